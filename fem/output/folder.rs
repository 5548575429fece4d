//! Reports as files in a folder: tables, pictures, shapes for ParaView, JSON.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::files::{Guard, Stage};
use super::report::{Format, Report};
use super::{Json, OutputError, comparison, compensation, csv, diagnosis, pictures, vtk};
use crate::compare::Comparison;
use crate::measure::Measurements;
use crate::model::{Model, Run};
use crate::process::Animation;
use crate::progress::Progress;

/// The files of a report, which appear all together or not at all.
pub struct Folder<'a> {
    /// Where they appear; made if it is missing.
    pub directory: &'a Path,
    /// Rule by which files there may be replaced.
    pub guard: Guard<'a>,
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
            Report::Diagnosis(data, diagnosis) => self.files(
                "diagnose",
                [
                    ("diagnosis.json", Some(Json.write(report)?)),
                    ("diagnosis.svg", Some(diagnosis::falling(data, diagnosis).svg().file())),
                ],
            )?,
            Report::Compensation(_, found, supplied) => self.files(
                "compensate",
                compensation::tables(found, supplied)
                    .into_iter()
                    .chain([("compensation.json", Some(Json.write(report)?))]),
            )?,
            Report::Fit(..) => self.files("fit", [("fit.json", Some(Json.write(report)?))])?,
            Report::Plan(..) => self.files("plan", [("plan.json", Some(Json.write(report)?))])?,
            Report::Budget(..) => self.files("budget", [("budget.json", Some(Json.write(report)?))])?,
            Report::Study(..) => self.files("study", [("study.json", Some(Json.write(report)?))])?,
            Report::Effects(..) => self.files("effects", [("effects.json", Some(Json.write(report)?))])?,
            Report::Validation(..) => self.files("validate", [("validation.json", Some(Json.write(report)?))])?,
        };
        let list: Vec<String> =
            written.iter().map(|name| format!("  {}", self.directory.join(name).display())).collect();
        Ok(format!("\nwritten\n{}\n", list.join("\n")))
    }
}

impl Folder<'_> {
    fn stage<'g>(&self, of: &'static str, guard: Guard<'g>) -> Result<Stage<'g>, OutputError> {
        Stage::new(self.directory, of, guard)
    }

    /// Texts with the names of their files, as far as there are any.
    fn files(
        &self,
        of: &'static str,
        texts: impl IntoIterator<Item = (&'static str, Option<String>)>,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let stage = self.stage(of, self.guard)?;
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
    /// figures as `NAME.svg`, and `summary.json`.
    fn run(&self, model: &Model, run: &Run, report: &Report) -> Result<Vec<PathBuf>, OutputError> {
        let reads = [self.guard.reads, &model.paths()].concat();
        let stage = self.stage("run", Guard { reads: &reads, ..self.guard })?;
        let found = &run.report;
        let tables = [("profile", &found.profile)].into_iter().chain(found.tables.iter().map(|(name, t)| (*name, t)));
        let mut written = Vec::new();
        for (name, table) in tables {
            let file = PathBuf::from(format!("{name}.csv"));
            stage.write(&file, csv::table(table).as_bytes())?;
            written.push(file);
        }
        if let Some(animation) = &found.animation {
            written.extend(self.animation(animation, "view.py", model, Path::new(""), &stage)?);
        }
        written.extend(pictures::stage_all(pictures::of_run(model, run), Path::new(""), &stage)?);
        stage.write(Path::new("summary.json"), Json.write(report)?.as_bytes())?;
        written.push("summary.json".into());
        stage.publish()?;
        Ok(written)
    }

    /// Into the folder, or into one of its own for each of several models.
    fn comparisons(
        &self,
        models: &[Model],
        measurements: &Measurements,
        comparisons: &[Comparison],
    ) -> Result<Vec<PathBuf>, OutputError> {
        let paths = models.iter().flat_map(Model::paths);
        let reads: Vec<PathBuf> = self.guard.reads.iter().cloned().chain(paths).collect();
        let stage = self.stage("compare", Guard { reads: &reads, ..self.guard })?;
        let mut written = Vec::new();
        for (model, comparison) in models.iter().zip(comparisons) {
            let own = if models.len() > 1 { Path::new(model.stem()) } else { Path::new("") };
            written.extend(self.comparison(model, measurements, comparison, own, &stage)?);
        }
        stage.publish()?;
        Ok(written)
    }

    /// `residuals.csv`; the measured and the predicted shape as `compared.pvd`, where the process has a
    /// body to show; the figures.
    fn comparison(
        &self,
        model: &Model,
        measurements: &Measurements,
        comparison: &Comparison,
        own: &Path,
        stage: &Stage,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let residuals = own.join("residuals.csv");
        stage.write(&residuals, comparison::residuals(measurements, comparison).as_bytes())?;
        let mut written = vec![residuals];
        let places = model.system.places(&measurements.rows);
        if let Some(places) = &places {
            let shapes = comparison::shapes(model.process.observables(), &measurements.rows, places, comparison);
            written.extend(self.animation(&shapes, "view-compared.py", model, own, stage)?);
        }
        written.extend(pictures::stage_all(pictures::of_comparison(model, measurements, comparison), own, stage)?);
        Ok(written)
    }

    /// `NAME.pvd` with true geometry, `NAME-magnified.pvd` as people look at it, their frames in `NAME/`, and the
    /// script that opens the second; in a folder `own` of the stage.
    fn animation(
        &self,
        animation: &Animation,
        script: &str,
        model: &Model,
        own: &Path,
        stage: &Stage,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let file = model.source.name.to_string();
        let series = vtk::Series::new(animation, model.title.as_deref().unwrap_or(&file), &file);
        let (real, magnified) = (animation.name.to_string(), format!("{}-magnified", animation.name));
        self.progress.expect(animation.frames as u64);
        let write = |i: usize| {
            let place = |stem: &str, end: &str| format!("{}/{stem}_{i:04}.{end}", animation.name);
            let paths = [place(&real, "vtu"), place(&magnified, "vtp")];
            let wrong = |error| OutputError::Shape { path: PathBuf::from(&paths[0]), error };
            let frame = series.frame(i).map_err(wrong)?;
            stage.write(&own.join(&paths[0]), &frame.real)?;
            if let Some(bytes) = &frame.magnified {
                stage.write(&own.join(&paths[1]), bytes)?;
            }
            self.progress.advance(1);
            Ok(paths.map(|path| (frame.time, path)))
        };
        let frames: Vec<[(f64, String); 2]> =
            (0..animation.frames).into_par_iter().map(write).collect::<Result<_, OutputError>>()?;
        let mut written = Vec::new();
        let view = series.view();
        for (k, stem) in [real, magnified].iter().enumerate().take(if view.is_some() { 2 } else { 1 }) {
            let path = own.join(format!("{stem}.pvd"));
            let list: Vec<(f64, String)> = frames.iter().map(|frame| frame[k].clone()).collect();
            let text = vtk::pvd(&list).map_err(|error| OutputError::Shape { path: path.clone(), error })?;
            stage.write(&path, text.as_bytes())?;
            written.push(path);
        }
        if let Some(view) = view {
            let path = own.join(script);
            stage.write(&path, view.as_bytes())?;
            written.push(path);
        }
        Ok(written)
    }
}
