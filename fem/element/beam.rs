//! The straight uniform beam element (Timoshenko; Euler–Bernoulli as its limit), exact for loads at its ends.
//!
//! ```text
//!   w1, F1 ^          ^ w2, F2        x to the right, w up (the way the tool force pushes)
//!          |  EI, kGA |
//!   theta1 o==========o theta2        theta counter-clockwise: the turn of the cross-section,
//!          0    l     l               equal to dw/dx where shear is neglected
//! ```

use faer::fx128;
use nalgebra::Matrix4;

/// A uniform length of beam, also one finite element with degrees of freedom (w1, θ1, w2, θ2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamPiece {
    /// Length l (m).
    pub length: f64,
    /// Flexural rigidity EI (N m²).
    pub flexural_rigidity: f64,
    /// Shear rigidity κGA (N); `f64::INFINITY` makes it an Euler–Bernoulli beam.
    pub shear_rigidity: f64,
}

impl BeamPiece {
    /// The piece cut into `count` equal pieces (none for `count` = 0).
    pub fn divided(self, count: usize) -> impl Iterator<Item = BeamPiece> {
        let part = BeamPiece { length: self.length / count as f64, ..self };
        std::iter::repeat_n(part, count)
    }

    /// Flexibility of the piece in terms of the shear force and the bending moment at its middle, where the
    /// two do not couple: (l³/12EI + l/κGA in m/N, l/EI in rad/(N m)).
    pub fn central_flexibility(&self) -> (f64, f64) {
        let bending = self.length / self.flexural_rigidity;
        (self.length * self.length / 12.0 * bending + self.length / self.shear_rigidity, bending)
    }

    /// Shear number Φ = 12 EI/(κGA l²): 0 for Euler–Bernoulli.
    fn shear_number(&self) -> f64 {
        12.0 * self.flexural_rigidity / (self.shear_rigidity * self.length * self.length)
    }

    /// Moment sum M1 + M2 per unit of sway θ1 + θ2 − 2(w2 − w1)/l: 6EI/((1 + Φ) l) (N m).
    fn sway_stiffness(&self) -> f64 {
        6.0 * self.flexural_rigidity / ((1.0 + self.shear_number()) * self.length)
    }

    /// Exact stiffness K (4 × 4, symmetric) in (F1, M1, F2, M2)ᵀ = K (w1, θ1, w2, θ2)ᵀ; forces in N, moments
    /// in N m:
    ///
    /// ```text
    ///            EI      |  12        6l      −12        6l    |
    ///   K = ------------ |  6l    (4+Φ)l²     −6l    (2−Φ)l²   |     Φ = 12 EI/(κGA l²)
    ///       (1 + Φ) l³   | −12       −6l       12       −6l    |
    ///                    |  6l    (2−Φ)l²     −6l    (4+Φ)l²   |
    /// ```
    ///
    /// The inverse of the flexibility of a cantilever, completed by equilibrium.
    pub fn stiffness(&self) -> Matrix4<f64> {
        let l = self.length;
        let sway = self.sway_stiffness();
        let bend = self.flexural_rigidity / l;
        // near/far moment stiffness as bending plus sway: (4+Φ)/(1+Φ) = 1 + 3/(1+Φ), (2−Φ)/(1+Φ) = −1 +
        // 3/(1+Φ)
        let (near, far) = (0.5 * sway + bend, 0.5 * sway - bend);
        let coupling = sway / l;
        let shear = 2.0 * coupling / l;
        Matrix4::new(
            shear, coupling, -shear, coupling, //
            coupling, near, -coupling, far, //
            -shear, -coupling, shear, -coupling, //
            coupling, far, -coupling, near,
        )
    }

    /// Forces (F1, M1, F2, M2) in N and N m that hold the ends at (w1, θ1, w2, θ2) in m and rad: K times the
    /// end displacements, but without the rounding of K, so that a rigid motion gives no force however short
    /// the piece.
    ///
    /// The end displacements come in twofold precision because the two deformations of the element,
    /// bend = θ2 − θ1 and sway = θ1 + θ2 − 2(w2 − w1)/l, are tiny differences of them:
    /// M1 + M2 = 6EI/((1+Φ)l)·sway, (M1 − M2)/2 = −EI/l·bend, F1 = −F2 = (M1 + M2)/l.
    pub(crate) fn end_forces(&self, [w1, theta1, w2, theta2]: [fx128; 4]) -> [f64; 4] {
        let chord = (w2 - w1) / fx128::from(self.length);
        let bend = (theta2 - theta1).0;
        let sway = ((theta1 - chord) + (theta2 - chord)).0;
        let moment_sum = self.sway_stiffness() * sway;
        let half_difference = -self.flexural_rigidity / self.length * bend;
        let force = moment_sum / self.length;
        [force, 0.5 * moment_sum + half_difference, -force, 0.5 * moment_sum - half_difference]
    }
}
