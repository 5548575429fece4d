//! `fem diagnose`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::diagnose::{Diagnosis, diagnose};
use crate::fit::fitted_text;
use crate::input::Source;
use crate::model::{Data, Model, add_effect};
use crate::output::files::{self, Guard};
use crate::output::{Folder, Format, Report, additions};
use crate::progress::Stretch;

pub fn run(args: &args::Diagnose) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let reads = args.data.reads(&args.model);
    let guard = Guard { reads: &reads, force: args.force };
    if let Some(new) = &args.add_to {
        guard.check(new)?;
    }
    let progress = args.limit.progress();
    let data = Data::of(&model, args.data.load(model.process)?)?.watched(progress.clone());
    let diagnosis = watched(&progress, || diagnose(&data, usize::from(args.max_effects), &progress))?;
    if args.profile {
        say!("{}", stretches(&progress.profile()));
    }
    if diagnosis.rows < data.len() {
        say!("note: {} of {} rows were used, evenly chosen", diagnosis.rows, data.len());
    }
    let report = Report::Diagnosis(&data, &diagnosis);
    if let Some(directory) = &args.output {
        Folder { directory, guard, progress: &progress }.write(&report)?;
    }
    if let Some(new) = &args.add_to {
        let better = completed(&data, &diagnosis)?;
        files::write(new, better.text_at(new).as_bytes(), guard)?;
        say!("written {}", new.display());
        let own = diagnosis.fit.estimates.iter().take(model.parameters.len());
        for open in own.filter(|e| !e.is_closed()) {
            say!("note: {} stays as it was: the data leave its interval open", open.parameter.path);
        }
    }
    notes(&data.notes_of_fit());
    print(&page(&report, args.json)?)
}

/// The model with the missing effects and every fitted value.
///
/// # Errors
/// A fitted value lies outside of what a model may hold.
pub fn completed(data: &Data, diagnosis: &Diagnosis) -> Result<Model, Error> {
    let text = fitted_text(data, &diagnosis.fit);
    let mut better = Model::parse(Source::new(data.model.source.name.to_string(), text))?;
    for (name, settings) in additions(data, diagnosis) {
        better = add_effect(&better, &name, &settings)?;
    }
    Ok(better)
}

/// A table of what the stretches of a computation took.
fn stretches(all: &[Stretch]) -> String {
    let line =
        |s: &Stretch| format!("{:<34} {:>6} {:>12} {:>9.3}\n", s.name, s.times, s.evaluations, s.time.as_secs_f64());
    let sum = Stretch {
        name: "in all",
        times: 1,
        evaluations: all.iter().map(|s| s.evaluations).sum(),
        time: all.iter().map(|s| s.time).sum(),
    };
    let head =
        format!("{:<34} {:>6} {:>12} {:>9}\n", "stretch, without those within it", "times", "evaluations", "time, s");
    head + &all.iter().chain([&sum]).map(line).collect::<String>()
}
