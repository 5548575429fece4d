//! The result of a diagnosis.

use super::bent_law::Bend;
use super::detection_limit::DetectionLimit;
use super::free_law::FreeLaw;
use super::largest_change::LargestChange;
use super::next::Next;
use super::posterior::Posterior;
use super::verdict::{GoodnessOfFit, Verdict};
use crate::compare::{Feature, Judges};
use crate::fit::{Estimate, Fit};
use crate::input::Name;
use crate::noise::{MeasurementEffect, NoiseLevel, Term};
use crate::process::Description;
use crate::units::Kind;

/// Diagnosis of a model. SI units.
#[non_exhaustive]
pub struct Diagnosis {
    /// Number of rows that were used; all of them unless there are very many.
    pub rows: usize,
    /// Cautions about the data, to be read before the rest is believed.
    pub cautions: Vec<String>,
    /// Noise that the model with all that was found is told by.
    #[doc(hidden)]
    pub noise: NoiseLevel,
    /// Goodness of fit of the model with its own parameters re-fitted.
    pub before: GoodnessOfFit,
    /// Structure of its residuals.
    #[doc(hidden)]
    pub features: Vec<Feature>,
    /// Verdict.
    pub verdict: Verdict,
    /// Paths of values that are taken as unknown here, because the data contradict what is roughly known of them.
    pub released: Vec<String>,
    /// What these rows can tell of a model.
    #[doc(hidden)]
    pub judges: Judges,
    /// Missing effects, what rows share first, in the order in which they should be added.
    pub missing: Vec<Missing>,
    /// Rows that are wrong by themselves, weighed down.
    #[doc(hidden)]
    pub outliers: Vec<Outlier>,
    /// Verdict on the model with all of it.
    pub verdict_after: Verdict,
    /// Goodness of fit of the model with all of them.
    pub after: GoodnessOfFit,
    /// Fit of all parameters, the model's own and those of the effects.
    pub fit: Fit,
    /// Structure of the residuals that remain.
    #[doc(hidden)]
    pub remaining: Vec<Feature>,
    /// Effects of the measurement that the residuals still ask for, where they have no other structure.
    #[doc(hidden)]
    pub suspects: Vec<Term>,
    /// Evaluation of every effect that the model does not have.
    #[doc(hidden)]
    pub candidates: Vec<Outlook>,
    /// Posterior over the sets of effects.
    #[doc(hidden)]
    pub posterior: Posterior,
    /// Next measurement, where effects are confounded.
    #[doc(hidden)]
    pub next: Option<Next>,
    /// −2 ln of the likelihood of what is told, its price included: ln n for every value that was added, the odds of the
    /// effects, and the price of the noise.
    #[doc(hidden)]
    pub criterion: f64,
    /// Coordinate by which rows were held out in cross-validation.
    #[doc(hidden)]
    pub cross_validation_by: Option<Name>,
    /// Number of evaluations at which the model could not be computed, and of all evaluations.
    pub trials: (usize, usize),
}

impl Diagnosis {
    /// The noise that a comparison of the model tells; where stated uncertainties were found to be others, what is left.
    #[must_use]
    #[doc(hidden)]
    pub fn noise_before(&self) -> &NoiseLevel {
        if self.noise.factor == 1.0 { &self.before.noise } else { &self.noise }
    }

    /// Whether something remains that no effect explains.
    #[must_use]
    pub fn leaves_structure(&self) -> bool {
        matches!(self.verdict, Verdict::PartlyExplained | Verdict::Unexplained)
    }
}

/// A row that lies far outside of what the others scatter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlier {
    /// Record of the file, counted from 1.
    pub record: usize,
    /// Number of its observable among the file's.
    pub observable: usize,
    /// Line of the file.
    pub line: u64,
    /// Observed value, SI.
    pub value: f64,
    /// Prediction of the best model, with what effects of the measurement add, SI.
    pub predicted: f64,
    /// Weight against other rows.
    pub weight: f64,
}

/// Origin of a missing effect: the physical system or the measurement.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// The machine's, the fixture's or the part's.
    Physical,
    /// A value that the model file has is wrong.
    Value {
        /// What is written, SI.
        written: f64,
    },
    /// A law that is in no catalogue: it describes.
    Law(FreeLaw),
    /// The measurement's.
    Measurement {
        /// Its entry in the catalogue.
        effect: &'static MeasurementEffect,
        /// Coordinates whose levels group the rows.
        by: Vec<Name>,
        /// Coordinate along which the part lies askew or a wave runs.
        along: Option<Name>,
        /// Period of a wave along it, SI, with its kind.
        period: Option<(f64, Kind)>,
        /// Observable on which it acts, where the file has several.
        observable: Option<Name>,
        /// Records of the file, counted from 1: those that are outlying, or the first after a step.
        records: Vec<usize>,
        /// Where the first row after a step stands, for people.
        from: Option<String>,
        /// First line of the file after a step.
        from_line: Option<u64>,
    },
}

impl Cause {
    /// An effect of the measurement on all rows.
    pub fn of(effect: &'static MeasurementEffect, observable: Option<Name>) -> Self {
        Self::Measurement {
            effect,
            by: Vec::new(),
            along: None,
            period: None,
            observable,
            records: Vec::new(),
            from: None,
            from_line: None,
        }
    }
}

/// An effect that is missing.
#[non_exhaustive]
pub struct Missing {
    /// Its origin.
    #[doc(hidden)]
    pub cause: Cause,
    /// The effect.
    pub effect: Description,
    /// Of the change of an effect: the values (SI) before it, in the order of its parameters behind the number after
    /// which it changed. Empty of any other effect.
    #[doc(hidden)]
    pub before: Vec<f64>,
    /// Probability that it is there, over all sets of effects that were weighed.
    pub probability: f64,
    /// Goodness of fit of the model with this and the effects before it.
    pub goodness: GoodnessOfFit,
    /// Probability that chance alone gains as much by any effect, the others being there (p-value of the
    /// maximum).
    pub p_value: f64,
    /// Estimates of its parameters, fitted with all others.
    pub estimates: Vec<Estimate>,
    /// Largest change that it makes in the rows; `None` where it changes none, as outlying rows do not.
    #[doc(hidden)]
    pub largest_change: Option<LargestChange>,
    /// Confounded effects: those that fit as well in its place.
    pub indistinguishable_from: Vec<Description>,
    /// How far and along what its law bends, where that describes much of what is left.
    #[doc(hidden)]
    pub bend: Option<Bend>,
    /// Why the measurement is not to be blamed for it: it may be a law of what the rows record. It describes then.
    #[doc(hidden)]
    pub doubt: Option<String>,
}

impl Missing {
    /// Whether it only describes what no law here has, or what may be of another origin.
    pub fn describes(&self) -> bool {
        match &self.cause {
            Cause::Law(_) => true,
            Cause::Measurement { effect, .. } => effect.describes() || self.doubt.is_some(),
            Cause::Physical | Cause::Value { .. } => false,
        }
    }
}

impl Verdict {
    /// The verdict where all of this is missing besides, terms of the noise among it.
    pub(super) fn beside(self, missing: &[Missing], has_terms: bool) -> Self {
        match self {
            _ if missing.iter().any(Missing::describes) => Self::beside_what_describes(missing),
            Self::Adequate if has_terms => Self::MissingEffect,
            Self::Unexplained if has_terms => Self::PartlyExplained,
            own => own,
        }
    }

    /// The verdict on a model some of which is only described: a curve, a wave or a zero that no law has explains nothing.
    pub fn beside_what_describes(missing: &[Missing]) -> Self {
        if missing.iter().all(Missing::describes) { Self::Unexplained } else { Self::PartlyExplained }
    }
}

/// Evaluation of one effect that the model does not have.
pub struct Outlook {
    /// The effect.
    pub effect: Description,
    /// Its probability, over all sets of effects.
    pub probability: f64,
    /// Root mean square residual with this effect alone added; `None` where it gains nothing or cannot be
    /// computed.
    pub rms: Option<f64>,
    /// Change of the penalised BIC (Schwarz's criterion) by it alone; a value below zero speaks for it.
    pub delta_bic: f64,
    /// Probability that chance alone gains as much by any effect (p-value of the maximum).
    pub p_value: f64,
    /// Detection limit of the effect in these data, in nine tenths of the weight of all sets that may be
    /// true.
    pub detection_limit: Option<DetectionLimit>,
}
