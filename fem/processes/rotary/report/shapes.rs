//! The table in space, target by target of a run.

use std::f64::consts::TAU;

use super::super::forward::borne;
use super::super::machine::Machine;
use super::super::rows::{approach, torque};
use super::super::setup::{Orientation, Setup};
use crate::positioning::{Approach, Direction};
use crate::process::{Animation, Arrow, Body, Cell, Ends, Field, Forward, Frame, Grid, Role, Skin, SkinPoint, View};
use crate::units::{ANGLE, FORCE, LENGTH, SMALL_ANGLE};

/// Points around the rim.
const RIM: usize = 72;
/// Frames, at most.
const MOST_FRAMES: usize = 400;

/// A target that is approached.
struct Stop {
    approach: Approach,
    /// Torque that the drive bears, towards +, N·m.
    borne: f64,
    /// Where it stops less where it should, rad.
    deviation: f64,
}

/// The first run, there and back; time is the number of the frame.
///
/// Points are those of the rim as commanded, then every target that has been approached, on a larger circle. `displacement`
/// is along the rim, by the predicted deviation. `force` is the torque that the drive bears, as a force at the rim.
pub fn animation(machine: &Machine, forward: &Forward) -> Animation {
    let setup = machine.setup.clone();
    let approaches = 2 * setup.test.positions;
    let count = approaches.min(MOST_FRAMES);
    let stop = |i: usize| {
        let row = i * approaches / count;
        let approach = approach(forward.programme, row);
        let outside = torque(&setup, forward.programme, row);
        let borne = borne(machine, approach.position, approach.direction, outside);
        Stop { approach, borne, deviation: forward.prediction[row] }
    };
    let stops: Vec<Stop> = (0..count).map(stop).collect();
    let frame = move |i: usize| frame(&setup, &stops[..=i], i);
    Animation {
        name: "rotary",
        shown: "deviation",
        time: "number of the target, from 0",
        view: View::Oblique,
        telling: (3 * count / 4).min(count.saturating_sub(1)),
        most_magnified: f64::INFINITY,
        frames: count,
        frame: Box::new(frame),
    }
}

/// The table at the last of some stops.
fn frame(setup: &Setup, stops: &[Stop], number: usize) -> Frame {
    let Some(last) = stops.last() else { return Frame::default() };
    let (radius, at) = (setup.shown_radius(), last.approach.position);
    let rim = |i: usize| at + TAU * i as f64 / RIM as f64;
    let mut grid = Grid::default();
    let (mut ways, mut deviations) = (Vec::new(), Vec::new());
    for i in 0..RIM {
        grid.points.push(setup.point(rim(i), radius, 0.0));
        grid.push(Cell::Line, &[i as u32, ((i + 1) % RIM) as u32]);
        ways.push(setup.towards(rim(i)).map(|c| radius * last.deviation * c));
        deviations.push(last.deviation);
    }
    for stop in stops {
        let angle = stop.approach.position;
        let outside = row_of(stop) * radius;
        grid.push(Cell::Vertex, &[grid.points.len() as u32]);
        grid.points.push(setup.point(angle, outside, 0.0));
        ways.push(setup.towards(angle).map(|c| outside * stop.deviation * c));
        deviations.push(stop.deviation);
    }
    let mut forces = vec![[0.0; 3]; grid.points.len()];
    forces[0] = setup.towards(at).map(|c| last.borne / radius * c);
    grid.point_fields = vec![
        Field::vector("displacement", LENGTH, ways),
        Field::vector("force", FORCE, forces),
        Field::scalar("deviation", SMALL_ANGLE, deviations),
    ];
    let side = match last.approach.direction {
        Direction::Forward => "forwards",
        Direction::Backward => "backwards",
    };
    let (target, off) = (ANGLE.shown(at), SMALL_ANGLE.shown(last.deviation));
    let above = Arrow { aside: setup.point(0.0, 0.0, 0.3 * radius), ..Arrow::new(0, 0.0) };
    Frame {
        time: number as f64,
        caption: format!("target {target:.2}, approached {side}: stops {off:+.2} from it"),
        bodies: bodies(setup, at, stops),
        grid,
        arrows: vec![above],
    }
}

/// Radius of the row in which a stop is shown over that of the table: outside those of the way back.
fn row_of(stop: &Stop) -> f64 {
    if stop.approach.direction == Direction::Forward { 1.35 } else { 1.15 }
}

/// The table with its index, the worm or the pinion that drives it, its bed; round it a pin where the table stopped at each
/// target, over a mark where it should have.
fn bodies(setup: &Setup, at: f64, stops: &[Stop]) -> Vec<Body> {
    let radius = setup.shown_radius();
    let thick = 0.12 * radius;
    let ring = |height: f64| -> Vec<SkinPoint> {
        let offset = setup.point(0.0, 0.0, height);
        (0..RIM).map(|i| SkinPoint { node: Some(i as u32), offset }).collect()
    };
    let table = Skin::lofted(&[ring(-thick), ring(thick)], Ends::Capped);
    let mut bodies = vec![Body::new("table", Role::Work, table)];
    let out = setup.point(at, 1.0, 0.0);
    let from_rim = setup.point(at, -0.6 * radius, 1.4 * thick);
    let index = Skin::square(Some(0), from_rim, out, &[(0.0, 0.3 * thick), (0.6 * radius, 0.3 * thick)]);
    bodies.push(Body::new("index", Role::Work, index));
    let up = setup.point(0.0, 0.0, 1.0);
    let across = setup.point(0.0, 1.0, 0.0);
    let driving = match (setup.drive.worm, setup.drive.turns_of_pinion()) {
        (Some(_), _) => {
            let from = setup.point(-TAU / 4.0, 1.15 * radius, -3.0 * thick);
            let from = [0, 1, 2].map(|c| from[c] - 0.7 * radius * across[c]);
            Some(("worm", Skin::turned(None, from, across, &[(0.0, 0.14 * radius), (1.4 * radius, 0.14 * radius)])))
        }
        (None, Some(ratio)) => {
            let own = radius / ratio.max(0.2);
            let from = setup.point(-TAU / 4.0, radius + own, -3.0 * thick);
            Some(("pinion", Skin::turned(None, from, up, &[(0.0, own), (1.5 * thick, own)])))
        }
        (None, None) => None,
    };
    bodies.extend(driving.map(|(name, skin)| Body::new(name, Role::Machine, skin)));
    let low = setup.point(0.0, 0.0, -5.0 * thick);
    let half = match setup.orientation {
        Orientation::Vertical => [1.5 * radius, 0.5 * thick, 1.5 * radius],
        Orientation::Horizontal => [1.5 * radius, 1.5 * radius, 0.5 * thick],
    };
    bodies.push(Body::new("bed", Role::Machine, Skin::block(None, low, half)));
    let thin = (0.02 * radius).min(0.2 * radius * setup.range.min(TAU) / setup.test.positions as f64);
    let (mut pins, mut marks) = (Skin::default(), Skin::default());
    for (i, stop) in stops.iter().enumerate() {
        let angle = stop.approach.position;
        let outwards = setup.point(angle, 1.0, 0.0);
        let inside = setup.point(angle, -0.07 * radius, 0.0);
        let pin = Skin::square(Some((RIM + i) as u32), inside, outwards, &[(0.0, thin), (0.14 * radius, thin)]);
        pins = pins.and(&pin);
        let from = setup.point(angle, (row_of(stop) - 0.07) * radius, -2.0 * thin);
        marks = marks.and(&Skin::square(None, from, outwards, &[(0.0, 0.4 * thin), (0.14 * radius, 0.4 * thin)]));
    }
    bodies.extend([Body::new("where it stopped", Role::Work, pins), Body::new("target", Role::Nominal, marks)]);
    bodies
}
