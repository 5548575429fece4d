//! The screw and its slide in space, target by target of a run.

use super::super::machine::Machine;
use super::super::rows::approach;
use super::super::setup::Setup;
use crate::positioning::{Approach, Direction};
use crate::process::{Animation, Arrow, Body, Cell, Ends, Field, Forward, Frame, Grid, Role, Skin, View, range};
use crate::units::{FORCE, LENGTH, MICRO};

/// Elements of the screw that is shown.
const ELEMENTS: usize = 100;
/// Frames, at most.
const MOST_FRAMES: usize = 400;

/// A target that is approached.
struct Stop {
    approach: Approach,
    /// Friction on the slide, N.
    force: f64,
    /// Where it stops less where it should, m.
    deviation: f64,
}

/// The first run, there and back; time is the number of the frame.
///
/// Points are the nodes of the screw on its axis (x, 0, 0), then the nut as commanded, then every target that has
/// been approached. `displacement` is along the axis: the screw's stretch under the friction of the slide, and the
/// predicted deviation of the nut at each target. `force` is what the slide's friction does to the screw.
pub fn animation(machine: &Machine, forward: &Forward) -> Animation {
    let setup = machine.setup.clone();
    let approaches = 2 * setup.test.positions;
    let count = approaches.min(MOST_FRAMES);
    let friction = machine.winding.as_ref().map_or(0.0, |winding| winding.friction);
    let stop = |i: usize| {
        let row = i * approaches / count;
        let approach = approach(forward.programme, row);
        let friction = setup.drag_at(approach.position) * friction;
        let force = if approach.direction == Direction::Forward { -friction } else { friction };
        Stop { approach, force, deviation: forward.prediction[row] }
    };
    let stops: Vec<Stop> = (0..count).map(stop).collect();
    let frame = move |i: usize| frame(&setup, &stops[..=i], i);
    Animation {
        name: "axis",
        shown: "deviation",
        time: "number of the target, from 0",
        view: View::Oblique,
        telling: (3 * count / 4).min(count.saturating_sub(1)),
        most_magnified: f64::INFINITY,
        frames: count,
        frame: Box::new(frame),
    }
}

/// The axis at the last of some stops.
fn frame(setup: &Setup, stops: &[Stop], number: usize) -> Frame {
    let Some(last) = stops.last() else { return Frame::default() };
    let (nut, force) = (last.approach.position, last.force);
    let screw = setup.screw();
    let ends = screw.held.iter().copied().chain([setup.from, setup.from + setup.travel, nut]);
    let (low, high) = range(ends);
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
    let mut deviations = stretch;
    for (at, deviation) in
        std::iter::once((nut, last.deviation)).chain(stops.iter().map(|s| (s.approach.position, s.deviation)))
    {
        grid.push(Cell::Vertex, &[grid.points.len() as u32]);
        grid.points.push([at, 0.0, 0.0]);
        deviations.push(deviation);
    }
    let along = |x: f64| [x, 0.0, 0.0];
    let mut forces = vec![[0.0; 3]; grid.points.len()];
    forces[loaded] = along(force);
    grid.point_fields = vec![
        Field::vector("displacement", LENGTH, deviations.iter().copied().map(along).collect()),
        Field::vector("force", FORCE, forces),
        Field::scalar("deviation", MICRO, deviations),
    ];
    let side = match last.approach.direction {
        Direction::Forward => "forwards",
        Direction::Backward => "backwards",
    };
    let (at, off) = (LENGTH.shown(nut), MICRO.shown(last.deviation));
    let above = Arrow { aside: [0.0, 2.4 * setup.diameter, 0.0], ..Arrow::new(loaded, 0.0) };
    Frame {
        time: number as f64,
        caption: format!("target {at:.1}, approached {side}: stops {off:+.2} from it"),
        bodies: bodies(setup, &nodes, (low, high), stops),
        grid,
        arrows: vec![above],
    }
}

/// Screw, bearings, bed and slide; on the bed a pin where the slide stopped at each target, forwards in the back row
/// and backwards in the front row, in front of a mark where it should have.
fn bodies(setup: &Setup, nodes: &[f64], (low, high): (f64, f64), stops: &[Stop]) -> Vec<Body> {
    let d = setup.diameter;
    let rim = |node: u32| (Some(node), [0.0; 3], 0.5 * d);
    let rims: Vec<_> = (0..nodes.len() as u32).map(rim).collect();
    let mut bodies = vec![Body::new("screw", Role::Work, Skin::round(&rims, [1.0, 0.0, 0.0], Ends::Capped))];
    for held in setup.screw().held {
        bodies.push(Body::new("bearing", Role::Machine, Skin::block(None, [held, 0.0, 0.0], [0.3 * d, d, d])));
    }
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low) + d);
    let bed = Skin::block(None, [middle, -1.4 * d, 1.9 * d], [half, 0.2 * d, 3.3 * d]);
    bodies.push(Body::new("bed", Role::Machine, bed));
    let nut = Some(nodes.len() as u32);
    let slide = Skin::block(nut, [0.0, 0.0, 0.0], [0.8 * d, 0.85 * d, 0.85 * d]).and(&Skin::block(
        nut,
        [0.0, 1.2 * d, 0.0],
        [1.6 * d, 0.3 * d, 1.4 * d],
    ));
    bodies.push(Body::new("slide", Role::Work, slide));
    let thin = (0.2 * d).min(0.1 * setup.travel / setup.test.positions as f64);
    let (mut pins, mut marks) = (Skin::default(), Skin::default());
    for (i, stop) in stops.iter().enumerate() {
        let z = if stop.approach.direction == Direction::Forward { 2.7 * d } else { 4.3 * d };
        let node = Some((nodes.len() + 1 + i) as u32);
        pins = pins.and(&Skin::block(node, [0.0, -0.7 * d, z], [thin, 0.5 * d, 0.3 * d]));
        let at = stop.approach.position;
        marks = marks.and(&Skin::block(None, [at, -1.15 * d, z], [0.3 * thin, 0.05 * d, 0.7 * d]));
    }
    bodies.extend([Body::new("where it stopped", Role::Work, pins), Body::new("target", Role::Nominal, marks)]);
    bodies
}
