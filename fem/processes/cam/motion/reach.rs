//! The reach of a wheel down the normal of a point of the profile.

use crate::processes::cam::profile::{Place, Vector, left};

/// The normal of a point of the profile, along which what is left is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// A point on the profile, m.
    pub point: Vector,
    /// The unit vector outwards.
    pub normal: Vector,
}

/// A position of the wheel and what it leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The rest from the profile outwards, m: positive where material is left, negative where too much is
    /// cut.
    pub left: f64,
    /// The leg on which it is cut.
    pub leg: usize,
    /// The time on that leg.
    pub at: f64,
}

impl From<Place> for Ray {
    fn from(place: Place) -> Self {
        Self { point: place.point, normal: place.normal }
    }
}

impl Ray {
    /// The unit vector across it.
    pub fn across(&self) -> Vector {
        left(&self.normal)
    }

    /// Distance of a point beside the ray, m.
    pub fn beside(&self, point: &Vector) -> f64 {
        self.normal.perp(&(point - self.point))
    }

    /// Height of a point above the tangent of the profile, m.
    pub fn above(&self, point: &Vector) -> f64 {
        self.normal.dot(&(point - self.point))
    }

    /// The rest that a wheel of `radius` about `centre` leaves, m; infinite where it does not meet the ray,
    /// or stands below the tangent, on the other side of the cam.
    pub fn left_by(&self, centre: &Vector, radius: f64) -> f64 {
        let (above, beside) = (self.above(centre), self.beside(centre));
        // As a product: near the edge of the wheel nothing is lost.
        let square = (radius - beside) * (radius + beside);
        if square <= 0.0 || above <= 0.0 { f64::INFINITY } else { above - square.sqrt() }
    }
}

impl Reach {
    /// Nothing is reached.
    pub fn none() -> Self {
        Self { left: f64::INFINITY, leg: usize::MAX, at: 0.0 }
    }

    /// This, if anything was found.
    pub fn found(self) -> Option<Self> {
        (self.leg != usize::MAX).then_some(self)
    }

    /// Takes another, if it leaves less.
    pub fn lower(&mut self, other: Self) {
        if other.left < self.left {
            *self = other;
        }
    }
}

/// No wheel of `radius` whose centre lies within `bow` of a chord leaves less than this along the ray. A
/// wheel of `radius + bow` that runs along the chord leaves above − √((R+bow)² − beside²), convex as
/// above and beside are linear: its least is where the slope of the circle is that of the chord.
pub fn lowest_of_capsule(ray: &Ray, ends: &[Vector; 2], radius: f64, bow: f64) -> f64 {
    let [above, next_above] = ends.map(|p| ray.above(&p));
    if above.max(next_above) + bow <= 0.0 {
        return f64::INFINITY;
    }
    let [beside, next_beside] = ends.map(|p| ray.beside(&p));
    let (rise, drift) = (next_above - above, next_beside - beside);
    let reach = radius + bow;
    let length = rise.hypot(drift);
    // Where along the chord: the slope vanishes at beside = −reach·rise/length, taken with the sign of the
    // drift.
    let wanted = if length > 0.0 { -reach * rise / length * drift.signum() } else { beside };
    let part =
        if drift == 0.0 { if rise < 0.0 { 1.0 } else { 0.0 } } else { ((wanted - beside) / drift).clamp(0.0, 1.0) };
    let beside = beside + drift * part;
    let square = (reach - beside) * (reach + beside);
    if square <= 0.0 { f64::INFINITY } else { above + rise * part - square.sqrt() }
}
