//! Charts of measured rows beside what a model says of them.

use super::layout::{Layout, Variable};
use super::positioning;
use crate::measure::Measurements;
use crate::model::Model;
use crate::noise::Noise;
use crate::output::chart::{Axis, Chart, Form, Plane, Point, Series};
use crate::process;
use crate::units::{Kind, UnitSymbol};

/// Most points of a chart: more cannot be told apart, and make a page heavy.
const MOST: usize = 800;

/// Measured rows, laid out once for all figures of them.
pub struct Rows<'a> {
    /// The model that says where they lie.
    pub model: &'a Model,
    /// The rows.
    pub measurements: &'a Measurements,
    /// The rows with what they leave to the model.
    pub resolved: process::Rows,
    /// The rows of each observable that was measured.
    pub layouts: Vec<Layout>,
    /// The value of each row from which it is shown, SI: the set diameter. None where all are shown as they are.
    references: Option<Vec<f64>>,
}

/// Measured values of rows, and what a model says of them, SI.
pub struct Judged<'a> {
    /// Measured value of each row without datum directions.
    pub measured: &'a [f64],
    /// Prediction of each.
    pub predicted: &'a [f64],
    /// Measured less predicted.
    pub residuals: &'a [f64],
    /// Noise by which the rows are judged.
    pub noise: &'a Noise,
}

impl<'a> Rows<'a> {
    /// Lays the rows out.
    pub fn of(model: &'a Model, measurements: &'a Measurements) -> Self {
        let resolved = model.system.resolved(&measurements.rows);
        let seen: Vec<usize> = measurements.observables.iter().map(|seen| seen.position).collect();
        let mut layouts = Layout::each(&*model.process, &resolved, &measurements.given, &seen);
        let references = model.system.references(&resolved);
        // Errors of micrometres are not seen on sizes of many millimetres.
        for layout in &mut layouts {
            if is_referred(references.as_deref(), layout) {
                let observable = &model.process.observables()[layout.observable];
                let name = format!("{} less nominal", observable.name.replace('_', " "));
                layout.value = Axis::new(name, observable.error_kind().unit);
            }
        }
        Self { model, measurements, resolved, layouts, references }
    }

    /// Kind in which the observable of a layout is shown.
    fn kind(&self, layout: &Layout) -> Kind {
        let observable = &self.model.process.observables()[layout.observable];
        if is_referred(self.references.as_deref(), layout) { observable.error_kind() } else { observable.kind }
    }

    /// A value of a row as it is shown, SI.
    fn shown(&self, row: usize, value: f64) -> f64 {
        value - self.references.as_ref().map_or(0.0, |all| all[row])
    }

    /// Factor from SI to the unit in which differences of an observable are told, and that unit.
    pub fn unit(&self, layout: &Layout) -> (f64, UnitSymbol) {
        let kind = self.model.process.observables()[layout.observable].error_kind();
        (1.0 / kind.canonical().factor, kind.unit)
    }
}

fn is_referred(references: Option<&[f64]>, layout: &Layout) -> bool {
    references.is_some_and(|all| layout.rows.iter().any(|row| all[*row] != 0.0))
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

/// Rows as dots over one of their variables, by their values at their places in the layout; not more than can be told apart.
pub fn dots(layout: &Layout, variable: &Variable, value: &dyn Fn(usize) -> f64) -> Vec<Point> {
    let rows = layout.rows.len();
    (0..rows).step_by(every(rows)).map(|at| Point::new(variable.values[at], value(at))).collect()
}

/// Measured rows as dots with bars, and predicted ones as lines.
pub fn measured(rows: &Rows, judged: &Judged) -> Vec<Chart> {
    let mut charts = Vec::new();
    if let Some(test) = rows.model.system.positioning() {
        let of = (test, &rows.measurements.rows);
        charts.push(positioning::chart(of, judged.measured, "measured", Some(judged.predicted)));
    }
    for layout in &rows.layouts {
        let kind = rows.kind(layout);
        let shown = |row: usize, value: f64| kind.from_si(rows.shown(row, value));
        let value = |at: usize| shown(layout.rows[at], judged.measured[layout.rows[at]]);
        let foretold = |at: usize| shown(layout.rows[at], judged.predicted[layout.rows[at]]);
        let bar = |at: usize| bar(judged, kind, layout.rows[at]);
        let none = |_| f64::NAN;
        let chosen = layout.chosen();
        let shown = layout.rows.len() / layout.labels.len().max(1) * chosen.len();
        let step = every(shown);
        let thin = |points: Vec<Point>| points.into_iter().step_by(step).collect::<Vec<_>>();
        let mut series = Vec::new();
        for (colour, group) in chosen.iter().copied().enumerate() {
            let name = &layout.labels[group];
            let label = if name.is_empty() { "predicted" } else { name };
            series.push(Series::new(label, colour, Form::Line, thin(layout.points(group, &foretold, &none))));
            series.push(Series::new("", colour, Form::Dots, thin(layout.points(group, &value, &bar))));
        }
        let sets = match layout.labels.len() {
            all if all > chosen.len() => format!("{} of {all} sets; ", chosen.len()),
            _ => String::new(),
        };
        let (end, some) = (&layout.end, thinned(shown));
        let name = format!("{}{end}", if layout.is_loop() { "measured-loop" } else { "measured" });
        let (x, y) = layout.axes();
        let title = format!("measured and predicted {}", layout.value.name);
        let note = format!("{sets}dots: measured, bars: \u{b1} 2 standard uncertainties; lines: predicted{some}");
        if layout.is_around() {
            let note = format!("dots: measured; lines: predicted; outwards is positive, magnified{some}");
            let plane = Plane::Polar { y: y.clone(), series: series.clone() };
            charts.push(Chart { name: format!("measured-polar{end}"), title: title.clone() + " around", note, plane });
        }
        charts.push(Chart { name, title, note, plane: Plane::Curves { x, y, series } });
    }
    charts
}

/// Twice the standard uncertainty of a row, in the unit of its observable.
fn bar(judged: &Judged, kind: Kind, row: usize) -> f64 {
    2.0 * judged.noise.sigma[row] / kind.canonical().factor
}

/// Measured over predicted values: a perfect model puts every row on the straight line.
pub fn agreement(rows: &Rows, judged: &Judged) -> Vec<Chart> {
    let chart = |layout: &Layout| {
        let kind = rows.kind(layout);
        let point = |row: &usize| Point {
            x: kind.from_si(rows.shown(*row, judged.predicted[*row])),
            y: kind.from_si(rows.shown(*row, judged.measured[*row])),
            u: bar(judged, kind, *row),
        };
        let points: Vec<Point> = layout.rows.iter().step_by(every(layout.rows.len())).map(point).collect();
        let ends = points.iter().flat_map(|p| [p.x, p.y]).filter(|v| v.is_finite());
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let straight = vec![Point::new(low, low), Point::new(high, high)];
        let (name, unit) = (&layout.value.name, &layout.value.unit);
        Chart {
            name: format!("agreement{}", layout.end),
            title: format!("measured over predicted {name}"),
            note: format!(
                "a perfect model puts every row on the line; bars: \u{b1} 2 standard uncertainties{}",
                thinned(layout.rows.len())
            ),
            plane: Plane::Curves {
                x: Axis::new(format!("predicted {name}"), unit.clone()),
                y: Axis::new(format!("measured {name}"), unit.clone()),
                series: vec![Series::new("equal", 5, Form::Line, straight), Series::new("", 0, Form::Dots, points)],
            },
        }
    };
    rows.layouts.iter().map(chart).collect()
}
