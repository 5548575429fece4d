//! Work of a session that runs beside the page: it begins, it is stopped, and what came of it is taken.

use std::sync::Arc;

use super::bench::Bench;
use super::job::{Job, Material, Outcome, Work};
use super::refusal::Refusal;
use super::session::Session;
use crate::output::files::Guard;
use crate::output::{ActionAnswer, Folder, quoted};
use crate::progress::Progress;

impl Session {
    /// Begins work beside the page: what it needs comes back, to be done on a thread of its own.
    ///
    /// # Errors
    /// Other work runs, or nothing is open.
    pub fn begin(&mut self, work: Work) -> Result<(Job, Material), Refusal> {
        if let Some(job) = &self.job {
            let doing = job.work.word();
            return Err(Refusal::new(format!("{doing} runs already"), "wait until it has ended, or stop it"));
        }
        let program = work.program().map(|name| self.folder.file(name)).transpose()?;
        let material = Material { model: self.model()?.clone(), measured: self.now.counted(), program };
        if work.needs_measurements() && material.measured.is_none() {
            return Err(Refusal::new("nothing was measured", "open a file of measurements"));
        }
        let job = Job::new(work, &material.model, &self.now);
        (self.job, self.trouble) = (Some(job.clone()), None);
        self.version += 1;
        Ok((job, material))
    }

    /// Stops the work that runs.
    ///
    /// # Errors
    /// None runs.
    pub fn stop(&mut self) -> Result<(), Refusal> {
        let job = self.job.as_ref().ok_or_else(|| Refusal::new("nothing runs", "there is nothing to stop"))?;
        job.progress.stop();
        Ok(())
    }

    /// Takes what came of work; nothing of what was stopped.
    pub fn end(&mut self, outcome: Result<Outcome, Refusal>) {
        let Some(job) = self.job.take() else { return };
        self.version += 1;
        if job.progress.is_stopped() {
            return;
        }
        let is_about_rows = matches!(outcome, Ok(Outcome::Diagnosed(_) | Outcome::Fitted(_)));
        let is_of = self.now.model.as_ref().is_some_and(|model| model.text() == job.of);
        let again = |what: &str| Some(format!("{what} was changed meanwhile: {} again", job.work.word()));
        match outcome {
            // What was found of other rows says nothing of these.
            Ok(_) if is_about_rows && !job.is_about(&self.now) => self.trouble = again("what was measured"),
            // What was done meanwhile is not taken back by what was found for the model before it.
            Ok(Outcome::Fitted(_)) if !is_of => self.trouble = again("the model"),
            Ok(Outcome::Fitted(model)) => self.change("fit".into(), Some((job.command, job.to)), *model, true),
            Ok(Outcome::Diagnosed(found)) => {
                self.take("diagnose", job.command, |next| next.diagnosed = Some(Arc::new(*found)));
            }
            Ok(Outcome::Corrected(mut found)) => {
                found.command.clone_from(&job.command);
                self.take("correct", job.command, |next| next.corrected = Some(Arc::new(*found)));
            }
            Ok(Outcome::Remedied(found)) => {
                self.take("look for remedies", job.command, |next| next.remedied = Some(Arc::new(found)));
            }
            Err(refusal) => self.trouble = Some(refusal.text()),
        }
    }

    /// Takes an answer: a step, unless steps were taken back meanwhile, which may still be taken again.
    fn take(&mut self, label: &str, command: String, put: impl FnOnce(&mut Bench)) {
        if self.steps.to_redo().is_some() {
            put(&mut self.now);
            return self.steps.also(command);
        }
        let mut next = self.now.clone();
        put(&mut next);
        self.step(label, Some(command), next);
    }

    /// Writes the files of the last correction into a folder that is not there yet, and names them.
    ///
    /// # Errors
    /// Nothing was corrected, or the folder cannot be made.
    pub fn write_correction(&mut self, name: &str) -> Result<Vec<String>, Refusal> {
        let none = || Refusal::new("nothing was corrected yet", "compute the correction first");
        let found = self.now.corrected.clone().ok_or_else(none)?;
        let directory = self.folder.fresh(name)?;
        let folder = Folder { directory: &directory, guard: Guard { reads: &[], force: false } };
        let answer = ActionAnswer(&found.model, &found.action);
        let told = folder.write("correct", &answer, &Progress::default())?;
        self.steps.also(format!("{} -o {}", found.command, quoted(name)));
        self.version += 1;
        let shown = |line: &str| {
            Some(line.trim().strip_prefix(self.folder.path().to_str()?)?.trim_start_matches('/').to_string())
        };
        Ok(told.lines().filter_map(shown).collect())
    }
}
