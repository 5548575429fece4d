//! `fem compare`.

use std::path::PathBuf;

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::compare::compare;
use crate::input::{InputError, Problem};
use crate::model::{Data, Model};
use crate::output::files::Guard;
use crate::output::{Folder, Format, Pictures, Report};
use crate::progress::Progress;

pub fn run(args: &args::Compare) -> Result<(), Error> {
    let models: Vec<Model> = args.models.iter().map(|path| Model::load(path)).collect::<Result<_, InputError>>()?;
    let Some(first) = models.first() else { return Ok(()) };
    let process = first.process;
    refuse_mixed(&models)?;
    for model in &models {
        model.require_values()?;
    }
    let mut measurements = args.data.load(process, args.output.is_some())?;
    let mut comparisons = Vec::new();
    for model in &models {
        let data = Data::of(model, measurements)?;
        comparisons.push(watched(&data.progress, || compare(&data))?);
        measurements = data.into_measurements();
    }
    let report = Report::Comparison(&models, &measurements, &comparisons);
    if args.output.is_some() || args.plot.is_some() {
        refuse_namesakes(&models)?;
    }
    let guard = Guard { reads: &args.data.with, force: args.force };
    if let Some(directory) = &args.plot {
        let reads: Vec<PathBuf> = models.iter().flat_map(Model::paths).chain(args.data.with.iter().cloned()).collect();
        Pictures { directory, guard: Guard { reads: &reads, ..guard } }.write(&report)?;
    }
    if let Some(directory) = &args.output {
        Folder { directory, guard, progress: &Progress::default() }.write(&report)?;
    }
    notes(&measurements.notes);
    print(&page(&report, args.json)?)
}

/// Models of several processes have no measurements in common.
///
/// # Errors
/// They are of several.
pub fn refuse_mixed(models: &[Model]) -> Result<(), Error> {
    let Some(first) = models.first() else { return Ok(()) };
    let Some(other) = models.iter().find(|m| m.process.name() != first.process.name()) else { return Ok(()) };
    let message = format!(
        "{} models {}, {} models {}",
        first.source.name,
        first.process.name(),
        other.source.name,
        other.process.name()
    );
    Err(Error::Request(Problem::new(message).help("compare models of one process")))
}

/// Several models are written into a folder each, by the names of their files.
fn refuse_namesakes(models: &[Model]) -> Result<(), Error> {
    for (i, model) in models.iter().enumerate() {
        if models[..i].iter().any(|other| other.stem() == model.stem()) {
            let problem = Problem::new(format!("two models are called {}", model.stem().display()));
            return Err(Error::Request(problem.help("rename one of them, or compare them without -o")));
        }
    }
    Ok(())
}
