//! The cam in the plane: its contour for drawings, and the wheel going round it for ParaView.

use std::f64::consts::TAU;

use super::job::Cam;
use super::model::Setup;
use super::motion::Motion;
use super::profile::{Vector, direction};
use crate::process::{Animation, Cell, Field, Frame, Grid, Spot};

/// Most frames of the animation.
const MOST_FRAMES: usize = 120;
/// Points around the wheel.
const AROUND_WHEEL: usize = 180;

/// The points of the prediction on the contour, closed, with the deviation at each by its number.
pub fn spots(setup: &Setup, deviation: impl Fn(usize) -> f64) -> Vec<Spot> {
    let places = setup.places();
    let spot = |i: usize| {
        let place = setup.profile.at(places[i]);
        Spot { at: place.point.into(), outward: place.normal.into(), deviation: deviation(i) }
    };
    (0..places.len()).chain([0]).map(spot).collect()
}

/// The wheel at the ends of blocks, seen from the cam; time is that of the programme, s. Points: the cam, displaced by its deviation; the path of the wheel's
/// centre; the wheel; its grinding point.
pub fn animation(cam: &Cam, motion: Motion, deviations: Vec<f64>) -> Animation {
    let setup = cam.machine.setup.clone();
    let contour = spots(&setup, |i| deviations[i]);
    let sense = setup.profile.sense();
    let times = setup.program.axes.times.clone();
    let count = setup.program.blocks().min(MOST_FRAMES);
    let block = move |frame: usize| (frame + 1) * (times.len() - 1) / count - 1;
    let times = setup.program.axes.times.clone();
    let frame = move |i: usize| {
        let block = block(i);
        let mut scene = Scene::default();
        scene.contour(&contour);
        scene
            .line(motion.legs().iter().map(|leg| leg.ends[0]).chain(motion.legs().last().map(|leg| leg.ends[1])), PATH);
        let legs = motion.legs();
        let next = if block + 2 < times.len() { motion.first_leg(block + 1) } else { legs.len() };
        let (leg, radius) = (&legs[next - 1], motion.radius());
        let centre = leg.ends[1];
        let rim = |k: usize| centre + direction(TAU * k as f64 / AROUND_WHEEL as f64) * radius;
        scene.line((0..=AROUND_WHEEL).map(rim), WHEEL);
        scene.vertex(leg.grinding_point(1.0, radius, sense), GRINDING_POINT);
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
    fn point(&mut self, [x, y]: [f64; 2], part: f64) -> u32 {
        self.grid.points.push([x, y, 0.0]);
        self.displacements.push([0.0; 3]);
        self.deviations.push(0.0);
        self.parts.push(part);
        self.grid.points.len() as u32 - 1
    }

    fn contour(&mut self, spots: &[Spot]) {
        let mut last = None;
        for spot in spots {
            let point = self.point(spot.at, CAM);
            let [x, y] = spot.outward.map(|c| c * spot.deviation);
            self.displacements[point as usize] = [x, y, 0.0];
            self.deviations[point as usize] = spot.deviation;
            if let Some(last) = last.replace(point) {
                self.grid.push(Cell::Line, &[last, point]);
            }
        }
    }

    fn line(&mut self, points: impl Iterator<Item = Vector>, part: f64) {
        let mut last = None;
        for point in points {
            let point = self.point(point.into(), part);
            if let Some(last) = last.replace(point) {
                self.grid.push(Cell::Line, &[last, point]);
            }
        }
    }

    fn vertex(&mut self, point: Vector, part: f64) {
        let point = self.point(point.into(), part);
        self.grid.push(Cell::Vertex, &[point]);
    }

    fn finish(mut self) -> Grid {
        self.grid.point_fields = vec![
            Field::vector("displacement", self.displacements),
            Field::scalar("deviation", self.deviations),
            Field::scalar("part", self.parts),
        ];
        self.grid
    }
}
