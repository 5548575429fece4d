//! Tubes and discs: closed forms of their thermal growth, and of a tube under pressure.

use super::rig::*;
use crate::element::plane::{Elasticity, Quad8};
use crate::mesh::{RevolvedMesh, Wall};
use crate::solve::elastic::{ElasticSystem, Loads};
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [warm_tube(), under_pressure()].concat()
}

/// The growth of a wall whose temperature rises as the logarithm of its radius from `inner` to `outer`, 1 K in all.
struct LogWall {
    inner: f64,
    outer: f64,
}

impl LogWall {
    /// ∫ T r dr from the bore to a radius.
    fn moment(&self, r: f64) -> f64 {
        let Self { inner: a, outer: b } = *self;
        (0.5 * r * r * (r / a).ln() - 0.25 * (r * r - a * a)) / (b / a).ln()
    }

    /// u/α of a thin disc, and of the middle of a long tube with free ends (Timoshenko and Goodier).
    fn grown(&self, r: f64, is_long: bool) -> f64 {
        const NU: f64 = 0.3;
        let Self { inner: a, outer: b } = *self;
        let (own, whole) = (self.moment(r), self.moment(b) / (b * b - a * a));
        if is_long {
            let rest = ((1.0 - 3.0 * NU) * r * r + (1.0 + NU) * a * a) * whole;
            ((1.0 + NU) * own + rest) / ((1.0 - NU) * r)
        } else {
            ((1.0 + NU) * own + ((1.0 - NU) * r * r + (1.0 + NU) * a * a) * whole) / r
        }
    }
}

/// The bore of 40 mm at 20, the outside of 80 at 60: a disc of 1 mm, and a tube of 400 mm at its middle.
fn warm_tube() -> Vec<Case> {
    let wall = LogWall { inner: 0.02, outer: 0.04 };
    let mut cases = Vec::new();
    for (length, is_long, name) in [
        (1.0, false, "disc of 40/80 x 1 mm, 40 K warmer outside"),
        (400.0, true, "tube of 40/80 x 400 mm, 40 K warmer outside"),
    ] {
        let held = body(
            &format!(
                r#"
            body = {{ material = "steel", revolved = [{{ length = "{length} mm", diameter = "80 mm", bore = "40 mm" }}] }}
            boundary = [{{ edge = "bore", temperature = "20 degC" }}, {{ edge = "outside", temperature = "60 degC" }}]
            environment = {{ temperature = "20 degC" }}
            time = {{ end = "1e5 min", step = "1e4 min", scheme = "backward-euler" }}
            mesh = {{ element_size = "2 mm" }}
            "#
            ),
            "",
        );
        let middle = 0.5e-3 * length;
        for (r, quantity) in [(0.02, "bore"), (0.028, "diameter at 28 mm"), (0.04, "outside")] {
            let expected = 2e6 * ALPHA * 40.0 * wall.grown(r, is_long);
            let found = diameter(&held, [middle, r], 6e6);
            // The disc is thin to a part of the square of its 1 mm over its wall of 20; ends of the tube fade.
            let tolerance = Tolerance::Relative(if is_long { 2e-5 } else { 5e-4 });
            cases.push(row(
                name,
                quantity,
                (expected, found, "um"),
                tolerance,
                "Timoshenko and Goodier, thermal stress in a disk and a long cylinder",
            ));
        }
        let mean = 2.0 * wall.moment(0.04) / (0.04 * 0.04 - 0.02 * 0.02);
        let grown = 1e3 * ALPHA * 40.0 * mean * length;
        let found = 1e6 * elongation(&held, 6e6);
        let law = "mean temperature: no mean stress along the axis";
        cases.push(row(name, "elongation", (grown, found, "um"), Tolerance::Relative(1e-5), law));
    }
    cases
}

/// A tube of 40/80 mm with free ends under 10 MPa within: Lamé.
fn under_pressure() -> Vec<Case> {
    let (a, b, pressure, e, nu) = (0.02_f64, 0.04_f64, 1e7, 210e9, 0.3);
    let widened = |at: f64| -> Option<f64> {
        let walls = vec![Wall { length: 0.03, radii: [a, b] }];
        let mesh = RevolvedMesh { walls, size: 2.5e-3, sections: Vec::new(), element: &Quad8 }.build().ok()?;
        let law = Elasticity::revolved(e, nu, 0.0).ok()?;
        let mut loads = Loads::none(&mesh);
        loads.add_pressure(&mesh, &law, "bore", pressure).ok()?;
        let solution = ElasticSystem::free(&mesh, law).ok()?.solve(&loads).ok()?;
        Some(solution.nodes[mesh.nearest_node([0.01, at])][1])
    };
    let lame = |r: f64| {
        let share = pressure * a * a / (b * b - a * a) / e;
        share * ((1.0 - nu) * r + (1.0 + nu) * b * b / r)
    };
    let one = |quantity, r: f64| {
        let found = 1e6 * widened(r).unwrap_or(f64::NAN);
        // Eight quadratic elements across the wall: errors of the fourth power.
        let tolerance = Tolerance::Relative(1e-5);
        row("tube of 40/80 mm, 10 MPa within", quantity, (1e6 * lame(r), found, "um"), tolerance, "Lame")
    };
    vec![one("radial displacement of the bore", a), one("radial displacement of the outside", b)]
}
