//! Reports as files in a folder: tables, pictures, shapes for ParaView, JSON.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::files::{self, Stage};
use super::report::{Format, Report};
use super::{Json, OutputError, comparison, compensation, csv, diagnosis, svg, vtk};
use crate::compare::Comparison;
use crate::measure::Measurements;
use crate::model::{Model, Run};
use crate::process::{Animation, Drawing};
use crate::progress::Progress;

/// The files of a report, which appear all together or not at all.
pub struct Folder<'a> {
    /// Where they appear; made if it is missing.
    pub directory: &'a Path,
    /// Files that were read and are never written over.
    pub reads: &'a [PathBuf],
    /// Of the frames.
    pub progress: &'a Progress,
}

impl Format for Folder<'_> {
    /// Writes the files, and lists those that a user opens.
    fn write(&self, report: &Report) -> Result<String, OutputError> {
        let written = match report {
            Report::Run(model, run) => self.run(model, run, report)?,
            Report::Comparison(models, measurements, comparisons) => {
                self.comparisons(models, measurements, comparisons)?
            }
            Report::Diagnosis(data, diagnosis) => self.files([
                ("diagnosis.json", Some(Json.write(report)?)),
                ("diagnosis.svg", Some(diagnosis::falling(data, diagnosis).svg())),
            ])?,
            Report::Compensation(_, found) => self.files(
                compensation::tables(found).into_iter().chain([("compensation.json", Some(Json.write(report)?))]),
            )?,
            Report::Fit(..) => self.files([("fit.json", Some(Json.write(report)?))])?,
            Report::Plan(..) => self.files([("plan.json", Some(Json.write(report)?))])?,
            Report::Budget(..) => self.files([("budget.json", Some(Json.write(report)?))])?,
            Report::Effects(..) => self.files([("effects.json", Some(Json.write(report)?))])?,
            Report::Validation(..) => self.files([("validation.json", Some(Json.write(report)?))])?,
        };
        let list: Vec<String> =
            written.iter().map(|name| format!("  {}", self.directory.join(name).display())).collect();
        Ok(format!("\nwritten\n{}\n", list.join("\n")))
    }
}

impl Folder<'_> {
    fn stage(&self, directory: &Path) -> Result<Stage, OutputError> {
        let unwritable = |error: std::io::Error| OutputError::File { path: directory.to_path_buf(), error };
        Stage::new(directory, self.reads).map_err(unwritable)
    }

    /// Texts with the names of their files, as far as there are any.
    fn files(
        &self,
        texts: impl IntoIterator<Item = (&'static str, Option<String>)>,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let stage = self.stage(self.directory)?;
        let mut written = Vec::new();
        for (name, text) in texts {
            if let Some(text) = text {
                stage.write(Path::new(name), text.as_bytes())?;
                written.push(PathBuf::from(name));
            }
        }
        stage.publish()?;
        Ok(written)
    }

    /// `profile.csv`, further tables as `NAME.csv`, the animation as `NAME.pvd` with its frames in `NAME/`,
    /// drawings as `NAME.svg`, and `summary.json`.
    fn run(&self, model: &Model, run: &Run, report: &Report) -> Result<Vec<PathBuf>, OutputError> {
        let reads = [self.reads, &model.paths()].concat();
        let stage = Folder { reads: &reads, ..*self }.stage(self.directory)?;
        let found = &run.report;
        let tables = [("profile", &found.profile)].into_iter().chain(found.tables.iter().map(|(name, t)| (*name, t)));
        let mut written = Vec::new();
        for (name, table) in tables {
            let file = PathBuf::from(format!("{name}.csv"));
            stage.write(&file, csv::table(table).as_bytes())?;
            written.push(file);
        }
        if let Some(animation) = &found.animation {
            written.extend(self.animation(animation, "view.py", model, &stage)?);
        }
        for drawing in &found.drawings {
            written.push(write_drawing(drawing, &stage)?);
        }
        stage.write(Path::new("summary.json"), Json.write(report)?.as_bytes())?;
        written.push("summary.json".into());
        stage.publish()?;
        if let Some(animation) = &found.animation {
            remove_frames_from(self.directory, animation);
        }
        Ok(written)
    }

    /// Into the folder, or into one of its own for each of several models.
    fn comparisons(
        &self,
        models: &[Model],
        measurements: &Measurements,
        comparisons: &[Comparison],
    ) -> Result<Vec<PathBuf>, OutputError> {
        let mut written = Vec::new();
        for (model, comparison) in models.iter().zip(comparisons) {
            let own = if models.len() > 1 { PathBuf::from(model.stem()) } else { PathBuf::new() };
            let files = self.comparison(model, measurements, comparison, &self.directory.join(&own))?;
            written.extend(files.into_iter().map(|file| own.join(file)));
        }
        Ok(written)
    }

    /// `residuals.csv`; the measured and the predicted shape as `compared.pvd`, where the process has a
    /// body to show; `compared.svg`, where it makes a contour.
    fn comparison(
        &self,
        model: &Model,
        measurements: &Measurements,
        comparison: &Comparison,
        directory: &Path,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let reads = [self.reads, &model.paths()].concat();
        let stage = Folder { reads: &reads, ..*self }.stage(directory)?;
        let residuals = PathBuf::from("residuals.csv");
        stage.write(&residuals, comparison::residuals(measurements, comparison).as_bytes())?;
        let mut written = vec![residuals];
        let places = model.system.places(&measurements.rows);
        let (observables, rows) = (model.process.observables(), &measurements.rows);
        let shapes = places.as_ref().map(|p| comparison::shapes(observables, rows, p, comparison));
        if let Some(shapes) = &shapes {
            written.extend(self.animation(shapes, "view-compared.py", model, &stage)?);
        }
        if let (Some(places), Some(nominal)) = (&places, model.system.contour()) {
            let rows = model.system.resolved(&measurements.rows);
            let drawing = comparison::drawing(nominal, model.process.coordinates(), &rows, places, comparison);
            written.push(write_drawing(&drawing, &stage)?);
        }
        stage.publish()?;
        if let Some(shapes) = &shapes {
            remove_frames_from(directory, shapes);
        }
        Ok(written)
    }

    /// `NAME.pvd` with true geometry, `NAME-magnified.pvd` as people look at it, their frames in `NAME/`, and the
    /// script that opens the second.
    fn animation(
        &self,
        animation: &Animation,
        script: &str,
        model: &Model,
        stage: &Stage,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let file = model.source.name.to_string();
        let series = vtk::Series::new(animation, model.title.as_deref().unwrap_or(&file), &file);
        let (real, magnified) = (animation.name.to_string(), magnified(animation.name));
        self.progress.expect(animation.frames as u64);
        let write = |i: usize| {
            let place = |stem: &str, end: &str| format!("{}/{stem}_{i:04}.{end}", animation.name);
            let paths = [place(&real, "vtu"), place(&magnified, "vtp")];
            let wrong = |error| OutputError::Shape { path: PathBuf::from(&paths[0]), error };
            let frame = series.frame(i).map_err(wrong)?;
            stage.write(Path::new(&paths[0]), &frame.real)?;
            if let Some(bytes) = &frame.magnified {
                stage.write(Path::new(&paths[1]), bytes)?;
            }
            self.progress.advance(1);
            Ok(paths.map(|path| (frame.time, path)))
        };
        let frames: Vec<[(f64, String); 2]> =
            (0..animation.frames).into_par_iter().map(write).collect::<Result<_, OutputError>>()?;
        let mut written = Vec::new();
        let view = series.view();
        for (k, stem) in [real, magnified].iter().enumerate().take(if view.is_some() { 2 } else { 1 }) {
            let path = PathBuf::from(format!("{stem}.pvd"));
            let list: Vec<(f64, String)> = frames.iter().map(|frame| frame[k].clone()).collect();
            let text = vtk::pvd(&list).map_err(|error| OutputError::Shape { path: path.clone(), error })?;
            stage.write(&path, text.as_bytes())?;
            written.push(path);
        }
        if let Some(view) = view {
            stage.write(Path::new(script), view.as_bytes())?;
            written.push(script.into());
        }
        Ok(written)
    }
}

/// The series with displacements magnified.
fn magnified(name: &str) -> String {
    format!("{name}-magnified")
}

/// Removes what an earlier, longer run has left of both series.
fn remove_frames_from(directory: &Path, animation: &Animation) {
    let folder = directory.join(animation.name);
    files::remove_frames_from(&folder, animation.name, animation.frames);
    files::remove_frames_from(&folder, &magnified(animation.name), animation.frames);
}

fn write_drawing(drawing: &Drawing, stage: &Stage) -> Result<PathBuf, OutputError> {
    let path = PathBuf::from(format!("{}.svg", drawing.name));
    stage.write(&path, svg::drawing(drawing).as_bytes())?;
    Ok(path)
}
