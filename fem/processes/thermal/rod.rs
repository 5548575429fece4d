//! A heated rod.

use std::f64::consts::PI;

use super::follow::{Followed, Look, Watch, unsolvable};
use super::machine::Machine;
use super::surroundings::Side;
use crate::process::{Failure, Segment};
use crate::solve::conduction::Run;
use crate::solve::rod::{Film, History, Joint, Probe, Rod, RodPiece, RodSystem, Sensor, Stepping, Track};

/// Number of the surroundings of all that has no others.
const ROOM: usize = 0;
/// Number of those of the base, where they are others.
const BASE: usize = 1;
/// Number of those of the first section.
const FIRST: usize = 2;

/// The rod of a machine.
fn rod(machine: &Machine, segments: &[Segment]) -> Rod {
    let (material, sections) = (&machine.setup.material, &machine.setup.sections);
    let piece = |s: &Segment| RodPiece {
        length: s.length,
        heat_capacity: material.density * material.specific_heat * s.section.area(),
        conductance: material.conductivity * s.section.area(),
        loss: 0.0,
    };
    let (mut outside, bores): (Vec<_>, Vec<_>) =
        sections.iter().enumerate().partition(|(_, s)| s.side == Side::Outside);
    outside.sort_by(|a, b| a.1.ends[0].total_cmp(&b.1.ends[0]));
    let mut films = Vec::new();
    let mut start = 0.0;
    for Segment { length, section } in segments {
        let own = [start, start + length];
        start = own[1];
        let mut film = |ends: [f64; 2], around: usize, coefficient: f64, diameter: f64| {
            let ends = [ends[0].max(own[0]), ends[1].min(own[1])];
            if ends[0] < ends[1] && coefficient > 0.0 {
                films.push(Film { ends, loss: coefficient * PI * diameter, around });
            }
        };
        let mut free = own[0];
        for (number, s) in &outside {
            film([free, s.ends[0]], ROOM, machine.convection, section.diameter);
            film(s.ends, FIRST + number, s.coefficient.unwrap_or(machine.convection), section.diameter);
            free = free.max(s.ends[1]);
        }
        film([free, own[1]], ROOM, machine.convection, section.diameter);
        for (number, s) in &bores {
            film(s.ends, FIRST + number, s.coefficient.unwrap_or(0.0), section.bore);
        }
    }
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
        base_around: if machine.setup.at_base.is_some() { BASE } else { ROOM },
        films,
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
    let energy = system.run(&stepping(run), &around(machine), |time, nodes, switched| {
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
    let values = system.read(&stepping(run), &around(machine), &sensors, readings, &machine.setup.rods);
    values.map_err(|e| unsolvable(&e))
}

/// Rises of all surroundings, by their numbers.
fn around(machine: &Machine) -> Vec<History> {
    let sections = machine.setup.sections.iter().map(|s| machine.rise(&s.temperature));
    [machine.around(), machine.around_base()].into_iter().chain(sections).collect()
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
        // A rod that is as warm above as below stays straight, and its diameter is nothing that is looked at.
        Look::Bow | Look::Diameter { .. } => Probe { weights: Vec::new() },
    }
}
