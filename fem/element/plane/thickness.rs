//! What a plane body is across its plane: as thick everywhere, or turned about the axis x.
//!
//! ```text
//!   ∫ f dV = s ∫ f w(y) dA      uniform:  s = t,   w = 1
//!                               revolved: s = 2π,  w = y
//! ```

use std::f64::consts::TAU;

use super::MAX_NODES;

/// The body across its plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thickness {
    /// The same thickness t (m) everywhere.
    Uniform(f64),
    /// A body of revolution: the plane is its half section, x runs along its axis, and y is the radius. What is
    /// integrated is that of the whole body, forces of a node those on its whole circle.
    Revolved,
}

impl Thickness {
    /// s: t (m), or 2π.
    pub fn scale(self) -> f64 {
        match self {
            Self::Uniform(thickness) => thickness,
            Self::Revolved => TAU,
        }
    }

    /// w at a point of this y (m): 1, or y (m).
    pub fn weight(self, y: f64) -> f64 {
        match self {
            Self::Uniform(_) => 1.0,
            Self::Revolved => y,
        }
    }

    /// Strain of the circle through a point of this y (m) by a radial motion of 1 m of each node, Nₐ/y (1/m); zero in
    /// bodies that have no circles.
    pub fn hoops(self, shapes: &[f64; MAX_NODES], y: f64) -> [f64; MAX_NODES] {
        match self {
            Self::Uniform(_) => [0.0; MAX_NODES],
            Self::Revolved => shapes.map(|shape| shape / y),
        }
    }

    /// Whether it is a body of revolution.
    pub fn is_revolved(self) -> bool {
        self == Self::Revolved
    }
}
