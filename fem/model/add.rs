//! One more effect in a model.

use super::formula_effect::{FORMULA, WORDS};
use super::{Edit, Entry, Model, change, effect_of};
use crate::input::{Name, Problem, did_you_mean};
use crate::noise::{Acts, MEASUREMENT, MeasurementEffect, Size, effects, observed, size};
use crate::process::{CHANGED, Description, EFFECTS, Parameter, change_of, is_size};
use crate::units::{Kind, Quantity};

/// A value for a key of an effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Name of the key.
    pub key: String,
    /// Value as it will stand in the model.
    pub value: Entry,
}

impl std::str::FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (key, value) = text.split_once('=').ok_or("write KEY=VALUE, as in 'rate=8 um/km'")?;
        Ok(Self { key: key.trim().into(), value: Entry::Text(value.trim().trim_matches('"').into()) })
    }
}

impl Setting {
    /// Refuses settings of which two have one key.
    ///
    /// # Errors
    /// The first key that is given again.
    pub fn check_once(all: &[Self]) -> Result<(), Problem> {
        let again = all.iter().enumerate().find(|(i, set)| all[..*i].iter().any(|other| other.key == set.key));
        again.map_or(Ok(()), |(_, set)| Err(Problem::new(format!("`{}` is given twice", set.key)).help("give it once")))
    }
}

/// The model with the effect `name`, of the process or of the measurement. Parameters without a setting are
/// unknown (`?`), except those that may be left out.
///
/// # Errors
/// The effect is unknown, present already, or does not fit; a setting is unknown or wrong.
pub fn add_effect(model: &Model, name: &str, settings: &[Setting]) -> Result<Model, Problem> {
    let (parent, keys) = match effects::named(name) {
        Some(effect) => (MEASUREMENT, of_measurement(model, name, effect, settings)?),
        None => (EFFECTS, of_process(model, name, settings)?),
    };
    model.edited(&[Edit::Add { parent, name: name.into(), keys }])
}

/// Keys of a table, with their values.
type Keys = Vec<(String, Entry)>;

fn of_process(model: &Model, name: &str, settings: &[Setting]) -> Result<Keys, Problem> {
    let is_own = model.process.effects().iter().all(|effect| effect.name != name);
    if is_own && settings.iter().any(|set| set.key == FORMULA) {
        return of_formula(model, name, settings);
    }
    let (effect, names) = match name.strip_suffix(CHANGED).and_then(|own| own.strip_suffix('.')) {
        Some(own) => change_to_add(model, own, settings)?,
        None => {
            let effect = effect_of(&*model.process, name)?;
            let names = effect.parameters.iter().map(|p| p.name.clone()).collect();
            (effect, names)
        }
    };
    if model.effects.iter().any(|e| e.description.name == effect.name) {
        return Err(present(name).help("edit its values in the file"));
    }
    if let Err(reason) = model.system.admits(name) {
        return Err(Problem::new(reason).help("choose an effect that can act in this model"));
    }
    let names: Vec<&str> = names.iter().map(|name| &**name).collect();
    check_settings(&effect.name, &names, settings, |Setting { key, value }| {
        let Some(parameter) = effect.parameters.iter().find(|p| p.name == *key) else { return Ok(()) };
        Quantity::parse(&value.to_string(), &parameter.kind).map(drop).map_err(|e| {
            let help = e.hint.unwrap_or_else(|| format!("write '{key}={}'", parameter.kind.example()));
            Problem::new(e.message).help(help)
        })
    })?;
    Ok(filled(&effect, settings))
}

/// Keys of an effect that is a formula: as they are given, for only the formula says what they are.
fn of_formula(model: &Model, name: &str, settings: &[Setting]) -> Result<Keys, Problem> {
    Setting::check_once(settings)?;
    if model.effects.iter().any(|e| e.description.name == name) {
        return Err(present(name).help("edit its values in the file, or choose another name"));
    }
    let is_name = name.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_') && !name.is_empty();
    if !is_name {
        let problem = Problem::new(format!("`{name}` is no name of an effect"));
        return Err(problem.help("use letters, digits and hyphens"));
    }
    // What is computed stands above what it is computed from.
    let (law, values): (Vec<&Setting>, Vec<&Setting>) = settings.iter().partition(|set| WORDS.contains(&&*set.key));
    let entry = |set: &&Setting| (set.key.clone(), set.value.clone());
    Ok(law.iter().chain(&values).map(entry).collect())
}

/// The change of an effect that the model has, in those of its parameters that are set, or in all that say how much
/// there is of it; also the keys that may be set.
fn change_to_add(model: &Model, name: &str, settings: &[Setting]) -> Result<(Description, Vec<Name>), Problem> {
    let Some(own) = model.effects.iter().find(|e| e.description.name == name) else {
        let problem = Problem::new(format!("the model has no effect `{name}` that could change"));
        return Err(problem.help(format!("add `{name}` first")));
    };
    let along = change::along(name, &*model.process)
        .map_err(|reason| Problem::new(reason).help("an effect that is the same throughout needs no change"))?;
    let whole = change_of(&own.description, along, |_| true);
    let names: Vec<Name> = whole.parameters.iter().map(|p| p.name.clone()).collect();
    let is_set = |p: &Parameter| settings.iter().any(|set| p.name == *set.key);
    let is_any_set = whole.parameters.iter().any(|p| !p.is_step && is_set(p));
    Ok((change_of(&own.description, along, |p| if is_any_set { is_set(p) } else { is_size(p) }), names))
}

fn of_measurement(
    model: &Model,
    name: &str,
    effect: &MeasurementEffect,
    settings: &[Setting],
) -> Result<Keys, Problem> {
    if model.has_measurement(name) {
        let other = model.free_table(effect.name, &[]);
        return Err(present(name).help(format!("edit its values in the file, or add another as `{other}`")));
    }
    let set = |key: &str| settings.iter().find(|s| s.key == key).map(|s| &s.value);
    let said = set("observable").map(Entry::to_string);
    let only = said.and_then(|o| model.process.observables().iter().position(|own| own.name == o));
    let of = observed(&*model.process, only);
    let keys = effect.all_keys();
    let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
    let sizes = effect.size_keys();
    let is_file = matches!(effect.size, Size::File(..));
    let is_size = |key: &str| !is_file && sizes.contains(&key);
    check_settings(name, &names, settings, |Setting { key, value }| match is_size(key) {
        true => {
            size(effect.sizes().find(|own| own.size.key() == key).unwrap_or(effect), &of, &value.to_string()).map(drop)
        }
        false => Ok(()),
    })?;
    // Of a sensor's characteristic what is not said is not there, and its curve asks for a range.
    let is_characteristic = matches!(effect.size, Size::OfReading(_));
    let is_any_set = sizes.iter().any(|key| set(key).is_some());
    let entry = |key: &str| {
        let Some(size) = effect.sizes().find(|own| own.size.key() == key && !is_file) else {
            return set(key).map(|value| written(value, false));
        };
        // Of a quantity of its own kind the unit is known.
        let (is_number, own) = match size.size {
            Size::Number(..) => (true, of.clone()),
            Size::Quantity(parameter) => (parameter.kind.unit.is_empty(), vec![(0, parameter.kind)]),
            Size::OfObservable(..) | Size::OfReading(_) | Size::File(..) => (false, of.clone()),
        };
        match set(key) {
            Some(value) => Some(written(value, is_number)),
            None if matches!(effect.acts, Acts::Weighs) => None,
            None if is_characteristic && (is_any_set || !matches!(key, "offset" | "scale")) => None,
            None => Some(Entry::Text(unknown(is_number, &own))),
        }
    };
    Ok(names.into_iter().filter_map(|key| Some((key.to_string(), entry(key)?))).collect())
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

/// Refuses settings of keys that `effect` does not have, that are given twice, or that `check` refuses.
fn check_settings(
    effect: &str,
    names: &[&str],
    settings: &[Setting],
    check: impl Fn(&Setting) -> Result<(), Problem>,
) -> Result<(), Problem> {
    Setting::check_once(settings)?;
    for setting in settings {
        let Setting { key, value } = setting;
        if !names.contains(&key.as_str()) {
            let meant = did_you_mean(key, names.iter().copied(), '`');
            let problem = Problem::new(format!("`{key}` is no parameter of `{effect}`"));
            return Err(problem.help(format!("{meant}its parameters are {}", names.join(", "))));
        }
        check(setting).map_err(|p| Problem { message: format!("{key}={value}: {}", p.message), ..p })?;
    }
    Ok(())
}

/// The keys of an effect of the process.
fn filled(effect: &Description, settings: &[Setting]) -> Keys {
    let set = |name: &str| settings.iter().find(|s| s.key == name);
    let kind = |name: &str| effect.parameters.iter().find(|p| p.name == name).map(|p| p.kind);
    let is_zero = |name: &str| {
        let value = set(name).zip(kind(name)).and_then(|(s, kind)| Quantity::parse(&s.value.to_string(), &kind).ok());
        value.is_none_or(|q| q == Quantity::known(0.0))
    };
    let entry = |parameter: &Parameter| match set(&parameter.name) {
        Some(setting) => Some(written(&setting.value, parameter.kind.unit.is_empty())),
        None if parameter.default.is_some() || parameter.needed_with.is_some_and(is_zero) => None,
        None => Some(Entry::Text(format!("? {}", parameter.kind.unit).trim_end().into())),
    };
    effect.parameters.iter().filter_map(|p| Some((p.name.to_string(), entry(p)?))).collect()
}

/// The entry as it stands in a model: known pure numbers stand without quotes.
fn written(entry: &Entry, pure: bool) -> Entry {
    match entry {
        Entry::Text(text) if pure => text.parse().map_or_else(|_| entry.clone(), Entry::Number),
        _ => entry.clone(),
    }
}
