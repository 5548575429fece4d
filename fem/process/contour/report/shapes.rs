//! The contour in the plane: for ParaView and for drawings.

use super::super::forward::Lap;
use super::super::machine::Machine;
use super::super::path::{Direction, Point};
use super::super::rows;
use super::super::setup::Setup;
use crate::process::{Animation, Cell, Curve, Drawing, Field, Frame, Grid, Spot};
use crate::units::FEED_RATE;

/// The points of each direction with their deviations (m), side by side.
fn laps<'a>(setup: &'a Setup, deviations: &'a [f64]) -> Vec<(Direction, Vec<(Point, f64)>)> {
    let mut rest = deviations;
    let of = |direction: &Direction| {
        let angles = rows::angles(setup, *direction);
        let (own, more) = rest.split_at(angles.len().min(rest.len()));
        rest = more;
        let points = angles.iter().map(|a| setup.path.at(*a));
        (*direction, points.zip(own.iter().copied()).collect())
    };
    setup.directions.iter().map(of).collect()
}

/// Lines through points that follow each other: a circle closes, sides stand apart.
fn pieces<T: Copy>(points: &[(Point, T)]) -> Vec<Vec<(Point, T)>> {
    let sides = 1 + points.iter().map(|p| p.0.side).max().unwrap_or(0);
    if sides == 1 {
        return vec![points.iter().chain(points.first()).copied().collect()];
    }
    let mut pieces = vec![Vec::new(); sides];
    points.iter().for_each(|p| pieces[p.0.side].push(*p));
    for piece in &mut pieces {
        piece.sort_by(|a, b| a.0.travelled.total_cmp(&b.0.travelled));
    }
    pieces
}

/// The contour in every direction, deviations magnified.
pub fn drawing(setup: &Setup, deviations: &[f64]) -> Drawing {
    let spot = |(point, deviation): &(Point, f64)| Spot { at: point.at, outward: point.outward, deviation: *deviation };
    let curve = |(family, (direction, points)): (usize, (Direction, Vec<(Point, f64)>))| Curve {
        label: format!("predicted, {}", direction.word()),
        family,
        is_measured: false,
        pieces: pieces(&points).iter().map(|piece| piece.iter().map(spot).collect()).collect(),
    };
    Drawing {
        name: "contour",
        title: format!("{}, {}", setup.path.words(), FEED_RATE.told(setup.feed)),
        nominal: setup.path.drawn(),
        curves: laps(setup, deviations).into_iter().enumerate().map(curve).collect(),
    }
}

/// A frame for each direction. Points are those of the path; `displacement` is the deviation outwards,
/// `following_error` where the tool is when the point is commanded, the lag along the path included.
pub fn animation(machine: &Machine, deviations: &[f64]) -> Animation {
    let setup = &machine.setup;
    let frame = |(i, (direction, points)): (usize, (Direction, Vec<(Point, f64)>))| {
        let lap = Lap::new(machine, direction, setup.feed);
        let mut grid = Grid::default();
        let (mut off, mut out, mut behind) = (Vec::new(), Vec::new(), Vec::new());
        for piece in pieces(&points) {
            for (j, (point, deviation)) in piece.iter().enumerate() {
                let here = grid.points.len() as u32;
                if j > 0 {
                    grid.push(Cell::Line, &[here - 1, here]);
                }
                let tool = lap.position(lap.time(point)).0;
                grid.points.push([point.at[0], point.at[1], 0.0]);
                off.push(*deviation);
                out.push([deviation * point.outward[0], deviation * point.outward[1], 0.0]);
                behind.push([tool[0] - point.at[0], tool[1] - point.at[1], 0.0]);
            }
        }
        grid.point_fields = vec![
            Field::scalar("deviation", off),
            Field::vector("displacement", out),
            Field::vector("following_error", behind),
        ];
        Frame { time: i as f64, grid }
    };
    let frames: Vec<Frame> = laps(setup, deviations).into_iter().enumerate().map(frame).collect();
    Animation { name: "path", frames: frames.len(), frame: Box::new(move |i| frames[i].clone()) }
}
