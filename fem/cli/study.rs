//! The commands `fem study` and `fem study merge`.

use std::path::{Path, PathBuf};

use super::args;
use super::data::default_directory;
use super::error::Error;
use super::say::say;
use super::terminal::{page, print};
use super::watch::watched;
use crate::ask::do_jobs;
use crate::input::Problem;
use crate::output::files::Guard;
use crate::output::study::{Earlier, StudyFolder, merge, parquet};
use crate::output::{Folder, StudyAnswer};
use crate::progress::Progress;
use crate::study::{Layout, Shard, StudyPlan, Summary};

pub fn run(args: &args::Study) -> Result<(), Error> {
    if let Some(args::StudyCommand::Merge(args)) = &args.command {
        let (layout, rows, summary) = merge(&args.folders, &args.output)?;
        return write_and_print(
            (&layout, &summary),
            (&args.output, &rows),
            Guard { reads: &[], force: false },
            args.json,
        );
    }
    let Some(file) = &args.plan else {
        let problem = Problem::new("no plan is named");
        return Err(Error::from(problem.help("fem study PLAN.toml; `fem new study` writes one")));
    };
    if let Some(path) = &args.parquet {
        parquet::check(path)?;
        Guard { reads: &[], force: args.force }.check(path)?;
    }
    let plan = StudyPlan::load(file)?;
    let layout = plan.layout();
    let shard = args.shard.unwrap_or(Shard::ALL);
    let directory = args.output.clone().unwrap_or_else(|| directory(file, shard));
    let reads = plan.paths();
    let earlier = Earlier { restart: args.restart, force: args.force };
    let mut folder = StudyFolder::open(&directory, &layout, shard, earlier, &reads)?;
    let jobs = folder.jobs();
    if let Some(job) = folder.altered() {
        say!(
            "note: row {job} in {} was not as it was written, and is computed again with those behind it",
            directory.display()
        );
    }
    let left = folder.next()..jobs.end;
    if !left.is_empty() && left.start > jobs.start {
        say!(
            "note: going on after {} of {} jobs in {}",
            left.start - jobs.start,
            jobs.end - jobs.start,
            directory.display()
        );
    }
    let progress = args.limit.progress();
    let undone = watched(&progress, || do_jobs(&plan, &mut folder, &progress))?;
    let (rows, summary) = folder.finish()?;
    if undone > 0 {
        say!("note: the time was over; {undone} jobs are left. The same command goes on with them");
        return print(&page(&StudyAnswer(&layout, &summary), args.json));
    }
    if let Some(path) = &args.parquet {
        let reads: Vec<PathBuf> = reads.iter().cloned().chain([rows.clone()]).collect();
        parquet::write(&rows, path, Guard { reads: &reads, force: args.force })?;
    }
    if shard != Shard::ALL {
        say!("note: these are the jobs of shard {shard}; `fem study merge` puts all of them together");
    }
    write_and_print((&layout, &summary), (&directory, &rows), Guard { reads: &reads, force: args.force }, args.json)?;
    if summary.rows > 0 && summary.failed == summary.rows {
        let first = summary.failures.first().map_or(String::new(), |(_, message)| message.clone());
        say!("error: every job failed: {first}");
        return Err(Error::Found);
    }
    Ok(())
}

/// Writes and prints the summary of finished rows.
fn write_and_print(
    (layout, summary): (&Layout, &Summary),
    (directory, rows): (&Path, &Path),
    guard: Guard,
    json: bool,
) -> Result<(), Error> {
    let answer = StudyAnswer(layout, summary);
    let written = Folder { directory, guard }.write("study", &answer, &Progress::default())?;
    let list = if json { String::new() } else { format!("{written}  {}\n", rows.display()) };
    print(&(page(&answer, json) + &list))
}

/// Folder `out/<plan name>`, of a shard with its number.
fn directory(plan: &Path, shard: Shard) -> PathBuf {
    let mut directory = default_directory(plan, "plan").into_os_string();
    if shard != Shard::ALL {
        directory.push(format!("-{}-of-{}", shard.number, shard.of));
    }
    directory.into()
}
