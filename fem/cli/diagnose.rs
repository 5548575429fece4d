//! `fem diagnose`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, page, print};
use super::watch::watched;
use super::written::{note_open, write_model};
use crate::ask::{self, completed};
use crate::diagnose::Diagnosis;
use crate::discover::{diagnose_with, read_candidates};
use crate::input::{InputError, Problem};
use crate::measure::{Measurements, Reading};
use crate::model::{Data, Draft, Model};
use crate::output::files::{self, Guard};
use crate::output::{DiagnosisAnswer, Folder, quoted, rows_to_measure, with};
use crate::process::Process;
use crate::progress::{Progress, Stretch};

pub fn run(args: &args::Diagnose) -> Result<(), Error> {
    let [path] = &args.models[..] else { return of_tests(args) };
    let reads = args.data.reads(path);
    let guard = Guard { reads: &reads, force: args.force };
    refuse_one_file(args)?;
    if let Some(new) = &args.add_to {
        guard.check(new)?;
    }
    if let Some(rows) = &args.next {
        guard.check(rows)?;
    }
    let progress = args.limit.progress();
    let (model, measured) = ask::read(path, |process, kept| args.data.load(process, kept, false))?;
    let data = Data::of(&model, measured)?.watched(progress.clone());
    let diagnosis = searched(args, &data, &progress, guard)?;
    // What was found is told, whether or not it makes a model.
    let completed = args.add_to.as_ref().map_or(Ok(()), |new| write_completed(new, (&data, &diagnosis), guard));
    if let Some(rows) = &args.next {
        write_next(args, rows, (&data, &diagnosis), guard)?;
    }
    print_diagnosis(args, &data, &diagnosis)?;
    completed
}

/// Refuses a completed model that would stand where the rows to measure, or the longer model for them, do.
fn refuse_one_file(args: &args::Diagnose) -> Result<(), Error> {
    let (Some(new), Some(rows)) = (&args.add_to, &args.next) else { return Ok(()) };
    let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    if [rows.clone(), rows.with_extension("toml")].iter().all(|other| whole(other) != whole(new)) {
        return Ok(());
    }
    let problem = Problem::new(format!("--add-to and --next would both write {}", new.display()));
    Err(problem.help("name two files: a model, and a table whose longer model stands beside it").into())
}

/// Writes the completed model.
fn write_completed(new: &Path, (data, diagnosis): (&Data, &Diagnosis), guard: Guard) -> Result<(), Error> {
    write_model(new, &completed(data, diagnosis)?, data.model, guard)?;
    note_open(diagnosis.fit.of(data.model).filter(|e| !e.is_closed()));
    Ok(())
}

/// Writes the rows to measure next and, where they lie beyond the model, the model that has them; says how to go on.
fn write_next(
    args: &args::Diagnose,
    rows: &Path,
    (data, diagnosis): (&Data, &Diagnosis),
    guard: Guard,
) -> Result<(), Error> {
    let Some(next) = &diagnosis.next else {
        say!("note: no further measurement that fem knows of would tell more, and {} is not written", rows.display());
        return Ok(());
    };
    let mut model = args.models[0].clone();
    if let Some(longer) = ask::extended(data.model, next)? {
        model = rows.with_extension("toml");
        files::write(&model, longer.text_at(&model).as_bytes(), guard)?;
        say!("written {}, whose batch has the parts to measure", model.display());
    }
    files::write(rows, rows_to_measure(data, next).as_bytes(), guard)?;
    let (model, rows) = (quoted(&model.to_string_lossy()), quoted(&rows.to_string_lossy()));
    say!("written {rows}, to be filled in; then: fem diagnose {model} {} --with {rows}", with(data));
    Ok(())
}

/// Diagnoses several tests of one machine together.
fn of_tests(args: &args::Diagnose) -> Result<(), Error> {
    let (models, files) = (args.models.len(), args.data.with.len());
    if models != files {
        let problem = Problem::new(format!("{models} models are named, and `--with` {files} times"));
        let help = "give one file for each test, in the order of the models: fem diagnose a.toml --with a.csv b.toml \
                    --with b.csv";
        return Err(problem.help(help).into());
    }
    if args.add_to.is_some() {
        let problem = Problem::new("--add-to writes one model, and these are several");
        return Err(problem.help("leave it out: the commands that complete each model are printed").into());
    }
    if !args.own.candidates.is_empty() {
        let problem = Problem::new("--candidates are laws of one test, and these are several");
        return Err(problem.help("leave it out, or diagnose each test by itself").into());
    }
    if args.next.is_some() {
        let problem = Problem::new("--next writes rows of one test, and these are several");
        return Err(problem.help("leave it out: what to measure is printed").into());
    }
    let drafts: Vec<Draft> = args.models.iter().map(|path| Draft::load(path)).collect::<Result<_, InputError>>()?;
    let reading = args.data.reading.said()?;
    let kept: Vec<Reading> = drafts.iter().map(Draft::reading).collect::<Result<_, InputError>>()?;
    let files = args.data.with.iter().zip(&drafts).zip(&kept);
    let each: Vec<(&PathBuf, &dyn Process, &Reading)> =
        files.map(|((path, draft), kept)| (path, draft.process(), kept)).collect();
    let measured = Measurements::load_each(&each, &reading, false)?;
    let loaded = drafts.into_iter().zip(&measured).map(|(draft, measured)| draft.with(&measured.recorded));
    let model = Model::of_tests(loaded.collect::<Result<_, InputError>>()?)?;
    let progress = args.limit.progress();
    let data = Data::of_tests(&model, measured)?.watched(progress.clone());
    let reads: Vec<PathBuf> = args.models.iter().chain(&args.data.with).cloned().collect();
    let diagnosis = searched(args, &data, &progress, Guard { reads: &reads, force: args.force })?;
    print_diagnosis(args, &data, &diagnosis)
}

/// Searches, tells what the search took and what it left out, and writes the diagnosis where a folder is named.
fn searched(args: &args::Diagnose, data: &Data, progress: &Arc<Progress>, guard: Guard) -> Result<Diagnosis, Error> {
    let candidates = read_candidates(&args.own.candidates)?;
    let most = usize::from(args.max_effects);
    let diagnosis = watched(progress, || diagnose_with(data, &candidates, most, progress))?;
    if args.profile {
        say!("{}", stretches(&progress.profile()));
    }
    if let Some(directory) = &args.output {
        Folder { directory, guard }.write("diagnose", &DiagnosisAnswer::new(data, &diagnosis), progress)?;
    }
    Ok(diagnosis)
}

/// Prints a diagnosis.
fn print_diagnosis(args: &args::Diagnose, data: &Data, diagnosis: &Diagnosis) -> Result<(), Error> {
    notes(&ask::notes(data, diagnosis));
    let answer = DiagnosisAnswer::new(data, diagnosis);
    print(&page(&if args.verbose { answer.verbose() } else { answer }, args.json))
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
