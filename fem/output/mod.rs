//! Writing results: for people, for programs, for ParaView. Files appear whole or not at all.

pub mod budget;
pub mod comparison;
pub mod compensation;
pub mod csv;
pub mod diagnosis;
pub mod files;
pub mod fit;
pub mod json;
pub mod plan;
pub mod plot;
pub mod svg;
pub mod text;
pub mod vtk;

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::compare::Comparison;
use crate::measure::Measurements;
use crate::model::{Model, Run};
use crate::process::{Animation, Drawing};
use crate::progress::Progress;

/// Writing failed.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The file system refused.
    #[error("{} cannot be written: {error}", path.display())]
    File {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// A shape cannot be written as VTK.
    #[error("{} cannot be written: {error}", path.display())]
    Shape {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: vtk::VtkError,
    },
}

/// Writes everything a run gives into `directory`: `profile.csv`, further tables as `NAME.csv`, `summary.json`, drawings as `NAME.svg`, and the animation as `NAME.pvd` with
/// its frames in `NAME/`. Gives the files that a user opens.
///
/// # Errors
/// A file cannot be written.
pub fn write_run(model: &Model, run: &Run, directory: &Path, progress: &Progress) -> Result<Vec<PathBuf>, OutputError> {
    let unwritable = |error: std::io::Error| OutputError::File { path: directory.to_path_buf(), error };
    let stage = files::Stage::new(directory).map_err(unwritable)?;
    stage.write(Path::new("profile.csv"), csv::table(&run.outcome.profile).as_bytes())?;
    let mut written = vec![directory.join("profile.csv")];
    for (name, table) in &run.outcome.tables {
        let file = PathBuf::from(format!("{name}.csv"));
        stage.write(&file, csv::table(table).as_bytes())?;
        written.push(directory.join(file));
    }
    if let Some(animation) = &run.outcome.animation {
        written.push(directory.join(write_animation(animation, &stage, progress)?));
    }
    for drawing in &run.outcome.drawings {
        written.push(directory.join(write_drawing(drawing, &stage)?));
    }
    stage.write(Path::new("summary.json"), format!("{:#}\n", json::run(model, run)).as_bytes())?;
    written.push(directory.join("summary.json"));
    stage.publish()?;
    if let Some(animation) = &run.outcome.animation {
        files::remove_frames_from(&directory.join(animation.name), animation.name, animation.frames);
    }
    Ok(written)
}

/// Writes what is left of a comparison: `residuals.csv`, the measured and the predicted shape as `compared.pvd`, where the process has a
/// body to show, and `compared.svg`, where it makes a contour.
///
/// # Errors
/// A file cannot be written.
pub fn write_comparison(
    model: &Model,
    measurements: &Measurements,
    comparison: &Comparison,
    directory: &Path,
) -> Result<(), OutputError> {
    let unwritable = |error: std::io::Error| OutputError::File { path: directory.to_path_buf(), error };
    let stage = files::Stage::new(directory).map_err(unwritable)?;
    stage.write(Path::new("residuals.csv"), comparison::residuals(measurements, comparison).as_bytes())?;
    let places = model.system.places(&measurements.rows);
    let shapes = places.as_ref().map(|p| comparison::shapes(p, comparison));
    if let Some(shapes) = &shapes {
        write_animation(shapes, &stage, &Progress::default())?;
    }
    if let (Some(places), Some(nominal)) = (&places, model.system.contour()) {
        let rows = model.system.resolved(&measurements.rows);
        let drawing = comparison::drawing(nominal, model.process.coordinates(), &rows, places, comparison);
        write_drawing(&drawing, &stage)?;
    }
    stage.publish()?;
    if let Some(shapes) = shapes {
        files::remove_frames_from(&directory.join(shapes.name), shapes.name, shapes.frames);
    }
    Ok(())
}

fn write_drawing(drawing: &Drawing, stage: &files::Stage) -> Result<PathBuf, OutputError> {
    let path = PathBuf::from(format!("{}.svg", drawing.name));
    stage.write(&path, svg::drawing(drawing).as_bytes())?;
    Ok(path)
}

fn write_animation(animation: &Animation, stage: &files::Stage, progress: &Progress) -> Result<PathBuf, OutputError> {
    let folder = Path::new(animation.name);
    let name = |i: usize| format!("{}_{i:04}.vtu", animation.name);
    progress.expect(animation.frames as u64);
    let write = |i: usize| {
        let frame = (animation.frame)(i);
        let path = folder.join(name(i));
        let bytes = vtk::vtu(&frame.grid).map_err(|error| OutputError::Shape { path: path.clone(), error })?;
        stage.write(&path, &bytes)?;
        progress.advance(1);
        Ok((frame.time, format!("{}/{}", animation.name, name(i))))
    };
    let frames: Vec<(f64, String)> =
        (0..animation.frames).into_par_iter().map(write).collect::<Result<_, OutputError>>()?;
    let path = PathBuf::from(format!("{}.pvd", animation.name));
    let text = vtk::pvd(&frames).map_err(|error| OutputError::Shape { path: path.clone(), error })?;
    stage.write(&path, text.as_bytes())?;
    Ok(path)
}
