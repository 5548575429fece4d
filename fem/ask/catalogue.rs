//! The catalogue of effects.

use super::Error;
use crate::input::{Problem, nearest};
use crate::noise::{MEASUREMENT, effects};
use crate::output::CatalogueAnswer;
use crate::process::{Description, Process};
use crate::processes;

/// The catalogue, or what it has of a process or an effect.
///
/// # Errors
/// There is nothing of this name.
pub fn catalogue(name: Option<&str>) -> Result<CatalogueAnswer, Error> {
    let all: Vec<(&'static dyn Process, Description)> =
        processes::ALL.iter().flat_map(|p| p.effects().into_iter().map(move |e| (*p, e))).collect();
    let owners = || processes::ALL.iter().map(|p| p.name()).chain([MEASUREMENT]);
    let of_owner = name.is_none_or(|n| owners().any(|owner| owner == n));
    let is_meant = |owner: &str, effect: &str| name.is_none_or(|n| n == if of_owner { owner } else { effect });
    let chosen: Vec<_> = all.iter().filter(|(p, e)| is_meant(p.name(), &e.name)).cloned().collect();
    let of_measurement: Vec<_> = effects::all().filter(|e| is_meant(MEASUREMENT, e.name)).collect();
    if chosen.is_empty() && of_measurement.is_empty() {
        let names = all.iter().map(|(_, e)| &*e.name).chain(effects::all().map(|e| e.name)).chain(owners());
        return Err(unknown(name.unwrap_or_default(), names).into());
    }
    let process = processes::ALL.iter().copied().find(|p| name == Some(p.name()));
    Ok(CatalogueAnswer { effects: chosen, of_measurement, is_list: of_owner, process })
}

fn unknown<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Problem {
    let problem = Problem::new(format!("`{name}` is neither a process nor an effect"));
    match nearest(name, names) {
        Some(near) => problem.help(format!("did you mean `{near}`? `fem effects` lists all")),
        None => problem.help("`fem effects` lists all"),
    }
}
