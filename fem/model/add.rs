//! Writes a model with one more effect; every comment and the order of the file are kept.

use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::{Model, effect_of};
use crate::input::{Problem, Source, did_you_mean};
use crate::noise::{Acts, MeasurementEffect, Size, effects, observed, size};
use crate::process::Description;
use crate::units::{Kind, Quantity};

/// A `KEY=VALUE` of the command line.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Name of the parameter.
    pub key: String,
    /// Text of the value as it will stand in the file, without quotes.
    pub value: String,
}

impl std::str::FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (key, value) = text.split_once('=').ok_or("write KEY=VALUE, as in 'rate=8 um/km'")?;
        Ok(Self { key: key.trim().into(), value: value.trim().trim_matches('"').into() })
    }
}

/// Adds the effect `name`, of the process or of the measurement, to a model; the source of the new model is the
/// text to write. Parameters without a setting are written as unknown (`?`), except those that may be left
/// out.
///
/// # Errors
/// The effect is unknown, present already, or does not fit; a setting is unknown or wrong.
pub fn add_effect(model: &Model, name: &str, settings: &[Setting]) -> Result<Model, Problem> {
    let text = match effects::named(name) {
        Some(effect) => with_measurement_effect(model, name, effect, settings)?,
        None => with_physical_effect(model, name, settings)?,
    };
    Model::parse(Source::new(model.source.name.clone(), text)).map_err(|e| {
        // The mistake stands in the request, not in the file.
        let problem = e.problems.into_iter().next().unwrap_or_else(|| Problem::new("the model would not be right"));
        problem.at(None)
    })
}

fn with_physical_effect(model: &Model, name: &str, settings: &[Setting]) -> Result<String, Problem> {
    let effect = effect_of(&*model.process, name)?;
    if model.effects.iter().any(|e| e.description.name == effect.name) {
        return Err(present(name).help("edit its values in the file"));
    }
    if let Err(reason) = model.system.admits(name) {
        return Err(Problem::new(reason).help("choose an effect that can act in this model"));
    }
    let names: Vec<&str> = effect.parameters.iter().map(|p| &*p.name).collect();
    check_settings(&effect.name, &names, settings, |Setting { key, value }| {
        let Some(parameter) = effect.parameters.iter().find(|p| p.name == *key) else { return Ok(()) };
        Quantity::parse(value, &parameter.kind).map(drop).map_err(|e| {
            let help = e.hint.unwrap_or_else(|| format!("write '{key}={}'", parameter.kind.example()));
            Problem::new(e.message).help(help)
        })
    })?;
    with_table(&model.source.text, "effects", name, |table| fill(table, &effect, settings))
}

fn with_measurement_effect(
    model: &Model,
    name: &str,
    effect: &MeasurementEffect,
    settings: &[Setting],
) -> Result<String, Problem> {
    if model.has_measurement(name) {
        let other = model.free_table(effect.name, &[]);
        return Err(present(name).help(format!("edit its values in the file, or add another as `{other}`")));
    }
    let set = |key: &str| settings.iter().find(|s| s.key == key).map(|s| &s.value);
    let only = set("observable").and_then(|o| model.process.observables().iter().position(|own| own.name == *o));
    let of = observed(&*model.process, only);
    let keys = effect.all_keys();
    let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
    let sizes = effect.size_keys();
    let is_file = matches!(effect.size, Size::File(..));
    let is_size = |key: &str| !is_file && sizes.contains(&key);
    check_settings(name, &names, settings, |Setting { key, value }| match is_size(key) {
        true => size(effect, &of, value).map(drop),
        false => Ok(()),
    })?;
    let is_number = match effect.size {
        Size::Number(..) => true,
        Size::Quantity(parameter) => parameter.kind.unit.is_empty(),
        Size::OfObservable(..) | Size::File(..) => false,
    };
    // Of a quantity of its own kind the unit is known.
    let own = match effect.size {
        Size::Quantity(parameter) => vec![(0, parameter.kind)],
        _ => of.clone(),
    };
    with_table(&model.source.text, "measurement", name, |table| {
        for key in names {
            let value = match set(key) {
                Some(value) => written(value, is_number && is_size(key)),
                None if !is_size(key) || matches!(effect.acts, Acts::Weighs) => continue,
                None => Value::from(unknown(is_number, &own)),
            };
            table.insert(key, Item::Value(value));
        }
    })
}

/// An unknown size; without its unit where it might be that of several observables.
fn unknown(is_number: bool, observed: &[(usize, Kind)]) -> String {
    match observed {
        [(_, first), others @ ..] if !is_number && others.iter().all(|(_, kind)| kind == first) => {
            format!("? {}", first.unit)
        }
        _ => "?".into(),
    }
}

fn present(name: &str) -> Problem {
    Problem::new(format!("the model has the effect `{name}` already"))
}

/// Writes a table within the table `parent` behind everything else, which stays byte for byte; an inline
/// `parent = { … }` is edited.
fn with_table(text: &str, parent: &str, name: &str, fill: impl FnOnce(&mut dyn TableLike)) -> Result<String, Problem> {
    let unreadable = |e: toml_edit::TomlError| Problem::new(e.message().to_string());
    let mut document: DocumentMut = text.parse().map_err(unreadable)?;
    if document.get(parent).is_some_and(Item::is_inline_table) {
        let mut table = InlineTable::new();
        fill(&mut table);
        if let Some(tables) = document[parent].as_table_like_mut() {
            tables.insert(name, Item::Value(Value::InlineTable(table)));
        }
        return Ok(document.to_string());
    }
    let mut table = Table::new();
    fill(&mut table);
    let gap = if text.is_empty() || text.ends_with('\n') { "\n" } else { "\n\n" };
    let added = format!("{gap}[{parent}.{name}]\n{table}");
    let crlf = text.contains("\r\n");
    Ok(format!("{text}{}", if crlf { added.replace('\n', "\r\n") } else { added }))
}

/// Refuses settings of keys that `effect` does not have, that are given twice, or that `check` refuses.
fn check_settings(
    effect: &str,
    names: &[&str],
    settings: &[Setting],
    check: impl Fn(&Setting) -> Result<(), Problem>,
) -> Result<(), Problem> {
    for (i, setting) in settings.iter().enumerate() {
        let Setting { key, value } = setting;
        if !names.contains(&key.as_str()) {
            let meant = did_you_mean(key, names.iter().copied(), '`');
            let problem = Problem::new(format!("`{key}` is no parameter of `{effect}`"));
            return Err(problem.help(format!("{meant}its parameters are {}", names.join(", "))));
        }
        if settings[..i].iter().any(|s| s.key == *key) {
            return Err(Problem::new(format!("`{key}` is given twice")).help("give it once"));
        }
        check(setting).map_err(|p| Problem { message: format!("{key}={value}: {}", p.message), ..p })?;
    }
    Ok(())
}

fn fill(table: &mut dyn TableLike, effect: &Description, settings: &[Setting]) {
    let set = |name: &str| settings.iter().find(|s| s.key == name);
    let kind = |name: &str| effect.parameters.iter().find(|p| p.name == name).map(|p| p.kind);
    let is_zero = |name: &str| {
        let value = set(name).zip(kind(name)).and_then(|(s, kind)| Quantity::parse(&s.value, &kind).ok());
        value.is_none_or(|q| q == Quantity::known(0.0))
    };
    for parameter in &*effect.parameters {
        let value = match set(&parameter.name) {
            Some(setting) => written(&setting.value, parameter.kind.unit.is_empty()),
            None if parameter.default.is_some() || parameter.needed_with.is_some_and(is_zero) => continue,
            None => Value::from(format!("? {}", parameter.kind.unit).trim_end()),
        };
        table.insert(&parameter.name, Item::Value(value));
    }
}

/// Makes the TOML value; known pure numbers stand without quotes.
fn written(value: &str, pure: bool) -> Value {
    let number = value.parse::<f64>().ok().filter(|_| pure);
    match number {
        Some(number) => Value::from(number),
        None => Value::from(value),
    }
}
