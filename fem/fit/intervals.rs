//! Profile-likelihood intervals of 95 %: a parameter is moved, all others re-fitted, until χ² has risen by
//! the quantile. Curvature alone (the Wald interval) misjudges time constants, exponents and parameters near
//! a bound.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::jacobian::Differences;
use super::least_squares::{StoppingCriterion, minimise, resume};
use super::objective::{Objective, Solution};
use super::steps::Steps;
use crate::noise::NoiseSource;
use crate::process::Failure;

/// 95 % point of χ² with one degree of freedom.
const QUANTILE: f64 = 3.841_458_820_694_124;
/// Distance from the quantile, in √Δχ², at which an end counts as found.
const PRECISION: f64 = 0.02;

/// Fall of χ² beyond which a minimum is a deeper one: what the precision of an end is in χ², and so moves none.
const DEEPER: f64 = 2.0 * Interval::HALF * PRECISION;
/// Most deeper minima that are gone to; each lies in another valley, or further down one that is long and
/// flat.
const MOST: usize = 6;

/// Parameters that are profiled at first, then twice as many.
const TOGETHER: usize = 4;

/// Stopping criterion of the other parameters while one is held.
const FOLLOW: StoppingCriterion = StoppingCriterion::rough(25, 1e-6);
/// Most positions at which an end is sought.
const TRIALS: usize = 24;
/// Distances beyond an end at which further valleys are sought, as parts of the distance of the end.
const BESIDE: [f64; 2] = [0.1, 0.3];

/// A 95 % interval, SI; an open end is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
}

impl Interval {
    /// Half the width of a 95 % interval of the standard normal distribution.
    pub const HALF: f64 = 1.959_964;

    /// Whether the data leave an end of it open.
    pub fn is_open(&self) -> bool {
        self.low.is_none() || self.high.is_none()
    }

    /// Whether it holds a value, SI; an open end holds everything beyond.
    pub fn contains(&self, value: f64) -> bool {
        self.low.is_none_or(|low| low <= value) && self.high.is_none_or(|high| value <= high)
    }

    /// Standard deviation of the normal distribution whose interval it is; `None` where an end is open.
    pub fn std(&self) -> Option<f64> {
        self.low.zip(self.high).map(|(low, high)| 0.5 * (high - low) / Self::HALF)
    }
}

/// Minimum with its profile intervals: along no profile does a deeper minimum lie.
#[derive(Clone)]
pub struct ProfiledMinimum {
    /// The minimum.
    pub solution: Solution,
    /// Covariance of its search variables.
    pub covariance: DMatrix<f64>,
    /// Interval of every parameter.
    pub intervals: Vec<Interval>,
    /// Profile of every parameter: values (SI), rising, with the rise of χ² there.
    pub profiles: Vec<Vec<(f64, f64)>>,
}

/// Profiles every parameter about a minimum; where a profile comes upon a deeper minimum, starts again from
/// that.
///
/// # Errors
/// The model cannot be computed beside a minimum.
pub fn profile_intervals(objective: &mut Objective, minimum: Solution) -> Result<ProfiledMinimum, Failure> {
    let mut gone = 0;
    let (mut solution, mut jacobian) =
        about(objective, minimum.clone()).ok_or_else(|| objective.why_not_beside(&minimum.position))?;
    loop {
        let covariance = objective.covariance(&jacobian);
        let walked = |i: usize| {
            let mut own = objective.clone();
            let mut profile = Profile {
                best: &solution,
                quantile: quantile(&own),
                deeper: None,
                goes_on: gone == MOST,
                seen: Vec::new(),
            };
            let interval = profile.interval(&mut own, &covariance, i);
            (interval, profile.deeper.take(), profile.rising())
        };
        // The first deeper minimum in the order of the parameters is taken, so that the same data always give the same
        // answer; as a rule one of the first few finds it, and the others are not asked.
        let (mut all, mut together, mut deeper) = (Vec::new(), TOGETHER, None);
        while deeper.is_none() && all.len() < solution.position.len() {
            let some = all.len()..solution.position.len().min(all.len() + together);
            let some: Vec<_> = some.into_par_iter().map(walked).collect();
            deeper = some.iter().find_map(|w| w.1.clone());
            all.extend(some);
            together *= 2;
        }
        let Some(deeper) = deeper else {
            let (intervals, profiles) = all.into_iter().map(|w| (w.0, w.2)).unzip();
            return Ok(ProfiledMinimum { solution, covariance, intervals, profiles });
        };
        let deeper = minimise(objective, &deeper.position, &[], StoppingCriterion::FULL).unwrap_or(deeper);
        match about(objective, deeper) {
            Some(own) => ((solution, jacobian), gone) = (own, gone + 1),
            // On the edge of where the model can be computed nothing can be said about its values.
            None => gone = MOST,
        }
    }
}

/// A minimum with its slopes by central differences, and the Jacobian there; `None` where the model cannot be computed beside
/// it.
fn about(objective: &Objective, minimum: Solution) -> Option<(Solution, DMatrix<f64>)> {
    let slopes = objective.slopes_about(&minimum, &[], Differences::Central)?.matrix;
    let jacobian = objective.jacobian_of(&slopes, &minimum.position);
    Some((Solution { slopes: Some(Arc::new(slopes)), ..minimum }, jacobian))
}

/// Profile of χ² along a parameter.
struct Profile<'a> {
    best: &'a Solution,
    quantile: f64,
    /// Deeper minimum on the way, at which the walk ends.
    deeper: Option<Solution>,
    /// Whether the walk goes on past a deeper minimum.
    goes_on: bool,
    /// Values that were visited, and the rise of χ² there.
    seen: Vec<(f64, f64)>,
}

impl Profile<'_> {
    fn interval(&mut self, objective: &mut Objective, covariance: &DMatrix<f64>, i: usize) -> Interval {
        if let Some(steps) = objective.variables[i].steps.clone() {
            return self.stepped(objective, &steps, i);
        }
        let walked = self.walked(objective, covariance, i);
        match objective.data.progress.permits("intervals by the profile of chi2: they are by its curvature") {
            true => walked,
            false => self.by_curvature(objective, covariance[(i, i)].sqrt(), i),
        }
    }

    /// The interval if χ² were a parabola in the search variable; its ends are open beyond the bounds.
    fn by_curvature(&self, objective: &Objective, std: f64, i: usize) -> Interval {
        let (variable, half) = (&objective.variables[i], self.quantile.sqrt() * std);
        let end = |s: f64| {
            let is_within = s > variable.low && s < variable.high;
            Some(variable.value(s)).filter(|v| is_within && v.is_finite())
        };
        let ends = [self.best.position[i] - half, self.best.position[i] + half].map(end);
        let [low, high] = if variable.is_reversed() { [ends[1], ends[0]] } else { ends };
        Interval { low, high }
    }

    /// The interval of a parameter that stands at certain places alone: from the first to the last of those, about the
    /// best one, at which χ² has not risen by the quantile. It reaches to the last number for which that place stands.
    fn stepped(&mut self, objective: &mut Objective, steps: &Steps, i: usize) -> Interval {
        /// Places outside, one after the other, beyond which no further one is tried.
        const OUTSIDE: usize = 2;
        let best = steps.at(self.best.position[i]);
        let mut ends = [best; 2];
        for (end, direction) in ends.iter_mut().zip([-1, 1]) {
            let mut outside = 0;
            for by in (1..=TRIALS as isize).map(|by| direction * by) {
                let Some(place) = steps.beside(best, by).filter(|_| outside < OUTSIDE) else { break };
                let start = self.at(i, place);
                match self.follow(objective, i, start).filter(|there| there.rise < self.quantile.sqrt()) {
                    Some(_) => (*end, outside) = (place, 0),
                    None => outside += 1,
                }
                if self.deeper.is_some() {
                    break;
                }
            }
        }
        Interval { low: Some(ends[0]), high: Some(steps.last_of(ends[1])) }
    }

    fn walked(&mut self, objective: &mut Objective, covariance: &DMatrix<f64>, i: usize) -> Interval {
        if objective.data.progress.is_over() {
            return Interval { low: None, high: None };
        }
        let walk = Walk {
            along: i,
            std: covariance[(i, i)].sqrt(),
            others: covariance.column(i) / covariance[(i, i)].max(f64::MIN_POSITIVE),
        };
        let mut end = |direction: f64| {
            let found = self.end(objective, &walk, direction);
            found.map(|s| objective.variables[i].value(s)).filter(|v| v.is_finite())
        };
        let (down, up) = (end(-1.0), end(1.0));
        if objective.variables[i].is_reversed() {
            Interval { low: up, high: down }
        } else {
            Interval { low: down, high: up }
        }
    }

    /// The profile as it was walked, by rising values; of equal ones the lower.
    fn rising(mut self) -> Vec<(f64, f64)> {
        self.seen.retain(|(value, _)| value.is_finite());
        self.seen.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        self.seen.dedup_by(|later, first| later.0 == first.0);
        self.seen
    }

    /// Finds the outermost end in one direction: where χ² has several valleys, those that are deep enough
    /// lie inside too.
    fn end(&mut self, objective: &mut Objective, walk: &Walk, direction: f64) -> Option<f64> {
        let i = walk.along;
        let origin = self.best.position[i];
        let mut end =
            self.end_from(objective, walk, direction, Point { position: self.best.position.clone(), rise: 0.0 })?;
        let variable = &objective.variables[i];
        let mut valleys = Vec::new();
        if variable.starts.len() > 1 {
            for s in variable.starts.iter().map(|start| variable.position(*start)) {
                valleys.push(self.at(i, s));
                valleys.extend(self.reshaped(objective, i, s));
            }
        }
        for beside in BESIDE {
            valleys.extend(self.unparked(objective, i, end + beside * (end - origin)));
        }
        valleys.sort_by(|a, b| (direction * b[i]).total_cmp(&(direction * a[i])));
        for valley in valleys {
            let s = valley[i];
            if direction * (s - end) <= 0.0 || self.deeper.is_some() {
                continue;
            }
            let there = self.follow(objective, i, valley);
            if let Some(there) = there.filter(|p| p.rise < self.quantile.sqrt()) {
                end = self.end_from(objective, walk, direction, there)?;
            }
        }
        Some(end)
    }

    /// Best position with one variable moved.
    fn at(&self, i: usize, s: f64) -> DVector<f64> {
        let mut position = self.best.position.clone();
        position[i] = s;
        position
    }

    /// Best position with one variable moved and all other nonlinear parameters at usual values.
    fn reshaped(&self, objective: &Objective, i: usize, s: f64) -> Option<DVector<f64>> {
        let mut position = self.at(i, s);
        let mut reshaped = false;
        for (j, variable) in objective.variables.iter().enumerate() {
            if j != i && variable.starts.len() > 1 {
                reshaped = true;
                position[j] = variable.position(variable.starts[variable.starts.len() / 2]);
            }
        }
        reshaped.then_some(position)
    }

    /// Best position with one variable moved and those at a bound at usual values: at a bound no gradient
    /// pulls them back, though a valley may lie inside.
    fn unparked(&self, objective: &Objective, i: usize, s: f64) -> Option<DVector<f64>> {
        let mut position = self.at(i, s.clamp(objective.variables[i].low, objective.variables[i].high));
        let mut parked = false;
        for (j, variable) in objective.variables.iter().enumerate().filter(|(j, _)| *j != i) {
            if variable.is_at_bound(position[j]) {
                parked = true;
                position[j] = variable
                    .starts
                    .get(variable.starts.len() / 2)
                    .map_or(position[j], |usual| variable.position(*usual));
            }
        }
        parked.then_some(position)
    }

    /// Finds the end of the valley around a point, in one direction, in the search variable: √Δχ² is nearly
    /// linear in it, so that secants find it in a few steps. The other variables begin where they were last,
    /// moved on as they moved before.
    fn end_from(&mut self, objective: &mut Objective, walk: &Walk, direction: f64, from: Point) -> Option<f64> {
        let (i, target) = (walk.along, self.quantile.sqrt());
        let origin = from.position[i];
        let (low, high) = objective.variables[i].within_reach(origin);
        let std = walk.std.min(high - low);
        let (mut inner, mut others) = (from, walk.others.clone());
        let mut outer: Option<(f64, f64)> = None;
        // Secants in a row that stayed inside.
        let mut inside = 0;
        let mut next = origin + direction * std * target;
        for _ in 0..TRIALS {
            let s = next.clamp(low, high);
            let gap = s - inner.position[i];
            if gap.abs() <= 1e-3 * outer.map_or(0.0, |o| (o.0 - origin).abs()) {
                break;
            }
            let mut start = inner.position.clone() + gap * &others;
            start
                .iter_mut()
                .zip(&objective.variables)
                .for_each(|(s, variable)| *s = s.clamp(variable.low, variable.high));
            start[i] = s;
            let mut still = inner.position.clone();
            still[i] = s;
            let start = lower(objective, start, still);
            let moved = start.and_then(|start| self.descend(objective, i, start));
            if self.deeper.is_some() {
                return None;
            }
            let risen = moved.as_ref().map_or(f64::INFINITY, |p| p.rise);
            match moved {
                Some(_) if (risen - target).abs() <= PRECISION => return Some(s),
                Some(moved) if risen <= target => {
                    others = (&moved.position - &inner.position) / gap;
                    inner = moved;
                    inside += 1;
                    if outer.is_none() && (s == low || s == high) {
                        // The bound itself still lies inside: the end is open there.
                        return None;
                    }
                }
                _ => {
                    outer = Some((s, risen));
                    inside = 0;
                }
            }
            let reached = inner.position[i];
            next = match outer {
                Some((s, risen)) => {
                    // A valley that is long and flat and then steep holds every secant back.
                    let part = if inside > 1 { 0.5 } else { (target - inner.rise) / (risen - inner.rise) };
                    reached + (s - reached) * part.clamp(0.1, 0.9)
                }
                None => {
                    let slope = (inner.rise / (reached - origin)).abs().max(1e-3 / std);
                    let far = (target * 1.05 / slope).min(4.0 * (reached - origin).abs());
                    origin + far.max(1.3 * (reached - origin).abs()) * direction
                }
            };
        }
        outer.map(|o| o.0)
    }

    /// Re-fits all variables but one.
    fn follow(&mut self, objective: &mut Objective, held: usize, start: DVector<f64>) -> Option<Point> {
        let start = objective.evaluate(start)?;
        self.descend(objective, held, start)
    }

    /// The same from where the model has been computed; the slopes of the best fit serve as long as they do.
    fn descend(&mut self, objective: &mut Objective, held: usize, start: Solution) -> Option<Point> {
        let start = Solution { slopes: self.best.slopes.clone(), ..start };
        let settled = resume(objective, start, &[held], FOLLOW);
        let rise = (settled.chi2 - self.best.chi2).max(0.0).sqrt();
        self.seen.push((objective.variables[held].value(settled.position[held]), rise * rise));
        if settled.chi2 < self.best.chi2 - DEEPER && !self.goes_on {
            self.deeper = Some(settled);
            return None;
        }
        Some(Point { position: settled.position, rise })
    }
}

/// The one of two positions at which χ² is lower; `None` where the model can be computed at neither.
fn lower(objective: &Objective, a: DVector<f64>, b: DVector<f64>) -> Option<Solution> {
    let both = [a, b].into_iter().filter_map(|position| objective.evaluate(position));
    both.min_by(|a, b| a.chi2.total_cmp(&b.chi2))
}

/// Direction of a profile: a search variable, its standard uncertainty from the curvature, and the movement
/// of all variables per unit of it.
struct Walk {
    along: usize,
    std: f64,
    others: DVector<f64>,
}

/// Point of a profile: the position with all variables but one re-fitted, and √Δχ² there.
struct Point {
    position: DVector<f64>,
    rise: f64,
}

/// Quantile of Δχ²: that of χ² where the noise is known, that of F where it is estimated from the residuals.
fn quantile(objective: &Objective) -> f64 {
    let freedom = objective.freedom().max(1.0);
    match objective.noise.source {
        NoiseSource::Column | NoiseSource::Covariance => QUANTILE,
        NoiseSource::Repeats | NoiseSource::Estimated => {
            FisherSnedecor::new(1.0, freedom).map_or(QUANTILE, |f| f.inverse_cdf(0.95))
        }
    }
}
