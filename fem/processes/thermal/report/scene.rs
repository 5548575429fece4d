//! The body in space: warm, grown and bent, through time.

use std::sync::Arc;

use super::super::body::{Body, Plane};
use super::super::follow::{Look, unsolvable};
use super::super::forward::{looks_at_shape, recorded, run};
use super::super::machine::Machine;
use super::super::over_temperature::Laws;
use super::super::recording::{Hottest, Picture, Recording};
use super::super::rows::{TIME_OF_ROW, elongations, of_circle, temperatures};
use super::super::setup::Setup;
use super::super::{plate, rod};
use super::bodies;
use crate::element::plane::Elasticity;
use crate::mesh::Mesh;
use crate::process::{Animation, Body as Drawn, Cell, Failure, Field, Forward, Frame, Grid, Role, Skin, View};
use crate::solve::conduction::Energy;
use crate::solve::elastic::{ElasticSystem, Loads, nodal_stresses};
use crate::units::{LENGTH, STRESS, TEMPERATURE, TEMPERATURE_RISE, TIME};

/// A run with all that is shown of it.
pub struct Scene {
    setup: Arc<Setup>,
    shape: Shape,
    recording: Arc<Recording>,
    /// The surface of the body.
    skin: Arc<Skin>,
    /// Growth from the base to the free end at these times, m, of a body that has them.
    pub elongation: Option<Vec<f64>>,
    /// Rise of the middle of a plane body over its ends at these times, m.
    pub bow: Option<Vec<f64>>,
    /// Circles (distance from the left end, and radius, m), and the changes of their diameters at these times, m.
    pub diameters: Vec<([f64; 2], Vec<f64>)>,
    /// Place of the hottest node, m; a rod has no y.
    pub hottest: Option<([f64; 2], Hottest)>,
}

enum Shape {
    /// Nodes along the rod, m.
    Rod(Vec<f64>),
    Plane(Box<Flat>),
}

/// A plane body that is free to grow.
struct Flat {
    plane: Plane,
    system: ElasticSystem<Arc<Mesh>>,
    mesh: Arc<Mesh>,
    law: Elasticity,
    laws: Laws,
}

impl Scene {
    /// Of the run that was followed for the prediction, or of another one where that does not tell enough.
    ///
    /// # Errors
    /// The body cannot be computed.
    pub fn new(machine: &Machine, forward: &Forward) -> Result<Self, Failure> {
        let setup = machine.setup.clone();
        let shape = match &setup.body {
            Body::Rod(segments) => Shape::Rod(rod::system(machine, segments)?.x),
            Body::Plane(plane) => Shape::Plane(Box::new(Flat::new(machine, plane)?)),
        };
        let nodes = shape.nodes();
        let run = run(machine)?;
        let known = machine.recording.get().filter(|own| own.run == run && !forward.has_formulas()).cloned();
        let recording = match known {
            Some(known) => known,
            None => {
                let mut rows = temperatures(&nodes, 0.0);
                let shown = |time: f64, rises: &[f64]| {
                    forward.has_formulas().then(|| {
                        let mut shown = rises.to_vec();
                        rows.columns[TIME_OF_ROW].fill(time);
                        forward.add_formulas(&rows, &mut shown);
                        shown
                    })
                };
                Arc::new(recorded(machine, looks_at_shape(&setup), run, shown)?)
            }
        };
        let (track, seen) = (&recording.track, |look| recording.seen(look));
        let mut elongation = seen(Look::Elongation);
        if let Some(values) = &mut elongation {
            forward.add_formulas(&elongations(&track.times), values);
        }
        let skin = Arc::new(match (&shape, &setup.body) {
            (Shape::Rod(x), Body::Rod(segments)) => bodies::rod(x, segments),
            (Shape::Plane(flat), _) => Skin::thickened(&Grid::of(&flat.mesh), flat.plane.shown_thickness()),
            _ => Skin::default(),
        });
        let bow = seen(Look::Bow);
        let grown = |circle: &[f64; 2]| {
            let mut values = seen(Look::Diameter { x: circle[0], y: Some(circle[1]) })?;
            forward.add_formulas(&of_circle(*circle, &track.times), &mut values);
            Some((*circle, values))
        };
        let diameters = setup.circles.iter().filter_map(grown).collect();
        let hottest = recording.hottest.map(|hottest| (nodes[hottest.node], hottest));
        Ok(Self { elongation, bow, diameters, hottest, recording, shape, setup, skin })
    }

    /// Times of the start and of the end of every step, s.
    pub fn times(&self) -> &[f64] {
        &self.recording.track.times
    }

    /// Where the heat went.
    pub fn energy(&self) -> &Energy {
        &self.recording.energy
    }

    /// The longest step that was taken, s.
    pub fn longest_step(&self) -> f64 {
        self.times().windows(2).map(|t| t[1] - t[0]).fold(0.0, f64::max)
    }

    /// Points are the nodes; displacement is growth from the base, of a plane body from the middle of its
    /// left end with both ends level, of a body of revolution from its left end.
    pub fn animation(self) -> Animation {
        let hottest = self.hottest.map_or(0.0, |(_, hottest)| hottest.time);
        let pictures = &self.recording.pictures;
        Animation {
            name: "body",
            shown: "temperature",
            time: "time since the heating began, s",
            view: View::Oblique,
            telling: pictures.partition_point(|p| p.time < hottest).min(pictures.len().saturating_sub(1)),
            most_magnified: f64::INFINITY,
            frames: pictures.len(),
            frame: Box::new(move |i| self.frame(i)),
        }
    }

    fn frame(&self, i: usize) -> Frame {
        let Picture { time, rises, shown } = &self.recording.pictures[i];
        let shown = shown.as_ref().unwrap_or(rises);
        let mut grid = match &self.shape {
            Shape::Rod(x) => rod_grid(x, rises, self.setup.material.expansion),
            Shape::Plane(flat) => flat.grid(rises),
        };
        let temperatures = shown.iter().map(|rise| self.setup.start + rise).collect();
        grid.point_fields.insert(0, Field::scalar("temperature", TEMPERATURE, temperatures));
        grid.point_fields.insert(1, Field::scalar("rise", TEMPERATURE_RISE, shown.clone()));
        let body = match &self.shape {
            Shape::Rod(_) => Drawn::new("rod", Role::Work, self.skin.clone()),
            Shape::Plane(flat) if flat.plane.thickness.is_revolved() => {
                Drawn::thickened("half section", self.skin.clone())
            }
            Shape::Plane(_) => Drawn::thickened("plate", self.skin.clone()),
        };
        let bodies = std::iter::once(body).chain(bodies::around(&self.setup, *time, &grid.points)).collect();
        let caption = format!("{:.2} after the start", TIME.shown(*time));
        Frame { time: *time, caption, grid, bodies, arrows: Vec::new() }
    }
}

impl Shape {
    /// x and y of the nodes, m.
    fn nodes(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Rod(x) => x.iter().map(|x| [*x, f64::NAN]).collect(),
            Self::Plane(flat) => flat.mesh.nodes().to_vec(),
        }
    }
}

fn rod_grid(x: &[f64], rises: &[f64], expansion: f64) -> Grid {
    let mut grid = Grid { points: x.iter().map(|x| [*x, 0.0, 0.0]).collect(), ..Grid::default() };
    let mut displacement = vec![[0.0; 3]];
    let mut moved = 0.0;
    for i in 1..x.len() {
        moved += 0.5 * expansion * (x[i] - x[i - 1]) * (rises[i] + rises[i - 1]);
        displacement.push([moved, 0.0, 0.0]);
        // The two sides of a joint are two points at one place.
        if x[i] > x[i - 1] {
            grid.push(Cell::Line, &[i as u32 - 1, i as u32]);
        }
    }
    grid.point_fields.push(Field::vector("displacement", LENGTH, displacement));
    grid
}

impl Flat {
    fn new(machine: &Machine, plane: &Plane) -> Result<Self, Failure> {
        let setup = &machine.setup;
        let mesh = plane.mesh(setup.element_size, &plate::sections(machine)).map_err(|e| unsolvable(&e))?;
        let laws = Laws::of(setup);
        let law = plate::elasticity(setup, plane, &laws)?;
        let system = ElasticSystem::free(mesh.clone(), law).map_err(|e| unsolvable(&e))?;
        Ok(Self { plane: plane.clone(), system, mesh, law, laws })
    }

    fn grid(&self, rises: &[f64]) -> Grid {
        let (mesh, mut grid) = (&self.mesh, Grid::of(&self.mesh));
        let rises: Vec<f64> = rises.iter().map(|rise| self.laws.grown(*rise)).collect();
        let mut loads = Loads::none(mesh);
        loads.add_temperature(mesh, &self.law, &rises);
        // Thermal loads are in equilibrium and finite, and the body has been factored: what is left to fail
        // shows as not a number.
        let solved = self.system.solve(&loads).map(|s| s.nodes);
        let mut displacements = solved.unwrap_or_else(|_| vec![[f64::NAN; 2]; mesh.nodes().len()]);
        self.level(&mut displacements);
        let stresses = nodal_stresses(mesh, &self.law, &displacements, &rises);
        let stress = stresses.iter().map(|[xx, yy, xy, across]| [*xx, *yy, *across, *xy, 0.0, 0.0]).collect();
        let displacement = displacements.iter().map(|[u, v]| [*u, *v, 0.0]).collect();
        grid.point_fields.push(Field::vector("displacement", LENGTH, displacement));
        grid.point_fields.push(Field::tensor("stress", STRESS, stress));
        grid
    }

    /// Takes the rigid motion out: the middle of the left end stays, that of the right end keeps its height. A body of
    /// revolution can slide alone: its left end stays at the outside.
    fn level(&self, displacements: &mut [[f64; 2]]) {
        let [from, to] = self.plane.extent(0);
        if self.plane.thickness.is_revolved() {
            let base = displacements[self.mesh.nearest_node([from, self.plane.usual_y(from)])][0];
            displacements.iter_mut().for_each(|own| own[0] -= base);
            return;
        }
        let at = |x: f64| {
            let place = self.mesh.locate([x, self.plane.middle()]);
            let node = self.mesh.nearest_node([x, self.plane.middle()]);
            let shares = place.map_or_else(|| vec![(node, 1.0)], |p| p.shares);
            [0, 1].map(|axis| shares.iter().map(|(n, s)| s * displacements[*n][axis]).sum::<f64>())
        };
        let (left, right) = (at(from), at(to));
        let turn = (right[1] - left[1]) / (to - from);
        for (own, [x, y]) in displacements.iter_mut().zip(self.mesh.nodes()) {
            own[0] -= left[0] - turn * (y - self.plane.middle());
            own[1] -= left[1] + turn * (x - from);
        }
    }
}
