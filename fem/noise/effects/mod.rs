//! The catalogue of measurement effects: what instrument, datum and surroundings do to data, the same in
//! every process.

mod alignment;
mod calibration;
mod clock;
mod correlated_noise;
mod covariance;
mod discrepancy;
mod drift;
mod gain;
mod jump;
mod outliers;
mod resolution;
mod uncertainty_scale;
mod wave;
mod zero_shift;

pub use alignment::ALIGNMENT;
pub use calibration::CALIBRATION;
pub use clock::CLOCK;
pub use correlated_noise::CORRELATED_NOISE;
pub use covariance::COVARIANCE;
pub use discrepancy::DISCREPANCY;
pub use drift::DRIFT;
pub use gain::GAIN;
pub use jump::JUMP;
pub use outliers::{OUTLIERS, contradictions, of as outlying, outlying_by};
pub use resolution::RESOLUTION;
pub use uncertainty_scale::UNCERTAINTY_SCALE;
pub use wave::WAVE;
pub use zero_shift::ZERO_SHIFT;

use super::evidence::Evidence;
use super::term::{MeasurementEffect, Term};
use crate::input::is_one_of;

/// Table of a model file for effects of the measurement, and the word by which all of them are asked for.
pub const MEASUREMENT: &str = "measurement";

/// Sets of terms that residuals may ask for: those at work with one or two more, their sizes still to be found.
pub type Seek = fn(&Evidence) -> Vec<Vec<Term>>;

/// When residuals are asked for an effect.
#[derive(Clone, Copy)]
pub enum Sought {
    /// Never: a model states it, or a search has it among the effects of the machine.
    Never,
    /// Beside those of the machine.
    Beside(Seek),
    /// Where nothing else explains them.
    Last(Seek),
}

/// All of them, in the order in which people meet them, and how residuals ask for each.
pub static ALL: &[(&MeasurementEffect, Sought)] = &[
    (&ZERO_SHIFT, Sought::Beside(zero_shift::sought)),
    (&OUTLIERS, Sought::Beside(outliers::sought)),
    (&CORRELATED_NOISE, Sought::Beside(correlated_noise::sought)),
    (&UNCERTAINTY_SCALE, Sought::Beside(uncertainty_scale::sought)),
    (&RESOLUTION, Sought::Beside(resolution::sought)),
    (&DRIFT, Sought::Beside(drift::sought)),
    (&JUMP, Sought::Beside(jump::sought)),
    (&GAIN, Sought::Never),
    (&CALIBRATION, Sought::Never),
    (&ALIGNMENT, Sought::Beside(alignment::sought)),
    (&CLOCK, Sought::Never),
    (&COVARIANCE, Sought::Never),
    (&WAVE, Sought::Beside(wave::sought)),
    (&DISCREPANCY, Sought::Last(discrepancy::sought)),
];

/// All of them, without how they are sought.
pub fn all() -> impl Iterator<Item = &'static MeasurementEffect> {
    ALL.iter().map(|(effect, _)| *effect)
}

/// Finds an effect of the measurement by the name of its table, which may be a further one: `zero-shift-2`.
pub fn named(table: &str) -> Option<&'static MeasurementEffect> {
    all().find(|effect| is_one_of(table, effect.name))
}

/// Sets of terms beside those at work that the residuals may ask for, and with `last` those that describe what
/// nothing else explains.
pub fn sought(evidence: &Evidence, last: bool) -> Vec<Vec<Term>> {
    /// Fewest rows in which terms are sought.
    const LEAST_ROWS: usize = 8;
    if evidence.measurements.len() < LEAST_ROWS {
        return Vec::new();
    }
    let seek = |(_, sought): &(&MeasurementEffect, Sought)| match *sought {
        Sought::Beside(seek) if !last => seek(evidence),
        Sought::Last(seek) if last => seek(evidence),
        _ => Vec::new(),
    };
    ALL.iter().flat_map(seek).collect()
}
