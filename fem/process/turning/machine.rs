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

/// How far the edge has drawn back after a cutting path, both in m.
pub type Wear = Box<dyn Fn(f64) -> f64 + Send + Sync>;

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
    /// Changes of diameter that add up: what moves the nose across, in the plane of the axis.
    pub shifts: Vec<Shift>,
    /// What moves the nose up or down, out of that plane, m.
    pub lifts: Vec<Shift>,
    /// What wears the edge back; each shows twice on the diameter.
    pub wears: Vec<Wear>,
    /// Why an effect cannot be computed; the machine then predicts nothing.
    pub failure: Option<Failure>,
}

impl Machine {
    /// The ideal machine: rigid, cold and sharp. Only the tool holder of the model yields.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let carriage = Joint { spring_compliance: setup.holder_compliance, contacts: Vec::new() };
        let hold = setup.hold();
        let (headstock, tailstock) = (Joint::default(), Joint::default());
        Self {
            setup,
            headstock,
            tailstock,
            carriage,
            hold,
            feedback: None,
            shifts: Vec::new(),
            lifts: Vec::new(),
            wears: Vec::new(),
            failure: None,
        }
    }

    /// Adds a change of diameter, m.
    pub fn add_shift(&mut self, shift: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.shifts.push(Box::new(shift));
    }

    /// Moves the nose up, m.
    pub fn add_lift(&mut self, lift: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.lifts.push(Box::new(lift));
    }

    /// Wears the edge back along the cutting path, m.
    pub fn add_wear(&mut self, wear: impl Fn(f64) -> f64 + Send + Sync + 'static) {
        self.wears.push(Box::new(wear));
    }

    /// How far the edge has drawn back after a cutting path (m), m.
    pub fn wear(&self, path: f64) -> f64 {
        self.wears.iter().map(|by| by(path)).sum()
    }

    /// Everything but force that changes the diameter at a moment, m: the nose stands at √(r² + z²) from the axis,
    /// with all that moves it across in r and all that moves it up in z [seed 002 (2), (3)].
    pub fn shift_at(&self, moment: &Moment) -> f64 {
        let all = |moves: &[Shift]| moves.iter().map(|by| by(moment)).sum::<f64>();
        let (across, up) = (all(&self.shifts) + 2.0 * self.wear(moment.path), 2.0 * all(&self.lifts));
        let diameter = moment.diameter + across;
        // √(D² + z²) − D without the loss of digits in the difference.
        let raised = if up == 0.0 { 0.0 } else { up * up / (diameter.hypot(up) + diameter) };
        across + raised
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
