//! The catalogue of measurement effects: what instrument, datum and surroundings do to data, the same in
//! every process.

mod correlated_noise;
mod discrepancy;
mod drift;
mod jump;
mod outliers;
mod uncertainty_scale;
mod zero_shift;

pub use correlated_noise::CORRELATED_NOISE;
pub use discrepancy::DISCREPANCY;
pub use drift::DRIFT;
pub use jump::JUMP;
pub use outliers::{OUTLIERS, OUTLYING};
pub use uncertainty_scale::UNCERTAINTY_SCALE;
pub use zero_shift::ZERO_SHIFT;

use super::term::MeasurementEffect;

/// All of them, in the order in which people meet them.
pub static ALL: &[&MeasurementEffect] =
    &[&ZERO_SHIFT, &OUTLIERS, &CORRELATED_NOISE, &UNCERTAINTY_SCALE, &DRIFT, &JUMP, &DISCREPANCY];
