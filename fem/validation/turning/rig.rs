//! A lathe from a model's text, and what can be read off it.

use crate::process::{Assembled, ForwardModel, Rows, Values, assembled};
use crate::processes::turning::Turning;
use crate::processes::turning::condense;
use crate::processes::turning::cut::Conditions;
use crate::processes::turning::elastic::{Cutting, Elastic};
use crate::processes::turning::forward::unloaded;
use crate::processes::turning::rows::{COORDINATES, X};
use crate::progress::Progress;
pub(super) use crate::validation::bench::{bisect, row};
use crate::validation::{Case, Tolerance};

/// A lathe with its effects.
pub type Lathe = Assembled<Turning>;

/// Agreement of two exact calculations: a thousand rounding errors.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A uniform steel shaft, Ø40 × 500 mm, under 400 N. The words in capitals are replaced.
pub const UNIFORM: &str = r#"
    workpiece = { material = "steel", segments = [{ length = "500 mm", diameter = "40 mm" }] }
    workholding = { type = "HELD" }
    cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "400 N" }
    mesh = { beam = "euler-bernoulli" }
"#;

/// The lathe of a model's text with effects given as TOML. A mistake in a text shows as NaN in every row
/// that uses it, so no row can pass by it.
pub fn lathe(text: &str, effects: &str) -> Option<Lathe> {
    assembled(text, effects)
}

/// The uniform shaft held by `held`, with effects.
pub fn uniform(held: &str, effects: &str) -> Option<Lathe> {
    lathe(&UNIFORM.replace("HELD", held), effects)
}

/// The gap between tool and work at x (m) under the model's own force, m.
pub fn gap(lathe: &Option<Lathe>, x: f64) -> f64 {
    gap_under(lathe, x, None)
}

/// The gap under other conditions, m.
pub fn gap_under(lathe: &Option<Lathe>, x: f64, conditions: Option<Conditions>) -> f64 {
    let solve = |lathe: &Lathe| {
        let shaft = condense(lathe.machine(), &[x]).ok()?;
        let conditions = conditions.unwrap_or(lathe.setup().conditions(0.0, 0.0));
        let at = Cutting::new(lathe.machine(), &lathe.machine().moment_on(1, x), conditions);
        Elastic::new(lathe.machine(), &shaft).deflect(0, &at).ok().map(|d| d.total)
    };
    lathe.as_ref().and_then(solve).unwrap_or(f64::NAN)
}

/// Diameter error observed at x (m) under the given coordinates, m.
pub fn observed(lathe: &Lathe, x: f64, given: &[(usize, f64)]) -> f64 {
    let mut columns = vec![Values::shared(f64::NAN, 1); COORDINATES.len()];
    columns[X].fill(x);
    given.iter().for_each(|(column, value)| columns[*column].fill(*value));
    let rows = Rows { columns, observable: Values::shared(0, 1) };
    lathe.observe(&rows).map_or(f64::NAN, |values| values[0])
}

/// Diameter error at x (m) of a part without the force's share, m.
pub fn shift(lathe: &Option<Lathe>, part: usize, x: f64) -> f64 {
    let left = |l: &Lathe| unloaded(l.machine(), &l.machine().moment_on(part, x)).ok();
    lathe.as_ref().and_then(left).unwrap_or(f64::NAN)
}

/// The whole predicted profile, part by part, m.
pub fn profile(lathe: &Option<Lathe>) -> Vec<f64> {
    lathe.as_ref().and_then(|l| l.predict(&Progress::default()).ok()).unwrap_or_default()
}

/// A deflection in m, met to round-off.
pub fn deflection(name: impl Into<String>, (expected, computed): (f64, f64), source: &'static str) -> Case {
    row(name, "deflection", (expected, computed, "m"), ROUND_OFF, source)
}

/// A diameter error in m, met to round-off.
pub fn diameter_error(name: impl Into<String>, (expected, computed): (f64, f64), source: &'static str) -> Case {
    row(name, "diameter error", (expected, computed, "m"), ROUND_OFF, source)
}

/// E, EI and κGA of the uniform shaft, computed apart from the program's own sections.
pub struct Shaft40 {
    pub force: f64,
    pub length: f64,
    pub ei: f64,
    pub shear: f64,
}

/// Ø40 × 500 mm of steel, 400 N.
pub fn shaft40() -> Shaft40 {
    let (e, nu, d) = (210e9, 0.3, 0.04f64);
    let ei = e * std::f64::consts::PI * d.powi(4) / 64.0;
    let kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
    let shear = kappa * e / (2.0 * (1.0 + nu)) * std::f64::consts::PI * d * d / 4.0;
    Shaft40 { force: 400.0, length: 0.5, ei, shear }
}
