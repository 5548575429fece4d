//! The straight uniform bar element, exact for loads at its ends.
//!
//! ```text
//!   u1, F1 ->          -> u2, F2        u and F along the bar
//!          o====EA====o
//!          0    l     l
//! ```

use nalgebra::Matrix2;

/// A uniform length of bar, also one finite element with degrees of freedom (u1, u2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarPiece {
    /// Length l (m).
    pub length: f64,
    /// Axial rigidity EA (N).
    pub axial_rigidity: f64,
}

impl BarPiece {
    /// EA/l (N/m); infinite for a bar without length.
    pub fn axial_stiffness(&self) -> f64 {
        self.axial_rigidity / self.length
    }

    /// Exact stiffness K (2 × 2, symmetric) in (F1, F2)ᵀ = K (u1, u2)ᵀ, N/m:
    ///
    /// ```text
    ///   K = EA/l |  1  −1 |
    ///            | −1   1 |
    /// ```
    pub fn stiffness(&self) -> Matrix2<f64> {
        let k = self.axial_stiffness();
        Matrix2::new(k, -k, -k, k)
    }
}
