//! What not every job has: rests, earlier passes, an uneven blank, a holder that gives way.

use std::f64::consts::TAU;

use super::design::STEEL;

/// A steady rest: a spring under the shaft, both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// From the headstock, mm.
    pub at: f64,
    /// N/um.
    pub stiffness: f64,
    /// Out of line, away from the tool, um.
    pub offset: f64,
}

/// A pass before that of the cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pass {
    /// Set depth, mm.
    pub depth: f64,
    /// Radial force at that depth, N.
    pub force: f64,
}

/// A wave of the blank's diameter along the shaft: amplitude·cos(2π·waves·x/L − phase).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Along the whole shaft.
    pub waves: f64,
    /// Of the diameter, mm.
    pub amplitude: f64,
    /// deg.
    pub phase: f64,
}

/// Lobes of the blank's radius around it: amplitude·cos(lobes·(angle − phase)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobe {
    /// In a turn.
    pub lobes: usize,
    /// Of the radius, mm.
    pub amplitude: f64,
    /// Of a crest, deg.
    pub phase: f64,
}

/// The tool's holder, a cantilever of steel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Holder {
    /// Free length, mm.
    pub overhang: f64,
    /// Across the force, mm.
    pub width: f64,
    /// Along the force, mm.
    pub height: f64,
}

impl Holder {
    /// l³/(3EI) and, where beams shear, l/(κGA) with κ = 10(1+ν)/(12+11ν) of a rectangle, um/N.
    pub fn compliance(&self, shear: bool) -> f64 {
        let (e, nu, l) = (1e3 * STEEL.modulus, STEEL.poisson, self.overhang);
        let (area, inertia) = (self.width * self.height, self.width * self.height.powi(3) / 12.0);
        let kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
        let slides = if shear { 2.0 * (1.0 + nu) * l / (kappa * e * area) } else { 0.0 };
        1e3 * (l.powi(3) / (3.0 * e * inertia) + slides)
    }
}

/// All of it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SetUp {
    /// Steady rests.
    pub rests: Vec<Rest>,
    /// In their order.
    pub passes: Vec<Pass>,
    /// By how much the blank is off along the shaft.
    pub waves: Vec<Wave>,
    /// The same at places: (x mm, error of the diameter mm), straight between; either of both.
    pub points: Vec<(f64, f64)>,
    /// By how much the blank is off around it.
    pub lobes: Vec<Lobe>,
    /// Of the tool.
    pub holder: Option<Holder>,
}

impl SetUp {
    /// By how much the blank's radius is too large at a place (mm) of a shaft of `length` and an angle (deg), um.
    pub fn blank_error(&self, x: f64, length: f64, angle: f64) -> f64 {
        let wave = |w: &Wave| 0.5 * w.amplitude * (TAU * w.waves * x / length - w.phase.to_radians()).cos();
        let lobe = |l: &Lobe| l.amplitude * (l.lobes as f64 * (angle - l.phase).to_radians()).cos();
        let (along, around): (f64, f64) = (self.waves.iter().map(wave).sum(), self.lobes.iter().map(lobe).sum());
        1e3 * (along + around + 0.5 * between(&self.points, x).unwrap_or(0.0))
    }
}

/// Straight between points (place, value) with rising places, beyond them as at the nearest; `None` of no points.
pub fn between(points: &[(f64, f64)], x: f64) -> Option<f64> {
    let last = points.last()?;
    Some(match points.partition_point(|(at, _)| *at <= x) {
        0 => points[0].1,
        i if i == points.len() => last.1,
        i => {
            let ((from, low), (to, high)) = (points[i - 1], points[i]);
            low + (high - low) * (x - from) / (to - from)
        }
    })
}
