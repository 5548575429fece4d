//! The ring to scale, with the forces of its jaws.

use std::f64::consts::TAU;

use super::super::machine::Machine;
use crate::process::{Part, Sketch};
use crate::units::{FORCE, LENGTH};

/// Corners of a circle.
const CORNERS: usize = 120;

/// Draws the ring as it is clamped.
pub fn sketch(machine: &Machine) -> Sketch {
    let setup = &machine.setup;
    let on = |radius: f64, angle: f64| [radius * angle.cos(), radius * angle.sin()];
    let circle = |radius: f64| (0..CORNERS).map(|i| on(radius, TAU * i as f64 / CORNERS as f64)).collect();
    let mut parts = vec![Part::Body(vec![circle(setup.outer_radius), circle(setup.inner_radius)])];
    let forces = machine.cutting_forces();
    for (i, angle) in machine.jaw_angles.iter().enumerate() {
        let force = forces[i % 2];
        let label = format!("jaw {}, {:.0}", i + 1, FORCE.shown(force));
        let pushed = on(-setup.grip.inwards() * force, *angle);
        parts.push(Part::Force { at: on(setup.held_radius(), *angle), force: pushed, label });
    }
    let [outer, inner] = [setup.outer_radius, setup.inner_radius].map(|r| LENGTH.shown(2.0 * r));
    Sketch { title: format!("the ring, {outer:.1} outside and {inner:.1} inside, while it is cut"), parts }
}
