//! The model at which a diagnosis of a whole machine arrives, with the machine itself, to be made again.

use fem::diagnose::Verdict;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::process::Rows;
use fem::progress::Progress;
use generator::{Process, Whole};

use crate::score;

/// A machine, what was measured of it, and the model that a diagnosis completes.
pub struct Arrived {
    pub whole: Whole,
    pub model: Model,
    /// Rows that were measured.
    pub rows: Rows,
    /// Whether the diagnosis leaves nothing.
    pub is_adequate: bool,
}

impl Arrived {
    /// At the machine of a seed; `None` where the diagnosis leaves a value unknown.
    pub fn at(process: &Process, seed: u64) -> Option<Self> {
        let whole = process.whole_machine(seed);
        let model = parsed(&whole.case.model);
        let read = Measurements::parse(Source::new("case.csv", whole.case.data.clone()), &*model.process);
        let data = Data::of(&model, read.expect("so are the data")).expect("every row lies in the model");
        let diagnosis = score::diagnose(&data, 6, &Progress::default()).ok()?;
        let better = fem::ask::completed(&data, &diagnosis).ok()?;
        better.require_part().ok()?;
        let is_adequate = diagnosis.verdict_after == Verdict::Adequate;
        Some(Self { whole, rows: data.rows.clone(), model: better, is_adequate })
    }
}

/// A model of the generator.
pub fn parsed(text: &str) -> Model {
    Model::parse(Source::new("case.toml", text.to_string())).expect("the model is right")
}

/// Name of a process; lathes have none before their seeds.
pub fn named(process: &Process) -> &str {
    if process.name.is_empty() { "turning" } else { process.name.trim() }
}
