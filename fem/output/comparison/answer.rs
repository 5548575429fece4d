//! Models held against measurements: text, JSON, figures and files.

use std::borrow::Cow;
use std::path::Path;

use serde_json::{Value as Json, json};

use super::asked::Asked;
use super::{drawing, feature, noise, observables, place, residuals, shapes, text};
use crate::compare::Comparison;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::answer::Answer;
use crate::output::block::Block;
use crate::output::chart::{Svg, named};
use crate::output::json::finite;
use crate::output::plots::Judged;
use crate::output::staged::Staged;
use crate::output::{OutputError, measurement, plots};
use crate::process::{Process, range};

/// Models of one process against one file, each with its comparison.
pub struct ComparisonAnswer<'a> {
    /// The process.
    pub process: &'a dyn Process,
    /// The models.
    pub models: &'a [Model],
    /// The measurements as they were read.
    pub measurements: &'a Measurements,
    /// The comparison of each model.
    pub comparisons: &'a [Comparison],
}

impl ComparisonAnswer<'_> {
    /// Every model with its comparison, and the folder for its files: its own where there are several.
    fn each(&self) -> impl Iterator<Item = (&Model, &Comparison, &Path)> {
        let is_one = self.models.len() == 1;
        let each = self.models.iter().zip(self.comparisons);
        each.map(move |(model, found)| (model, found, Path::new(if is_one { "".as_ref() } else { model.stem() })))
    }

    /// How the measured parts stand against the drawing: that of the first model that asks something.
    fn asked(&self) -> Option<Asked> {
        let of = |(model, found): (&Model, &Comparison)| {
            let sigma = range(found.noise.sigma.iter().copied()).1;
            Asked::of(model, self.measurements, (&observed(model, self.measurements), sigma))
        };
        self.models.iter().zip(self.comparisons).find_map(of)
    }
}

impl Answer for ComparisonAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let asked = self.asked().map(|asked| asked.blocks());
        let compared = text::blocks(self.process, self.measurements, self.comparisons);
        compared.into_iter().chain(asked.into_iter().flatten()).collect()
    }

    /// `fem compare --json`: `fem-comparison/1`.
    fn json(&self) -> Json {
        let Self { process, measurements, comparisons, .. } = *self;
        let kind = measurements.kind();
        let first = comparisons.first();
        let noise = first.map(|c| noise(&c.noise.level(measurements), kind));
        let terms = |c: &Comparison| measurement::json(&c.noise.terms, process, Some(measurements));
        let model = |c: &Comparison| {
            json!({
                "model": c.model,
                "rms": kind.from_si(c.rms),
                "bias": kind.from_si(c.bias),
                "unit": kind.unit,
                "worst": {
                    "error": kind.from_si(c.worst_error),
                    "row": measurements.record(c.worst),
                    "line": measurements.line(c.worst),
                    "file": measurements.file_of(c.worst).unwrap_or(&measurements.name),
                    "at": place(process.coordinates(), measurements, c.worst),
                },
                "chi2_per_dof": finite(c.reduced_chi2),
                "p_value": c.p_value,
                "adequate": c.adequacy(),
                "features": c.features.iter().map(feature).collect::<Vec<_>>(),
                "observables": observables(measurements, |s| c.agreement(measurements, s)),
                "measurement": terms(c),
                "cautions": c.cautions,
                "suspects": measurement::json(&c.suspects, process, Some(measurements)),
            })
        };
        let [tolerance, rms_from_middle] = Asked::json(self.asked().as_ref());
        json!({
            "schema": "fem-comparison/1",
            "data": measurements.name,
            "files": measurement::files(measurements),
            "observations": measurements.len(),
            "noise": noise,
            "measurement": first.map(terms),
            "models": comparisons.iter().map(model).collect::<Vec<_>>(),
            "tolerance": tolerance,
            "rms_from_middle": rms_from_middle,
            "notes": measurements.notes,
        })
    }

    fn figures(&self) -> Vec<(String, Svg)> {
        let of_one = |(model, found, own): (&Model, &Comparison, &Path)| {
            let own = own.to_path_buf();
            let measured = observed(model, self.measurements);
            let (rows, judged) = (plots::Rows::of(model, self.measurements), judged(&measured, found));
            let contour =
                drawing(&rows, &judged).map(|drawn| (drawn.name.to_string(), crate::output::drawing::drawing(&drawn)));
            let [measured, agreement] = [plots::measured(&rows, &judged), plots::agreement(&rows, &judged)];
            let [along, maps] = [plots::along(&rows, &judged, None), plots::maps(&rows, &judged, None)];
            let charts = [measured, agreement, along, maps].into_iter().flatten().map(|chart| named(&chart));
            let all: Vec<_> = contour.into_iter().chain(charts).collect();
            all.into_iter().map(move |(name, svg)| (own.join(name).display().to_string(), svg))
        };
        self.each().flat_map(of_one).collect()
    }

    /// Of each model `residuals.csv`; the measured and the predicted shape as `compared.pvd`, where the process has a
    /// body to show; the figures.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        for (model, found, own) in self.each() {
            files.text(own.join("residuals.csv"), &residuals::residuals(self.measurements, found))?;
            let rows = &self.measurements.rows;
            if let Some(places) = model.system.places(rows) {
                let measured = observed(model, self.measurements);
                let shapes = shapes::shapes(model.process.observables(), rows, &places, &judged(&measured, found));
                files.animation(&shapes, "view-compared.py", model, own)?;
            }
        }
        files.figures(self.figures())
    }
}

/// Measured values as a model is compared with them: without its datum directions.
fn observed<'a>(model: &Model, measurements: &'a Measurements) -> Cow<'a, [f64]> {
    let mut observed = Cow::Borrowed(&measurements.observed[..]);
    for direction in model.system.datum_directions(&measurements.rows) {
        direction.take_out(observed.to_mut());
    }
    observed
}

/// Measured values of a model's comparison, and what it says of them.
fn judged<'a>(measured: &'a [f64], found: &'a Comparison) -> Judged<'a> {
    Judged { measured, predicted: &found.predicted, residuals: &found.residuals, noise: &found.noise }
}
