//! The axis to scale: the screw in its bearings, the nut in the middle of the travel.

use super::super::machine::Machine;
use crate::process::{Part, Sketch, range};
use crate::units::{FORCE, LENGTH, MICRO, STIFFNESS};

/// Length and diameter of the nut by those of the screw: about those of catalogues.
const NUT: [f64; 2] = [2.0, 1.8];

/// Draws the axis with what the travel and the drive are.
pub fn sketch(machine: &Machine) -> Sketch {
    let setup = &machine.setup;
    let screw = setup.screw();
    let (from, to) = (setup.from, setup.from + setup.travel);
    let ends = screw.held.iter().copied().chain([from, to]);
    let (low, high) = range(ends);
    let (radius, nut) = (0.5 * setup.diameter, 0.5 * (from + to));
    let half = [0.5 * NUT[0] * setup.diameter, 0.5 * NUT[1] * setup.diameter];
    let mut parts = vec![
        Part::rectangle([low, -radius], [high, radius]),
        Part::rectangle([nut - half[0], -half[1]], [nut + half[0], half[1]]),
    ];
    for at in &screw.held {
        let label = format!("fixed bearing at {:.1}", LENGTH.shown(*at));
        parts.push(Part::Support { at: [*at, -radius], away: [0.0, -1.0], label });
    }
    if let Some(winding) = &machine.winding {
        let label = format!("nut and bearing, {:.1}", STIFFNESS.shown(winding.stiffness));
        parts.push(Part::Spring { at: [nut, half[1]], away: [0.0, 1.0], label });
        let friction = setup.drag_at(nut) * winding.friction;
        let label = format!("friction, {:.0}", FORCE.shown(friction));
        parts.push(Part::Force { at: [nut + half[0], 0.0], force: [-friction, 0.0], label });
    }
    let play = machine.play(nut);
    let play = if play == 0.0 { String::new() } else { format!(", play {:.2}", MICRO.shown(play)) };
    let title = format!("the screw, {:.1} a turn, its nut in the middle of the travel{play}", LENGTH.shown(setup.lead));
    Sketch { title, parts }
}
