//! How finely a program is written.

use crate::input::Reader;
use crate::units::{LENGTH, MICRO};

/// Chord tolerance where a model does not say, m.
const CHORD: f64 = 1e-6;

/// How finely a program is written. SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// How far straight lines may lie off the contour that they stand for, m.
    pub chord_tolerance: f64,
    /// Least increment of words across, m; that of most controls if none is stated.
    pub increment: Option<f64>,
}

impl Default for Fineness {
    fn default() -> Self {
        Self { chord_tolerance: CHORD, increment: None }
    }
}

impl Fineness {
    /// Reads the keys of it in `[program]`.
    pub fn read(t: &Reader) -> Self {
        let chord = t.quantity("chord_tolerance", MICRO, "how far straight blocks may lie off the corrected contour");
        let chord_tolerance = chord.chosen().positive().or(CHORD);
        let about = "least increment of the corrected words; 0.001 mm or 0.0001 in if left out";
        let increment = t.quantity("increment", LENGTH, about).chosen().positive().optional();
        Self { chord_tolerance, increment }
    }
}
