//! The screw and its nut in space, target by target of a run.

use super::super::machine::Machine;
use super::super::rows::approach;
use super::super::setup::Setup;
use crate::positioning::Direction;
use crate::process::{Animation, Cell, Field, Forward, Frame, Grid};

/// Elements of the screw that is shown.
const ELEMENTS: usize = 100;
/// Frames, at most.
const MOST_FRAMES: usize = 400;

/// The first run, there and back; time is the number of the frame.
///
/// Points are the nodes of the screw on its axis (x, 0, 0), then the nut as commanded. `displacement` is
/// along the axis: the screw's stretch under the friction of the slide, and the predicted deviation of the
/// nut. `force` is what the slide's friction does to them.
pub fn animation(machine: &Machine, forward: &Forward) -> Animation {
    let setup = machine.setup.clone();
    let approaches = 2 * setup.test.positions;
    let count = approaches.min(MOST_FRAMES);
    let friction = machine.lost.map_or(0.0, |l| l.friction);
    let stop = |i: usize| {
        let row = i * approaches / count;
        let at = approach(forward.programme, row);
        let force = if at.direction == Direction::Forward { -friction } else { friction };
        (at.position, force, forward.prediction[row])
    };
    let stops: Vec<_> = (0..count).map(stop).collect();
    let frame = move |i: usize| Frame { time: i as f64, grid: grid(&setup, stops[i]) };
    Animation { name: "axis", frames: count, frame: Box::new(frame) }
}

/// The screw with its nut at a position (m), under a force (N), with a deviation (m).
fn grid(setup: &Setup, (nut, force, deviation): (f64, f64, f64)) -> Grid {
    let screw = setup.screw();
    let ends = screw.held.iter().copied().chain([setup.from, setup.from + setup.travel, nut]);
    let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let mut nodes: Vec<f64> = screw.held.clone();
    let even = (0..=ELEMENTS).map(|i| low + (high - low) * i as f64 / ELEMENTS as f64);
    for x in std::iter::once(nut).chain(even) {
        if nodes.iter().all(|n| (n - x).abs() > 1e-9 * (high - low)) {
            nodes.push(x);
        }
    }
    nodes.sort_unstable_by(f64::total_cmp);
    let distance = |i: &usize| (nodes[*i] - nut).abs();
    let loaded = (0..nodes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
    let stretch = screw.displacements(&nodes, loaded, force);
    let mut grid = Grid { points: nodes.iter().map(|x| [*x, 0.0, 0.0]).collect(), ..Grid::default() };
    for i in 1..nodes.len() as u32 {
        grid.push(Cell::Line, &[i - 1, i]);
    }
    grid.push(Cell::Vertex, &[grid.points.len() as u32]);
    grid.points.push([nut, 0.0, 0.0]);
    let along = |x: f64| [x, 0.0, 0.0];
    let mut forces = vec![[0.0; 3]; nodes.len() + 1];
    forces[loaded] = along(force);
    grid.point_fields = vec![
        Field::vector("displacement", stretch.into_iter().chain([deviation]).map(along).collect()),
        Field::vector("force", forces),
    ];
    grid
}
