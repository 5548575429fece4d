//! The plate of a membrane chuck and its jaws in space: pushed open, and let go on the ring.

use std::f64::consts::TAU;

use super::super::grip::Grip;
use super::super::membrane::{Grasp, Push};
use super::super::setup::Setup;
use crate::process::{Animation, Body, Cell, Ends, Field, Frame, Grid, Role, Skin, SkinPoint, View};
use crate::units::{FORCE, LENGTH, MICRO};

/// Circles of points on the plate, and points on each.
const CIRCLES: usize = 16;
const AROUND: usize = 96;
/// Steps of the push, and of letting go.
const STEPS: usize = 6;
/// How thick a jaw is along the radius, as a part of the radius at which it presses.
const JAW: f64 = 0.35;

/// The chuck as it is drawn: its points, and how these move.
struct Plate {
    grasp: Grasp,
    push: Push,
    grid: Grid,
    /// Of every point how far it is off where all is free, as the ring is larger than the jaws; how it moves under the whole push,
    /// and under a moment of 1 N·m on every jaw, m.
    moves: Vec<[[f64; 3]; 3]>,
    bodies: Vec<Body>,
}

/// A membrane with a push pushed open, and let go; time 1 and 2 are when that is done. `None` of other chucks, and of jaws that spread.
///
/// Displacement is that from the chuck without a push and without a ring, which is larger than its jaws.
pub fn animation(setup: &Setup) -> Option<Animation> {
    let grasp = setup.grasp.filter(|_| setup.grip == Grip::Outside)?;
    let plate = Plate::new(setup, grasp, grasp.membrane.push?);
    Some(Animation {
        name: "membrane",
        shown: "axial_displacement",
        time: "phase: 1 pushed open, 2 let go on the ring",
        view: View::Oblique,
        telling: 2 * STEPS,
        most_magnified: f64::INFINITY,
        frames: 1 + 2 * STEPS,
        frame: Box::new(move |i| plate.frame(i)),
    })
}

impl Plate {
    fn new(setup: &Setup, grasp: Grasp, push: Push) -> Self {
        let membrane = &grasp.membrane;
        let (plate, arms) = (&membrane.plate, &membrane.arms);
        let mut own = Self { grasp, push, grid: Grid::default(), moves: Vec::new(), bodies: Vec::new() };
        let turned = plate.deflections(arms);
        own.add([0.0; 3], 0.0, turned(0.0, 0.0));
        for circle in 1..=CIRCLES {
            let r = plate.radius * circle as f64 / CIRCLES as f64;
            for i in 0..AROUND {
                let angle = TAU * i as f64 / AROUND as f64;
                own.add([r * angle.cos(), r * angle.sin(), 0.0], r, turned(r, angle));
            }
        }
        let disc = own.disc(0.5 * plate.thickness);
        own.bodies.push(Body::thickened("membrane", disc));
        // How the roots turn and rise, pushed and under a moment; the chuck gives way at a pad by that turn.
        let roots = [
            (membrane.opened(push).slope, push.force * plate.deflection_pushed(push.radius, arms.circle)),
            (grasp.own / membrane.length.powi(2), turned(arms.circle, 0.0)),
        ];
        for k in 0..arms.count {
            let jaw = own.jaw(TAU * k as f64 / arms.count as f64, setup.held_radius(), roots);
            own.bodies.push(Body::new("jaw", Role::Machine, jaw));
        }
        let ring = own.ring(setup);
        own.bodies.push(Body::new("ring", Role::Nominal, ring));
        own
    }

    /// A point of the plate at a radius (m), and how it moves under a moment of 1 N·m on every jaw, m.
    fn add(&mut self, point: [f64; 3], radius: f64, turned: f64) {
        let Plate { grasp: Grasp { membrane, .. }, push, .. } = self;
        let opened = push.force * membrane.plate.deflection_pushed(push.radius, radius);
        self.put(point, [[0.0; 3], [0.0, 0.0, opened], [0.0, 0.0, turned]]);
    }

    /// A point with its moves.
    fn put(&mut self, point: [f64; 3], moves: [[f64; 3]; 3]) -> SkinPoint {
        let node = Some(self.grid.points.len() as u32);
        self.grid.points.push(point);
        self.moves.push(moves);
        SkinPoint { node, offset: [0.0; 3] }
    }

    /// The ring, which is larger than the free jaws and gives way under them.
    fn ring(&mut self, setup: &Setup) -> Skin {
        let Grasp { membrane, ring: gives, .. } = self.grasp;
        let mut rim = |z: f64, radius: f64| -> Vec<SkinPoint> {
            let point = |i: usize| {
                let (sine, cosine) = (TAU * i as f64 / AROUND as f64).sin_cos();
                let outwards = |by: f64| [by * cosine, by * sine, 0.0];
                let place = [radius * cosine, radius * sine, membrane.length + 0.5 * z * setup.width];
                let moves = [outwards(0.5 * membrane.interference), [0.0; 3], outwards(-gives / membrane.length)];
                self.put(place, moves)
            };
            (0..AROUND).map(point).collect()
        };
        let [outer, inner] = [setup.outer_radius, setup.inner_radius];
        Skin::lofted(&[rim(-1.0, outer), rim(1.0, outer), rim(1.0, inner), rim(-1.0, inner)], Ends::Joined)
    }

    /// Both faces of the plate and its rim, half of its thickness (m) on either side, and its cells.
    fn disc(&mut self, half: f64) -> Skin {
        let mut skin = Skin::default();
        let behind = self.grid.points.len() as u32;
        for z in [half, -half] {
            skin.points.extend((0..behind).map(|node| SkinPoint { node: Some(node), offset: [0.0, 0.0, z] }));
        }
        let at = |circle: usize, i: usize| 1 + (circle * AROUND + i % AROUND) as u32;
        for i in 0..AROUND {
            let (a, b) = (at(0, i), at(0, i + 1));
            self.grid.push(Cell::Triangle, &[0, a, b]);
            skin.triangles.extend([[0, a, b], [behind, b + behind, a + behind]]);
            for circle in 1..CIRCLES {
                let own = [at(circle - 1, i), at(circle, i), at(circle, i + 1), at(circle - 1, i + 1)];
                self.grid.push(Cell::Quad, &own);
                let [a, b, c, d] = own;
                skin.quads.extend([own, [d, c, b, a].map(|point| point + behind)]);
            }
            let (a, b) = (at(CIRCLES - 1, i), at(CIRCLES - 1, i + 1));
            skin.quads.push([b, a, a + behind, b + behind]);
        }
        skin
    }

    /// A jaw at an angle, from its root on the plate to its pad, which presses at a radius (m): it turns (rad) and rises (m) with
    /// its root.
    fn jaw(&mut self, angle: f64, radius: f64, roots: [(f64, f64); 2]) -> Skin {
        let membrane = self.grasp.membrane;
        let (plate, arms) = (&membrane.plate, &membrane.arms);
        let (circle, thick) = (arms.circle, JAW * radius);
        let (sine, cosine) = angle.sin_cos();
        let mut ring = |[inner, outer]: [f64; 2], half: f64, up: f64| -> Vec<SkinPoint> {
            let corner = |(r, side): (f64, f64)| {
                let moved =
                    |(turn, rise): (f64, f64)| [turn * up * cosine, turn * up * sine, rise - turn * (r - circle)];
                let place = [r * cosine - side * sine, r * sine + side * cosine, up];
                self.put(place, [[0.0; 3], moved(roots[0]), moved(roots[1])])
            };
            [(inner, -half), (outer, -half), (outer, half), (inner, half)].map(corner).to_vec()
        };
        let root = [circle - 0.5 * thick, circle + 0.5 * thick];
        let rings = [
            ring(root, 0.5 * (arms.root * circle).min(circle), 0.5 * plate.thickness),
            ring([radius, radius + thick], 0.5 * membrane.pad, membrane.length + 0.5 * membrane.pad),
        ];
        Skin::lofted(&rings, Ends::Capped)
    }

    fn frame(&self, i: usize) -> Frame {
        let (grasp, membrane) = (&self.grasp, &self.grasp.membrane);
        let time = i as f64 / STEPS as f64;
        // Part of the push; the jaws touch the ring where they are as far open as that is larger.
        let part = if time <= 1.0 { time } else { 2.0 - time };
        let stroke = membrane.opened(self.push).slope * membrane.length;
        let touches = (0.5 * membrane.interference / stroke).min(1.0);
        let held = if time <= 1.0 { 0.0 } else { grasp.force() * (1.0 - part / touches).max(0.0) };
        let moved = |[apart, opened, turned]: &[[f64; 3]; 3]| {
            [0, 1, 2].map(|k| apart[k] + part * opened[k] + held * membrane.length * turned[k])
        };
        let displacement: Vec<[f64; 3]> = self.moves.iter().map(moved).collect();
        let mut grid = self.grid.clone();
        let axial = displacement.iter().map(|own| own[2]).collect();
        grid.point_fields = vec![
            Field::vector("displacement", LENGTH, displacement),
            Field::scalar("axial_displacement", MICRO, axial),
        ];
        let caption = match (part, held) {
            (_, held) if held > 0.0 => format!("sprung on the ring: {:.0} at each jaw", FORCE.shown(held)),
            (0.0, _) => "at rest".into(),
            _ => format!("pushed open by {:.0}", FORCE.shown(part * self.push.force)),
        };
        Frame { time, caption, grid, bodies: self.bodies.clone(), arrows: Vec::new() }
    }
}
