//! What takes its time: diagnosis, fit and correction run beside the page, which may stop them.

use std::sync::Arc;
use std::time::Instant;

use serde_json::{Value as Json, json};

use super::bench::{Bench, Corrected, Diagnosed};
use super::refusal::Refusal;
use crate::ask::{advise, correct, fit, fitted};
use crate::diagnose::MOST_EFFECTS;
use crate::discover::diagnose;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::{
    AdvisedAnswer, Answer, CorrectionAnswer, DiagnosisAnswer, additions, fragment, next_fragment, rows_to_measure,
    verdict_sentence,
};
use crate::progress::Progress;

/// What may be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    Diagnose,
    Fit,
    Correct,
}

impl Work {
    /// That of a word.
    pub fn of(word: &str) -> Result<Self, Refusal> {
        match word {
            "diagnose" => Ok(Self::Diagnose),
            "fit" => Ok(Self::Fit),
            "correct" => Ok(Self::Correct),
            _ => Err(Refusal::new(format!("`{word}` is nothing to be done"), "ask for diagnose, fit or correct")),
        }
    }

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Diagnose => "diagnose",
            Self::Fit => "fit",
            Self::Correct => "correct",
        }
    }
}

/// Work that runs.
#[derive(Clone)]
pub struct Job {
    /// What it is.
    pub work: Work,
    /// By which it is followed and stopped.
    pub progress: Arc<Progress>,
    /// Text of the model that it is about.
    pub of: String,
    began: Instant,
}

impl Job {
    /// Work on a model that begins now.
    pub fn new(work: Work, of: String) -> Self {
        Self { work, progress: Arc::default(), of, began: Instant::now() }
    }

    /// For the page.
    pub fn json(&self) -> Json {
        let (done, total) = self.progress.read();
        let share = (total > 0).then(|| done as f64 / total as f64);
        let seconds = (10.0 * self.began.elapsed().as_secs_f64()).round() / 10.0;
        json!({ "what": self.work.word(), "done": share, "seconds": seconds })
    }
}

/// What came of it.
pub enum Outcome {
    Diagnosed(Diagnosed),
    Fitted(Box<Model>),
    Corrected(Corrected),
}

/// What the work needs.
pub struct Material {
    pub model: Model,
    pub measured: Option<Measurements>,
}

impl Material {
    fn measured(&mut self) -> Result<Measurements, Refusal> {
        self.measured.take().ok_or_else(|| Refusal::new("nothing was measured", "open a file of measurements first"))
    }

    /// Does the work.
    pub fn work(mut self, work: Work, progress: &Arc<Progress>) -> Result<Outcome, Refusal> {
        match work {
            Work::Diagnose => self.diagnosed(progress).map(Outcome::Diagnosed),
            Work::Fit => {
                let measured = self.measured()?;
                let data = Bench::data(&self.model, measured, progress)?;
                Ok(Outcome::Fitted(Box::new(fitted(&data, &fit(&data)?)?)))
            }
            Work::Correct => self.corrected(progress).map(Outcome::Corrected),
        }
    }

    fn diagnosed(mut self, progress: &Arc<Progress>) -> Result<Diagnosed, Refusal> {
        let measured = self.measured()?;
        let data = Bench::data(&self.model, measured, progress)?;
        let found = diagnose(&data, MOST_EFFECTS, progress)?;
        let answer = DiagnosisAnswer::new(&data, &found);
        let next = found.next.as_ref().map(|next| (next_fragment(&found), rows_to_measure(&data, next)));
        let (json, html) = (answer.json(), fragment(&answer));
        let verdict = verdict_sentence(&data, &found);
        Ok(Diagnosed { of: self.model.text(), verdict, json, html, next, additions: additions(&data, &found) })
    }

    fn corrected(self, progress: &Arc<Progress>) -> Result<Corrected, Refusal> {
        let html = match self.model.system.commanded() {
            Some(_) => {
                let found = correct(&self.model, false, progress)?;
                fragment(&CorrectionAnswer(&self.model, &found, None))
            }
            None => fragment(&AdvisedAnswer(&self.model, &advise(&self.model, false, progress)?)),
        };
        Ok(Corrected { of: self.model.text(), html })
    }
}
