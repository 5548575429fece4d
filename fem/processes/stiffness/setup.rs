//! The tables of a stiffness model.

use std::sync::Arc;

use super::allowed::ALLOWED;
use super::base::Base;
use crate::input::Reader;
use crate::process::{Allowed, estimates};
use crate::units::{FORCE, STIFFNESS};

/// Most readings that are predicted.
const MOST_POINTS: usize = 500_000;

/// Where the force goes from its largest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loading {
    /// Back to no force, from which it rose first.
    FromZero,
    /// On to the same force of the other sign, and round again: the loop of a force that has been round before.
    Reversed,
}

impl Loading {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("from-zero", Self::FromZero), ("reversed", Self::Reversed)];
}

/// Everything a stiffness model says but its effects. SI units.
#[derive(Clone)]
pub struct Setup {
    /// Stiffness k of the ideal joint, N/m; infinite where a structure is pushed without one.
    pub stiffness: f64,
    /// The machine that is pushed, if it is drawn.
    pub base: Option<Arc<Base>>,
    /// The unit of a machine that the joint is, where it is one.
    pub unit: Option<String>,
    /// Force at which loading ends, N.
    pub max_force: f64,
    /// Steps from no force to the largest, and as many back.
    pub steps: usize,
    /// Where the force goes from its largest.
    pub loading: Loading,
    /// What the drawing allows.
    pub allowed: Allowed,
}

impl Setup {
    /// Reads every table of a stiffness model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let base = Base::read(model).map(Arc::new);
        let read_joint = |t: &Reader| {
            let stiffness =
                t.quantity("stiffness", STIFFNESS, "stiffness of the ideal joint").estimated(estimates::STIFFNESS);
            let stiffness = stiffness.positive().required();
            (stiffness, t.text("unit", "the unit of the machine that is loaded, as its file names it: \"tailstock\""))
        };
        // Beside a structure it is the joint that passes the force on, and there need be none.
        const JOINT: &str = "the joint, or the machine as a whole";
        let (stiffness, unit) = match model.has("structure") {
            true => model.optional_table("joint", JOINT, read_joint).unwrap_or((f64::INFINITY, None)),
            false => model.table("joint", JOINT, read_joint),
        };
        if model.is_described() {
            model.may_be_left_out("joint");
        }
        let (max_force, steps, loading) = model.table("test", "how it is loaded and unloaded", |t| {
            let max_force = t.quantity("max_force", FORCE, "force at which loading ends").positive().required();
            let steps = t.count("steps", "steps up to it, and down again").between(1, 1_000_000).or(20);
            let about = "whether the force is let go at zero, or runs on to the other sign and back";
            (max_force, steps, t.choice("loading", about, Loading::WORDS).or_first(Loading::FromZero))
        });
        let about = "what the displacement is held against";
        let allowed = model.optional_table("tolerance", about, |t| Allowed::read(t, &ALLOWED)).unwrap_or_default();
        let own = Self { stiffness, base, unit, max_force, steps, loading, allowed };
        let pairs = own.base.as_ref().map_or(1, |base| base.loads.len() * base.dials.len());
        let steps = if loading == Loading::Reversed { 2 * steps } else { steps };
        let points = (2 * steps).saturating_mul(pairs);
        if points > MOST_POINTS {
            let message = format!("{points} readings, up and down at every place, are more than {MOST_POINTS}");
            model.problem("test", message, "take fewer steps");
        }
        own
    }

    /// Forces of the programme, rising, N.
    pub fn forces(&self) -> Vec<f64> {
        let last = self.steps as i64;
        let first = match self.loading {
            Loading::FromZero => 0,
            Loading::Reversed => -last,
        };
        (first..=last).map(|i| self.max_force * (i as f64 / last as f64)).collect()
    }
}
