//! The command `fem effects`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::input::{Problem, nearest};
use crate::output::{Detail, Report};
use crate::process::{self, Description, Process};

pub fn effects(args: &args::Effects) -> Result<(), Error> {
    let all: Vec<(&dyn Process, Description)> =
        process::ALL.iter().flat_map(|p| p.effects().into_iter().map(move |e| (*p, e))).collect();
    let name = args.name.as_deref();
    let of_process = name.is_none_or(|n| process::ALL.iter().any(|p| p.name() == n));
    let is_meant =
        |p: &dyn Process, e: &Description| name.is_none_or(|n| n == if of_process { p.name() } else { e.name });
    let chosen: Vec<_> = all.iter().filter(|(p, e)| is_meant(*p, e)).cloned().collect();
    if chosen.is_empty() {
        return Err(Error::Request(unknown(name.unwrap_or_default(), &all)));
    }
    let detail = if of_process { Detail::Line } else { Detail::Page };
    print(&page(&Report::Effects(&chosen, detail), args.json)?)
}

fn unknown(name: &str, all: &[(&dyn Process, Description)]) -> Problem {
    let names = all.iter().map(|(_, e)| e.name).chain(process::ALL.iter().map(|p| p.name()));
    let problem = Problem::new(format!("`{name}` is neither a process nor an effect"));
    match nearest(name, names) {
        Some(near) => problem.help(format!("did you mean `{near}`? `fem effects` lists all")),
        None => problem.help("`fem effects` lists all"),
    }
}
