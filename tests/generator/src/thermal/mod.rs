//! Heated rods, by other numerics than the program under test: finite volumes instead of finite elements,
//! another implicit method in time, the sensors' lag through the recorded history. Heated [plates](plate) by series.

pub mod asked;
pub mod catalogue;
pub mod design;
pub mod job;
pub mod plate;
pub mod rod;
pub mod scenes;
pub mod writing;

use std::f64::consts::TAU;

use catalogue::LAWS;
use job::{Job, Row, Seen};
use rod::{Heater, Rod, histories};

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::random::Random;

/// Temperatures (degC) and elongations (um) of heated rods.
pub const THERMAL: Process = Process {
    name: "thermal ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: scenes::draw,
};

/// Structure outside the catalogue.
const SHAPES: &[&str] = &[
    "a sensor comes loose",
    "a sensor drifts",
    "ripple in time",
    "ripple of one sensor",
    "the end slips",
    "a sensor's scale is wrong while it is warm",
    "a burst",
];

/// The lag of sensors is followed in steps of this length, s: much shorter than any lag.
const FOLLOW: f64 = 5.0;

impl crate::job::Job for Job {
    crate::job::of_fields!("thermal");

    fn scales(&self) -> Vec<f64> {
        job::by_row(self.rows.iter().map(|row| row.seen), self.kelvin, 1.0)
    }

    fn si(&self) -> Vec<f64> {
        job::by_row(self.rows.iter().map(|row| row.seen), 1.0, 1e-6)
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.1, 6.0)
    }

    fn admits(&self, effect: &str, causes: &[Cause]) -> bool {
        let losing = |c: &Cause| ["convection", "base-conductance"].contains(&c.effect);
        match effect {
            "ambient-drift" => causes.iter().any(losing),
            "sensor-lag" => self.rows.iter().any(|r| r.seen != Seen::Elongation),
            _ => true,
        }
    }

    fn length(&self) -> f64 {
        self.segments.iter().map(|s| s.0).sum()
    }

    fn draws(&self, effect: &str) -> usize {
        match effect {
            "extra-source" | "contact-resistance" => 10,
            "ambient-drift" => 20,
            _ => 3,
        }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let lag = value(causes, "sensor-lag", "time_constant").unwrap_or(0.0);
        let at: Vec<f64> = self.sensors.iter().map(|x| 1e-3 * x).collect();
        let mut times: Vec<f64> = self.rows.iter().map(|r| 60.0 * r.time).collect();
        if lag > 0.0 {
            let last = times.iter().copied().fold(0.0, f64::max);
            times = (1..=(last / FOLLOW).round() as usize).map(|k| k as f64 * FOLLOW).collect();
        } else {
            times.dedup();
        }
        let mut found = histories(&self.rod(causes), &at, &times);
        if lag > 0.0 {
            delay(&mut found, lag);
        }
        let row = |row: &Row| {
            let i = times.iter().position(|t| (t - 60.0 * row.time).abs() < 1e-6).unwrap_or(0);
            match row.seen {
                Seen::Temperature(sensor) => self.set_up.start.unwrap_or(self.ambient) + found[i].0[sensor],
                Seen::Elongation => 1e6 * 11.5e-6 * found[i].1 + row.change,
            }
        };
        self.rows.iter().map(row).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let sees = |seen: fn(&Row) -> bool| self.rows.iter().any(seen);
        let (warm, long) = (sees(|r| r.seen != Seen::Elongation), sees(|r| r.seen == Seen::Elongation));
        let fits = |name: &&str| if name.contains("sensor") { warm } else { long || **name != *"the end slips" };
        let names: Vec<&'static str> = SHAPES.iter().copied().filter(fits).collect();
        let name = random.pick(&names);
        let sensor = random.whole(0, self.sensors.len() - 1);
        let (at, periods, phase) = (random.uniform(0.25, 0.75), random.uniform(5.0, 11.0), random.uniform(0.0, TAU));
        let slips = [random.uniform(0.15, 0.4), random.uniform(0.5, 0.85)];
        let shape = |row: &Row| {
            let share = row.time / self.end;
            let own = f64::from(row.seen == Seen::Temperature(sensor));
            let end = f64::from(row.seen == Seen::Elongation);
            match name {
                "a sensor comes loose" => own * f64::from(share > at),
                "a sensor drifts" => own * share,
                "ripple in time" => (TAU * periods * share + phase).sin(),
                "ripple of one sensor" => own * (TAU * periods * share + phase).sin(),
                "the end slips" => end * (f64::from(share > slips[0]) - f64::from(share > slips[1])),
                "a sensor's scale is wrong while it is warm" => own * f64::from((share - at).abs() < 0.12),
                _ => f64::from((share - at).abs() < 0.06),
            }
        };
        (name, self.rows.iter().zip(self.scales()).map(|(row, scale)| scale * shape(row)).collect())
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
    fn rod(&self, causes: &[Cause]) -> Rod {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let source = |(at, power, from, to): &(f64, f64, f64, f64)| (1e-3 * at, *power, 60.0 * from, 60.0 * to);
        let sources = std::iter::once(&self.source).chain(&self.set_up.sources).map(source).collect();
        let heater = value(causes, "heater-capacity", "contact")
            .map(|contact| Heater { capacity: size("heater-capacity", "heat_capacity"), contact });
        let friction = value(causes, "extra-source", "at").map(|at| (1e-3 * at, size("extra-source", "power")));
        let joint = value(causes, "contact-resistance", "at");
        let period = value(causes, "ambient-drift", "period").map_or(1.0, |hours| 3600.0 * hours);
        let surroundings =
            (size("ambient-drift", "amplitude"), TAU / period, size("ambient-drift", "phase").to_radians());
        Rod {
            segments: self.segments.iter().map(|(l, d)| (1e-3 * l, 1e-3 * d)).collect(),
            conductivity: 50.0,
            capacity: 7850.0 * 470.0,
            convection: size("convection", "coefficient"),
            base: size("base-conductance", "conductance"),
            joint: joint.map(|at| (1e-3 * at, size("contact-resistance", "conductance"))),
            sources,
            heater,
            friction: friction.into_iter().collect(),
            surroundings,
            apart: self.set_up.start.map_or(0.0, |start| self.ambient - start),
        }
    }
}

/// What sensors of a lag (s) show of a history in steps of [`FOLLOW`] that begins at zero: τ m' = T − m
/// with T straight within each step.
fn delay(found: &mut [(Vec<f64>, f64)], lag: f64) {
    let decay = (-FOLLOW / lag).exp();
    let sensors = found.first().map_or(0, |f| f.0.len());
    for sensor in 0..sensors {
        let (mut before, mut shown) = (0.0, 0.0);
        for (places, _) in found.iter_mut() {
            let now = places[sensor];
            let slope = (now - before) / FOLLOW;
            // The straight line's own response: now − slope·lag, to which the difference at the start decays.
            shown = now - slope * lag + (shown - before + slope * lag) * decay;
            before = now;
            places[sensor] = shown;
        }
    }
}
