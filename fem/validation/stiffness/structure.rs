//! A machine that is pushed, and the same machine as another program assembles it.

use super::rig::{Machine, row};
use crate::process::{ForwardModel, assembled};
use crate::processes::stiffness::curve::Branch;
use crate::processes::stiffness::rows::{along, elsewhere};
use crate::validation::bench::tables;
use crate::validation::{Case, Tolerance};

/// Values of another program, printed to 1e-9 um.
const PRINTED: Tolerance = Tolerance::Absolute(1e-9);
const OPENSEES: &str = "OpenSees 3.7.1: the whole machine as one frame (tests/validation/opensees/lathe_on_bed.py)";

/// Readings of the dials under 1000 N at nose and centre, um.
const READINGS: [[f64; 6]; 2] = [
    [18.477048725, 4.540155580, 7.297884277, 3.738273120, 2.666666667, 1.333333333],
    [4.540155580, 24.299394270, 3.341427754, 8.145999634, 1.066666667, 2.933333333],
];

pub fn cases() -> Vec<Case> {
    let text = tables(include_str!("../../../models/pushed-lathe.toml"));
    let machine: Option<Machine> = assembled(&text, "");
    let reading = |load: usize, dial: usize| {
        let rows = elsewhere(along(vec![1000.0], Branch::Load), load, dial);
        machine.as_ref().and_then(|m| m.observe(&rows).ok()).map_or(f64::NAN, |values| 1e6 * values[0])
    };
    let of_load = |(load, expected): (usize, &[f64; 6])| {
        let place = ["nose", "centre"][load];
        let of_dial = |(dial, expected): (usize, &f64)| {
            let name = format!("lathe pushed at its {place}, dial {}", dial + 1);
            row(name, "displacement", (*expected, reading(load, dial), "um"), PRINTED, OPENSEES)
        };
        expected.iter().enumerate().map(of_dial).collect::<Vec<_>>()
    };
    READINGS.iter().enumerate().flat_map(of_load).collect()
}
