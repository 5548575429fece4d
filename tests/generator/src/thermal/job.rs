//! The job: which rod, what heats it, and what is measured when.

use crate::job::{NoiseKind, Shown};

/// What a row observes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Seen {
    /// Temperature of this sensor, degC.
    Temperature(usize),
    /// Elongation of the free end, um.
    Elongation,
}

/// One value for every row that sees a temperature, another for those that see the elongation.
pub fn by_row(seen: impl Iterator<Item = Seen>, temperature: f64, elongation: f64) -> Vec<f64> {
    seen.map(|seen| if seen == Seen::Elongation { elongation } else { temperature }).collect()
}

/// One measured row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// min.
    pub time: f64,
    /// What.
    pub seen: Seen,
    /// What the control adds to the length, um.
    pub change: f64,
}

/// A rod with its measuring design.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// (length, diameter) from the base, mm.
    pub segments: Vec<(f64, f64)>,
    /// (x mm, W, on from, to min).
    pub source: (f64, f64, f64, f64),
    /// Of the start and, without drift, of the surroundings, degC.
    pub ambient: f64,
    /// min.
    pub end: f64,
    /// Places of the sensors, mm.
    pub sensors: Vec<f64>,
    /// Measured rows, by time.
    pub rows: Vec<Row>,
    /// Noise of temperatures where that of elongations is one, K/um.
    pub kelvin: f64,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
    /// What not every rod has.
    pub set_up: SetUp,
}

/// What not every rod has.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SetUp {
    /// Further sources, as the first.
    pub sources: Vec<(f64, f64, f64, f64)>,
    /// Of the rod at the start where it is not that of the surroundings, degC.
    pub start: Option<f64>,
    /// Longest step (s) and element (mm) of the model, where they are not the usual ones.
    pub fine: Option<(f64, f64)>,
}
