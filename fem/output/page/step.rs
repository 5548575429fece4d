//! The error falling: models, or one model and its missing effects, with what each leaves.

use super::subject::{Evidence, Subject};
use crate::diagnose::Cause;
use crate::noise::Noise;
use crate::output::diagnosis::label;

/// A model on the way to the noise.
pub struct Step<'a> {
    /// The effect that was added, or the model's name.
    pub label: String,
    /// Root mean square error, in the unit of all errors.
    pub rms: f64,
    /// Reduced χ².
    pub reduced_chi2: f64,
    /// Root mean square error of rows that were held out, in the same unit.
    pub held_out: Option<f64>,
    /// Prediction of every row, SI.
    pub predicted: &'a [f64],
    /// Measured less predicted, without what effects of the measurement add, SI.
    pub residuals: Vec<f64>,
    /// Noise by which the rows are judged.
    pub noise: &'a Noise,
}

/// The steps: of several models, each; of one, the model re-fitted and each missing effect added to it.
pub fn steps<'a>(subject: &Subject<'a>, found: &Evidence<'a>) -> Vec<Step<'a>> {
    let kind = found.data.kind();
    let compared = || {
        let one = |c: &'a crate::compare::Comparison| Step {
            label: c.model.clone(),
            rms: kind.from_si(c.rms),
            reduced_chi2: c.reduced_chi2,
            held_out: None,
            predicted: &c.predicted,
            residuals: c.noise.unshared(&c.residuals).into_owned(),
            noise: &c.noise,
        };
        found.comparisons.iter().map(one).collect()
    };
    let Some(d) = found.diagnosis else { return compared() };
    if subject.models.len() > 1 && !found.comparisons.is_empty() {
        return compared();
    }
    let sigma = kind.from_si(d.noise.together());
    let noise = &d.fit.noise;
    let first = format!("{} re-fitted", subject.model().source.name);
    let labels = std::iter::once(first).chain(d.missing.iter().map(|m| format!("+ {}", label(m))));
    let goodness = std::iter::once(&d.before).chain(d.missing.iter().map(|m| &m.goodness));
    let mut is_shared = !found.data.terms.is_empty();
    let causes = std::iter::once(None).chain(d.missing.iter().map(|m| Some(&m.cause)));
    let mut all = Vec::new();
    for ((label, goodness), cause) in labels.zip(goodness).zip(causes) {
        is_shared |= matches!(cause, Some(Cause::Measurement { .. }));
        let residuals = found.data.residuals(&goodness.predicted);
        all.push(Step {
            label,
            rms: kind.from_si(goodness.rms),
            reduced_chi2: goodness.reduced_chi2,
            held_out: goodness.cross_validation.filter(|h| h.is_finite()).map(|h| h * sigma),
            predicted: &goodness.predicted,
            residuals: if is_shared { noise.unshared(&residuals).into_owned() } else { residuals },
            noise,
        });
    }
    all.retain(|step| step.predicted.len() == found.data.len() && noise.sigma.len() == found.data.len());
    all
}
