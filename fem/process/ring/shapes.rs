//! The ring in space: clamped, bored, released.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::job::Ring;
use super::machine::{Machine, Place};
use super::model::{Body, Setup};
use super::response::{self, Jaw};
use crate::element::plane::{Elasticity, PlaneState, STRAINS};
use crate::mesh::Mesh;
use crate::process::{Animation, Cell, Failure, Field, Frame, Grid};
use crate::solve::elastic::{ElasticSystem, Loads, nodal_stresses};
use crate::solve::ring::{ContactArc, add_jaws};

/// One step of the series: what the jaws press with and how much of the cut is done, as parts of one.
struct Step {
    /// Of the force at standstill.
    clamped: f64,
    /// Of the cut.
    bored: f64,
}

/// Steps of the clamping, of the cut and of the release: a run takes as long as writing them, 1.4 MB each on the usual mesh.
const STEPS: usize = 3;

/// The solved ring with what a run shows of it.
pub struct Scene {
    machine: Arc<Machine>,
    mesh: Arc<Mesh>,
    jaws: Vec<Jaw>,
    /// Under the jaws at standstill, m. (nodes, 2)
    displacements: Vec<[f64; 2]>,
    /// (σxx, σyy, σxy) at the nodes, Pa.
    stresses: Vec<[f64; STRAINS]>,
    /// What the cut leaves of the bore's radius at each node's angle, m: the deviation of the released ring.
    cut: Vec<f64>,
    steps: Vec<Step>,
}

impl Scene {
    /// Solves the ring under the jaws at standstill, as they stand and press.
    ///
    /// # Errors
    /// The ring cannot be computed.
    pub fn new(ring: &Ring) -> Result<Self, Failure> {
        let (setup, machine) = (ring.setup(), ring.machine.clone());
        let (e, nu) = (setup.material.youngs_modulus, setup.material.poisson_ratio);
        let law = Elasticity::new(PlaneState::Stress, e, nu, setup.material.expansion, setup.width)
            .map_err(|error| response::unsolvable(&error))?;
        let jaws = ring.jaws()?;
        let (mesh, loads) = pressed(setup, &jaws)?;
        let system = ElasticSystem::free(&*mesh, law).map_err(|error| response::unsolvable(&error))?;
        let mut displacements = system.solve(&loads).map_err(|error| response::unsolvable(&error))?.nodes;
        drop(system);
        centre(&mesh, &mut displacements);
        let stresses = nodal_stresses(&mesh, &law, &displacements, &[]);
        let bore = ring.bore()?;
        let while_boring = machine.force_at(setup.jaw_force, setup.spindle_speed.unwrap_or(0.0));
        let cut = |node: &[f64; 2]| {
            let angle = node[1].atan2(node[0]);
            let place = Place { angle, orientation: 0.0, blank: setup.blank_at(angle) };
            ring.marks_at(&place) - while_boring * bore.radial(angle)
        };
        let cut = mesh.nodes().iter().map(cut).collect();
        let steps = steps(if setup.jaw_force > 0.0 { while_boring / setup.jaw_force } else { 0.0 });
        Ok(Self { machine, mesh, jaws, displacements, stresses, cut, steps })
    }

    /// Largest equivalent stress on the bore under the jaws at standstill, Pa, and where, rad. Under a line load the stress at the jaw itself has no bound.
    pub fn largest_stress(&self) -> (f64, f64) {
        let on_bore = self.mesh.nodes_on(crate::mesh::BORE).unwrap_or_default();
        let of = |node: u32| {
            let [x, y] = self.mesh.nodes()[node as usize];
            (equivalent(self.stresses[node as usize]), y.atan2(x).rem_euclid(TAU))
        };
        on_bore.into_iter().map(of).fold((0.0, 0.0), |a, b| if b.0 > a.0 * (1.0 + 1e-9) { b } else { a })
    }

    /// Clamped, then bored, then released; time 1, 2 and 3 are when each is done.
    ///
    /// Points are the nodes of the mesh, then the middles of the jaws. Displacement is that of the ring as it was before clamping; what is bored shows as
    /// displacement of the bore that fades towards the outside.
    pub fn animation(self) -> Animation {
        Animation { name: "ring", frames: self.steps.len(), frame: Box::new(move |i| self.frame(i)) }
    }

    fn frame(&self, i: usize) -> Frame {
        let Step { clamped, bored } = self.steps[i];
        let setup = &self.machine.setup;
        let mut grid = Grid::default();
        let (mut displacement, mut force) = (Vec::new(), Vec::new());
        let (mut stress, mut single) = (Vec::new(), Vec::new());
        for (node, &[x, y]) in self.mesh.nodes().iter().enumerate() {
            let r = x.hypot(y);
            let depth = ((setup.outer_radius - r) / (setup.outer_radius - setup.inner_radius)).max(0.0);
            let cut = bored * self.cut[node] * depth / r;
            let [u, v] = self.displacements[node];
            let [xx, yy, xy] = self.stresses[node].map(|s| clamped * s);
            grid.points.push([x, y, 0.0]);
            displacement.push([clamped * u + cut * x, clamped * v + cut * y, 0.0]);
            force.push([0.0; 3]);
            stress.extend([xx, yy, 0.0, xy, 0.0, 0.0]);
            single.push(equivalent([xx, yy, xy]));
        }
        for element in self.mesh.elements() {
            grid.push(Cell::of(element.kind), element.nodes);
        }
        for jaw in &self.jaws {
            let (sine, cosine) = jaw.angle.sin_cos();
            let push = clamped * jaw.share * setup.jaw_force;
            grid.push(Cell::Vertex, &[grid.points.len() as u32]);
            grid.points.push([setup.outer_radius * cosine, setup.outer_radius * sine, 0.0]);
            displacement.push([0.0; 3]);
            force.push([-push * cosine, -push * sine, 0.0]);
            stress.extend([0.0; 6]);
            single.push(0.0);
        }
        grid.point_fields = vec![
            Field::vector("displacement", displacement),
            Field::vector("force", force),
            Field { name: "stress".into(), components: 6, values: stress },
            Field::scalar("equivalent_stress", single),
        ];
        Frame { time: i as f64 / STEPS as f64, grid }
    }
}

/// The mesh, and on it the jaws at standstill.
fn pressed(setup: &Setup, jaws: &[Jaw]) -> Result<(Arc<Mesh>, Loads), Failure> {
    match &setup.body {
        Body::Drawn(drawn) => {
            let mut loads = Loads::none(&drawn.mesh);
            drawn.press(&mut loads, jaws, setup.jaw_force)?;
            Ok((drawn.mesh.clone(), loads))
        }
        Body::Cells(size) => {
            let mesh = response::mesh(setup.outer_radius, setup.inner_radius, *size)?;
            let push = |jaw: &Jaw| ContactArc { angle: jaw.angle, width: jaw.arc, force: setup.jaw_force * jaw.share };
            let pushes: Vec<ContactArc> = jaws.iter().map(push).collect();
            let mut loads = Loads::none(&mesh);
            add_jaws(&mut loads, &mesh, &pushes).map_err(|error| response::unsolvable(&error))?;
            Ok((Arc::new(mesh), loads))
        }
    }
}

/// Clamping; turning, where the jaws lighten to a part of their force, and the cut; release.
fn steps(while_boring: f64) -> Vec<Step> {
    let parts = |of: fn(f64, f64) -> Step, while_boring: f64| {
        (1..=STEPS).map(move |k| of(k as f64 / STEPS as f64, while_boring))
    };
    std::iter::once(Step { clamped: 0.0, bored: 0.0 })
        .chain(parts(|part, _| Step { clamped: part, bored: 0.0 }, while_boring))
        .chain(parts(
            |part, turning| Step { clamped: 1.0 + (turning - 1.0) * part.min(1.0), bored: part },
            while_boring,
        ))
        .chain(parts(|part, turning| Step { clamped: turning * (1.0 - part), bored: 1.0 }, while_boring))
        .collect()
}

/// Takes the rigid motion out, by which the body happened to be held: the mean displacement and turn of the nodes.
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

/// Equivalent stress of plane stress by von Mises, Pa.
fn equivalent([x, y, shear]: [f64; STRAINS]) -> f64 {
    (x * x - x * y + y * y + 3.0 * shear * shear).sqrt()
}
