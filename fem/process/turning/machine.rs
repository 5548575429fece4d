//! The machine as effects shape it: joints that yield, and everything that shifts the tool against the work.

use std::sync::Arc;

use super::model::Setup;
use crate::joint::{Contact, Joint};
use crate::process::Failure;
use crate::solve::Hold;

/// Where and when a point of a part is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// From the headstock, m.
    pub x: f64,
    /// Finished diameter there, m.
    pub diameter: f64,
    /// Since the start of the batch, s.
    pub time: f64,
    /// Cutting path of the tool so far, m.
    pub path: f64,
}

/// A change of diameter that does not depend on the force, m.
pub type Shift = Box<dyn Fn(&Moment) -> f64 + Send + Sync>;

/// A lathe with its effects. Effects act on it by yielding at a joint, by tilting the chuck, by feeding the
/// deflection back into the force, or by adding a shift.
pub struct Machine {
    /// What the model says.
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
    pub fn shift(&mut self, shift: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.shifts.push(Box::new(shift));
    }
}

impl Joint {
    /// Puts a spring of `stiffness` N/m in series; infinite changes nothing.
    pub fn soften(&mut self, stiffness: f64) {
        self.spring_compliance += 1.0 / stiffness;
    }

    /// Puts a contact y = c·Qⁿ in series; c = 0 changes nothing.
    pub fn add_contact(&mut self, coefficient: f64, exponent: f64) {
        if coefficient != 0.0 {
            self.contacts.push(Contact { coefficient, exponent });
        }
    }
}
