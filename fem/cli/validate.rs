//! The command `fem validate`.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::input::{Problem, nearest};
use crate::output::ValidationAnswer;
use crate::validation::{self, Case};

/// Sources that an error lists: those of most rows.
const LISTED: usize = 16;

pub fn validate(args: &args::Validate) -> Result<(), Error> {
    let all: Vec<Case> = validation::PARTS.par_iter().flat_map_iter(|(_, cases)| cases()).collect();
    let cases = match &args.source {
        Some(text) => all.iter().filter(|case| case.cites(text)).cloned().collect(),
        None => all.clone(),
    };
    if let (Some(text), true) = (&args.source, cases.is_empty()) {
        return Err(Error::from(unknown(text, &all)));
    }
    print(&page(&ValidationAnswer(&cases, all.len()), args.json))?;
    if cases.iter().all(Case::passed) { Ok(()) } else { Err(Error::Found) }
}

fn unknown(text: &str, all: &[Case]) -> Problem {
    let mut rows: BTreeMap<&str, usize> = BTreeMap::new();
    for case in all {
        *rows.entry(case.work()).or_default() += 1;
    }
    let mut works: Vec<(&str, usize)> = rows.into_iter().filter(|(work, _)| !work.is_empty()).collect();
    works.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let listed: Vec<String> = works.iter().take(LISTED).map(|(work, count)| format!("{work} ({count})")).collect();
    let meant = nearest(text, works.iter().map(|(work, _)| *work)).map(|near| format!("did you mean `{near}`? "));
    let further = works.len().saturating_sub(LISTED);
    Problem::new(format!("no case has a source that says `{text}`")).help(format!(
        "{}sources, with their cases: {}, and {further} more; `fem validate` shows every case with its source",
        meant.unwrap_or_default(),
        listed.join(", ")
    ))
}
