//! Where a lathe program lies on the shaft: the table `[program]`.

use std::f64::consts::TAU;

use super::schedule::Pass;
use crate::gcode::{Across, LATHE, Stretch, Workpiece};
use crate::input::Reader;
use crate::process::Segment;
use crate::units::{LENGTH, MICRO};

/// Chord tolerance where a model does not say, m.
const CHORD: f64 = 1e-6;
/// How far a finished radius may lie off that of the drawing: half of the last depth of cut, for what is left to cut is no finished
/// surface, and at least and at most this, m.
const AGREEMENT: (f64, f64) = (20e-6, 100e-6);

/// What a model says of programs. SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Programs {
    /// Distance from the headstock at which Z is 0, m.
    zero: f64,
    across: Across,
    chord_tolerance: f64,
    increment: Option<f64>,
}

impl Programs {
    /// Reads `[program]`.
    pub fn read(model: &Reader, length: f64) -> Self {
        const WORDS: &[(&str, Across)] = &[("diameter", Across::Diameter), ("radius", Across::Radius)];
        let read = |t: &Reader| {
            let zero = t.quantity("zero", LENGTH, "where Z is 0, from the headstock; the tailstock end if left out");
            let zero = zero.chosen().or(length);
            let across = t.choice("x", "what X says where the program does not", WORDS).or_first(Across::Diameter);
            let chord =
                t.quantity("chord_tolerance", MICRO, "how far straight blocks may lie off the corrected contour");
            let chord_tolerance = chord.chosen().positive().or(CHORD);
            let increment =
                t.quantity("increment", LENGTH, "least increment of X words; 0.001 mm or 0.0001 in if left out");
            Self { zero, across, chord_tolerance, increment: increment.chosen().positive().optional() }
        };
        let absent = Self { zero: length, across: Across::Diameter, chord_tolerance: CHORD, increment: None };
        model.optional_table("program", "where the lathe program lies on the shaft", read).unwrap_or(absent)
    }

    /// The shaft as its program sees it, given the pass and the depth (m) of the last cut.
    pub fn workpiece(&self, segments: &[Segment], pass: Pass, depth: f64) -> Workpiece {
        let mut from = 0.0;
        let stretch = |segment: &Segment| {
            let own = Stretch { from, to: from + segment.length, radius: 0.5 * segment.section.diameter };
            from = own.to;
            own
        };
        Workpiece {
            axes: LATHE,
            zero: self.zero,
            across: self.across,
            chord_tolerance: self.chord_tolerance,
            increment: self.increment,
            agreement: (0.5 * depth).clamp(AGREEMENT.0, AGREEMENT.1),
            stretches: segments.iter().map(stretch).collect(),
            pass: [pass.from, pass.to],
            feed: TAU * pass.feed,
        }
    }
}
