//! A beam that is pressed on supports and held by nothing else: how it bends, and which supports it leaves.
//!
//! Supports only press. Where one carries a force Q > 0 the beam sinks there by the support's y(Q), from where the
//! support stands; where it carries nothing the beam may lift off. All forces on the beam balance, and then
//!
//! ```text
//!     w(x) = a + b·x + Σ F·G(x, s)        over loads F and reactions −Q, at s
//! ```
//!
//! bends it exactly ([`Bending`]). The reactions follow from the force method: w = y(Q) at every support that carries, which is
//! one small system whatever the beam's length and however many pieces it has.

mod bending;
mod carried;
mod settle;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
mod tests;

pub use bending::Bending;
pub use settle::settle;

use std::sync::Arc;

use crate::joint::Joint;

/// A support under the beam.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// Distance from the beam's end, m.
    pub at: f64,
    /// How far it stands below its place, m; below zero where it stands high.
    pub lowered: f64,
    /// The law by which it yields.
    pub joint: Joint,
}

/// A force that presses the beam down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Distance from the beam's end, m.
    pub at: f64,
    /// Force, N; zero or more.
    pub force: f64,
}

/// The reaction of a support.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// Force Q, N; zero where the beam has lifted off.
    pub force: f64,
    /// Displacement of the beam there from where the support stands, m: what it sinks by, or, below zero, how far the
    /// beam has lifted off.
    pub displacement: f64,
}

/// The beam found no place to lie.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BeamError {
    /// The loads press outside the supports.
    #[error("the part tips: what presses on it acts at x = {:.3} mm as a whole, and the supports reach from {:.3} to {:.3} mm", 1e3 * at, 1e3 * from, 1e3 * to)]
    Tips {
        /// Place of the resultant, m.
        at: f64,
        /// Place of the first support, m.
        from: f64,
        /// Place of the last support, m.
        to: f64,
    },
    /// Newton's method or the choice of supports did not come to an end.
    #[error("no equilibrium of the part on its supports under {load} N")]
    NoEquilibrium {
        /// Sum of the loads, N.
        load: f64,
    },
}

/// A beam at rest on its supports.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    bending: Arc<Bending>,
    /// Forces (s, F): loads, and reactions with a minus sign.
    forces: Vec<(f64, f64)>,
    /// Rigid part of the displacement, a + b·x.
    rigid: (f64, f64),
    /// Reactions in the order of the supports.
    pub reactions: Vec<Reaction>,
}

impl Settled {
    /// w at x, m, downwards.
    pub fn deflection(&self, x: f64) -> f64 {
        let bent: f64 = self.forces.iter().map(|(s, f)| f * self.bending.influence(x, *s)).sum();
        self.rigid.0 + self.rigid.1 * x + bent
    }

    /// How far the section at x turns, rad: dw/dx but for what shear adds.
    pub fn slope(&self, x: f64) -> f64 {
        let bent: f64 = self.forces.iter().map(|(s, f)| f * self.bending.turned(x, *s)).sum();
        self.rigid.1 + bent
    }

    /// EI·w'' at x, N m: above zero where the beam hollows upwards, as over a support.
    pub fn moment(&self, x: f64) -> f64 {
        self.forces.iter().map(|(s, f)| 0.5 * f * (x - s).abs()).sum()
    }
}
