//! The next part of a machine, from its own history.

use std::path::PathBuf;
use std::sync::Arc;

use fem::ask::{Change, Log};
use fem::output::files::Appended;
use fem::output::{NextAnswer, json, text};
use fem::units::{MICRO, TIME};
use pyo3::prelude::*;

use crate::compute::compute;
use crate::data::Asked;

/// What is planned before the next part, in the units that people use.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Planned {
    new_insert: bool,
    new_set_up: bool,
    /// Minutes of rest.
    pause: f64,
    next_job: Option<String>,
    /// Offset with which the measured parts were made, um.
    applied: Option<f64>,
    dry_run: bool,
}

/// The offset of the next part and what to expect: the document, its text, its page, and what should not be overlooked. What was
/// measured is added to the log.
#[pyfunction]
#[pyo3(signature = (log, data, job, planned))]
pub fn next_part(
    py: Python,
    log: PathBuf,
    data: Option<Asked>,
    job: Option<String>,
    planned: Planned,
) -> PyResult<(String, String, String, Vec<String>)> {
    compute(py, &Arc::default(), move |progress| {
        let mut file = Appended::open(&log)?;
        let mut log = Log::read(&log.display().to_string(), file.bytes())?;
        let job = log.job(job.as_deref())?;
        let measured = data.map(|data| data.read(&log.history.jobs[job].model, false)).transpose()?;
        let Planned { new_insert, new_set_up, pause, next_job, applied, dry_run } = planned;
        let pause = TIME.to_si(pause);
        let change = Change { insert: new_insert, set_up: new_set_up, pause, job: next_job };
        let own = measured.as_ref().map(|measured| (job, measured));
        let (next, added) = log.next(own, applied.map(|um| MICRO.to_si(um)), &change, progress)?;
        if !dry_run && !added.entry.is_empty() {
            file.append(added.whole, &added.entry)?;
        }
        let answer = NextAnswer(&log.history, &next);
        let of_data = measured.iter().flat_map(|measured| measured.notes.iter().cloned());
        let notes = log.notes.iter().cloned().chain(of_data).collect();
        Ok((json(&answer), text(&answer, None), answer.page(), notes))
    })
}
