//! The cam in the plane: its contour for drawings, and the wheel going round it for ParaView.

use std::f64::consts::TAU;

use super::super::motion::Motion;
use super::super::profile::{Vector, direction};
use super::super::setup::Setup;
use crate::process::{
    Animation, Body, Cell, Curve, Drawing, Ends, Field, Frame, Grid, Role, Skin, SkinPoint, Spot, View,
};
use crate::units::{LENGTH, MICRO, NUMBER};

/// Most frames of the animation.
const MOST_FRAMES: usize = 60;
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
/// displaced by its deviation; the path of the wheel's centre; the wheel; its grinding point, with which the wheel
/// moves; the middle of the wheel.
pub fn animation(setup: &Setup, motion: Motion, deviations: &[f64]) -> Animation {
    let contour = predicted(setup, deviations);
    let sense = setup.profile.sense();
    let times = setup.program.axes.times.clone();
    let count = setup.program.blocks().min(MOST_FRAMES);
    let folds_at = drawing(setup, deviations).folds_at();
    let frame = move |i: usize| {
        let block = (i + 1) * (times.len() - 1) / count - 1;
        let legs = motion.legs();
        let next = if block + 2 < times.len() { motion.first_leg(block + 1) } else { legs.len() };
        let (leg, radius) = (&legs[next - 1], motion.radius());
        let rim = |k: usize| leg.ends[1] + direction(TAU * k as f64 / AROUND_WHEEL as f64) * radius;
        let spot = |at: Vector| Spot { at: at.into(), outward: [0.0; 2], deviation: 0.0 };
        // The wheel goes with the point of the cam that it grinds, magnified or not.
        let grinds = leg.grinding_point(1.0, radius, sense);
        let apart = |s: &Spot| (s.at[0] - grinds.x).hypot(s.at[1] - grinds.y);
        let ground = contour.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).copied();
        let with_cam = |at: Vector| Spot { at: at.into(), ..ground.unwrap_or(spot(at)) };
        let mut scene = Scene::default();
        scene.line(contour.iter().copied(), CAM);
        scene.line(legs.iter().map(|leg| leg.ends[0]).chain(legs.last().map(|leg| leg.ends[1])).map(spot), PATH);
        scene.line((0..=AROUND_WHEEL).map(rim).map(spot), WHEEL);
        scene.line([with_cam(grinds)], GRINDING_POINT);
        scene.line([with_cam(leg.ends[1])], GRINDING_POINT);
        let (seconds, off) = (times[block + 1], ground.map_or(0.0, |s| s.deviation));
        Frame {
            time: seconds,
            caption: format!("{seconds:.2} s into the turn: {:+.2} off where the wheel grinds", MICRO.shown(off)),
            bodies: bodies(&contour, scene.grid.points.len() as u32 - 1, radius),
            grid: scene.finish(),
            arrows: Vec::new(),
        }
    };
    Animation {
        name: "cam",
        shown: "deviation",
        time: "time of the programme, s",
        view: View::Front,
        telling: 0,
        most_magnified: UNFOLDED * folds_at,
        frames: count,
        frame: Box::new(frame),
    }
}

/// The cam, with its deviations in colours on a band along its edge, and the wheel, whose middle is a point of the
/// grid.
fn bodies(contour: &[Spot], wheel: u32, radius: f64) -> Vec<Body> {
    // The contour ends where it begins.
    let spots = &contour[..contour.len().saturating_sub(1)];
    let size = spots.iter().map(|s| s.at[0].hypot(s.at[1])).fold(0.0, f64::max);
    let (front, back) = (0.25 * size, -0.25 * size);
    let area: f64 = (0..spots.len())
        .map(|i| (spots[i].at, spots[(i + 1) % spots.len()].at))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    let mut order: Vec<usize> = (0..spots.len()).step_by(spots.len().div_ceil(MOST_RINGS)).collect();
    if area < 0.0 {
        order.reverse();
    }
    let point = |i: usize, inwards: f64, z: f64| {
        let [x, y] = spots[i].outward.map(|c| -inwards * c);
        SkinPoint { node: Some(i as u32), offset: [x, y, z] }
    };
    let depth = RIM * size;
    let band: Vec<Vec<SkinPoint>> = order
        .iter()
        .map(|i| {
            [point(*i, 0.0, front), point(*i, 0.0, back), point(*i, depth, back), point(*i, depth, front)].to_vec()
        })
        .collect();
    let edge = |z: f64| order.iter().map(|i| point(*i, 0.9 * depth, z)).collect::<Vec<_>>();
    let axis = |z: f64| vec![SkinPoint { node: None, offset: [0.0, 0.0, z] }; order.len()];
    let (low, high) = (0.98 * back, 0.98 * front);
    let loops = [axis(low), edge(low), edge(high), axis(high)];
    let wide = 1.1 * (front - back);
    let rims = [-0.5 * wide, 0.5 * wide].map(|z| (Some(wheel), [0.0, 0.0, z], radius));
    let disc = Skin::around(&rims, [0.0, 0.0, 1.0], Ends::Capped, 2 * AROUND_WHEEL);
    vec![
        Body::thickened("edge of the cam", Skin::lofted(&band, Ends::Joined)),
        Body { is_computed: true, ..Body::new("cam", Role::Machine, Skin::lofted(&loops, Ends::Capped)) },
        Body::new("wheel", Role::Tool, disc),
    ]
}

/// Places along the edge of the cam that is drawn, at most.
const MOST_RINGS: usize = 900;
/// Values of the field `part`.
const CAM: f64 = 0.0;
const PATH: f64 = 1.0;
const WHEEL: f64 = 2.0;
const GRINDING_POINT: f64 = 3.0;
/// Depth of the band along the edge of the cam, as a part of the cam's size.
const RIM: f64 = 0.06;
/// How near the picture may come to where the contour folds back.
const UNFOLDED: f64 = 0.7;

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
        // The last two are points alone.
        let last = self.grid.points.len() as u32 - 1;
        self.grid.push(Cell::Vertex, &[last - 1]);
        self.grid.push(Cell::Vertex, &[last]);
        self.grid.point_fields = vec![
            Field::vector("displacement", LENGTH, self.displacements),
            Field::scalar("deviation", MICRO, self.deviations),
            Field::scalar("part", NUMBER, self.parts),
        ];
        self.grid
    }
}
