//! Reads `[model]` and `[[input]]` of a budget file.

use std::cell::RefCell;

use super::{Input, ModelPart, Target};
use crate::budget::Law;
use crate::input::{Bounds, InputError, Reader, did_you_mean, nearest};
use crate::model::Model;
use crate::process::{Absent, Coordinate, Holds, Rows};
use crate::units::{Kind, Knowledge, MICRO, TEMPERATURE_RISE};

/// Largest model file, bytes.
const LARGEST: u64 = 4_000_000;

/// Reads the model of a budget and its inputs. The problems of a wrong model file go to `broken`.
pub fn read(reader: &Reader, broken: &RefCell<Option<InputError>>) -> Option<ModelPart> {
    let found = reader.optional_table("model", "a model that contributes a figure of its prediction", |t| {
        let file = t.file("file", "the model file", LARGEST);
        if file.is_none() && !t.has("file") {
            t.problem("", "`file` is missing in `model`", "add file = \"lathe.toml\"");
        }
        let loaded = file.and_then(|file| match file.text() {
            Ok(source) => Model::parse(source)
                .and_then(|m| m.require_values().map(|()| m))
                .map_err(|e| broken.replace(Some(e)))
                .ok(),
            Err(problem) => {
                t.problem("file", problem.message, problem.help.unwrap_or_default());
                None
            }
        });
        let observable = t.text("observable", "what is observed; the model's first length if left out");
        let Some(model) = loaded else {
            // Nothing more can be checked without the model.
            t.optional_table("at", "where and under which conditions it is observed", |t| t.accept_any());
            t.optional_table("less", "the same, taken off", |t| t.accept_any());
            return None;
        };
        let rows = read_rows(t, &model, observable.as_deref());
        Some((model, rows))
    });
    let Some((model, rows)) = found.flatten() else {
        reader.list("input", "what varies in the model", |t, _| t.accept_any());
        return None;
    };
    let own = reader
        .list("input", "what varies in the model, beside what it marks `+-`", |t, _| read_input(t, &model, &rows));
    let mut inputs: Vec<Input> = own.into_iter().flatten().collect();
    for (i, parameter) in model.parameters.iter().enumerate() {
        let Knowledge::Rough(std) = parameter.quantity.knowledge else { continue };
        if !inputs.iter().any(|input| input.target == Target::Parameter(i)) {
            inputs.push(Input {
                name: parameter.path.clone(),
                target: Target::Parameter(i),
                centre: parameter.quantity.value,
                half: Law::Normal.half_field(std),
                law: Law::Normal,
                bounds: parameter.bounds,
            });
        }
    }
    Some(ModelPart { model, rows, inputs })
}

/// Reads the observed row, and the one that is subtracted.
fn read_rows(t: &Reader, model: &Model, observable: Option<&str>) -> Rows {
    let observables = model.process.observables();
    let is_length = |kind: Kind| kind.canonical().dimension == MICRO.canonical().dimension;
    let lengths = || (0..observables.len()).filter(|i| is_length(observables[*i].error_kind()));
    let chosen = match observable {
        None => lengths().next(),
        Some(name) => lengths().find(|i| observables[*i].name == name),
    };
    if chosen.is_none() {
        let names: Vec<&str> = lengths().map(|i| observables[i].name).collect();
        let message = format!("`{}` observes no such length", model.process.name());
        t.problem("observable", message, format!("a budget adds lengths up; known are {}", names.join(", ")));
    }
    let coordinates = model.process.coordinates();
    let row = |t: &Reader| coordinates.iter().map(|c| read_coordinate(t, c)).collect::<Vec<f64>>();
    let first = t.table("at", "where and under which conditions it is observed", row);
    let less = t.optional_table("less", "where and under which conditions what is taken off is observed", row);
    let all = |i: usize| std::iter::once(first[i]).chain(less.iter().map(|l| l[i])).collect();
    let columns = (0..coordinates.len()).map(all).collect();
    let rows = Rows { columns, observable: vec![chosen.unwrap_or(0); 1 + usize::from(less.is_some())] };
    if t.is_sound() {
        for misplaced in model.system.misplaced(&rows) {
            t.problem(
                if misplaced.row == 0 { "at" } else { "less" },
                misplaced.message,
                "mend it, or let the model cover it",
            );
        }
    }
    rows
}

fn read_coordinate(t: &Reader, coordinate: &Coordinate) -> f64 {
    let Coordinate { name, about, holds, absent, .. } = *coordinate;
    let given = match holds {
        Holds::Quantity(kind) if absent == Absent::Refused => Some(t.quantity(name, kind, about).required()),
        Holds::Quantity(kind) => t.quantity(name, kind, about).optional(),
        Holds::Number(first) => t.count(name, about).between(first as usize, usize::MAX).optional().map(|n| n as f64),
        Holds::Word(words) => t.text(name, about).map(|word| match words.iter().position(|w| *w == word) {
            Some(position) => position as f64,
            None => {
                let listed: Vec<String> = words.iter().map(|w| format!("\"{w}\"")).collect();
                let meant = did_you_mean(&word, words.iter().copied(), '"');
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
        (None, Absent::Value(value)) => value,
        (None, _) => f64::NAN,
    }
}

fn read_input(t: &Reader, model: &Model, rows: &Rows) -> Option<Input> {
    let parameter = t.text("parameter", "path of a quantity that the model marks `+-`: effects.tool-wear.rate");
    let coordinate = t.text("coordinate", "a coordinate of the observed rows that varies: radial_force");
    let law = t.choice("distribution", "how it scatters", Law::WORDS).or_first(Law::Normal);
    match (parameter, coordinate) {
        (Some(path), None) => read_parameter(t, model, &path, law),
        (None, Some(name)) => read_varying(t, model, rows, &name, law),
        _ => {
            t.accept_any();
            t.problem("", "an input is a parameter or a coordinate", "give one of `parameter` and `coordinate`");
            None
        }
    }
}

fn read_parameter(t: &Reader, model: &Model, path: &str, law: Law) -> Option<Input> {
    let Some(i) = model.parameters.iter().position(|p| p.path == path) else {
        t.accept_any();
        let known = nearest(path, model.parameters.iter().map(|p| p.path.as_str()));
        let meant = known.map_or(String::new(), |near| format!("did you mean `{near}`? "));
        let message = format!("{} does not mark `{path}` as not exactly known", model.source.name);
        t.problem("parameter", message, format!("{meant}write it there as \"60 +- 5 N/um\" is written"));
        return None;
    };
    let known = &model.parameters[i];
    let Knowledge::Rough(std) = known.quantity.knowledge else { return None };
    let about = "half of its field; from the model's `+-` if left out";
    let half = t.quantity("half_field", spread(known.kind), about).not_negative().or(law.half_field(std));
    Some(Input {
        name: path.to_string(),
        target: Target::Parameter(i),
        centre: known.quantity.value,
        half,
        law,
        bounds: known.bounds,
    })
}

fn read_varying(t: &Reader, model: &Model, rows: &Rows, name: &str, law: Law) -> Option<Input> {
    let coordinates = model.process.coordinates();
    let quantities = || coordinates.iter().filter(|c| matches!(c.holds, Holds::Quantity(_)));
    let Some((column, Holds::Quantity(kind))) =
        coordinates.iter().position(|c| c.name == name).map(|i| (i, coordinates[i].holds))
    else {
        t.accept_any();
        let listed: Vec<&str> = quantities().map(|c| c.name).collect();
        let message = format!("`{name}` is no quantity under which `{}` is observed", model.process.name());
        t.problem("coordinate", message, format!("known are {}", listed.join(", ")));
        return None;
    };
    let usual = model.system.resolved(rows).columns[column][0];
    let centre = t.quantity("value", kind, "middle of its field; the model's if left out").or(usual);
    let half = t.quantity("half_field", spread(kind), "half of its field").not_negative().required();
    let ends = [centre - half, centre + half].map(|value| {
        let mut moved = rows.clone();
        moved.columns[column].fill(value);
        moved
    });
    if let Some(wrong) = ends.iter().filter(|_| t.is_sound()).find_map(|r| model.system.misplaced(r).into_iter().next())
    {
        t.problem("half_field", wrong.message, "narrow the field, or move its middle");
    }
    // A quantity that is above zero all over its field is so beyond it too.
    let bounds = if centre - half >= 0.0 { Bounds::NotNegative } else { Bounds::Any };
    Some(Input { name: name.to_string(), target: Target::Coordinate(column), centre, half, law, bounds })
}

/// Kind in which a field of this kind is written: that of a temperature is a difference.
fn spread(kind: Kind) -> Kind {
    if kind.canonical().offset == 0.0 { kind } else { TEMPERATURE_RISE }
}
