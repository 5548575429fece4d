//! A heated body in a plane: a plate, or the half section of a body of revolution.

use std::sync::Arc;

use super::body::{Outline, Plane};
use super::boundary;
use super::follow::{Followed, Look, Watch, unsolvable};
use super::machine::Machine;
use super::over_temperature::Laws;
use super::setup::Setup;
use super::source::Strip;
use super::surroundings::Surroundings;
use crate::element::plane::{Capacity, Conduction, Elasticity, PlaneState, Thickness, WHOLE};
use crate::input::Varying;
use crate::mesh::{Mesh, MeshError, Side};
use crate::process::Failure;
use crate::solve::conduction::{Condition, History, Instant, Loss, Run, ThermalError, ThermalSystem};
use crate::solve::elastic::{ElasticSystem, Loads};
use crate::solve::rod::{PointSource, Probe, Track};
use crate::units::{LENGTH, TEMPERATURE, TIME};

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
    name_surfaces(&mut mesh, setup).map_err(|e| unsolvable(&e))?;
    let laws = Laws::of(setup);
    let law = Conduction {
        conductivity: laws.conductivity.scale(),
        heat_capacity: setup.material.density * laws.specific_heat.scale(),
        thickness: plane.thickness,
    };
    let conditions = conditions(machine, plane, &mesh)?;
    let properties = laws.properties(setup);
    let system = ThermalSystem::over_temperature(&mesh, law, properties, Capacity::Consistent, &conditions);
    let system = system.map_err(|e| unsolvable(&e))?;
    let probes = probes(setup, (plane, &mesh), &laws, looks)?;
    let switches: Vec<f64> = conditions.iter().flat_map(Condition::switches).collect();
    let mut track = Track::new(looks.len());
    // Of what does not change with the temperature the growth is in proportion to the rise.
    let bends = !setup.over_temperature.is_constant() && looks.iter().any(Look::is_shape);
    let observe = |now: Instant<'_>| {
        let grown: Option<Vec<f64>> =
            bends.then(|| now.temperatures().into_iter().map(|rise| laws.grown(rise)).collect());
        let read = |(look, probe): (&Look, &Probe)| {
            let own = |node: usize| match &grown {
                Some(grown) if look.is_shape() => grown[node],
                _ => now.at(node),
            };
            probe.weights.iter().map(|(node, weight)| weight * own(*node)).sum::<f64>()
        };
        let switched = now.time == 0.0 || now.time == run.end || switches.contains(&now.time);
        track.push(now.time, switched, looks.iter().zip(&probes).map(read));
        watch(now.time, &|| now.temperatures());
    };
    let energy = system.run(&vec![0.0; mesh.nodes().len()], run, observe);
    Ok(Followed { track, energy: energy.map_err(|error| not_followed(&error, setup.start))? })
}

/// A body that could not be followed to the end of the run, from a temperature (K) at the start.
fn not_followed(error: &ThermalError, start: f64) -> Failure {
    let ThermalError::Unknown { time, reached, known } = error else { return unsolvable(error) };
    let [reached, known] = [reached, known].map(|both| both.map(|rise| TEMPERATURE.format(start + rise)));
    let [coldest, hottest] = reached;
    Failure {
        message: format!(
            "the body is between {coldest} and {hottest} at {}, and its properties are known from {} to {}",
            TIME.format(*time),
            known[0],
            known[1]
        ),
        help: "record conductivity, specific_heat and expansion of the material as far as that".into(),
    }
}

/// Everything that heats and cools, as rises over the temperature at the start.
fn conditions(machine: &Machine, plane: &Plane, mesh: &Mesh) -> Result<Vec<Condition>, Failure> {
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
                match coefficient {
                    Varying::Constant(coefficient) => {
                        Condition::Convection { sides, coefficient: *coefficient, ambient }
                    }
                    Varying::Record(film) => {
                        let loss = Loss::Film(History::Record(film.clone()));
                        Condition::Surface { sides, loss, ambient }
                    }
                }
            }
            boundary::Condition::Radiation { emissivity, ambient } => {
                let ambient = ambient.as_ref().map_or(around.clone(), rise);
                let loss = Loss::Radiation { emissivity: *emissivity, zero: setup.start };
                Condition::Surface { sides, loss, ambient }
            }
            boundary::Condition::Temperature(own) => Condition::Temperature { sides, temperature: rise(own) },
            boundary::Condition::Moving { speed, width, flux, from } => {
                Condition::MovingFlux { sides, flux: flux.clone(), width: *width, start: *from, speed: *speed }
            }
        });
    }
    if machine.convection > 0.0 {
        let (coefficient, ambient) = (machine.convection, around.clone());
        all.push(Condition::Convection { sides: FREE.into(), coefficient, ambient: ambient.clone() });
        all.push(Condition::Faces { coefficient, ambient });
    }
    for (number, section) in setup.sections.iter().enumerate() {
        let coefficient = section.coefficient.unwrap_or(machine.convection);
        let ambient = rise(&section.temperature);
        all.push(Condition::Convection { sides: around_section(number), coefficient, ambient });
    }
    if machine.base > 0.0 && !matches!(plane.outline, Outline::Mesh(_)) {
        let coefficient = machine.base / plane.base_area();
        all.push(Condition::Convection { sides: "left".into(), coefficient, ambient: machine.around_base() });
    }
    for PointSource { at, power, .. } in &machine.sources {
        all.push(Condition::Source { shares: section(mesh, plane.thickness, *at), power: power.clone() });
    }
    for heated in &setup.strips {
        all.push(Condition::Source { shares: strip(mesh, plane.thickness, heated)?, power: heated.power.clone() });
    }
    Ok(all)
}

/// Name of the sides around which a section of the environment is.
fn around_section(number: usize) -> String {
    format!("section {number}")
}

/// Names the sides around which sections of the environment are, and what is left to the film of the surroundings.
fn name_surfaces(mesh: &mut Mesh, setup: &Setup) -> Result<(), MeshError> {
    let sections: Vec<String> = (0..setup.sections.len()).map(around_section).collect();
    for (name, section) in sections.iter().zip(&setup.sections) {
        let Surroundings { side, ends: [from, to], .. } = section;
        mesh.name_part(name, side.edge(), |[x, _]| (*from..=*to).contains(&x))?;
    }
    let taken = setup.boundaries.iter().filter(|b| !b.is_open()).map(|b| b.edge.as_str());
    mesh.name_rest(FREE, &taken.chain(sections.iter().map(String::as_str)).collect::<Vec<_>>())
}

/// Where heat comes in over a whole section, or what is around the body changes, m.
pub fn sections(machine: &Machine) -> Vec<f64> {
    let setup = &machine.setup;
    let strips = setup.strips.iter().filter(|strip| strip.axis() == 0).flat_map(|strip| strip.ends);
    let around = setup.sections.iter().flat_map(|section| section.ends);
    machine.sources.iter().map(|source| source.at).chain(strips).chain(around).collect()
}

/// A strip of the surface as shares of its nodes, which sum to one: those of an even flux. Shoulders, across the way of
/// the strip, get none.
fn strip(mesh: &Mesh, thickness: Thickness, strip: &Strip) -> Result<Vec<(usize, f64)>, Failure> {
    let axis = strip.axis();
    let mut shares = Vec::new();
    for &side in mesh.sides(&strip.edge).map_err(|e| unsolvable(&e))? {
        let curve = mesh.curve(side);
        let [from, to] = [-1.0, 1.0].map(|s| curve.point(s)[axis]);
        if from == to {
            continue;
        }
        // Sides may run either way.
        let [a, b] = strip.ends.map(|place| (2.0 * (place - from) / (to - from) - 1.0).clamp(-1.0, 1.0));
        let own = curve.shape_integrals(thickness, [a.min(b), a.max(b)]);
        shares.extend(mesh.side_nodes(side).as_slice().iter().zip(own).map(|(node, share)| (*node as usize, share)));
    }
    let whole: f64 = shares.iter().map(|(_, share)| share).sum();
    shares.iter_mut().for_each(|(_, share)| *share /= whole);
    Ok(shares)
}

/// The section at x (m) as shares of its nodes, which sum to one: along it every element, a rectangle, is crossed from
/// bottom to top.
fn section(mesh: &Mesh, thickness: Thickness, x: f64) -> Vec<(usize, f64)> {
    /// Gauss points along the way through an element, exact for its shape functions, and for their product with the
    /// radius: (η, weight).
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
            let y = 0.5 * (low + high + eta * (high - low));
            let part = 0.5 * weight * (high - low) * thickness.weight(y);
            whole += part;
            shares.extend(element.nodes.iter().zip(shapes).map(|(n, shape)| (*n as usize, part * shape)));
        }
    }
    shares.iter_mut().for_each(|(_, share)| *share /= whole);
    shares
}

/// How the rises of all nodes add up to what is looked at. What the body does is weighed by reciprocity, and
/// solved for once.
fn probes(setup: &Setup, (plane, mesh): (&Plane, &Mesh), laws: &Laws, looks: &[Look]) -> Result<Vec<Probe>, Failure> {
    let elastic = match looks.iter().any(Look::is_shape) {
        true => Some(ElasticSystem::free(mesh, elasticity(setup, plane, laws)?).map_err(|e| unsolvable(&e))?),
        false => None,
    };
    let place = |x: f64, y: Option<f64>| [x, y.unwrap_or_else(|| plane.usual_y(x))];
    let probe = |look: &Look| match (look, &elastic) {
        (Look::Rise { x, y }, _) => {
            let point = place(*x, *y);
            let place = mesh.locate(point).ok_or_else(|| off_body(point))?;
            Ok(Probe { weights: place.shares })
        }
        (Look::Elongation, Some(elastic)) => weighed(elastic, pulled(mesh, elastic.law())?),
        (Look::Diameter { x, y }, Some(elastic)) => weighed(elastic, widened(mesh, place(*x, *y))?),
        (Look::Bow, Some(elastic)) => weighed(elastic, bent(mesh, plane)?),
        (_, None) => Ok(Probe { weights: Vec::new() }),
    };
    looks.iter().map(probe).collect()
}

/// The elastic law of a body that is free to grow, with the expansion that it has at the start.
///
/// # Errors
/// A material that is none.
pub fn elasticity(setup: &Setup, plane: &Plane, laws: &Laws) -> Result<Elasticity, Failure> {
    let material = &setup.material;
    let (e, nu, alpha) = (material.youngs_modulus, material.poisson_ratio, laws.expansion.scale());
    let law = match plane.thickness {
        Thickness::Uniform(width) => Elasticity::new(PlaneState::Stress, e, nu, alpha, width),
        Thickness::Revolved => Elasticity::revolved(e, nu, alpha),
    };
    law.map_err(|e| unsolvable(&e))
}

fn off_body([x, y]: [f64; 2]) -> Failure {
    Failure {
        message: format!("the place x = {:.3}, y = {:.3} is not on the body", LENGTH.shown(x), LENGTH.shown(y)),
        help: "give places on it; where y is left out it is half way up, of a body of revolution on its outside".into(),
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
        let thickness = law.thickness();
        let own = |side: &Side| mesh.curve(*side).shape_integrals(thickness, WHOLE).iter().sum::<f64>();
        let area = thickness.scale() * sides.iter().map(own).sum::<f64>();
        let pressure = sign / area;
        loads.add_traction(mesh, law, edge, [pressure, 0.0]).map_err(|e| unsolvable(&e))?;
    }
    Ok(loads)
}

/// Two newtons all around a circle: they work on the mean of its diameters, twice the change of its radius.
fn widened(mesh: &Mesh, circle: [f64; 2]) -> Result<Loads, Failure> {
    let mut loads = Loads::none(mesh);
    let place = mesh.locate(circle).ok_or_else(|| off_body(circle))?;
    place.shares.iter().for_each(|(node, share)| loads.add_force(*node, [0.0, 2.0 * share]));
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
