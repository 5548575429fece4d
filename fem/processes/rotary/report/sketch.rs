//! The axis to scale, seen along it: the table, what drives it, its scale, and the torques on it.

use std::f64::consts::TAU;

use super::super::machine::Machine;
use super::super::scale::At;
use crate::process::{Part, Sketch};
use crate::units::{SMALL_ANGLE, TORQUE, TORSIONAL_STIFFNESS};

/// Points around a circle.
const AROUND: usize = 96;
/// Length and half the height of a worm by the radius of its wheel: about those of catalogues.
const WORM: [f64; 2] = [1.2, 0.15];
/// Wall of the ring of a scale by its radius.
const RING: f64 = 0.06;

/// Draws the axis in the middle of its range with what acts on it.
pub fn sketch(machine: &Machine) -> Sketch {
    let setup = &machine.setup;
    let (radius, middle) = (setup.shown_radius(), setup.from + 0.5 * setup.range);
    let mut parts = vec![Part::Body(vec![circle([0.0, 0.0], radius)])];
    match (setup.drive.worm, setup.drive.turns_of_pinion()) {
        (Some(_), _) => {
            let [long, half] = WORM.map(|own| own * radius);
            parts.push(Part::rectangle([-0.5 * long, -radius - 2.0 * half], [0.5 * long, -radius]));
        }
        (None, Some(ratio)) => {
            let own = radius / ratio.max(0.2);
            parts.push(Part::Body(vec![circle([0.0, -radius - own], own)]));
        }
        (None, None) => {}
    }
    if let Some(ring) = setup.scale.filter(|scale| scale.at == At::Table).and_then(|scale| scale.radius) {
        parts.push(Part::Body(vec![circle([0.0, 0.0], ring), circle([0.0, 0.0], (1.0 - RING) * ring)]));
    }
    parts.push(Part::Support { at: [0.0, 0.0], away: [0.0, 1.0], label: "axis".into() });
    if machine.compliance > 0.0 {
        let label = format!("drive, {:.3}", TORSIONAL_STIFFNESS.shown(1.0 / machine.compliance));
        parts.push(Part::Spring { at: [0.0, -radius], away: [-1.0, 0.0], label });
    }
    if machine.friction > 0.0 {
        let label = format!("friction, {:.1} against the motion", TORQUE.shown(machine.friction));
        parts.push(Part::Force { at: [radius, 0.0], force: [0.0, -machine.friction / radius], label });
    }
    let other = setup.test.torque + machine.load(middle);
    if other != 0.0 {
        let label = format!("torque, {:.1}", TORQUE.shown(other));
        parts.push(Part::Force { at: [-radius, 0.0], force: [0.0, -other / radius], label });
    }
    let play = machine.play(middle);
    let play = if play == 0.0 { String::new() } else { format!(", play {:.2}", SMALL_ANGLE.shown(play)) };
    let ratio = (setup.drive.ratio() * 1e4).round() / 1e4;
    let title = format!("the table along its axis, {ratio} turns of the motor in one of it{play}");
    Sketch { title, parts }
}

/// A circle by its corners.
fn circle([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let at = |i: usize| {
        let (sine, cosine) = (TAU * i as f64 / AROUND as f64).sin_cos();
        [x + radius * cosine, y + radius * sine]
    };
    (0..AROUND).map(at).collect()
}
