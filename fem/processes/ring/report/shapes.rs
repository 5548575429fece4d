//! The ring in space: clamped, bored, released.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::super::body::Body;
use super::super::forward;
use super::super::grip::Grip;
use super::super::jaws::Jaw;
use super::super::machine::Machine;
use super::super::response::unsolvable;
use super::super::rows::{self, SECTION};
use super::super::setup::Setup;
use super::clamped::{Clamped, Solved, states};
use super::wide;
use crate::element::plane::{Elasticity, PlaneState, STRAINS};
use crate::mesh::{BORE, Mesh, OUTSIDE};
use crate::process::{Animation, Arrow, Body as Drawn, Cell, Failure, Field, Forward, Frame, Grid, Role, Skin, View};
use crate::solve::elastic::{ElasticSystem, Loads, nodal_stresses};
use crate::solve::ring::{ContactArc, add_jaws_on};
use crate::units::{FORCE, LENGTH, MICRO, STRESS};

/// Steps of the clamping, of the cut and of the release: a run takes as long as writing them, 0.6 MB each on
/// the usual mesh.
const STEPS: usize = 6;

/// Length of a jaw as it is drawn, as a part of the ring's radius.
const JAW: f64 = 0.35;

/// The solved ring, as far as a run shows it.
pub struct Scene {
    setup: Arc<Setup>,
    /// The nodes of the ring, and its cells.
    ring: Grid,
    /// Under the jaws at standstill, and while the chuck turns.
    states: [Clamped; 2],
    /// Change of the bore's radius by the cut at each node's angle, m: the deviation of the released ring.
    cut: Vec<f64>,
    /// The surface of the ring.
    skin: Arc<Skin>,
    /// Nodes of the surface that is cut.
    on_cut: Vec<u32>,
}

impl Scene {
    /// Solves the ring under the jaws as they stand and press.
    ///
    /// # Errors
    /// The ring cannot be computed.
    pub fn new(machine: &Machine, forward: &Forward) -> Result<Self, Failure> {
        let (ring, states, skin, on_cut) = match machine.setup.reach {
            Some(reach) => wide::solved(machine, reach)?,
            None => Self::plane(machine)?,
        };
        let setup = machine.setup.clone();
        let mut rows = rows::released(&setup, ring.points.iter().map(|[x, y, _]| angle_of([*x, *y])).collect());
        if setup.reach.is_some() {
            rows.columns[SECTION] = ring.points.iter().map(|point| point[2] + 0.5 * setup.width).collect();
        }
        let cut = forward::absolute(machine, forward, &rows)?;
        Ok(Self { setup, ring, states, cut, skin: Arc::new(skin), on_cut })
    }

    /// Solves a ring that is plane.
    fn plane(machine: &Machine) -> Result<Solved, Failure> {
        let setup = machine.setup.clone();
        let material = &setup.material;
        let (e, nu) = (material.youngs_modulus, material.poisson_ratio);
        let law = Elasticity::new(PlaneState::Stress, e, nu, material.expansion, setup.width).map_err(unsolvable)?;
        let mesh = match &setup.body {
            Body::Drawn(drawn) => drawn.mesh.clone(),
            Body::Cells(size) => Arc::new(size.mesh(setup.outer_radius, setup.inner_radius)?),
        };
        let system = ElasticSystem::free(&*mesh, law).map_err(unsolvable)?;
        let clamped = |jaws: Vec<Jaw>| -> Result<Clamped, Failure> {
            let mut displacements = system.solve(&loads(&setup, &mesh, &jaws)?).map_err(unsolvable)?.nodes;
            centre(&mesh, &mut displacements);
            let stresses = nodal_stresses(&mesh, &law, &displacements, &[]);
            let displacements = displacements.into_iter().map(|[u, v]| [u, v, 0.0]).collect();
            Ok(Clamped { jaws, displacements, stresses })
        };
        let states = states(machine, clamped)?;
        let grid = Grid::of(&mesh);
        let skin = Skin::thickened(&grid, setup.width);
        let cut = if setup.grip == Grip::Outside { BORE } else { OUTSIDE };
        Ok((grid, states, skin, mesh.nodes_on(cut).unwrap_or_default()))
    }

    /// Largest equivalent stress on the bore under the jaws at standstill, Pa, and where, rad. Under a line
    /// load the stress at the jaw itself has no bound.
    pub fn largest_stress(&self) -> (f64, f64) {
        let of = |node: &u32| {
            let [x, y, _] = self.ring.points[*node as usize];
            (equivalent(self.states[0].stresses[*node as usize]), angle_of([x, y]))
        };
        self.on_cut.iter().map(of).fold((0.0, 0.0), |a, b| if b.0 > a.0 * (1.0 + 1e-9) { b } else { a })
    }

    /// Clamped, then bored, then released; time 1, 2 and 3 are when each is done.
    ///
    /// Points are the nodes of the mesh, then the middles of the jaws. Displacement is that of the ring as
    /// it was before clamping, and of the jaws with it; the cut shows as displacement of the bore that fades towards the
    /// outside.
    pub fn animation(self) -> Animation {
        Animation {
            name: "ring",
            shown: "radial_displacement",
            time: "phase: 1 clamped, 2 cut, 3 released",
            view: View::Oblique,
            telling: STEPS,
            most_magnified: f64::INFINITY,
            frames: 1 + 3 * STEPS,
            frame: Box::new(move |i| self.frame(i)),
        }
    }

    /// What is felt of the jaws at standstill and of those of the turning chuck, and the part of the cut that is done.
    fn state(time: f64) -> ([f64; 2], f64) {
        if time <= 1.0 {
            ([time, 0.0], 0.0)
        } else if time <= 2.0 {
            // The chuck turns, where its jaws lighten.
            ([2.0 - time, time - 1.0], time - 1.0)
        } else {
            ([0.0, 3.0 - time], 1.0)
        }
    }

    fn frame(&self, i: usize) -> Frame {
        let time = i as f64 / STEPS as f64;
        let ((felt, bored), setup) = (Self::state(time), &self.setup);
        let [standing, turning] = &self.states;
        let mix = |one: f64, other: f64| felt[0] * one + felt[1] * other;
        let mut grid = self.ring.clone();
        let mut force = vec![[0.0; 3]; grid.points.len()];
        let (mut displacement, mut stress, mut single) = (Vec::new(), Vec::new(), Vec::new());
        for (node, &[x, y, _]) in self.ring.points.iter().enumerate() {
            let r = x.hypot(y);
            let depth = ((setup.held_radius() - r) / (setup.held_radius() - setup.cut_radius())).max(0.0);
            let cut = bored * self.cut[node] * depth / r;
            let [u, v, w] =
                [0, 1, 2].map(|axis| mix(standing.displacements[node][axis], turning.displacements[node][axis]));
            let [xx, yy, xy, across] = [0, 1, 2, 3].map(|k| mix(standing.stresses[node][k], turning.stresses[node][k]));
            displacement.push([u + cut * x, v + cut * y, w]);
            stress.push([xx, yy, 0.0, xy, 0.0, 0.0]);
            single.push(equivalent([xx, yy, xy, across]));
        }
        let mut bodies = vec![Drawn::thickened("ring", self.skin.clone())];
        let mut arrows = Vec::new();
        for (jaw, later) in standing.jaws.iter().zip(&turning.jaws) {
            let (sine, cosine) = jaw.angle.sin_cos();
            let push = mix(jaw.share, later.share);
            let node = grid.points.len();
            grid.push(Cell::Vertex, &[node as u32]);
            let (at, sign) = ([cosine, sine].map(|c| setup.held_radius() * c), setup.grip.inwards());
            let behind = setup.reach.map_or(0.0, |[from, to]| 0.5 * (from + to - setup.width));
            let at = [at[0], at[1], behind];
            grid.points.push(at);
            force.push([-sign * push * cosine, -sign * push * sine, 0.0]);
            // A jaw goes with the surface that it presses on.
            let nearest = nearest(&self.ring.points, at);
            displacement.push(
                [0, 1, 2].map(|axis| mix(standing.displacements[nearest][axis], turning.displacements[nearest][axis])),
            );
            bodies.push(Drawn::new("jaw", Role::Machine, self.jaw(node, [sign * cosine, sign * sine])));
            arrows.push(Arrow::new(node, JAW * setup.held_radius()));
        }
        if time > 1.0 && time < 2.0 {
            bodies.push(match setup.grip {
                Grip::Outside => Drawn::new("boring bar", Role::Tool, self.boring_bar(time - 1.0)),
                Grip::Inside => Drawn::new("tool", Role::Tool, self.tool(time - 1.0)),
            });
        }
        stress.resize(grid.points.len(), [0.0; 6]);
        single.resize(grid.points.len(), 0.0);
        let radial = |([x, y, _], [u, v, _]): (&[f64; 3], &[f64; 3])| (x * u + y * v) / x.hypot(*y);
        let radial = grid.points.iter().zip(&displacement).map(radial).collect();
        grid.point_fields =
            vec![Field::vector("displacement", LENGTH, displacement), Field::vector("force", FORCE, force)];
        if setup.reach.is_none() {
            grid.point_fields.push(Field::tensor("stress", STRESS, stress));
            grid.point_fields.push(Field::scalar("equivalent_stress", STRESS, single));
        }
        grid.point_fields.push(Field::scalar("radial_displacement", MICRO, radial));
        let (squeezed, name) = match setup.grip {
            Grip::Outside => ("squeezed", "bore"),
            Grip::Inside => ("spread", "outside"),
        };
        let phase = match time {
            t if t < 1.0 => "the jaws close".into(),
            1.0 => format!("clamped: the ring is {squeezed}"),
            t if t < 2.0 => format!("cut round while it is {squeezed}"),
            2.0 => format!("cut: the {name} is round, the ring still {squeezed}"),
            t if t < 3.0 => "the jaws open".into(),
            _ => format!("released: the {name} springs out of round"),
        };
        Frame { time, caption: phase, grid, bodies, arrows }
    }

    /// A jaw at a point of the grid, away from the ring.
    fn jaw(&self, node: usize, [x, y]: [f64; 2]) -> Skin {
        let (reach, half) = (JAW * self.setup.held_radius(), 0.12 * self.setup.held_radius());
        Skin::square(Some(node as u32), [0.0; 3], [x, y, 0.0], &[(0.0, half), (reach, half)])
    }

    /// The tool that turns the outside, so much of its way along the ring.
    fn tool(&self, share: f64) -> Skin {
        let Setup { outer_radius: r, width, .. } = *self.setup;
        let z = width * (0.7 - 1.4 * share);
        Skin::square(None, [r, 0.0, z], [1.0, 0.0, 0.0], &[(0.0, 0.01 * r), (0.15 * r, 0.1 * r), (0.8 * r, 0.1 * r)])
    }

    /// The boring bar, so much of its way through the ring.
    fn boring_bar(&self, share: f64) -> Skin {
        let Setup { inner_radius: r, width, .. } = *self.setup;
        let [length, thick] = [3.0 * r, 0.22 * r];
        let z = width * (0.7 - 1.4 * share);
        let bar = Skin::turned(None, [0.5 * r, 0.0, z], [0.0, 0.0, 1.0], &[(0.0, thick), (length, thick)]);
        bar.and(&Skin::square(None, [r, 0.0, z + 0.1 * r], [-1.0, 0.0, 0.0], &[(0.0, 0.01 * r), (0.5 * r, 0.1 * r)]))
    }
}

/// Jaws on the mesh whose shares are their forces, N.
fn loads(setup: &Setup, mesh: &Mesh, jaws: &[Jaw]) -> Result<Loads, Failure> {
    let mut loads = Loads::none(mesh);
    match &setup.body {
        Body::Drawn(drawn) => drawn.press(&mut loads, jaws, 1.0)?,
        Body::Cells(_) => {
            let held = if setup.grip == Grip::Outside { OUTSIDE } else { BORE };
            let pushes: Vec<ContactArc> = jaws.iter().map(|jaw| jaw.load(setup.grip.inwards())).collect();
            add_jaws_on(held, &mut loads, mesh, &pushes).map_err(unsolvable)?;
        }
    }
    Ok(loads)
}

/// Takes the rigid motion out, by which the body happened to be held: the mean displacement and turn of the
/// nodes.
fn centre(mesh: &Mesh, displacements: &mut [[f64; 2]]) {
    let count = displacements.len() as f64;
    let mean = [0, 1].map(|axis| displacements.iter().map(|u| u[axis]).sum::<f64>() / count);
    let (mut turn, mut inertia) = (0.0, 0.0);
    for ([x, y], [u, v]) in mesh.nodes().iter().zip(&*displacements) {
        turn += x * (v - mean[1]) - y * (u - mean[0]);
        inertia += x * x + y * y;
    }
    for ([x, y], u) in mesh.nodes().iter().zip(displacements) {
        *u = [u[0] - mean[0] + turn / inertia * y, u[1] - mean[1] - turn / inertia * x];
    }
}

/// The node that is nearest to a place.
fn nearest(points: &[[f64; 3]], at: [f64; 3]) -> usize {
    let far = |point: &[f64; 3]| (0..3).map(|axis| (point[axis] - at[axis]).powi(2)).sum::<f64>();
    (0..points.len()).min_by(|a, b| far(&points[*a]).total_cmp(&far(&points[*b]))).unwrap_or(0)
}

/// Polar angle, rad from 0 on.
fn angle_of([x, y]: [f64; 2]) -> f64 {
    y.atan2(x).rem_euclid(TAU)
}

/// Equivalent stress of plane stress by von Mises, Pa.
fn equivalent([x, y, shear, _]: [f64; STRAINS]) -> f64 {
    (x * x - x * y + y * y + 3.0 * shear * shear).sqrt()
}
