//! The machine as effects shape it: joints that yield, and everything that shifts the tool against the work.

use std::sync::Arc;

use super::setup::Setup;
use crate::joint::Joint;
use crate::process::{self, Command, Failure};
use crate::solve::{Hold, Shaft};

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// Place, part and time at which a point is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Distance from the headstock, m.
    pub x: f64,
    /// Finished diameter there, m.
    pub diameter: f64,
    /// Number of the part, from 1.
    pub part: usize,
    /// Time since the start of the batch, s.
    pub time: f64,
    /// Cutting path of the insert so far, m.
    pub path: f64,
}

/// A displacement or a change of diameter that does not depend on the force, m.
pub type Shift = Box<dyn Fn(&Moment) -> f64 + Send + Sync>;

/// How far the edge has drawn back after a cutting path, both in m.
pub type Wear = Box<dyn Fn(f64) -> f64 + Send + Sync>;

/// A change of the insert of which no list tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Renewal {
    /// Number of the part after which it was.
    pub after: f64,
    /// Part of the wear that goes with the old edge.
    pub share: f64,
}

/// A support of the shaft whose place effects move, or beside which friction holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// At x = 0.
    Headstock,
    /// At x = L.
    Tailstock,
}

/// Where the nose stands on a diameter, by all that does not ask for the force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nose {
    /// Twice the way across, in the plane of the axis, m.
    pub across: f64,
    /// Twice the way up, out of that plane, m.
    pub up: f64,
}

impl Nose {
    /// The diameter error (m) that it leaves where nose and work are moved apart by a gap (m) besides, and what the
    /// error grows by with the gap: it stands at √(r² + z²) from the axis, with all that moves it across in r and all
    /// that moves it up in z [seed 002 (2), (3)].
    pub fn error(&self, diameter: f64, gap: f64) -> (f64, f64) {
        let across = self.across + 2.0 * gap;
        if self.up == 0.0 {
            return (across, 2.0);
        }
        let moved = diameter + across;
        let whole = moved.hypot(self.up);
        // √(D² + z²) − D without the loss of digits in the difference.
        (across + self.up * self.up / (whole + moved), 2.0 * moved / whole)
    }
}

/// A lathe with its effects. Effects act on it by yielding at a joint, by tilting the chuck, by moving a support, by
/// feeding back into the force what the nose leaves of the depth, or by moving the nose.
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
    /// Dry friction beside the joints of headstock and tailstock, N.
    pub friction: [f64; 2],
    /// Displacements of headstock and tailstock away from the tool, m.
    displaced: [Vec<Shift>; 2],
    /// Displacement of all steady rests out of line besides their own offsets, m.
    pub rests_offset: f64,
    /// Exponent of the force in the depth actually cut; `None` where the force stays as set.
    pub feedback: Option<f64>,
    /// Changes of diameter that add up: what moves the nose across, in the plane of the axis.
    pub shifts: Vec<Shift>,
    /// Movements of the nose up or down, out of that plane, m.
    pub lifts: Vec<Shift>,
    /// Wear of the edge; each shows twice on the diameter.
    pub wears: Vec<Wear>,
    /// Changes of the insert beside those of the schedule.
    pub renewals: Vec<Renewal>,
    /// What is added to the radius that the last pass is programmed to.
    pub command: Option<Arc<Command>>,
    /// Why an effect cannot be computed; the machine then predicts nothing.
    pub failure: Option<Failure>,
}

impl Machine {
    /// The ideal machine: rigid, cold and sharp. Only the tool holder of the model yields, and the nose stands where it
    /// was set between parts.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let carriage = Joint { spring_compliance: setup.holder_compliance, contacts: Vec::new() };
        let hold = setup.hold();
        let (headstock, tailstock) = (Joint::default(), Joint::default());
        let mut machine = Self {
            setup: setup.clone(),
            headstock,
            tailstock,
            carriage,
            hold,
            friction: [0.0; 2],
            displaced: [Vec::new(), Vec::new()],
            rests_offset: 0.0,
            feedback: None,
            shifts: Vec::new(),
            lifts: Vec::new(),
            wears: Vec::new(),
            renewals: Vec::new(),
            command: None,
            failure: None,
        };
        if !(setup.schedule.events.corrections.is_empty() && setup.schedule.events.inserts.is_empty()) {
            machine.add_shift(move |at| setup.schedule.correction(at.part));
        }
        machine
    }

    /// Adds a change of diameter, m.
    pub fn add_shift(&mut self, shift: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.shifts.push(Box::new(shift));
    }

    /// Moves a support away from the tool, m.
    pub fn displace(&mut self, support: Support, displacement: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.displaced[support as usize].push(Box::new(displacement));
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

    /// How far the edge that cuts at a moment has drawn back, m.
    fn wear_at(&self, moment: &Moment) -> f64 {
        let worn = self.wear(moment.path);
        let schedule = &self.setup.schedule;
        // An insert that was changed again since is none of the schedule's.
        let acts = |r: &&Renewal| r.after < moment.part as f64 && r.after > schedule.new_since(moment.part) as f64;
        let renewed = self.renewals.iter().filter(acts).map(|renewal| {
            let before = schedule.path(renewal.after as usize, schedule.pass.to);
            renewal.share * (self.wear((moment.path - before).max(0.0)) - worn)
        });
        worn + renewed.sum::<f64>()
    }

    /// Where the nose stands at a moment of the last pass.
    pub fn nose_at(&self, moment: &Moment) -> Nose {
        let across = all(&self.shifts, moment) + 2.0 * self.wear_at(moment) + self.commanded_at(moment);
        Nose { across, up: 2.0 * all(&self.lifts, moment) }
    }

    /// What a correction of the last pass adds to the diameter at a moment, m.
    pub fn commanded_at(&self, moment: &Moment) -> f64 {
        self.command.as_ref().map_or(0.0, |command| 2.0 * command.at(moment.x, &[moment.part as f64]))
    }

    /// How far headstock and tailstock stand from their places at a moment, away from the tool, m.
    pub fn displacements_at(&self, moment: &Moment) -> [f64; 2] {
        [all(&self.displaced[0], moment), all(&self.displaced[1], moment)]
    }

    /// Place and time of x on `part` by the schedule of the model.
    pub fn moment_on(&self, part: usize, x: f64) -> Moment {
        let Setup { schedule, .. } = &*self.setup;
        let (time, path) = (schedule.time(part, x), schedule.path(part, x));
        Moment { x, diameter: self.setup.diameter(x), part, time, path }
    }

    /// Whether the gap at a place is another one at another time.
    pub fn gap_changes(&self) -> bool {
        self.feeds_back() || self.displaced.iter().any(|displaced| !displaced.is_empty())
    }

    /// The shaft as the machine holds it.
    pub fn shaft(&self) -> Shaft {
        let mut shaft = self.setup.shaft(self.hold);
        shaft.rests.iter_mut().for_each(|rest| rest.offset += self.rests_offset);
        shaft
    }

    /// Whether friction holds a joint that yields: what it has been through then counts.
    pub fn rubs(&self) -> bool {
        let yields = |joint: &Joint| joint.spring_compliance > 0.0 || !joint.contacts.is_empty();
        let joints = [&self.headstock, &self.tailstock];
        joints.iter().zip(self.friction).any(|(joint, friction)| friction > 0.0 && yields(joint))
    }

    /// Whether the deflection changes the force.
    pub fn feeds_back(&self) -> bool {
        self.feedback.is_some_and(|exponent| exponent != 0.0)
    }
}

fn all(moves: &[Shift], moment: &Moment) -> f64 {
    moves.iter().map(|by| by(moment)).sum()
}
