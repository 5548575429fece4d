//! Rings and rows for the table.

use crate::element::plane::{Elasticity, PlaneState, Quad8};
use crate::mesh::{Grading, Mesh, RingMesh};
use crate::process::{Assembled, ForwardModel, Rows, Values, assembled};
use crate::processes::ring::Ring;
use crate::processes::ring::rows::{ANGLE_OF_ROW, COORDINATES, JAW_FORCE, RUN, SPEED, STATE};
use crate::validation::Tolerance;
pub(super) use crate::validation::bench::{figure as figure_of, row};

/// A ring in its chuck with effects.
pub type Chuck = Assembled<Ring>;

/// Round-off of sums of doubles.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A steel ring of Ø100 × 20 mm, deviations from the set circle. Words in capitals are replaced.
pub const RING: &str = r#"
    workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "BORE mm", width = "20 mm" }
    chuck = { jaws = JAWS, jaw_force = "3 kN" }
    cut = { spindle_speed = "400 rpm", force_per_depth = "1 kN/mm" }
    mesh = { circumferential = 360, radial = 6, order = 2 }
    measurement = { reference = "absolute" }
"#;

/// The text of a ring of this bore (mm) in so many jaws.
pub fn ring(bore: f64, jaws: usize) -> String {
    RING.replace("BORE", &bore.to_string()).replace("JAWS", &jaws.to_string())
}

/// The chuck of a model's text with effects given as TOML. A mistake in a text shows as NaN in every row
/// that uses it, so no row can pass by it.
pub fn chuck(text: &str, effects: &str) -> Option<Chuck> {
    assembled(text, effects)
}

/// Deviations at angles (rad) of one set-up in the model's own conditions but for some columns, m; NaN where
/// they cannot be computed.
pub fn deviations(chuck: &Option<Chuck>, angles: &[f64], changes: &[(usize, f64)]) -> Vec<f64> {
    let mut columns = vec![Values::shared(0.0, angles.len()); COORDINATES.len()];
    columns[ANGLE_OF_ROW] = angles.to_vec().into();
    for column in [JAW_FORCE, SPEED] {
        columns[column].fill(f64::NAN);
    }
    columns[RUN].fill(1.0);
    for (column, value) in changes {
        columns[*column].fill(*value);
    }
    let rows = Rows { columns, observable: Values::shared(0, angles.len()) };
    let observed = chuck.as_ref().and_then(|c| c.observe(&rows).ok());
    observed.unwrap_or_else(|| vec![f64::NAN; angles.len()])
}

/// Radial displacement of the clamped bore at an angle (rad), m.
pub fn clamped(chuck: &Option<Chuck>, angle: f64) -> f64 {
    deviations(chuck, &[angle], &[(STATE, 1.0)])[0]
}

/// The mesh of the ring of these rows with a bore of 84 mm, and its elastic law, for a solution of its own.
pub fn mesh() -> Option<(Mesh, Elasticity)> {
    let ring = RingMesh {
        outer_radius: 0.05,
        inner_radius: 0.042,
        circumferential: 360,
        radial: 6,
        element: &Quad8,
        grading: Grading::uniform(),
    };
    Some((ring.build().ok()?, Elasticity::new(PlaneState::Stress, 210e9, 0.3, 0.0, 0.02).ok()?))
}
