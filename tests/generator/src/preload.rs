//! Two equal sides that a preload presses on each other: Q1 − Q2 = S and u(Q1) + u(Q2) = 2·u(P), until the one
//! that is relieved bears nothing.

use crate::dense::root;

/// One side: u(Q) = Q/k + c·Qⁿ, um and N.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Side {
    /// N/um; None where it has no spring.
    pub stiffness: Option<f64>,
    /// c (um/N^n) and n.
    pub contact: Option<(f64, f64)>,
}

impl Side {
    /// What it approaches under a force of zero or more, um.
    pub fn approach(&self, force: f64) -> f64 {
        let contact = self.contact.map_or(0.0, |(c, n)| if force > 0.0 { c * force.powf(n) } else { 0.0 });
        self.stiffness.map_or(0.0, |k| force / k) + contact
    }

    /// How far two of it move under a force of zero or more, pressed on each other by `preload`, um.
    pub fn pair_moves(&self, preload: f64, force: f64) -> f64 {
        let pressed = self.approach(preload);
        let missing = |loaded: f64| self.approach(loaded) + self.approach((loaded - force).max(0.0)) - 2.0 * pressed;
        let loaded = if missing(force) >= 0.0 { force } else { root(force, force + preload, missing) };
        self.approach(loaded) - pressed
    }
}
