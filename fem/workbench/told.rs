//! What the page is told of a bench.

use std::collections::BTreeSet;
use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::bench::{Bench, Compared, Diagnosed};
use super::refusal::Refusal;
use crate::input::Parameter;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::finite;
use crate::process::Holds;
use crate::units::{Kind, Knowledge, Unit, unit_text};

/// The model with its text: its values, its effects, those that it could have.
pub fn model(bench: &Bench, text: &str, is_saved: bool) -> Json {
    let Some(model) = &bench.model else { return Json::Null };
    let has = |name: &str| model.effects.iter().any(|own| own.description.name == *name);
    let effect = |name: &str, about: &str| json!({ "name": name, "about": about });
    let own = model.effects.iter().map(|own| effect(&own.description.name, &own.description.about));
    let of_measurement = model.measurement.iter().map(|term| effect(&term.table, term.effect.about));
    let catalogue = model.process.effects();
    let absent = catalogue.iter().filter(|own| !has(&own.name) && model.system.admits(&own.name).is_ok());
    json!({
        "file": bench.file,
        "title": model.title,
        "process": model.process.name(),
        "about": model.process.about(),
        "is_saved": is_saved,
        "text": text,
        "figures": bench.drawn,
        "values": model.quantities.iter().map(|own| value(model, own)).collect::<Vec<_>>(),
        "effects": own.chain(of_measurement).collect::<Vec<_>>(),
        "catalogue": absent.map(|own| effect(&own.name, &own.about)).collect::<Vec<_>>(),
    })
}

/// The unit in which a value is written, or else the usual one; with its symbol.
pub fn unit_of<'m>(model: &'m Model, parameter: &'m Parameter) -> (Unit, &'m str) {
    let written = model.written(&parameter.path).map(unit_text);
    let own = written.and_then(|name| Some((parameter.kind.unit_of(name).ok()?, name)));
    own.unwrap_or((parameter.kind.canonical(), &parameter.kind.unit))
}

/// A quantity, in the unit in which it is written.
fn value(model: &Model, own: &Parameter) -> Json {
    let (unit, symbol) = unit_of(model, own);
    let shown = |si: f64| (si - unit.offset) / unit.factor;
    let (knowledge, std) = match own.quantity.knowledge {
        Knowledge::Known => ("known", Json::Null),
        Knowledge::Rough(std) => ("roughly", finite(std / unit.factor)),
        Knowledge::Free => ("unknown", Json::Null),
    };
    let entry = model.catalogue(&own.path);
    let effect = model.effect_of(&own.path).and_then(|name| model.effects.iter().find(|e| e.description.name == *name));
    let range = entry.map(|p| [p.range.0, p.range.1].map(|end| finite(shown(p.kind.to_si(end)))));
    let text = model.written(&own.path).map(str::to_string).or_else(|| model.raw(&own.path).map(|raw| raw.to_string()));
    let (group, key) = own.path.rsplit_once('.').unwrap_or(("", &own.path));
    json!({
        "path": own.path.to_string(),
        "group": group,
        "key": key,
        "text": text,
        "value": finite(shown(own.quantity.value)),
        "unit": symbol,
        "std": std,
        "knowledge": knowledge,
        "about": entry.map(|p| p.about),
        "range": range,
        "source": effect.map(|e| e.description.source),
    })
}

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
        "struck": bench.struck.iter().collect::<Vec<_>>(),
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

/// What is missing, by the last diagnosis.
pub fn diagnosis(found: &Diagnosed, model: Option<&Model>, is_current: bool) -> Json {
    let is_there = |name: &str| model.is_some_and(|m| m.effects.iter().any(|own| own.description.name == *name));
    let cause = |(number, own): (usize, &Json)| {
        let name = own["effect"].as_str().unwrap_or_default();
        let probability = own["probability"].as_f64().unwrap_or(0.0);
        let values = own["parameters"].as_object().into_iter().flatten().map(|(key, value)| {
            format!("{key} {:.4} {}", value["value"].as_f64().unwrap_or(f64::NAN), value["unit"].as_str().unwrap_or(""))
        });
        json!({
            "effect": name,
            "label": name,
            "about": about(model, name),
            "probability": probability,
            "class": if probability >= 0.9 { "certain" } else { "perhaps" },
            "rms_after": own["rms_after"],
            "unit": found.json["noise"]["unit"],
            "values": values.collect::<Vec<_>>(),
            "alike": own["indistinguishable_from"],
            "can_add": found.additions.get(number).is_some() && !is_there(name),
            "is_added": is_there(name),
        })
    };
    let other = |own: &Json| {
        let name = own["effect"].as_str().unwrap_or_default();
        json!({ "effect": name, "about": about(model, name), "probability": own["probability"], "rms_alone": own["rms_after"] })
    };
    let list = |key: &str| found.json[key].as_array().map_or(&[][..], Vec::as_slice);
    json!({
        "is_current": is_current,
        "verdict": found.verdict,
        "html": found.html,
        "causes": list("missing").iter().enumerate().map(cause).collect::<Vec<_>>(),
        "others": list("candidates").iter().map(other).collect::<Vec<_>>(),
        "next": found.next.as_ref().map(|(html, rows)| json!({ "html": html, "rows": rows })),
    })
}

/// What an effect is, where the catalogue of the model's process has it.
fn about(model: Option<&Model>, name: &str) -> Option<String> {
    model?.process.effects().iter().find(|own| own.name == *name).map(|own| own.about.to_string())
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
    Some(json!({
        "version": version,
        "columns": all.given.iter().map(column).collect::<Vec<_>>(),
        "observables": all.observables.iter().map(|own| json!({ "name": &*own.name, "unit": own.kind.unit })).collect::<Vec<_>>(),
        "observable": (0..all.len()).map(|row| all.observable(row)).collect::<Vec<_>>(),
        "observed": (0..all.len()).map(|row| finite(kind(all, row).from_si(all.observed[row]))).collect::<Vec<_>>(),
        "predicted": found.map(|found| in_rows((all, &bench.struck), found.predicted.iter())),
        "sigma": found.map(|found| in_rows((all, &bench.struck), found.sigma.iter())),
        "lines": (0..all.len()).map(|row| all.line(row)).collect::<Vec<_>>(),
    }))
}

/// What a model predicts with values on trial of the rows that count, and what is left.
pub fn trial((all, struck): (&Measurements, &BTreeSet<usize>), predicted: &[f64], left: Option<f64>) -> Json {
    json!({ "predicted": in_rows((all, struck), predicted.iter()), "rms": left.map(finite) })
}

/// Values (SI) of the rows that count, each in its place among all and in its unit; null where one is struck out.
fn in_rows<'v>(
    (all, struck): (&Measurements, &BTreeSet<usize>),
    mut counted: impl Iterator<Item = &'v f64>,
) -> Vec<Json> {
    let own = |row: usize| match struck.contains(&row) {
        true => Json::Null,
        false => counted.next().map_or(Json::Null, |own| finite(kind(all, row).from_si(*own))),
    };
    (0..all.len()).map(own).collect()
}

/// Kind of what a row observes.
fn kind(all: &Measurements, row: usize) -> Kind {
    all.observables[all.observable(row)].kind
}
