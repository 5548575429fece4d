//! A ring under radial pressure on its outer circle by Fourier series, exact for plane stress: the reference
//! that the finite elements must converge to. It shares nothing with them.
//!
//! Pressure p(θ) = p₀ + Σ pₘ cos m(θ − φ). The mean is Lamé's problem. A harmonic m ≥ 2 has Michell's stress
//! function Φ = Σₖ cₖ r^eₖ cos mθ with exponents e = m, m + 2, −m, 2 − m, hence
//!
//! ```text
//!   σrr = Σ cₖ (e − m²) r^(e−2) cos mθ            = −pₘ cos mθ at Ro, 0 at Ri
//!   σrθ = Σ cₖ m (e − 1) r^(e−2) sin mθ           = 0 at Ro and Ri
//!   σθθ = Σ cₖ e (e − 1) r^(e−2) cos mθ
//!   u_r = ∫ (σrr − ν σθθ)/E dr = Σ cₖ [(e − m²)/(e − 1) − ν e] r^(e−1)/E cos mθ
//! ```
//!
//! four equations for the four cₖ. The first harmonic of loads in equilibrium vanishes. Timoshenko and
//! Goodier, *Theory of Elasticity*, §28 and §43; Michell (1899).

use std::f64::consts::PI;

use nalgebra::{Matrix4, Vector4};

/// A ring in plane stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesRing {
    /// Outer radius Ro, m.
    pub outer_radius: f64,
    /// Inner radius Ri, m.
    pub inner_radius: f64,
    /// Width b, m.
    pub width: f64,
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
}

/// A radial force F (N, inwards) spread evenly over the angle `arc` (rad) about `angle` (rad); arc 0 is a
/// line load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// Angle of its middle, rad.
    pub angle: f64,
    /// Angle of the arc, rad; 0 for a line load.
    pub arc: f64,
    /// Force F, N, positive inwards.
    pub force: f64,
}

/// Compliances of the bore to each harmonic of the pressure.
#[derive(Clone, Debug)]
pub struct BoreSeries {
    ring: SeriesRing,
    /// u_r(Ri) per pressure of harmonic m, m/Pa; that of m = 1 is 0.
    compliances: Vec<f64>,
}

/// The most harmonics taken: those of a ring of 1/2000 wall.
const MOST: usize = 40_000;

impl SeriesRing {
    /// The series of the bore, to the last harmonic that still adds 1e-17 of the second.
    pub fn bore(self) -> BoreSeries {
        let mut compliances = vec![self.mean_compliance(), 0.0, self.compliance(2)];
        while compliances.len() < MOST && compliances[compliances.len() - 1].abs() > 1e-17 * compliances[2].abs() {
            compliances.push(self.compliance(compliances.len()));
        }
        BoreSeries { ring: self, compliances }
    }

    /// Lamé: u_r(Ri) per uniform outer pressure = −2 Ro² Ri / (E (Ro² − Ri²)).
    fn mean_compliance(&self) -> f64 {
        let (outer, inner) = (self.outer_radius, self.inner_radius);
        -2.0 * outer * outer * inner / (self.youngs_modulus * (outer - inner) * (outer + inner))
    }

    /// u_r(Ri) per pressure of harmonic m ≥ 2. Powers are of r over the radius at which they are largest.
    fn compliance(&self, m: usize) -> f64 {
        let m = m as f64;
        let ratio = self.inner_radius / self.outer_radius;
        // (exponent, r^(e−2) at Ri, at Ro): growing powers over Ro, falling ones over Ri
        let terms = [m, m + 2.0, -m, 2.0 - m].map(|e| {
            let power = ratio.powf((e - 2.0).abs());
            if e >= 2.0 { (e, power, 1.0) } else { (e, 1.0, power) }
        });
        let row = |value: &dyn Fn(f64) -> f64, inside: bool| {
            terms.map(|(e, inner, outer)| value(e) * if inside { inner } else { outer })
        };
        let normal = |e: f64| e - m * m;
        let shear = |e: f64| m * (e - 1.0);
        let rows = [row(&normal, true), row(&normal, false), row(&shear, true), row(&shear, false)];
        let matrix = Matrix4::from_fn(|i, j| rows[i][j]);
        let Some(coefficients) = matrix.lu().solve(&Vector4::new(0.0, -1.0, 0.0, 0.0)) else { return f64::NAN };
        let displacement = |(e, inner, _): (f64, f64, f64)| {
            ((e - m * m) / (e - 1.0) - self.poisson_ratio * e) * inner * self.inner_radius / self.youngs_modulus
        };
        coefficients.iter().zip(terms).map(|(c, term)| c * displacement(term)).sum()
    }
}

impl BoreSeries {
    /// u_r (m, positive outwards) of the bore at `angle` (rad) under `pushes` in equilibrium.
    pub fn radial(&self, pushes: &[Push], angle: f64) -> f64 {
        let line = |push: &Push| push.force / (PI * self.ring.outer_radius * self.ring.width);
        let mean: f64 = pushes.iter().map(|push| 0.5 * line(push)).sum();
        let harmonics = self.compliances.iter().enumerate().skip(2).map(|(m, compliance)| {
            let m = m as f64;
            let pressure = |push: &Push| line(push) * sinc(0.5 * m * push.arc) * (m * (angle - push.angle)).cos();
            compliance * pushes.iter().map(pressure).sum::<f64>()
        });
        self.compliances[0] * mean + harmonics.sum::<f64>()
    }
}

/// sin x / x.
fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pushes(n: usize, arc: f64, force: f64) -> Vec<Push> {
        (0..n).map(|jaw| Push { angle: jaw as f64 * 2.0 * PI / n as f64, arc, force }).collect()
    }

    #[test]
    fn three_jaws_give_the_published_figures() {
        let ring = SeriesRing {
            outer_radius: 0.05,
            inner_radius: 0.04,
            width: 0.02,
            youngs_modulus: 210e9,
            poisson_ratio: 0.3,
        };
        let bore = ring.bore();
        let jaws = pushes(3, 10_f64.to_radians(), 2000.0);
        for (degrees, expected) in [(0.0, -10.025_369), (30.0, -0.532_458), (60.0, 6.892_577)] {
            let found = 1e6 * bore.radial(&jaws, f64::to_radians(degrees));
            assert!((found - expected).abs() < 6e-7, "{degrees}: {found} {expected}");
        }
        let mean = bore.compliances[0] * 3.0 * 2000.0 / (2.0 * PI * 0.05 * 0.02);
        assert!((1e6 * mean + 1.010_508).abs() < 6e-7, "{mean}");
    }

    /// Thin ring under n line loads (Roark): inward at a load FR³/2EI [(β/2 + sin2β/4)/sin²β − 1/β], outward
    /// midway FR³/4EI [2/β − 1/sinβ − β cosβ/sin²β], β = π/n.
    #[test]
    fn a_thin_ring_bends_as_a_curved_beam() {
        let (radius, wall, width) = (0.05, 5e-5, 0.02);
        let ring = SeriesRing {
            outer_radius: radius + 0.5 * wall,
            inner_radius: radius - 0.5 * wall,
            width,
            youngs_modulus: 210e9,
            poisson_ratio: 0.3,
        };
        let bore = ring.bore();
        let scale = radius.powi(3) / (210e9 * width * f64::powi(wall, 3) / 12.0);
        for n in [2, 3, 4, 6] {
            let beta = PI / n as f64;
            let inward = 0.5 * ((0.5 * beta + 0.25 * (2.0 * beta).sin()) / beta.sin().powi(2) - 1.0 / beta);
            let outward = 0.25 * (2.0 / beta - 1.0 / beta.sin() - beta * beta.cos() / beta.sin().powi(2));
            let loads = pushes(n, 0.0, 1.0);
            let (at, midway) = (bore.radial(&loads, 0.0) / scale, bore.radial(&loads, beta) / scale);
            // wall over radius is 1/1000; the ring also shortens, which matters at n = 6
            assert!((at / -inward - 1.0).abs() < 5e-3, "{n}: {at} {inward}");
            assert!((midway / outward - 1.0).abs() < 5e-3, "{n}: {midway} {outward}");
        }
    }
}
