//! Bored rings, by other numerics than the program under test: every harmonic of the jaws' pressure is a
//! boundary value problem in the radius, solved by Chebyshev collocation of the equations of equilibrium,
//! instead of finite elements or Michell's closed terms.

pub mod asked;
pub mod catalogue;
pub mod design;
pub mod elastic;
pub mod job;
pub mod scenes;
pub mod writing;

use std::f64::consts::TAU;

use catalogue::LAWS;
use job::{Job, Row, SetUp};

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::random::Random;

/// Deviations of bored rings, um.
pub const RING: Process = Process {
    name: "ring ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    // The one is of three jaws, the other of four and more.
    never_together: &[["jaw-position", "jaw-imbalance"]],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// Structure outside the catalogue.
const SHAPES: &[&str] = &[
    "lobes",
    "one bad set-up",
    "lobes that turn from set-up to set-up",
    "a dent",
    "a spiral",
    "a flat",
    "lobes in one set-up",
];

impl crate::job::Job for Job {
    fn process(&self) -> &'static str {
        "ring"
    }

    fn laws(&self) -> &'static [Law] {
        LAWS
    }

    fn shown(&self) -> &[Shown] {
        &self.shown
    }

    fn forget(&mut self) {
        self.shown.clear();
    }

    fn noise(&self) -> NoiseKind {
        self.noise
    }

    fn groups(&self) -> Vec<usize> {
        self.rows.iter().map(|row| row.set_up).collect()
    }

    fn rows(&self) -> usize {
        self.rows.len()
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.03, 3.0)
    }

    fn blind(&self) -> Vec<Vec<f64>> {
        if self.absolute {
            return Vec::new();
        }
        let shapes: [fn(f64) -> f64; 3] = [|_| 1.0, f64::cos, f64::sin];
        let one = |set_up: usize, shape: fn(f64) -> f64| {
            let at = |row: &Row| if row.set_up == set_up { shape(row.angle.to_radians()) } else { 0.0 };
            self.rows.iter().map(at).collect()
        };
        (0..self.set_ups.len()).flat_map(|s| shapes.map(|shape| one(s, shape))).collect()
    }

    fn admits(&self, effect: &str, _causes: &[Cause]) -> bool {
        match effect {
            "jaw-position" => self.jaws == 3,
            "jaw-imbalance" => self.jaws >= 4 && self.jaws.is_multiple_of(2),
            "cutting-heat" | "chuck-runout" => self.absolute,
            _ => true,
        }
    }

    fn length(&self) -> f64 {
        0.0
    }

    fn draws(&self, effect: &str) -> usize {
        match effect {
            "residual-stress" | "spindle-error" | "jaw-position" | "chuck-runout" => 20,
            _ => 6,
        }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let squeezed: Vec<Vec<(f64, f64)>> = self.set_ups.iter().map(|own| self.squeezed(causes, own)).collect();
        self.rows.iter().map(|row| self.deviation(causes, row, at(&squeezed[row.set_up], row.angle))).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let name = random.pick(SHAPES);
        // Two lobes and multiples of the jaws are what the catalogue makes.
        let lobes = random.pick(&[4usize, 5, 7, 8, 10]);
        let lobes = if lobes.is_multiple_of(self.jaws) { lobes + 1 } else { lobes } as f64;
        let (phase, bad) = (random.uniform(0.0, TAU), random.whole(0, self.set_ups.len() - 1));
        let (turn, wide) = (random.uniform(0.6, 2.0), random.uniform(0.15, 0.4));
        let shape = |row: &Row| {
            let angle = row.angle.to_radians();
            let off = (angle - phase + 2.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            let here = f64::from(row.set_up == bad);
            match name {
                "lobes" => (lobes * angle - phase).cos(),
                "one bad set-up" => here * (2.0 * angle - phase).cos(),
                "lobes that turn from set-up to set-up" => (lobes * angle - phase - turn * row.set_up as f64).cos(),
                "a dent" => (-0.5 * (off / wide).powi(2)).exp(),
                "a spiral" => angle / TAU - 0.5,
                "a flat" => ((off.cos() - wide.cos()) / (1.0 - wide.cos())).max(0.0),
                _ => here * (lobes * angle - phase).cos(),
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
    /// u_r of the bore in a set-up, um: amplitudes of cos and sin of 0, 1, 2 … waves around.
    fn squeezed(&self, causes: &[Cause], set_up: &SetUp) -> Vec<(f64, f64)> {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let arc = size("jaw-contact-arc", "arc").to_radians();
        let errors = ["error_2", "error_3"].map(|error| size("jaw-position", error).to_radians());
        let places: Vec<f64> = (0..self.jaws)
            .map(|k| TAU * k as f64 / self.jaws as f64 + if (1..3).contains(&k) { errors[k - 1] } else { 0.0 })
            .collect();
        // Each jaw is pulled outwards by what its own mass weighs in the turn.
        let speed = if set_up.clamped { 0.0 } else { set_up.speed * TAU / 60.0 };
        let thrown = 1e-3 * size("centrifugal-unloading", "jaw_moment") * speed * speed;
        let more = 0.01 * size("jaw-imbalance", "difference") * set_up.force;
        let tightened = |k: usize| set_up.force + if k.is_multiple_of(2) { 0.5 * more } else { -0.5 * more };
        let forces: Vec<f64> =
            (0..).zip(shares(&places)).map(|(k, share)| share * (tightened(k) - thrown).max(0.0)).collect();
        // Compliances are of a ring with E = b = Ro = 1.
        let scale = 1e6 / (self.modulus * 1e9 * self.width * 1e-3);
        let wave = |m: usize| {
            let half = 0.5 * m as f64 * arc;
            let spread = if half == 0.0 { 1.0 } else { half.sin() / half };
            let sum = |part: fn(f64) -> f64| -> f64 {
                places.iter().zip(&forces).map(|(place, force)| force * part(m as f64 * place)).sum()
            };
            let factor = scale * self.compliances[m] * spread * if m == 0 { 1.0 } else { 2.0 } / TAU;
            (factor * sum(f64::cos), factor * sum(f64::sin))
        };
        (0..self.compliances.len()).map(wave).collect()
    }

    /// What a row shows without noise, um. The nose is set to s outwards and finds the bore where it is while the
    /// ring is cut, at b = blank + squeezed + hot + aside; it yields by k·(s − b), k = C/(C + j), and leaves
    /// s − k·(s − b), which then goes back to the ring let go, cold, and on its own axis. What stresses that
    /// lasted do when they are let go comes after all of that.
    fn deviation(&self, causes: &[Cause], row: &Row, squeezed: f64) -> f64 {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let set_up = &self.set_ups[row.set_up];
        if set_up.clamped {
            // At standstill, before the cut: the jaws alone.
            return squeezed;
        }
        let angle = row.angle.to_radians();
        let wave = |effect, amplitude: f64, lobes: f64, turned: f64| {
            amplitude * (lobes * (angle - turned - size(effect, "phase").to_radians())).cos()
        };
        let hot = self.expansion * 1e-6 * self.inner * 1e3 * size("cutting-heat", "temperature_rise");
        let aside = wave("chuck-runout", 0.5 * size("chuck-runout", "runout"), 1.0, 0.0);
        let moved = squeezed + hot + aside;
        let set = row.change + wave("spindle-error", size("spindle-error", "amplitude"), 2.0, 0.0);
        // N/um from kN/mm: the same number.
        let copies =
            value(causes, "copying", "stiffness").map_or(0.0, |j| self.force_per_depth / (self.force_per_depth + j));
        let bored = set - copies * (set - (row.blank + moved));
        let stress = size("residual-stress", "amplitude");
        bored - moved + wave("residual-stress", stress, 2.0, set_up.orientation.to_radians())
    }
}

/// The sum of waves at an angle, deg.
fn at(waves: &[(f64, f64)], angle: f64) -> f64 {
    let angle = angle.to_radians();
    (0..).zip(waves).map(|(m, (c, s))| c * (f64::from(m) * angle).cos() + s * (f64::from(m) * angle).sin()).sum()
}

/// Forces of three jaws that can be in equilibrium, from the two equations of the resultant: Σ s cos φ = Σ
/// s sin φ = 0, Σ s = 3.
fn shares(places: &[f64]) -> Vec<f64> {
    if places.len() != 3 {
        return vec![1.0; places.len()];
    }
    let row = |part: fn(f64) -> f64| places.iter().map(|p| part(*p)).collect::<Vec<f64>>();
    crate::dense::solve(vec![row(f64::cos), row(f64::sin), row(|_| 1.0)], vec![0.0, 0.0, 3.0])
}
