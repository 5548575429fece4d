//! One side of a cut through a beam, held exactly and without a subtraction.
//!
//! The part of a beam on one side of a cut resists a deflection w and a slope θ of the cut with a force and a
//! moment, (V, M) = K·(w, θ), K symmetric and positive semidefinite. K itself is infinite at a rigid support
//! and grows without digits to lose at a free end, so it is kept in homogeneous form: the five 2×2 minors of
//! [I; K] up to one factor,
//!
//! ```text
//!     (δ, a₁₁, a₁₂, a₂₂, d)  with  K = a/δ  and  det K = d/δ
//! ```
//!
//! In these coordinates everything that happens along a beam is *linear with coefficients ≥ 0*: a rigid
//! length, a flexibility (F₁ shear, F₂ bending, uncoupled at the middle of a uniform piece), a spring.
//! Between the support and the cut a₁₂ never changes sign, so its magnitude is kept. Sums of non-negative
//! terms lose no digits: after N pieces the relative error is at most about N rounding errors, whatever the
//! stiffness of beam and springs. (These are the Plücker coordinates of the Lagrangian plane of end states;
//! for ODEs the method is known as that of compound matrices.)

use crate::element::BeamPiece;

/// A uniform length of beam as the cut sees it: two rigid halves about its flexibility.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Half the length, m.
    pub half: f64,
    /// Shear flexibility, m/N at the middle.
    pub shear: f64,
    /// Bending flexibility, rad/(N m) at the middle.
    pub bending: f64,
    /// Stiffness of the steady rest at the link's far end, N/m; 0 where there is none.
    pub rest: f64,
}

impl From<BeamPiece> for Link {
    fn from(piece: BeamPiece) -> Self {
        let (shear, bending) = piece.central_flexibility();
        Self { half: 0.5 * piece.length, shear, bending, rest: 0.0 }
    }
}

/// The hold of a support on the rotation: compliance p/q in rad/(N m), so that free (1/0) and clamped (0/1)
/// are both plain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning {
    pub p: f64,
    pub q: f64,
}

impl Turning {
    /// Not held at all.
    pub const FREE: Self = Self { p: 1.0, q: 0.0 };
}

/// Homogeneous stiffness of what lies on one side of a cut. The cross term is its magnitude: positive when
/// the cut is looked at from the supported side, with x counted away from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    pub delta: f64,
    pub a11: f64,
    pub a12: f64,
    pub a22: f64,
    pub det: f64,
}

impl HalfPlane {
    /// Nothing holds the cut.
    pub const FREE: Self = Self { delta: 1.0, a11: 0.0, a12: 0.0, a22: 0.0, det: 0.0 };

    /// Rigid in translation, held in rotation by a compliance of `turning`.
    pub fn held(turning: Turning) -> Self {
        // diag(∞, q/p) up to a factor: a₁₁ : d = 1 : q/p.
        Self { delta: 0.0, a11: turning.p, a12: 0.0, a22: 0.0, det: turning.q }
    }

    /// Carried rigidly over `length`.
    #[inline]
    pub fn carried(self, length: f64) -> Self {
        let a12 = self.a12 + length * self.a11;
        Self { a12, a22: self.a22 + length * (self.a12 + a12), ..self }
    }

    /// This side in series with a flexibility that does not couple shear (m/N) and bending (rad/(N m)).
    #[inline]
    pub fn softened(self, shear: f64, bending: f64) -> Self {
        Self {
            delta: self.delta + shear * self.a11 + bending * self.a22 + shear * bending * self.det,
            a11: self.a11 + bending * self.det,
            a12: self.a12,
            a22: self.a22 + shear * self.det,
            det: self.det,
        }
    }

    /// This side seen from beyond a uniform length of beam.
    #[inline]
    pub fn beyond(self, link: &Link) -> Self {
        self.carried(link.half).softened(link.shear, link.bending).carried(link.half)
    }

    /// This side with a translational spring of `stiffness` N/m at the cut. Scaled so that many springs do
    /// not overflow.
    pub fn sprung(self, stiffness: f64) -> Self {
        let stiffer = Self { a11: self.a11 + stiffness * self.delta, det: self.det + stiffness * self.a22, ..self };
        let scale = stiffer.delta.max(stiffer.a11).max(stiffer.a22).max(stiffer.det);
        if scale > 0.0 && scale.is_finite() { stiffer.times(1.0 / scale) } else { stiffer }
    }

    /// This side with the steady rest at a link's far end, if there is one.
    #[inline]
    pub fn with_rest(self, link: &Link) -> Self {
        if link.rest > 0.0 { self.sprung(link.rest) } else { self }
    }

    fn times(self, f: f64) -> Self {
        Self { delta: f * self.delta, a11: f * self.a11, a12: f * self.a12, a22: f * self.a22, det: f * self.det }
    }

    /// Deflection (m/N) and slope (rad/N, positive away from this side's support) under a unit force at the
    /// cut that this side and `other`, on the other side, hold together. Infinite or NaN where the body is
    /// loose.
    #[inline]
    pub fn joined(&self, other: &Self) -> (f64, f64) {
        let deflection = self.a22 * other.delta + other.a22 * self.delta;
        // K₁₂ is −a₁₂/δ on this side and +a₁₂/δ on the other.
        let slope = self.a12 * other.delta - other.a12 * self.delta;
        let det = self.det * other.delta
            + other.det * self.delta
            + self.a11 * other.a22
            + self.a22 * other.a11
            + 2.0 * self.a12 * other.a12;
        (deflection / det, slope / det)
    }

    /// The end of this side at its rigid support, displaced by one unit: the slope that follows, counted away
    /// from the support of the *other* end (per m), and the force it takes (N/m). `self` is all that hangs on
    /// that support.
    pub fn displaced(&self, turning: Turning) -> (f64, f64) {
        let rotation = self.a22 * turning.p + self.delta * turning.q;
        let slope = self.a12 * turning.p;
        let force = self.det * turning.p + self.a11 * turning.q;
        if rotation > 0.0 { (slope / rotation, force / rotation) } else { (0.0, 0.0) }
    }

    /// The end of this side at its rigid support, where what holds its rotation is turned by one unit: the slope that
    /// follows, the force (N) and the moment (N m) with which the support holds it, all counter-clockwise and upwards for
    /// an end on the left; `None` where its rotation is not held. `self` is all that hangs on that support.
    pub fn turned(&self, turning: Turning) -> Option<(f64, f64, f64)> {
        let rotation = self.a22 * turning.p + self.delta * turning.q;
        let by = |value: f64| value * turning.q / rotation;
        (turning.q > 0.0 && rotation > 0.0).then(|| (by(self.delta), by(self.a12), by(self.a22)))
    }

    /// Deflection and slope at the near end of a link whose far end moves by (w, θ); `self` holds the near
    /// end, and θ counts away from its support. About the link's middle u' = (I + F·K)⁻¹·u.
    #[inline]
    pub fn followed(&self, link: &Link, (w, theta): (f64, f64)) -> (f64, f64) {
        let near = self.carried(link.half);
        let far = near.softened(link.shear, link.bending);
        let w = w - link.half * theta;
        let w_middle = ((near.delta + link.bending * near.a22) * w + link.shear * near.a12 * theta) / far.delta;
        let theta_middle = (link.bending * near.a12 * w + (near.delta + link.shear * near.a11) * theta) / far.delta;
        (w_middle - link.half * theta_middle, theta_middle)
    }
}
