//! Draws small curves in text.

use crate::process::Plot;

/// Columns of a curve with its labels where nothing is known of the terminal.
pub const USUAL: usize = 73;
/// Columns that the labels take, and fewest of the curve.
const LABELS: usize = 12;
const NARROWEST: usize = 20;
/// Lines of a curve, and of one that is wide.
const HEIGHT: usize = 11;
const WIDE: usize = 100;
const TALL: usize = 16;

/// Draws a curve as lines of text with its axes, as wide as there are columns.
pub fn lines(plot: &Plot, columns: usize) -> Vec<String> {
    let width = columns.saturating_sub(LABELS).max(NARROWEST);
    let height = if width > WIDE { TALL } else { HEIGHT };
    let ys = || plot.points.iter().map(|p| p.1);
    let (low, high) = (ys().fold(f64::INFINITY, f64::min), ys().fold(f64::NEG_INFINITY, f64::max));
    let mut lines = vec![plot.title.clone()];
    let (Some(first), Some(last)) = (plot.points.first(), plot.points.last()) else { return lines };
    // A constant is drawn in the middle; below a millionth of a unit there is nothing to see.
    let (low, high) = if high - low < 1e-6 { (low - 0.5, high + 0.5) } else { (low, high) };
    let row_at = |column: usize| {
        let x = first.0 + (last.0 - first.0) * (column as f64 / (width - 1) as f64);
        let row = (high - value_at(&plot.points, x)) / (high - low) * (height - 1) as f64;
        (row.round() as usize).min(height - 1)
    };
    let rows: Vec<usize> = (0..width).map(row_at).collect();
    let label = |row: usize| high - (high - low) * (row as f64 / (height - 1) as f64);
    for row in 0..height {
        let mark = if row % 5 == 0 { format!("{:>10} ┤", short(label(row))) } else { format!("{:>10} │", "") };
        let line: String = rows.iter().map(|r| if *r == row { '•' } else { ' ' }).collect();
        lines.push(format!("{mark}{}", line.trim_end()));
    }
    lines.push(format!("{:>10} └{}", "", "─".repeat(width)));
    let (left, right) = (short(first.0), format!("{} {}", short(last.0), plot.x_unit));
    lines.push(format!("{:>11} {left}{right:>width$}", "", width = width - left.chars().count()));
    lines
}

/// Interpolates linearly between the points.
fn value_at(points: &[(f64, f64)], x: f64) -> f64 {
    let i = points.partition_point(|p| p.0 < x).clamp(1, points.len().max(2) - 1);
    let (Some(a), Some(b)) = (points.get(i - 1), points.get(i)) else {
        return points.first().map_or(0.0, |p| p.1);
    };
    a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0)
}

/// Writes a number in a few characters.
fn short(value: f64) -> String {
    match value.abs() {
        a if a >= 1000.0 => format!("{value:.0}"),
        a if a >= 100.0 => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}
