//! A joint of a machine's structure: contact surfaces that a preload holds together, or a clearance.
//!
//! Its spring stands in the structure. What is told here is by how much the joint gives way beside it under the force F
//! that it transmits, positive where it is pressed:
//!
//! ```text
//!     contact, preloaded by P:   e = c·(F + P)ⁿ − c·Pⁿ   for F > −P; there it opens, F = −P
//!     clearance g:               e = 0 for F < 0, anything up to g for F = 0, g beyond
//! ```

use super::{Contact, JointState};

/// What gives way in a joint beside its spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Seat {
    /// Surfaces in contact, and the force (N) with which they are held together without a load.
    Contact(Contact, f64),
    /// Clearance from the one flank to the other, m.
    Clearance(f64),
}

/// Opening or clearance (m) along the path per unit of its variable.
const WAY: f64 = 1e-6;

impl Seat {
    /// The state at a place of the joint's path, on which force and displacement never fall and never stand still
    /// together. Of a contact the variable is (F + P)ⁿ where it is closed, and the opening in um below zero; of a clearance
    /// the force beyond its flanks, and the way between them in um.
    pub fn along(&self, s: f64) -> JointState {
        let state = |force, displacement, force_rate, displacement_rate| JointState {
            force,
            displacement,
            force_rate,
            displacement_rate,
        };
        match *self {
            Self::Contact(Contact { coefficient, exponent }, preload) => {
                let held = coefficient * preload.powf(exponent);
                if s <= 0.0 {
                    return state(-preload, WAY * s - held, 0.0, WAY);
                }
                let force = s.powf(1.0 / exponent);
                state(force - preload, coefficient * s - held, force / (exponent * s), coefficient)
            }
            Self::Clearance(gap) => match s {
                s if s < 0.0 => state(s, 0.0, 1.0, 0.0),
                s if s * WAY > gap => state(s - gap / WAY, gap, 1.0, 0.0),
                s => state(0.0, WAY * s, 0.0, WAY),
            },
        }
    }

    /// Whether all of its values are known: those that are sought are no numbers yet.
    pub fn is_known(&self) -> bool {
        match *self {
            Self::Contact(Contact { coefficient, exponent }, preload) => !(coefficient + exponent + preload).is_nan(),
            Self::Clearance(gap) => !gap.is_nan(),
        }
    }

    /// The force (N) with which it is held together: it bears as much against its direction, and a clearance anything.
    pub fn holds(&self) -> f64 {
        match *self {
            Self::Contact(_, preload) => preload,
            Self::Clearance(_) => f64::INFINITY,
        }
    }

    /// The place of its path under a force (N).
    pub fn path_at(&self, force: f64) -> f64 {
        match *self {
            Self::Contact(Contact { exponent, .. }, preload) => (force + preload).max(0.0).powf(exponent),
            Self::Clearance(gap) if force > 0.0 => force + gap / WAY,
            Self::Clearance(_) => force,
        }
    }
}
