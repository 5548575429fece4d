//! By how much a blank is off along the part, before the cut that copies it.

use std::f64::consts::TAU;

use super::polyline::on_lines;
use crate::input::Reader;
use crate::units::{ANGLE, LENGTH, NUMBER};

/// Words of a process for the error of its blanks.
pub struct BlankWords {
    /// Description of the list `blank`.
    pub waves: &'static str,
    /// Description of a wave's number: the length along which waves are counted.
    pub along: &'static str,
    /// Description of a wave's amplitude.
    pub amplitude: &'static str,
    /// Description of a wave's phase, with the place from which it counts.
    pub phase: &'static str,
    /// Description of the list `blank_points`.
    pub points: &'static str,
    /// Description of a point's place, with the end from which it counts.
    pub at: &'static str,
    /// Description of a point's error, with the meaning of its sign.
    pub error: &'static str,
    /// Word for the part that is cut.
    pub part: &'static str,
    /// Place at which the part begins.
    pub beginning: &'static str,
}

/// The error of a blank along the part: waves, and points with straight lines between; m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlankProfile {
    waves: Vec<Wave>,
    /// (x, error), rising.
    points: Vec<(f64, f64)>,
}

/// A wave of a blank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Along the whole part, or once around it.
    pub waves: f64,
    /// m.
    pub amplitude: f64,
    /// rad.
    pub phase: f64,
}

impl BlankProfile {
    /// Reads `blank` and `blank_points` of a part of `length` m.
    pub fn read(t: &Reader, length: f64, words: &BlankWords) -> Self {
        let waves = t.list("blank", words.waves, |t, _| Wave {
            waves: t.quantity("waves", NUMBER, words.along).not_negative().required(),
            amplitude: t.quantity("amplitude", LENGTH, words.amplitude).required(),
            phase: t.quantity("phase", ANGLE, words.phase).or(0.0),
        });
        let points = t.list("blank_points", words.points, |t, _| {
            let at = t.quantity("at", LENGTH, words.at).not_negative().required();
            if at > length * (1.0 + 1e-12) {
                let (message, length) = (format!("the place lies beyond the {}", words.part), LENGTH.format(length));
                t.problem("at", message, format!("the {} is {length} long", words.part));
            }
            (at, t.quantity("error", LENGTH, words.error).required())
        });
        if points.windows(2).any(|w| w[1].0 <= w[0].0) {
            let help = format!("give them from {} on, each once", words.beginning);
            t.problem("blank_points", "the places do not rise", help);
        }
        Self { waves, points }
    }

    /// Whether there is no error.
    pub fn is_true(&self) -> bool {
        self.waves.is_empty() && self.points.is_empty()
    }

    /// Error at x on a part of `length`, m.
    pub fn error(&self, x: f64, length: f64) -> f64 {
        let wave = |w: &Wave| w.amplitude * (TAU * w.waves * x / length - w.phase).cos();
        let next = self.points.partition_point(|p| p.0 <= x);
        let between = on_lines(next, self.points.len(), |i| self.points[i], x);
        self.waves.iter().map(wave).sum::<f64>() + between
    }
}
