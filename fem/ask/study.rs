//! Studies in their folders.

use std::path::{Path, PathBuf};

use super::Error;
use crate::output::study::{Earlier, StudyFolder, line};
use crate::output::{OutputError, StudyAnswer};
use crate::progress::Progress;
use crate::study::{Layout, Shard, StudyPlan, Summary, in_order};

/// A study as far as it has come.
#[non_exhaustive]
pub struct Study {
    /// File of its rows.
    pub rows: PathBuf,
    /// Number of jobs that are left.
    pub left: u64,
    layout: Layout,
    summary: Summary,
}

impl Study {
    /// Yield, worst case and sensitivity by its rows.
    pub fn answer(&self) -> StudyAnswer<'_> {
        StudyAnswer(&self.layout, &self.summary)
    }
}

/// Does the jobs of a plan on all threads, with their rows in a folder. Rows of the same plan that stand there are gone
/// on with; where the time is over, jobs are left for another call.
///
/// # Errors
/// The folder holds something else, or cannot be written.
pub fn study(plan: &StudyPlan, directory: &Path, progress: &Progress) -> Result<Study, Error> {
    let layout = plan.layout();
    let mut folder = StudyFolder::open(directory, &layout, Shard::ALL, Earlier::default(), &plan.paths())?;
    let left = do_jobs(plan, &mut folder, progress)?;
    let (rows, summary) = folder.finish()?;
    Ok(Study { rows, left, layout, summary })
}

/// Does the jobs that are left in the folder of a study, and returns the number of those that are left then.
///
/// # Errors
/// A row cannot be written.
pub fn do_jobs(plan: &StudyPlan, folder: &mut StudyFolder, progress: &Progress) -> Result<u64, OutputError> {
    let end = folder.jobs().end;
    let next = in_order(
        folder.next()..end,
        progress,
        |number| line(&plan.job(number)),
        |line| folder.append(line.as_bytes()),
    )?;
    Ok(end - next)
}
