//! A plan: a model, what varies in it, what is done at every point, and what is wanted of it.

use std::path::PathBuf;

use sha2::{Digest, Sha256};

use super::design::{Design, Input, Points, Sampler, Spread};
use super::layout::{Layout, Nature, ResultColumn};
use crate::input::Source;
use crate::model::Model;
use crate::units::Kind;

/// Command that is run at every point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// `fem run`.
    Run,
    /// `fem fit`.
    Fit,
    /// `fem diagnose`.
    Diagnose,
}

impl Task {
    /// Words in a plan.
    pub const WORDS: &[(&'static str, Self)] = &[("run", Self::Run), ("fit", Self::Fit), ("diagnose", Self::Diagnose)];

    /// Word in a plan.
    pub fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(_, task)| *task == self).map_or("", |(word, _)| word)
    }
}

/// A result that a job can give.
#[derive(Clone, Debug, PartialEq)]
pub struct Offered {
    /// Name: `largest.value`, `effects.tool-wear.rate`, `verdict`.
    pub name: String,
    /// Kind of a quantity, in whose unit it is told.
    pub kind: Option<Kind>,
    /// Whether it is a word.
    pub is_word: bool,
}

/// A result that is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// The result.
    pub offered: Offered,
    /// Smallest and largest value that is accepted, SI.
    pub tolerance: Option<(f64, f64)>,
}

/// A plan that was read without a problem.
#[non_exhaustive]
pub struct StudyPlan {
    /// Name and text of the file.
    pub file: Source,
    /// The key `title`, if the file has it.
    pub title: Option<String>,
    /// The model.
    pub model: Model,
    /// Command that is run at every point.
    #[doc(hidden)]
    pub task: Task,
    /// Files of measurements.
    pub data: Vec<PathBuf>,
    /// The file of each point of a table, by its position; empty where every file is looked at at all points.
    pub data_of_point: Vec<usize>,
    /// File and text of the table that names the points, if one does.
    pub table: Option<Source>,
    /// Quantities that vary.
    #[doc(hidden)]
    pub inputs: Vec<Input>,
    /// Design by which they vary.
    #[doc(hidden)]
    pub design: Design,
    /// The points.
    #[doc(hidden)]
    pub points: Points,
    /// Results that are wanted of every job.
    #[doc(hidden)]
    pub results: Vec<Wanted>,
}

impl StudyPlan {
    /// Number of jobs.
    pub fn jobs(&self) -> u64 {
        let files = if self.data_of_point.is_empty() { self.data.len().max(1) } else { 1 };
        self.points.count().saturating_mul(files as u64)
    }

    /// Values of the inputs (in their units) and file of job number `number`, from 0.
    pub fn point(&self, number: u64) -> (Vec<f64>, Option<&PathBuf>) {
        let (round, point) = (number / self.points.count(), number % self.points.count());
        let file = self.data_of_point.get(point as usize).copied().unwrap_or(round as usize);
        (self.points.at(point), self.data.get(file))
    }

    /// All files that it reads.
    pub fn paths(&self) -> Vec<PathBuf> {
        let own = [Some(&self.file), self.table.as_ref()].into_iter().flatten().map(|f| PathBuf::from(&*f.name));
        own.chain(self.model.paths()).chain(self.data.iter().cloned()).collect()
    }

    /// Layout of its rows.
    #[doc(hidden)]
    pub fn layout(&self) -> Layout {
        let column = |wanted: &Wanted| {
            let kind = wanted.offered.kind;
            let told = |si: f64| kind.map_or(si, |kind| kind.from_si(si));
            ResultColumn {
                name: wanted.offered.name.clone(),
                unit: kind.map(|kind| kind.unit).unwrap_or_default().into(),
                is_word: wanted.offered.is_word,
                tolerance: wanted.tolerance.map(|(low, high)| (told(low), told(high))),
            }
        };
        let nature = match self.design {
            Design::Drawn { sampler: Sampler::Random, .. } => Nature::Independent,
            Design::Drawn { .. } => Nature::Even,
            Design::Grid | Design::Table { .. } => Nature::Listed,
        };
        Layout {
            facts: self.facts(),
            title: self.title.clone(),
            plan: self.file.name.to_string(),
            task: self.task.word().into(),
            design: self.design.word().into(),
            jobs: self.jobs(),
            group: self.points.group(),
            nature,
            inputs: self.inputs.iter().map(|i| (i.path.to_string(), i.kind.unit.into())).collect(),
            has_data: !self.data.is_empty(),
            results: self.results.iter().map(column).collect(),
        }
    }

    /// Everything on which rows depend.
    fn facts(&self) -> Vec<(String, String)> {
        let mut facts = vec![
            ("the version of fem".to_string(), env!("CARGO_PKG_VERSION").to_string()),
            ("`task`".into(), self.task.word().into()),
            ("`type` of the design".into(), self.design.word().into()),
        ];
        if let Design::Drawn { samples, seed, indices, .. } = self.design {
            let told = [("samples", samples.to_string()), ("seed", seed.to_string()), ("indices", indices.to_string())];
            facts.extend(told.map(|(key, value)| (format!("`{key}`"), value)));
        }
        let name = |path: &PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        for path in self.model.paths().iter().chain(&self.data) {
            facts.push((format!("the content of {}", name(path)), digest(&std::fs::read(path).unwrap_or_default())));
        }
        if let Some(table) = &self.table {
            facts.push(("the content of the table".into(), digest(table.text.as_bytes())));
        }
        for input in &self.inputs {
            let told = |si: &f64| format!("{:?}", input.rounded(*si));
            let spread = match &input.spread {
                Spread::Field { law, centre, half } => {
                    format!("{} {} by {half:?}, lambda {:?}", law.word(), told(centre), law.lambda())
                }
                Spread::List(values) => values.iter().map(told).collect::<Vec<_>>().join(", "),
                Spread::Table => "as the table says".into(),
            };
            facts.push((format!("the input {}", input.path), spread));
        }
        let names: Vec<&str> = self.results.iter().map(|wanted| wanted.offered.name.as_str()).collect();
        facts.push(("the list of results".into(), names.join(", ")));
        facts
    }
}

/// SHA-256 of a content, shortened: what changes by accident or on purpose changes it.
fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes)[..8].iter().map(|byte| format!("{byte:02x}")).collect()
}
