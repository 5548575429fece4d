//! A compensation: for people, for programs, and for controllers.

mod controller;
mod json;
mod text;

pub use json::json;
pub use text::text;

use std::path::{Path, PathBuf};

use super::{OutputError, csv, files};
use crate::compensate::Compensation;
use crate::measure::Measurements;
use crate::model::Model;

/// What may be written.
pub const FILES: [&str; 6] =
    ["points.csv", "segments.csv", "both-directions.csv", LINUXCNC, "predicted.csv", "compensation.json"];

/// The table of LinuxCNC's compensation.
pub const LINUXCNC: &str = "linuxcnc.comp";

/// Writes `compensation.json`, the tables `points.csv`, `segments.csv`, `both-directions.csv` and, where it takes them, `linuxcnc.comp`, and
/// `predicted.csv`, what is left along the travel. Gives the files.
///
/// # Errors
/// A file cannot be written.
pub fn write(
    model: &Model,
    measurements: &Measurements,
    compensation: &Compensation,
    directory: &Path,
) -> Result<Vec<PathBuf>, OutputError> {
    let unwritable = |error: std::io::Error| OutputError::File { path: directory.to_path_buf(), error };
    let stage = files::Stage::new(directory).map_err(unwritable)?;
    let [points, segments, both] = &compensation.schemes;
    let texts = [
        Some(csv::table(&controller::points(&points.table))),
        Some(csv::table(&controller::segments(&segments.table))),
        Some(csv::table(&controller::both_directions(&both.table))),
        controller::linuxcnc(&both.table),
        Some(csv::table(&controller::predicted(compensation))),
        Some(format!("{:#}\n", json(model, measurements, compensation))),
    ];
    let mut written = Vec::new();
    for (name, text) in FILES.iter().zip(&texts) {
        if let Some(text) = text {
            stage.write(Path::new(name), text.as_bytes())?;
            written.push(directory.join(name));
        }
    }
    stage.publish()?;
    Ok(written)
}
