//! Studies: a plan with the folder of its rows, and the rows of a range of jobs for whoever shares them out.

use std::path::PathBuf;
use std::sync::{Arc, Mutex};

use fem::ask::do_jobs;
use fem::input::{Problem, Source};
use fem::output::files::Guard;
use fem::output::study::{Earlier, StudyFolder, line};
use fem::output::{Folder, StudyAnswer, json, text};
use fem::process::Failure;
use fem::study::{Layout, Shard, StudyPlan, in_order};
use pyo3::prelude::*;

use crate::compute::{compute, compute_watched, locked, within};
use crate::error::Error;

/// Reads a plan: a file, or a text whose paths are relative to the folder of `name`.
fn read(name: String, text: Option<String>) -> Result<StudyPlan, Error> {
    Ok(match text {
        Some(text) => StudyPlan::parse(Source::new(name, text))?,
        None => StudyPlan::load(&PathBuf::from(name))?,
    })
}

/// A plan, and the folder in which its rows grow.
#[pyclass(frozen, module = "fem._fem")]
pub struct Study {
    plan: Arc<StudyPlan>,
    layout: Layout,
    folder: Arc<Mutex<Option<StudyFolder>>>,
}

#[pymethods]
impl Study {
    /// Opens or makes the folder of a plan, and finds how far an earlier program came.
    #[staticmethod]
    fn open(py: Python, name: String, text: Option<String>, output: PathBuf, restart: bool) -> PyResult<Self> {
        let earlier = Earlier { restart, force: false };
        compute(py, &Arc::default(), move |_| {
            let plan = read(name, text)?;
            let layout = plan.layout();
            let folder = StudyFolder::open(&output, &layout, Shard::ALL, earlier, &plan.paths())?;
            Ok(Self { plan: Arc::new(plan), layout, folder: Arc::new(Mutex::new(Some(folder))) })
        })
    }

    /// Number of jobs that are done, and of all.
    fn done(&self) -> (u64, u64) {
        let folder = locked(&self.folder);
        (folder.as_ref().map_or(self.layout.jobs, StudyFolder::next), self.layout.jobs)
    }

    /// Everything on which rows depend.
    fn facts(&self) -> Vec<(String, String)> {
        self.layout.facts.clone()
    }

    /// Does the jobs that are left, within so many seconds if a limit is given; `watch` is told how many of them are
    /// done.
    fn compute(&self, py: Python, seconds: Option<f64>, watch: Option<Py<PyAny>>) -> PyResult<()> {
        let progress = within(seconds);
        let (before, all) = self.done();
        let look = |py: Python| match &watch {
            Some(watch) => watch.call1(py, (before + progress.read().0, all)).map(drop),
            None => Ok(()),
        };
        let (plan, shared) = (self.plan.clone(), self.folder.clone());
        compute_watched(py, &progress, look, move |progress| {
            let mut own = locked(&shared);
            let Some(mut folder) = own.take() else { return Err(ended()) };
            do_jobs(&plan, &mut folder, progress)?;
            // What was stopped is let go, so that whoever comes next finds the folder free.
            if !progress.is_stopped() {
                *own = Some(folder);
            }
            Ok(())
        })
    }

    /// Appends the lines of the next jobs.
    fn append(&self, py: Python, lines: Vec<String>) -> PyResult<()> {
        let shared = self.folder.clone();
        compute(py, &Arc::default(), move |_| {
            let mut own = locked(&shared);
            let folder = own.as_mut().ok_or_else(ended)?;
            for line in lines {
                folder.append(line.as_bytes())?;
            }
            Ok(())
        })
    }

    /// Ends the work, and says what the rows say so far: the JSON document, the page for people, and their file. Where
    /// all jobs are done, what the command writes beside the rows appears in the folder `kept`.
    fn finish(&self, py: Python, kept: Option<PathBuf>) -> PyResult<(String, String, PathBuf)> {
        let (layout, plan, shared) = (self.layout.clone(), self.plan.clone(), self.folder.clone());
        let (done, jobs) = self.done();
        compute(py, &Arc::default(), move |progress| {
            let folder = locked(&shared).take();
            let (rows, summary) = folder.ok_or_else(ended)?.finish()?;
            let answer = StudyAnswer(&layout, &summary);
            if let Some(directory) = kept.as_deref().filter(|_| done == jobs) {
                let guard = Guard { reads: &plan.paths(), force: false };
                Folder { directory, guard }.write("study", &answer, progress)?;
            }
            Ok((json(&answer), text(&answer, None), rows))
        })
    }
}

/// The lines of jobs `first` to before `last`, counted from 0, of a plan on whose facts rows depend.
#[pyfunction]
pub fn study_jobs(
    py: Python,
    name: String,
    text: Option<String>,
    facts: Vec<(String, String)>,
    first: u64,
    last: u64,
) -> PyResult<Vec<String>> {
    compute(py, &Arc::default(), move |progress| {
        let plan = read(name, text)?;
        let mut own = plan.layout();
        let here = own.clone();
        own.facts = facts;
        let differences = own.differences(&here);
        if !differences.is_empty() {
            let message = format!("this machine reads another plan: {}", differences.join("; "));
            let problem = Problem::new(message).help("let all machines see the same files and the same version of fem");
            return Err(problem.into());
        }
        let mut lines = Vec::new();
        let work = |number| line(&plan.job(number));
        in_order(first..last, progress, work, |line| {
            lines.push(line);
            Ok::<(), Error>(())
        })?;
        Ok(lines)
    })
}

fn ended() -> Error {
    Error::from(Failure { message: "the study was ended".into(), help: "open it again: it goes on".into() })
}
