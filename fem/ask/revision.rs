//! A model with other values.

use crate::input::{Problem, did_you_mean};
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
    let mut removed: Vec<Edit> = Vec::new();
    for name in without {
        let edit = removal(model, name)?;
        if !removed.contains(&edit) {
            removed.push(edit);
        }
    }
    if let Some(value) = values.iter().find(|value| removed.iter().any(|edit| is_within(&value.key, edit))) {
        let problem = Problem::new(format!("`{}` belongs to an effect that is left out", value.key));
        return Err(problem.help("set its value or leave it out"));
    }
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
    let is_text = model.written(key).is_some();
    let entry = if is_text { value.clone() } else { bare(value) };
    Edit::Set { path: key.as_str().into(), entry }
}

/// Whether a key stands in the table that an edit takes out.
fn is_within(key: &str, removal: &Edit) -> bool {
    let Edit::Remove { parent, name } = removal else { return false };
    key.strip_prefix(&format!("{parent}.{name}")).is_some_and(|rest| rest.starts_with('.'))
}

/// The edit that takes an effect out, by its name or by that of its table.
fn removal(model: &Model, name: &str) -> Result<Edit, Problem> {
    let of_process = model.effects.iter().map(|effect| (EFFECTS, effect.description.name.to_string()));
    let of_measurement = model.measurement.iter().map(|term| (MEASUREMENT, term.table.clone()));
    let all: Vec<(&'static str, String)> = of_process.chain(of_measurement).collect();
    let is_meant = |(parent, own): &&(&str, String)| own == name || format!("{parent}.{own}") == name;
    match &*all.iter().filter(is_meant).collect::<Vec<_>>() {
        [] => {}
        [(parent, own)] => return Ok(Edit::Remove { parent, name: own.clone() }),
        several => {
            let tables = several.iter().map(|(parent, own)| format!("{parent}.{own}")).collect::<Vec<_>>();
            let problem = Problem::new(format!("the model has two effects `{name}`"));
            return Err(problem.help(format!("write {}", tables.join(" or "))));
        }
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
