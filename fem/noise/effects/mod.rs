//! The catalogue of measurement effects: what instrument, datum and surroundings do to data, the same in
//! every process.

mod alignment;
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

pub use alignment::{ALIGNMENT, ALIGNMENT_OFFSET};
pub use clock::CLOCK;
pub use correlated_noise::CORRELATED_NOISE;
pub use covariance::COVARIANCE;
pub use discrepancy::DISCREPANCY;
pub use drift::DRIFT;
pub use gain::GAIN;
pub use jump::JUMP;
pub use outliers::{OUTLIERS, OUTLYING};
pub use resolution::RESOLUTION;
pub use uncertainty_scale::UNCERTAINTY_SCALE;
pub use wave::WAVE;
pub use zero_shift::ZERO_SHIFT;

use super::term::MeasurementEffect;

/// Table of a model file for effects of the measurement, and the word by which all of them are asked for.
pub const MEASUREMENT: &str = "measurement";

/// All of them, in the order in which people meet them.
pub static ALL: &[&MeasurementEffect] = &[
    &ZERO_SHIFT,
    &OUTLIERS,
    &CORRELATED_NOISE,
    &UNCERTAINTY_SCALE,
    &RESOLUTION,
    &DRIFT,
    &JUMP,
    &GAIN,
    &ALIGNMENT,
    &CLOCK,
    &COVARIANCE,
    &WAVE,
    &DISCREPANCY,
];

impl MeasurementEffect {
    /// Whether it only describes what no law here has: it explains nothing.
    pub fn describes(&self) -> bool {
        [&DISCREPANCY, &WAVE].contains(&self)
    }
}
