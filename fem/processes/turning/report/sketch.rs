//! The lathe to scale: the shaft in its supports, bent where the tool bends the system most.

use super::super::elastic::{Deflection, condense};
use super::super::machine::Machine;
use super::structure;
use crate::joint::Joint;
use crate::process::{Failure, Part, Sketch};
use crate::solve::Moved;
use crate::units::{FORCE, LENGTH, STIFFNESS};

/// Nodes of the bent line.
const NODES: usize = 80;

/// Draws the machine with the tool at that of the positions (m) at which it gives way most.
///
/// # Errors
/// The shaft cannot be condensed.
pub fn sketch(machine: &Machine, positions: &[f64], deflections: &[Deflection]) -> Result<Sketch, Failure> {
    let setup = &machine.setup;
    let largest = deflections.iter().zip(positions).max_by(|a, b| a.0.total.total_cmp(&b.0.total));
    let Some((deflection, &tool)) = largest else { return Ok(Sketch::default()) };
    let length = setup.length();
    let nodes = (0..=NODES).map(|i| length * i as f64 / NODES as f64);
    let all: Vec<f64> = std::iter::once(tool).chain(nodes).collect();
    let shaft = condense(machine, &all)?;
    let joints = Moved { ends: deflection.supports.displacements, ..deflection.moved() };
    let line = shaft.line(0, deflection.force, &joints);
    // What stands out of line is there without the force too.
    let before = shaft.line(0, 0.0, &Moved::default());
    let bent = |i: usize| ([all[i], 0.0], [0.0, line[i] - before[i]]);
    let mut parts = Vec::new();
    if let Some(base) = &setup.base
        && let Some(displaced) = structure::standing(base, &shaft, (0, tool), deflection)
    {
        parts.extend(base.drawn.sketch(&displaced));
    }
    let mut from = 0.0;
    for segment in &setup.segments {
        let (to, radius) = (from + segment.length, 0.5 * segment.section.diameter);
        parts.push(Part::rectangle([from, -radius], [to, radius]));
        from = to;
    }
    parts.push(Part::Bent((1..all.len()).map(bent).collect()));
    let (head_force, tail_force) = (deflection.supports.forces[0], deflection.supports.forces[1]);
    let held = |at, away, joint: &Joint, name: &str, force: f64| {
        let label = match (joint.spring_compliance > 0.0, joint.contacts.is_empty()) {
            (true, true) => format!("{name}, {:.1}", STIFFNESS.shown(1.0 / joint.spring_compliance)),
            (_, false) => format!("{name}, a contact"),
            (false, true) => format!("{name}, rigid"),
        };
        let label = format!("{label}, {:.0}", FORCE.shown(force));
        let is_rigid = joint.spring_compliance <= 0.0 && joint.contacts.is_empty();
        if is_rigid { Part::Support { at, away, label } } else { Part::Spring { at, away, label } }
    };
    let radius = |x: f64| 0.5 * setup.diameter(x);
    let up = [0.0, 1.0];
    // On a structure they are drawn with it.
    if setup.base.is_none() {
        parts.push(held([0.0, radius(0.0)], up, &machine.headstock, "headstock", head_force));
        if setup.workholding.has_tailstock() {
            parts.push(held([length, radius(length)], up, &machine.tailstock, "tailstock", tail_force));
        }
    }
    for rest in &setup.steady_rests {
        let label = format!("rest, {:.1}", STIFFNESS.shown(rest.stiffness));
        parts.push(Part::Spring { at: [rest.at, radius(rest.at)], away: up, label });
    }
    let carriage = if machine.carriage.spring_compliance > 0.0 {
        format!("; carriage {:.1}", STIFFNESS.shown(1.0 / machine.carriage.spring_compliance))
    } else {
        String::new()
    };
    let label = format!("tool, {:.0}{carriage}", FORCE.shown(deflection.force));
    parts.push(Part::Force { at: [tool, -radius(tool)], force: [0.0, deflection.force], label });
    Ok(Sketch { title: format!("the shaft with the tool at x = {:.1}", LENGTH.shown(tool)), parts })
}
