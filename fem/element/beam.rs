//! A uniform length of beam, exact at any length.

/// A uniform length of beam: Euler–Bernoulli where the shear rigidity is infinite, Timoshenko where it is finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamPiece {
    /// m.
    pub length: f64,
    /// EI, N m².
    pub flexural_rigidity: f64,
    /// κGA, N; infinite for Euler–Bernoulli.
    pub shear_rigidity: f64,
}

impl BeamPiece {
    /// Flexibility of the piece in terms of the shear force and the bending moment at its middle, where the two do
    /// not couple: (l³/12EI + l/κGA in m/N, l/EI in rad/(N m)).
    pub fn central_flexibility(&self) -> (f64, f64) {
        let bending = self.length / self.flexural_rigidity;
        (self.length * self.length / 12.0 * bending + self.length / self.shear_rigidity, bending)
    }
}
