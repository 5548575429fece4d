//! Joints: supports that yield, linearly and by the contact law y = c·Qⁿ; two of them that press on each other; seats that
//! a preload holds together, or that have clearance; friction beside one.

mod clearance;
mod pair;
mod rubbing;
mod seat;

pub use clearance::{give_way, lost_motion};
pub use pair::Pair;
pub use rubbing::Rubbing;
pub use seat::Seat;

/// A yielding support: springs and contacts in series, y(Q) = Q·Σ1/k + Σ c·Qⁿ.
///
/// Contacts press only: for Q ≤ 0 they do not move, and only the springs yield.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Joint {
    /// Sum of the springs' compliances, m/N; 0 is rigid.
    pub spring_compliance: f64,
    /// Contacts in series.
    pub contacts: Vec<Contact>,
}

/// A contact joint y = c·Qⁿ (Q > 0), n in (0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Coefficient c, m/Nⁿ.
    pub coefficient: f64,
    /// Exponent n, in (0, 1].
    pub exponent: f64,
}

impl Contact {
    /// Displacement of the contact under the force `q` (N), m.
    pub fn displacement(&self, q: f64) -> f64 {
        match self.exponent {
            _ if q <= 0.0 => 0.0,
            // The square root is exact, and many times faster than a power.
            0.5 => self.coefficient * q.sqrt(),
            n => self.coefficient * q.powf(n),
        }
    }
}

/// A joint at one value of its path variable: force, displacement and how both change with the variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointState {
    /// Force Q, N.
    pub force: f64,
    /// Displacement y, m.
    pub displacement: f64,
    /// Rate of the force, dQ/ds.
    pub force_rate: f64,
    /// Rate of the displacement, dy/ds.
    pub displacement_rate: f64,
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

    /// y (m) and dy/dQ (m/N) under the force `q`; the latter is infinite at q = 0 where a contact with n < 1
    /// closes.
    pub fn yield_under(&self, q: f64) -> (f64, f64) {
        let (mut displacement, mut compliance) = (self.spring_compliance * q, self.spring_compliance);
        if q >= 0.0 {
            for contact in &self.contacts {
                let y = contact.displacement(q);
                displacement += y;
                compliance += match q {
                    0.0 => contact.coefficient * contact.exponent * q.powf(contact.exponent - 1.0),
                    q => contact.exponent * y / q,
                };
            }
        }
        (displacement, compliance)
    }

    /// y under the force `q`, m.
    pub fn displacement(&self, q: f64) -> f64 {
        self.yield_under(q).0
    }

    /// Work stored in the joint under the force `q`, ∫Q dy = Q²·Σ1/2k + Σ c·n/(n + 1)·Qⁿ⁺¹, J.
    pub fn work(&self, q: f64) -> f64 {
        let contact = |c: &Contact| c.displacement(q) * q * c.exponent / (c.exponent + 1.0);
        0.5 * self.spring_compliance * q * q + self.contacts.iter().map(contact).sum::<f64>()
    }

    /// The joint along a path s through its states, on which neither force nor displacement has an infinite
    /// slope.
    ///
    /// y = c·Qⁿ rises vertically at Q = 0. With Q = s^(1/n), n the smallest exponent, Q and y are both smooth
    /// and rising in s ≥ 0; for s < 0, where contacts are shut, Q = s.
    pub fn along(&self, s: f64) -> JointState {
        if s < 0.0 || self.contacts.is_empty() {
            let k = self.spring_compliance;
            return JointState { force: s, displacement: k * s, force_rate: 1.0, displacement_rate: k };
        }
        let power = 1.0 / self.path_exponent();
        // s^(p−1) is s^p/s, but at the closing point, where all but the steepest contact have no slope.
        let rate = |value: f64, p: f64| if s > 0.0 { p * value / s } else { f64::from(p == 1.0) };
        let force = s.powf(power);
        let force_rate = rate(force, power);
        let k = self.spring_compliance;
        let mut state = JointState { force, displacement: k * force, force_rate, displacement_rate: k * force_rate };
        for contact in &self.contacts {
            let exponent = contact.exponent * power; // ≥ 1, and 1 for the steepest
            let value = if exponent == 1.0 { s } else { s.powf(exponent) };
            state.displacement += contact.coefficient * value;
            state.displacement_rate += contact.coefficient * rate(value, exponent);
        }
        state
    }

    /// The path variable at which the joint carries the force `q`.
    pub fn path_at(&self, q: f64) -> f64 {
        if q <= 0.0 || self.contacts.is_empty() { q } else { q.powf(self.path_exponent()) }
    }

    fn path_exponent(&self) -> f64 {
        self.contacts.iter().map(|c| c.exponent).fold(1.0, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joint() -> Joint {
        let contacts = vec![Contact { coefficient: 2e-7, exponent: 0.5 }, Contact { coefficient: 1e-8, exponent: 0.8 }];
        Joint { spring_compliance: 1e-8, contacts }
    }

    #[test]
    fn the_path_runs_through_the_law() {
        let joint = joint();
        for q in [-50.0, 0.0, 1e-12, 3.0, 400.0] {
            let state = joint.along(joint.path_at(q));
            assert!((state.force - q).abs() <= 1e-12 * q.abs(), "{q}");
            assert!((state.displacement - joint.displacement(q)).abs() <= 1e-20 + 1e-12 * joint.displacement(q).abs());
        }
    }

    #[test]
    fn rates_are_finite_and_equal_the_finite_difference() {
        let joint = joint();
        for s in [-3.0, 0.7, 4.0, 20.0] {
            let h = 1e-6;
            let (a, b, at) = (joint.along(s - h), joint.along(s + h), joint.along(s));
            assert!(((b.force - a.force) / (2.0 * h) / at.force_rate - 1.0).abs() < 1e-7);
            assert!(((b.displacement - a.displacement) / (2.0 * h) / at.displacement_rate - 1.0).abs() < 1e-7);
        }
        let at_zero = joint.along(0.0);
        assert!(at_zero.force_rate.is_finite() && at_zero.displacement_rate > 0.0);
    }
}
