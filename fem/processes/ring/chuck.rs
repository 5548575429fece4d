//! The table of the chuck.

use super::grip::Grip;
use super::membrane::Membrane;
use crate::input::Reader;
use crate::process::estimates::CLAMPING_FORCE;
use crate::units::{FORCE, LENGTH, NUMBER};

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
    /// Where the jaws press along the ring, from its face at the chuck, m; all along it where this is not said.
    pub reach: Option<[f64; 2]>,
    /// What makes the force, if it is a membrane.
    pub membrane: Option<Membrane>,
    /// Friction between jaws and ring.
    pub friction: Option<f64>,
    /// By how much it is to hold more than the cut asks for.
    pub margin: f64,
}

impl Chuck {
    /// Reads that of a ring of some `width` (m); a mesh from a file is drawn for jaws of a known force that hold it by its outside.
    pub fn read(t: &Reader, is_drawn: bool, width: f64) -> Self {
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
        let reach = read_reach(t, width);
        if let (Some(_), true) = (reach, is_drawn || membrane.is_some()) {
            let other = if is_drawn { "the mesh of the ring was drawn" } else { "the pads of a membrane do so" };
            let message = format!("jaws of some width press on a part of the ring, and {other} for all of its width");
            t.problem("jaw_width", message, "leave `jaw_width` out");
        }
        let friction =
            t.quantity("friction", NUMBER, "between jaws and ring; with it the least force that holds is told");
        let margin =
            t.quantity("margin", NUMBER, "by how many times the friction of the jaws holds what the cut asks for");
        let (friction, margin) = (friction.positive().optional(), margin.positive().or(MARGIN));
        Self { grip, jaws, jaw_force: jaw_force.unwrap_or_default(), reach, membrane, friction, margin }
    }
}

/// Where the jaws press along a ring of some width (m), if that is said.
fn read_reach(t: &Reader, width: f64) -> Option<[f64; 2]> {
    let about = "over which the jaws press along the ring; all of its width if left out";
    let own = t.quantity("jaw_width", LENGTH, about).positive().optional();
    let about = "from the ring's face at the chuck to where the jaws begin to press";
    let from = t.quantity("jaw_from", LENGTH, about).not_negative().optional();
    if own.is_none() && from.is_some() && !t.is_described() {
        t.problem("jaw_from", "it is not said over which length the jaws press", "add jaw_width = \"20 mm\"");
    }
    let reach = own.map(|own| [from.unwrap_or(0.0), from.unwrap_or(0.0) + own])?;
    if reach[1] > width * (1.0 + 1e-9) {
        let [end, width] = [reach[1], width].map(|length| LENGTH.format(length));
        let message = format!("the jaws press up to {end}, and the ring is {width} wide");
        t.problem("jaw_width", message, "lengths along the ring are from its face at the chuck");
        return None;
    }
    Some(reach.map(|end| end.min(width)))
}
