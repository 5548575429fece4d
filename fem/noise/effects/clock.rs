//! The times of the file are late.

use super::super::key::OBSERVABLE;
use super::super::term::{Acts, MeasurementEffect, Size};
use crate::process::Parameter;
use crate::units::SECONDS;

/// Two hours: clocks that people set are minutes apart, and an hour where only one knows of summer time.
static DELAY: Parameter = Parameter::signed(
    "delay",
    SECONDS,
    "by which the times of the file are late; below zero where they are early",
    (1.0, 7200.0),
);

/// Every time that the file gives is late by a constant.
pub static CLOCK: MeasurementEffect = MeasurementEffect {
    name: "clock",
    about: "the times of the file are late by a constant: two clocks, or a reading that takes its time",
    law: "y = prediction at (time - delay), at the start where that is before it",
    source: "a shift of the time axis; Box, Jenkins & Reinsel, Time Series Analysis, 1994, ch. 10 (dead time)",
    separates: "switch something that both clocks see",
    size: Size::Quantity(&DELAY),
    keys: &[OBSERVABLE],
    example: "30 s",
    parameters: 0.0,
    // Before the start nothing changes.
    acts: Acts::Times(|delay, time| (time - delay).max(time.min(0.0))),
    ..MeasurementEffect::USUAL
};
