//! The history of a machine: its jobs, the parts that it made, and what was measured on them.

use std::collections::BTreeMap;

use crate::input::{InputError, Problem, Source};
use crate::measure::Measurements;
use crate::model::Model;
use crate::process::{Commanded, Failure, Rows, Values};

/// The history of a machine, as its log tells it.
#[derive(Clone)]
pub struct History {
    /// Name and text of the log.
    pub source: Source,
    /// The key `title`, if the log has it.
    pub title: Option<String>,
    /// What is made on the machine; there is at least one job.
    pub jobs: Vec<Job>,
    /// Parts at which something changed or was written down, by rising numbers.
    pub parts: Vec<Part>,
    /// What was measured, job by job in the order of the log.
    pub measured: Vec<Measured>,
    /// What was advised last, for parts that come after all of `parts`.
    pub advised: Option<Part>,
}

/// Something that is made on the machine.
#[derive(Clone)]
pub struct Job {
    /// Its name in the log; empty where there is one job alone.
    pub name: String,
    /// What is known of it.
    pub model: Model,
    /// How its command is corrected.
    pub commanded: Commanded,
    /// The coordinate that numbers its parts, by its position.
    pub number: usize,
}

/// A part of the machine, and how it was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its number on the machine, from 1.
    pub number: usize,
    /// Its job, by position.
    pub job: usize,
    /// What was added to the programmed radius, m.
    pub offset: f64,
    /// Number of the insert that cut it, from 1.
    pub insert: usize,
    /// Number of the set-up, from 1: the tool was measured or touched anew between two.
    pub set_up: usize,
    /// How long the machine rested before it, s.
    pub pause: f64,
}

/// Readings of one job.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The job, by position.
    pub job: usize,
    /// Where each was taken; the number of a part is that on the machine.
    pub rows: Rows,
    /// The error of each, SI.
    pub errors: Vec<f64>,
    /// Its standard uncertainty, SI; NaN where nobody says.
    pub uncertainty: Vec<f64>,
}

impl Job {
    /// A job of a model, whose values may be known roughly, but not unknown.
    ///
    /// # Errors
    /// A value is unknown, or the process has no command that is corrected, or parts do not follow one another in it.
    pub fn new(name: String, model: Model) -> Result<Self, InputError> {
        model.require_part()?;
        let refuse =
            |message: String, help: &str| InputError::one(model.source.clone(), Problem::new(message).help(help));
        // Runs of an axis and parts of a fixture have no offset that is entered between them.
        let commanded = model.system.commanded().filter(Commanded::is_tool_offset);
        let Some((commanded, number)) = commanded.and_then(|own| Some((own, own.number?))) else {
            let message = format!("{} models {}", model.source.name, model.process.about());
            return Err(refuse(message, "the next part is known of turned contours, which are corrected by an offset"));
        };
        if model.written("batch.cycle_time").is_none() {
            let message = format!("{} does not say how parts follow one another", model.source.name);
            return Err(refuse(
                message,
                "add [batch] with cycle_time = \"6 min\", from the start of one part to the next",
            ));
        }
        Ok(Self { name, model, commanded, number })
    }

    /// Readings of the job, as errors of its diameter.
    ///
    /// # Errors
    /// Rows lie off the work, or are of nothing that the command corrects.
    pub fn readings(&self, job: usize, measurements: &Measurements) -> Result<Measured, InputError> {
        let refuse = |problems| InputError::new(Source::new(measurements.name.clone(), ""), problems);
        let system = &self.model.system;
        let mut rows = measurements.rows.clone();
        // Columns that nobody's law asks for have no place in the model.
        rows.columns.truncate(self.model.process.coordinates().len());
        let numbers = rows.columns[self.number].clone();
        rows.columns[self.number].fill(1.0);
        let misplaced = system.misplaced(&rows);
        if !misplaced.is_empty() {
            let problem = |row: usize, message: &str| {
                Problem::new(format!("{}: {message}", measurements.place(row))).help("mend the row")
            };
            return Err(refuse(misplaced.iter().map(|m| problem(m.row, &m.message)).collect()));
        }
        let mut as_errors = rows.clone();
        as_errors.observable = Values::shared(self.commanded.observable, rows.len());
        // What a whole diameter is more than its error, no law changes.
        let ideal = system.with_effects(&[]);
        let failed = |failure: Failure| refuse(vec![Problem::new(failure.message).help(failure.help)]);
        let (whole, error) = (ideal.observe(&rows).map_err(failed)?, ideal.observe(&as_errors).map_err(failed)?);
        let errors =
            measurements.observed.iter().zip(whole.iter().zip(&error)).map(|(y, (w, e))| y - (w - e)).collect();
        let uncertainty = match &measurements.uncertainty {
            Some(own) => own.to_vec(),
            None => vec![f64::NAN; rows.len()],
        };
        as_errors.columns[self.number] = numbers;
        Ok(Measured { job, rows: as_errors, errors, uncertainty })
    }
}

impl Measured {
    /// Number of the part of a row, by the column that numbers parts.
    pub fn number(&self, column: usize, row: usize) -> usize {
        self.rows.columns[column][row] as usize
    }

    /// A reading as a text by which it is recognised, whatever unit it is written in.
    pub fn mark(&self, row: usize) -> String {
        let columns = self.rows.columns.iter().map(|column| column[row]);
        columns.chain([self.errors[row]]).map(|value| format!("{value:.7e} ")).collect()
    }

    /// Those of these readings, in this order.
    #[must_use]
    pub fn some(&self, rows: &[usize]) -> Self {
        let of = |all: &[f64]| rows.iter().map(|row| all[*row]).collect();
        Self { job: self.job, rows: self.rows.some(rows), errors: of(&self.errors), uncertainty: of(&self.uncertainty) }
    }
}

impl History {
    /// How a part was made, or will be where nothing else is said: as the one before it, without another pause.
    pub fn part(&self, number: usize) -> Part {
        let first = Part { number, job: 0, offset: 0.0, insert: 1, set_up: 1, pause: 0.0 };
        let last = self.parts.iter().rfind(|part| part.number <= number);
        let advised =
            self.advised.as_ref().filter(|own| own.number <= number && last.is_none_or(|l| own.number > l.number));
        match advised.or(last) {
            Some(own) if own.number == number => own.clone(),
            Some(own) => Part { number, pause: 0.0, ..own.clone() },
            None => first,
        }
    }

    /// The greatest number of a part that was made, 0 where there is none.
    pub fn last(&self) -> usize {
        let written = self.parts.last().map_or(0, |part| part.number);
        self.numbers().next_back().map_or(written, |(number, _)| written.max(number))
    }

    /// Numbers of the parts that were measured, rising, each with its readings: of which entry, and which row.
    pub fn numbers(&self) -> impl DoubleEndedIterator<Item = (usize, Vec<(usize, usize)>)> + use<> {
        let mut all: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
        for (entry, measured) in self.measured.iter().enumerate() {
            let column = self.jobs[measured.job].number;
            for row in 0..measured.errors.len() {
                all.entry(measured.number(column, row)).or_default().push((entry, row));
            }
        }
        all.into_iter()
    }

    /// Adds parts that were made and readings of them that are not known yet. Parts beyond all that is written are made as was
    /// advised, or with the offset that was `applied`. Tells the parts and the rows that are new.
    pub fn add(&mut self, measured: Measured, applied: Option<f64>) -> (Vec<Part>, Vec<usize>) {
        let column = self.jobs[measured.job].number;
        let mut known: BTreeMap<String, usize> = BTreeMap::new();
        for own in self.measured.iter().filter(|own| own.job == measured.job) {
            (0..own.errors.len()).for_each(|row| *known.entry(own.mark(row)).or_default() += 1);
        }
        let is_new = |row: &usize| match known.get_mut(&measured.mark(*row)) {
            Some(count) if *count > 0 => {
                *count -= 1;
                false
            }
            _ => true,
        };
        let rows: Vec<usize> = (0..measured.errors.len()).filter(is_new).collect();
        let mut numbers: Vec<usize> = rows.iter().map(|row| measured.number(column, *row)).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let last = self.last();
        // Where something was to change that was not measured, it is written down as well.
        let planned =
            self.advised.as_ref().map(|own| own.number).filter(|own| numbers.last().is_some_and(|last| own < last));
        let mut new: Vec<usize> = numbers.into_iter().chain(planned).filter(|number| *number > last).collect();
        new.sort_unstable();
        new.dedup();
        let made = |number: &usize| {
            let own = self.part(*number);
            Part { job: measured.job, offset: applied.unwrap_or(own.offset), ..own }
        };
        let parts: Vec<Part> = new.iter().map(made).collect();
        self.parts.extend(parts.iter().cloned());
        if !rows.is_empty() {
            self.measured.push(measured.some(&rows));
        }
        (parts, rows)
    }
}
