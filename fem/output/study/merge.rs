//! Shards of a study put together.

use std::io::BufRead;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::folder::{Earlier, FILES, StudyError, StudyFolder, altered, finished, known, without_sums};
use super::rows;
use crate::input::Problem;
use crate::output::OutputError;
use crate::output::files::folder_at;
use crate::study::{Layout, Shard, Summary};

/// Writes the rows of all shards into one folder, as if the study had been done there, and says what they say.
///
/// # Errors
/// A folder holds no finished rows, or rows of another plan; jobs are missing, or stand in two folders; the rows cannot
/// be read or written.
pub fn merge(folders: &[PathBuf], output: &Path) -> Result<(Layout, PathBuf, Summary), StudyError> {
    let mut shards: Vec<(Range<u64>, &PathBuf, Shard)> = Vec::new();
    let mut layout: Option<(Layout, &PathBuf)> = None;
    for folder in folders {
        let Some((own, shard)) = known(folder) else {
            return refused(format!("{} holds no rows of a study", folder.display()), "name folders of `fem study`");
        };
        if finished(folder).is_none() {
            let message = format!("shard {shard} in {} is not finished", folder.display());
            return refused(message, "run it again: it goes on where it was stopped");
        }
        if let Some((first, path)) = &layout {
            let differences = first.differences(&own);
            if !differences.is_empty() {
                let (a, b) = (path.display(), folder.display());
                let message = format!("{a} and {b} are of different plans: {}", differences.join("; "));
                return refused(message, "merge shards of one plan alone");
            }
        }
        let dir = folder_at(folder).map_err(OutputError::at(folder))?;
        if let Some(problem) = without_sums(folder, &dir) {
            let problem = problem.help("copy the whole folder, or run the shard again with --restart");
            return Err(StudyError::Refused(problem));
        }
        if let Some(job) = altered(folder, &dir, shard.jobs(&own).start).map_err(OutputError::at(folder))? {
            let message = format!("row {job} of shard {shard} in {} is not as it was written", folder.display());
            return refused(message, "the file was changed: run the shard again with --restart");
        }
        shards.push((shard.jobs(&own), folder, shard));
        layout.get_or_insert((own, folder));
    }
    let Some((layout, _)) = layout else { return refused("nothing is to be merged".into(), "name folders") };
    shards.sort_by_key(|(jobs, _, _)| (jobs.start, jobs.end));
    covers(&layout, &shards)?;
    // A link that stands beside a shard came with it.
    let files = |folder: &PathBuf| FILES.map(|name| folder.join(name));
    let reads: Vec<PathBuf> = folders.iter().flat_map(files).chain(folders.iter().cloned()).collect();
    let mut target = StudyFolder::open(output, &layout, Shard::ALL, Earlier::default(), &reads)?;
    let mut line = Vec::new();
    for (jobs, folder, shard) in shards {
        let Some((path, mut reader)) = finished(folder) else { continue };
        for job in jobs {
            line.clear();
            reader.read_until(b'\n', &mut line).map_err(OutputError::at(&path))?;
            if rows::job_of(&line) != Some(job + 1) {
                let message = format!("row {} of shard {shard} in {} is not there", job + 1, path.display());
                return refused(message, "the file was changed: run the shard again with --restart");
            }
            // Those before it stand there from an earlier attempt.
            if job == target.next() {
                target.append(&line)?;
            }
        }
    }
    let (path, summary) = target.finish()?;
    Ok((layout, path, summary))
}

/// Refuses shards that overlap, or leave jobs out.
fn covers(layout: &Layout, shards: &[(Range<u64>, &PathBuf, Shard)]) -> Result<(), StudyError> {
    let mut next = 0;
    let missing = |from: u64, to: u64| {
        let message = format!("jobs {} to {to} are in none of the folders", from + 1);
        refused(message, "name the folders of all shards")
    };
    for (jobs, folder, _) in shards {
        if jobs.start > next {
            return missing(next, jobs.start);
        }
        if jobs.start < next && !jobs.is_empty() {
            let message = format!("job {} stands in two folders, one of them {}", jobs.start + 1, folder.display());
            return refused(message, "name each shard once, all with the same number of shards");
        }
        next = next.max(jobs.end);
    }
    if next < layout.jobs { missing(next, layout.jobs) } else { Ok(()) }
}

fn refused<T>(message: String, help: &str) -> Result<T, StudyError> {
    Err(StudyError::Refused(Problem::new(message).help(help)))
}
