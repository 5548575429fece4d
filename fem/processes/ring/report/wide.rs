//! The wide ring in space: its two surfaces and its faces, as short jaws move them.

use std::f64::consts::TAU;

use super::super::forward;
use super::super::jaws::Jaw;
use super::super::machine::Machine;
use super::super::response::BoreSeries;
use super::clamped::{Clamped, Solved, states};
use crate::element::plane::STRAINS;
use crate::process::{Cell, Failure, Grid, Skin, SkinPoint};

/// Places around.
const AROUND: usize = 120;
/// Most sections along.
const MOST_SECTIONS: usize = 31;

/// Solves the ring that jaws press from one place to another along it (m), at standstill and while the chuck turns.
///
/// # Errors
/// The ring cannot be computed.
pub fn solved(machine: &Machine, reach: [f64; 2]) -> Result<Solved, Failure> {
    let setup = &machine.setup;
    let sections = forward::sections(machine, reach)?;
    let all = sections.places();
    // Both faces, and evenly chosen sections between them.
    let every = (all.len() - 1).div_ceil(MOST_SECTIONS - 1);
    let chosen: Vec<usize> = (0..all.len()).filter(|i| i % every == 0 || i + 1 == all.len()).collect();
    let (mut grid, mut quads) = (Grid::default(), Vec::new());
    for is_cut in [true, false] {
        let radius = if is_cut { setup.cut_radius() } else { setup.held_radius() };
        for section in &chosen {
            let z = all[*section] * setup.outer_radius - 0.5 * setup.width;
            grid.points.extend((0..AROUND).map(|i| {
                let (sine, cosine) = angle(i).sin_cos();
                [radius * cosine, radius * sine, z]
            }));
        }
    }
    let count = chosen.len();
    // Surfaces one after the other, sections along each, places around each.
    let node = |surface: usize, section: usize, i: usize| ((surface * count + section) * AROUND + i % AROUND) as u32;
    let inner = usize::from(setup.cut_radius() > setup.held_radius());
    for i in 0..AROUND {
        for section in 1..count {
            let side = |surface: usize| {
                [(section - 1, i), (section - 1, i + 1), (section, i + 1), (section, i)]
                    .map(|(section, i)| node(surface, section, i))
            };
            let [a, b, c, d] = side(inner);
            quads.push([d, c, b, a]);
            quads.push(side(1 - inner));
        }
        let face = |section: usize| {
            [(inner, i), (inner, i + 1), (1 - inner, i + 1), (1 - inner, i)]
                .map(|(surface, i)| node(surface, section, i))
        };
        quads.push(face(0));
        let [a, b, c, d] = face(count - 1);
        quads.push([d, c, b, a]);
    }
    quads.iter().for_each(|quad| grid.push(Cell::Quad, quad));
    let points = (0..grid.points.len() as u32).map(|node| SkinPoint { node: Some(node), offset: [0.0; 3] }).collect();
    let skin = Skin { points, triangles: Vec::new(), quads };
    let compliance = setup.grip.inwards() / (setup.material.youngs_modulus * setup.width);
    let clamped = |jaws: Vec<Jaw>| -> Result<Clamped, Failure> {
        let mut displacements = Vec::with_capacity(grid.points.len());
        for is_cut in [true, false] {
            for section in &chosen {
                let [along, outwards, around] = sections.motions(is_cut, *section, &jaws);
                displacements.extend((0..AROUND).map(|i| {
                    let (sine, cosine) = angle(i).sin_cos();
                    let [w, u, v] =
                        [&along, &outwards, &around].map(|own: &BoreSeries| compliance * own.radial(angle(i)));
                    [u * cosine - v * sine, u * sine + v * cosine, w]
                }));
            }
        }
        let stresses = vec![[0.0; STRAINS]; displacements.len()];
        Ok(Clamped { jaws, displacements, stresses })
    };
    let states = states(machine, clamped)?;
    Ok((grid, states, skin, Vec::new()))
}

/// Angle of a place around, rad.
fn angle(i: usize) -> f64 {
    TAU * i as f64 / AROUND as f64
}
