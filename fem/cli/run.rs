//! The command `fem run`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{page, print};
use super::watch::watched;
use crate::model::Model;
use crate::output::files::Guard;
use crate::output::{Folder, Format, Pictures, Report};
use crate::progress::Progress;

pub fn run(args: &args::Run) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    model.require_part()?;
    let progress = Arc::new(Progress::default());
    let run = watched(&progress, || model.run(&progress))?;
    let report = Report::Run(&model, &run);
    let directory = args.output.clone().unwrap_or_else(|| default_directory(&args.model));
    let guard = Guard { reads: &[], force: args.force };
    let written = match &args.plot {
        Some(directory) => Pictures { directory, guard: Guard { reads: &model.paths(), ..guard } }.write(&report)?,
        None => {
            let folder = Folder { directory: &directory, guard, progress: &progress };
            watched(&progress, || folder.write(&report))?
        }
    };
    for warning in &run.report.warnings {
        say!("warning: {warning}");
    }
    let list = if args.json { String::new() } else { written };
    print(&(page(&report, args.json)? + &list))
}

/// Directory `out/<model name>`.
fn default_directory(model: &Path) -> PathBuf {
    let stem = model.file_stem().filter(|stem| !stem.to_string_lossy().bytes().all(|byte| byte == b'.'));
    Path::new("out").join(stem.unwrap_or("model".as_ref()))
}
