//! The files of a case: the model as the user believes it, and the measured rows.

use crate::job::Job;
use crate::law::{Cause, unit};
use std::fmt::Write as _;

/// An observed value as a file shows it: with so many decimals, or without noise to the last digit.
pub fn observed(value: f64, decimals: usize, sigma: f64) -> String {
    if sigma == 0.0 { format!("{value:.12e}") } else { format!("{value:.decimals$}") }
}

/// The model file; `values` (one per shown parameter) replaces the `+-` by known values, and `more` are
/// further effects. The user's file is `model(job, None, &[])`.
pub fn model(job: &dyn Job, values: Option<&[f64]>, more: &[Cause]) -> String {
    let mut text = format!("title = \"case\"\nprocess = \"{}\"\n\n{}", job.process(), job.tables());
    for (i, s) in job.shown().iter().enumerate() {
        let known = values.map_or(format!("{} +- {}", s.written, s.std), |v| format!("{:.15e}", v[i]));
        let unit = unit(job.laws(), s.effect, s.parameter);
        if i == 0 || job.shown()[i - 1].effect != s.effect {
            let _ = write!(text, "\n[effects.{}]\n", s.effect);
        }
        let _ = writeln!(text, "{} = \"{known} {unit}\"", s.parameter);
    }
    for cause in more {
        let _ = write!(text, "\n[effects.{}]\n", cause.effect);
        for &(parameter, value) in &cause.parameters {
            let _ = match unit(job.laws(), cause.effect, parameter) {
                "" => writeln!(text, "{parameter} = {value:?}"),
                unit => writeln!(text, "{parameter} = \"{value} {unit}\""),
            };
        }
    }
    text
}
