//! The command `fem run`.

use std::sync::Arc;

use super::args;
use super::data::default_directory;
use super::error::Error;
use super::say::say;
use super::terminal::{page, print};
use super::watch::watched;
use crate::ask;
use crate::model::Model;
use crate::output::files::Guard;
use crate::output::{Folder, RunAnswer};
use crate::progress::Progress;

pub fn run(args: &args::Run) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    model.require_part()?;
    let progress = Arc::new(Progress::default());
    let (mut run, band) = watched(&progress, || ask::run(&model, &progress))?;
    let thinned = run.report.animations.into_iter().map(|own| own.thinned(args.frames as usize)).collect();
    run.report.animations = thinned;
    let answer = RunAnswer(&model, &run, band.as_ref());
    let directory = args.output.clone().unwrap_or_else(|| default_directory(&args.model, "model"));
    let reads = model.paths();
    let guard = Guard { reads: &reads, force: args.force };
    let written = match &args.plot {
        Some(directory) => Folder { directory, guard }.write_figures(&answer)?,
        None => watched(&progress, || Folder { directory: &directory, guard }.write("run", &answer, &progress))?,
    };
    for warning in &run.report.warnings {
        say!("warning: {warning}");
    }
    let list = if args.json { String::new() } else { written };
    print(&(page(&answer, args.json) + &list))
}
