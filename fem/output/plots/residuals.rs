//! Charts of residuals: along every coordinate, and as maps over pairs.

use super::layout::Layout;
use super::measured::{Judged, Rows, dots, thinned};
use crate::output::chart::{Axis, Chart, Form, Plane, Point, Series};

/// Most levels of a coordinate at which the mean of the rows is drawn.
const MOST_MEANS: usize = 60;
/// Most maps.
const MOST_MAPS: usize = 6;

/// Residuals along every coordinate that varies, with the band of the noise; `limits` are the ends of the ordinate in
/// SI, where several figures are to have the same.
pub fn along(rows: &Rows, judged: &Judged, limits: Option<f64>) -> Vec<Chart> {
    let mut charts = Vec::new();
    for layout in &rows.layouts {
        let (factor, unit) = rows.unit(layout);
        for variable in &layout.variables {
            let residual = |at: usize| factor * judged.residuals[layout.rows[at]];
            let dots = dots(layout, variable, &residual);
            let means = means(&variable.levels, &variable.values, &residual);
            let sigma = layout.rows.iter().map(|row| judged.noise.sigma[*row].powi(2)).sum::<f64>();
            let sigma = factor * (sigma / layout.rows.len().max(1) as f64).sqrt();
            let ends = [variable.levels.first(), variable.levels.last()].into_iter().flatten();
            let band: Vec<Point> = ends.map(|x| Point { x: *x, y: 0.0, u: 2.0 * sigma }).collect();
            let name = &variable.axis.name;
            charts.push(Chart {
                name: format!("residual-{}{}", name.replace(' ', "-"), layout.end),
                title: format!("residual over {name}"),
                note: format!(
                    "measured less predicted; band: \u{b1} 2 standard uncertainties; line: mean of the rows there{}",
                    thinned(layout.rows.len())
                ),
                plane: Plane::Curves {
                    x: variable.axis.clone(),
                    y: Axis { limits: limits.map(|l| (-factor * l, factor * l)), ..Axis::new("residual", unit) },
                    series: vec![
                        Series::new("", 2, Form::Band, band),
                        Series::new("", 0, Form::Dots, dots),
                        Series::new("", 1, Form::Line, means),
                    ],
                },
            });
        }
    }
    charts
}

/// Mean residual at every level, where there are not too many of them and more rows than levels.
fn means(levels: &[f64], values: &[f64], residual: &dyn Fn(usize) -> f64) -> Vec<Point> {
    if levels.len() > MOST_MEANS || levels.len() >= values.len() {
        return Vec::new();
    }
    let mean = |level: &f64| {
        let size = 1e-9 * level.abs().max(1e-300);
        let own: Vec<f64> = (0..values.len()).filter(|i| (values[*i] - level).abs() <= size).map(residual).collect();
        Point::new(*level, own.iter().sum::<f64>() / own.len() as f64)
    };
    levels.iter().map(mean).filter(|p| p.y.is_finite()).collect()
}

/// Residuals over pairs of coordinates; `limits` as in [`along`].
pub fn maps(rows: &Rows, judged: &Judged, limits: Option<f64>) -> Vec<Chart> {
    let mut charts = Vec::new();
    for layout in &rows.layouts {
        let (factor, unit) = rows.unit(layout);
        let limits = limits.map(|limit| factor * limit);
        let residual = |at: usize| factor * judged.residuals[layout.rows[at]];
        let pairs = layout.pairs().into_iter().take(MOST_MAPS);
        charts.extend(pairs.map(|pair| map(layout, pair, &residual, &unit, limits)));
    }
    charts
}

fn map(
    layout: &Layout,
    (a, b): (usize, usize),
    residual: &dyn Fn(usize) -> f64,
    unit: &str,
    limits: Option<f64>,
) -> Chart {
    let (x, y) = (&layout.variables[a], &layout.variables[b]);
    let cells: Vec<[f64; 3]> = (0..layout.rows.len()).map(|at| [x.values[at], y.values[at], residual(at)]).collect();
    let own = cells.iter().map(|c| c[2].abs()).fold(0.0, f64::max);
    let most = limits.unwrap_or(own).max(1e-12);
    let value = Axis { limits: Some((-most, most)), ..Axis::new("residual", unit) };
    let (first, second) = (&x.axis.name, &y.axis.name);
    let pair = format!("{first}-{second}").replace(' ', "-");
    Chart {
        name: format!("residual-map-{pair}{}", layout.end),
        title: format!("residual over {first} and {second}"),
        note: "measured less predicted: blue is smaller than predicted, orange larger".into(),
        plane: Plane::Map { x: x.axis.clone(), y: y.axis.clone(), value, cells },
    }
}
