//! Two joints that press on each other: a preloaded pair.

use super::Joint;

/// Steps of Newton or halves after which a root is taken as it is; some six are needed.
const STEPS: usize = 200;

/// Two joints of one law u(Q) that press on each other with P and carry a force S between them.
///
/// S loads one and relieves the other, and what the one gives way the other follows: Q₁ − Q₂ = S and u(Q₁) +
/// u(Q₂) = 2·u(P), y = u(Q₁) − u(P). Once the second is relaxed, Q₂ = 0, the first carries S alone, y = u(S) −
/// u(P) [statics of two springs in parallel, with u(Q) = Q/k + c·Qⁿ of seed 002 (29)]. Without preload there is
/// one joint. The same joint stands on either side, so that y(−S) = −y(S).
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    /// The law u(Q) of each.
    joint: &'a Joint,
    /// Preload P, N.
    preload: f64,
    /// u(P), m.
    pressed: f64,
}

impl<'a> Pair<'a> {
    /// Two joints of this law under a preload of `preload` N; 0 for one joint.
    pub fn new(joint: &'a Joint, preload: f64) -> Self {
        Self { joint, preload, pressed: joint.displacement(preload) }
    }

    /// y under the force `s` (N), m.
    pub fn displacement(&self, s: f64) -> f64 {
        let [first, _] = self.forces(s.abs());
        (self.joint.displacement(first) - self.pressed).copysign(s)
    }

    /// Tangent compliance dy/dS under the force `s` (N), m/N: u₁′·u₂′/(u₁′ + u₂′) while both press, u₁′ beyond.
    pub fn compliance(&self, s: f64) -> f64 {
        let [first, second] = self.forces(s.abs());
        let [first, follows] = [first, second].map(|q| self.joint.yield_under(q).1);
        if second > 0.0 { 1.0 / (1.0 / first + 1.0 / follows) } else { first }
    }

    /// Work ∫S dy from no force to `s` (N): what both store beyond what the preload has stored, J.
    pub fn work(&self, s: f64) -> f64 {
        let [first, second] = self.forces(s.abs());
        self.joint.work(first) + self.joint.work(second) - 2.0 * self.joint.work(self.preload)
    }

    /// The force at which the second joint is relaxed, u(S) = 2·u(P), N.
    pub fn relaxed_at(&self) -> f64 {
        self.alone(2.0 * self.pressed)
    }

    /// The force under which the pair gives way by `displacement` (m), N.
    ///
    /// The first joint is pressed to u(P) + y and the second relieved to u(P) − y, or to nothing.
    pub fn force_at(&self, displacement: f64) -> f64 {
        let y = displacement.abs();
        (self.alone(self.pressed + y) - self.alone((self.pressed - y).max(0.0))).copysign(displacement)
    }

    /// Forces Q₁ and Q₂ under `s` ≥ 0, N.
    fn forces(&self, s: f64) -> [f64; 2] {
        let together = 2.0 * self.pressed;
        if self.joint.displacement(s) >= together {
            return [s, 0.0];
        }
        if s == 0.0 {
            return [self.preload; 2];
        }
        // Along the path of the second joint, on which the sum has no infinite slope where it is relaxed.
        let path = rising_root(self.joint.path_at(self.preload), |path| {
            let second = self.joint.along(path);
            let (displacement, compliance) = self.joint.yield_under(s + second.force);
            let rate = compliance * second.force_rate + second.displacement_rate;
            (displacement + second.displacement - together, rate)
        });
        let second = self.joint.along(path).force;
        [s + second, second]
    }

    /// The force under which one joint alone gives way by `displacement` ≥ 0 (m), N.
    fn alone(&self, displacement: f64) -> f64 {
        if displacement == 0.0 {
            return 0.0;
        }
        // Contacts only add to what the springs yield, so that the springs alone would need more force.
        let most = self.joint.path_at(displacement / self.joint.spring_compliance);
        let path = rising_root(most, |path| {
            let state = self.joint.along(path);
            (state.displacement - displacement, state.displacement_rate)
        });
        self.joint.along(path).force
    }
}

/// The root between 0 and `high` of a rising function given with its slope: Newton's step where it stays
/// between the bounds found so far, half of the way elsewhere.
fn rising_root(mut high: f64, function: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut at, small) = (0.0, high, f64::EPSILON * high);
    for _ in 0..STEPS {
        let (value, slope) = function(at);
        if value > 0.0 {
            high = at;
        } else {
            low = at;
        }
        let newton = at - value / slope;
        let next = if (low..=high).contains(&newton) { newton } else { 0.5 * (low + high) };
        if (next - at).abs() <= small {
            return next;
        }
        at = next;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::super::Contact;
    use super::*;

    fn joint(contacts: &[(f64, f64)]) -> Joint {
        let contacts = contacts.iter().map(|(c, exponent)| Contact { coefficient: *c, exponent: *exponent });
        Joint { spring_compliance: 1.0 / 80e6, contacts: contacts.collect() }
    }

    #[test]
    fn springs_resist_together_until_one_is_relaxed() {
        let spring = joint(&[]);
        let pair = Pair::new(&spring, 400.0);
        for (s, expected) in [(0.0, 0.0), (160.0, 1.0), (800.0, 5.0), (1000.0, 7.5), (-1000.0, -7.5)] {
            assert!((1e6 * pair.displacement(s) - expected).abs() < 1e-12, "{s}");
        }
        assert!((pair.relaxed_at() - 800.0).abs() < 1e-9 && (pair.force_at(7.5e-6) - 1000.0).abs() < 1e-9);
        assert!((Pair::new(&spring, 0.0).displacement(1000.0) - 12.5e-6).abs() < 1e-18);
    }

    #[test]
    fn forces_balance_and_what_one_gives_way_the_other_follows() {
        for contacts in [vec![(2.5e-7, 0.5)], vec![(2e-7, 0.35), (1e-8, 0.8)], vec![(5e-9, 1.0)]] {
            let joint = joint(&contacts);
            for preload in [1e-3, 7.0, 400.0] {
                let pair = Pair::new(&joint, preload);
                let relaxed = pair.relaxed_at();
                for part in [0.0, 1e-6, 0.3, 0.9, 0.999_999, 1.0, 1.2, 10.0] {
                    let s = part * relaxed;
                    let [first, second] = pair.forces(s);
                    let [a, b, p] = [first, second, preload].map(|q| joint.displacement(q));
                    assert!((first - second - s).abs() <= 1e-12 * first);
                    assert!(part > 1.0 || (a + b - 2.0 * p).abs() <= 1e-13 * p, "{contacts:?} {preload} {part}");
                    assert!(second > 0.0 || part > 0.999_999);
                    assert!((pair.force_at(pair.displacement(s)) - s).abs() <= 1e-9 * relaxed.max(s));
                }
            }
        }
    }

    #[test]
    fn compliance_and_work_are_the_slope_and_the_area_of_the_curve() {
        let joint = joint(&[(2.5e-7, 0.5)]);
        let pair = Pair::new(&joint, 400.0);
        for s in [100.0, 700.0, 1200.0] {
            let h = 1e-2;
            let difference = |f: &dyn Fn(f64) -> f64| (f(s + h) - f(s - h)) / (2.0 * h);
            let slope = difference(&|s| pair.displacement(s));
            assert!((slope / pair.compliance(s) - 1.0).abs() < 1e-7);
            assert!((difference(&|s| pair.work(s)) / (s * slope) - 1.0).abs() < 1e-7);
        }
        assert!(pair.work(0.0).abs() < 1e-18);
    }
}
