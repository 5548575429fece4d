//! A heated rod.

use super::follow::{Followed, Look, Watch, unsolvable};
use super::machine::Machine;
use crate::process::{Failure, Segment};
use crate::solve::conduction::Run;
use crate::solve::rod::{Joint, Probe, Rod, RodPiece, RodSystem, Sensor, Stepping, Track};

/// The rod of a machine.
fn rod(machine: &Machine, segments: &[Segment]) -> Rod {
    let material = &machine.setup.material;
    let piece = |s: &Segment| RodPiece {
        length: s.length,
        heat_capacity: material.density * material.specific_heat * s.section.area(),
        conductance: material.conductivity * s.section.area(),
        loss: machine.convection * std::f64::consts::PI * s.section.diameter,
    };
    // A joint at a step of the diameter touches over the smaller section.
    let area = |at: f64| {
        let mut start = 0.0;
        let touches = |s: &&Segment| {
            let own = start..=start + s.length;
            start += s.length;
            own.contains(&at)
        };
        segments.iter().filter(touches).map(|s| s.section.area()).fold(f64::INFINITY, f64::min)
    };
    Rod {
        pieces: segments.iter().map(piece).collect(),
        base: machine.base,
        joints: machine.contacts.iter().map(|c| Joint { at: c.at, conductance: c.conductance * area(c.at) }).collect(),
        sources: machine.sources.clone(),
    }
}

/// Follows a rod.
///
/// # Errors
/// It cannot be computed.
pub fn follow(
    machine: &Machine,
    segments: &[Segment],
    looks: &[Look],
    run: &Run,
    watch: Watch,
) -> Result<Followed, Failure> {
    let system = system(machine, segments)?;
    let probes: Vec<Probe> = looks.iter().map(|look| probe(&system, machine, *look)).collect();
    let mut track = Track::new(looks.len());
    let energy = system.run(&stepping(run), &machine.around(), |time, nodes, switched| {
        track.push(time, switched, probes.iter().map(|p| p.read(nodes)));
        watch(time, &|| nodes.to_vec());
    });
    Ok(Followed { track, energy: energy.map_err(|e| unsolvable(&e))? })
}

/// Value of each reading, given by the position of its look and its time (s).
///
/// # Errors
/// The rod cannot be computed.
pub fn read(
    machine: &Machine,
    segments: &[Segment],
    looks: &[Look],
    readings: &[(usize, f64)],
    run: &Run,
) -> Result<Vec<f64>, Failure> {
    let system = system(machine, segments)?;
    let sensor = |look: &Look| Sensor { probe: probe(&system, machine, *look), lag: machine.lag_of(*look) };
    let sensors: Vec<Sensor> = looks.iter().map(sensor).collect();
    let values = system.read(&stepping(run), &machine.around(), &sensors, readings, &machine.setup.rods);
    values.map_err(|e| unsolvable(&e))
}

/// The rod in elements.
///
/// # Errors
/// It cannot be computed.
pub fn system(machine: &Machine, segments: &[Segment]) -> Result<RodSystem, Failure> {
    RodSystem::new(&rod(machine, segments), machine.setup.element_size).map_err(|e| unsolvable(&e))
}

fn stepping(run: &Run) -> Stepping {
    Stepping { scheme: run.scheme, step: run.step, end: run.end }
}

fn probe(system: &RodSystem, machine: &Machine, look: Look) -> Probe {
    match look {
        Look::Elongation => {
            let mut whole = system.integral_to(machine.setup.body.length());
            whole.weights.iter_mut().for_each(|(_, weight)| *weight *= machine.setup.material.expansion);
            whole
        }
        Look::Rise { x, .. } => system.at(x),
        // A rod that is as warm above as below stays straight.
        Look::Bow => Probe { weights: Vec::new() },
    }
}
