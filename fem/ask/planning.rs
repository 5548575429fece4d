//! Detection limits of a design, before anything is measured.

use super::Error;
use crate::diagnose::{self, Plan};
use crate::input::Problem;
use crate::model::Data;
use crate::process::{Observable, Process};
use crate::units::{Kind, Knowledge, Quantity};

/// Predicts which effects the rows of a design can detect at the given noise (texts such as `1.5 um`, one for each
/// unit), with a note where some noise is assumed.
///
/// # Errors
/// A noise is no positive quantity of any observable, or the model cannot be computed.
pub fn plan(design: &Data, noise: &[String]) -> Result<(Plan, Option<String>), Error> {
    let (sigma, note) = planned_noise(design, noise)?;
    Ok((diagnose::plan(design, &sigma)?, note))
}

/// Standard deviation of each observable, SI: as given (`1.5 um`), else one unit; with a note where that is assumed.
///
/// # Errors
/// A noise is no positive quantity of any observable.
fn planned_noise(design: &Data, said: &[String]) -> Result<(Vec<f64>, Option<String>), Error> {
    let process = &*design.model.process;
    let sigma = noise(process, said)?;
    let is_assumed = |position: usize| design.uncertainty.is_none() && sigma[position].is_none();
    let assumed = design.observables.iter().filter(|s| is_assumed(s.position)).map(|s| format!("1 {}", s.kind.unit));
    let assumed: Vec<String> = assumed.collect();
    let note = (!assumed.is_empty())
        .then(|| format!("a noise of {} is assumed; say --noise or add a column u", assumed.join(" and ")));
    let usual = |(o, sigma): (&Observable, &Option<f64>)| sigma.unwrap_or_else(|| o.error_kind().to_si(1.0));
    Ok((process.observables().iter().zip(&sigma).map(usual).collect(), note))
}

/// The noise of each observable, SI, as far as it is said: each size stands for the observables that are
/// told in its unit.
fn noise(process: &dyn Process, said: &[String]) -> Result<Vec<Option<f64>>, Error> {
    let kinds: Vec<Kind> = process.observables().iter().map(Observable::error_kind).collect();
    let mut all = vec![None; kinds.len()];
    for text in said {
        let wrong = |message: String| {
            let units: Vec<String> = kinds.iter().map(|k| format!("'1 {}'", k.unit)).collect();
            Error::from(Problem::new(message).help(format!("write --noise {}", units.join(" or "))))
        };
        let parsed: Vec<_> = kinds.iter().map(|k| Quantity::parse(text, k)).collect();
        if let Some(Err(error)) = parsed.iter().find(|_| parsed.iter().all(Result::is_err)) {
            return Err(wrong(format!("--noise {text}: {}", error.message)));
        }
        for (sigma, quantity) in all.iter_mut().zip(parsed.into_iter().map(Result::ok)) {
            let Some(quantity) = quantity else { continue };
            if quantity.knowledge != Knowledge::Known || quantity.value <= 0.0 {
                return Err(wrong("the noise is no positive quantity".into()));
            }
            *sigma = Some(quantity.value);
        }
    }
    Ok(all)
}
