//! Sizes of effects of the measurement, estimated beside the parameters.

use super::estimates::Estimate;
use super::intervals::Interval;
use crate::input::{Bounds, Parameter};
use crate::measure::Measurements;
use crate::model::Data;
use crate::noise::{Acts, Noise, Restricted, Term};
use crate::units::{Knowledge, Quantity};

/// The size of a term with its 95 % interval, from the profile of the restricted likelihood.
pub fn size_estimate(
    term: &Term,
    measurements: &Measurements,
    restricted: &Restricted,
    noise: &Noise,
    number: usize,
) -> Estimate {
    let [low, high] = if term.effect.acts.is_estimated() { restricted.interval(noise, number) } else { [None, None] };
    let interval = Interval { low, high };
    let width = interval.high.zip(interval.low).map_or(f64::NAN, |(high, low)| (high - low) / 3.92);
    Estimate {
        parameter: Parameter {
            path: format!("measurement.{}.{}", term.name(), term.effect.size.key()).into(),
            kind: term.kind(measurements),
            quantity: Quantity { value: term.size, knowledge: Knowledge::Free },
            bounds: Bounds::NotNegative,
            span: None,
            doubt: None,
        },
        value: term.size,
        std: width,
        interval,
        warnings: Vec::new(),
        profile: Vec::new(),
    }
}

/// A size that the model leaves unknown, estimated from these rows.
#[derive(Clone, Debug)]
pub struct EstimatedSize {
    /// The term, with the size that was found.
    pub term: Term,
    /// The size with its interval.
    pub estimate: Estimate,
}

impl EstimatedSize {
    /// Whether the rows tell the size: its interval is closed, or it was read off their values.
    pub fn is_told(&self) -> bool {
        self.estimate.is_closed() || matches!(self.term.effect.acts, Acts::Rounds)
    }
}

/// The sizes that the model leaves unknown, as a noise has them.
pub fn estimated(data: &Data, restricted: &Restricted, noise: &Noise) -> Vec<EstimatedSize> {
    let unknown = noise.terms.iter().enumerate().filter(|(_, term)| data.model.is_unknown(term));
    let estimate = |(number, term): (usize, &Term)| EstimatedSize {
        term: term.clone(),
        estimate: size_estimate(term, data, restricted, noise, number),
    };
    unknown.map(estimate).collect()
}
