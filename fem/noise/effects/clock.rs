//! The times of the file are late.

use super::super::term::{Acts, MeasurementEffect, Size};
use crate::process::Parameter;
use crate::units::SECONDS;

/// Ten minutes are what two clocks that people set may differ by.
static DELAY: Parameter = Parameter::signed(
    "delay",
    SECONDS,
    "by which the times of the file are late; below zero where they are early",
    (1.0, 600.0),
);

/// Every time that the file gives is late by a constant.
pub static CLOCK: MeasurementEffect = MeasurementEffect {
    name: "clock",
    about: "the times of the file are late by a constant: two clocks, or a reading that takes its time",
    law: "y = prediction at (time - delay), at the start where that is before it",
    source: "a shift of the time axis; Box, Jenkins & Reinsel, Time Series Analysis, 1994, ch. 10 (dead time)",
    separates: "switch something that both clocks see",
    size: Size::Quantity(&DELAY),
    acts: Acts::Reads,
};
