//! Laws of distribution of an error over its field.

use super::Stream;

/// Distribution of an error over ±Δ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Normal, Δ being three standard deviations.
    Normal,
    /// Triangular (Simpson) over ±Δ.
    Triangular,
    /// Uniform over ±Δ; also assumed where nothing is known.
    Uniform,
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
        }
    }

    /// Coefficient λ: the square of the standard deviation over Δ [seed 002 (42)].
    pub fn lambda(self) -> f64 {
        match self {
            Self::Normal => 1.0 / 9.0,
            Self::Triangular => 1.0 / 6.0,
            Self::Uniform => 1.0 / 3.0,
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
        }
    }
}
