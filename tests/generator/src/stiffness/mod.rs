//! Joints under a load that rises and falls. The force that a joint transmits is followed along the way of the
//! load, as the joint itself goes, where the program has closed forms of each branch.

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
use crate::preload::Side;
use crate::random::Random;

/// Displacements (um) of joints.
pub const STIFFNESS: Process = Process {
    name: "stiffness ",
    laws: LAWS,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    never_together: &[["gap", "preload"]],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// Structure outside the catalogue.
const SHAPES: &[&str] = &["ripple over the force", "a slip", "a slip back", "a drift of the gauge", "one reading"];

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// N.
    pub force: f64,
    /// On the way down.
    pub unload: bool,
}

/// How the force goes before it is read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Loading {
    /// From nothing, for the first time.
    #[default]
    FromZero,
    /// Between both signs of the largest, which it has done before.
    Reversed,
}

/// A joint with its test.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// N/um.
    pub stiffness: f64,
    /// N.
    pub max_force: f64,
    /// From where the force rises.
    pub loading: Loading,
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

    fn admits(&self, effect: &str, _causes: &[Cause]) -> bool {
        // In a loop that has been gone through before nothing settles.
        effect != "settling" || self.loading == Loading::FromZero
    }

    fn length(&self) -> f64 {
        self.max_force
    }

    fn draws(&self, effect: &str) -> usize {
        if effect == "contact-joint" { 8 } else { 4 }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let joint = Joint::of(self, causes);
        self.rows.iter().map(|row| joint.moves(&self.way_to(row), self.max_force)).collect()
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
    /// Forces between which the force has gone straight, up to a reading; the first from a joint at rest.
    fn way_to(&self, row: &Row) -> Vec<f64> {
        let most = self.max_force;
        let mut way = if self.loading == Loading::Reversed { vec![most, -most] } else { Vec::new() };
        // The turn is at the largest force, read or not.
        way.extend(row.unload.then_some(most));
        way.push(row.force);
        way
    }
}

/// What the causes make of a joint, N and um.
struct Joint {
    side: Side,
    friction: f64,
    gap: f64,
    preload: f64,
    depth: f64,
    offset: f64,
}

impl Joint {
    fn of(job: &Job, causes: &[Cause]) -> Self {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let exponent = value(causes, "contact-joint", "n");
        Self {
            side: Side { stiffness: Some(job.stiffness), contact: exponent.map(|n| (size("contact-joint", "c"), n)) },
            friction: size("dry-friction", "force"),
            gap: size("gap", "gap"),
            preload: size("preload", "force"),
            depth: size("settling", "depth"),
            offset: size("datum-offset", "offset"),
        }
    }

    /// Where the joint stands at the end of a way of the force. Friction comes first: what the joint transmits
    /// lags behind the force by no more than f. What is transmitted bends spring and contact, settles them, and
    /// crosses the gap where it changes its sign.
    fn moves(&self, way: &[f64], most: f64) -> f64 {
        let (mut transmitted, mut settled): (f64, f64) = (0.0, 0.0);
        for force in way {
            transmitted = transmitted.clamp(force - self.friction, force + self.friction);
            settled = settled.max(self.depth * transmitted / most);
        }
        let crossed = if transmitted > 0.0 && self.preload == 0.0 { self.gap } else { 0.0 };
        transmitted.signum() * self.gives(transmitted.abs()) + settled + crossed + self.offset
    }

    /// How far the joint gives way under a force, alone or pressed against its like.
    fn gives(&self, force: f64) -> f64 {
        if self.preload == 0.0 { self.side.approach(force) } else { self.side.pair_moves(self.preload, force) }
    }
}
