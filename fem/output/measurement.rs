//! Effects of the measurement, as text and JSON: the catalogue, and those that are at work.

use std::fmt::Write;

use serde_json::{Value as Json, json};

use crate::measure::Measurements;
use crate::model::{Key, measurement_keys};
use crate::noise::{MeasurementEffect, Size, Term, effects};
use crate::process::Process;

/// The word by which all of them are asked for.
pub const MEASUREMENT: &str = "measurement";

/// The section of the catalogue: one line per effect.
pub fn catalogue(effects: &[&MeasurementEffect]) -> String {
    let mut text = format!("{MEASUREMENT}: what instrument, datum and surroundings do to data, in every process\n");
    for effect in effects {
        // Writing to a String does not fail, here and below.
        let _ = writeln!(text, "  {:<24} {}", effect.name, effect.about);
    }
    text
}

/// All about one effect.
pub fn page(effect: &MeasurementEffect) -> String {
    let MeasurementEffect { name, about, law, source, separates, .. } = effect;
    let mut text = format!("{name} ({MEASUREMENT})\n  {about}\n\n  law     {law}\n  source  {source}\n\n");
    let keys = measurement_keys(effect);
    for key in &keys {
        let _ = writeln!(text, "  {:<14} {}", key.name, described(effect, key));
    }
    let _ = writeln!(text, "\n  what separates it from effects of the machine: {separates}");
    let _ = writeln!(text, "\n  in a model file\n    [{MEASUREMENT}.{name}]");
    for key in keys.iter().filter(|key| !key.example.is_empty()) {
        let quote = if is_number(effect, key) { "" } else { "\"" };
        let _ = writeln!(text, "    {} = {quote}{}{quote}", key.name, key.example);
    }
    text
}

fn is_size(effect: &MeasurementEffect, key: &Key) -> bool {
    key.name == effect.size.key()
}

fn is_number(effect: &MeasurementEffect, key: &Key) -> bool {
    is_size(effect, key) && matches!(effect.size, Size::Number(..))
}

fn described(effect: &MeasurementEffect, key: &Key) -> String {
    match effect.size {
        Size::OfObservable(..) if is_size(effect, key) => format!("{}, in a unit of what is observed", key.about),
        _ => key.about.to_string(),
    }
}

/// The entry of an effect in `fem effects --json`, with the keys of the others.
pub fn entry(effect: &MeasurementEffect) -> Json {
    let parameter = |key: &Key| {
        let unit = if is_number(effect, key) { Some("") } else { None };
        json!({
            "name": key.name, "about": described(effect, key), "example": key.example,
            "unit": unit, "neutral": null, "range": null, "default": null,
        })
    };
    json!({
        "process": MEASUREMENT,
        "effect": effect.name,
        "about": effect.about,
        "law": effect.law,
        "source": effect.source,
        "parameters": measurement_keys(effect).iter().map(parameter).collect::<Vec<_>>(),
        "look_alikes": [],
        "separated_by": [effect.separates],
    })
}

/// The line that says which effects of the measurement a model has at work; empty where there are none.
pub fn at_work(model: &str, terms: &[Term], process: &dyn Process, measurements: &Measurements) -> String {
    if terms.is_empty() {
        return String::new();
    }
    let all: Vec<String> = terms.iter().map(|term| words(term, process, measurements)).collect();
    format!("{model} has, of the measurement: {}\n", all.join("; "))
}

/// A term in words: `zero-shift by run, size 0.712 um`.
pub fn words(term: &Term, process: &dyn Process, measurements: &Measurements) -> String {
    let mut text = term.effect.name.to_string();
    text.push_str(&grouped(&coordinates(term, process)));
    if let Some(observable) = term.observable {
        let _ = write!(text, " of {}", process.observables()[observable].name);
    }
    match &term.rows[..] {
        [] => {}
        [row] => drop(write!(text, ", line {}", measurements.lines[*row])),
        rows => drop(write!(text, ", {} rows", rows.len())),
    }
    let size = term.kind(measurements).shown(term.size);
    match term.size.is_nan() {
        true => drop(write!(text, ", {} estimated", term.effect.size.key())),
        false => drop(write!(text, ", {} {size:.3}", term.effect.size.key())),
    }
    text
}

/// The coordinates that group rows, in words: ` by run and direction`.
pub fn grouped(by: &[&str]) -> String {
    if by.is_empty() { String::new() } else { format!(" by {}", by.join(" and ")) }
}

/// What a curve along these coordinates that no law has is called in the field, and what that is.
pub fn curve(effect: &MeasurementEffect, by: &[&str], process: &dyn Process) -> Option<(&'static str, &'static str)> {
    let own = process.coordinates().iter().filter(|c| by.contains(&c.name));
    own.filter_map(|c| c.curve).next().filter(|_| *effect == effects::DISCREPANCY)
}

fn coordinates(term: &Term, process: &dyn Process) -> Vec<&'static str> {
    term.by.iter().map(|i| process.coordinates()[*i].name).collect()
}

/// The effects of the measurement at work, beside the noise in JSON; rows are records, counted from 1.
pub fn json(terms: &[Term], process: &dyn Process, measurements: &Measurements) -> Json {
    let one = |term: &Term| {
        let kind = term.kind(measurements);
        json!({
            "effect": term.effect.name,
            "by": coordinates(term, process),
            "observable": term.observable.map(|o| process.observables()[o].name),
            "rows": term.rows.iter().map(|row| measurements.records_of[*row] + 1).collect::<Vec<_>>(),
            "parameter": term.effect.size.key(),
            "size": Some(kind.from_si(term.size)).filter(|size| size.is_finite()),
            "unit": kind.unit,
        })
    };
    terms.iter().map(one).collect()
}
