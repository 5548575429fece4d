//! The contour on which a rod's run is summed up instead of being stepped.
//!
//! A run is a function of the matrix A = C⁻¹K: each step multiplies by a rational function of it. By
//! Cauchy's formula f(−A) = 1/2πi ∮ f(s) (s + A)⁻¹ ds about the spectrum −λ, 0 ≤ λ ≤ Λ, f(s) being the same
//! steps of the one equation z′ = s·z + u. The trapezoidal rule converges geometrically in the number of
//! points if they are even in the right variable (Hale, Higham and Trefethen 2008). Here f is analytic and
//! bounded in Re s < p, p some 4 over the length of the run: the half plane without the spectrum is mapped
//! onto an annulus by an elliptic sine, and the contour lies half way.

use nalgebra::Complex;

use super::lanes::LANES;

/// Error that the sum may leave, as a part of what the whole input would do to an insulated rod.
const TOLERANCE: f64 = 1e-10;
/// Growth e^`GROWTH` of a run at the right edge of the half plane.
const GROWTH: f64 = 4.0;
/// Bounds of the spectrum are rounded up to a power of this, so that one contour serves similar rods.
const BUCKET: f64 = 8.0;

/// Points above the real axis with their weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Points s, 1/s.
    pub points: Vec<Complex<f64>>,
    /// Weights w, 1/s: f(−A) = Im Σ w f(s) (s + A)⁻¹.
    pub weights: Vec<Complex<f64>>,
}

/// Bounds that determine a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The half plane Re s < p in which runs do not grow beyond all bounds, 1/s.
    pub edge: f64,
    /// Bound Λ of the spectrum, 1/s.
    pub spectrum: f64,
}

impl Reach {
    /// Of runs up to `end` (s) and rates up to `fastest` (1/s).
    pub fn new(end: f64, fastest: f64) -> Self {
        let edge = GROWTH / end;
        let buckets = (fastest / edge).max(1.0).log(BUCKET).ceil();
        Self { edge, spectrum: edge * BUCKET.powf(buckets) }
    }

    /// Number of points, a multiple of those worked on side by side: the sum's error is some exp(−π²/2 · points /
    /// (ln((Λ + p)/p) + 1.4)), the modulus of the annulus for a long spectrum.
    pub fn count(self) -> usize {
        let length = ((self.spectrum + self.edge) / self.edge).ln() + 1.4;
        let needed = -TOLERANCE.ln() * length * 2.0 / (std::f64::consts::PI * std::f64::consts::PI);
        (needed.ceil() as usize).next_multiple_of(LANES)
    }

    /// The contour.
    pub fn contour(self) -> Contour {
        let Self { edge, spectrum } = self;
        let count = self.count();
        let middle = (edge * (edge + spectrum)).sqrt();
        // (p − s)/middle = (1 + z)/(1 − z) takes the half plane onto the unit disc and the spectrum onto
        // [−a, a]; √k sn takes a rectangle onto half the disc, √k = a.
        let a = (((edge + spectrum) / edge).ln() / 4.0).tanh();
        let modulus = Modulus::new(a * a);
        let across = modulus.complement();
        let (wide, high) = (modulus.quarter_period(), 0.5 * 0.5 * across.quarter_period());
        let width = 2.0 * wide / count as f64;
        let [s1, c1, d1] = across.functions(high);
        let one = Complex::new(1.0, 0.0);
        let point = |i: usize| {
            let [s, c, d] = modulus.functions(-wide + (i as f64 + 0.5) * width);
            // Addition theorem for x + iy (Abramowitz and Stegun 16.21), with the sign of y by which points
            // are above the real axis.
            let below = 1.0 - (d * s1).powi(2);
            let sn = Complex::new(s * d1, -c * d * s1 * c1) / below;
            let cn = Complex::new(c * c1, s * d * s1 * d1) / below;
            let dn = Complex::new(d * c1 * d1, modulus.0.powi(2) * s * c * s1) / below;
            let z = sn * a;
            let slope = cn * dn * a;
            let place = Complex::new(edge, 0.0) - (one + z) / (one - z) * middle;
            (place, -slope / ((one - z) * (one - z)) * (2.0 * middle * width / std::f64::consts::PI))
        };
        let (points, weights) = (0..count).map(point).unzip();
        Contour { points, weights }
    }
}

/// Modulus k of elliptic functions, and √(1 − k²).
#[derive(Clone, Copy, Debug)]
struct Modulus(f64, f64);

impl Modulus {
    fn new(k: f64) -> Self {
        Self(k, ((1.0 - k) * (1.0 + k)).sqrt())
    }

    fn complement(self) -> Self {
        Self(self.1, self.0)
    }

    /// Means of the arithmetic–geometric iteration from 1 and √(1 − k²), each with half of the difference
    /// that it had.
    fn means(self) -> Vec<[f64; 2]> {
        let mut means = vec![[1.0, self.0]];
        let mut geometric = self.1;
        // Digits double with each.
        for _ in 0..16 {
            let [mean, half] = means[means.len() - 1];
            if half <= f64::EPSILON * mean {
                break;
            }
            means.push([0.5 * (mean + geometric), 0.5 * (mean - geometric)]);
            geometric = (mean * geometric).sqrt();
        }
        means
    }

    /// K(k).
    fn quarter_period(self) -> f64 {
        let means = self.means();
        0.5 * std::f64::consts::PI / means[means.len() - 1][0]
    }

    /// sn, cn and dn (Abramowitz and Stegun 16.4).
    fn functions(self, x: f64) -> [f64; 3] {
        let means = self.means();
        let last = means.len() - 1;
        let mut angle = 2f64.powi(last as i32) * means[last][0] * x;
        for [mean, half] in means[1..].iter().rev() {
            angle = 0.5 * ((half / mean * angle.sin()).asin() + angle);
        }
        let (s, c) = angle.sin_cos();
        [s, c, (1.0 - (self.0 * s).powi(2)).sqrt()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun: K(√½) = 1.85407 46773, sn(K/2) = 1/√(1 + k′).
    #[test]
    fn elliptic_functions_are_those_of_the_tables() {
        let modulus = Modulus::new(0.5f64.sqrt());
        let period = modulus.quarter_period();
        assert!((period - 1.854_074_677_301_372).abs() < 1e-14, "{period}");
        let [s, c, d] = modulus.functions(0.5 * period);
        assert!((s - (1.0 + modulus.1).recip().sqrt()).abs() < 1e-14);
        assert!((c * c + s * s - 1.0).abs() < 1e-14 && (d - modulus.1.sqrt()).abs() < 1e-14);
    }

    /// e^(−λt) over the whole of the run and of the spectrum, and λ = 0.
    #[test]
    fn exponentials_are_summed_up() {
        let end = 12_000.0;
        let reach = Reach::new(end, 8.0);
        let Contour { points, weights } = reach.contour();
        assert!(points.iter().all(|s| s.im > 0.0 && s.re < reach.edge));
        for rate in [0.0, 1e-5, 1e-3, 0.1, 1.0, 8.0] {
            for part in [0.01, 0.1, 0.5, 1.0] {
                let time = part * end;
                let term = |(s, w): (&Complex<f64>, &Complex<f64>)| (w * (s * time).exp() / (s + rate)).im;
                let sum: f64 = points.iter().zip(&weights).map(term).sum();
                assert!((sum - (-rate * time).exp()).abs() < 1e-9, "{rate} {time}: {sum}");
            }
        }
    }
}
