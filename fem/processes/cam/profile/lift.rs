//! Radius over angle, joined by a periodic cubic spline, so that the normal of the profile turns smoothly.
//!
//! The radius is that of a knife-edge follower, and then of the profile itself, or of the centre of a roller,
//! and then the profile lies a roller's radius inside it.

use std::f64::consts::TAU;

use super::plane::{Place, direction, left};

/// Radius over angle, periodic.
#[derive(Clone, Debug, PartialEq)]
pub struct Lift {
    /// Angles, rising over one turn; the first again at the end, rad.
    angles: Vec<f64>,
    /// Radii; the first again at the end, m.
    radii: Vec<f64>,
    /// Second derivatives d²r/dθ², m/rad².
    bends: Vec<f64>,
    /// Radius of the roller, m; 0 for a knife edge.
    roller: f64,
}

impl Lift {
    /// A spline through the rows, which rise in angle and cover less than a turn.
    pub fn new(mut angles: Vec<f64>, mut radii: Vec<f64>, roller: f64) -> Self {
        angles.push(angles[0] + TAU);
        radii.push(radii[0]);
        let bends = periodic_spline(&angles, &radii);
        Self { angles, radii, bends, roller }
    }

    /// Number of intervals.
    pub fn intervals(&self) -> usize {
        self.angles.len() - 1
    }

    /// The angle at which an interval begins, rad.
    pub fn angle(&self, i: usize) -> f64 {
        self.angles[i]
    }

    /// Of the table's curve at u from 0 to 1 within an interval: radius, its derivative by the angle, length
    /// by the angle, curvature.
    fn curve(&self, i: usize, u: f64) -> [f64; 4] {
        let h = self.angles[i + 1] - self.angles[i];
        let (a, b) = (1.0 - u, u);
        let (m, n) = (self.bends[i], self.bends[i + 1]);
        let (r, s) = (self.radii[i], self.radii[i + 1]);
        let radius = a * r + b * s + h * h / 6.0 * ((a * a * a - a) * m + (b * b * b - b) * n);
        let slope = (s - r) / h + h / 6.0 * ((3.0 * b * b - 1.0) * n - (3.0 * a * a - 1.0) * m);
        let speed = slope.hypot(radius);
        let curvature = (radius * radius + 2.0 * slope * slope - radius * (a * m + b * n)) / speed.powi(3);
        [radius, slope, speed, curvature]
    }

    /// The place at u from 0 to 1 within an interval.
    pub fn place(&self, i: usize, u: f64) -> Place {
        let [radius, slope, speed, curvature] = self.curve(i, u);
        let radial = direction(self.angles[i] + u * (self.angles[i + 1] - self.angles[i]));
        let normal = -left(&((radial * slope + left(&radial) * radius) / speed));
        let curvature = curvature / (1.0 - curvature * self.roller);
        Place { point: radial * radius - normal * self.roller, normal, curvature }
    }

    /// Length of an interval of the profile, m.
    pub fn length(&self, i: usize) -> f64 {
        let h = self.angles[i + 1] - self.angles[i];
        // Gauss's rule of three points.
        let at = |(x, weight): (f64, f64)| {
            let [_, _, speed, curvature] = self.curve(i, 0.5 + 0.5 * x);
            0.5 * h * weight * speed * (1.0 - self.roller * curvature)
        };
        let side = 0.6f64.sqrt();
        [(-side, 5.0 / 9.0), (0.0, 8.0 / 9.0), (side, 5.0 / 9.0)].map(at).iter().sum()
    }
}

/// Second derivatives at the knots of the periodic cubic spline: hᵢ₋₁Mᵢ₋₁ + 2(hᵢ₋₁ +
/// hᵢ)Mᵢ + hᵢMᵢ₊₁ = 6(dᵢ − dᵢ₋₁), closed by the Sherman–Morrison formula.
fn periodic_spline(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len() - 1;
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let slope: Vec<f64> = (0..n).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    let before = |i: usize| (i + n - 1) % n;
    let right: Vec<f64> = (0..n).map(|i| 6.0 * (slope[i] - slope[before(i)])).collect();
    let mut diagonal: Vec<f64> = (0..n).map(|i| 2.0 * (h[before(i)] + h[i])).collect();
    let corner = h[n - 1];
    // A = T + u·vᵀ with u = (γ, 0 … 0, c), v = (1, 0 … 0, c/γ).
    let gamma = -diagonal[0];
    diagonal[0] -= gamma;
    diagonal[n - 1] -= corner * corner / gamma;
    let mut u = vec![0.0; n];
    (u[0], u[n - 1]) = (gamma, corner);
    let (m, z) = (tridiagonal(&h, &diagonal, &right), tridiagonal(&h, &diagonal, &u));
    let along = |w: &[f64]| w[0] + corner / gamma * w[n - 1];
    let factor = along(&m) / (1.0 + along(&z));
    let mut bends: Vec<f64> = m.iter().zip(&z).map(|(m, z)| m - factor * z).collect();
    bends.push(bends[0]);
    bends
}

/// Solves the symmetric system with `h[i]` beside the diagonal between i and i + 1.
fn tridiagonal(h: &[f64], diagonal: &[f64], right: &[f64]) -> Vec<f64> {
    let n = diagonal.len();
    let (mut d, mut r) = (diagonal.to_vec(), right.to_vec());
    for i in 1..n {
        let part = h[i - 1] / d[i - 1];
        d[i] -= part * h[i - 1];
        r[i] -= part * r[i - 1];
    }
    r[n - 1] /= d[n - 1];
    for i in (0..n - 1).rev() {
        r[i] = (r[i] - h[i] * r[i + 1]) / d[i];
    }
    r
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_of_an_eccentric_circle_is_that_circle_to_the_fourth_power_of_its_step() {
        // Circle of 20 mm about (3, 0) mm: r(θ) = 3cosθ + √(400 − 9sin²θ).
        let error = |rows: usize| {
            let angles: Vec<f64> = (0..rows).map(|i| TAU * i as f64 / rows as f64).collect();
            let radius = |a: &f64| 3e-3 * a.cos() + (4e-4 - 9e-6 * a.sin().powi(2)).sqrt();
            let radii = angles.iter().map(radius).collect();
            let lift = Lift::new(angles, radii, 0.0);
            let off = |i: usize| {
                let place = lift.place(i, 0.5);
                let from_centre = place.point - super::super::plane::Vector::new(3e-3, 0.0);
                (from_centre.norm() - 0.02).abs().max(1e-3 * (place.normal - from_centre / 0.02).norm())
            };
            (0..rows).map(off).fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(36), error(72));
        assert!(fine < 1e-8 && coarse / fine > 7.5, "{coarse:e} {fine:e}");
    }

    #[test]
    fn the_profile_lies_a_rollers_radius_inside() {
        let angles: Vec<f64> = (0..36).map(|i| TAU * f64::from(i) / 36.0).collect();
        let lift = Lift::new(angles, vec![0.03; 36], 0.01);
        let place = lift.place(5, 0.3);
        assert!((place.point.norm() - 0.02).abs() < 1e-15 && (place.curvature - 50.0).abs() < 1e-9);
        let around: f64 = (0..36).map(|i| lift.length(i)).sum();
        assert!((around - TAU * 0.02).abs() < 1e-12);
    }
}
