//! The reports of the commands, and the trait of everything that writes one.

use super::{OutputError, Supplied};
use crate::budget::{Budget, Estimate};
use crate::compare::Comparison;
use crate::compensate::Compensation;
use crate::diagnose::{Diagnosis, Plan};
use crate::fit::Fit;
use crate::measure::Measurements;
use crate::model::{Data, Model, Run};
use crate::noise::MeasurementEffect;
use crate::process::{Description, Process};
use crate::study::{Layout, Summary};
use crate::validation::Case;

/// Result of a command.
pub enum Report<'a> {
    /// `fem run`.
    Run(&'a Model, &'a Run),
    /// `fem compare`: models of one process against one file, each with its comparison.
    Comparison(&'a [Model], &'a Measurements, &'a [Comparison]),
    /// `fem fit`.
    Fit(&'a Data<'a>, &'a Fit),
    /// `fem diagnose`.
    Diagnosis(&'a Data<'a>, &'a Diagnosis),
    /// `fem plan`.
    Plan(&'a Data<'a>, &'a Plan),
    /// `fem compensate`, with the files for the controls that are asked for.
    Compensation(&'a Data<'a>, &'a Compensation, &'a [Supplied]),
    /// `fem budget`.
    Budget(&'a Budget, Option<&'a Estimate>),
    /// `fem study`: what its rows are, and what they say.
    Study(&'a Layout, &'a Summary),
    /// `fem effects`: entries of the catalogue, those of processes and those of the measurement, as a list or
    /// as a page each.
    Effects(&'a [(&'a dyn Process, Description)], &'a [&'a MeasurementEffect], Detail),
    /// `fem validate`: the cases to be shown, and how many there are in all.
    Validation(&'a [Case], usize),
}

impl Report<'_> {
    /// Steps left undone for want of time, the first few by name and the number of the others.
    pub fn left_undone(&self) -> Vec<String> {
        /// Most that are named.
        const MOST: usize = 12;
        let (Self::Fit(data, _) | Self::Diagnosis(data, _) | Self::Plan(data, _) | Self::Compensation(data, ..)) = self
        else {
            return Vec::new();
        };
        let mut all = data.progress.left_undone();
        all.sort_unstable();
        let more = all.len().saturating_sub(MOST);
        all.truncate(MOST);
        all.extend((more > 0).then(|| format!("{more} more")));
        all
    }
}

/// How much is told of each of many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// A line.
    Line,
    /// A page.
    Page,
}

/// A way to write reports. A new one is one file with an `impl` of this.
pub trait Format {
    /// Writes a report, and gives what is to be printed.
    ///
    /// # Errors
    /// A file cannot be written.
    fn write(&self, report: &Report) -> Result<String, OutputError>;
}
