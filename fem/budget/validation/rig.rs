//! Budgets from their texts, and rows about them.

use super::super::{Estimate, estimate, read};
use crate::input::Source;
use crate::process::{Case, Tolerance};
use crate::progress::Progress;

/// Adds up the budget of a text. A mistake in a text shows as NaN in every row that uses it, so that no row
/// can pass by it.
pub fn budget(text: &str) -> Option<Estimate> {
    // Rows that call their errors alike mean several of them.
    let mut text = text.to_string();
    for number in 1.. {
        let numbered = text.replacen("name = \"e\"", &format!("name = \"e{number}\""), 1);
        if numbered == text {
            break;
        }
        text = numbered;
    }
    let read = read::parse(Source::new("budget.toml", text)).ok()?;
    estimate(&read, &Progress::default()).ok().flatten()
}

/// Makes a row in micrometres of figures in metres.
pub fn row(
    name: impl Into<String>,
    quantity: &'static str,
    (expected, computed): (f64, f64),
    tolerance: Tolerance,
    source: &'static str,
) -> Case {
    Case { name: name.into(), quantity, expected, computed: 1e6 * computed, unit: "um", tolerance, source }
}
