//! What controls make of the files that `fem compensate` writes for them.
//!
//! Each module reads the text of a control's files as its manual says, and moves an axis with a known error as the
//! control would: it looks up, interpolates, counts and reverses. Nothing of the program is used for that. The error
//! must then be gone to the least increment, on axes of both signs, with targets at even and uneven distances, and
//! with random pitch errors.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod axis;
mod beckhoff;
mod fanuc;
mod heidenhain;
mod lathe;
mod linuxcnc;
mod mach4;
mod mill;
mod mitsubishi;
mod random;
mod refused;
mod rotary;
mod siemens;
mod text;
mod words;

use axis::Axis;

/// What a control adds to the commanded position (mm), read from its files: a position (mm), and whether it is
/// approached forwards.
pub type Added = Box<dyn Fn(f64, bool) -> f64>;

/// A control: its word after `--for`, what its files make it add, the least increment of a sum (mm), and whether it
/// has a table for each direction.
pub struct Control {
    name: &'static str,
    read: fn(&axis::Files) -> Added,
    least: f64,
    each_way: bool,
}

const CONTROLS: &[Control] = &[
    Control { name: "linuxcnc", read: linuxcnc::read, least: 1e-6, each_way: true },
    Control { name: "siemens-eec", read: siemens::eec, least: 1e-6, each_way: false },
    Control { name: "siemens-cec", read: siemens::cec, least: 1e-6, each_way: true },
    Control { name: "heidenhain", read: heidenhain::read, least: 1e-4, each_way: true },
    Control { name: "fanuc", read: fanuc::one_way, least: 1e-3, each_way: false },
    Control { name: "fanuc-bidirectional", read: fanuc::both_ways, least: 1e-3, each_way: true },
    Control { name: "mitsubishi", read: mitsubishi::read, least: 5e-4, each_way: false },
    Control { name: "mach4", read: mach4::read, least: 1e-4, each_way: true },
    Control { name: "beckhoff", read: beckhoff::read, least: 1e-4, each_way: true },
];

/// Every control that the program knows has its interpreter here, and its row in the page.
#[test]
fn every_control_is_read_again() {
    let known: Vec<&str> = fem::output::CONTROLS.iter().map(|control| control.name).collect();
    let page = include_str!("../../docs/compensation.md");
    for name in &known {
        assert!(CONTROLS.iter().any(|control| control.name == *name), "{name} has no interpreter");
        assert!(page.contains(&format!("\n| `{name}` | ")), "{name} has no row in the page");
    }
    assert_eq!(known.len(), CONTROLS.len());
}

/// What is left on an axis at its targets from both sides, once it is moved with what its control adds, mm. The
/// scale moves by as much as is added: the error of the place is met, and not that of the command.
fn left(axis: &Axis, added: &Added) -> Vec<f64> {
    let at = |target: f64, forward: bool| {
        let encoder = target + added(target, forward);
        encoder + axis.error(encoder, forward) - target
    };
    axis.targets.iter().flat_map(|x| [at(*x, true), at(*x, false)]).collect()
}

fn range(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::MIN, f64::max) - values.iter().copied().fold(f64::MAX, f64::min)
}

/// What may be left, mm: the rounding of both directions (a value and one for backlash are each off by half of the
/// least increment, which makes three halves both ways), the change of the error over what is added, and the unevenness
/// of the reversal where there is one value for it, half of whose difference stays on either side, by turns.
fn allowed(control: &Control, axis: &Axis) -> f64 {
    let uneven = if control.each_way { 0.0 } else { 0.5 * axis.uneven };
    1.5 * control.least + uneven + 2.0 * axis.steepest() * axis.largest() + 1e-9
}

#[test]
fn the_error_is_gone() {
    for axis in axis::axes() {
        let found = axis.compensated();
        for control in CONTROLS {
            let files = axis::files(control.name, &found).unwrap();
            let rest = range(&left(&axis, &(control.read)(&files)));
            let allowed = allowed(control, &axis);
            assert!(rest <= allowed, "{} on {}: {rest} mm is left, {allowed} allowed", control.name, axis.name);
            assert!(
                (files.left - rest).abs() < 2.0 * axis.steepest() * axis.largest() + 1e-9,
                "{} on {}: {} told, {rest} found",
                control.name,
                axis.name,
                files.left
            );
            // The twin: without its files the axis is off by far more.
            let without: Added = Box::new(|_, _| 0.0);
            assert!(range(&left(&axis, &without)) > 3.0 * allowed, "{} shows nothing", axis.name);
        }
    }
}

/// The sign, twice over: what is left with the files turned over is twice the error.
#[test]
fn the_other_sign_doubles_the_error() {
    let axis = &axis::axes()[0];
    let without: Added = Box::new(|_, _| 0.0);
    let error = range(&left(axis, &without));
    let found = axis.compensated();
    for control in CONTROLS {
        let added = (control.read)(&axis::files(control.name, &found).unwrap());
        let turned: Added = Box::new(move |x, forward| -added(x, forward));
        let doubled = range(&left(axis, &turned));
        assert!((doubled - 2.0 * error).abs() < 3.0 * control.least + 0.01 * error, "{}: {doubled}", control.name);
    }
}

/// Random pitch errors and reversals, of either sign, on axes of random travel.
#[test]
fn random_errors_are_gone() {
    let mut random = random::Random(7);
    for _ in 0..6 {
        let axis = Axis::random(&mut random);
        let found = axis.compensated();
        for control in CONTROLS {
            let files = axis::files(control.name, &found).unwrap_or_else(|why| panic!("{}: {why}", axis.name));
            let rest = range(&left(&axis, &(control.read)(&files)));
            let allowed = allowed(control, &axis);
            assert!(rest <= allowed, "{} on {}: {rest} mm is left, {allowed} allowed", control.name, axis.name);
        }
    }
}
