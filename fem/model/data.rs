//! The one door by which measurements reach what compares, fits, diagnoses, plans and compensates.

use std::ops::Deref;
use std::path::Path;

use toml_edit::Item;

use super::Model;
use crate::input::{InputError, Problem, Source};
use crate::measure::Measurements;
use crate::noise::{Acts, Size, Term, effects};
use crate::process::{Absent, Coordinate, DatumDirection, Misplaced, Rows};

/// Most misplaced rows that are reported.
const MOST_PROBLEMS: usize = 20;

/// Measurements that belong to a model: every row lies in it, and the datum directions are taken out of the
/// observed values. Reads as [`Measurements`].
#[derive(Clone)]
pub struct Data<'m> {
    /// Model against which the rows were checked.
    pub model: &'m Model,
    /// Datum directions that were taken out of the observed values: the way of measuring is blind to them.
    pub datum_directions: Vec<DatumDirection>,
    /// Effects of the measurement that the model states, with the rows on which they act; a size that is not
    /// a number is unknown.
    pub terms: Vec<Term>,
    measurements: Measurements,
    /// Observed values as they were read, where datum directions were taken out of them.
    as_read: Option<Vec<f64>>,
}

impl<'m> Data<'m> {
    /// Checks every row against the model and takes the datum directions out.
    ///
    /// # Errors
    /// Rows lie off the model's body or beyond its programme; each is named with its line.
    pub fn of(model: &'m Model, measurements: Measurements) -> Result<Self, InputError> {
        let misplaced = model.system.misplaced(&measurements.rows);
        if misplaced.is_empty() {
            let terms =
                resolved(model, &measurements).map_err(|problem| InputError::one(model.source.clone(), problem))?;
            return Ok(Self { terms, ..Self::within(model, measurements) });
        }
        let problem = |m: &Misplaced| {
            Problem::new(format!("{}: {}", measurements.place(m.row), m.message))
                .help("mend the row, or let the model cover it")
        };
        let source = Source::new(measurements.name.clone(), "");
        Err(InputError { source, problems: misplaced.iter().take(MOST_PROBLEMS).map(problem).collect() })
    }

    /// Makes a design of rows that the model itself proposes, which need no check.
    pub(crate) fn proposed(model: &'m Model, name: &str, rows: Rows) -> Self {
        Self::within(model, Measurements::planned(model.process, name, rows))
    }

    /// Makes a design of the model's own programme, thinned to what a person would measure.
    ///
    /// # Errors
    /// The places of the programme follow from what the model does not know.
    pub fn programme(model: &'m Model) -> Result<Self, Problem> {
        /// Most rows of such a design.
        const MOST: usize = 240;
        let all = model.system.programme();
        let is_place = |c: &Coordinate| c.absent == Absent::Refused;
        let places = model.process.coordinates().iter().zip(&all.columns).filter(|(c, _)| is_place(c));
        if let Some((c, _)) = places.into_iter().find(|(_, values)| values.iter().any(|v| !v.is_finite())) {
            let problem = Problem::new(format!("where the model's own programme looks along {} is unknown", c.name));
            return Err(problem.help("give the length that is `?` a value, or name the rows: --with FILE.csv"));
        }
        let step = all.len().div_ceil(MOST).max(1);
        // A step that has no common factor with the length of a pass visits every place.
        let step = (step..).find(|s| !all.len().is_multiple_of(*s) || *s == 1).unwrap_or(step);
        let take = |column: &Vec<f64>| column.iter().copied().step_by(step).collect();
        let rows = Rows {
            columns: all.columns.iter().map(take).collect(),
            observable: all.observable.iter().copied().step_by(step).collect(),
        };
        Ok(Self::proposed(model, "the model's own programme", rows))
    }

    /// Prepares rows that lie in the model.
    fn within(model: &'m Model, mut measurements: Measurements) -> Self {
        let datum_directions = model.system.datum_directions(&measurements.rows);
        let as_read = (!datum_directions.is_empty()).then(|| measurements.observed.clone());
        datum_directions.iter().for_each(|direction| direction.take_out(&mut measurements.observed));
        Self { model, datum_directions, terms: Vec::new(), measurements, as_read }
    }

    /// Selects the rows whose numbers `keep` accepts. Their datum directions are others, and are taken out
    /// anew.
    #[must_use]
    pub fn some(&self, keep: impl Fn(usize) -> bool) -> Self {
        let mut some = self.measurements.some(&keep);
        if let Some(observed) = &self.as_read {
            some.observed = (0..self.len()).filter(|row| keep(*row)).map(|row| observed[row]).collect();
        }
        let mut numbers = (0..self.len()).filter(|row| keep(*row)).enumerate().map(|(new, old)| (old, new));
        let numbers: std::collections::BTreeMap<usize, usize> = numbers.by_ref().collect();
        let of = |term: &Term| {
            let rows = match term.effect.acts {
                // The first row of a step is the next one that stays.
                Acts::Shared(_) => term.rows.iter().filter_map(|r| numbers.range(r..).next().map(|n| *n.1)).collect(),
                _ => term.rows.iter().filter_map(|r| numbers.get(r).copied()).collect(),
            };
            Term { rows, ..term.clone() }
        };
        Self { terms: self.terms.iter().map(of).collect(), ..Self::within(self.model, some) }
    }

    /// Gives the measurements back as they were read, for another model.
    pub fn into_measurements(self) -> Measurements {
        let Self { mut measurements, as_read, .. } = self;
        if let Some(observed) = as_read {
            measurements.observed = observed;
        }
        measurements
    }

    /// Degrees of freedom: observations less datum directions.
    pub fn freedom(&self) -> f64 {
        (self.len() - self.datum_directions.len()) as f64
    }

    /// Whether the model was fitted to these very rows, as its comments say.
    pub fn was_fitted_before(&self) -> bool {
        let mark = self.mark();
        self.model.source.text.lines().any(|line| line.starts_with('#') && line.contains(&mark))
    }

    /// Notes of the file, with a caution where a fit would count the rows twice.
    pub fn notes_of_fit(&self) -> Vec<String> {
        let twice = self.was_fitted_before().then(|| {
            "the model's values were fitted to these very rows: as prior knowledge they count them twice, and \
             intervals come out too narrow; fit the model from before"
                .to_string()
        });
        self.notes.iter().cloned().chain(twice).collect()
    }

    /// Mark by which the comment of a fitted model tells these rows from others.
    pub fn mark(&self) -> String {
        let digest = Measurements::digest(self.as_read.as_ref().unwrap_or(&self.observed));
        format!("{} rows, mark {digest:016x}", self.len())
    }
}

/// The effects of a model with the rows of a file in the place of its records.
///
/// # Errors
/// A record that the file does not have, or an effect that could act on any of several observables.
fn resolved(model: &Model, measurements: &Measurements) -> Result<Vec<Term>, Problem> {
    let is_in_file = |o: usize| measurements.observables.iter().any(|s| s.position == o);
    let several = measurements.observables.len() > 1;
    let acting = model.measurement.iter().filter(|term| term.observable.is_none_or(is_in_file));
    let resolve = |term: &Term| {
        let name = term.effect.name;
        let place = model.document.get("measurement").and_then(|m| m.get(name)).and_then(Item::span);
        if several && term.observable.is_none() && matches!(term.effect.size, Size::OfObservable(..)) {
            let names: Vec<&str> = measurements.observables.iter().map(|s| s.name).collect();
            let problem = Problem::new(format!("`measurement.{name}` does not say on which observable it acts"));
            let listed = format!("{} has {}", measurements.name, names.join(" and "));
            return Err(problem.help(format!("{listed}: add observable = \"{}\"", names[0])).at(place));
        }
        let file = file(term, measurements).map_err(|problem| problem.at(place.clone()))?;
        let before = file.map_or(0, |number| measurements.files[number].first_record);
        let mut rows = Vec::new();
        for record in &term.rows {
            let is_first = *term.effect == effects::JUMP;
            let is_meant = |row: &usize| {
                let own = measurements.records_of[*row] + 1;
                let is_there = file.is_none_or(|number| measurements.file_number(*row) == number);
                let at = before + record;
                is_there && term.is_of(measurements, *row) && if is_first { own >= at } else { own == at }
            };
            let own: Vec<usize> = (0..measurements.len()).filter(is_meant).collect();
            if own.is_empty() {
                let problem = Problem::new(format!("`measurement.{name}` names row {record}"));
                let of = file.map_or(&measurements.name, |number| &measurements.files[number].name);
                return Err(problem.help(format!("{of} has no such row")).at(place));
            }
            rows.extend(own.into_iter().take(if is_first { 1 } else { usize::MAX }));
        }
        // Of the only observable nothing need be said.
        Ok(Term { rows, file: None, observable: term.observable.filter(|_| several), ..term.clone() })
    };
    acting.map(resolve).collect()
}

/// The number of the file whose rows a term counts; `None` where it counts them through all files.
///
/// # Errors
/// No file has that name.
fn file(term: &Term, measurements: &Measurements) -> Result<Option<usize>, Problem> {
    let Some(name) = &term.file else { return Ok(None) };
    // The file may have been named from another folder.
    let is_named = |file: &str| file == name || Path::new(file).file_name().is_some_and(|own| own == name.as_str());
    let mut meant = (0..measurements.files.len()).filter(|number| is_named(&measurements.files[*number].name));
    match (meant.next(), meant.next()) {
        (Some(number), None) => Ok(Some(number)),
        (found, _) => {
            let none = if found.is_some() { "several files have this name" } else { "no file has this name" };
            let problem = Problem::new(format!("`measurement.{}` counts rows of {name}: {none}", term.effect.name));
            let files: Vec<&str> = measurements.files.iter().map(|file| &*file.name).collect();
            Err(problem.help(format!("the measurements are {}", files.join(", "))))
        }
    }
}

impl Deref for Data<'_> {
    type Target = Measurements;

    fn deref(&self) -> &Measurements {
        &self.measurements
    }
}
