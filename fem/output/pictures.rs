//! The figures of a report as SVG files: with everything else in its folder, or alone.

use std::path::{Path, PathBuf};

use super::chart::{Chart, Svg, draw};
use super::files::{Guard, Stage};
use super::report::{Format, Report};
use super::{OutputError, comparison, diagnosis, drawing, plots, sketch};
use crate::compare::Comparison;
use crate::measure::Measurements;
use crate::model::{Contribution, Model, Run};

/// The figures of a report alone: nothing else is computed or written.
pub struct Pictures<'a> {
    /// Where they appear; made if it is missing.
    pub directory: &'a Path,
    /// Rule by which files there may be replaced.
    pub guard: Guard<'a>,
}

impl Format for Pictures<'_> {
    /// Writes the figures, and lists them.
    fn write(&self, report: &Report) -> Result<String, OutputError> {
        let all = of_report(report);
        let stage = Stage::new(self.directory, "plot", self.guard)?;
        let written = stage_all(all, Path::new(""), &stage)?;
        stage.publish()?;
        let list: Vec<String> = written.iter().map(|f| format!("  {}", self.directory.join(f).display())).collect();
        Ok(format!("\nwritten\n{}\n", list.join("\n")))
    }
}

/// The figures of a report, each with the stem of its file; those of several models in a folder each.
fn of_report(report: &Report) -> Vec<(String, Svg)> {
    match report {
        Report::Run(model, run) => of_run(model, run),
        Report::Comparison(models, measurements, comparisons) => {
            let mut all = Vec::new();
            for (model, comparison) in models.iter().zip(*comparisons) {
                let folder = if models.len() > 1 { format!("{}/", model.stem().display()) } else { String::new() };
                let own = of_comparison(model, measurements, comparison);
                all.extend(own.into_iter().map(|(name, svg)| (format!("{folder}{name}"), svg)));
            }
            all
        }
        Report::Diagnosis(data, found) => vec![("diagnosis".into(), diagnosis::falling(data, found).svg())],
        _ => Vec::new(),
    }
}

/// Writes figures into a folder `own` of one in the making, and names their files.
pub fn stage_all(all: Vec<(String, Svg)>, own: &Path, stage: &Stage) -> Result<Vec<PathBuf>, OutputError> {
    let mut written = Vec::new();
    for (name, svg) in all {
        let path = own.join(format!("{name}.svg"));
        stage.write(&path, svg.file().as_bytes())?;
        written.push(path);
    }
    Ok(written)
}

/// The figures of a run, each with the stem of its file: machine and contours, then curves and maps.
pub fn of_run(model: &Model, run: &Run) -> Vec<(String, Svg)> {
    drawings(run).into_iter().chain(plots::predicted(model, run).iter().map(named)).collect()
}

/// Change by each effect along the curve: the text of an SVG file for each contribution but the ideal system's.
pub fn signatures(model: &Model, contributions: &[Contribution]) -> Vec<String> {
    plots::changes(model, contributions).iter().map(|(_, chart)| draw(chart).file()).collect()
}

/// The figures of a report as texts of SVG files, each with the stem of its name.
pub fn figures(report: &Report) -> Vec<(String, String)> {
    of_report(report).into_iter().map(|(name, svg)| (name, svg.file())).collect()
}

/// The machine to scale, and the contours that it makes.
pub fn drawings(run: &Run) -> Vec<(String, Svg)> {
    let machine = run.report.sketch.iter().map(|s| ("machine".to_string(), sketch::sketch(s)));
    machine.chain(run.report.drawings.iter().map(|d| (d.name.to_string(), drawing::drawing(d)))).collect()
}

/// The figures of a comparison: the contour where one is made, measured rows beside predicted ones, residuals.
pub fn of_comparison(model: &Model, measurements: &Measurements, found: &Comparison) -> Vec<(String, Svg)> {
    let mut all = Vec::new();
    if let (Some(places), Some(nominal)) = (model.system.places(&measurements.rows), model.system.contour()) {
        let rows = model.system.resolved(&measurements.rows);
        let drawn = comparison::drawing(
            nominal,
            model.process.coordinates(),
            &rows,
            &places,
            (&found.predicted, &found.residuals),
        );
        all.push((drawn.name.to_string(), drawing::drawing(&drawn)));
    }
    let rows = plots::Rows {
        model,
        measurements,
        predicted: &found.predicted,
        residuals: &found.residuals,
        noise: &found.noise,
    };
    let charts = [plots::measured(&rows), plots::agreement(&rows), plots::along(&rows, None), plots::maps(&rows, None)];
    all.extend(charts.iter().flatten().map(named));
    all
}

fn named(chart: &Chart) -> (String, Svg) {
    (chart.name.clone(), draw(chart))
}
