//! The command `fem effects`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::input::{Problem, nearest};
use crate::noise::{MEASUREMENT, MeasurementEffect, effects};
use crate::output::{Detail, Report, columns};
use crate::process::{self, Description, Process};

pub fn effects(args: &args::Effects) -> Result<(), Error> {
    print(&catalogue(args.name.as_deref(), args.json)?)
}

/// The catalogue, or what it has of a process or an effect, for people or as JSON.
///
/// # Errors
/// There is nothing of this name.
pub fn catalogue(name: Option<&str>, json: bool) -> Result<String, Error> {
    let all: Vec<(&dyn Process, Description)> =
        process::ALL.iter().flat_map(|p| p.effects().into_iter().map(move |e| (*p, e))).collect();
    let owners = || process::ALL.iter().map(|p| p.name()).chain([MEASUREMENT]);
    let of_owner = name.is_none_or(|n| owners().any(|owner| owner == n));
    let is_meant = |owner: &str, effect: &str| name.is_none_or(|n| n == if of_owner { owner } else { effect });
    let chosen: Vec<_> = all.iter().filter(|(p, e)| is_meant(p.name(), e.name)).cloned().collect();
    let of_measurement: Vec<&MeasurementEffect> = effects::all().filter(|e| is_meant(MEASUREMENT, e.name)).collect();
    if chosen.is_empty() && of_measurement.is_empty() {
        let names = all.iter().map(|(_, e)| e.name).chain(effects::all().map(|e| e.name)).chain(owners());
        return Err(Error::Request(unknown(name.unwrap_or_default(), names)));
    }
    let detail = if of_owner { Detail::Line } else { Detail::Page };
    let mut text = page(&Report::Effects(&chosen, &of_measurement, detail), json)?;
    let process = process::ALL.iter().find(|p| name == Some(p.name()));
    if let (Some(process), false) = (process, json) {
        text.push_str(&format!("\n{}", columns(*process)));
    }
    Ok(text)
}

fn unknown<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Problem {
    let problem = Problem::new(format!("`{name}` is neither a process nor an effect"));
    match nearest(name, names) {
        Some(near) => problem.help(format!("did you mean `{near}`? `fem effects` lists all")),
        None => problem.help("`fem effects` lists all"),
    }
}
