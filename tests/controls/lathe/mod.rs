//! What lathes make of programs that carry a correction.
//!
//! The interpreter reads a program by the manuals alone (FANUC 16i/18i-TB, LinuxCNC), in whole hundred-millionths of a
//! micrometre, and shares nothing with the program: neither a parser nor a way to find the surface. Programs of many styles
//! must then make the contour that is wanted to the least increment, and keep every byte outside of their X words.

mod interpreter;
mod programs;
mod styles;

use fem::gcode::{Across, Corrected, Course, Fineness, LATHE, Program, Spot, Stretch, Workpiece, corrected};

/// Length of the shaft, and where its step is, mm from the headstock.
pub const LENGTH: f64 = 100.0;
pub const STEP: f64 = 40.0;

/// A shaft of 40 mm up to the step and 30 mm beyond it.
pub fn shaft() -> Workpiece {
    let stretch =
        |(from, to, radius): (f64, f64, f64)| Stretch { from: 1e-3 * from, to: 1e-3 * to, level: 1e-3 * radius };
    Workpiece {
        axes: LATHE,
        zero: Spot { x: 1e-3 * LENGTH, ..Spot::default() },
        across: Across::Diameter,
        fineness: Fineness { chord_tolerance: 1e-6, increment: None },
        agreement: 100e-6,
        stretches: [(0.0, STEP, 20.0), (STEP, LENGTH, 15.0)].map(stretch).to_vec(),
        pass: [1e-3 * LENGTH, 0.0],
        breadth: None,
        feed: Some(0.15e-3),
    }
}

/// The change of the radius that is wanted at a place (mm from the headstock), um.
pub fn wanted(x: f64) -> f64 {
    -14.0 + 0.09 * x + 6.0 * (x / 11.0).sin()
}

/// A program that carries it.
pub fn carry(work: &Workpiece, text: &[u8], adds: bool) -> Result<Corrected, String> {
    let program = Program::of("part.ngc", text.to_vec(), work).map_err(|error| error.to_string())?;
    let places: Vec<f64> = (0..=400).map(|i| 1e-3 * LENGTH * f64::from(i) / 400.0).collect();
    let changes: Vec<f64> = places.iter().map(|x| 1e-6 * wanted(1e3 * x)).collect();
    corrected(&program, work, &[Course { y: 0.0, places: &places, changes: &changes }], adds)
        .map_err(|error| error.to_string())
}
