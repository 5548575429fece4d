//! Effects of the measurement, as text and JSON: the catalogue, and those that are at work.

use std::fmt::Write;

use serde_json::{Value as Json, json};

use crate::input::Name;
use crate::measure::{Measurements, grouping_name};
use crate::noise::{Key, MEASUREMENT, MeasurementEffect, Shape, Size, Term, effects};
use crate::process::Process;
use crate::units::{Kind, NUMBER};

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
    let keys = effect.all_keys();
    for key in &keys {
        let _ = writeln!(text, "  {:<14} {}", key.name, described(effect, key));
    }
    let _ = writeln!(text, "\n  what separates it from effects of the machine: {separates}");
    let _ = writeln!(text, "\n  in a model file\n    [{MEASUREMENT}.{name}]");
    for key in keys.iter().filter(|key| !key.example.is_empty()) {
        let is_plain = is_number(effect, key) && key.example.parse::<f64>().is_ok();
        let quote = if is_plain { "" } else { "\"" };
        let _ = writeln!(text, "    {} = {quote}{}{quote}", key.name, key.example);
    }
    text
}

fn is_size(effect: &MeasurementEffect, key: &Key) -> bool {
    effect.size_keys().contains(&key.name)
}

/// Unit of a key, where it is known without a file.
fn unit(effect: &MeasurementEffect, key: &Key) -> Option<&'static str> {
    match effect.sizes().find(|own| own.size.key() == key.name)?.size {
        Size::Number(..) => Some(""),
        Size::Quantity(parameter) => Some(&parameter.kind.unit),
        Size::OfObservable(..) | Size::OfReading(_) | Size::File(..) => None,
    }
}

fn is_number(effect: &MeasurementEffect, key: &Key) -> bool {
    unit(effect, key) == Some("")
}

fn described(effect: &MeasurementEffect, key: &Key) -> String {
    match effect.size {
        Size::OfObservable(..) | Size::OfReading(_) if is_size(effect, key) && unit(effect, key).is_none() => {
            format!("{}, in a unit of what is observed", key.about)
        }
        _ => key.about.to_string(),
    }
}

/// The entry of an effect in `fem effects --json`, with the keys of the others.
pub fn entry(effect: &MeasurementEffect) -> Json {
    let parameter = |key: &Key| {
        json!({
            "name": key.name, "about": described(effect, key), "example": key.example,
            "unit": unit(effect, key), "neutral": null, "range": null, "default": null,
        })
    };
    json!({
        "process": MEASUREMENT,
        "effect": effect.name,
        "about": effect.about,
        "law": effect.law,
        "source": effect.source,
        "parameters": effect.all_keys().iter().map(parameter).collect::<Vec<_>>(),
        "look_alikes": [],
        "separated_by": [effect.separates],
    })
}

/// The line that says which effects of the measurement a model has at work; empty where there are none.
/// Where no file is meant, rows are its records.
pub fn at_work(model: &str, terms: &[Term], process: &dyn Process, measurements: Option<&Measurements>) -> String {
    if terms.is_empty() {
        return String::new();
    }
    let all: Vec<String> = terms.iter().map(|term| words(term, process, measurements)).collect();
    format!("{model} has, of the measurement: {}\n", all.join("; "))
}

/// A term in words: `zero-shift by run, size 0.712 um`.
pub fn words(term: &Term, process: &dyn Process, measurements: Option<&Measurements>) -> String {
    let mut text = term.effect.name.to_string();
    text.push_str(&grouped(&coordinates(term, process)));
    if let Some(along) = term.along {
        let coordinate = &process.coordinates()[along.coordinate];
        let _ = write!(text, " along {}", coordinate.name);
        if let Some((period, kind)) = term.period.zip(coordinate.holds.kind()) {
            let _ = write!(text, " once in {:.3} {}", kind.from_si(period), kind.unit);
        }
    }
    if let Some(observable) = term.observable {
        let _ = write!(text, " of {}", process.observables()[observable].name);
    }
    match (&term.rows[..], measurements) {
        ([], _) => {}
        ([row], Some(measurements)) => drop(write!(text, ", {}", measurements.place(*row))),
        ([record], None) => drop(write!(text, ", row {record}")),
        (rows, _) => drop(write!(text, ", {} rows", rows.len())),
    }
    let key = term.effect.size.key();
    match (&term.covariance, term.size) {
        (Some(given), _) => drop(write!(text, " of {} rows", given.rows())),
        (None, size) if size.is_nan() => drop(write!(text, ", {key} estimated")),
        (None, size) if size.is_infinite() => drop(write!(text, ", {key} free")),
        (None, size) => drop(write!(text, ", {key} {:.3}", kind(term, process, measurements).shown(size))),
    }
    text
}

/// Names of the files of measurements.
pub fn files(measurements: &Measurements) -> Vec<&str> {
    measurements.files.iter().map(|file| &*file.name).collect()
}

/// Kind of the size of a term: without a file that of the observable that it names, or of the first.
fn kind(term: &Term, process: &dyn Process, measurements: Option<&Measurements>) -> Kind {
    match (measurements, term.effect.size) {
        (Some(measurements), _) => term.kind(measurements),
        (None, Size::OfObservable(..) | Size::OfReading(_)) => {
            process.observables()[term.observable.unwrap_or(0)].error_kind()
        }
        (None, Size::Quantity(parameter)) => parameter.kind,
        (None, Size::Number(..) | Size::File(..)) => NUMBER,
    }
}

/// The coordinates that group rows, in words: ` by run and direction`.
pub fn grouped(by: &[Name]) -> String {
    if by.is_empty() { String::new() } else { format!(" by {}", by.join(" and ")) }
}

/// Name in the field, and explanation, of a curve along these coordinates that no law has.
pub fn curve(effect: &MeasurementEffect, by: &[Name], process: &dyn Process) -> Option<(&'static str, &'static str)> {
    let own = process.coordinates().iter().filter(|c| by.contains(&c.name));
    own.filter_map(|c| c.curve).next().filter(|_| effect.shape == Some(Shape::Curve))
}

fn coordinates(term: &Term, process: &dyn Process) -> Vec<Name> {
    term.by.iter().map(|i| grouping_name(process, *i)).collect()
}

/// The effects of the measurement at work, beside the noise in JSON; rows are records, counted from 1.
pub fn json(terms: &[Term], process: &dyn Process, measurements: Option<&Measurements>) -> Json {
    let record = |row: &usize| measurements.map_or(*row, |m| m.record(*row));
    let one = |term: &Term| {
        let kind = kind(term, process, measurements);
        let is_file = matches!(term.effect.size, Size::File(..));
        let size = match term.size {
            size if term.is_flat() && size.is_infinite() => json!("free"),
            size if size.is_finite() && !is_file => json!(kind.from_si(size)),
            _ => Json::Null,
        };
        json!({
            "effect": term.effect.name,
            "table": Some(&term.table).filter(|table| !table.is_empty()),
            "by": coordinates(term, process),
            "along": term.along.map(|a| &process.coordinates()[a.coordinate].name),
            "period": term.period.zip(term.along).map(|(period, along)| {
                let kind = process.coordinates()[along.coordinate].holds.kind();
                kind.map(|kind| json!({ "value": kind.from_si(period), "unit": kind.unit }))
            }),
            "observable": term.observable.map(|o| &process.observables()[o].name),
            "rows": term.rows.iter().map(record).collect::<Vec<_>>(),
            "parameter": term.effect.size.key(),
            "size": size,
            "unit": kind.unit,
        })
    };
    terms.iter().map(one).collect()
}

/// The entry of the catalogue by its name, if it is one of the measurement.
pub fn entry_named(name: &str) -> Option<&'static MeasurementEffect> {
    effects::all().find(|effect| effect.name == name)
}
