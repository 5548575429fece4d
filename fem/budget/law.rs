//! Laws of distribution of an error over its field.

use std::f64::consts::SQRT_2;

use statrs::function::beta::{beta_reg, inv_beta_reg};
use statrs::function::erf::{erfc, erfc_inv};

use super::Stream;
use crate::input::{Bounds, Reader};
use crate::units::NUMBER;

/// Distribution of an error over ±Δ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Normal, Δ being three standard deviations.
    Normal,
    /// Triangular (Simpson) over ±Δ.
    Triangular,
    /// Uniform over ±Δ; also assumed where nothing is known.
    Uniform,
    /// Symmetric beta law over ±Δ whose coefficient λ this is, in (0, 1/2]: a stretch of uniform at 1/3, drawn to
    /// the middle below and to the ends above it.
    Scatter(f64),
}

impl Law {
    /// Words in a budget file.
    pub const WORDS: &[(&'static str, Self)] = &[
        ("normal", Self::Normal),
        ("triangular", Self::Triangular),
        ("uniform", Self::Uniform),
        ("unknown", Self::Uniform),
    ];

    /// Word in a budget file.
    pub fn word(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Triangular => "triangular",
            Self::Uniform => "uniform",
            Self::Scatter(_) => "by lambda",
        }
    }

    /// Coefficient λ: the square of the standard deviation over Δ [seed 002 (42)].
    pub fn lambda(self) -> f64 {
        match self {
            Self::Normal => 1.0 / 9.0,
            Self::Triangular => 1.0 / 6.0,
            Self::Uniform => 1.0 / 3.0,
            Self::Scatter(lambda) => lambda,
        }
    }

    /// Half-field Δ of a law with this standard deviation.
    pub fn half_field(self, std: f64) -> f64 {
        std / self.lambda().sqrt()
    }

    /// Draws over ±1, from two independent numbers u, v in (0, 1).
    pub fn draw(self, stream: &Stream, dimension: u32, attempt: u32) -> f64 {
        let [u, v] = stream.uniform(dimension, attempt);
        match self {
            // Box and Muller.
            Self::Normal => (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos() / 3.0,
            Self::Triangular => u + v - 1.0,
            Self::Uniform => 2.0 * u - 1.0,
            // A point within the unit disc, evenly round, seen from the side: (1 − x²)^(a − 1) where the square of
            // its distance has the power a − 1/2 [Ulrich, Statistics and Computing 1984; Devroye 1986, IX.3].
            // The variance 1/(2a + 1) is λ.
            Self::Scatter(lambda) => {
                let power = 0.5 * (1.0 / lambda - 2.0);
                let distance = if power > 0.0 { -(u.ln() / power).exp_m1() } else { 1.0 };
                distance.sqrt() * (std::f64::consts::TAU * v).cos()
            }
        }
    }

    /// Value over ±1 below which the part `p` of all draws lies, 0 to 1.
    pub fn quantile(self, p: f64) -> f64 {
        match self {
            Self::Normal => -erfc_inv(2.0 * p) * SQRT_2 / 3.0,
            Self::Triangular if p < 0.5 => (2.0 * p).sqrt() - 1.0,
            Self::Triangular => 1.0 - (2.0 * (1.0 - p)).sqrt(),
            Self::Uniform => 2.0 * p - 1.0,
            Self::Scatter(lambda) => 2.0 * inv_beta_reg(beta(lambda), beta(lambda), p) - 1.0,
        }
    }

    /// Part of all draws below `x` over ±1: the inverse of [`Self::quantile`].
    pub fn below(self, x: f64) -> f64 {
        let inside = x.clamp(-1.0, 1.0);
        match self {
            Self::Normal => 0.5 * erfc(-3.0 * x / SQRT_2),
            Self::Triangular if x < 0.0 => 0.5 * (1.0 + inside).powi(2),
            Self::Triangular => 1.0 - 0.5 * (1.0 - inside).powi(2),
            Self::Uniform => 0.5 * (1.0 + inside),
            Self::Scatter(lambda) => beta_reg(beta(lambda), beta(lambda), 0.5 * (1.0 + inside)),
        }
    }

    /// Reads the law of a table: a word, or its coefficient λ; `None` where neither is given.
    pub fn read(t: &Reader, about: &'static str, usual: Self) -> Option<Self> {
        let given = t.has("distribution");
        let word = t.choice("distribution", about, Self::WORDS).or_first(usual);
        let about = "coefficient of relative scatter of another law, instead of `distribution`";
        let lambda = t.quantity("lambda", NUMBER, about).bounds(Bounds::Within(0.0, 0.5)).optional();
        if given && lambda.is_some() {
            t.problem("lambda", "the law is given twice", "keep either `distribution` or `lambda`");
        }
        lambda.map(Self::Scatter).or(given.then_some(word))
    }
}

/// Both parameters a of the symmetric beta law with this λ = 1/(2a + 1).
fn beta(lambda: f64) -> f64 {
    0.5 * (1.0 / lambda - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_undo_the_distribution_and_have_its_variance() {
        for law in [Law::Normal, Law::Triangular, Law::Uniform, Law::Scatter(0.2), Law::Scatter(0.45)] {
            let steps = 20_000;
            let mut square = 0.0;
            for i in 0..steps {
                let p = (f64::from(i) + 0.5) / f64::from(steps);
                let x = law.quantile(p);
                assert!((law.below(x) - p).abs() < 1e-9, "{law:?} at {p}");
                square += x * x / f64::from(steps);
            }
            // The midpoint rule loses the tails of a normal law, and is exact to 1/steps² elsewhere.
            assert!((square - law.lambda()).abs() < 1e-4 * law.lambda() + 1e-5, "{law:?}: {square}");
        }
    }
}
