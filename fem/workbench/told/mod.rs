//! What the page is told of a bench.

mod diagnosis;
mod model;

pub use diagnosis::diagnosis;
pub use model::{model, unit_of};

use std::collections::BTreeSet;
use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::bench::{Bench, Compared};
use super::refusal::Refusal;
use crate::measure::{Decimal, MeasuredObservable, Measurements, Reading};
use crate::output::finite;
use crate::process::Holds;
use crate::tolerance::Limits;
use crate::units::Kind;

/// The measurements that are open.
pub fn data(bench: &Bench) -> Json {
    let Some(all) = &bench.measured else { return Json::Null };
    let column = |(name, heading): (&String, &String)| {
        let (name, unit) = crate::input::name_and_unit(name);
        json!({ "name": name, "unit": unit, "heading": heading })
    };
    json!({
        "files": bench.files,
        "rows": all.len(),
        "notes": all.notes,
        "columns": all.header.iter().zip(&all.headings).map(column).collect::<Vec<_>>(),
        "reading": reading(&bench.reading),
        "struck": bench.struck.iter().collect::<Vec<_>>(),
    })
}

/// What was said of how files are to be read.
pub fn reading(said: &Reading) -> Json {
    let decimal = said.decimal.map(|own| match own {
        Decimal::Comma => "comma",
        Decimal::Point => "point",
    });
    json!({
        "columns": said.columns(),
        "decimal": decimal,
        "header": said.headings.map(|line| line.unwrap_or(0)),
        "sheet": said.sheet,
        "as_typed": said.as_typed,
    })
}

/// How the model stands against them.
pub fn comparison(compared: Option<&Result<Arc<Compared>, Refusal>>) -> Json {
    match compared {
        None => Json::Null,
        Some(Err(refusal)) => json!({ "problem": refusal.text(), "html": "" }),
        Some(Ok(own)) => json!({
            "rms": finite(own.rms),
            "unit": own.unit,
            "reduced_chi2": finite(own.reduced_chi2),
            "noise": finite(own.noise),
            "is_adequate": own.is_adequate,
            "verdict": if own.is_adequate { "nothing is left but the noise" } else { "the model fails" },
            "html": own.html,
            "problem": null,
        }),
    }
}

/// The rows, with what is predicted of them; numbers in the units that are shown.
pub fn rows(bench: &Bench, version: u64) -> Option<Json> {
    let (all, model) = (bench.measured.as_ref()?, bench.model.as_ref()?);
    let coordinates = model.process.coordinates();
    let column = |i: &usize| {
        let (values, coordinate) = (&all.rows.columns[*i], &coordinates[*i]);
        let (unit, shown, words): (&str, Vec<Json>, Json) = match &coordinate.holds {
            Holds::Quantity(kind) => {
                (&kind.unit, values.iter().map(|own| finite(kind.from_si(*own))).collect(), Json::Null)
            }
            Holds::Number(_) => ("", values.iter().map(|own| finite(*own)).collect(), Json::Null),
            Holds::Word(words) => {
                let word = |own: &f64| json!(words.of_value(*own));
                ("", values.iter().map(|own| finite(*own)).collect(), values.iter().map(word).collect())
            }
        };
        json!({ "name": &*coordinate.name, "unit": unit, "values": shown, "words": words })
    };
    let found = bench.compared.as_ref().and_then(|found| found.as_ref().ok());
    let limits = model.system.limits(&model.system.resolved(&all.rows));
    let references = bench.references.as_ref().map(|all| all.as_slice());
    let reference = |row: usize| references.map_or(0.0, |all| all[row]);
    let within = |(row, own): (usize, &Option<Limits>)| match own {
        Some(own) => json!([own.lower, own.upper].map(|end| finite(kind(all, row).from_si(end - reference(row))))),
        None => Json::Null,
    };
    let is_referred = |own: &MeasuredObservable| {
        (0..all.len()).any(|row| all.observables[all.observable(row)].position == own.position && reference(row) != 0.0)
    };
    let observable = |own: &MeasuredObservable| {
        let name = if is_referred(own) { format!("{} less nominal", own.name) } else { own.name.to_string() };
        json!({ "name": name, "unit": own.kind.unit })
    };
    let is_asked = limits.iter().any(Option::is_some);
    Some(json!({
        "version": version,
        "columns": all.given.iter().map(column).collect::<Vec<_>>(),
        "observables": all.observables.iter().map(observable).collect::<Vec<_>>(),
        "observable": (0..all.len()).map(|row| all.observable(row)).collect::<Vec<_>>(),
        "observed": (0..all.len()).map(|row| finite(kind(all, row).from_si(all.observed[row] - reference(row)))).collect::<Vec<_>>(),
        "predicted": found.map(|found| in_rows((all, &bench.struck), &found.predicted, references)),
        "sigma": found.map(|found| in_rows((all, &bench.struck), &found.sigma.to_vec(), None)),
        "limits": is_asked.then(|| limits.iter().enumerate().map(within).collect::<Vec<_>>()),
        "lines": (0..all.len()).map(|row| all.line(row)).collect::<Vec<_>>(),
    }))
}

/// What a model predicts with values on trial of the rows that count, each less its reference (SI), if it has one; what is left;
/// and whether any row `moves` by them.
pub fn trial(
    rows: (&Measurements, &BTreeSet<usize>),
    (predicted, references): (&[f64], Option<&[f64]>),
    (left, moves): (Option<f64>, bool),
) -> Json {
    json!({ "predicted": in_rows(rows, predicted, references), "rms": left.map(finite), "moves": moves })
}

/// Values (SI) of the rows that count, each in its place among all and in its unit, less its reference; null where one is
/// struck out.
fn in_rows((all, struck): (&Measurements, &BTreeSet<usize>), counted: &[f64], references: Option<&[f64]>) -> Vec<Json> {
    let mut counted = counted.iter();
    let own = |row: usize| match struck.contains(&row) {
        true => Json::Null,
        false => counted
            .next()
            .map_or(Json::Null, |own| finite(kind(all, row).from_si(own - references.map_or(0.0, |all| all[row])))),
    };
    (0..all.len()).map(own).collect()
}

/// Kind of what a row observes.
fn kind(all: &Measurements, row: usize) -> Kind {
    all.observables[all.observable(row)].kind
}
