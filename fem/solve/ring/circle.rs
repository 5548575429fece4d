//! Sides of elements along a circle about the origin, addressed by angle.

use std::f64::consts::{PI, TAU};

use crate::element::plane::{EDGE_NODES, EdgeCurve, edge_shapes};
use crate::mesh::{Mesh, MeshError, Side, SideNodes};

/// One side on the circle: an arc from the angle `start` over `span` (rad), where `span` < 0 for a side that
/// runs clockwise.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    curve: EdgeCurve,
    pub nodes: SideNodes,
    pub start: f64,
    pub span: f64,
}

impl Arc {
    fn new(curve: EdgeCurve, nodes: SideNodes) -> Self {
        let angle = |s: f64| {
            let [x, y] = curve.point(s);
            y.atan2(x)
        };
        let start = angle(-1.0);
        Self { curve, nodes, start, span: wrapped(angle(1.0) - start) }
    }

    /// Parameter s of the side's point at `angle` beyond its start (rad, with the sign of the span), by
    /// Newton's method on the polar angle of x(s).
    pub fn parameter(&self, angle: f64) -> f64 {
        let (sine, cosine) = (self.start + angle).sin_cos();
        let mut s = 2.0 * angle / self.span - 1.0;
        for _ in 0..8 {
            let ([x, y], [dx, dy]) = (self.curve.point(s), self.curve.tangent(s));
            // distance from the ray and its derivative
            let step = (cosine * y - sine * x) / (cosine * dy - sine * dx);
            s -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        s
    }

    /// Shape functions of the side's nodes at `angle` beyond its start.
    pub fn shapes(&self, angle: f64) -> [f64; EDGE_NODES] {
        edge_shapes(self.curve.nodes(), self.parameter(angle))
    }

    /// Angle from the lower end of the arc to `angle` (rad), counter-clockwise, in [0, 2π).
    pub fn beyond(&self, angle: f64) -> f64 {
        (angle - self.low()).rem_euclid(TAU)
    }

    /// The lower end in angle, rad.
    pub fn low(&self) -> f64 {
        self.start + self.span.min(0.0)
    }

    /// Angle beyond the *start* of what lies `beyond` the lower end.
    pub fn beyond_start(&self, beyond: f64) -> f64 {
        beyond + self.span.min(0.0)
    }
}

/// Sides on a circle, ordered by angle around the origin.
pub(super) fn arcs(mesh: &Mesh, sides: &[Side]) -> Vec<Arc> {
    let own = |&side| Arc::new(mesh.curve(side), mesh.side_nodes(side));
    let mut arcs: Vec<Arc> = sides.iter().map(own).collect();
    arcs.sort_by(|a, b| a.low().rem_euclid(TAU).total_cmp(&b.low().rem_euclid(TAU)));
    arcs
}

/// The sides called `name`, which close around the origin.
pub(super) fn all_around(mesh: &Mesh, name: &str) -> Result<Vec<Arc>, MeshError> {
    let arcs = arcs(mesh, mesh.sides(name)?);
    let covered: f64 = arcs.iter().map(|arc| arc.span.abs()).sum();
    if (covered - TAU).abs() > 1e-6 {
        let quantity = "angle that the sides cover around the origin (rad)";
        return Err(MeshError::Parameter { quantity, range: format!("2π all along `{name}`"), value: covered });
    }
    Ok(arcs)
}

/// An angle in (−π, π].
fn wrapped(angle: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    if turned > PI { turned - TAU } else { turned }
}
