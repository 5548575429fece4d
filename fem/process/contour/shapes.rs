//! The contour in the plane: for ParaView, for drawings, and for measured rows.

use super::job::Contouring;
use super::machine::Lap;
use super::model::Setup;
use super::observe;
use super::path::{Direction, Point, rounded};
use crate::process::{Animation, Cell, Curve, Drawing, Field, Frame, Grid, Places, Rows, Spot};
use crate::units::FEED_RATE;

/// The points of each direction with their deviations (m), side by side.
fn laps<'a>(setup: &'a Setup, deviations: &'a [f64]) -> Vec<(Direction, Vec<(Point, f64)>)> {
    let mut rest = deviations;
    let of = |direction: &Direction| {
        let angles = observe::angles(setup, *direction);
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
pub fn drawing(contouring: &Contouring, deviations: &[f64]) -> Drawing {
    let setup = contouring.setup();
    let spot = |(point, deviation): &(Point, f64)| Spot { at: point.at, outward: point.outward, deviation: *deviation };
    let curve = |(family, (direction, points)): (usize, (Direction, Vec<(Point, f64)>))| Curve {
        label: format!("predicted, {}", direction.word()),
        family,
        is_measured: false,
        pieces: pieces(&points).iter().map(|piece| piece.iter().map(spot).collect()).collect(),
    };
    Drawing {
        name: "contour",
        title: format!("{}, {} mm/min", setup.path.words(), rounded(FEED_RATE.from_si(setup.feed))),
        nominal: setup.path.drawn(),
        curves: laps(setup, deviations).into_iter().enumerate().map(curve).collect(),
    }
}

/// A frame for each direction. Points are those of the path; `displacement` is the deviation outwards, `following_error` where the tool is when the point
/// is commanded, the lag along the path included.
pub fn animation(contouring: &Contouring, deviations: &[f64]) -> Animation {
    let setup = contouring.setup();
    let frame = |(i, (direction, points)): (usize, (Direction, Vec<(Point, f64)>))| {
        let lap = Lap::new(&contouring.machine, direction, setup.feed);
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

/// On the path, lap by lap; a deviation is outwards.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let mut ways: Vec<(Direction, f64)> = Vec::new();
    let mut places = Places { references: vec![0.0; rows.len()], ..Places::default() };
    for row in 0..rows.len() {
        let way = observe::way(setup, rows, row);
        let frame = ways.iter().position(|w| *w == way).unwrap_or_else(|| {
            ways.push(way);
            ways.len() - 1
        });
        let point = setup.path.at(rows.get(observe::ANGLE_OF_ROW, row).unwrap_or(0.0));
        places.points.push([point.at[0], point.at[1], 0.0]);
        places.directions.push([point.outward[0], point.outward[1], 0.0]);
        places.along.push(point.travelled);
        places.frames.push(frame as f64);
    }
    places
}
