//! The motion that slide and cam make of a programme.

use std::f64::consts::TAU;

use super::leg::Leg;
use super::play::play;

/// The commands of a turn: places of slide and cam when blocks begin, and at the end of the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Times, s; rising from 0.
    pub times: Vec<f64>,
    /// Polar angle of the wheel's centre in the cam, counted on, rad.
    pub turns: Vec<f64>,
    /// Distance of the wheel's centre from the cam's axis, m.
    pub slides: Vec<f64>,
}

impl Axes {
    /// The same blocks from the last to the first.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let end = self.times.last().copied().unwrap_or(0.0);
        Self {
            times: self.times.iter().rev().map(|t| end - t).collect(),
            turns: self.turns.iter().rev().copied().collect(),
            slides: self.slides.iter().rev().copied().collect(),
        }
    }

    /// Time of a turn, s.
    fn period(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// Number of the block at a time within the turn.
    fn block(&self, time: f64) -> usize {
        self.times.partition_point(|t| *t <= time).clamp(1, self.times.len() - 1) - 1
    }

    /// Angle of the cam at any time, rad.
    fn turn(&self, time: f64) -> f64 {
        let rounds = (time / self.period()).floor();
        let time = time - rounds * self.period();
        let i = self.block(time);
        let part = (time - self.times[i]) / (self.times[i + 1] - self.times[i]);
        let around = TAU.copysign(self.turns[self.turns.len() - 1] - self.turns[0]);
        self.turns[i] + part * (self.turns[i + 1] - self.turns[i]) + rounds * around
    }

    /// Whether the cam turns at one speed.
    fn is_steady(&self) -> bool {
        let speed = |i: usize| (self.turns[i + 1] - self.turns[i]) / (self.times[i + 1] - self.times[i]);
        let mean = (self.turns[self.turns.len() - 1] - self.turns[0]) / self.period();
        (0..self.times.len() - 1).all(|i| (speed(i) - mean).abs() < 1e-9 * mean.abs())
    }
}

/// The legs of the motion when the slide is late by `lag` (s), driven through play of width `gap` (m), and
/// the wheel stands `height` (m) above the cam's axis. Legs belong to the blocks that the slide executes.
pub fn legs(axes: &Axes, lag: f64, gap: f64, height: f64) -> Vec<Leg> {
    let commands: Vec<(f64, f64)> = axes.times.iter().copied().zip(axes.slides.iter().copied()).collect();
    let mut bends = if gap > 0.0 { play(&commands, gap) } else { commands };
    if lag != 0.0 && !axes.is_steady() {
        // The cam bends when the slide, which is late, is in the middle of a block.
        let period = axes.period();
        let times = axes.times[1..].iter().map(|t| (t - lag).rem_euclid(period));
        let between: Vec<(f64, f64)> = times.map(|time| (time, at(&bends, time))).collect();
        bends.extend(between);
        bends.sort_by(|a, b| a.0.total_cmp(&b.0));
        bends.dedup_by(|b, a| b.0 - a.0 < 1e-12 * period);
    }
    let leg = |w: &[(f64, f64)]| {
        let ((from, slide), (to, next)) = (w[0], w[1]);
        let block = axes.block(0.5 * (from + to));
        let (start, length) = (axes.times[block], axes.times[block + 1] - axes.times[block]);
        let turns = if lag == 0.0 && (from, to) == (start, axes.times[block + 1]) {
            (axes.turns[block], axes.turns[block + 1])
        } else {
            // Seen from inside the leg, so that at a bend of the cam the right side is taken.
            let (inside, end) = (axes.turn(0.5 * (from + to) + lag), axes.turn(from + lag));
            (end, 2.0 * inside - end)
        };
        let part = ((from - start) / length, (to - start) / length);
        Leg::new((turns.0, turns.1 - turns.0), (slide, next - slide), height, block, part)
    };
    bends.windows(2).map(leg).collect()
}

/// Linear between bends.
fn at(bends: &[(f64, f64)], time: f64) -> f64 {
    let i = bends.partition_point(|b| b.0 <= time).clamp(1, bends.len() - 1);
    let (a, b) = (bends[i - 1], bends[i]);
    a.1 + (b.1 - a.1) * (time - a.0) / (b.0 - a.0)
}
