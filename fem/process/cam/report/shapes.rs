//! The cam in the plane: its contour for drawings, and the wheel going round it for ParaView.

use std::f64::consts::TAU;

use super::super::motion::Motion;
use super::super::profile::{Vector, direction};
use super::super::setup::Setup;
use crate::process::{Animation, Cell, Curve, Drawing, Field, Frame, Grid, Spot};

/// Most frames of the animation.
const MOST_FRAMES: usize = 120;
/// Points around the wheel.
const AROUND_WHEEL: usize = 180;

/// The contour with the deviations (m) of the prediction's points.
fn predicted(setup: &Setup, deviations: &[f64]) -> Vec<Spot> {
    setup.drawn().into_iter().zip(deviations.iter().cycle()).map(|(spot, d)| spot.off_by(*d)).collect()
}

/// The cam with its deviations magnified.
pub fn drawing(setup: &Setup, deviations: &[f64]) -> Drawing {
    let pieces = vec![predicted(setup, deviations)];
    Drawing {
        name: "cam",
        title: "deviation of the cam, magnified".into(),
        nominal: vec![setup.drawn()],
        curves: vec![Curve { label: "predicted".into(), family: 0, is_measured: false, pieces }],
    }
}

/// The wheel at the ends of blocks, seen from the cam; time is that of the programme, s. Points: the cam,
/// displaced by its deviation; the path of the wheel's centre; the wheel; its grinding point.
pub fn animation(setup: &Setup, motion: Motion, deviations: &[f64]) -> Animation {
    let contour = predicted(setup, deviations);
    let sense = setup.profile.sense();
    let times = setup.program.axes.times.clone();
    let count = setup.program.blocks().min(MOST_FRAMES);
    let frame = move |i: usize| {
        let block = (i + 1) * (times.len() - 1) / count - 1;
        let legs = motion.legs();
        let next = if block + 2 < times.len() { motion.first_leg(block + 1) } else { legs.len() };
        let (leg, radius) = (&legs[next - 1], motion.radius());
        let rim = |k: usize| leg.ends[1] + direction(TAU * k as f64 / AROUND_WHEEL as f64) * radius;
        let spot = |at: Vector| Spot { at: at.into(), outward: [0.0; 2], deviation: 0.0 };
        let mut scene = Scene::default();
        scene.line(contour.iter().copied(), CAM);
        scene.line(legs.iter().map(|leg| leg.ends[0]).chain(legs.last().map(|leg| leg.ends[1])).map(spot), PATH);
        scene.line((0..=AROUND_WHEEL).map(rim).map(spot), WHEEL);
        scene.line([spot(leg.grinding_point(1.0, radius, sense))], GRINDING_POINT);
        Frame { time: times[block + 1], grid: scene.finish() }
    };
    Animation { name: "cam", frames: count, frame: Box::new(frame) }
}

/// Values of the field `part`.
const CAM: f64 = 0.0;
const PATH: f64 = 1.0;
const WHEEL: f64 = 2.0;
const GRINDING_POINT: f64 = 3.0;

/// Points and lines in the making.
#[derive(Default)]
struct Scene {
    grid: Grid,
    displacements: Vec<[f64; 3]>,
    deviations: Vec<f64>,
    parts: Vec<f64>,
}

impl Scene {
    fn line(&mut self, spots: impl IntoIterator<Item = Spot>, part: f64) {
        let first = self.grid.points.len() as u32;
        for Spot { at: [x, y], outward, deviation } in spots {
            let here = self.grid.points.len() as u32;
            self.grid.points.push([x, y, 0.0]);
            self.displacements.push([outward[0] * deviation, outward[1] * deviation, 0.0]);
            self.deviations.push(deviation);
            self.parts.push(part);
            if here > first {
                self.grid.push(Cell::Line, &[here - 1, here]);
            }
        }
    }

    fn finish(mut self) -> Grid {
        // The last is a point alone.
        self.grid.push(Cell::Vertex, &[self.grid.points.len() as u32 - 1]);
        self.grid.point_fields = vec![
            Field::vector("displacement", self.displacements),
            Field::scalar("deviation", self.deviations),
            Field::scalar("part", self.parts),
        ];
        self.grid
    }
}
