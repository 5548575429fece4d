//! The tables `[measurement.NAME]`: what the model says of its instrument, datum and surroundings.

use crate::input::{Problem, Reader, did_you_mean};
use crate::measure::Measurements;
use crate::noise::{Acts, MeasurementEffect, Size, Term, effects};
use crate::process::Process;
use crate::units::{Kind, Knowledge, NUMBER, Quantity};

/// Reads every measurement effect of a model. A size that is unknown (`?`) is not a number; rows are records
/// of the file, counted from 1.
pub fn read(model: &Reader, process: &'static dyn Process) -> Vec<Term> {
    let names: Vec<&'static str> = effects::ALL.iter().map(|e| e.name).collect();
    let about = "what instrument, datum or surroundings do to the measurements";
    let read = |name: &'static str, table: &Reader| {
        let effect = effects::ALL.iter().copied().find(|e| e.name == name)?;
        term(effect, table, process)
    };
    model.tables_within("measurement", about, &names, read).into_iter().flatten().collect()
}

fn term(effect: &'static MeasurementEffect, table: &Reader, process: &'static dyn Process) -> Option<Term> {
    let mut term = Term::new(effect);
    if let Some(name) = table.text("observable", "the observable on which it acts, where a file has several") {
        let names = || process.observables().iter().map(|o| o.name);
        term.observable = names().position(|n| n == name);
        if term.observable.is_none() {
            let meant = did_you_mean(&name, names(), '"');
            let known = names().collect::<Vec<_>>().join(", ");
            table.problem("observable", format!("`{name}` is not observed"), format!("{meant}known are {known}"));
        }
    }
    if *effect == effects::ZERO_SHIFT || *effect == effects::DISCREPANCY {
        let about = "coordinates whose levels have a zero each, parted by commas; one zero for all where left out";
        for name in table.text("by", about).iter().flat_map(|by| by.split(',')).map(str::trim) {
            let names = || process.coordinates().iter().map(|c| c.name);
            match names().position(|n| n == name) {
                Some(coordinate) => term.by.push(coordinate),
                None => {
                    let meant = did_you_mean(name, names(), '"');
                    let known = names().collect::<Vec<_>>().join(", ");
                    table.problem("by", format!("`{name}` is no coordinate"), format!("{meant}known are {known}"));
                }
            }
        }
    }
    if matches!(effect.acts, Acts::Weighs) {
        let listed = table.text("rows", "the rows that are wrong, counted from 1 and parted by commas");
        term.rows = numbers(table, "rows", listed.as_deref().unwrap_or_default());
        if listed.is_none() && !table.is_described() {
            table.problem("rows", "the rows that are wrong are not listed", "add rows = \"12, 40\"");
        }
    }
    if *effect == effects::JUMP {
        let first = table.text("from", "the first row of the step, counted from 1");
        term.rows = numbers(table, "from", first.as_deref().unwrap_or_default());
        if term.rows.len() != 1 && !table.is_described() {
            table.problem("from", "a step begins at one row", "add from = \"46\"");
        }
    }
    let size = table.text(effect.size.key(), effect.size.about());
    term.size = match &size {
        Some(text) => quantity(effect, table, process, text)?,
        None => f64::NAN,
    };
    Some(term)
}

/// The size in SI; not a number where it is unknown.
fn quantity(effect: &MeasurementEffect, table: &Reader, process: &dyn Process, text: &str) -> Option<f64> {
    let key = effect.size.key();
    let kinds: Vec<Kind> = match effect.size {
        Size::Number(..) => vec![NUMBER],
        Size::OfObservable(..) => process.observables().iter().map(|o| o.kind).collect(),
    };
    let mut read = kinds.iter().map(|kind| Quantity::parse(text, kind));
    let found = read.clone().find_map(Result::ok);
    match (found, read.next()) {
        (Some(q), _) if q.knowledge == Knowledge::Free => Some(f64::NAN),
        (Some(q), _) if q.value > 0.0 && q.value.is_finite() => Some(q.value),
        (Some(_), _) => {
            table.problem(key, format!("`{key}` must be above zero"), "leave the table out, or write \"?\"");
            None
        }
        (None, Some(Err(e))) => {
            table.problem(key, format!("`{key}`: {}", e.message), e.hint.unwrap_or_default());
            None
        }
        (None, _) => None,
    }
}

fn numbers(table: &Reader, key: &str, text: &str) -> Vec<usize> {
    let mut rows = Vec::new();
    for word in text.split(',').map(str::trim).filter(|w| !w.is_empty()) {
        match word.parse::<usize>() {
            Ok(row) if row > 0 => rows.push(row),
            _ => table.problem(key, format!("`{word}` is no row"), "rows are counted from 1: \"12, 40\""),
        }
    }
    rows
}

/// The terms with the rows of a file in the place of its records.
///
/// # Errors
/// A record that the file does not have.
pub fn resolved(terms: &[Term], measurements: &Measurements) -> Result<Vec<Term>, Problem> {
    let resolve = |term: &Term| {
        let mut rows = Vec::new();
        for record in &term.rows {
            let own = (0..measurements.len()).filter(|row| measurements.records_of[*row] + 1 == *record);
            let own: Vec<usize> = own.filter(|row| term.is_of(measurements, *row)).collect();
            if own.is_empty() {
                let problem = Problem::new(format!("`measurement.{}` names row {record}", term.effect.name));
                return Err(problem.help(format!("{} has no such row", measurements.name)));
            }
            let first = if *term.effect == effects::JUMP { 1 } else { own.len() };
            rows.extend(own.into_iter().take(first));
        }
        Ok(Term { rows, ..term.clone() })
    };
    terms.iter().map(resolve).collect()
}
