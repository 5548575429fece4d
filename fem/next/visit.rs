//! Visits: parts of one job that follow one another on the machine, as a batch of its model with what happened in it.

use std::sync::Arc;

use rayon::prelude::*;

use super::history::{History, Job, Part};
use crate::input::ParameterId;
use crate::knowledge::Knowledge;
use crate::model::{Edit, Entry, Model};
use crate::process::{Command, Failure, Rows, Values};
use crate::units::{Kind, TIME};

/// Fewest parts of a batch: effects of several parts are refused in one of a single part.
const FEWEST: usize = 64;
/// Step of a slope, in standard uncertainties of a value.
const STEP: f64 = 0.3;

/// A visit of a job.
pub struct Visit<'h> {
    /// The job, by position.
    pub job: usize,
    /// Number on the machine of its first part.
    pub first: usize,
    history: &'h History,
    own: &'h Job,
    /// The model of a batch that begins with it, and what is known of its values.
    model: Model,
    knowledge: Knowledge,
}

/// What a visit would show of some rows, and how that changes with each of its values that is known roughly.
pub struct Shown {
    /// Predicted errors, SI.
    pub values: Vec<f64>,
    /// Change of each with each value, per standard uncertainty of that.
    pub slopes: Vec<Vec<f64>>,
}

impl<'h> Visit<'h> {
    /// The visit of the parts from `first` to `last`, and what follows up to `end`.
    ///
    /// # Errors
    /// The batch makes no model.
    pub fn new(history: &'h History, first: &Part, last: usize, end: usize, to_come: &Part) -> Result<Self, Failure> {
        let own = &history.jobs[first.job];
        let local = |part: &Part| part.number - first.number;
        let within = history.parts.iter().filter(|part| part.number > first.number && part.number <= last);
        let is_within = to_come.number > last.max(first.number) && to_come.number <= end;
        let within: Vec<&Part> = within.chain(is_within.then_some(to_come)).collect();
        let after = |part: &Part| ("after".to_string(), Entry::Whole(local(part) as i64));
        let rested = within.iter().filter(|part| part.pause > 0.0);
        let pauses =
            rested.map(|part| vec![after(part), ("duration".to_string(), Entry::Text(exact(&TIME, part.pause)))]);
        let mut insert = first.insert;
        let is_new = |part: &&&Part| std::mem::replace(&mut insert, part.insert) != part.insert;
        let inserts: Vec<_> = within.iter().filter(is_new).map(|part| vec![after(part)]).collect();
        let set = |key: &str, entry| Edit::Set { path: ParameterId::from(format!("batch.{key}").as_str()), entry };
        let mut edits = vec![
            set("parts", Entry::Whole((end - first.number + 1).max(FEWEST) as i64)),
            set("pauses", Entry::Tables(pauses.collect())),
            set("inserts", Entry::Tables(inserts)),
            set("corrections", Entry::Tables(Vec::new())),
        ];
        if own.model.written("batch.log").is_some() {
            edits.push(Edit::Remove { parent: "batch", name: "log".into() });
        }
        let model = own.model.edited(&edits).map_err(|problem| Failure {
            message: format!("{}: {}", own.model.source.name, problem.message),
            help: problem.help.unwrap_or_default(),
        })?;
        let knowledge = Knowledge::of(&model);
        Ok(Self { job: first.job, first: first.number, history, own, model, knowledge })
    }

    /// The model of the batch.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Rows as the batch numbers them.
    pub fn local(&self, rows: &Rows) -> Rows {
        let mut local = rows.clone();
        let column = self.own.number;
        local.columns[column] = local.columns[column].map(|number| number - self.first as f64 + 1.0);
        local
    }

    /// Rows at places of parts, by their numbers on the machine.
    pub fn rows(&self, numbers: &[usize], places: &[f64]) -> Rows {
        let count = numbers.len() * places.len();
        let mut columns = vec![Values::shared(f64::NAN, count); self.model.process.coordinates().len()];
        columns[self.own.commanded.along] = numbers.iter().flat_map(|_| places.iter().copied()).collect();
        columns[self.own.number] = numbers.iter().flat_map(|number| places.iter().map(|_| *number as f64)).collect();
        Rows { columns, observable: Values::shared(self.own.commanded.observable, count) }
    }

    /// What rows would show with the values so many standard uncertainties away, and offsets (m) of parts.
    ///
    /// # Errors
    /// The model cannot be computed.
    pub fn values(&self, rows: &Rows, away: &[f64], offset: impl Fn(usize) -> f64) -> Result<Vec<f64>, Failure> {
        let local = self.local(rows);
        let mut numbers: Vec<usize> = local.columns[self.own.number].iter().map(|n| *n as usize).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let changes = numbers.iter().map(|number| offset(number + self.first - 1)).collect();
        let contours = numbers.iter().map(|number| (vec![*number as f64], vec![0.0]));
        let command = Arc::new(Command::new(contours, None).with(changes));
        self.model.commanded_at(&self.knowledge.away(away), &command)?.observe(&local)
    }

    /// The same as the parts were made, or will be with an offset of those to come, with slopes.
    ///
    /// # Errors
    /// The model cannot be computed.
    pub fn shown(&self, rows: &Rows, away: &[f64], to_come: Option<f64>) -> Result<Shown, Failure> {
        let offset = |number: usize| to_come.unwrap_or_else(|| self.history.part(number).offset);
        let values = self.values(rows, away, offset)?;
        let rough: Vec<usize> = self.knowledge.are_rough().enumerate().filter(|(_, is)| *is).map(|(i, _)| i).collect();
        let slope = |value: &usize| {
            let mut moved = away.to_vec();
            moved[*value] += STEP;
            let own = self.values(rows, &moved, offset)?;
            Ok(own.iter().zip(&values).map(|(own, value)| (own - value) / STEP).collect())
        };
        let slopes = rough.par_iter().map(slope).collect::<Result<_, Failure>>()?;
        Ok(Shown { values, slopes })
    }
}

/// A quantity to the last digit, as a model writes it.
fn exact(kind: &Kind, si: f64) -> String {
    format!("{} {}", kind.from_si(si), kind.unit)
}
