//! Subject of a page: models, their prediction, and evidence.

use crate::compare::Comparison;
use crate::diagnose::Diagnosis;
use crate::model::{Data, Model};
use crate::output::run::RunAnswer;

/// Models, their prediction, and what measurements say of them.
pub struct Subject<'a> {
    /// In the order in which they were named; there is at least one.
    pub models: &'a [Model],
    /// The run of the last of them; `None` where it leaves values open, or a completed one takes its place.
    pub run: Option<RunAnswer<'a>>,
    /// Evidence of measurements, where there are any.
    pub evidence: Option<Evidence<'a>>,
    /// Names of the files that were read, with the SHA-256 of each.
    pub files: Vec<(String, String)>,
}

/// Evidence of measurements for or against models.
pub struct Evidence<'a> {
    /// The measurements, as the last model sees them.
    pub all: &'a Data<'a>,
    /// Those of them that were diagnosed; all, where nothing was.
    pub data: &'a Data<'a>,
    /// Of every model as it is written with all measurements; empty where values are open.
    pub comparisons: &'a [Comparison],
    /// Of the last model.
    pub diagnosis: Option<&'a Diagnosis>,
    /// The last model with what was missing and all fitted values, and its run.
    pub completed: Option<RunAnswer<'a>>,
}

impl<'a> Subject<'a> {
    /// The model that the page is about.
    pub fn model(&self) -> &'a Model {
        &self.models[self.models.len() - 1]
    }

    /// The best that is known of the machine: the completed model, or else the model as it is written.
    pub fn best(&self) -> Option<RunAnswer<'a>> {
        self.evidence.as_ref().and_then(|found| found.completed).or(self.run)
    }
}
