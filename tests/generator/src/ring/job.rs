//! The job: which ring, how it is held and bored, and where it is measured.

use crate::job::{NoiseKind, Shown};

/// A set-up: rows that are measured from one circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetUp {
    /// Of each jaw, N.
    pub force: f64,
    /// rpm.
    pub speed: f64,
    /// Of the ring's mark from jaw 1, deg.
    pub orientation: f64,
    /// Measured clamped, before boring.
    pub clamped: bool,
}

/// One measured row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Position in the list of set-ups.
    pub set_up: usize,
    /// From jaw 1, deg.
    pub angle: f64,
    /// Radial deviation before boring, um.
    pub blank: f64,
    /// How much farther out the nose is sent, um.
    pub change: f64,
}

/// A ring with its measuring design.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// Outer radius, mm.
    pub outer: f64,
    /// Inner radius, mm.
    pub inner: f64,
    /// mm.
    pub width: f64,
    /// GPa.
    pub modulus: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// 1e-6/K.
    pub expansion: f64,
    /// How many jaws.
    pub jaws: usize,
    /// Of each, N.
    pub force: f64,
    /// rpm.
    pub speed: f64,
    /// kN/mm.
    pub force_per_depth: f64,
    /// Measured from the set circle, not from that of least squares.
    pub absolute: bool,
    /// How the rings were made.
    pub set_ups: Vec<SetUp>,
    /// Measured rows.
    pub rows: Vec<Row>,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
    /// Compliances of the bore per harmonic.
    pub compliances: Vec<f64>,
}
