//! Joints under a load that rises and falls. The displacement is followed step by step along the force, as
//! the joint itself goes, where the program has closed forms of each branch.

pub mod catalogue;
pub mod design;
pub mod writing;

use std::f64::consts::TAU;

use catalogue::LAWS;

use crate::Process;
use crate::job::{NoiseKind, Shown};
use crate::law::{Cause, Law, value};
use crate::random::Random;

/// Displacements (um) of joints.
pub const STIFFNESS: Process = Process {
    name: "stiffness ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[["gap", "preload"]],
};

/// Structure outside the catalogue.
const SHAPES: &[&str] = &["ripple over the force", "a slip", "a slip back", "a drift of the gauge", "one reading"];

/// Halves to nothing that a gauge would show.
const HALVES: usize = 40;

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// N.
    pub force: f64,
    /// On the way down.
    pub unload: bool,
}

/// A joint with its test.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// N/um.
    pub stiffness: f64,
    /// N.
    pub max_force: f64,
    /// Readings in their order.
    pub rows: Vec<Row>,
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows with `+-`.
    pub shown: Vec<Shown>,
}

impl crate::job::Job for Job {
    crate::job::of_fields!("stiffness");

    fn noise_range(&self) -> (f64, f64) {
        (0.02, 1.5)
    }

    fn admits(&self, _effect: &str, _causes: &[Cause]) -> bool {
        true
    }

    fn length(&self) -> f64 {
        self.max_force
    }

    fn draws(&self, effect: &str) -> usize {
        if effect == "contact-joint" { 8 } else { 4 }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let joint = Joint::of(self, causes);
        // Forces on the spring over the whole loop, from what friction leaves of each rise and fall.
        let mut spring: f64 = 0.0;
        let mut settled: f64 = 0.0;
        let mut seen = Vec::with_capacity(self.rows.len());
        for (row, top) in self.rows.iter().map(|row| (row, self.max_force)) {
            if row.unload && seen.iter().all(|(was, _): &(bool, f64)| !was) {
                // The turn is at the largest force, read or not.
                spring = spring.max(top - joint.friction);
                settled = settled.max(joint.depth * spring / self.max_force);
            }
            // Friction lets the spring go no further than f on either side of the force.
            spring = spring.clamp(row.force - joint.friction, row.force + joint.friction).max(0.0);
            settled = settled.max(joint.depth * spring / self.max_force);
            let open = if row.force > 0.0 && joint.preload == 0.0 { joint.gap } else { 0.0 };
            seen.push((row.unload, joint.spring(spring) + settled + open + joint.offset));
        }
        seen.into_iter().map(|(_, y)| y).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let name = random.pick(SHAPES);
        let (periods, phase, at) = (random.uniform(2.5, 6.0), random.uniform(0.0, TAU), random.uniform(0.35, 0.65));
        let (row_at, count) = (random.whole(0, self.rows.len() - 1), self.rows.len() as f64);
        let shape = |(number, row): (usize, &Row)| {
            let part = row.force / self.max_force;
            match name {
                "ripple over the force" => (TAU * periods * part + phase).sin(),
                "a slip" => f64::from(row.unload || part > at),
                "a slip back" => f64::from(row.unload && part < at),
                "a drift of the gauge" => (number as f64 / count).powi(2),
                _ => f64::from(number == row_at),
            }
        };
        (name, self.rows.iter().enumerate().map(shape).collect())
    }

    fn tables(&self) -> String {
        writing::tables(self)
    }

    fn data(&self, observed: &[f64], sigma: f64) -> String {
        writing::data(self, observed, sigma)
    }
}

/// What the causes make of a joint, N and um.
struct Joint {
    stiffness: f64,
    friction: f64,
    gap: f64,
    preload: f64,
    contact: Option<(f64, f64)>,
    depth: f64,
    offset: f64,
}

impl Joint {
    fn of(job: &Job, causes: &[Cause]) -> Self {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let exponent = value(causes, "contact-joint", "n");
        Self {
            stiffness: job.stiffness,
            friction: size("dry-friction", "force"),
            gap: size("gap", "gap"),
            preload: size("preload", "force"),
            contact: exponent.map(|n| (size("contact-joint", "c"), n)),
            depth: size("settling", "depth"),
            offset: size("datum-offset", "offset"),
        }
    }

    /// How far the joint gives way under a force. Pressed by a preload against its like, it moves to where the
    /// force that closes the one side less the force that is left on the other is the outer force: looked for
    /// by halving along the movement.
    fn spring(&self, force: f64) -> f64 {
        if self.preload == 0.0 {
            return self.approach(force);
        }
        let pressed = self.approach(self.preload);
        halved(self.approach(force), |y| self.closing(pressed + y) - self.closing(pressed - y) > force)
    }

    /// What one side approaches under a force.
    fn approach(&self, force: f64) -> f64 {
        let contact = self.contact.map_or(0.0, |(c, n)| if force > 0.0 { c * (n * force.ln()).exp() } else { 0.0 });
        force / self.stiffness + contact
    }

    /// The force under which one side approaches by so much, nothing where it is open.
    fn closing(&self, approach: f64) -> f64 {
        halved((self.stiffness * approach).max(0.0), |force| self.approach(force) > approach)
    }
}

/// Where `is_beyond` begins between zero and `high`.
fn halved(mut high: f64, is_beyond: impl Fn(f64) -> bool) -> f64 {
    let mut low = 0.0;
    for _ in 0..HALVES {
        let middle = 0.5 * (low + high);
        if is_beyond(middle) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}
