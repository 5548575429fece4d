//! Circular tests of two axes. Slides are followed behind their drives step by step ([`axis`]); what comes behind
//! them on a machine is written down once more here, in mm and um. Rectangles and polygons are not made.

pub mod asked;
pub mod axis;
pub mod catalogue;
pub mod commanded;
pub mod design;
pub mod scenes;
pub mod writing;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use axis::{Axis, Lost, State};
use catalogue::LAWS;
use commanded::Lap;

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::preload::Side;
use crate::random::Random;

/// Deviations (um) of circles.
pub const CONTOUR: Process = Process {
    name: "contour ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// Young's modulus of the screws, N/mm².
pub const YOUNGS_MODULUS: f64 = 210_000.0;

/// Structure outside the catalogue.
const SHAPES: &[&str] =
    &["lobes", "lobes that turn with the direction", "a dent", "a step", "a spiral", "one bad lap", "an arc is off"];

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Number of the lap.
    pub lap: usize,
    /// Clockwise.
    pub clockwise: bool,
    /// mm/min.
    pub feed: f64,
    /// Of the commanded point, deg.
    pub angle: f64,
}

/// A screw on its fixed bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Screw {
    /// mm.
    pub diameter: f64,
    /// From the centre of the circle, mm.
    pub fixed_at: f64,
    /// A nut of two halves: what each is, and with what they press on each other, N.
    pub nut: Option<(Side, f64)>,
}

/// Two axes with their test.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// mm.
    pub radius: f64,
    /// Of the model, mm/min.
    pub feed: f64,
    /// Kv, 1/s.
    pub gain: f64,
    /// Of both screws, mm.
    pub lead: Option<f64>,
    /// At which the drives stick and slip, Hz.
    pub frequency: Option<f64>,
    /// Of x and y.
    pub screws: Option<[Screw; 2]>,
    /// On the tool, outwards and against the travel, N.
    pub cut: Option<[f64; 2]>,
    /// How much farther out the path is commanded counter-clockwise and clockwise: angle (deg) and change (um), rising.
    pub command: [Vec<(f64, f64)>; 2],
    /// Readings in their order.
    pub rows: Vec<Row>,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
}

impl crate::job::Job for Job {
    crate::job::of_fields!("contour");

    fn groups(&self) -> Vec<usize> {
        self.rows.iter().map(|row| row.lap).collect()
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.05, 3.0)
    }

    fn admits(&self, effect: &str, _causes: &[Cause]) -> bool {
        match effect {
            "cyclic-error-x" | "cyclic-error-y" => self.lead.is_some(),
            "stick-slip-x" | "stick-slip-y" => self.frequency.is_some(),
            "elastic-lost-motion-x" | "elastic-lost-motion-y" => self.screws.is_some(),
            "cutting-deflection" => self.cut.is_some(),
            _ => true,
        }
    }

    fn length(&self) -> f64 {
        self.radius
    }

    fn draws(&self, effect: &str) -> usize {
        self.laws().iter().find(|law| law.0 == effect).map_or(0, |law| if law.1.len() > 1 { 8 } else { 2 })
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        // All rows with a corrected command are of one feed.
        let lap = |clockwise: bool| -> Option<[Lap; 2]> {
            let table = &self.command[usize::from(clockwise)];
            let row = self.rows.iter().find(|row| row.clockwise == clockwise && !table.is_empty())?;
            let round = if clockwise { -1.0 } else { 1.0 };
            let [x, y] = self.axes(causes, row);
            Some([Lap::new(x, table, 0.0, round), Lap::new(y, table, 1.0, round)])
        };
        let laps = [false, true].map(lap);
        let of = |row: &Row| laps[usize::from(row.clockwise)].as_ref();
        self.rows.iter().map(|row| self.deviation(causes, row, of(row))).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let name = random.pick(SHAPES);
        let (lobes, phase) = (random.pick(&[3.0, 5.0, 6.0, 7.0]), random.uniform(0.0, TAU));
        let (wide, bad) = (random.uniform(0.2, 0.5), random.pick(&self.rows).lap);
        let shape = |row: &Row| {
            let angle = row.angle.to_radians();
            // From −π to π about a place.
            let off = (angle - phase + 2.5 * TAU).rem_euclid(TAU) - PI;
            match name {
                "lobes" => (lobes * angle - phase).cos(),
                "lobes that turn with the direction" => (lobes * angle + if row.clockwise { phase } else { 0.0 }).cos(),
                "a dent" => (-0.5 * (off / wide).powi(2)).exp(),
                "a step" => f64::from(off > 0.0),
                "a spiral" => off / TAU,
                "one bad lap" => f64::from(row.lap == bad) * (3.0 * angle - phase).cos(),
                _ => f64::from(off.abs() < wide),
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
    /// The axes under their causes on a row's lap.
    pub fn axes(&self, causes: &[Cause], row: &Row) -> [Axis; 2] {
        let size = |effect: &str, parameter: &str| value(causes, effect, parameter).unwrap_or(0.0);
        let mismatch = size("servo-mismatch", "mismatch");
        let names = [
            ["backlash-x", "elastic-lost-motion-x", "gain-with-feed-x"],
            ["backlash-y", "elastic-lost-motion-y", "gain-with-feed-y"],
        ];
        [0, 1].map(|i| {
            let [play, winding, changes] = names[i];
            let friction = size(winding, "friction");
            let seat = value(causes, winding, "stiffness").map_or(0.0, |k| 1.0 / k);
            let screw = self.screws.map(|screws| screws[i]);
            let nut = screw.and_then(|s| s.nut).map_or(0.0, |(side, preload)| side.pair_moves(preload, friction));
            let lost = Lost {
                // Play and what friction winds up stand in series: one joint, crossed where the drive turns round.
                half: 1e-3 * (0.5 * size(play, "gap") + friction * seat + nut),
                growth: screw.map_or(0.0, |s| friction / (YOUNGS_MODULUS * 0.25 * PI * s.diameter * s.diameter)),
                bearing: screw.map_or(0.0, |s| s.fixed_at),
            };
            let change = size(changes, "change") / (self.feed / 60.0);
            let gain = self.gain * (1.0 + [0.5, -0.5][i] * mismatch);
            Axis { radius: self.radius, speed: row.feed / 60.0 / self.radius, gain, change, lost }
        })
    }

    /// What a row shows without noise, um.
    fn deviation(&self, causes: &[Cause], row: &Row, lap: Option<&[Lap; 2]>) -> f64 {
        let size = |effect: &str, parameter: &str| value(causes, effect, parameter).unwrap_or(0.0);
        let round = if row.clockwise { -1.0 } else { 1.0 };
        let angle = row.angle.to_radians();
        let (sine, cosine) = angle.sin_cos();
        // The command's own turn since the lap began at 0°; y follows a quarter behind it, or goes ahead.
        let turned = (round * angle).rem_euclid(TAU);
        let axes = self.axes(causes, row);
        let phases = [turned, turned - round * FRAC_PI_2];
        let [x, y] = [0, 1].map(|i| lap.map_or_else(|| axes[i].at(phases[i]), |laps| laps[i].at(phases[i])));
        let time = turned / axes[0].speed;
        let wave = |effect: &str, at: f64| size(effect, "amplitude") * (at + size(effect, "phase").to_radians()).sin();
        // What the screw is wrong by where the slide has come to, and how the drive jerks.
        let own = |state: State, [cyclic, stick]: [&str; 2]| {
            let turns = self.lead.map_or(0.0, |lead| TAU * state.place / lead);
            let jerks = self.frequency.map_or(0.0, |f| TAU * f * time);
            state.place + 1e-3 * (wave(cyclic, turns) + wave(stick, jerks))
        };
        let half = 0.5e-6 * size("scale-mismatch", "mismatch");
        let x_at = (1.0 + half) * own(x, ["cyclic-error-x", "stick-slip-x"]);
        let y_at = (1.0 - half) * own(y, ["cyclic-error-y", "stick-slip-y"]);
        let [across, along] = self.cut.unwrap_or_default();
        // um from N and N/um.
        let gives = |parameter, force: f64| value(causes, "cutting-deflection", parameter).map_or(0.0, |k| force / k);
        let right = size("centre-offset", "x") + gives("stiffness_x", across * cosine + round * along * sine);
        let up = size("centre-offset", "y") + gives("stiffness_y", across * sine - round * along * cosine);
        let tool = [x_at + 1e-6 * size("squareness", "angle") * y_at + 1e-3 * right, y_at + 1e-3 * up];
        let spike = |effect, since: f64| {
            let fade = value(causes, effect, "time_constant").unwrap_or(1.0);
            size(effect, "height") * (-1e3 * since / fade).exp()
        };
        1e3 * (tool[0].hypot(tool[1]) - self.radius)
            + spike("reversal-spike-x", x.since) * cosine.abs()
            + spike("reversal-spike-y", y.since) * sine.abs()
    }
}
