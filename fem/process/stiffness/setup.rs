//! The tables of a stiffness model.

use crate::input::Reader;
use crate::units::{FORCE, STIFFNESS};

/// Everything a stiffness model says but its effects. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// Stiffness k of the ideal joint, N/m.
    pub stiffness: f64,
    /// Force at which loading ends, N.
    pub max_force: f64,
    /// Steps from no force to the largest, and as many back.
    pub steps: usize,
}

impl Setup {
    /// Reads every table of a stiffness model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let stiffness = model.table("joint", "the joint, or the machine as a whole", |t| {
            t.quantity("stiffness", STIFFNESS, "stiffness of the ideal joint").positive().required()
        });
        let (max_force, steps) = model.table("test", "how it is loaded and unloaded", |t| {
            let max_force = t.quantity("max_force", FORCE, "force at which loading ends").positive().required();
            (max_force, t.count("steps", "steps up to it, and down again").between(1, 1_000_000).or(20))
        });
        Self { stiffness, max_force, steps }
    }

    /// Forces of the programme, rising, N.
    pub fn forces(&self) -> Vec<f64> {
        (0..=self.steps).map(|i| self.max_force * (i as f64 / self.steps as f64)).collect()
    }
}
