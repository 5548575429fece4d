//! Points and directions in the plane of a cam.

use nalgebra::Vector2;

/// A point or a direction in the cam's plane; the origin is the cam's axis.
pub type Vector = Vector2<f64>;

/// The unit vector at an angle.
pub fn direction(angle: f64) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    Vector::new(cosine, sine)
}

/// A vector turned by a quarter, counter-clockwise.
pub fn left(v: &Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

/// The angle from one vector to another, between −π and π.
pub fn turn(from: &Vector, to: &Vector) -> f64 {
    from.perp(to).atan2(from.dot(to))
}

/// A place on the profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The point, m.
    pub point: Vector,
    /// The unit vector outwards.
    pub normal: Vector,
    /// Positive where the cam is convex, 1/m.
    pub curvature: f64,
}

impl Place {
    /// The point at a distance outwards, m.
    pub fn outside(&self, distance: f64) -> Vector {
        self.point + self.normal * distance
    }
}
