//! The instrument's scale is off.

use super::super::key::OBSERVABLE;
use super::super::term::{Acts, MeasurementEffect, Size};
use crate::process::Parameter;
use crate::units::Kind;

/// Kind of the factor: the example is a scale that shows two per cent too much.
const FACTOR: Kind = Kind::new("a pure number", "", "1.02");

/// A scale that is off by a fifth is broken rather than out of adjustment.
static OFF: Parameter = Parameter::factor("factor", FACTOR, "what the instrument shows over what there is", (0.8, 1.2));

/// The instrument shows a multiple of what there is.
pub static GAIN: MeasurementEffect = MeasurementEffect {
    name: "gain",
    about: "the scale of the instrument is off: it shows a multiple of what there is",
    law: "y = factor * prediction",
    source: "JCGM 200:2012 (VIM), 4.12 and 4.20: sensitivity and systematic error of a measuring system",
    separates: "measure a master of known size with the same instrument",
    size: Size::Quantity(&OFF),
    keys: &[OBSERVABLE],
    example: "1.02",
    parameters: 0.0,
    acts: Acts::Shows(|factor, value, _| (factor - 1.0) * value),
    ..MeasurementEffect::USUAL
};
