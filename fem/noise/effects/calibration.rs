//! The characteristic of a sensor: what it shows over what there is.

use super::super::key::{HIGH, LOW, OBSERVABLE};
use super::super::term::{Acts, MeasurementEffect, Size};
use crate::process::Parameter;
use crate::units::{Kind, MICRO};

/// Kind of the factor: the example is a scale that shows two parts in a thousand too much.
const FACTOR: Kind = Kind::new("a pure number", "", "1.002");
/// Where the cubic s - s^3 is largest it is 2/(3*sqrt(3)).
const LARGEST_CUBIC: f64 = 0.384_900_179_459_750_5;

static OFFSET: Parameter = Parameter::signed("offset", MICRO, "what it shows of nothing", (0.0, 100.0));
static SCALE: Parameter = Parameter::factor("scale", FACTOR, "what it shows over what there is", (0.9, 1.1));
static BOW: Parameter =
    Parameter::signed("bow", MICRO, "what it shows too much half way between `low` and `high`", (0.01, 10.0));
static S_BEND: Parameter = Parameter::signed(
    "s_bend",
    MICRO,
    "what it shows too much at 0.79 of the way from `low` to `high`, and too little at 0.21",
    (0.01, 10.0),
);

/// The characteristic of the sensor is a polynomial: an offset, a scale, and how far it bends away from that line.
pub static CALIBRATION: MeasurementEffect = MeasurementEffect { beside: &[&OFFSETS, &SCALES, &S_BENDS], ..BOWED };

const BOWED: MeasurementEffect = MeasurementEffect {
    name: "calibration",
    about: "the characteristic of the sensor: an offset, a scale and a curve, each as well as its certificate knows it",
    law: "y = prediction + offset + (scale - 1)*prediction + bow*(1 - s^2) + s_bend*2.598*(s - s^3), s from -1 at low to 1 at high",
    source: "JCGM 200:2012 (VIM), 4.30 and 4.31: calibration diagram and curve; IEC 60770-1: conformity of a characteristic",
    separates: "measure masters of known size at both ends and half way with the same instrument",
    size: Size::OfReading(&BOW),
    keys: &[OBSERVABLE, LOW, HIGH],
    example: "0.8 +- 0.3 um",
    parameters: 0.0,
    acts: Acts::Shows(|bow, _, s| bow * (1.0 - s * s)),
    ..MeasurementEffect::USUAL
};

static OFFSETS: MeasurementEffect = MeasurementEffect {
    size: Size::OfReading(&OFFSET),
    acts: Acts::Shows(|offset, _, _| offset),
    beside: &[&CALIBRATION],
    example: "0.3 +- 0.1 um",
    ..BOWED
};

static SCALES: MeasurementEffect = MeasurementEffect {
    size: Size::Quantity(&SCALE),
    acts: Acts::Shows(|scale, value, _| (scale - 1.0) * value),
    beside: &[&CALIBRATION],
    example: "1.002 +- 0.001",
    ..BOWED
};

static S_BENDS: MeasurementEffect = MeasurementEffect {
    size: Size::OfReading(&S_BEND),
    acts: Acts::Shows(|bend, _, s| bend * (s - s * s * s) / LARGEST_CUBIC),
    beside: &[&CALIBRATION],
    example: "",
    ..BOWED
};
