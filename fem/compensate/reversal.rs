//! Splits the lost motion into a constant part and one that grows with the length of screw between bearing
//! and nut: kinematic or elastic.
//!
//! The lost motion at a target is b(x) = b₀ + F·2c(x), c the compliance of the screw (m/N) and F the
//! friction that winds it up (N). A regression over 2c(x) estimates F and b₀. No reversal tells whether b₀
//! is play or the compliance of nut and bearing under the same friction; below zero it is neither.
//!
//! Friction need not be the same all along, b(x) = δ + 2·F(x)/C(x) [seed 001, seed 000]: where the two parts miss the
//! targets by more than the approaches scatter, neither is named, and a step b₀ + F·2c(x) + h·[x > x_s] is tried,
//! which is what a place leaves from which on the slide goes harder.

use super::is_scatter;
use crate::compare::SIGNIFICANCE;
use crate::positioning::{Evaluation, Side, Target};

/// Standard uncertainties beyond which a friction, or a part below zero, is significant.
const SEEN: f64 = 3.0;
/// Ratio to the other at which one part of the lost motion rules.
const RULES: f64 = 2.0;
/// Ratio to what both miss below which neither is named.
const MISSED: f64 = 4.0;
/// Fewest targets of a regression.
const TARGETS: usize = 4;
/// Fewest targets on either side of a step.
const BESIDE: usize = 2;
/// Fewest targets for a step.
const STEPPED: usize = 6;

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
    /// Largest distance of a target from both parts together, m.
    pub misfit: f64,
    /// Whether the scatter of the approaches explains what the parts miss; `None` without repeats.
    pub fits: Option<bool>,
    /// Step that comes nearer to the targets, where the parts miss them.
    pub step: Option<Step>,
}

/// Place at which the lost motion steps. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Last target before the step, m.
    pub from: f64,
    /// First target behind it, m.
    pub to: f64,
    /// Height h, m.
    pub height: f64,
    /// Constant part b₀ beside the step, m.
    pub constant: f64,
    /// Friction F beside the step, N.
    pub friction: f64,
    /// Largest distance of a target, m.
    pub misfit: f64,
}

/// The constant part, as what it could be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kinematic {
    /// Above zero.
    Seen,
    /// Not to be told from zero.
    CompatibleWithNone,
    /// Below zero, which no play is.
    BelowNone,
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
    /// The parts are not told apart.
    Unclear,
}

impl LostMotion {
    /// Estimates the parts of the lost motion, given the compliance of the screw at a position. `None` where
    /// there are fewer than four targets, or no screw whose compliance varies.
    pub fn of(evaluation: &Evaluation, compliance: impl Fn(f64) -> Option<f64>) -> Option<Self> {
        let both = |t: &&Target| t.reversal().is_some();
        let targets: Vec<Target> = evaluation.targets.iter().filter(both).copied().collect();
        let places: Vec<f64> = targets.iter().map(|t| t.position).collect();
        let stretch: Vec<f64> = places.iter().map(|x| Some(2.0 * compliance(*x)?)).collect::<Option<_>>()?;
        let lost: Vec<f64> = targets.iter().filter_map(|t| Some(-t.reversal()?)).collect();
        if lost.len() < TARGETS {
            return None;
        }
        let line = Line::of(&stretch, &lost)?;
        let n = lost.len() as f64;
        let variance = line.squares() / (n - 2.0);
        let screw = stretch.iter().map(|x| line.slope * x);
        let fits = scatter_explains(&targets, &line.left);
        Some(Self {
            constant: line.constant,
            constant_std: (variance * (1.0 / n + line.middle.powi(2) / line.spread)).sqrt(),
            friction: line.slope,
            friction_std: (variance / line.spread).sqrt(),
            screw: screw.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v))),
            misfit: line.misfit(),
            fits,
            step: if fits == Some(true) { None } else { Step::of(&places, &stretch, &lost, &line) },
        })
    }

    /// Whether the part that grows along the screw is significant.
    pub fn grows(&self) -> bool {
        self.friction > SEEN * self.friction_std
    }

    /// Classifies the constant part by its sign, at the significance `SEEN`.
    pub fn kinematic(&self) -> Kinematic {
        match self.constant / self.constant_std {
            part if part < -SEEN => Kinematic::BelowNone,
            part if part > SEEN => Kinematic::Seen,
            _ => Kinematic::CompatibleWithNone,
        }
    }

    /// Part that rules midway between the ends. None does where the parts miss the targets by more than a quarter of
    /// what they are, where a step tells better, or where a part below zero stands beside one that grows.
    pub fn rules(&self) -> Rules {
        let elastic = if self.grows() { 0.5 * (self.screw.0 + self.screw.1) } else { 0.0 };
        let constant = self.constant.max(0.0);
        let ruling = self.constant.abs().max(elastic);
        let is_missed = self.fits != Some(true) && ruling < MISSED * self.misfit;
        match () {
            () if self.step.is_some() || is_missed || self.grows() && self.kinematic() == Kinematic::BelowNone => {
                Rules::Unclear
            }
            () if constant >= RULES * elastic => Rules::Constant,
            () if elastic >= RULES * constant => Rules::Elastic,
            () => Rules::Both,
        }
    }
}

impl Step {
    /// The step that comes nearest to the targets, if it is significant among all that were tried. What the line
    /// leaves of the step is regressed on what it leaves of the lost motion.
    ///
    /// With its place and height a step has two parameters; the F test of two against m degrees of freedom has the
    /// level (S/S₀)^(m/2), S and S₀ the squares that are left with and without it.
    fn of(places: &[f64], stretch: &[f64], lost: &[f64], line: &Line) -> Option<Self> {
        if places.len() < STEPPED {
            return None;
        }
        let stepped = |first: usize| {
            let behind: Vec<f64> = (0..places.len()).map(|i| f64::from(u8::from(i >= first))).collect();
            let left = Line::of(stretch, &behind)?;
            let height = left.left.iter().zip(&line.left).map(|(a, b)| a * b).sum::<f64>() / left.squares();
            let rest: Vec<f64> = lost.iter().zip(&behind).map(|(b, h)| b - height * h).collect();
            let rest = Line::of(stretch, &rest).filter(|rest| rest.squares().is_finite())?;
            Some((first, height, rest))
        };
        let tried: Vec<_> = (BESIDE..=places.len() - BESIDE).filter_map(stepped).collect();
        let (count, freedom) = (tried.len() as f64, (places.len() - 4) as f64);
        let (first, height, rest) = tried.into_iter().min_by(|a, b| a.2.squares().total_cmp(&b.2.squares()))?;
        let level = count * (rest.squares() / line.squares()).powf(0.5 * freedom);
        (level < SIGNIFICANCE).then(|| Self {
            from: places[first - 1],
            to: places[first],
            height,
            constant: rest.constant,
            friction: rest.slope,
            misfit: rest.misfit(),
        })
    }
}

/// A straight line by least squares.
struct Line {
    constant: f64,
    slope: f64,
    /// Mean of the abscissas, and the sum of the squares of their distances from it.
    middle: f64,
    spread: f64,
    /// Residual of every ordinate.
    left: Vec<f64>,
}

impl Line {
    /// `None` where all abscissas are one.
    fn of(x: &[f64], y: &[f64]) -> Option<Self> {
        let n = x.len() as f64;
        let [middle, level] = [x, y].map(|values| values.iter().sum::<f64>() / n);
        let spread: f64 = x.iter().map(|x| (x - middle).powi(2)).sum();
        if spread <= 1e-12 * n * middle * middle {
            return None;
        }
        let slope = x.iter().zip(y).map(|(x, y)| (x - middle) * (y - level)).sum::<f64>() / spread;
        let constant = level - slope * middle;
        let left = x.iter().zip(y).map(|(x, y)| y - constant - slope * x).collect();
        Some(Self { constant, slope, middle, spread, left })
    }

    fn squares(&self) -> f64 {
        self.left.iter().map(|l| l * l).sum()
    }

    fn misfit(&self) -> f64 {
        self.left.iter().fold(0.0, |most, l| most.max(l.abs()))
    }
}

/// Whether the scatter of the approaches explains what two parameters leave of the targets' lost motions (F test).
fn scatter_explains(targets: &[Target], left: &[f64]) -> Option<bool> {
    let of_mean = |t: &Target| t.sides().map(|s: &Side| 1.0 / s.count as f64).sum::<f64>();
    let of_lost: f64 = targets.iter().zip(left).map(|(t, left)| left * left / of_mean(t)).sum();
    is_scatter(targets, of_lost, (left.len() - 2) as f64)
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
        LostMotion::of(&Evaluation::of(&approaches, &deviations), |x| Some(1e-9 * x))
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

    /// Play of 3 um, 500 N, and from 2.5 m on 14 um more: the line through all has no play and a friction that is none.
    #[test]
    fn a_place_of_extra_drag_is_told_and_no_part_named_on_it() {
        let lost: Vec<(f64, f64)> =
            (0..=6).map(|i| (f64::from(i), 3.0 + f64::from(i) + if i > 2 { 14.0 } else { 0.0 })).collect();
        let found = split(&lost).unwrap();
        // Least squares by hand about the middle at 3 m, where Σ(x − 3)² = 28: the step adds 14·(0 + 1 + 2 + 3)/28 = 3
        // um a metre to the slope, and 14·4/7 = 8 um to the mean.
        let (slope, level) = (14.0 * (0.0 + 1.0 + 2.0 + 3.0) / 28.0, 14.0 * 4.0 / 7.0);
        assert!((found.friction - 500.0 * (1.0 + slope)).abs() < 1e-6, "{found:?}");
        assert!((1e6 * found.constant - (3.0 + level - 3.0 * slope)).abs() < 1e-9, "{found:?}");
        // The first target behind the step stands 14 um above, where the line has risen by the mean.
        assert!((1e6 * found.misfit - (14.0 - level)).abs() < 1e-9, "{found:?}");
        assert_eq!((found.kinematic(), found.rules()), (Kinematic::CompatibleWithNone, Rules::Unclear));
        let step = found.step.unwrap();
        assert_eq!((step.from, step.to), (2.0, 3.0));
        assert!((1e6 * step.height - 14.0).abs() < 1e-9 && (step.friction - 500.0).abs() < 1e-6, "{step:?}");
        assert!((1e6 * step.constant - 3.0).abs() < 1e-9 && step.misfit < 1e-12, "{step:?}");
    }

    #[test]
    fn a_part_below_zero_is_no_play() {
        // 12 um of play, of which the control takes 20.
        let found = split(&[(0.0, -8.02), (1.0, -6.98), (2.0, -6.0), (3.0, -5.02), (4.0, -3.98)]).unwrap();
        assert_eq!((found.kinematic(), found.rules()), (Kinematic::BelowNone, Rules::Unclear));
    }
}
