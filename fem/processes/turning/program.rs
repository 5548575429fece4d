//! Where a lathe program lies on the shaft: the table `[program]`.

use std::f64::consts::TAU;

use super::schedule::Pass;
use crate::gcode::{Across, Fineness, LATHE, Spot, Stretch, Workpiece};
use crate::input::Reader;
use crate::process::Segment;
use crate::units::LENGTH;

/// What a model says of programs. SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Programs {
    /// Distance from the headstock at which Z is 0, m.
    zero: f64,
    across: Across,
    fineness: Fineness,
}

impl Programs {
    /// Reads `[program]`.
    pub fn read(model: &Reader, length: f64) -> Self {
        const WORDS: &[(&str, Across)] = &[("diameter", Across::Diameter), ("radius", Across::Radius)];
        let read = |t: &Reader| {
            let zero = t.quantity("zero", LENGTH, "where Z is 0, from the headstock; the tailstock end if left out");
            let zero = zero.chosen().or(length);
            let across = t.choice("x", "what X says where the program does not", WORDS).or_first(Across::Diameter);
            Self { zero, across, fineness: Fineness::read(t) }
        };
        let absent = Self { zero: length, across: Across::Diameter, fineness: Fineness::default() };
        model.optional_table("program", "where the lathe program lies on the shaft", read).unwrap_or(absent)
    }

    /// The shaft as its program sees it, given the pass and the depth (m) of the last cut.
    pub fn workpiece(&self, segments: &[Segment], pass: Pass, depth: f64) -> Workpiece {
        let mut from = 0.0;
        let stretch = |segment: &Segment| {
            let own = Stretch { from, to: from + segment.length, level: 0.5 * segment.section.diameter };
            from = own.to;
            own
        };
        Workpiece {
            axes: LATHE,
            zero: Spot { x: self.zero, ..Spot::default() },
            across: self.across,
            fineness: self.fineness,
            agreement: Workpiece::agreement(Some(depth)),
            stretches: segments.iter().map(stretch).collect(),
            breadth: None,
            pass: [pass.from, pass.to],
            feed: Some(TAU * pass.feed),
        }
    }
}
