//! The stated uncertainty is off by a factor.

use super::super::evidence::Evidence;
use super::super::term::{Acts, MeasurementEffect, Size, Term};

/// The column `u` is off by a factor.
pub static UNCERTAINTY_SCALE: MeasurementEffect = MeasurementEffect {
    name: "uncertainty-scale",
    about: "the stated uncertainty `u` is off by a factor",
    law: "standard deviation of a row = factor * u",
    source: "Birge, The calculation of errors by the method of least squares, Phys. Rev. 40, 1932",
    separates: "repeat some rows: their scatter is the uncertainty",
    size: Size::Number("factor", "by which every `u` is multiplied"),
    example: "2",
    acts: Acts::Scales,
    ..MeasurementEffect::USUAL
};

/// Once, where there is a `u` to multiply.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let is_stated = evidence.measurements.uncertainty.is_some();
    let is_sought = is_stated && !evidence.has(|acts| matches!(acts, Acts::Scales));
    if is_sought { vec![evidence.and(Term::new(&UNCERTAINTY_SCALE))] } else { Vec::new() }
}
