//! `fem compare`.

use std::path::PathBuf;
use std::sync::Arc;

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::ask::{compare_all, read_all};
use crate::input::Problem;
use crate::model::Model;
use crate::output::files::Guard;
use crate::output::{ComparisonAnswer, Folder};

pub fn run(args: &args::Compare) -> Result<(), Error> {
    let read = read_all(&args.models, |process, kept| args.data.load(process, kept, args.output.is_some()));
    let Some((models, measurements)) = read? else { return Ok(()) };
    let Some(process) = models.first().map(|model| &*model.process) else { return Ok(()) };
    let progress = Arc::default();
    let compared = watched(&progress, || compare_all(&models, measurements, &progress, |_, found| found));
    let (comparisons, measurements) = compared?;
    let answer = ComparisonAnswer { process, models: &models, measurements: &measurements, comparisons: &comparisons };
    if args.output.is_some() || args.plot.is_some() {
        refuse_namesakes(&models)?;
    }
    let reads: Vec<PathBuf> = models.iter().flat_map(Model::paths).chain(args.data.with.iter().cloned()).collect();
    let guard = Guard { reads: &reads, force: args.force };
    if let Some(directory) = &args.plot {
        Folder { directory, guard }.write_figures(&answer)?;
    }
    if let Some(directory) = &args.output {
        Folder { directory, guard }.write("compare", &answer, &progress)?;
    }
    notes(&measurements.notes);
    print(&page(&answer, args.json))
}

/// Several models are written into a folder each, by the names of their files.
fn refuse_namesakes(models: &[Model]) -> Result<(), Error> {
    for (i, model) in models.iter().enumerate() {
        if models[..i].iter().any(|other| other.stem() == model.stem()) {
            let problem = Problem::new(format!("two models are called {}", model.stem().display()));
            return Err(Error::from(problem.help("rename one of them, or compare them without -o")));
        }
    }
    Ok(())
}
