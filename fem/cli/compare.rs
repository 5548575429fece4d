//! `fem compare`.

use std::path::Path;

use super::args;
use super::error::Error;
use super::print;
use crate::compare::{Comparison, compare};
use crate::input::{InputError, Problem, Source};
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::{self, comparison};

pub fn run(args: &args::Compare) -> Result<(), Error> {
    let models: Vec<Model> = args.models.iter().map(|path| Model::load(path)).collect::<Result<_, InputError>>()?;
    let Some(first) = models.first() else { return Ok(()) };
    let process = first.process;
    if let Some(other) = models.iter().find(|m| m.process.name() != process.name()) {
        let message = format!(
            "{} models {}, {} models {}",
            first.source.name,
            process.name(),
            other.source.name,
            other.process.name()
        );
        return Err(Error::Request(Problem::new(message).help("compare models of one process")));
    }
    for model in &models {
        model.require_values()?;
    }
    let measurements = Measurements::load(&args.with, process)?;
    let mut comparisons = Vec::new();
    for model in &models {
        check_places(model, &measurements, &args.with)?;
        comparisons.push(compare(model, &measurements)?);
    }
    if let Some(directory) = &args.output {
        write(directory, &args.with, &measurements, &models, &comparisons)?;
    }
    for note in &measurements.notes {
        super::say!("note: {note}");
    }
    if args.json {
        return print(&format!("{:#}\n", comparison::json(process, &measurements, &comparisons)));
    }
    print(&comparison::text(process, &measurements, &comparisons))
}

/// Refuses rows off the model's body or beyond its programme.
pub fn check_places(model: &Model, measurements: &Measurements, path: &Path) -> Result<(), Error> {
    let misplaced = model.system.misplaced(&measurements.rows);
    if misplaced.is_empty() {
        return Ok(());
    }
    let problem = |m: &crate::process::Misplaced| {
        let line = measurements.lines[m.row];
        Problem::new(format!("line {line}: {}", m.message)).help("mend the row, or let the model cover it")
    };
    let source = Source::new(path.display().to_string(), "");
    Err(InputError { source, problems: misplaced.iter().take(20).map(problem).collect() }.into())
}

/// Into `DIR`, or `DIR/<stem>` where there are several models.
fn write(
    directory: &Path,
    data: &Path,
    measurements: &Measurements,
    models: &[Model],
    comparisons: &[Comparison],
) -> Result<(), Error> {
    for (i, (model, comparison)) in models.iter().zip(comparisons).enumerate() {
        let stem = stem_of(model);
        if models[..i].iter().any(|other| stem_of(other) == stem) {
            let problem = Problem::new(format!("two models are called {}", stem.display()));
            return Err(Error::Request(problem.help("rename one of them, or compare them without -o")));
        }
        let folder = if models.len() > 1 { directory.join(stem) } else { directory.to_path_buf() };
        super::add::refuse_itself(data, &folder.join("residuals.csv"))?;
        output::write_comparison(model, measurements, comparison, &folder)?;
    }
    Ok(())
}

/// The name of a model's file without its folder and ending.
fn stem_of(model: &Model) -> std::ffi::OsString {
    Path::new(&*model.source.name).file_stem().unwrap_or_default().to_os_string()
}
