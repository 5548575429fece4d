//! Animates the measured and the predicted shape.

use crate::output::plots::Judged;
use crate::output::thread::{goes_around, join, radius, thread};
use crate::process::{Animation, Body, Field, Frame, Grid, Observable, Places, Role, Rows, Skin, View};
use crate::units::{Kind, LENGTH, NUMBER};

/// Most rows of a frame that are marked, evenly chosen: more are not told apart on any screen.
const MOST_MARKS: usize = 2000;

/// Half of the size of a mark, in radii of a thread.
const MARK: f64 = 2.0;

/// Makes a frame for each value that rows have in common. Points are the measured rows, joined by a line in
/// the order of their places, which closes where they go all around; `measured`, `predicted` and `residual` are
/// values of the observable, and the vectors move the points by the measured and the predicted values. Behind them
/// stand the same points again, which `displacement` moves by the predicted values, and the first ones by the
/// measured.
pub fn shapes(observables: &[Observable], rows: &Rows, places: &Places, judged: &Judged) -> Animation {
    let mut order: Vec<usize> = (0..places.frames.len()).collect();
    let key = |row: &usize| (places.frames[*row], places.along[*row]);
    order.sort_by(|a, b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    let frames = order.chunk_by(|a, b| key(a).0 == key(b).0);
    // Rows of several observables are of several units, and have none together.
    let kinds = match rows.observable.first().filter(|first| rows.observable.iter().all(|o| o == *first)) {
        Some(one) => [observables[*one].error_kind(), observables[*one].kind],
        None => [NUMBER; 2],
    };
    let all: Vec<Frame> = frames.map(|rows| frame(rows, kinds, places, judged)).collect();
    Animation {
        name: "compared",
        shown: "residual",
        time: "number of what the rows have in common: the part, the run, the lap",
        view: View::Oblique,
        telling: 0,
        most_magnified: f64::INFINITY,
        frames: all.len(),
        frame: Box::new(move |i| all[i].clone()),
    }
}

/// The frame of rows that have one value in common, in the order of their places.
fn frame(all: &[usize], [error, kind]: [Kind; 2], places: &Places, judged: &Judged) -> Frame {
    let rows: Vec<usize> = all.iter().copied().step_by(all.len().div_ceil(MOST_MARKS)).collect();
    let at = places.frames[rows[0]];
    // Once for what was measured, once for what is predicted.
    let twice = || rows.iter().chain(&rows);
    let residual = |r: usize| judged.residuals[r];
    let predicted = |r: usize| judged.predicted[r];
    let measured = |r: usize| judged.measured[r];
    let scalar = |value: &dyn Fn(usize) -> f64| twice().map(|r| value(*r)).collect::<Vec<f64>>();
    let by = |value: f64, r: usize| places.directions[r].map(|d| d * (value - places.references[r]));
    let moved = |value: &dyn Fn(usize) -> f64| twice().map(|r| by(value(*r), *r)).collect::<Vec<[f64; 3]>>();
    let own = rows.iter().map(|r| by(measured(*r), *r)).chain(rows.iter().map(|r| by(predicted(*r), *r)));
    let mut grid = Grid { points: twice().map(|r| places.points[*r]).collect(), ..Grid::default() };
    let count = rows.len() as u32;
    let is_closed = goes_around(&rows.iter().map(|r| places.directions[*r]).collect::<Vec<_>>());
    join(&mut grid, count, is_closed);
    let bodies = bodies(&grid.points[..rows.len()], is_closed);
    grid.point_fields = vec![
        Field::scalar("residual", error, scalar(&residual)),
        Field::scalar("measured", kind, scalar(&measured)),
        Field::scalar("predicted", kind, scalar(&predicted)),
        Field::vector("displacement", LENGTH, own.collect()),
        Field::vector("measured_displacement", LENGTH, moved(&measured)),
        Field::vector("predicted_displacement", LENGTH, moved(&predicted)),
    ];
    let counted =
        if rows.len() < all.len() { format!("{count} of {} rows", all.len()) } else { format!("{count} rows") };
    Frame { time: at, caption: format!("set {at}: {counted}"), grid, bodies, arrows: Vec::new() }
}

/// A mark for every measured row, and a thread through what is predicted of them.
fn bodies(points: &[[f64; 3]], is_closed: bool) -> Vec<Body> {
    let half = MARK * radius(points);
    let count = points.len() as u32;
    let marks = (0..count).fold(Skin::default(), |all, i| all.and(&Skin::block(Some(i), [0.0; 3], [half; 3])));
    let mut bodies = vec![Body::thickened("measured", marks)];
    if count > 1 {
        let thread = Body::new("predicted", Role::Nominal, thread(points, count, is_closed));
        bodies.push(Body { is_computed: true, ..thread });
    }
    bodies
}
