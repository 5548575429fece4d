//! `fem effects`.

use serde_json::Value as Json;

use super::args;
use super::error::Error;
use super::print;
use crate::input::{Problem, nearest};
use crate::output::{json, text};
use crate::process::{self, Description, Process};

pub fn effects(args: &args::Effects) -> Result<(), Error> {
    let all: Vec<(&dyn Process, &Description)> =
        process::ALL.iter().flat_map(|p| p.effects().into_iter().map(move |e| (*p, e))).collect();
    let name = args.name.as_deref();
    let of_process = name.is_none_or(|n| process::ALL.iter().any(|p| p.name() == n));
    let chosen: Vec<_> =
        all.iter().filter(|(p, e)| name.is_none_or(|n| if of_process { p.name() == n } else { e.name == n })).collect();
    if chosen.is_empty() {
        return Err(Error::Request(unknown(name.unwrap_or_default(), &all)));
    }
    if args.json {
        let entries: Vec<Json> = chosen.iter().map(|(p, e)| json::effect(*p, e)).collect();
        return print(&format!("{:#}\n", Json::Array(entries)));
    }
    if !of_process {
        let pages: Vec<String> = chosen.iter().map(|(p, e)| text::effect(p.name(), e)).collect();
        return print(&pages.join("\n"));
    }
    let mut page = String::new();
    for process in process::ALL.iter().filter(|p| chosen.iter().any(|(c, _)| c.name() == p.name())) {
        page.push_str(&format!("{}: {}\n", process.name(), process.about()));
        for (_, effect) in chosen.iter().filter(|(p, _)| p.name() == process.name()) {
            page.push_str(&text::effect_line(effect));
            page.push('\n');
        }
    }
    print(&format!("{page}\n`fem effects NAME` tells all about one of them\n"))
}

fn unknown(name: &str, all: &[(&dyn Process, &Description)]) -> Problem {
    let names = all.iter().map(|(_, e)| e.name).chain(process::ALL.iter().map(|p| p.name()));
    let problem = Problem::new(format!("`{name}` is neither a process nor an effect"));
    match nearest(name, names) {
        Some(near) => problem.help(format!("did you mean `{near}`? `fem effects` lists all")),
        None => problem.help("`fem effects` lists all"),
    }
}
