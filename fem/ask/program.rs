//! The user's own program, corrected.

use std::path::Path;

use super::Error;
use crate::correct::{Correction, Programmed};
use crate::gcode::{Program, Workpiece, corrected};
use crate::input::Problem;
use crate::model::Model;

/// Names of the other files of a correction.
const TAKEN: [&str; 3] = ["correction.csv", "correction.json", "contour.ngc"];

/// Reads a program for the part of a model.
///
/// # Errors
/// The process has no programs, or this one cannot be followed.
pub fn program(model: &Model, path: &Path) -> Result<Program, Error> {
    let work = workpiece(model)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if TAKEN.iter().any(|taken| name.eq_ignore_ascii_case(taken)) {
        let problem = Problem::new(format!("{}: the correction has a file of this name itself", path.display()));
        return Err(problem.help("give the program another name").into());
    }
    Ok(Program::read(path, &work)?)
}

/// The program with the contour of a correction; where `adds` says so, with blocks put between.
///
/// # Errors
/// No block of it finishes the part, or the model cannot be computed.
pub fn programmed(model: &Model, found: &Correction, program: &Program, adds: bool) -> Result<Programmed, Error> {
    let work = workpiece(model)?;
    if found.is_for_several() {
        let problem =
            Problem::new(format!("{}: each place and each pallet has a contour of its own", model.source.name));
        return Err(problem
            .help(
                "give a program for each of them: leave the other [[place]] and [[pallet]] out of the model; without a \
                 program `correction.csv` has all contours",
            )
            .into());
    }
    let corrected = corrected(program, &work, &found.common_courses(), adds)?;
    let with = found.with_contour(model, &corrected.carried)?;
    let name = Path::new(&*program.source.name).file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(Programmed { name, corrected, with })
}

fn workpiece(model: &Model) -> Result<Workpiece, Error> {
    model.require_part()?;
    model.system.program().ok_or_else(|| {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        problem.help("programs are corrected for turned shafts and milled tops").into()
    })
}
