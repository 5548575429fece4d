//! A line through places of rows, as a body that people see.

use crate::process::{Cell, Ends, Grid, Skin};

/// Radius of a thread, as a part of the size of the shape.
const RADIUS: f64 = 0.003;

/// Smallest cosine between the outward directions of rows that belong to one line.
pub const BENT: f64 = 0.8;

/// Whether places in their order, by their outward directions, go all around, and not only there and back again.
pub fn goes_around<const N: usize>(outward: &[[f64; N]]) -> bool {
    let [first, .., last] = outward else { return false };
    let near = |a: &[f64; N], b: &[f64; N]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() > BENT;
    outward.len() > 8 && near(first, last) && !near(first, &outward[outward.len() / 2])
}

/// Joins the first `count` points of a grid by lines, the last with the first where they go around.
pub fn join(grid: &mut Grid, count: u32, is_closed: bool) {
    for i in 0..count {
        grid.push(Cell::Vertex, &[i]);
        if i > 0 {
            grid.push(Cell::Line, &[i - 1, i]);
        }
    }
    if is_closed {
        grid.push(Cell::Line, &[count - 1, 0]);
    }
}

/// The radius of a thread through some points, m.
pub fn radius(points: &[[f64; 3]]) -> f64 {
    let extent = |c: usize| {
        let [low, high] = [f64::min, f64::max].map(|pick| points.iter().map(|p| p[c]).reduce(pick).unwrap_or(0.0));
        high - low
    };
    RADIUS * extent(0).max(extent(1)).max(extent(2)).max(1e-6)
}

/// A thread through points that are those of a grid from `first` on.
pub fn thread(points: &[[f64; 3]], first: u32, is_closed: bool) -> Skin {
    let next = |i: usize| points[(i + 1) % points.len()];
    let ring = |i: usize| {
        // Across the way to the next point, the last of an open line that it came.
        let (a, b) = if i + 1 < points.len() || is_closed { (points[i], next(i)) } else { (points[i - 1], points[i]) };
        Skin::ring(Some(first + i as u32), [0, 1, 2].map(|c| b[c] - a[c]), radius(points))
    };
    let rings: Vec<_> = (0..points.len()).map(ring).collect();
    Skin::lofted(&rings, if is_closed { Ends::Joined } else { Ends::Capped })
}
