//! Budgets from their texts, and rows about them.

use crate::budget::{Budget, Drawn, Estimate};
use crate::input::Source;
use crate::progress::Progress;
use crate::validation::{Case, Tolerance};

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
    let read = Budget::parse(Source::new("budget.toml", text)).ok()?;
    read.estimate(&Progress::default()).ok().flatten()
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

/// Draws the errors of a text so many times.
pub fn drawn(errors: &str, samples: usize) -> Option<Drawn> {
    budget(&format!("budget = {{ samples = {samples}, seed = 20 }}\n{errors}")).map(|e| e.monte_carlo)
}

/// Makes rows of mean and standard deviation of a drawn law with this mean, standard deviation (um) and kurtosis:
/// within three standard errors.
pub fn moments(
    name: &str,
    (errors, samples): (&str, usize),
    (mean, std, kurtosis): (f64, f64, f64),
    source: &'static str,
) -> Vec<Case> {
    let drawn = drawn(errors, samples);
    let of = |figure: fn(&Drawn) -> f64| drawn.as_ref().map_or(f64::NAN, figure);
    let count = samples as f64;
    let errors = [std / count.sqrt(), std * ((kurtosis - 1.0) / (4.0 * count)).sqrt()];
    let [of_mean, of_std] = errors.map(|e| Tolerance::Absolute(3.0 * e));
    vec![
        row(name, "mean", (mean, of(|d| d.mean.value)), of_mean, source),
        row(name, "standard deviation", (std, of(|d| d.std.value)), of_std, source),
    ]
}
