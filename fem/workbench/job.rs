//! What takes its time: diagnosis, fit and correction run beside the page, which may stop them.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use serde_json::{Value as Json, json};

use super::bench::{Bench, Corrected, Diagnosed, Remedied};
use super::refusal::Refusal;
use crate::ask::{action, fit, fitted, program, remedies};
use crate::diagnose::{Group, MOST_EFFECTS};
use crate::discover::diagnose;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::{
    ActionAnswer, Answer, DiagnosisAnswer, RemedyAnswer, additions, fragment, group_sentence, next_fragment, quoted,
    rows_to_measure, verdict_sentence,
};
use crate::progress::Progress;
use crate::units::TIME;

/// What may be asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Work {
    /// What is missing.
    Diagnose,
    /// The values that are not known.
    Fit,
    /// What to command: perhaps by a program, with blocks put between where they are asked for.
    Correct { program: Option<String>, adds: bool },
    /// What the shop should change, for so many minutes more.
    Remedies { minutes: Option<f64> },
}

impl Work {
    /// That of what the page says.
    ///
    /// # Errors
    /// It is nothing to be done.
    pub fn of(said: &Json) -> Result<Self, Refusal> {
        let word = said["what"].as_str().unwrap_or_default();
        match word {
            "diagnose" => Ok(Self::Diagnose),
            "fit" => Ok(Self::Fit),
            "correct" => Ok(Self::Correct {
                program: said["program"].as_str().map(str::to_string),
                adds: said["add_blocks"].as_bool().unwrap_or(false),
            }),
            "remedies" => Ok(Self::Remedies { minutes: said["minutes"].as_f64() }),
            _ => Err(Refusal::new(
                format!("`{word}` is nothing to be done"),
                "ask for diagnose, fit, correct or remedies",
            )),
        }
    }

    /// Its word.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Diagnose => "diagnose",
            Self::Fit => "fit",
            Self::Correct { .. } => "correct",
            Self::Remedies { .. } => "remedies",
        }
    }

    /// Whether it is about measurements.
    pub fn needs_measurements(&self) -> bool {
        matches!(self, Self::Diagnose | Self::Fit)
    }

    /// Name of the file of a program that it is for.
    pub fn program(&self) -> Option<&str> {
        match self {
            Self::Correct { program, .. } => program.as_deref(),
            _ => None,
        }
    }

    /// The options of `fem correct` by which the same is asked for.
    pub fn options(&self) -> String {
        match self {
            Self::Correct { program: Some(program), adds } => {
                format!(" --program {}{}", quoted(program), if *adds { " --add-blocks" } else { "" })
            }
            Self::Remedies { minutes } => {
                let limit = minutes.map_or(String::new(), |minutes| format!(" --minutes {minutes}"));
                format!(" --remedies{limit}")
            }
            _ => String::new(),
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
    /// The rows that it is about, and those that were struck out.
    pub measured: Option<Arc<Measurements>>,
    pub struck: BTreeSet<usize>,
    /// The command that does the same, and the file of a model that it writes.
    pub command: String,
    pub to: String,
    began: Instant,
}

impl Job {
    /// Work on what is open that begins now.
    pub fn new(work: Work, model: &Model, bench: &Bench) -> Self {
        let (by, with) = (&bench.by_commands, bench.with());
        let (file, to) = (quoted(by), format!("{}-fitted.toml", by.strip_suffix(".toml").unwrap_or(by)));
        let command = match &work {
            Work::Diagnose => format!("fem diagnose {file} {with}"),
            Work::Fit => format!("fem fit {file} {with} --add-to {}", quoted(&to)),
            Work::Correct { .. } | Work::Remedies { .. } => format!("fem correct {file}{}", work.options()),
        };
        let (measured, struck) = (bench.measured.clone(), bench.struck.clone());
        Self { work, progress: Arc::default(), of: model.text(), measured, struck, command, to, began: Instant::now() }
    }

    /// Whether the rows are still those that it is about.
    pub fn is_about(&self, bench: &Bench) -> bool {
        let is_same = match (&self.measured, &bench.measured) {
            (Some(own), Some(now)) => Arc::ptr_eq(own, now),
            (own, now) => own.is_none() && now.is_none(),
        };
        is_same && self.struck == bench.struck
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
    Diagnosed(Box<Diagnosed>),
    Fitted(Box<Model>),
    Corrected(Box<Corrected>),
    Remedied(Remedied),
}

/// What the work needs.
pub struct Material {
    pub model: Model,
    pub measured: Option<Measurements>,
    /// The file of a program.
    pub program: Option<PathBuf>,
}

impl Material {
    fn measured(&mut self) -> Result<Measurements, Refusal> {
        self.measured.take().ok_or_else(|| Refusal::new("nothing was measured", "open a file of measurements first"))
    }

    /// Does the work.
    ///
    /// # Errors
    /// It cannot be done.
    pub fn work(mut self, work: &Work, progress: &Arc<Progress>) -> Result<Outcome, Refusal> {
        match work {
            Work::Diagnose => self.diagnosed(progress).map(|own| Outcome::Diagnosed(Box::new(own))),
            Work::Fit => {
                let measured = self.measured()?;
                let data = Bench::data(&self.model, measured, progress)?;
                Ok(Outcome::Fitted(Box::new(fitted(&data, &fit(&data)?)?)))
            }
            Work::Correct { adds, .. } => self.corrected(*adds, progress).map(|own| Outcome::Corrected(Box::new(own))),
            Work::Remedies { minutes } => {
                let limit = minutes.map(|minutes| TIME.to_si(minutes));
                let found = remedies(&self.model, limit, false, progress)?;
                let answer = RemedyAnswer { model: &self.model, found: &found, correction: None, directory: None };
                Ok(Outcome::Remedied(Remedied { of: self.model.text(), html: fragment(&answer) }))
            }
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
        let group = |own: &Group| (group_sentence(own, &found), own.effects.clone());
        let groups = found.posterior.groups.iter().map(group).collect();
        let (of, additions) = (self.model.text(), additions(&data, &found));
        Ok(Diagnosed { of, verdict, json, html, next, additions, groups })
    }

    fn corrected(self, adds: bool, progress: &Arc<Progress>) -> Result<Corrected, Refusal> {
        let read = self.program.as_ref().map(|path| program(&self.model, path)).transpose()?;
        let found = action(&self.model, (read.as_ref(), adds), false, progress)?;
        let html = fragment(&ActionAnswer(&self.model, &found));
        let of = self.model.text();
        Ok(Corrected { of, html, model: self.model, action: found, command: String::new() })
    }
}
