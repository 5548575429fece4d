//! The validation table of budgets: the handbook's formulas by hand, read from a budget's text, and laws whose moments and quantiles are known.

mod drawing;
mod formulas;

use super::{Estimate, estimate};
use crate::input::Source;
use crate::process::{Case, Tolerance};
use crate::progress::Progress;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [formulas::cases(), drawing::cases()].concat()
}

/// The budget of a text, added up. A mistake in a text shows as NaN in every row that uses it, so no row can pass by it.
fn budget(text: &str) -> Option<Estimate> {
    // Rows that call their errors alike mean several of them.
    let mut text = text.to_string();
    for number in 1.. {
        let numbered = text.replacen("name = \"e\"", &format!("name = \"e{number}\""), 1);
        if numbered == text {
            break;
        }
        text = numbered;
    }
    let read = super::read::parse(Source::new("budget.toml", text)).ok()?;
    estimate(&read, &Progress::default()).ok().flatten()
}

/// A row in micrometres of figures in metres.
fn row(
    name: impl Into<String>,
    quantity: &'static str,
    (expected, computed): (f64, f64),
    tolerance: Tolerance,
    source: &'static str,
) -> Case {
    Case { name: name.into(), quantity, expected, computed: 1e6 * computed, unit: "um", tolerance, source }
}
