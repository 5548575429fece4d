//! A model with other values.

use crate::input::{Problem, Raw, did_you_mean};
use crate::model::{Edit, Entry, Model, Setting};
use crate::noise::MEASUREMENT;
use crate::process::EFFECTS;

/// The model with values for some of its keys, named by their paths (`cut.depth`), and without some of its effects, of
/// the process or of the measurement.
///
/// # Errors
/// A key is given twice or belongs to an effect that is left out, the model has no such effect or table or two of the
/// name, or what comes of it is no model.
pub fn revised(model: &Model, values: &[Setting], without: &[String]) -> Result<Model, Problem> {
    Setting::check_once(values)?;
    let tables = effect_tables(model);
    let mut left_out =
        without.iter().map(|name| meant(&tables, name)).collect::<Result<Vec<&EffectTable>, Problem>>()?;
    left_out.sort_unstable();
    left_out.dedup();
    let is_left_out = |value: &&Setting| owner(&tables, &value.key).is_some_and(|table| left_out.contains(&table));
    if let Some(value) = values.iter().find(is_left_out) {
        let problem = Problem::new(format!("`{}` belongs to an effect that is left out", value.key));
        return Err(problem.help("set its value or leave it out"));
    }
    let removed: Vec<Edit> =
        left_out.into_iter().map(|(parent, name)| Edit::Remove { parent, name: name.clone() }).collect();
    let set: Vec<Edit> = values.iter().map(|value| entering(model, value)).collect();
    model.edited(&[&*set, &*removed].concat()).map_err(|problem| {
        // The value that is wrong for itself is the one to name.
        let is_wrong = |edit: &Edit| model.edited(std::slice::from_ref(edit)).err().as_ref() == Some(&problem);
        let wrong = set.iter().position(is_wrong);
        let Some(Setting { key, value }) = wrong.map(|wrong| &values[wrong]) else { return problem };
        Problem { message: format!("{key}={value}: {}", problem.message), ..problem }
    })
}

/// The edit that puts a value into the model.
fn entering(model: &Model, Setting { key, value }: &Setting) -> Edit {
    let path = key.as_str().into();
    if model.written(key).is_some() {
        return Edit::Set { path, entry: value.clone() };
    }
    // A list or a table is written as the file writes it.
    if let Entry::Text(text) = value
        && text.trim_start().starts_with(['[', '{'])
        && let Some(value) = Raw::parse(text)
    {
        return Edit::Write { path, value };
    }
    Edit::Set { path, entry: bare(value) }
}

/// The table of an effect: the one in which it stands, and its own name there.
type EffectTable = (&'static str, String);

/// The tables of all effects of a model, of the process and of the measurement.
fn effect_tables(model: &Model) -> Vec<EffectTable> {
    let of_process = model.effects.iter().map(|effect| (EFFECTS, effect.description.name.to_string()));
    let of_measurement = model.measurement.iter().map(|term| (MEASUREMENT, term.table.clone()));
    of_process.chain(of_measurement).collect()
}

/// The table of an effect in which a key stands. Names may have dots: of those that the key begins with, the longest.
fn owner<'t>(tables: &'t [EffectTable], key: &str) -> Option<&'t EffectTable> {
    let has_key = |(parent, name): &&EffectTable| key.starts_with(&format!("{parent}.{name}."));
    tables.iter().filter(has_key).max_by_key(|(_, name)| name.len())
}

/// The table that is meant by an effect's name or by that of its table.
fn meant<'t>(tables: &'t [EffectTable], name: &str) -> Result<&'t EffectTable, Problem> {
    let path = |(parent, own): &EffectTable| format!("{parent}.{own}");
    match &*tables.iter().filter(|table| table.1 == name || path(table) == name).collect::<Vec<_>>() {
        [] => Err(unknown(tables, name)),
        [table] => Ok(table),
        several => {
            let tables = several.iter().map(|table| path(table)).collect::<Vec<_>>().join(" or ");
            Err(Problem::new(format!("the model has two effects `{name}`")).help(format!("write {tables}")))
        }
    }
}

/// Says that a model has no effect of a name.
fn unknown(tables: &[EffectTable], name: &str) -> Problem {
    let names = || tables.iter().map(|(_, own)| own.as_str());
    let has = match tables.is_empty() {
        true => "it has none".to_string(),
        false => format!("it has {}", names().collect::<Vec<_>>().join(", ")),
    };
    let meant = did_you_mean(name, names(), '`');
    Problem::new(format!("the model has no effect `{name}`")).help(format!("{meant}{has}"))
}

/// A value where no text stands: numbers, whole or not, and yes and no are written without quotes.
fn bare(value: &Entry) -> Entry {
    let Entry::Text(text) = value else { return value.clone() };
    let whole = || text.parse().ok().map(Entry::Whole);
    let number = || text.parse().ok().map(Entry::Number);
    let flag = || text.parse().ok().map(Entry::Flag);
    whole().or_else(number).or_else(flag).unwrap_or_else(|| value.clone())
}
