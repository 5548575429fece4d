//! Splits the lost motion into a constant part and one that grows with the length of screw between bearing
//! and nut: kinematic or elastic.
//!
//! The lost motion at a target is b(x) = b₀ + F·2c(x), c the compliance of the screw (m/N) and F the
//! friction that winds it up (N). A regression over 2c(x) estimates F and b₀. No reversal tells whether b₀
//! is play or the compliance of nut and bearing under the same friction.

use crate::positioning::Evaluation;

/// Standard uncertainties beyond which a friction is significant.
const SEEN: f64 = 3.0;
/// Ratio at which one part of the lost motion rules.
const RULES: f64 = 2.0;
/// Fewest targets of a regression.
const TARGETS: usize = 4;

/// Lost motion along an axis by its parts. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostMotion {
    /// Constant part b₀: play, and the deflection of nut and bearing, m.
    pub constant: f64,
    /// Standard uncertainty of b₀, m.
    pub constant_std: f64,
    /// Friction F, N; negative where the reversal falls away from the bearing, which no friction does.
    pub friction: f64,
    /// Standard uncertainty of F, N.
    pub friction_std: f64,
    /// Part F·2c that the screw adds at the targets, smallest and largest, m.
    pub screw: (f64, f64),
}

/// Part of the lost motion that rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rules {
    /// The part that is the same all along.
    Constant,
    /// The part that grows along the screw.
    Elastic,
    /// Neither part alone.
    Both,
}

impl LostMotion {
    /// Estimates the parts of the lost motion, given the compliance of the screw at a position. `None` where
    /// there are fewer than four targets, or the compliance does not vary.
    pub fn of(evaluation: &Evaluation, compliance: impl Fn(f64) -> f64) -> Option<Self> {
        let point = |t: &crate::positioning::Target| Some((2.0 * compliance(t.position), -t.reversal()?));
        let points: Vec<(f64, f64)> = evaluation.targets.iter().filter_map(point).collect();
        if points.len() < TARGETS {
            return None;
        }
        let n = points.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
        let (x, y) = (mean(|p| p.0), mean(|p| p.1));
        let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
        if spread <= 1e-12 * n * x * x {
            return None;
        }
        let friction = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
        let constant = y - friction * x;
        let left: f64 = points.iter().map(|p| (p.1 - constant - friction * p.0).powi(2)).sum();
        let variance = left / (n - 2.0);
        let screw = points.iter().map(|p| friction * p.0);
        Some(Self {
            constant,
            constant_std: (variance * (1.0 / n + x * x / spread)).sqrt(),
            friction,
            friction_std: (variance / spread).sqrt(),
            screw: screw.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v))),
        })
    }

    /// Whether the part that grows along the screw is significant.
    pub fn grows(&self) -> bool {
        self.friction > SEEN * self.friction_std
    }

    /// Part that rules midway between the ends.
    pub fn rules(&self) -> Rules {
        let elastic = if self.grows() { 0.5 * (self.screw.0 + self.screw.1) } else { 0.0 };
        match self.constant.max(0.0) {
            constant if constant >= RULES * elastic => Rules::Constant,
            constant if elastic >= RULES * constant => Rules::Elastic,
            _ => Rules::Both,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::positioning::{Approach, Direction};

    /// Lost motion (um) at places (m) of a screw of 1 nm/N a metre.
    fn split(lost: &[(f64, f64)]) -> Option<LostMotion> {
        let approach = |position, direction| Approach { position, direction, run: 1.0 };
        let approaches: Vec<Approach> =
            lost.iter().flat_map(|(x, _)| Direction::BOTH.map(|d| approach(*x, d))).collect();
        let deviations: Vec<f64> = lost.iter().flat_map(|(_, b)| [0.0, 1e-6 * b]).collect();
        LostMotion::of(&Evaluation::of(&approaches, &deviations), |x| 1e-9 * x)
    }

    #[test]
    fn play_and_friction_are_told_apart_along_the_screw() {
        // 500 N add 1 um a metre to play of 6 um, but for 0.02 um of noise.
        let found = split(&[(0.0, 6.02), (1.0, 6.98), (2.0, 8.0), (3.0, 8.98), (4.0, 10.02)]).unwrap();
        assert!((found.friction - 500.0).abs() < 6.0 && (1e6 * found.constant - 6.0).abs() < 0.03, "{found:?}");
        assert!(found.grows() && found.rules() == Rules::Constant);
        let heavy = split(&[(0.0, 0.02), (1.0, 0.98), (2.0, 2.0), (3.0, 2.98), (4.0, 4.02)]).unwrap();
        assert_eq!(heavy.rules(), Rules::Elastic);
    }

    #[test]
    fn what_is_the_same_all_along_is_no_friction() {
        let found = split(&[(0.0, 6.1), (1.0, 5.9), (2.0, 6.1), (3.0, 5.9), (4.0, 6.1)]).unwrap();
        assert!(!found.grows() && found.rules() == Rules::Constant);
        assert_eq!(split(&[(0.0, 6.0), (1.0, 6.0), (2.0, 6.0)]), None);
    }
}
