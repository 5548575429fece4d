//! Charts of measured rows beside what a model says of them.

use super::layout::Layout;
use super::positioning;
use crate::measure::Measurements;
use crate::model::Model;
use crate::noise::Noise;
use crate::output::chart::{Axis, Chart, Form, Plane, Point, Series};
use crate::units::UnitSymbol;

/// Most points of a chart: more cannot be told apart, and make a page heavy.
const MOST: usize = 800;

/// Measured rows with what a model predicts of them, SI.
pub struct Rows<'a> {
    /// The model.
    pub model: &'a Model,
    /// The rows.
    pub measurements: &'a Measurements,
    /// Prediction of each.
    pub predicted: &'a [f64],
    /// Measured less predicted.
    pub residuals: &'a [f64],
    /// Noise by which the rows are judged.
    pub noise: &'a Noise,
}

impl Rows<'_> {
    /// Layouts of the observables of the file, each with its name as the end of a file's name.
    pub fn layouts(&self) -> Vec<(String, Layout)> {
        let rows = self.model.system.resolved(&self.measurements.rows);
        let several = self.measurements.observables.len() > 1;
        let one = |seen: &crate::measure::MeasuredObservable| {
            let layout = Layout::of(&*self.model.process, &rows, &self.measurements.given, seen.position)?;
            Some((if several { format!("-{}", seen.name) } else { String::new() }, layout))
        };
        self.measurements.observables.iter().filter_map(one).collect()
    }

    /// Factor from SI to the unit in which differences of an observable are told, and that unit.
    pub fn unit(&self, layout: &Layout) -> (f64, UnitSymbol) {
        let position = layout.rows.first().map_or(0, |row| self.measurements.rows.observable[*row]);
        let kind = self.model.process.observables()[position].error_kind();
        (1.0 / kind.canonical().factor, kind.unit)
    }

    /// Value of a row in the unit of its observable.
    fn in_unit(&self, row: usize, si: f64) -> f64 {
        self.model.process.observables()[self.measurements.rows.observable[row]].kind.from_si(si)
    }

    /// Twice the standard uncertainty of a row, in the unit of its observable.
    pub fn bar(&self, row: usize) -> f64 {
        let kind = self.model.process.observables()[self.measurements.rows.observable[row]].kind;
        2.0 * self.noise.sigma[row] / kind.canonical().factor
    }

    /// Measured value of a row without datum directions, in the unit of its observable.
    fn measured(&self, row: usize) -> f64 {
        self.in_unit(row, self.predicted[row] + self.residuals[row])
    }
}

/// Every so many of these rows are drawn.
pub fn every(rows: usize) -> usize {
    rows.div_ceil(MOST).max(1)
}

/// Tells that not all rows are drawn.
pub fn thinned(rows: usize) -> String {
    let every = every(rows);
    if every > 1 { format!("; one row in {every} is drawn") } else { String::new() }
}

/// Measured rows as dots with bars, and predicted ones as lines.
pub fn measured(rows: &Rows) -> Vec<Chart> {
    let mut charts = Vec::new();
    if let Some(test) = rows.model.system.positioning() {
        let readings: Vec<f64> = rows.predicted.iter().zip(rows.residuals).map(|(p, r)| p + r).collect();
        let approaches = test.approaches(&rows.measurements.rows);
        charts.push(positioning::chart(&approaches, &readings, "measured", Some(rows.predicted)));
    }
    for (of, layout) in rows.layouts() {
        let value = |at: usize| rows.measured(layout.rows[at]);
        let foretold = |at: usize| rows.in_unit(layout.rows[at], rows.predicted[layout.rows[at]]);
        let bar = |at: usize| rows.bar(layout.rows[at]);
        let none = |_| f64::NAN;
        let chosen = layout.chosen();
        let shown = layout.rows.len() / layout.labels.len().max(1) * chosen.len();
        let step = every(shown);
        let thin = |points: Vec<Point>| points.into_iter().step_by(step).collect::<Vec<_>>();
        let mut series = Vec::new();
        for (colour, group) in chosen.iter().copied().enumerate() {
            let one = |label: String, form, points| Series { label, colour, form, points };
            let name = &layout.labels[group];
            let label = if name.is_empty() { "predicted".to_string() } else { name.clone() };
            series.push(one(label, Form::Line, thin(layout.points(group, &foretold, &none))));
            series.push(one(String::new(), Form::Dots, thin(layout.points(group, &value, &bar))));
        }
        let sets = match layout.labels.len() {
            all if all > chosen.len() => format!("{} of {all} sets; ", chosen.len()),
            _ => String::new(),
        };
        let name = format!("{}{of}", if layout.is_loop() { "measured-loop" } else { "measured" });
        let (x, y) = layout.axes();
        let title = format!("measured and predicted {}", layout.value.name);
        let some = thinned(shown);
        let note = format!("{sets}dots: measured, bars: \u{b1} 2 standard uncertainties; lines: predicted{some}");
        if layout.is_around() {
            let (note, y) =
                (format!("dots: measured; lines: predicted; outwards is positive, magnified{some}"), y.clone());
            let plane = Plane::Polar { y, series: series.clone() };
            charts.push(Chart { name: format!("measured-polar{of}"), title: title.clone() + " around", note, plane });
        }
        charts.push(Chart { name, title, note, plane: Plane::Curves { x, y, series } });
    }
    charts
}

/// Measured over predicted values: a perfect model puts every row on the straight line.
pub fn agreement(rows: &Rows) -> Vec<Chart> {
    let chart = |(of, layout): (String, Layout)| {
        let step = every(layout.rows.len());
        let point = |row: &usize| Point {
            x: rows.in_unit(*row, rows.predicted[*row]),
            y: rows.measured(*row),
            u: rows.bar(*row),
        };
        let points: Vec<Point> = layout.rows.iter().step_by(step).map(point).collect();
        let ends = points.iter().flat_map(|p| [p.x, p.y]).filter(|v| v.is_finite());
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let straight = vec![Point::new(low, low), Point::new(high, high)];
        let (name, unit) = (&layout.value.name, &layout.value.unit);
        let series = |label: &str, colour, form, points| Series { label: label.into(), colour, form, points };
        Chart {
            name: format!("agreement{of}"),
            title: format!("measured over predicted {name}"),
            note: format!(
                "a perfect model puts every row on the line; bars: \u{b1} 2 standard uncertainties{}",
                thinned(layout.rows.len())
            ),
            plane: Plane::Curves {
                x: Axis::new(format!("predicted {name}"), unit.clone()),
                y: Axis::new(format!("measured {name}"), unit.clone()),
                series: vec![series("equal", 5, Form::Line, straight), series("", 0, Form::Dots, points)],
            },
        }
    };
    rows.layouts().into_iter().map(chart).collect()
}
