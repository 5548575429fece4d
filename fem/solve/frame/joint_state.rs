//! One joint during Newton's iteration: where it stands on its law and how it is linearised there.

use super::system::Motion;
use crate::joint::Joint;

/// Bounds of the tangent stiffness κ. Neither changes the solution, only the last steps toward it where they
/// bind. Softest, as part of the secant stiffness at half the load: κ = 0 at Q = 0 would leave the shaft
/// loose.
const SOFTEST: f64 = 1e-6;
/// Stiffest, as multiple of the node's own stiffness: stands for a joint that is rigid (y′ = 0).
const STIFFEST: f64 = 1e3;

/// State of one joint.
#[derive(Clone)]
pub(super) struct JointState<'f> {
    /// Degree of freedom it acts on.
    pub freedom: usize,
    pub law: &'f Joint,
    /// Force Q (N) at which the joint stands on its law.
    pub force: f64,
    /// Force (N) that balances the shaft at its present displacements; equal to `force` at the solution.
    pub balance: f64,
    /// Stiffness (N/m) with which the rest of the shaft, other joints included, resists this joint's
    /// displacement.
    pub rest: f64,
    /// Stiffness (N/m) of the node without the joint: the diagonal entry.
    own: f64,
    /// Q/y(Q) (N/m) at half the load: the stiffness to start with and the scale that compares forces with
    /// gaps.
    pub secant: f64,
}

impl<'f> JointState<'f> {
    /// A joint before any load; `load` is the largest load (N).
    pub fn new(freedom: usize, law: &'f Joint, own: f64, load: f64) -> Self {
        // without load any stiffness will do: nothing moves
        let guess = if load > 0.0 { 0.5 * load } else { 1.0 };
        let secant = (guess / law.displacement(guess)).min(STIFFEST * own);
        Self { freedom, law, force: 0.0, balance: 0.0, rest: 0.0, own, secant }
    }

    /// κ = 1/y′(Q) within its bounds (N/m); at least the part `rounding` of the node's own stiffness.
    pub fn tangent(&self, rounding: f64) -> f64 {
        self.bounded(1.0 / self.law.yield_under(self.force).1, rounding)
    }

    /// The stiffness to start with, within the same bounds (N/m).
    pub fn start(&self, rounding: f64) -> f64 {
        self.bounded(self.secant, rounding)
    }

    fn bounded(&self, stiffness: f64, rounding: f64) -> f64 {
        stiffness.max(SOFTEST * self.secant).max(rounding * self.own).min(STIFFEST * self.own)
    }

    /// Gap w − y(Q) (m) between the shaft and the joint.
    pub fn gap(&self, motion: &Motion) -> f64 {
        motion[self.freedom].0 - self.law.displacement(self.force)
    }

    /// Takes the compliance (m/N) of the shaft at this joint, with the joint's own `stiffness` in it, and
    /// keeps the stiffness of the rest: 1/a = e + κ. A rest below the part `rounding` of the node's own
    /// stiffness is none: the force is statically determinate.
    pub fn set_rest(&mut self, compliance: f64, stiffness: f64, rounding: f64) {
        let rest = 1.0 / compliance - stiffness;
        self.rest = if rest > rounding * self.own { rest } else { 0.0 };
    }

    /// Force Q (N) on the law where shaft and joint meet if the rest of the shaft, now at displacement `w`
    /// (m) with the force `balance` (N) between them, gives way linearly: e (w − y(Q)) + balance − Q = 0. For
    /// a single joint on a linear shaft this is the solution, however curved the law.
    pub fn meeting_force(&self, w: f64, balance: f64) -> f64 {
        let offset = self.rest * w + balance;
        // Q lies between 0 and the offset, at any power of ten: bisection over the representable numbers
        let (mut low, mut high) = (0, offset.abs().to_bits());
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            let force = f64::from_bits(middle).copysign(offset);
            let excess = (self.rest * self.law.displacement(force) + force - offset) * offset.signum();
            if excess > 0.0 { high = middle } else { low = middle }
        }
        f64::from_bits(high).copysign(offset)
    }

    /// Squared distance (N²) of the shaft at `w` (m) and `balance` (N) from the joint's law, along the load
    /// line.
    pub fn distance(&self, w: f64, balance: f64) -> f64 {
        let force = self.meeting_force(w, balance);
        (balance - force).powi(2) + (self.secant * (w - self.law.displacement(force))).powi(2)
    }
}

#[cfg(test)]
mod tests {
    use super::JointState;
    use crate::joint::{Contact, Joint};

    #[test]
    fn meeting_force_is_on_the_load_line() {
        // (k, c, n, rest of the shaft N/m, w m, balance N)
        let table = [
            (f64::INFINITY, 0.2e-6, 0.5, 5e6, 12e-6, 130.0),
            (4e7, 0.2e-6, 0.5, 5e6, -12e-6, 20.0),
            (f64::INFINITY, 0.2e-6, 0.5, 5e6, -12e-6, 20.0),
            (f64::INFINITY, 5e-6, 0.1, 5e6, 1e-9, 1e-9),
            (f64::INFINITY, 0.2e-6, 0.5, 0.0, 12e-6, 130.0),
        ];
        for (k, c, n, rest, w, balance) in table {
            let k: f64 = k;
            let law = Joint { spring_compliance: 1.0 / k, contacts: vec![Contact { coefficient: c, exponent: n }] };
            let mut joint = JointState::new(0, &law, 1e9, 500.0);
            joint.rest = rest;
            let force = joint.meeting_force(w, balance);
            let miss = rest * (w - law.displacement(force)) + balance - force;
            assert!(miss.abs() <= 1e-14 * (rest * w.abs() + balance.abs()), "{law:?}: {miss}");
        }
    }
}
