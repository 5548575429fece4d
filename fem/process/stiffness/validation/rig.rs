//! Joints and rows for the table.

use std::sync::Arc;

use toml_edit::Document;

use super::super::observe::UNLOAD;
use super::super::{Pushed, Setup, effect};
use crate::input::Reader;
use crate::process::{Case, Job, Rows, Tolerance};

/// What sums of doubles leave.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A row of the table.
pub fn row(
    name: impl Into<String>,
    quantity: &'static str,
    (expected, computed, unit): (f64, f64, &'static str),
    tolerance: Tolerance,
    source: &'static str,
) -> Case {
    Case { name: name.into(), quantity, expected, computed, unit, tolerance, source }
}

/// A spring of 80 N/um, loaded up to 1000 N, with effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can
/// pass by it.
pub fn joint(effects: &str) -> Option<Pushed> {
    let text = "joint = { stiffness = \"80 N/um\" }\ntest = { max_force = \"1000 N\", steps = 20 }";
    let document = Document::parse(text).ok()?;
    let (setup, _, problems) = Reader::document(document.as_table(), Setup::read);
    let effects = Document::parse(effects).ok()?;
    let read = |model: &Reader| {
        let mut active = Vec::new();
        for (name, _) in effects.iter() {
            let description = effect(name)?.description();
            active.push(model.table(description.name, "", |t| description.read(t)));
        }
        Some(active)
    };
    let (active, _, more) = Reader::document(effects.as_table(), read);
    (problems.is_empty() && more.is_empty()).then(|| Pushed::equip(Arc::new(setup), &active.unwrap_or_default()))
}

/// y under a force (N) on loading, um.
pub fn up(joint: &Option<Pushed>, force: f64) -> f64 {
    observed(joint, force, 0.0)
}

/// y under a force (N) on unloading, um.
pub fn down(joint: &Option<Pushed>, force: f64) -> f64 {
    observed(joint, force, UNLOAD)
}

fn observed(joint: &Option<Pushed>, force: f64, branch: f64) -> f64 {
    let rows = Rows { columns: vec![vec![force], vec![branch]], observable: vec![0] };
    joint.as_ref().and_then(|j| j.observe(&rows).ok()).map_or(f64::NAN, |y| 1e6 * y[0])
}
