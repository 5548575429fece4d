//! The effects of the measurement that a model states, put on the rows of a file.

use std::ops::Range;
use std::path::Path;

use super::Model;
use crate::input::Problem;
use crate::measure::{Measurements, step_of};
use crate::noise::{Acts, FROM, MEASUREMENT, Size, Term, caution};

impl Model {
    /// Whether the size of an effect of the measurement is left to be estimated from every file.
    #[doc(hidden)]
    pub fn is_unknown(&self, term: &Term) -> bool {
        let is_own = |t: &&Term| t.table == term.table && t.effect.size == term.effect.size;
        let own = self.measurement.iter().find(is_own);
        let is_size = term.effect.acts.is_estimated() || matches!(term.effect.acts, Acts::Rounds);
        is_size && own.is_some_and(|t| t.size.is_nan())
    }
}

/// The effects of a model with the rows of a file in the place of its records; `observed` are the values as
/// they were read.
///
/// # Errors
/// A record that the file does not have, an effect that could act on any of several observables, a covariance
/// of other rows, a step that the values do not show.
pub fn resolved(model: &Model, measurements: &Measurements, observed: &[f64]) -> Result<Vec<Term>, Vec<Problem>> {
    let all = model.measurement.iter().filter(|term| is_in_file(term, measurements));
    let (terms, problems): (Vec<_>, Vec<_>) =
        all.map(|t| resolve(model, t, measurements, observed)).partition(Result::is_ok);
    let problems: Vec<Problem> = problems.into_iter().filter_map(Result::err).collect();
    if problems.is_empty() { Ok(terms.into_iter().flatten().collect()) } else { Err(problems) }
}

/// The observable on which a term acts: that which it names, or the only one of the file that has the unit of its size.
fn meant(term: &Term, measurements: &Measurements) -> Option<usize> {
    let mut of_unit = measurements.observables.iter().map(|s| s.position).filter(|own| term.among.contains(own));
    term.observable.or(match (of_unit.next(), of_unit.next()) {
        (Some(only), None) => Some(only),
        _ => None,
    })
}

fn is_in_file(term: &Term, measurements: &Measurements) -> bool {
    let has = |own: usize| measurements.observables.iter().any(|s| s.position == own);
    match term.observable {
        Some(own) => has(own),
        None => term.among.is_empty() || term.among.iter().any(|own| has(*own)),
    }
}

/// The place of a term's table.
fn place(model: &Model, table: &str) -> Option<Range<usize>> {
    model.tables.now().get(MEASUREMENT)?.get(table)?.span()
}

fn resolve(model: &Model, term: &Term, measurements: &Measurements, observed: &[f64]) -> Result<Term, Problem> {
    let term = &Term { observable: meant(term, measurements), ..term.clone() };
    let (name, file) = (format!("measurement.{}", term.table), &measurements.name);
    let several = measurements.observables.len() > 1;
    let is_of_one = matches!(term.effect.size, Size::OfObservable(..)) || matches!(term.effect.acts, Acts::Shows(_));
    let refuse = |message: String, help: String| Problem::new(message).help(help).at(place(model, &term.table));
    if several && term.observable.is_none() && is_of_one {
        let names: Vec<&str> = measurements.observables.iter().map(|s| &*s.name).collect();
        let help = format!("{file} has {}: add observable = \"{}\"", names.join(" and "), names[0]);
        return Err(refuse(format!("`{name}` does not say on which observable it acts"), help));
    }
    if let Some(given) = &term.covariance {
        let rows = measurements.len();
        if several || given.rows() != rows {
            let found = format!("`{name}` has the covariance of {} rows, and {file} has {rows}", given.rows());
            return Err(refuse(found, "give it one row and one column for each row, of one observable".into()));
        }
        if let Some(other) = model.measurement.iter().find(|t| matches!(t.effect.acts, Acts::Neighbours)) {
            let help = "leave one of the tables out".into();
            let both = format!("`{name}` and `measurement.{}` both say what rows share", other.table);
            return Err(refuse(both, help));
        }
    }
    let counted = file_of(term, measurements).map_err(|problem| problem.at(place(model, &term.table)))?;
    let rows = rows_of(term, measurements, counted).map_err(|record| {
        let of = counted.map_or(file, |number| &measurements.files[number].name);
        refuse(format!("`{name}` names row {record}"), format!("{of} has no such row"))
    })?;
    let mut size = term.size;
    if matches!(term.effect.acts, Acts::Rounds) && size.is_nan() && !measurements.is_planned() {
        let number = measurements.observables.iter().position(|s| term.observable.is_none_or(|own| own == s.position));
        size = number.and_then(|number| step_of(measurements, observed, number)).ok_or_else(|| {
            let help = "say what the step of the instrument is: step = \"1 um\"".into();
            refuse(format!("`{name}`: the values of {file} lie on no grid that tells the step"), help)
        })?;
    }
    // Of the only observable nothing need be said.
    Ok(Term { rows, size, file: None, observable: term.observable.filter(|_| several), ..term.clone() })
}

/// The number of the file whose rows a term counts; `None` where it counts them through all files.
///
/// # Errors
/// No file has that name.
fn file_of(term: &Term, measurements: &Measurements) -> Result<Option<usize>, Problem> {
    let Some(name) = &term.file else { return Ok(None) };
    // The file may have been named from another folder.
    let is_named = |file: &str| file == name || Path::new(file).file_name().is_some_and(|own| own == name.as_str());
    let mut meant = (0..measurements.files.len()).filter(|number| is_named(&measurements.files[*number].name));
    match (meant.next(), meant.next()) {
        (Some(number), None) => Ok(Some(number)),
        (found, _) => {
            let none = if found.is_some() { "several files have this name" } else { "no file has this name" };
            let problem = Problem::new(format!("`measurement.{}` counts rows of {name}: {none}", term.table));
            let files: Vec<&str> = measurements.files.iter().map(|file| &*file.name).collect();
            Err(problem.help(format!("the measurements are {}", files.join(", "))))
        }
    }
}

/// The rows of the records that a term names, counted in one file or through all of them; of a step the
/// first.
///
/// # Errors
/// The record that the file does not have.
fn rows_of(term: &Term, measurements: &Measurements, counted: Option<usize>) -> Result<Vec<usize>, usize> {
    let before = counted.map_or(0, |number| measurements.files[number].first_record);
    let mut rows = Vec::new();
    for record in &term.rows {
        let is_first = term.effect.has(FROM);
        let is_meant = |row: &usize| {
            let own = measurements.record(*row);
            let is_there = counted.is_none_or(|number| measurements.file_number(*row) == number);
            let at = before + record;
            is_there && term.is_of(measurements, *row) && if is_first { own >= at } else { own == at }
        };
        let own: Vec<usize> = (0..measurements.len()).filter(is_meant).collect();
        if own.is_empty() {
            return Err(*record);
        }
        rows.extend(own.into_iter().take(if is_first { 1 } else { usize::MAX }));
    }
    Ok(rows)
}

/// The effects of a model that would be at work in rows that are only proposed: those of known size that name
/// no rows of a file.
pub fn of_design(model: &Model, measurements: &Measurements) -> Vec<Term> {
    let is_of_rows = |t: &Term| t.covariance.is_some() || !t.rows.is_empty();
    let is_told = |t: &Term| !t.size.is_nan() || t.effect.acts.is_reading();
    let of = |t: &&Term| !is_of_rows(t) && is_told(t) && is_in_file(t, measurements);
    let placed = |t: &Term| Term { observable: meant(t, measurements), ..t.clone() };
    model.measurement.iter().filter(of).map(placed).collect()
}

/// Cautions about terms, resolved to the rows of a file, that cannot be meant as they stand.
pub fn cautions(model: &Model, terms: &[Term], measurements: &Measurements) -> Vec<String> {
    let absent = model.measurement.iter().filter(|t| !is_in_file(t, measurements)).map(|t| {
        let own = t.observable.into_iter().chain(t.among.iter().copied());
        let names: Vec<&str> = own.map(|o| &*model.process.observables()[o].name).collect();
        format!("`measurement.{}` has no effect: {} has no {}", t.table, measurements.name, names.join(" or "))
    });
    let own = terms.iter().filter_map(|term| {
        caution(&*model.process, term, measurements).map(|text| format!("`measurement.{}` {text}", term.table))
    });
    absent.chain(own).collect()
}
