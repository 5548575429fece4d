//! A joint beside which dry friction holds: what it bears depends on what it has been through.

use super::{Joint, JointState};

/// A joint u(S) with a friction of at most f beside it, which transmits Q = S + T, |T| ≤ f.
///
/// While the friction holds, the joint stands where it stood and bears the S that it bore; beyond, Q = S + f where the load
/// rises and Q = S − f where it falls [Coulomb's law; the play operator, Krasnosel'skii and Pokrovskii, Systems with
/// Hysteresis, 1989, 2.1]. S = Q − min(max(Q − S₀, −f), f), S₀ what was borne before: from one S₀ the law y(Q) rises
/// throughout, so that an equilibrium finds by itself whether the joint holds or slides.
#[derive(Clone, Copy, Debug)]
pub struct Rubbing<'a> {
    /// The law u(S).
    joint: &'a Joint,
    /// Friction f, N.
    friction: f64,
    /// S₀, N.
    borne: f64,
}

impl<'a> Rubbing<'a> {
    /// A joint with a friction of up to `friction` N, which bore `borne` N before.
    pub fn new(joint: &'a Joint, friction: f64, borne: f64) -> Self {
        Self { joint, friction, borne }
    }

    /// A joint that nothing rubs.
    pub fn free(joint: &'a Joint) -> Self {
        Self::new(joint, 0.0, 0.0)
    }

    /// What of the force `q` (N) the joint bears, N; the rest is friction.
    pub fn bears(&self, q: f64) -> f64 {
        q - (q - self.borne).clamp(-self.friction, self.friction)
    }

    /// y (m) and dy/dQ (m/N) under the force `q` (N), see [`Joint::yield_under`].
    pub fn yield_under(&self, q: f64) -> (f64, f64) {
        let holds = (q - self.borne).abs() < self.friction;
        let (displacement, compliance) = self.joint.yield_under(self.bears(q));
        (displacement, if holds { 0.0 } else { compliance })
    }

    /// y/Q under the force `q` (N), that of the springs under none, m/N.
    pub fn secant(&self, q: f64) -> f64 {
        if q == 0.0 { self.joint.spring_compliance } else { self.yield_under(q).0 / q }
    }

    /// The law along a path, see [`Joint::along`]: that of the joint, parted where friction holds by its 2f newtons.
    pub fn along(&self, s: f64) -> JointState {
        if self.friction == 0.0 {
            return self.joint.along(s);
        }
        let (held, width) = (self.joint.path_at(self.borne), 2.0 * self.friction);
        let slid = |at: f64, by: f64| {
            let state = self.joint.along(at);
            JointState { force: state.force + by, ..state }
        };
        match s - held {
            below if below < 0.0 => slid(s, -self.friction),
            beyond if beyond > width => slid(s - width, self.friction),
            way => JointState {
                force: self.borne - self.friction + way,
                displacement: self.joint.displacement(self.borne),
                force_rate: 1.0,
                displacement_rate: 0.0,
            },
        }
    }

    /// The place of its path under the force `q` (N).
    pub fn path_at(&self, q: f64) -> f64 {
        let borne = self.bears(q);
        self.joint.path_at(borne) + self.friction + (q - borne)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Contact;
    use super::*;

    fn joint() -> Joint {
        Joint { spring_compliance: 1e-8, contacts: vec![Contact { coefficient: 2e-7, exponent: 0.5 }] }
    }

    #[test]
    fn the_joint_stays_behind_until_twice_the_friction_is_gone() {
        let joint = Joint { spring_compliance: 1.0 / 50e6, contacts: Vec::new() };
        let mut borne = 0.0;
        // 0 -> 500 -> 450 -> 380 -> 0 -> 30 N with 40 N of friction, 50 N/um.
        for (q, expected) in [(500.0, 9.2), (450.0, 9.2), (380.0, 8.4), (0.0, 0.8), (30.0, 0.8)] {
            let now = Rubbing::new(&joint, 40.0, borne);
            assert!((1e6 * now.yield_under(q).0 - expected).abs() < 1e-12, "{q}");
            borne = now.bears(q);
        }
    }

    #[test]
    fn the_path_runs_through_the_law_and_never_stands_still() {
        let joint = joint();
        for borne in [0.0, 60.0, 300.0] {
            let rubbing = Rubbing::new(&joint, 40.0, borne);
            for q in [-90.0, 0.0, 15.0, 70.0, 99.0, 120.0, 400.0] {
                let state = rubbing.along(rubbing.path_at(q));
                assert!((state.force - q).abs() < 1e-10, "{borne} {q}");
                assert!((state.displacement - rubbing.yield_under(q).0).abs() < 1e-18, "{borne} {q}");
                assert!(state.force_rate + state.displacement_rate > 0.0);
            }
        }
    }
}
