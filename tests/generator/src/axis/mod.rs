//! Feed axes under a positioning test. The laws are short; they are written down once more here, in mm and
//! um, so that a slip of the program in sign, unit or origin shows.

pub mod asked;
pub mod catalogue;
pub mod design;
pub mod scenes;
pub mod writing;

use std::f64::consts::{PI, TAU};

use catalogue::LAWS;

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::preload::Side;
use crate::random::Random;

/// Deviations (um) of feed axes.
pub const AXIS: Process = Process {
    name: "axis ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// Young's modulus of the screw, N/mm².
const YOUNGS_MODULUS: f64 = 210_000.0;

/// Expansion of the screw, 1e-6/K, and the temperature at which its lead is right, degC.
const EXPANSION: f64 = 11.5;
const REFERENCE: f64 = 20.0;

/// Structure outside the catalogue.
const SHAPES: &[&str] = &[
    "a wave that is no turn of the screw",
    "a step along the travel",
    "one target is off",
    "every other run is off",
    "play in one half of the travel",
];

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Number of the run.
    pub run: usize,
    /// Target, mm.
    pub x: f64,
    /// Approached on the way back.
    pub backward: bool,
    /// min since the cold start; 0 where nobody looked at a clock.
    pub time: f64,
    /// Force that pulls the slide towards the beginning of the travel, N.
    pub pull: f64,
    /// What the control adds to the command, um.
    pub change: f64,
}

/// An axis with its test.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// mm.
    pub travel: f64,
    /// Where it begins, mm.
    pub from: f64,
    /// mm.
    pub lead: f64,
    /// Of the screw, mm.
    pub diameter: f64,
    /// Of the bearing, mm.
    pub fixed_at: f64,
    /// Readings in their order.
    pub rows: Vec<Row>,
    /// Whether the file has times.
    pub own_clock: bool,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
    /// What not every axis has.
    pub set_up: SetUp,
}

/// What not every axis has.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SetUp {
    /// A second fixed bearing, mm.
    pub also_fixed_at: Option<f64>,
    /// Friction of the slide at places (mm, N) that reach over the travel, straight between; only its course
    /// counts.
    pub drag: Vec<(f64, f64)>,
    /// A nut of two halves: what each is, and with what they press on each other, N.
    pub nut: Option<(Side, f64)>,
    /// Of the screw, degC.
    pub temperature: Option<f64>,
}

impl SetUp {
    /// Friction at a place over its mean from `from` to `to`.
    fn dragged(&self, x: f64, [from, to]: [f64; 2]) -> f64 {
        if self.drag.is_empty() {
            return 1.0;
        }
        let mut ends: Vec<f64> = self.drag.iter().map(|(at, _)| *at).filter(|at| from < *at && *at < to).collect();
        ends.insert(0, from);
        ends.push(to);
        let piece = |pair: &[f64]| 0.5 * (self.drag_at(pair[0]) + self.drag_at(pair[1])) * (pair[1] - pair[0]);
        self.drag_at(x) * (to - from) / ends.windows(2).map(piece).sum::<f64>()
    }

    fn drag_at(&self, x: f64) -> f64 {
        let above = self.drag.partition_point(|(at, _)| *at <= x).clamp(1, self.drag.len() - 1);
        let ((from, low), (to, high)) = (self.drag[above - 1], self.drag[above]);
        low + (high - low) * (x - from) / (to - from)
    }
}

impl crate::job::Job for Job {
    crate::job::of_fields!("axis");

    fn groups(&self) -> Vec<usize> {
        self.rows.iter().map(|row| row.run - 1).collect()
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.05, 4.0)
    }

    fn admits(&self, effect: &str, _causes: &[Cause]) -> bool {
        // Where a screw that is held at both ends goes when it warms up nobody says.
        effect != "thermal-growth" || self.own_clock && self.set_up.also_fixed_at.is_none()
    }

    fn length(&self) -> f64 {
        self.travel
    }

    fn draws(&self, effect: &str) -> usize {
        match effect {
            "periodic-error" | "thermal-growth" | "elastic-lost-motion" => 8,
            _ => 2,
        }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let area = 0.25 * PI * self.diameter * self.diameter;
        // um per N: 1000 times mm per N. The nut hangs on the screw from its bearing, or on both of its ends.
        let give = |x: f64| {
            let seat = value(causes, "elastic-lost-motion", "stiffness").map_or(0.0, |k| 1.0 / k);
            let near = (x - self.fixed_at).abs();
            let free = self.set_up.also_fixed_at.map_or(near, |other| {
                let far = (x - other).abs();
                let between = near + far <= (other - self.fixed_at).abs() * (1.0 + 1e-12);
                if between { near * far / (near + far) } else { near.min(far) }
            });
            seat + 1e3 * free / (YOUNGS_MODULUS * area)
        };
        // What friction winds up is transmitted when the slide is reached, one way or the other: screw, bearing
        // and nut stand in series with the play, on the side of it that the approach has left them.
        let wound = |x: f64| {
            let friction =
                size("elastic-lost-motion", "friction") * self.set_up.dragged(x, [self.from, self.from + self.travel]);
            let nut = self.set_up.nut.map_or(0.0, |(side, preload)| side.pair_moves(preload, friction));
            friction * give(x) + nut
        };
        let warmed = |time: f64| {
            let tau = value(causes, "thermal-growth", "time_constant").unwrap_or(1.0);
            size("thermal-growth", "slope") * (1.0 - (-time / tau).exp())
        };
        // um/m from 1e-6/K.
        let warm = self.set_up.temperature.map_or(0.0, |t| EXPANSION * (t - REFERENCE));
        let one = |row: &Row| {
            let part = (row.x - self.from) / self.travel;
            let bow = 1.0 - (2.0 * part - 1.0).powi(2);
            let turn = TAU * row.x / self.lead + size("periodic-error", "phase").to_radians();
            let both = 1e-3 * row.x * size("scale-error", "slope")
                + size("periodic-error", "amplitude") * turn.sin()
                + 1e-3 * (row.x - self.fixed_at) * (warmed(row.time) + warm)
                + size("abbe-error", "height") * bow
                + size("reference-shift", "offset");
            let wound = wound(row.x);
            let play = size("backlash", "gap")
                + size("uneven-backlash", "change") * (part - 0.5)
                + size("worn-screw", "depth") * bow;
            if row.pull > 0.0 {
                // The drive holds the slide against the pull, and against friction or with its help.
                let friction = size("elastic-lost-motion", "friction")
                    * self.set_up.dragged(row.x, [self.from, self.from + self.travel]);
                let holds = if row.backward { row.pull - friction } else { row.pull + friction };
                let nut = self.set_up.nut.map_or(0.0, |(side, preload)| side.pair_moves(preload, holds.abs()));
                let has_nut = value(causes, "elastic-lost-motion", "friction").is_some();
                let yielded = holds.abs() * give(row.x) + if has_nut { nut } else { 0.0 };
                return if holds < 0.0 { both + yielded + play } else { both - yielded };
            }
            if row.backward { both + wound + play } else { both - wound }
        };
        // The slide is sent elsewhere, and is off there as it is off when it is meant to go there.
        let sent = |row: &Row| row.change + one(&Row { x: row.x + 1e-3 * row.change, ..*row });
        self.rows.iter().map(sent).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let name = random.pick(SHAPES);
        let (periods, phase, at) = (random.uniform(1.7, 3.4), random.uniform(0.0, TAU), random.uniform(0.3, 0.7));
        let target = random.pick(&self.rows).x;
        let shape = |row: &Row| {
            let part = (row.x - self.from) / self.travel;
            match name {
                "a wave that is no turn of the screw" => (TAU * periods * part + phase).sin(),
                "a step along the travel" => f64::from(part > at),
                "one target is off" => f64::from(row.x == target),
                "every other run is off" => f64::from(row.run.is_multiple_of(2)),
                _ => f64::from(row.backward && part > at),
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
