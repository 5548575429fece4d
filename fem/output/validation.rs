//! The answer of `fem validate`: expected and computed values.

use std::fmt::Write;

use serde_json::{Value, json};

use super::answer::Answer;
use super::block::Block;
use super::json::finite;
use crate::validation::{Case, Tolerance};

/// Cases of the validation table to be shown, and the number of all.
pub struct ValidationAnswer<'a>(pub &'a [Case], pub usize);

impl Answer for ValidationAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(cases, total) = *self;
        let width = cases.iter().map(|c| c.name.chars().count() + c.quantity.chars().count() + 2).max().unwrap_or(0);
        let mut text = format!(
            "{:<width$} {:>16} {:>16} {:<8} {:>9} {:>9}\n",
            "case", "expected", "computed", "unit", "error", "allowed"
        );
        for case in cases {
            let name = format!("{}, {}", case.name, case.quantity);
            let percent = if matches!(case.tolerance, Tolerance::Relative(_)) { " rel" } else { " abs" };
            let verdict = if case.passed() { "" } else { "  FAILED" };
            let _ = writeln!(
                text,
                "{name:<width$} {:>16} {:>16} {:<8} {:>9.1e} {:>9.1e}{percent}  {}{verdict}",
                figure(case.expected),
                figure(case.computed),
                case.unit,
                case.error(),
                case.allowed(),
                case.source,
            );
        }
        let failed = cases.iter().filter(|c| !c.passed()).count();
        let part = if cases.len() < total { format!(" of {total}") } else { String::new() };
        let _ = writeln!(text, "\n{}{part} cases, {failed} failed", cases.len());
        vec![Block::Lines(text)]
    }

    /// `fem validate --json`: `fem-validation/1`.
    fn json(&self) -> Value {
        let Self(cases, total) = *self;
        let case = |c: &Case| {
            json!({
                "name": c.name,
                "quantity": c.quantity,
                "expected": finite(c.expected),
                "computed": finite(c.computed),
                "unit": c.unit,
                "error": finite(c.error()),
                "error_is": match c.tolerance { Tolerance::Relative(_) => "relative", Tolerance::Absolute(_) => "absolute" },
                "tolerance": c.allowed(),
                "source": c.source,
                "passed": c.passed(),
            })
        };
        json!({ "schema": "fem-validation/1", "cases": cases.iter().map(case).collect::<Vec<_>>(), "total": total })
    }
}

fn figure(value: f64) -> String {
    match value.abs() {
        a if a == 0.0 || (1e-3..1e6).contains(&a) => format!("{value:.9}"),
        _ => format!("{value:.9e}"),
    }
}
