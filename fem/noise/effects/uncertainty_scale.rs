//! The stated uncertainty is off by a factor.

use super::super::term::{Acts, MeasurementEffect, Size};

/// The column `u` is off by a factor.
pub static UNCERTAINTY_SCALE: MeasurementEffect = MeasurementEffect {
    name: "uncertainty-scale",
    about: "the stated uncertainty `u` is off by a factor",
    law: "standard deviation of a row = factor * u",
    source: "Birge, The calculation of errors by the method of least squares, Phys. Rev. 40, 1932",
    separates: "repeat some rows: their scatter is the uncertainty",
    size: Size::Number("factor", "by which every `u` is multiplied"),
    acts: Acts::Scales,
};
