//! The tables `[measurement.NAME]`: what the model says of its instrument, datum and surroundings.

use crate::input::{Problem, Reader, did_you_mean, is_one_of};
use crate::measure::{FILE, FILE_WORD};
use crate::noise::{Acts, MeasurementEffect, Size, Term, effects};
use crate::process::Process;
use crate::units::{Kind, Knowledge, NUMBER, Quantity};

/// A key of such a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// What it holds.
    pub about: &'static str,
    /// How it is written, without quotes; empty where it is seldom needed.
    pub example: &'static str,
}

const BY: Key = Key {
    name: "by",
    about: "coordinates, or `file`, whose levels have a zero each, parted by commas; one zero for all where left out",
    example: "run",
};
const OBSERVABLE: Key =
    Key { name: "observable", about: "the observable on which it acts, where a file has several", example: "" };
const ROWS: Key =
    Key { name: "rows", about: "the rows that are wrong, counted from 1 and parted by commas", example: "12, 40" };
const FROM: Key = Key { name: "from", about: "the first row of the step, counted from 1", example: "46" };
const IN_FILE: Key = Key {
    name: "file",
    about: "of several files the one whose rows these are; counted through all of them where left out",
    example: "",
};

/// The keys of an effect's table, the size last.
pub fn keys(effect: &MeasurementEffect) -> Vec<Key> {
    let mut keys = Vec::new();
    if *effect == effects::ZERO_SHIFT || *effect == effects::DISCREPANCY {
        keys.push(BY);
    }
    if matches!(effect.acts, Acts::Shared(_) | Acts::Weighs) {
        keys.push(OBSERVABLE);
    }
    if matches!(effect.acts, Acts::Weighs) {
        keys.push(ROWS);
    }
    if *effect == effects::JUMP {
        keys.push(FROM);
    }
    if matches!(effect.acts, Acts::Weighs) || *effect == effects::JUMP {
        keys.push(IN_FILE);
    }
    let example = match (effect.size, effect.acts) {
        (Size::OfObservable(..), _) => "0.7 um",
        (Size::Number(..), Acts::Weighs) => "10",
        (Size::Number(..), _) => "2",
    };
    keys.push(Key { name: effect.size.key(), about: effect.size.about(), example });
    keys
}

/// Finds an effect of the measurement by the name of its table, which may be a further one: `zero-shift-2`.
pub fn effect_named(name: &str) -> Option<&'static MeasurementEffect> {
    effects::ALL.iter().copied().find(|e| is_one_of(name, e.name))
}

/// Reads every measurement effect of a model. A size that is unknown (`?`) is not a number; rows are records
/// of the file, counted from 1.
pub fn read(model: &Reader, process: &'static dyn Process) -> Vec<Term> {
    let names: Vec<&'static str> = effects::ALL.iter().map(|e| e.name).collect();
    let about = "what instrument, datum or surroundings do to the measurements";
    let read = |name: &'static str, table: &Reader| term(effect_named(name)?, table, process);
    model.tables_within("measurement", about, &names, read).into_iter().flatten().collect()
}

fn term(effect: &'static MeasurementEffect, table: &Reader, process: &'static dyn Process) -> Option<Term> {
    let mut term = Term::new(effect);
    let keys = keys(effect);
    if keys.contains(&BY) {
        term.by = coordinates(table, process);
    }
    if keys.contains(&OBSERVABLE) {
        term.observable = observable(table, process);
    }
    if keys.contains(&ROWS) {
        term.rows = numbers(table, &ROWS);
        if !table.has(ROWS.name) {
            table.problem(ROWS.name, "the rows that are wrong are not listed", "add rows = \"12, 40\"");
        }
    }
    if keys.contains(&FROM) {
        term.rows = numbers(table, &FROM);
        if !table.has(FROM.name) || term.rows.len() > 1 {
            table.problem(FROM.name, "a step begins at one row", "add from = \"46\"");
        }
    }
    if keys.contains(&IN_FILE) {
        term.file = table.text(IN_FILE.name, IN_FILE.about);
    }
    let key = effect.size.key();
    let Some(text) = table.text_or_number(key, effect.size.about()) else {
        term.size = if matches!(effect.acts, Acts::Weighs) { effects::OUTLYING } else { f64::NAN };
        return Some(term);
    };
    match size(effect, &observed(process, term.observable), &text) {
        Ok((value, of)) => {
            term.size = value;
            // A unit that only one of several observables has tells on which the effect acts.
            if let ([only], true) = (&of[..], of.len() < process.observables().len() && keys.contains(&OBSERVABLE)) {
                term.observable = Some(*only);
            }
            Some(term)
        }
        Err(problem) => {
            table.problem(key, format!("`{key}`: {}", problem.message), problem.help.unwrap_or_default());
            None
        }
    }
}

fn coordinates(table: &Reader, process: &dyn Process) -> Vec<usize> {
    let names = || process.coordinates().iter().map(|c| c.name).chain([FILE_WORD]);
    let mut all = Vec::new();
    for name in table.text(BY.name, BY.about).iter().flat_map(|by| by.split(',')).map(str::trim) {
        match names().position(|n| n == name) {
            Some(last) if last == process.coordinates().len() => all.push(FILE),
            Some(coordinate) => all.push(coordinate),
            None => {
                let meant = did_you_mean(name, names(), '"');
                let known = names().collect::<Vec<_>>().join(", ");
                table.problem(BY.name, format!("`{name}` is no coordinate"), format!("{meant}known are {known}"));
            }
        }
    }
    all
}

fn observable(table: &Reader, process: &dyn Process) -> Option<usize> {
    let name = table.text(OBSERVABLE.name, OBSERVABLE.about)?;
    let names = || process.observables().iter().map(|o| o.name);
    let position = names().position(|n| n == name);
    if position.is_none() {
        let meant = did_you_mean(&name, names(), '"');
        let known = names().collect::<Vec<_>>().join(", ");
        table.problem(OBSERVABLE.name, format!("`{name}` is not observed"), format!("{meant}known are {known}"));
    }
    position
}

fn numbers(table: &Reader, key: &Key) -> Vec<usize> {
    let text = table.text_or_number(key.name, key.about);
    let mut rows = Vec::new();
    for word in text.iter().flat_map(|text| text.split(',')).map(str::trim) {
        match word.parse::<usize>() {
            Ok(row) if row > 0 => rows.push(row),
            _ => table.problem(
                key.name,
                format!("`{word}` is no row"),
                format!("rows are counted from 1: \"{}\"", key.example),
            ),
        }
    }
    rows
}

/// Positions and kinds of the observables on which an effect can act.
pub(super) fn observed(process: &dyn Process, only: Option<usize>) -> Vec<(usize, Kind)> {
    let all = process.observables().iter().enumerate().map(|(i, o)| (i, o.error_kind()));
    all.filter(|(i, _)| only.is_none_or(|only| only == *i)).collect()
}

/// Reads the size of an effect that acts on one of `observed`: its value in SI, not a number where it is
/// unknown, and the observables of whose kind it is.
///
/// # Errors
/// It is no quantity of any of them, or cannot be meant.
pub(super) fn size(
    effect: &MeasurementEffect,
    observed: &[(usize, Kind)],
    text: &str,
) -> Result<(f64, Vec<usize>), Problem> {
    let parse = |(position, kind): &(usize, Kind)| {
        let kind = if matches!(effect.size, Size::Number(..)) { &NUMBER } else { kind };
        // Of what is unknown the unit need not be said.
        let text = if text.trim() == "?" { format!("? {}", kind.unit) } else { text.to_string() };
        Quantity::parse(&text, kind).map(|quantity| (*position, quantity))
    };
    let (read, wrong): (Vec<_>, Vec<_>) = observed.iter().map(parse).partition(Result::is_ok);
    let read: Vec<(usize, Quantity)> = read.into_iter().flatten().collect();
    let Some((_, quantity)) = read.first() else {
        let error = wrong.into_iter().find_map(Result::err);
        let (message, hint) = error.map_or((String::new(), None), |e| (e.message, e.hint));
        let example = keys(effect).last().map_or("", |key| key.example);
        return Err(Problem::new(message).help(hint.unwrap_or_else(|| format!("write \"{example}\""))));
    };
    let of = read.iter().map(|(position, _)| *position).collect();
    let is_weight = matches!(effect.acts, Acts::Weighs);
    match quantity.knowledge {
        Knowledge::Free if is_weight => {
            Err(Problem::new("it cannot be estimated from single rows").help("leave it out, and it is 10"))
        }
        Knowledge::Free => Ok((f64::NAN, of)),
        _ if quantity.value > 0.0 => Ok((quantity.value, of)),
        _ if is_weight => Err(Problem::new("it must be above zero").help("leave it out, and it is 10")),
        _ => Err(Problem::new("it must be above zero").help("leave the table out, or write \"?\"")),
    }
}
