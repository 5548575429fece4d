//! Writes a model with one more effect; every comment and the order of the file are kept.

use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::{Model, effect_of};
use crate::input::{Problem, Source, did_you_mean};
use crate::process::Description;
use crate::units::Quantity;

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

/// Adds the effect `name` to a model; the source of the new model is the text to write. Parameters without a
/// setting are written as unknown (`?`), except those that may be left out.
///
/// # Errors
/// The effect is unknown, present already, or does not fit; a setting is unknown or wrong.
pub fn add_effect(model: &Model, name: &str, settings: &[Setting]) -> Result<Model, Problem> {
    let effect = effect_of(model.process, name)?;
    if model.effects.iter().any(|e| e.description.name == effect.name) {
        let problem = Problem::new(format!("the model has the effect `{name}` already"));
        return Err(problem.help("edit its values in the file"));
    }
    if let Err(reason) = model.system.admits(name) {
        return Err(Problem::new(reason).help("choose an effect that can act in this model"));
    }
    check_settings(&effect, settings)?;
    let text = with_effect(&model.source.text, &effect, settings)?;
    Model::parse(Source::new(model.source.name.clone(), text)).map_err(|e| {
        // The mistake stands in the request, not in the file.
        let problem = e.problems.into_iter().next().unwrap_or_else(|| Problem::new("the model would not be right"));
        problem.at(None)
    })
}

/// Writes the effect as a table behind everything else, which stays byte for byte; an inline `effects = { …
/// }` is edited.
fn with_effect(text: &str, effect: &Description, settings: &[Setting]) -> Result<String, Problem> {
    let unreadable = |e: toml_edit::TomlError| Problem::new(e.message().to_string());
    let mut document: DocumentMut = text.parse().map_err(unreadable)?;
    if document.get("effects").is_some_and(Item::is_inline_table) {
        let mut table = InlineTable::new();
        fill(&mut table, effect, settings);
        if let Some(effects) = document["effects"].as_table_like_mut() {
            effects.insert(effect.name, Item::Value(Value::InlineTable(table)));
        }
        return Ok(document.to_string());
    }
    let mut table = Table::new();
    fill(&mut table, effect, settings);
    let gap = if text.is_empty() || text.ends_with('\n') { "\n" } else { "\n\n" };
    let added = format!("{gap}[effects.{}]\n{table}", effect.name);
    let crlf = text.contains("\r\n");
    Ok(format!("{text}{}", if crlf { added.replace('\n', "\r\n") } else { added }))
}

fn check_settings(effect: &Description, settings: &[Setting]) -> Result<(), Problem> {
    for (i, Setting { key, value }) in settings.iter().enumerate() {
        let names = || effect.parameters.iter().map(|p| p.name);
        let Some(parameter) = effect.parameters.iter().find(|p| p.name == key) else {
            let meant = did_you_mean(key, names(), '`');
            let listed = names().collect::<Vec<_>>().join(", ");
            let problem = Problem::new(format!("`{key}` is no parameter of `{}`", effect.name));
            return Err(problem.help(format!("{meant}its parameters are {listed}")));
        };
        if settings[..i].iter().any(|s| s.key == *key) {
            return Err(Problem::new(format!("`{key}` is given twice")).help("give it once"));
        }
        if let Err(e) = Quantity::parse(value, &parameter.kind) {
            let problem = Problem::new(format!("{key}={value}: {}", e.message));
            return Err(problem.help(e.hint.unwrap_or_else(|| format!("write '{key}={}'", parameter.kind.example()))));
        }
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
        let value = match set(parameter.name) {
            Some(setting) => written(&setting.value, parameter.kind.unit.is_empty()),
            None if parameter.default.is_some() || parameter.needed_with.is_some_and(is_zero) => continue,
            None => Value::from(format!("? {}", parameter.kind.unit).trim_end()),
        };
        table.insert(parameter.name, Item::Value(value));
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
