//! A model with other values.

use crate::input::{Problem, did_you_mean};
use crate::model::{Edit, Entry, Model, Setting};
use crate::noise::MEASUREMENT;
use crate::process::EFFECTS;

/// The model with values for some of its keys, named by their paths (`cut.depth`), and without some of its effects, of
/// the process or of the measurement.
///
/// # Errors
/// A key is given twice, the model has no such effect or table, or what comes of it is no model.
pub fn revised(model: &Model, values: &[Setting], without: &[String]) -> Result<Model, Problem> {
    Setting::check_once(values)?;
    let removed = without.iter().map(|name| removal(model, name)).collect::<Result<Vec<Edit>, Problem>>()?;
    let set = values.iter().map(|Setting { key, value }| {
        let is_text = model.written(key).is_some();
        let entry = if is_text { value.clone() } else { bare(value) };
        Edit::Set { path: key.as_str().into(), entry }
    });
    model.edited(&set.chain(removed).collect::<Vec<_>>())
}

/// The edit that takes an effect out, by its name or by that of its table.
fn removal(model: &Model, name: &str) -> Result<Edit, Problem> {
    let of_process = model.effects.iter().map(|effect| (EFFECTS, effect.description.name.to_string()));
    let of_measurement = model.measurement.iter().map(|term| (MEASUREMENT, term.table.clone()));
    let all: Vec<(&'static str, String)> = of_process.chain(of_measurement).collect();
    let is_meant = |(parent, own): &&(&str, String)| own == name || format!("{parent}.{own}") == name;
    if let Some((parent, own)) = all.iter().find(is_meant) {
        return Ok(Edit::Remove { parent, name: own.clone() });
    }
    let names = || all.iter().map(|(_, own)| own.as_str());
    let has = match all.is_empty() {
        true => "it has none".to_string(),
        false => format!("it has {}", names().collect::<Vec<_>>().join(", ")),
    };
    let meant = did_you_mean(name, names(), '`');
    Err(Problem::new(format!("the model has no effect `{name}`")).help(format!("{meant}{has}")))
}

/// A value where no text stands: numbers, whole or not, and yes and no are written without quotes.
fn bare(value: &Entry) -> Entry {
    let Entry::Text(text) = value else { return value.clone() };
    let whole = || text.parse().ok().map(Entry::Whole);
    let number = || text.parse().ok().map(Entry::Number);
    let flag = || text.parse().ok().map(Entry::Flag);
    whole().or_else(number).or_else(flag).unwrap_or_else(|| value.clone())
}
