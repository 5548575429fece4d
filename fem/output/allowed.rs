//! The prediction as a shape in ParaView, with what a drawing allows of it and how far it may be off.

use super::thread::{goes_around, join, thread};
use crate::knowledge::Band;
use crate::model::{Model, Run};
use crate::process::{Animation, Body, Field, Frame, Grid, Places, View};
use crate::tolerance::Limits;
use crate::units::{Kind, LENGTH};

/// Most rows of a frame, evenly chosen: more are not told apart on any screen.
const MOST_ROWS: usize = 2000;

/// A frame for each value that rows of the programme have in common, a part or a direction: the line of its rows, moved by the
/// error, with `beyond_limits`, how far it lies beyond them, `predicted`, `band`, half of what holds it with 95 %, and the limits.
/// `None` where the drawing asks nothing of rows, or there is no shape to show.
pub fn animation(model: &Model, run: &Run, band: Option<&Band>) -> Option<Animation> {
    let rows = model.system.programme();
    let limits = model.system.limits(&rows);
    if limits.iter().all(Option::is_none) {
        return None;
    }
    let places = model.system.places(&rows)?;
    // Rows of several observables are of several units, and have none together.
    let first = *rows.observable.first()?;
    if !rows.observable.iter().all(|own| *own == first) {
        return None;
    }
    let observable = &model.process.observables()[first];
    let half = |row: usize| band.map(|band| 0.5 * (band.interval[row][1] - band.interval[row][0]));
    let row = |row: usize| Shown { value: run.prediction[row], limits: limits[row], half: half(row) };
    let all: Vec<Shown> = (0..rows.len()).map(row).collect();
    let mut order: Vec<usize> = (0..rows.len()).collect();
    let key = |row: &usize| (places.frames[*row], places.along[*row]);
    order.sort_by(|a, b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    let frames: Vec<Vec<usize>> = order.chunk_by(|a, b| key(a).0 == key(b).0).map(<[usize]>::to_vec).collect();
    let kinds = [observable.error_kind(), observable.kind];
    Some(Animation {
        name: "allowed",
        shown: "beyond_limits",
        time: "number of what the rows have in common: the part, the run, the lap",
        view: View::Oblique,
        telling: 0,
        most_magnified: f64::INFINITY,
        frames: frames.len(),
        frame: Box::new(move |i| frame(&frames[i], kinds, &places, &all)),
    })
}

/// A row as it is shown, SI.
#[derive(Clone, Copy)]
struct Shown {
    value: f64,
    limits: Option<Limits>,
    half: Option<f64>,
}

impl Shown {
    /// How far it lies beyond its limits, positive above them.
    fn beyond(&self) -> f64 {
        let Some(limits) = self.limits else { return 0.0 };
        (self.value - limits.upper).max(0.0) - (limits.lower - self.value).max(0.0)
    }
}

fn frame(own: &[usize], [error, kind]: [Kind; 2], places: &Places, all: &[Shown]) -> Frame {
    let rows: Vec<usize> = own.iter().copied().step_by(own.len().div_ceil(MOST_ROWS)).collect();
    let mut grid = Grid { points: rows.iter().map(|row| places.points[*row]).collect(), ..Grid::default() };
    let is_closed = goes_around(&rows.iter().map(|row| places.directions[*row]).collect::<Vec<_>>());
    let count = rows.len() as u32;
    join(&mut grid, count, is_closed);
    let scalar = |value: &dyn Fn(&Shown) -> Option<f64>| -> Option<Vec<f64>> {
        rows.iter().map(|row| value(&all[*row])).collect()
    };
    let moved = |row: &usize| places.directions[*row].map(|d| d * (all[*row].value - places.references[*row]));
    let told = [
        ("beyond_limits", error, scalar(&|own| own.limits.map(|_| own.beyond()))),
        ("band", error, scalar(&|own| own.half)),
        ("predicted", kind, scalar(&|own| Some(own.value))),
        ("lower_limit", kind, scalar(&|own| Some(own.limits?.lower).filter(|own| own.is_finite()))),
        ("upper_limit", kind, scalar(&|own| Some(own.limits?.upper).filter(|own| own.is_finite()))),
    ];
    let scalars = told.into_iter().filter_map(|(name, kind, values)| Some(Field::scalar(name, kind, values?)));
    let moved = Field::vector("displacement", LENGTH, rows.iter().map(moved).collect());
    grid.point_fields = scalars.chain([moved]).collect();
    let bodies = match rows.len() {
        0 | 1 => Vec::new(),
        _ => vec![Body::thickened("predicted", thread(&grid.points, 0, is_closed))],
    };
    let at = rows.first().map_or(0.0, |row| places.frames[*row]);
    Frame { time: at, caption: format!("set {at}: {count} rows"), grid, bodies, arrows: Vec::new() }
}
