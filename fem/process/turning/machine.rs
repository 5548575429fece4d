//! The machine as effects shape it: joints that yield, and everything that shifts the tool against the work.

use std::sync::Arc;

use super::setup::Setup;
use crate::joint::Joint;
use crate::process::{self, Failure};
use crate::solve::Hold;

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// Place and time at which a point of a part is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Distance from the headstock, m.
    pub x: f64,
    /// Finished diameter there, m.
    pub diameter: f64,
    /// Time since the start of the batch, s.
    pub time: f64,
    /// Cutting path of the tool so far, m.
    pub path: f64,
}

/// A change of diameter that does not depend on the force, m.
pub type Shift = Box<dyn Fn(&Moment) -> f64 + Send + Sync>;

/// A lathe with its effects. Effects act on it by yielding at a joint, by tilting the chuck, by feeding the
/// deflection back into the force, or by adding a shift.
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Support at x = 0.
    pub headstock: Joint,
    /// Support at x = L.
    pub tailstock: Joint,
    /// Tool and slide.
    pub carriage: Joint,
    /// Rotation at the headstock.
    pub hold: Hold,
    /// Exponent of the force in the depth actually cut; `None` where the force stays as set.
    pub feedback: Option<f64>,
    /// Changes of diameter that add up.
    pub shifts: Vec<Shift>,
    /// Why an effect cannot be computed; the machine then predicts nothing.
    pub failure: Option<Failure>,
}

impl Machine {
    /// The ideal machine: rigid, cold and sharp. Only the tool holder of the model yields.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let carriage = Joint { spring_compliance: setup.holder_compliance, contacts: Vec::new() };
        let hold = setup.hold();
        let (headstock, tailstock) = (Joint::default(), Joint::default());
        Self { setup, headstock, tailstock, carriage, hold, feedback: None, shifts: Vec::new(), failure: None }
    }

    /// Adds a change of diameter, m.
    pub fn add_shift(&mut self, shift: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.shifts.push(Box::new(shift));
    }

    /// Everything but force that changes the diameter at a moment, m.
    pub fn shift_at(&self, moment: &Moment) -> f64 {
        self.shifts.iter().map(|shift| shift(moment)).sum()
    }

    /// The same when the tool is at `x` on `part` by the schedule of the model.
    pub fn shift_on(&self, part: usize, x: f64) -> f64 {
        let Setup { schedule, .. } = &*self.setup;
        let (time, path) = (schedule.time(part, x), schedule.path(part, x));
        self.shift_at(&Moment { x, diameter: self.setup.diameter(x), time, path })
    }

    /// Whether the deflection changes the force.
    pub fn feeds_back(&self) -> bool {
        self.feedback.is_some_and(|exponent| exponent != 0.0)
    }
}
