//! A heated plane body.

use std::sync::Arc;

use super::body::Plane;
use super::boundary;
use super::follow::{Followed, Look, Watch, unsolvable};
use super::machine::Machine;
use super::setup::Setup;
use crate::element::plane::{Capacity, Conduction, Elasticity, PlaneState};
use crate::mesh::Mesh;
use crate::process::Failure;
use crate::solve::conduction::{Condition, History, Instant, Run, ThermalSystem};
use crate::solve::elastic::{ElasticSystem, Loads};
use crate::solve::rod::{PointSource, Probe, Track};
use crate::units::LENGTH;

/// Name of the edges on which the film of the surroundings acts.
const FREE: &str = "free";

/// Follows a plane body.
///
/// # Errors
/// It cannot be computed, or a place is not on it.
pub fn follow(machine: &Machine, plane: &Plane, looks: &[Look], run: &Run, watch: Watch) -> Result<Followed, Failure> {
    let setup = &*machine.setup;
    let mesh = plane.mesh(setup.element_size, &sections(machine)).map_err(|e| unsolvable(&e))?;
    let mut mesh = Arc::unwrap_or_clone(mesh);
    let taken: Vec<&str> = setup.boundaries.iter().filter(|b| !b.is_open()).map(|b| b.edge.as_str()).collect();
    mesh.name_rest(FREE, &taken).map_err(|e| unsolvable(&e))?;
    let law = Conduction {
        conductivity: setup.material.conductivity,
        heat_capacity: setup.material.density * setup.material.specific_heat,
        thickness: plane.width,
    };
    let conditions = conditions(machine, plane, &mesh);
    let system = ThermalSystem::new(&mesh, law, Capacity::Consistent, &conditions).map_err(|e| unsolvable(&e))?;
    let probes = probes(setup, plane, &mesh, looks)?;
    let switches: Vec<f64> = conditions.iter().flat_map(Condition::switches).collect();
    let mut track = Track::new(looks.len());
    let observe = |now: Instant<'_>| {
        let read = |p: &Probe| p.weights.iter().map(|(node, weight)| weight * now.at(*node)).sum::<f64>();
        let switched = now.time == 0.0 || now.time == run.end || switches.contains(&now.time);
        track.push(now.time, switched, probes.iter().map(read));
        watch(now.time, &|| now.temperatures());
    };
    let energy = system.run(&vec![0.0; mesh.nodes().len()], run, observe);
    Ok(Followed { track, energy: energy.map_err(|e| unsolvable(&e))? })
}

/// Everything that heats and cools, as rises over the temperature at the start.
fn conditions(machine: &Machine, plane: &Plane, mesh: &Mesh) -> Vec<Condition> {
    let setup = &machine.setup;
    let around = machine.around();
    let rise = |own: &History| machine.rise(own);
    let mut all = Vec::new();
    for boundary in &setup.boundaries {
        let sides = boundary.edge.clone();
        all.push(match &boundary.condition {
            boundary::Condition::Flux(flux) => Condition::Flux { sides, flux: flux.clone() },
            boundary::Condition::Convection { coefficient, ambient } => {
                let ambient = ambient.as_ref().map_or(around.clone(), rise);
                Condition::Convection { sides, coefficient: *coefficient, ambient }
            }
            boundary::Condition::Temperature(own) => Condition::Temperature { sides, temperature: rise(own) },
            boundary::Condition::Moving { speed, width, flux, from } => {
                Condition::MovingFlux { sides, flux: *flux, width: *width, start: *from, speed: *speed }
            }
        });
    }
    if machine.convection > 0.0 {
        let (coefficient, ambient) = (machine.convection, around.clone());
        all.push(Condition::Convection { sides: FREE.into(), coefficient, ambient: ambient.clone() });
        all.push(Condition::Faces { coefficient, ambient });
    }
    if let (true, Some([_, height])) = (machine.base > 0.0, plane.size) {
        let coefficient = machine.base / (height * plane.width);
        all.push(Condition::Convection { sides: "left".into(), coefficient, ambient: machine.around_base() });
    }
    for PointSource { at, power, .. } in &machine.sources {
        all.push(Condition::Source { shares: section(mesh, *at), power: power.clone() });
    }
    all
}

/// Where heat comes in over a whole section, m.
pub fn sections(machine: &Machine) -> Vec<f64> {
    machine.sources.iter().map(|source| source.at).collect()
}

/// The section of a rectangle at x (m) as shares of its nodes, which sum to one: along it every element is
/// crossed from bottom to top.
fn section(mesh: &Mesh, x: f64) -> Vec<(usize, f64)> {
    /// Gauss points along the way through an element, exact for its shape functions: (η, weight).
    const POINTS: [(f64, f64); 2] = [(-0.577_350_269_189_625_8, 1.0), (0.577_350_269_189_625_8, 1.0)];
    let mut shares = Vec::new();
    let mut whole = 0.0;
    for element in mesh.elements() {
        let coordinates = mesh.coordinates(element);
        // Corners stand counter-clockwise from the lower left.
        let ([left, low], [right, high]) = (coordinates[0], coordinates[2]);
        // On a border of elements the one towards the base.
        if x > right * (1.0 + 1e-12) || (left > 0.0 && x <= left * (1.0 + 1e-12)) {
            continue;
        }
        let xi = (2.0 * (x - left) / (right - left) - 1.0).min(1.0);
        for (eta, weight) in POINTS {
            let shapes = element.kind.shapes([xi, eta]);
            let part = 0.5 * weight * (high - low);
            whole += part;
            shares.extend(element.nodes.iter().zip(shapes).map(|(n, shape)| (*n as usize, part * shape)));
        }
    }
    shares.iter_mut().for_each(|(_, share)| *share /= whole);
    shares
}

/// How the rises of all nodes add up to what is looked at. What the body does is weighed by reciprocity, and
/// solved for once.
fn probes(setup: &Setup, plane: &Plane, mesh: &Mesh, looks: &[Look]) -> Result<Vec<Probe>, Failure> {
    let shape = |look: &&Look| !matches!(look, Look::Rise { .. });
    let elastic = match looks.iter().find(shape) {
        Some(_) => Some(ElasticSystem::free(mesh, elasticity(setup, plane)?).map_err(|e| unsolvable(&e))?),
        None => None,
    };
    let probe = |look: &Look| match (look, &elastic) {
        (Look::Rise { x, y }, _) => {
            let point = [*x, y.unwrap_or(plane.middle())];
            let place = mesh.locate(point).ok_or_else(|| off_body(point))?;
            Ok(Probe { weights: place.shares })
        }
        (Look::Elongation, Some(elastic)) => weighed(elastic, pulled(mesh, elastic.law())?),
        (Look::Bow, Some(elastic)) => weighed(elastic, bent(mesh, plane)?),
        (_, None) => Ok(Probe { weights: Vec::new() }),
    };
    looks.iter().map(probe).collect()
}

/// The elastic law of a body that is free to grow.
///
/// # Errors
/// A material that is none.
pub fn elasticity(setup: &Setup, plane: &Plane) -> Result<Elasticity, Failure> {
    let material = &setup.material;
    let (e, nu) = (material.youngs_modulus, material.poisson_ratio);
    Elasticity::new(PlaneState::Stress, e, nu, material.expansion, plane.width).map_err(|e| unsolvable(&e))
}

fn off_body([x, y]: [f64; 2]) -> Failure {
    Failure {
        message: format!("the place x = {:.3}, y = {:.3} is not on the body", LENGTH.shown(x), LENGTH.shown(y)),
        help: "give places on it; y is half way up where it is left out".into(),
    }
}

/// The displacement on which loads of one in all would do their work.
fn weighed(elastic: &ElasticSystem<&Mesh>, loads: Loads) -> Result<Probe, Failure> {
    let solution = elastic.solve(&loads).map_err(|e| unsolvable(&e))?;
    let work = Loads::thermal_work(elastic.mesh(), elastic.law(), &solution.nodes);
    Ok(Probe { weights: work.into_iter().enumerate().collect() })
}

/// One newton that pulls the right edge from the left, spread over both: it works on the mean elongation.
fn pulled(mesh: &Mesh, law: &Elasticity) -> Result<Loads, Failure> {
    let mut loads = Loads::none(mesh);
    for (edge, sign) in [("left", -1.0), ("right", 1.0)] {
        let sides = mesh.sides(edge).map_err(|_| Failure {
            message: format!("the elongation is that from edge left to edge right, and the mesh has no `{edge}`"),
            help: "name both ends in the mesh as physical groups, or observe temperatures alone".into(),
        })?;
        let length: f64 = sides.iter().map(|side| mesh.curve(*side).length()).sum();
        let pressure = sign / (length * law.thickness());
        loads.add_traction(mesh, law, edge, [pressure, 0.0]).map_err(|e| unsolvable(&e))?;
    }
    Ok(loads)
}

/// One newton that lifts the middle of the centre line against its ends.
fn bent(mesh: &Mesh, plane: &Plane) -> Result<Loads, Failure> {
    let [from, to] = plane.extent(0);
    let mut loads = Loads::none(mesh);
    for (x, force) in [(from, -0.5), (0.5 * (from + to), 1.0), (to, -0.5)] {
        let point = [x, plane.middle()];
        let place = mesh.locate(point).ok_or_else(|| off_body(point))?;
        place.shares.iter().for_each(|(node, share)| loads.add_force(*node, [0.0, share * force]));
    }
    Ok(loads)
}
