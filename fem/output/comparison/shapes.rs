//! Animates the measured and the predicted shape.

use crate::compare::Comparison;
use crate::process::{Animation, Cell, Field, Frame, Grid, Places};

/// Makes a frame for each value that rows have in common. Points are the measured rows, joined by a line in
/// the order of their places; `measured`, `predicted` and `residual` are values of the observable, and the
/// vectors move the points by the measured and the predicted values.
pub fn shapes(places: &Places, comparison: &Comparison) -> Animation {
    let mut frames: Vec<f64> = places.frames.clone();
    frames.sort_unstable_by(f64::total_cmp);
    frames.dedup();
    let all: Vec<Frame> = frames.iter().map(|at| frame(*at, places, comparison)).collect();
    Animation { name: "compared", frames: all.len(), frame: Box::new(move |i| all[i].clone()) }
}

fn frame(at: f64, places: &Places, comparison: &Comparison) -> Frame {
    let mut rows: Vec<usize> = (0..places.frames.len()).filter(|r| places.frames[*r] == at).collect();
    rows.sort_by(|a, b| places.along[*a].total_cmp(&places.along[*b]));
    let scalar = |values: &[f64]| rows.iter().map(|r| values[*r]).collect::<Vec<f64>>();
    let moved = |values: &[f64]| {
        let by = |r: &usize| places.directions[*r].map(|d| d * (values[*r] - places.references[*r]));
        rows.iter().map(by).collect::<Vec<[f64; 3]>>()
    };
    // Measured values as they were compared, without datum directions.
    let measured: Vec<f64> = comparison.predicted.iter().zip(&comparison.residuals).map(|(p, r)| p + r).collect();
    let mut grid = Grid { points: rows.iter().map(|r| places.points[*r]).collect(), ..Grid::default() };
    for i in 0..rows.len() as u32 {
        grid.push(Cell::Vertex, &[i]);
        if i > 0 {
            grid.push(Cell::Line, &[i - 1, i]);
        }
    }
    grid.point_fields = vec![
        Field::scalar("residual", scalar(&comparison.residuals)),
        Field::scalar("measured", scalar(&measured)),
        Field::scalar("predicted", scalar(&comparison.predicted)),
        Field::vector("measured_displacement", moved(&measured)),
        Field::vector("predicted_displacement", moved(&comparison.predicted)),
    ];
    Frame { time: at, grid }
}
