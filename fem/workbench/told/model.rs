//! The model: what it says, what it could say, what acts in it.

use std::collections::HashSet;

use serde_json::{Value as Json, json};

use super::super::bench::Bench;
use crate::input::{Parameter, name_and_unit};
use crate::model::{Holds, Key, List, Model, Outline};
use crate::output::{all_columns, finite};
use crate::process;
use crate::units::{Knowledge, Unit, unit_text};

/// The model with its text: its values, its effects, those that it could have.
pub fn model(bench: &Bench, text: &str, is_saved: bool) -> Json {
    let Some(model) = &bench.model else { return Json::Null };
    let has = |name: &str| model.effects.iter().any(|own| own.description.name == *name);
    let effect = |name: &str, about: &str| json!({ "name": name, "about": about });
    let own = model.effects.iter().map(|own| effect(&own.description.name, &own.description.about));
    let of_measurement = model.measurement.iter().map(|term| effect(&term.table, term.effect.about));
    let catalogue = model.process.effects();
    let absent = catalogue.iter().filter(|own| !has(&own.name) && model.system.admits(&own.name).is_ok());
    let outline = model.outline();
    json!({
        "file": bench.file,
        "title": model.title,
        "process": model.process.name(),
        "about": model.process.about(),
        "is_saved": is_saved,
        "text": text,
        "figures": bench.drawn,
        "values": values(model, &outline),
        "lists": outline.lists.iter().map(list).collect::<Vec<_>>(),
        "absent": outline.absent.iter().map(key).collect::<Vec<_>>(),
        "columns": columns(model),
        "has_settings": !model.settings.is_empty(),
        "effects": own.chain(of_measurement).collect::<Vec<_>>(),
        "catalogue": absent.map(|own| effect(&own.name, &own.about)).collect::<Vec<_>>(),
    })
}

/// Everything that has a value, in the order of the file.
fn values(model: &Model, outline: &Outline) -> Vec<Json> {
    let quantity = |path: &str| model.quantity(path);
    let listed: HashSet<&str> = outline.keys.iter().map(|own| &*own.path).collect();
    let of_outline = outline.keys.iter().map(|own| match quantity(&own.path) {
        Some(quantity) => value(model, quantity, &own.about),
        None => word(model, own),
    });
    // Those of formulas, and of effects of the measurement.
    let others = model.quantities.iter().filter(|own| !listed.contains(&*own.path));
    of_outline.chain(others.map(|own| value(model, own, ""))).collect()
}

fn parted(path: &str) -> (&str, &str) {
    path.rsplit_once('.').unwrap_or(("", path))
}

/// A word, a text, a number of things, a yes or no.
fn word(model: &Model, own: &Key) -> Json {
    let (group, key) = parted(&own.path);
    json!({
        "path": own.path,
        "group": group,
        "key": key,
        "text": model.raw(&own.path).map(|raw| raw.to_string()),
        "kind": kind(own),
        "choices": (!own.choices.is_empty()).then_some(&own.choices),
        "value": null,
        "unit": "",
        "std": null,
        "knowledge": "known",
        "about": own.about,
        "range": null,
        "source": null,
    })
}

fn kind(own: &Key) -> &'static str {
    match own.holds {
        Holds::Text if own.choices.is_empty() => "text",
        Holds::Text => "word",
        Holds::Number => "number",
        Holds::Flag => "flag",
        Holds::Table => "table",
    }
}

/// A quantity, in the unit in which it is written.
fn value(model: &Model, own: &Parameter, about: &str) -> Json {
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
    let (group, key) = parted(&own.path);
    let about = entry.map(|p| p.about.to_string()).or((!about.is_empty()).then(|| about.to_string()));
    json!({
        "path": own.path.to_string(),
        "group": group,
        "key": key,
        "text": text,
        "kind": "quantity",
        "choices": null,
        "value": finite(shown(own.quantity.value)),
        "unit": symbol,
        "std": std,
        "knowledge": knowledge,
        "about": about,
        "range": range,
        "source": effect.map(|e| e.description.source),
    })
}

/// The unit in which a value is written, or else the usual one; with its symbol.
pub fn unit_of<'m>(model: &'m Model, parameter: &'m Parameter) -> (Unit, &'m str) {
    let written = model.written(&parameter.path).map(unit_text);
    let own = written.and_then(|name| Some((parameter.kind.unit_of(name).ok()?, name)));
    own.unwrap_or((parameter.kind.canonical(), &parameter.kind.unit))
}

/// A list of tables.
fn list(own: &List) -> Json {
    let column = |own: &Key| {
        json!({
            "key": own.path,
            "about": own.about,
            "choices": (!own.choices.is_empty()).then_some(&own.choices),
            "needed": own.is_needed,
            "example": own.example,
        })
    };
    let keys: Vec<Json> = own.keys.iter().map(column).collect();
    json!({ "path": own.path, "about": own.about, "keys": keys, "rows": own.rows })
}

/// A key that the model could have.
fn key(own: &Key) -> Json {
    let choices = (!own.choices.is_empty()).then_some(&own.choices);
    json!({ "path": own.path, "about": own.about, "example": own.example, "choices": choices })
}

/// The columns that measurements may have.
fn columns(model: &Model) -> Vec<Json> {
    let coordinates = model.process.coordinates();
    let column = |(heading, about): (String, String)| {
        let (name, unit) = name_and_unit(&heading);
        let words = coordinates.iter().find(|own| own.name == name).and_then(|own| match &own.holds {
            process::Holds::Word(words) => Some(words.iter().map(ToString::to_string).collect::<Vec<_>>()),
            _ => None,
        });
        json!({ "name": name, "unit": unit, "about": about, "words": words })
    };
    all_columns(&*model.process).into_iter().map(column).collect()
}
