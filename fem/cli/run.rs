//! `fem run`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args;
use super::error::Error;
use super::{print, watch};
use crate::model::Model;
use crate::output::{json, text, write_run};
use crate::progress::Progress;

pub fn run(args: &args::Run) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    model.require_values()?;
    let progress = Arc::new(Progress::default());
    let bar = watch::show(&progress);
    let run = model.run(&progress)?;
    let directory = args.output.clone().unwrap_or_else(|| default_directory(&args.model));
    let written = write_run(&model, &run, &directory, &progress)?;
    bar.finish();
    for warning in &run.outcome.warnings {
        super::say!("warning: {warning}");
    }
    if args.json {
        return print(&format!("{:#}\n", json::run(&model, &run)));
    }
    let files: Vec<String> = written.iter().map(|f| format!("  {}", f.display())).collect();
    print(&format!("{}\nwritten\n{}\n", text::run(&model, &run), files.join("\n")))
}

/// `out/<model name>`.
fn default_directory(model: &Path) -> PathBuf {
    Path::new("out").join(model.file_stem().unwrap_or(model.as_os_str()))
}
