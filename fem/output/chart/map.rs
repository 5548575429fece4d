//! A value over two axes, as coloured cells with their scale beside them.

use super::data::{Axis, Chart};
use super::scale::{Frame, Scale};
use super::style::STEPS;
use super::svg::Svg;

/// Size of the picture, pixels.
const SIZE: [f64; 2] = [680.0, 380.0];
const LEFT: f64 = 64.0;
const RIGHT: f64 = SIZE[0] - 104.0;
const TOP: f64 = 78.0;
const BOTTOM: f64 = SIZE[1] - 52.0;
/// Left and right edge of the scale of colours.
const BAR: [f64; 2] = [SIZE[0] - 84.0, SIZE[0] - 66.0];
/// Most cells along an axis, and of a map: more make a page heavy and are not seen.
const MOST: usize = 160;
const MOST_CELLS: usize = 2500;

pub fn draw(chart: &Chart, [x, y, value]: [&Axis; 3], cells: &[[f64; 3]]) -> Svg {
    let mut svg = Svg::new(SIZE, &chart.title, &chart.note);
    svg.text("t", [14.0, 24.0], "start", &chart.title);
    svg.text("s", [14.0, 43.0], "start", &chart.note);
    let cells: Vec<&[f64; 3]> = cells.iter().filter(|c| c.iter().all(|v| v.is_finite())).collect();
    let [across, up] = [0, 1].map(|i| cells.iter().map(|c| c[i]).collect::<Vec<f64>>());
    let (mut columns, mut rows) = (edges(across.clone(), MOST), edges(up.clone(), MOST));
    if columns.len() * rows.len() > MOST_CELLS {
        let side = MOST_CELLS.isqrt();
        rows = edges(up, side.max(MOST_CELLS / columns.len().max(1)));
        columns = edges(across, MOST_CELLS / rows.len().max(1));
    }
    let ends = |edges: &[f64]| (edges.first().copied().unwrap_or(0.0), edges.last().copied().unwrap_or(1.0));
    let xs = Scale::exact(ends(&columns).0, ends(&columns).1, [LEFT, RIGHT]);
    let ys = Scale::exact(ends(&rows).0, ends(&rows).1, [BOTTOM, TOP]);
    let is_two = value.limits.is_some();
    let shades = match value.limits {
        Some((low, high)) => Scale::exact(low, high, [0.0, STEPS as f64]),
        None => Scale::of(value, cells.iter().map(|c| c[2]), [0.0, STEPS as f64]),
    };
    let class = |v: f64| {
        let step = shades.at(v).clamp(0.0, STEPS as f64 - 1.0) as usize;
        format!("{}{step}", if is_two { "q" } else { "p" })
    };
    // A cell is as wide as half of the way to its neighbours; of several rows in one cell, the mean is shown.
    let place = |edges: &[f64], v: f64| edges.partition_point(|e| *e <= v).clamp(1, edges.len().max(2) - 1) - 1;
    let (wide, high) = (columns.len().saturating_sub(1), rows.len().saturating_sub(1));
    // Sums of abscissa, ordinate and value of the rows of each cell, and their number.
    let mut sums = vec![[0.0; 4]; wide * high];
    for [x, y, value] in cells {
        let sum = &mut sums[place(&rows, *y) * wide + place(&columns, *x)];
        [*x, *y, *value, 1.0].into_iter().zip(sum).for_each(|(own, sum)| *sum += own);
    }
    svg.axes = [x, y, value].map(Axis::clone).into();
    // Cells meet without seams.
    svg.push("<g shape-rendering=\"crispEdges\">");
    for (i, [x, y, value, count]) in sums.into_iter().enumerate().filter(|(_, sum)| sum[3] > 0.0) {
        let (mean, column, row) = (value / count, i % wide, i / wide);
        let (left, right) = (xs.at(columns[column]), xs.at(columns[column + 1]));
        let (low, top) = (ys.at(rows[row]), ys.at(rows[row + 1]));
        // Cells overlap by a hair, so that no ground shines through.
        let (width, height) = (right - left + 0.4, low - top + 0.4);
        svg.push(format!(
            "<path class=\"{}\" d=\"M{left:.1} {top:.1}h{width:.1}v{height:.1}h-{width:.1}z\"/>",
            class(mean)
        ));
        svg.mark([0.5 * (left + right), 0.5 * (low + top)], "", &[x / count, y / count, mean]);
    }
    svg.push("</g>");
    Frame { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM }.axes(&mut svg, (x, &xs), (y, &ys));
    bar(&mut svg, value, &shades, is_two);
    svg
}

/// Edges of cells about the distinct values; of too many values, of even cells.
fn edges(mut values: Vec<f64>, most: usize) -> Vec<f64> {
    values.sort_unstable_by(f64::total_cmp);
    let span = values.last().zip(values.first()).map_or(1.0, |(a, b)| a - b);
    values.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * span);
    let (Some(first), Some(last)) = (values.first().copied(), values.last().copied()) else { return Vec::new() };
    if values.len() > most {
        return (0..=most).map(|i| first + span * i as f64 / most as f64).collect();
    }
    let (head, tail) = match values[..] {
        [_, second, ..] => (second - first, last - values[values.len() - 2]),
        _ => (1.0, 1.0),
    };
    let between = values.windows(2).map(|w| 0.5 * (w[0] + w[1]));
    [first - 0.5 * head].into_iter().chain(between).chain([last + 0.5 * tail]).collect()
}

/// The scale of colours.
fn bar(svg: &mut Svg, value: &Axis, shades: &Scale, is_two: bool) {
    let step = (BOTTOM - TOP) / STEPS as f64;
    let kind = if is_two { "q" } else { "p" };
    for i in 0..STEPS {
        let top = BOTTOM - step * (i + 1) as f64;
        let (left, width) = (BAR[0], BAR[1] - BAR[0]);
        svg.push(format!(
            "<rect class=\"{kind}{i}\" x=\"{left}\" y=\"{top:.1}\" width=\"{width}\" height=\"{:.1}\"/>",
            step + 0.4
        ));
    }
    for (at, text) in shades.ticks(value, 6.0) {
        let y = BOTTOM - shades.at(at) * step;
        if (TOP - 1.0..=BOTTOM + 1.0).contains(&y) {
            svg.push(format!("<path class=\"a\" d=\"M{:.1} {y:.1}h4\"/>", BAR[1]));
            svg.text("n", [BAR[1] + 7.0, y + 4.0], "start", &text);
        }
    }
    svg.text("x", [SIZE[0] - 10.0, TOP - 12.0], "end", &value.label());
}
