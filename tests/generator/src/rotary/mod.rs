//! Rotary axes under a positioning test, in degrees, seconds of arc and N·m: wheels that turn each other from the motor to
//! the table, a spring, and a table that lies against one flank or the other.

pub mod asked;
pub mod catalogue;
pub mod design;
pub mod scenes;
pub mod writing;

use std::f64::consts::TAU;

use catalogue::LAWS;

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::random::Random;

/// Deviations (arcsec) of rotary axes.
pub const ROTARY: Process = Process {
    name: "rotary ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    // The readings of one head are off by a wheel or by a ring alike.
    never_together: &[["wheel-eccentricity", "scale-eccentricity"]],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// Seconds of arc in a radian.
const ARCSEC: f64 = 206_264.806_247_096_36;

/// Structure outside the catalogue.
const SHAPES: &[&str] = &[
    "three waves in a turn",
    "a step along the range",
    "one target is off",
    "every other run is off",
    "play in one half of the range",
];

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Number of the run.
    pub run: usize,
    /// Target, deg.
    pub angle: f64,
    /// Approached on the way back.
    pub backward: bool,
    /// min since the cold start; 0 where nobody looked at a clock.
    pub time: f64,
    /// External torque towards larger angles, N·m; None where it is that of the test.
    pub torque: Option<f64>,
    /// What the control adds to the command, arcsec.
    pub change: f64,
}

/// A ring of lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Behind the gearing, on the motor.
    pub on_motor: bool,
    /// The control holds what it shows.
    pub closed: bool,
    /// mm.
    pub radius: f64,
    /// On the ring.
    pub lines: u32,
}

/// An axis with its test.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// deg.
    pub range: f64,
    /// Where it begins, deg.
    pub from: f64,
    /// Across gravity.
    pub lies: bool,
    /// Teeth of each pair of gears from the motor on.
    pub pairs: Vec<[u32; 2]>,
    /// Starts of the worm behind them and teeth of its wheel.
    pub worm: Option<[u32; 2]>,
    /// Pitch radius of the wheel on the table, mm.
    pub wheel: Option<f64>,
    /// N·m/arcsec at the table; None where it is rigid.
    pub stiffness: Option<f64>,
    /// Its scale.
    pub ring: Option<Ring>,
    /// Torque from outside during the test, N·m.
    pub torque: f64,
    /// Readings in their order.
    pub rows: Vec<Row>,
    /// Whether the file has times.
    pub own_clock: bool,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
}

/// Turns of every shaft in a turn of the table.
struct Turns {
    /// The worm.
    worm: f64,
    /// The pinion of the last pair, and the teeth that pass there.
    pinion: f64,
    teeth: f64,
    /// The motor.
    motor: f64,
}

impl Job {
    /// From the table back to the motor, wheel by wheel.
    fn turns(&self) -> Turns {
        let worm = self.worm.map_or(1.0, |[starts, teeth]| f64::from(teeth) / f64::from(starts));
        let (mut shaft, mut pinion, mut teeth) = (worm, 0.0, 0.0);
        for (i, [small, large]) in self.pairs.iter().rev().enumerate() {
            let passing = shaft * f64::from(*large);
            shaft = passing / f64::from(*small);
            if i == 0 {
                (teeth, pinion) = (passing, shaft);
            }
        }
        Turns { worm, pinion, teeth, motor: shaft }
    }

    /// Whether the control takes out what the drive is off by.
    fn is_closed(&self) -> bool {
        self.ring.is_some_and(|ring| ring.closed)
    }

    /// Where the table comes to rest beside its command, arcsec: its drive pushes it by one flank, and gives way by what it
    /// bears.
    fn rests(&self, causes: &[Cause], row: &Row) -> f64 {
        if self.is_closed() {
            return 0.0;
        }
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let soft = |effect| value(causes, effect, "stiffness").map_or(0.0, |stiffness| 1.0 / stiffness);
        let give = self.stiffness.map_or(0.0, |k| 1.0 / k) + soft("elastic-wind-up") + soft("compliance");
        let cosine = |effect| (row.angle + size(effect, "phase")).to_radians().cos();
        let weight = size("unbalance", "moment") * cosine("unbalance");
        let pushed = row.torque.unwrap_or(self.torque) + weight;
        let friction = size("elastic-wind-up", "friction");
        let play = size("backlash", "gap") + size("uneven-backlash", "change") * cosine("uneven-backlash");
        // Friction is against the way: it is the drive that must bear it.
        if row.backward {
            let bears = pushed + friction;
            if bears < 0.0 { bears * give } else { play + bears * give }
        } else {
            let bears = pushed - friction;
            if bears > 0.0 { play + bears * give } else { bears * give }
        }
    }

    /// What wheels and rings are off by at an angle (deg), arcsec, the same from either side.
    fn wheels(&self, causes: &[Cause], angle: f64) -> f64 {
        let Turns { worm, pinion, teeth, motor } = self.turns();
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let wave = |effect, parameter, times: f64| {
            size(effect, parameter) * ((times * angle).to_radians() + size(effect, "phase").to_radians()).sin()
        };
        // um on mm.
        let runs_out = |effect, radius: Option<f64>| {
            radius.map_or(0.0, |radius| 1e-3 * ARCSEC / radius * wave(effect, "eccentricity", 1.0))
        };
        let lines = self.ring.map_or(0.0, |ring| f64::from(ring.lines) * if ring.on_motor { motor } else { 1.0 });
        wave("worm-error", "amplitude", worm)
            + wave("worm-second-harmonic", "amplitude", 2.0 * worm)
            + wave("tooth-error", "amplitude", teeth)
            + wave("gear-eccentricity", "amplitude", pinion)
            + wave("motor-gear-eccentricity", "amplitude", motor)
            + runs_out("wheel-eccentricity", self.wheel)
            + runs_out("scale-eccentricity", self.ring.map(|ring| ring.radius))
            + wave("scale-second-harmonic", "amplitude", 2.0)
            + wave("interpolation-error", "amplitude", lines)
            + angle * size("ratio-error", "slope")
    }
}

impl crate::job::Job for Job {
    crate::job::of_fields!("rotary");

    fn si(&self) -> Vec<f64> {
        vec![1.0 / ARCSEC; self.rows.len()]
    }

    fn groups(&self) -> Vec<usize> {
        self.rows.iter().map(|row| row.run - 1).collect()
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.1, 4.0)
    }

    fn admits(&self, effect: &str, _causes: &[Cause]) -> bool {
        let on_table = self.ring.is_some_and(|ring| !ring.on_motor);
        match effect {
            "reference-shift" => true,
            "thermal-drift" => self.own_clock,
            "scale-eccentricity" | "scale-second-harmonic" => on_table,
            "interpolation-error" => self.ring.is_some(),
            _ if self.is_closed() => false,
            "worm-error" | "worm-second-harmonic" => self.worm.is_some(),
            "tooth-error" | "gear-eccentricity" => !self.pairs.is_empty(),
            "motor-gear-eccentricity" => self.pairs.len() > 1,
            "wheel-eccentricity" => self.wheel.is_some(),
            "ratio-error" => self.range < 360.0,
            "backlash" | "uneven-backlash" => self.worm.is_some() || !self.pairs.is_empty(),
            "compliance" => self.stiffness.is_none(),
            "unbalance" => self.lies,
            _ => true,
        }
    }

    fn length(&self) -> f64 {
        self.range
    }

    fn draws(&self, effect: &str) -> usize {
        match effect {
            "ratio-error" | "backlash" | "reference-shift" | "compliance" => 2,
            _ => 8,
        }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let warmed = |time: f64| {
            let tau = value(causes, "thermal-drift", "time_constant").unwrap_or(1.0);
            size("thermal-drift", "size") * (1.0 - (-time / tau).exp())
        };
        let one = |row: &Row| {
            self.wheels(causes, row.angle)
                + self.rests(causes, row)
                + warmed(row.time)
                + size("reference-shift", "offset")
        };
        // The table is sent elsewhere, and is off there as it is off when it is meant to go there.
        let sent = |row: &Row| row.change + one(&Row { angle: row.angle + row.change / 3600.0, ..*row });
        self.rows.iter().map(sent).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let name = random.pick(SHAPES);
        let (phase, at) = (random.uniform(0.0, TAU), random.uniform(0.3, 0.7));
        let target = random.pick(&self.rows).angle;
        let shape = |row: &Row| {
            let part = (row.angle - self.from) / self.range;
            match name {
                "three waves in a turn" => (3.0 * row.angle.to_radians() + phase).sin(),
                "a step along the range" => f64::from(part > at),
                "one target is off" => f64::from(row.angle == target),
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
