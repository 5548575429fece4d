//! Benches for rows of the table: a number of a report, a root, a row.

use super::{Case, Tolerance};
use crate::process::{Assembled, Definition, ForwardModel};
use crate::progress::Progress;

/// A number of a run's figures by the figure's key and its path inside, in the unit in which it is told;
/// NaN where there is none.
pub fn figure<D: Definition>(machine: &Option<Assembled<D>>, key: &str, path: &str) -> f64 {
    let report = machine.as_ref().and_then(|m| m.report(m.predict(&Progress::default()).ok()?).ok());
    let figure = report.as_ref().and_then(|r| r.figures.iter().find(|f| f.key == key));
    figure.and_then(|f| f.value_at(path)).unwrap_or(f64::NAN)
}

/// A row of the table: (expected, computed, unit).
pub fn row(
    name: impl Into<String>,
    quantity: &'static str,
    (expected, computed, unit): (f64, f64, &'static str),
    tolerance: Tolerance,
    source: &'static str,
) -> Case {
    Case { name: name.into(), quantity, expected, computed, unit, tolerance, source }
}

/// The tables of a model file that say what is modelled: without title, process and effects.
pub fn tables(model: &str) -> String {
    let tables = model.split("[effects").next().unwrap_or_default();
    let own = |line: &&str| !line.starts_with("title") && !line.starts_with("process");
    tables.lines().filter(own).collect::<Vec<_>>().join("\n")
}

/// The root of a rising function between `low` and `high`, by bisection: slow, and nothing that could go
/// wrong with Newton's method goes wrong with it.
pub fn bisect(mut low: f64, mut high: f64, rising: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if rising(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}
