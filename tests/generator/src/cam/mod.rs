//! Cams that a polar grinder interpolates, in blocks of equal length. What the wheel leaves is looked for
//! position by position ([`motion`]). Follower's lifts, other divisions, blocks that begin and end at rest and
//! shifted ends are not made.

pub mod asked;
pub mod catalogue;
pub mod design;
pub mod motion;
pub mod profile;
pub mod scenes;
pub mod writing;

use std::f64::consts::{PI, TAU};

use catalogue::LAWS;
use motion::{Machine, Motion};
use profile::{Place, Profile};

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::random::Random;

/// Deviations (um) of ground cams.
pub const CAM: Process = Process {
    name: "cam ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// Structure outside the catalogue.
const SHAPES: &[&str] = &["lobes", "chatter", "a dent", "a step", "one bad cam"];

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Number of the cam in `passes`.
    pub pass: usize,
    /// Polar angle of the profile's point, deg.
    pub angle: f64,
}

/// How a cam was ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pass {
    /// Of the cam, rpm.
    pub speed: f64,
    /// From the end of the programme to its beginning.
    pub reverse: bool,
}

/// The pass before, forwards at the speed of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Before {
    /// Of a block, mm.
    pub step: f64,
    /// Radius of its wheel, mm.
    pub wheel: f64,
    /// Layer that it took off, um.
    pub stock: f64,
}

/// A grinder with the cams that were measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// What is programmed.
    pub profile: Profile,
    /// Radius of the wheel, mm.
    pub wheel: f64,
    /// Of a block, mm.
    pub step: f64,
    /// Of the cam in the model, rpm.
    pub speed: f64,
    /// Layer (um) and force per rate of removal (N/(mm²/s)).
    pub cut: Option<(f64, f64)>,
    /// What ground the cams before, if that was another programme.
    pub before: Option<Before>,
    /// The cams.
    pub passes: Vec<Pass>,
    /// Readings in their order.
    pub rows: Vec<Row>,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
}

impl crate::job::Job for Job {
    crate::job::of_fields!("cam");

    fn groups(&self) -> Vec<usize> {
        self.rows.iter().map(|row| row.pass).collect()
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.05, 3.0)
    }

    fn admits(&self, effect: &str, _causes: &[Cause]) -> bool {
        effect != "grinding-deflection" || self.cut.is_some()
    }

    fn length(&self) -> f64 {
        self.profile.lengths().iter().sum()
    }

    fn draws(&self, _effect: &str) -> usize {
        2
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let size = |effect: &str, parameter: &str| value(causes, effect, parameter).unwrap_or(0.0);
        let machine = Machine {
            lag: 1e-3 * size("servo-lag", "time"),
            gap: 1e-3 * size("infeed-backlash", "gap"),
            height: 1e-3 * size("centre-height", "height"),
            loss: 1e-3 * size("wheel-wear", "loss"),
        };
        let turn = |step: f64, wheel: f64, pass: &Pass| {
            let ends = motion::programme(&self.profile, wheel, step);
            Motion::new(&ends, wheel, &machine, TAU / 60.0 * pass.speed, pass.reverse)
        };
        let turns: Vec<Motion> = self.passes.iter().map(|pass| turn(self.step, self.wheel, pass)).collect();
        let forwards = Pass { speed: self.speed, reverse: false };
        let before = self.before.map(|b| (b, turn(b.step, b.wheel, &forwards)));
        let gives = value(causes, "grinding-deflection", "stiffness").map_or(0.0, |k| 1.0 / k);
        let one = |row: &Row| {
            let place = self.profile.at(row.angle);
            // Of the layer the wheel gives way by so much.
            let part = |wheel: f64, pass: &Pass| if gives > 0.0 { gives * self.rate(&place, wheel, pass) } else { 0.0 };
            let (pass, left) = (&self.passes[row.pass], 1e3 * turns[row.pass].leaves(&place));
            let (part_here, stock) = (part(self.wheel, pass), self.cut.map_or(0.0, |cut| cut.0));
            let Some((before, turn)) = &before else { return left + part_here * stock };
            let found = 1e3 * turn.leaves(&place) + part(before.wheel, &forwards) * before.stock;
            // d = left + part·layer and layer = stock + found − d; where none is left the old surface stays.
            let layer = (stock + found - left) / (1.0 + part_here);
            if layer > 0.0 { left + part_here * layer } else { stock + found }
        };
        self.rows.iter().map(one).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let name = random.pick(SHAPES);
        let (lobes, phase) = (random.pick(&[3.0, 4.0, 5.0]), random.uniform(0.0, TAU));
        let (waves, wide) = (random.uniform(12.0, 20.0).round(), random.uniform(0.15, 0.4));
        let bad = random.pick(&self.rows).pass;
        let shape = |row: &Row| {
            let angle = row.angle.to_radians();
            let off = (angle - phase + 2.5 * TAU).rem_euclid(TAU) - PI;
            match name {
                "lobes" => (lobes * angle - phase).cos(),
                "chatter" => (waves * angle - phase).cos(),
                "a dent" => (-0.5 * (off / wide).powi(2)).exp(),
                "a step" => f64::from(off > 0.0),
                _ => f64::from(row.pass == bad) * (lobes * angle - phase).cos(),
            }
        };
        (name, self.rows.iter().map(shape).collect())
    }

    fn asked(&self, rows: &[Asked]) -> Option<Box<dyn crate::job::Job>> {
        Some(Box::new(asked::asked(self, rows)?))
    }

    fn tables(&self) -> String {
        writing::tables(self)
    }

    fn data(&self, observed: &[f64], sigma: f64) -> String {
        writing::data(self, observed, sigma)
    }
}

impl Job {
    /// Force of the cut for each um of the layer where the grinding point goes along the profile as it is
    /// programmed, N/um.
    fn rate(&self, place: &Place, wheel: f64, pass: &Pass) -> f64 {
        let Some((_, per_rate)) = self.cut else { return 0.0 };
        // The cam turns by dφ = W × dW/W², and the centre goes by dW = (1 + κR)·ds along the profile.
        let [x, y] = place.centre(wheel);
        let (sine, cosine) = place.normal.sin_cos();
        let turned = (1.0 + place.curvature * wheel) * (x * cosine + y * sine) / (x * x + y * y);
        per_rate * 1e-3 * (TAU / 60.0 * pass.speed) / turned
    }
}
