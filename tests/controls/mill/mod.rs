//! What mills make of programs that carry a correction.
//!
//! As for lathes, the interpreter reads a program by the manuals alone, in whole hundred-millionths of a micrometre.
//! Programs of many styles must leave the top as high as is wanted along every track to the least increment, and keep
//! every byte outside of their Z words.

mod interpreter;
mod programs;
mod refused;
mod styles;

use fem::gcode::{Across, Breadth, Corrected, Course, Fineness, MILL, Program, Spot, Stretch, Workpiece, corrected};

/// Length and width of the top, mm.
pub const LENGTH: f64 = 100.0;
pub const WIDTH: f64 = 40.0;

/// A top whose zero is its corner, under a cutter of 24 mm.
pub fn top() -> Workpiece {
    Workpiece {
        axes: MILL,
        zero: Spot { y: -0.5e-3 * WIDTH, ..Spot::default() },
        across: Across::Height,
        fineness: Fineness { chord_tolerance: 1e-6, increment: None },
        agreement: 100e-6,
        stretches: vec![Stretch { from: 0.0, to: 1e-3 * LENGTH, level: 0.0 }],
        breadth: Some(Breadth { half: 0.5e-3 * WIDTH, reach: 12e-3 }),
        pass: [0.0, 1e-3 * LENGTH],
        feed: None,
    }
}

/// The change of the height that is wanted at a place (mm from the corner), um.
pub fn wanted(x: f64, y: f64) -> f64 {
    -14.0 + 0.09 * x + 6.0 * (x / 11.0).sin() + 0.3 * (y - 0.5 * WIDTH)
}

/// A program that carries it.
pub fn carry(work: &Workpiece, text: &[u8], adds: bool) -> Result<Corrected, String> {
    let program = Program::of("top.ngc", text.to_vec(), work).map_err(|error| error.to_string())?;
    let places: Vec<f64> = (0..=400).map(|i| 1e-3 * LENGTH * f64::from(i) / 400.0).collect();
    let lines = [0.0, 0.5 * WIDTH, WIDTH].map(|y| {
        let changes: Vec<f64> = places.iter().map(|x| 1e-6 * wanted(1e3 * x, y)).collect();
        (1e-3 * (y - 0.5 * WIDTH), changes)
    });
    let courses: Vec<Course> = lines.iter().map(|(y, changes)| Course { y: *y, places: &places, changes }).collect();
    corrected(&program, work, &courses, adds).map_err(|error| error.to_string())
}
