//! The job: what is turned, how it is held, in what order, and where it is measured.

use super::set_up::SetUp;
use super::shaft::{Segment, Shaft};
use crate::job::{NoiseKind, Shown};

/// How the workpiece is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holding {
    /// Pinned, pinned.
    Centres,
    /// Clamped, free.
    Chuck,
    /// Clamped, pinned.
    ChuckAndCentre,
}

/// One measured row's coordinates.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Row {
    /// Part number from 1.
    pub part: usize,
    /// Place from the headstock, mm.
    pub x: f64,
    /// Nominal radial force of the row, N.
    pub force: f64,
    /// Diameter before the cut, mm, when the design measures it.
    pub blank: Option<f64>,
    /// Depth to which the row's cut was set, mm, where it is not the model's.
    pub depth: Option<f64>,
    /// Around the part, deg.
    pub angle: f64,
    /// What is added to the radius to which the last pass is programmed, um.
    pub radius_change: f64,
}

/// What was measured on the lathe itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// Clearance angle of the edge, deg.
    pub clearance: f64,
    /// Width of the wear land (mm) at cutting paths (m), rising from 0.
    pub land: Vec<(f64, f64)>,
    /// From the front to the rear guideway, mm.
    pub spacing: f64,
    /// Spindle axis above the guideways, mm.
    pub height: f64,
}

impl Survey {
    /// Width of the land after a path (m), straight between the points, mm.
    pub fn width(&self, path: f64) -> f64 {
        let span = self.land.windows(2).find(|pair| path <= pair[1].0).unwrap_or(&self.land[self.land.len() - 2..]);
        let ((from, narrow), (to, wide)) = (span[0], span[1]);
        narrow + (wide - narrow) * (path - from) / (to - from)
    }
}

/// A turning job with its measuring design.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// The finished shaft.
    pub shaft: Shaft,
    /// Workholding.
    pub holding: Holding,
    /// Nominal depth t_0, mm.
    pub depth: f64,
    /// Feed, mm/rev.
    pub feed: f64,
    /// Spindle speed, rpm.
    pub speed: f64,
    /// Nominal radial force, N.
    pub force: f64,
    /// Whether the tool runs from 0 to L and not, as by default, from L to 0.
    pub forward: bool,
    /// Parts in the batch.
    pub parts: usize,
    /// Start to start, min.
    pub cycle: f64,
    /// (after part, minutes).
    pub pauses: Vec<(usize, f64)>,
    /// Measured rows.
    pub rows: Vec<Row>,
    /// Whether the file has a force column.
    pub force_column: bool,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
    /// What is known of edge and bed, if they were measured.
    pub survey: Option<Survey>,
    /// What not every job has.
    pub set_up: SetUp,
}

impl Job {
    /// Feed speed of the tool, mm/min.
    pub fn tool_speed(&self) -> f64 {
        self.feed * self.speed
    }

    /// Cutting time of one part, min.
    pub fn cutting_time(&self) -> f64 {
        self.shaft.length() / self.tool_speed()
    }

    /// When part `k` starts: (k-1) cycle_time + all pauses after earlier parts, min.
    pub fn start(&self, part: usize) -> f64 {
        let paused: f64 = self.pauses.iter().filter(|(after, _)| *after < part).map(|(_, minutes)| minutes).sum();
        (part - 1) as f64 * self.cycle + paused
    }

    /// Whether the slide moved outwards when it last moved on the way to x: of the sections that the tool has left, the
    /// last of another diameter is smaller.
    pub fn has_climbed(&self, x: f64) -> bool {
        let mut end = 0.0;
        let (left, ahead): (Vec<_>, Vec<_>) = self.shaft.segments.iter().partition(|segment| {
            end += segment.length;
            end <= x + 1e-9
        });
        let here = self.shaft.diameter(x);
        let is_other = |segment: &&&Segment| segment.diameter != here;
        let last = if self.forward { left.iter().rev().find(is_other) } else { ahead.iter().find(is_other) };
        last.is_some_and(|segment| segment.diameter < here)
    }

    /// Minutes that the passes before the last take on each part, at the same feed and speed.
    pub fn before_last(&self) -> f64 {
        self.set_up.passes.len() as f64 * self.cutting_time()
    }

    /// Minutes since the last pass on the part began when the tool is at x.
    pub fn into_cut(&self, x: f64) -> f64 {
        let travelled = if self.forward { x } else { self.shaft.length() - x };
        travelled / self.tool_speed()
    }

    /// Cutting path of the tool since the batch began, m: pi times the integral of D dx/feed.
    pub fn path(&self, part: usize, x: f64) -> f64 {
        let length = self.shaft.length();
        let this = if self.forward { self.shaft.unrolled(0.0, x) } else { self.shaft.unrolled(x, length) };
        1e-3 * ((part - 1) as f64 * self.shaft.unrolled(0.0, length) + this) / self.feed
    }
}
