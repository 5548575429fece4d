//! What is open: a model, measurements, and what they say of each other. What was before a step is kept as it was.

use std::collections::BTreeSet;
use std::sync::Arc;

use serde_json::Value as Json;

use super::refusal::Refusal;
use crate::ask::compare_all;
use crate::correct::Action;
use crate::input::Name;
use crate::measure::{Measurements, Reading};
use crate::model::{Data, Model};
use crate::output::{Addition, ComparisonAnswer, fragment, machine_fragment, quoted, residuals, standing_lines};
use crate::process::Values;
use crate::progress::Progress;

/// All that a step may change.
#[derive(Clone, Default)]
pub struct Bench {
    /// The model, if one is open.
    pub model: Option<Model>,
    /// Its file.
    pub file: String,
    /// The file that the model would stand in, had all been done by commands.
    pub by_commands: String,
    /// Files of measurements.
    pub files: Vec<String>,
    /// How they are to be read.
    pub reading: Reading,
    /// All of their rows.
    pub measured: Option<Arc<Measurements>>,
    /// Rows that somebody has struck out, from 0.
    pub struck: BTreeSet<usize>,
    /// The value of each row from which it is shown, SI: the set diameter. None where all are shown as they are.
    pub references: Option<Arc<Vec<f64>>>,
    /// What the model draws, and how its parts stand against the drawing.
    pub drawn: String,
    pub standing: Vec<String>,
    /// The model against the measurements; why not, where it is not.
    pub compared: Option<Result<Arc<Compared>, Refusal>>,
    /// What was left with each model so far.
    pub steps: Vec<(String, f64)>,
    /// The last diagnosis.
    pub diagnosed: Option<Arc<Diagnosed>>,
    /// The last correction.
    pub corrected: Option<Arc<Corrected>>,
    /// What the shop should change, when that was asked last.
    pub remedied: Option<Arc<Remedied>>,
}

/// A comparison. SI but for `rms` and `noise`.
pub struct Compared {
    pub rms: f64,
    pub unit: String,
    pub reduced_chi2: f64,
    pub noise: f64,
    pub is_adequate: bool,
    pub html: String,
    /// The prediction of the rows that are not struck out.
    pub predicted: Vec<f64>,
    pub sigma: Values,
    /// The rows as a table, with what is left of each.
    pub csv: String,
}

/// A diagnosis of some model.
pub struct Diagnosed {
    /// Text of the model.
    pub of: String,
    /// What it says, in a sentence.
    pub verdict: String,
    pub json: Json,
    pub html: String,
    pub next: Option<(String, String)>,
    pub additions: Vec<Addition>,
    /// Groups of effects that stand for each other: what is said of each, and its members.
    pub groups: Vec<(String, Vec<Name>)>,
}

/// A correction of some model.
pub struct Corrected {
    /// Text of the model.
    pub of: String,
    pub html: String,
    /// The model itself and what to do about it, and the command that says the same.
    pub model: Model,
    pub action: Action,
    pub command: String,
}

/// What a shop should change, by some model.
pub struct Remedied {
    /// Text of the model.
    pub of: String,
    pub html: String,
}

impl Bench {
    /// The rows that count, as a model's own.
    pub fn counted(&self) -> Option<Measurements> {
        let all = self.measured.as_ref()?;
        Some(match self.struck.is_empty() {
            true => (**all).clone(),
            false => all.some(|row| !self.struck.contains(&row)),
        })
    }

    /// Holds the model against the measurements, after something has changed.
    pub fn compare(&mut self) {
        self.compared = self.comparison();
        let rows = self.model.as_ref().zip(self.measured.as_ref());
        let references = rows.and_then(|(model, all)| model.system.references(&model.system.resolved(&all.rows)));
        self.references = references.map(Arc::new);
        let run = self.model.as_ref().filter(|model| model.require_part().is_ok());
        let run = run.and_then(|model| model.run(&Progress::default()).ok());
        self.standing = run.as_ref().map_or(Vec::new(), |run| standing_lines(&run.standings));
        self.drawn = run.map_or(String::new(), |run| machine_fragment(&run));
    }

    /// The options by which a command is given the measurements.
    pub fn with(&self) -> String {
        let files = self.files.iter().flat_map(|name| ["--with".to_string(), name.clone()]);
        let words: Vec<String> = files.chain(self.reading.options()).map(|word| quoted(&word)).collect();
        words.join(" ")
    }

    fn comparison(&self) -> Option<Result<Arc<Compared>, Refusal>> {
        let (model, measured) = (self.model.as_ref()?, self.counted()?);
        let progress = Arc::new(Progress::default());
        let found = compare_all(std::slice::from_ref(model), measured, &progress, |data, found| {
            let kind = data.kind();
            let answer = ComparisonAnswer {
                process: &*model.process,
                models: std::slice::from_ref(model),
                measurements: data,
                comparisons: std::slice::from_ref(&found),
            };
            Compared {
                rms: kind.from_si(found.rms),
                unit: kind.unit.to_string(),
                reduced_chi2: found.reduced_chi2,
                noise: kind.from_si(found.noise.level(data).together()),
                is_adequate: found.adequate(),
                html: fragment(&answer),
                csv: residuals(data, &found),
                sigma: found.noise.sigma.clone(),
                predicted: found.predicted,
            }
        });
        Some(found.map_err(Refusal::from).map(|(mut all, _)| Arc::new(all.remove(0))))
    }

    /// Notes what is left with the model as it now is.
    pub fn note(&mut self, label: String) {
        if let Some(Ok(found)) = &self.compared {
            self.steps.push((label, found.rms));
        }
    }

    /// The rows that count, held against the model.
    pub fn data<'m>(model: &'m Model, measured: Measurements, progress: &Arc<Progress>) -> Result<Data<'m>, Refusal> {
        Ok(Data::of(model, measured)?.watched(progress.clone()))
    }
}
