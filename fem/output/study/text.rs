//! A study for people.

use std::fmt::Write;

use super::rows::with_unit;
use crate::output::fit::Short;
use crate::output::text::titled;
use crate::study::{Acceptance, Extreme, Found, Index, Layout, Nature, Numbers, ResultColumn, Summary};

/// Results of which indices are told, unless they have a tolerance.
const MOST_WITH_INDICES: usize = 3;
/// Words of a column that are told.
const MOST_WORDS: usize = 8;

/// Writes a study. Writing to a String does not fail.
pub fn text(layout: &Layout, summary: &Summary) -> String {
    let title = titled(layout.title.as_deref(), &layout.plan);
    let mut text = format!("{title}\nstudy: {}\n\n", about(layout));
    let share = 100.0 * summary.failed as f64 / summary.rows.max(1) as f64;
    let failed = match summary.failed {
        0 => "none failed".to_string(),
        failed => format!("{failed} failed ({share:.3} %)"),
    };
    let of = if summary.rows < layout.jobs { format!(" of {}", layout.jobs) } else { String::new() };
    let _ = writeln!(text, "  {:<12} {}{of}, {failed}", "jobs", summary.rows);
    for (job, message) in &summary.failures {
        let _ = writeln!(text, "  {:<12} job {job}: {message}", "");
    }
    let all = || layout.results.iter().zip(&summary.results);
    let width = all().map(|(column, _)| with_unit(&column.name, &column.unit).chars().count()).max().unwrap_or(0);
    let width = width.max(12);
    if all().any(|(_, found)| matches!(found, Found::Numbers(_))) {
        let _ = writeln!(
            text,
            "\n  {:<width$} {:>12} {:>12} {:>12} {:>12}",
            "results", "mean", "std", "smallest", "largest"
        );
    }
    for (column, found) in all() {
        let name = with_unit(&column.name, &column.unit);
        match found {
            Found::Numbers(numbers) => {
                let [low, high] = match &numbers.ends {
                    Some(ends) => [short(ends[0].value), short(ends[1].value)],
                    None => ["-".to_string(), "-".to_string()],
                };
                let (mean, std) = (short(numbers.mean), short(numbers.std));
                let missing = match numbers.missing {
                    0 => String::new(),
                    missing => format!("   not there in {missing} jobs"),
                };
                let _ = writeln!(text, "  {name:<width$} {mean:>12} {std:>12} {low:>12} {high:>12}{missing}");
            }
            Found::Words(words) => {
                let told: Vec<String> =
                    words.iter().take(MOST_WORDS).map(|(word, count)| format!("{word} {count}")).collect();
                let _ = writeln!(text, "  {name:<width$} {}", told.join(", "));
            }
        }
    }
    for (i, (column, found)) in all().enumerate() {
        let Found::Numbers(numbers) = found else { continue };
        if let (Some(acceptance), Some(tolerance)) = (numbers.acceptance, column.tolerance) {
            tolerated(&mut text, layout, (column, numbers), acceptance, tolerance);
        }
        let is_told = column.tolerance.is_some() || i < MOST_WITH_INDICES;
        if let (Some((indices, groups)), true) = (&numbers.indices, is_told) {
            sensitivity(&mut text, layout, column, (indices, *groups));
        }
    }
    if let (Some(caution), true) = (Summary::caution(layout.nature), all().any(|(c, _)| c.tolerance.is_some())) {
        let _ = writeln!(text, "\nnote: {caution}");
    }
    text
}

fn about(layout: &Layout) -> String {
    let count = layout.inputs.len();
    let inputs = if count == 1 { "1 input".to_string() } else { format!("{count} inputs") };
    let points = match layout.group {
        1 => format!("{} jobs", layout.jobs),
        group => format!("{} groups of {group} jobs", layout.jobs / group),
    };
    format!("`{}` in {points}, {inputs}, design `{}`", layout.task, layout.design)
}

fn short(value: f64) -> String {
    if value.is_finite() { format!("{:.6}", Short(value)) } else { "-".into() }
}

fn tolerated(
    text: &mut String,
    layout: &Layout,
    (column, numbers): (&ResultColumn, &Numbers),
    acceptance: Acceptance,
    (low, high): (f64, f64),
) {
    let unit = &column.unit;
    let within = match (low.is_finite(), high.is_finite()) {
        (true, true) => format!("from {} to {} {unit}", short(low), short(high)),
        (true, false) => format!("of at least {} {unit}", short(low)),
        _ => format!("of at most {} {unit}", short(high)),
    };
    let _ = writeln!(text, "\n  {} with a tolerance {}", column.name, within.trim_end());
    let Acceptance { good, bad, failed } = acceptance;
    let percent = |share: f64| format!("{:.3}", 100.0 * share);
    let interval = match layout.nature {
        Nature::Listed => String::new(),
        _ => {
            let (low, high) = acceptance.interval();
            format!(" (95 %: {} to {} %)", percent(low), percent(high))
        }
    };
    let word = if layout.nature == Nature::Listed { "within" } else { "yield" };
    let _ = writeln!(
        text,
        "    {word:<10} {} %{interval}: {good} good, {bad} bad, {failed} failed",
        percent(acceptance.share())
    );
    if let Some(worst) = &numbers.worst {
        let beyond = (low - worst.value).max(worst.value - high);
        let told = if beyond > 0.0 { "beyond" } else { "within" };
        let _ = writeln!(
            text,
            "    {:<10} {} {unit} in job {}, {} {unit} {told} the tolerance",
            "worst",
            short(worst.value),
            worst.job,
            short(beyond.abs())
        );
        point(text, layout, worst);
    }
}

/// Where a value came from.
fn point(text: &mut String, layout: &Layout, extreme: &Extreme) {
    if let Some(data) = &extreme.data {
        let _ = writeln!(text, "    {:<10} {data}", "");
    }
    for ((name, unit), value) in layout.inputs.iter().zip(&extreme.inputs) {
        let _ = writeln!(text, "    {:<10} {}", "", format!("{name} = {} {unit}", short(*value)).trim_end());
    }
}

fn sensitivity(text: &mut String, layout: &Layout, column: &ResultColumn, (indices, groups): (&[Index], u64)) {
    let mut order: Vec<usize> = (0..indices.len()).collect();
    order.sort_by(|a, b| indices[*b].total.total_cmp(&indices[*a].total));
    let width = layout.inputs.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0).max(12);
    let _ = writeln!(
        text,
        "\n  parts of the variance of {}, of {groups} groups (standard errors)\n    {:<width$} {:>16} {:>16}",
        column.name, "input", "alone", "with others"
    );
    for i in order {
        let Index { first, first_error, total, total_error } = indices[i];
        let told = |value: f64, error: f64| format!("{value:.3} ({error:.3})");
        let (alone, all) = (told(first, first_error), told(total, total_error));
        let _ = writeln!(text, "    {:<width$} {alone:>16} {all:>16}", layout.inputs[i].0);
    }
}
