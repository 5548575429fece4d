//! Cams that a polar grinder interpolates, in blocks of equal length. What the wheel leaves is looked for
//! position by position ([`motion`]). Follower's lifts, other divisions, blocks that begin and end at rest,
//! shifted ends and a pass before are not made.

pub mod catalogue;
pub mod design;
pub mod motion;
pub mod profile;
pub mod writing;

use std::f64::consts::{PI, TAU};

use catalogue::LAWS;
use motion::{Machine, Motion};
use profile::{Place, Profile};

use crate::Process;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::random::Random;

/// Deviations (um) of ground cams.
pub const CAM: Process = Process {
    name: "cam ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[],
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
        let ends = motion::programme(&self.profile, self.wheel, self.step);
        let turn = |pass: &Pass| Motion::new(&ends, self.wheel, &machine, TAU / 60.0 * pass.speed, pass.reverse);
        let turns: Vec<Motion> = self.passes.iter().map(turn).collect();
        let gives = value(causes, "grinding-deflection", "stiffness").map_or(0.0, |k| 1.0 / k);
        let one = |row: &Row| {
            let place = self.profile.at(row.angle);
            let force = if gives > 0.0 { self.force(&place, &self.passes[row.pass]) } else { 0.0 };
            1e3 * turns[row.pass].leaves(&place) + gives * force
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

    fn tables(&self) -> String {
        writing::tables(self)
    }

    fn data(&self, observed: &[f64], sigma: f64) -> String {
        writing::data(self, observed, sigma)
    }
}

impl Job {
    /// Force of the cut where the grinding point goes along the profile as it is programmed, N.
    fn force(&self, place: &Place, pass: &Pass) -> f64 {
        let Some((stock, per_rate)) = self.cut else { return 0.0 };
        // The cam turns by dφ = W × dW/W², and the centre goes by dW = (1 + κR)·ds along the profile.
        let [x, y] = place.centre(self.wheel);
        let (sine, cosine) = place.normal.sin_cos();
        let turned = (1.0 + place.curvature * self.wheel) * (x * cosine + y * sine) / (x * x + y * y);
        per_rate * 1e-3 * stock * (TAU / 60.0 * pass.speed) / turned
    }
}
