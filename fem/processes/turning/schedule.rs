//! When and after how much cutting each point of each part is turned.

use super::events::{Events, InsertChange, Pause};
use crate::process::Segment;

/// One pass of the tool along the shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// m from the headstock.
    pub from: f64,
    /// m from the headstock.
    pub to: f64,
    /// m per radian of the spindle.
    pub feed: f64,
    /// rad/s.
    pub spindle_speed: f64,
}

impl Pass {
    /// Speed of the tool along the shaft, m/s.
    pub fn speed(&self) -> f64 {
        self.feed * self.spindle_speed
    }

    /// Cutting time, s.
    pub fn duration(&self) -> f64 {
        (self.to - self.from).abs() / self.speed()
    }

    /// Smallest and largest x, m.
    pub fn ends(&self) -> (f64, f64) {
        (self.from.min(self.to), self.from.max(self.to))
    }
}

/// The batch: part k starts (k − 1) cycles and all earlier pauses after the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// The pass, the same on every part.
    pub pass: Pass,
    /// How many parts.
    pub parts: usize,
    /// Start of the last pass of each part and of one more, s since the start of the batch.
    starts: Vec<f64>,
    /// Start to start where nothing pauses, s.
    pub cycle_time: f64,
    /// (x, ∫₀ˣ D/2 dx) at the ends of the segments.
    swept: Vec<(f64, f64)>,
    /// Events between parts.
    pub events: Events,
}

impl Schedule {
    /// `earlier` is how long the passes before take on each part, s.
    pub fn new(
        pass: Pass,
        earlier: f64,
        (parts, cycle_time): (usize, f64),
        events: Events,
        segments: &[Segment],
    ) -> Self {
        let mut pauses = events.pauses.iter().peekable();
        let mut rested = 0.0;
        let start = |part: usize| {
            while let Some(pause) = pauses.next_if(|p: &&Pause| p.after < part) {
                rested += pause.duration;
            }
            (part - 1) as f64 * cycle_time + rested + earlier
        };
        let starts = (1..=parts + 1).map(start).collect();
        let mut swept = vec![(0.0, 0.0)];
        let (mut x, mut area) = (0.0, 0.0);
        for segment in segments {
            x += segment.length;
            area += 0.5 * segment.section.diameter * segment.length;
            swept.push((x, area));
        }
        Self { pass, parts, starts, cycle_time, swept, events }
    }

    /// Start of the last pass of `part` (from 1), s; parts beyond the batch, for which an experiment may ask, follow without
    /// a pause.
    pub fn start(&self, part: usize) -> f64 {
        let last = self.starts.len().saturating_sub(1);
        let number = part.saturating_sub(1);
        let known = self.starts.get(number.min(last)).copied().unwrap_or(0.0);
        known + number.saturating_sub(last) as f64 * self.cycle_time
    }

    /// How long the batch takes with all pauses, s.
    pub fn duration(&self) -> f64 {
        let pauses: f64 = self.events.pauses.iter().map(|pause| pause.duration).sum();
        self.parts as f64 * self.cycle_time + pauses
    }

    /// When the tool is at `x` on `part`, s since the start of the batch.
    pub fn time(&self, part: usize, x: f64) -> f64 {
        self.start(part) + (x - self.pass.from).abs() / self.pass.speed()
    }

    /// Cutting path of the insert until it is at `x` on `part`, m: ∫πD dx per feed, over this part and all
    /// since the insert was changed.
    pub fn path(&self, part: usize, x: f64) -> f64 {
        let whole = self.path_between(self.pass.from, self.pass.to);
        part.saturating_sub(1 + self.new_since(part)) as f64 * whole + self.path_between(self.pass.from, x)
    }

    /// Longest cutting path of an insert, m.
    pub fn longest_path(&self) -> f64 {
        let ends = self.events.inserts.iter().map(|insert| insert.after).chain([self.parts]);
        ends.map(|part| self.path(part, self.pass.to)).fold(f64::NAN, f64::max)
    }

    /// The part after which the insert that cuts `part` was new; 0 for that of the first.
    pub fn new_since(&self, part: usize) -> usize {
        self.insert_of(part).map_or(0, |insert| insert.after)
    }

    /// By how much larger `part` is for what was entered and for how its insert sits, m.
    pub fn correction(&self, part: usize) -> f64 {
        let corrections = self.events.corrections.iter().take_while(|correction| correction.after < part);
        let entered: f64 = corrections.map(|correction| correction.diameter).sum();
        entered + self.insert_of(part).map_or(0.0, |insert| insert.diameter)
    }

    fn insert_of(&self, part: usize) -> Option<&InsertChange> {
        self.events.inserts.iter().rfind(|insert| insert.after < part)
    }

    /// The work turns by dx/feed (rad) under the tool, whose edge then passes D/2 per radian.
    fn path_between(&self, a: f64, b: f64) -> f64 {
        (self.swept_to(b) - self.swept_to(a)).abs() / self.pass.feed
    }

    fn swept_to(&self, x: f64) -> f64 {
        let i = self.swept.partition_point(|s| s.0 < x).clamp(1, self.swept.len() - 1);
        let ((x0, s0), (x1, s1)) = (self.swept[i - 1], self.swept[i]);
        s0 + (s1 - s0) * (x - x0) / (x1 - x0)
    }
}
