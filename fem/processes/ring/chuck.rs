//! The table of the chuck.

use super::grip::Grip;
use super::membrane::Membrane;
use crate::input::Reader;
use crate::process::estimates::CLAMPING_FORCE;
use crate::units::{FORCE, NUMBER};

/// Times that jaws hold what the cut asks for, unless the model says otherwise.
const MARGIN: f64 = 2.0;

/// A chuck as the model file has it. SI units.
pub struct Chuck {
    /// Side by which its jaws hold the ring.
    pub grip: Grip,
    /// How many, evenly spaced.
    pub jaws: usize,
    /// Force of each at standstill, N; 0 where a membrane makes it.
    pub jaw_force: f64,
    /// What makes the force, if it is a membrane.
    pub membrane: Option<Membrane>,
    /// Friction between jaws and ring.
    pub friction: Option<f64>,
    /// By how much it is to hold more than the cut asks for.
    pub margin: f64,
}

impl Chuck {
    /// Reads it; a mesh from a file is drawn for jaws of a known force that hold it by its outside.
    pub fn read(t: &Reader, is_drawn: bool) -> Self {
        let about = "by which side the jaws hold the ring; the other one is cut";
        let grip = t.choice("grip", about, Grip::WORDS).or_first(Grip::Outside);
        if grip == Grip::Inside && is_drawn && !t.is_described() {
            let help = "leave `file` out of [mesh], or hold it by its outside";
            t.problem("grip", "a ring whose mesh was drawn is held by its outside", help);
        }
        let jaws = t.count("jaws", "how many jaws, evenly spaced, the first at 0 deg").between(2, 100).required();
        let about = "a plate that is pushed open and springs back: what the jaws press with";
        let membrane = t.optional_table("membrane", about, |t| Membrane::read(t, jaws));
        let force = t.quantity("jaw_force", FORCE, "radial force of each jaw; that of a membrane follows from it");
        let force = force.estimated(CLAMPING_FORCE).not_negative();
        let jaw_force = match membrane.is_some() || t.is_described() {
            true => force.optional(),
            false => Some(force.required()),
        };
        if membrane.is_some() && t.has("jaw_force") {
            let help = "leave `jaw_force` out, and a run tells it; or leave [chuck.membrane] out";
            t.problem("jaw_force", "the force of the jaws follows from [chuck.membrane], and stands here too", help);
        }
        if membrane.is_some() && is_drawn && !t.is_described() {
            let help = "leave `file` out of [mesh], or say `jaw_force` instead";
            t.problem("membrane", "how a ring whose mesh was drawn gives way under its jaws is not known", help);
        }
        let friction =
            t.quantity("friction", NUMBER, "between jaws and ring; with it the least force that holds is told");
        let margin =
            t.quantity("margin", NUMBER, "by how many times the friction of the jaws holds what the cut asks for");
        let (friction, margin) = (friction.positive().optional(), margin.positive().or(MARGIN));
        Self { grip, jaws, jaw_force: jaw_force.unwrap_or_default(), membrane, friction, margin }
    }
}
