//! The stepped shaft: compliances by the unit-load method (Castigliano), which needs no elements and no
//! stiffness matrix.

use std::f64::consts::PI;

/// Linear elastic, conducting stuff of the workpiece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus, GPa.
    pub modulus: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density, kg/m^3.
    pub density: f64,
    /// Thermal expansion, 1e-6 /K.
    pub expansion: f64,
    /// Thermal conductivity, W/m/K.
    pub conductivity: f64,
    /// Specific heat, J/kg/K.
    pub specific_heat: f64,
}

/// One cylinder of the shaft, mm.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Segment {
    /// Length along the axis, mm.
    pub length: f64,
    /// Set (finished) diameter, mm.
    pub diameter: f64,
    /// Of a hollow one, mm; 0 of a solid one.
    pub bore: f64,
}

impl Segment {
    /// Of the section, mm².
    pub fn area(&self) -> f64 {
        0.25 * PI * (self.diameter.powi(2) - self.bore.powi(2))
    }

    /// Second moment of the section, mm⁴.
    fn inertia(&self) -> f64 {
        PI * (self.diameter.powi(4) - self.bore.powi(4)) / 64.0
    }

    /// Shear coefficient of a hollow round, 6(1+ν)(1+m²)²/[(7+6ν)(1+m²)² + (20+12ν)m²], m = bore/D.
    fn kappa(&self, nu: f64) -> f64 {
        let square = (self.bore / self.diameter).powi(2);
        let whole = (1.0 + square).powi(2);
        6.0 * (1.0 + nu) * whole / ((7.0 + 6.0 * nu) * whole + (20.0 + 12.0 * nu) * square)
    }
}

/// Stepped round beam; x from the headstock, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    /// What it is made of.
    pub material: Material,
    /// Its cylinders from the headstock.
    pub segments: Vec<Segment>,
    /// Whether shear deflection counts (Timoshenko) or not (Euler-Bernoulli).
    pub shear: bool,
}

impl Shaft {
    /// Whole length, mm.
    pub fn length(&self) -> f64 {
        self.segments.iter().map(|s| s.length).sum()
    }

    /// Set diameter at x; exactly on a step the segment toward the tailstock counts.
    pub fn diameter(&self, x: f64) -> f64 {
        let mut end = 0.0;
        for segment in &self.segments {
            end += segment.length;
            if x < end - 1e-9 {
                return segment.diameter;
            }
        }
        self.segments.last().map_or(0.0, |s| s.diameter)
    }

    /// Area of the turned surface's unrolling, the integral of pi D dx from `a` to `b`, mm^2: cutting path
    /// times feed.
    pub fn unrolled(&self, a: f64, b: f64) -> f64 {
        self.pieces(&[])
            .iter()
            .map(|&(from, to, section)| PI * section.diameter * (b.min(to) - a.max(from)).max(0.0))
            .sum()
    }

    /// Deflection at `z` from a unit force at `x`, clamped at 0 and free at L, um/N.
    pub fn cantilever(&self, x: f64, z: f64) -> f64 {
        let arm = |at: f64, s: f64| if s < at { (at - s, 1.0) } else { (0.0, 0.0) };
        self.virtual_work(&[x, z], |s| (arm(x, s), arm(z, s)))
    }

    /// Deflection at `x` from a unit force there, pinned at both ends, um/N.
    pub fn between_pins(&self, x: f64) -> f64 {
        let length = self.length();
        let state = |s: f64| {
            let beyond = (length - x) / length;
            if s < x { (s * beyond, beyond) } else { (x * (length - s) / length, -x / length) }
        };
        self.virtual_work(&[x], |s| (state(s), state(s)))
    }

    /// Integral of M m/EI + Q q/(kappa G A), um/N: `loads` gives ((M, Q), (m, q)) at a section, kinked only
    /// at `cuts` and at steps. Between them the integrand is a parabola, so two Gauss points per piece
    /// integrate it exactly.
    fn virtual_work(&self, cuts: &[f64], loads: impl Fn(f64) -> ((f64, f64), (f64, f64))) -> f64 {
        let (e, nu) = (self.material.modulus * 1e3, self.material.poisson);
        let shear_modulus = e / (2.0 * (1.0 + nu));
        let mut sum = 0.0;
        for (from, to, section) in self.pieces(cuts) {
            let bending = 1.0 / (e * section.inertia());
            let sliding = if self.shear { 1.0 / (section.kappa(nu) * shear_modulus * section.area()) } else { 0.0 };
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            for s in [middle - half / 3_f64.sqrt(), middle + half / 3_f64.sqrt()] {
                let ((m1, q1), (m2, q2)) = loads(s);
                sum += half * (m1 * m2 * bending + q1 * q2 * sliding);
            }
        }
        1e3 * sum
    }

    /// The shaft cut at its steps and at `cuts`: (from, to, section).
    fn pieces(&self, cuts: &[f64]) -> Vec<(f64, f64, Segment)> {
        let mut pieces = Vec::new();
        let mut start = 0.0;
        for segment in &self.segments {
            let end = start + segment.length;
            let mut ends: Vec<f64> = cuts.iter().copied().filter(|&c| c > start && c < end).collect();
            ends.push(end);
            ends.sort_by(f64::total_cmp);
            let mut from = start;
            for to in ends {
                pieces.push((from, to, *segment));
                from = to;
            }
            start = end;
        }
        pieces
    }
}
