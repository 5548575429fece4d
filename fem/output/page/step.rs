//! The error falling: models, or one model and its missing effects, with what each leaves.

use super::subject::{Evidence, Subject};
use crate::compare::Comparison;
use crate::diagnose::Cause;
use crate::model::Data;
use crate::noise::Noise;
use crate::output::diagnosis::label;
use crate::output::plots::Judged;

/// A model on the way to the noise.
pub struct Step<'a> {
    /// The effect that was added, or the model's name.
    pub label: String,
    /// Root mean square error, in the unit of all errors.
    pub rms: f64,
    /// Measured values without what effects of the measurement add, SI.
    pub measured: Vec<f64>,
    /// Prediction of every row, SI.
    pub predicted: &'a [f64],
    /// Measured less predicted, SI.
    pub residuals: Vec<f64>,
    /// Noise by which the rows are judged.
    pub noise: &'a Noise,
}

impl Step<'_> {
    /// The rows as figures show them.
    pub fn judged(&self) -> Judged<'_> {
        let Self { measured, predicted, residuals, noise, .. } = self;
        Judged { measured, predicted, residuals, noise }
    }
}

/// Measured values, and residuals, without what effects of the measurement most probably add to them.
fn unshared(observed: &[f64], residuals: &[f64], noise: &Noise) -> (Vec<f64>, Vec<f64>) {
    let left = noise.unshared(residuals);
    let measured = observed.iter().zip(residuals).zip(&*left).map(|((y, r), l)| y - (r - l));
    (measured.collect(), left.into_owned())
}

/// The steps: of several models, each; of one, the model re-fitted and each missing effect added to it. And the
/// measurements that they leave something of: all are compared, some may be too many for a diagnosis.
pub fn steps<'a>(subject: &Subject<'a>, found: &Evidence<'a>) -> (Vec<Step<'a>>, &'a Data<'a>) {
    let kind = found.data.kind();
    let compared = || {
        let one = |c: &'a Comparison| {
            let (measured, residuals) = unshared(&found.all.observed, &c.residuals, &c.noise);
            let (label, rms) = (c.model.clone(), kind.from_si(c.rms));
            Step { label, rms, measured, predicted: &c.predicted, residuals, noise: &c.noise }
        };
        (found.comparisons.iter().map(one).collect(), found.all)
    };
    let Some(d) = found.diagnosis else { return compared() };
    if subject.models.len() > 1 && !found.comparisons.is_empty() {
        return compared();
    }
    let noise = &d.fit.noise;
    let first = format!("{} re-fitted", subject.model().source.name);
    let labels = std::iter::once(first).chain(d.missing.iter().map(|m| format!("+ {}", label(m))));
    let goodness = std::iter::once(&d.before).chain(d.missing.iter().map(|m| &m.goodness));
    let mut is_shared = !found.data.terms.is_empty();
    let causes = std::iter::once(None).chain(d.missing.iter().map(|m| Some(&m.cause)));
    let mut all = Vec::new();
    for ((label, goodness), cause) in labels.zip(goodness).zip(causes) {
        is_shared |= matches!(cause, Some(Cause::Measurement { .. }));
        let (observed, residuals) = (&found.data.observed, found.data.residuals(&goodness.predicted));
        let (measured, residuals) = match is_shared {
            true => unshared(observed, &residuals, noise),
            false => (observed.clone(), residuals),
        };
        let rms = kind.from_si(goodness.rms);
        all.push(Step { label, rms, measured, predicted: &goodness.predicted, residuals, noise });
    }
    all.retain(|step| step.predicted.len() == found.data.len() && noise.sigma.len() == found.data.len());
    (all, found.data)
}
