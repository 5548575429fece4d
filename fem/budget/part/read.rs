//! Reads `[model]`, or several `[[model]]`, of a budget file.

use std::cell::RefCell;

use super::{Figure, ModelPart, Models, inputs};
use crate::budget::{Kind as Way, Law};
use crate::input::{InputError, Reader, did_you_mean};
use crate::model::Model;
use crate::process::{Absent, Coordinate, Holds, Rows, Values};
use crate::units::{FACTOR, Kind, MICRO};

/// Reads the models of a budget and their inputs. The problems of a wrong model file go to `broken`.
pub fn read(reader: &Reader, broken: &RefCell<Option<InputError>>) -> Models {
    let about = "models that contribute figures of their predictions";
    let parts = reader.one_or_list("model", about, |t, _| read_part(t, broken));
    let count = parts.len();
    let parts: Vec<ModelPart> = parts.into_iter().flatten().collect();
    if parts.is_empty() || parts.len() < count {
        // Nothing more can be checked without the models.
        reader.list("input", "what varies in the models", |t, _| t.accept_any());
        return Models { parts, inputs: Vec::new() };
    }
    for (i, part) in parts.iter().enumerate() {
        if parts[..i].iter().any(|other| other.name == part.name) {
            let message = format!("two models are called `{}`", part.name);
            reader.problem("model", message, "give each a `name` of its own");
        }
    }
    let inputs = inputs::read(reader, &parts);
    Models { parts, inputs }
}

fn read_part(t: &Reader, broken: &RefCell<Option<InputError>>) -> Option<ModelPart> {
    let name = t.text("name", "what its share is called; its file if left out");
    let kind = t.choice("kind", "how the figure adds; a random one is half of a field", Way::WORDS);
    let kind = if t.has("kind") { kind.or_first(Way::Random) } else { Way::Systematic };
    let law = Law::read(t, "law of a random figure over its field; uniform if unknown", Law::Uniform);
    if law.is_some() && kind == Way::Systematic {
        t.problem("distribution", "a systematic figure has no law", "add kind = \"random\", or let its inputs vary");
    }
    let factor = t.quantity("factor", FACTOR, "what the figure is multiplied by, as 0.5 makes half of a field");
    let factor = factor.or(1.0);
    let effect = t.text("effect", "the effect whose change alone is the figure, if it is not the whole prediction");
    let about = "the value at a place, or the spread, largest less smallest, over the model's own programme";
    let figure = t.choice("figure", about, Figure::WORDS).or_first(Figure::Difference);
    let loaded = Model::named(t, "file", "the model file", broken);
    let loaded = loaded.filter(|m| m.require_values().map_err(|e| broken.replace(Some(e))).is_ok());
    let observable = t.text("observable", "what is observed; the model's first length if left out");
    let Some(model) = loaded else {
        // Nothing more can be checked without the model.
        t.optional_table("at", "where and under which conditions it is observed", |t| t.accept_any());
        t.optional_table("less", "the same, taken off", |t| t.accept_any());
        return None;
    };
    let acting: Vec<&str> = model.effects.iter().map(|e| &*e.description.name).collect();
    if let Some(unknown) = effect.as_deref().filter(|name| !acting.contains(name)) {
        let meant = did_you_mean(unknown, acting.iter().copied(), '`');
        let message = format!("{} has no effect `{unknown}`", model.source.name);
        t.problem("effect", message, format!("{meant}it has {}", acting.join(", ")));
    }
    let observable = choose(t, &model, observable.as_deref());
    let rows = match figure {
        Figure::Difference => read_rows(t, &model, observable),
        Figure::Spread => read_programme(t, &model, observable),
    };
    let name = name.unwrap_or_else(|| model.source.name.to_string());
    let law = law.unwrap_or(Law::Uniform);
    Some(ModelPart { name, model, kind, law, factor, effect, rows, figure })
}

/// The observable of this name, or the first that is a length.
fn choose(t: &Reader, model: &Model, name: Option<&str>) -> usize {
    let observables = model.process.observables();
    let is_length = |kind: Kind| kind.canonical().dimension == MICRO.canonical().dimension;
    let lengths = || (0..observables.len()).filter(|i| is_length(observables[*i].error_kind()));
    let chosen = match name {
        None => lengths().next(),
        Some(name) => lengths().find(|i| observables[*i].name == name),
    };
    if chosen.is_none() {
        let names: Vec<&str> = lengths().map(|i| &*observables[i].name).collect();
        let message = format!("`{}` observes no such length", model.process.name());
        t.problem("observable", message, format!("a budget adds lengths up; known are {}", names.join(", ")));
    }
    chosen.unwrap_or(0)
}

/// Reads the observed row, and the one that is subtracted.
fn read_rows(t: &Reader, model: &Model, observable: usize) -> Rows {
    let coordinates = model.process.coordinates();
    let row = |t: &Reader| coordinates.iter().map(|c| read_coordinate(t, c, true)).collect::<Vec<f64>>();
    let first = t.table("at", "where and under which conditions it is observed", row);
    let less = t.optional_table("less", "where and under which conditions what is taken off is observed", row);
    let all = |i: usize| std::iter::once(first[i]).chain(less.iter().map(|l| l[i])).collect();
    let columns = (0..coordinates.len()).map(all).collect();
    let rows = Rows { columns, observable: Values::shared(observable, 1 + usize::from(less.is_some())) };
    check(t, model, &rows, |row| if row == 0 { "at" } else { "less" });
    rows
}

/// Reads the rows over which a figure is a spread: those of the model's programme with the given numbers and
/// words, under the given conditions.
fn read_programme(t: &Reader, model: &Model, observable: usize) -> Rows {
    let coordinates = model.process.coordinates();
    let row = |t: &Reader| coordinates.iter().map(|c| read_coordinate(t, c, false)).collect::<Vec<f64>>();
    let given = t.optional_table("at", "which part of the programme, and under which conditions", row);
    let mut rows = model.open_programme();
    let given = given.unwrap_or_else(|| vec![f64::NAN; coordinates.len()]);
    let is_kept = |row: usize| {
        let same = |column: usize| {
            let quantity = matches!(coordinates[column].holds, Holds::Quantity(_));
            quantity || given[column].is_nan() || rows.columns[column][row] == given[column]
        };
        rows.observable[row] == observable && (0..given.len()).all(same)
    };
    let kept: Vec<usize> = (0..rows.len()).filter(|row| is_kept(*row)).collect();
    for (column, value) in rows.columns.iter_mut().zip(&given) {
        *column = kept.iter().map(|row| column[*row]).collect();
        if !value.is_nan() {
            column.fill(*value);
        }
    }
    rows.observable = Values::shared(observable, kept.len());
    if kept.is_empty() && t.is_sound() {
        let help = "leave `observable` out, or name a part, a state, a branch that the model has";
        t.problem("at", format!("the programme of {} has no such rows", model.source.name), help);
    }
    check(t, model, &rows, |_| "at");
    rows
}

fn check(t: &Reader, model: &Model, rows: &Rows, key: impl Fn(usize) -> &'static str) {
    if t.is_sound() {
        for misplaced in model.system.misplaced(rows) {
            t.problem(key(misplaced.row), misplaced.message, "mend it, or let the model cover it");
        }
    }
}

/// Reads a coordinate; one that the programme runs over is not asked for.
fn read_coordinate(t: &Reader, coordinate: &Coordinate, is_needed: bool) -> f64 {
    let Coordinate { name, about, holds, absent, .. } = coordinate;
    let about = *about;
    let is_place = matches!(absent, Absent::Refused | Absent::NeededBut(_));
    let given = match holds {
        Holds::Quantity(_) if is_place && !is_needed => None,
        Holds::Quantity(kind) if is_place => Some(t.quantity(name.clone(), *kind, about).required()),
        Holds::Quantity(kind) => t.quantity(name.clone(), *kind, about).optional(),
        Holds::Number(first) => {
            t.count(name.clone(), about).between(*first as usize, usize::MAX).optional().map(|n| n as f64)
        }
        Holds::Word(words) => t.text(name.clone(), about).map(|word| match words.position(&word) {
            Some(position) => position as f64,
            None => {
                let listed: Vec<String> = words.iter().map(|w| format!("\"{w}\"")).collect();
                let meant = did_you_mean(&word, words.iter(), '"');
                t.problem(
                    name,
                    format!("`{name}` is \"{word}\""),
                    format!("{meant}it must be one of {}", listed.join(", ")),
                );
                f64::NAN
            }
        }),
    };
    match (given, absent) {
        (Some(value), _) => value,
        (None, Absent::Value(value)) if is_needed => *value,
        (None, _) => f64::NAN,
    }
}
