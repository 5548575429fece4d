//! `fem compare`.

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::compare::compare;
use crate::input::{InputError, Problem};
use crate::model::{Data, Model};
use crate::output::files::Guard;
use crate::output::{Folder, Format, Report};
use crate::progress::Progress;

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
    let mut measurements = args.data.load(process)?;
    let mut comparisons = Vec::new();
    for model in &models {
        let data = Data::of(model, measurements)?;
        comparisons.push(watched(&data.progress, || compare(&data))?);
        measurements = data.into_measurements();
    }
    let report = Report::Comparison(&models, &measurements, &comparisons);
    if let Some(directory) = &args.output {
        refuse_namesakes(&models)?;
        let guard = Guard { reads: &args.data.with, force: args.force };
        Folder { directory, guard, progress: &Progress::default() }.write(&report)?;
    }
    notes(&measurements.notes);
    print(&page(&report, args.json)?)
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
