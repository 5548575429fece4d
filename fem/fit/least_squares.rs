//! Levenberg–Marquardt within bounds. Damping is scaled by the size of each column, a variable that pushes
//! against its bound, or against a jump of the prediction, stands still, and a step to where the model cannot be computed
//! counts as too long. A step that falls short of what it promised is bent along the valley (Transtrum & Sethna, Improvements
//! to the Levenberg–Marquardt algorithm, 2012).

use std::sync::Arc;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::jacobian::{Differences, Jump};
use super::objective::{Objective, Solution};
use super::settle::settle;
use crate::process::Failure;

/// Criterion by which a search for a minimum stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriterion {
    /// Most steps.
    pub steps: usize,
    /// Fall of χ², as a part of 1 + χ², below which a step is the last.
    pub tolerance: f64,
    /// Differences of which Jacobians are made.
    pub differences: Differences,
}

impl StoppingCriterion {
    /// Full convergence.
    pub const FULL: Self = Self { steps: 200, tolerance: 1e-10, differences: Differences::Central };

    /// Convergence that is enough to go on from.
    pub const fn rough(steps: usize, tolerance: f64) -> Self {
        Self { steps, tolerance, differences: Differences::Forward }
    }

    /// Whether a minimum is sought, and not only how deep it may lie.
    fn is_precise(self) -> bool {
        self.tolerance <= PRECISE
    }
}

/// Finds the minimum near a position.
///
/// # Errors
/// The model cannot be computed there.
pub fn solve(objective: &mut Objective, start: &DVector<f64>) -> Result<Solution, Failure> {
    minimise(objective, start, &[], StoppingCriterion::FULL).ok_or_else(|| Failure {
        message: "the model cannot be computed where the fit begins".into(),
        help: "give the parameters values from which `fem run` works".into(),
    })
}

/// Minimises χ² from `start` with the variables `held` fixed; `None` where χ² cannot be computed at the
/// start.
pub fn minimise(
    objective: &mut Objective,
    start: &DVector<f64>,
    held: &[usize],
    stop: StoppingCriterion,
) -> Option<Solution> {
    let start = objective.evaluate(start.clone())?;
    Some(resume(objective, start, held, stop))
}

/// Where the Jacobian of a step is from.
#[derive(Clone, Copy, PartialEq)]
enum Origin {
    /// Differences, at this point.
    Differences,
    /// Slopes that an earlier search has made close by.
    Earlier,
    /// The last one, mended by what the step has seen.
    Mended,
}

/// Fall of χ² for which a size may be ten times less plausible.
const WORTH: f64 = 1.0;
/// Most times that a size may be that.
const DECADES: usize = 3;

/// Minimises χ², the variables `held` fixed, from where another search, of another noise or with none of them held, has left
/// it: as long as its slopes serve, a step costs one evaluation. Bounds that give way are passed as long as each is worth it.
pub fn resume(objective: &mut Objective, from: Solution, held: &[usize], stop: StoppingCriterion) -> Solution {
    for (variable, s) in objective.variables.iter_mut().zip(&from.position) {
        while variable.is_barred(*s) && !(variable.low..=variable.high).contains(s) {
            variable.give_way();
        }
    }
    let mut here = within_bounds(objective, from, held, stop);
    for _ in 0..DECADES {
        let is_barred = |i: &usize| !held.contains(i) && objective.variables[*i].is_barred(here.position[*i]);
        let barred: Vec<usize> = (0..objective.variables.len()).filter(is_barred).collect();
        if barred.is_empty() {
            break;
        }
        let before = objective.variables.clone();
        barred.iter().for_each(|i| objective.variables[*i].give_way());
        let further = within_bounds(objective, here.clone(), held, stop);
        if here.chi2 - further.chi2 < WORTH {
            objective.variables = before;
            break;
        }
        here = further;
    }
    settle(objective, here, held, |objective, from| within_bounds(objective, from, held, stop))
}

/// Descends to a minimum within the bounds. Between Jacobians by differences, each step mends the last one by what it has seen (Broyden
/// 1965); no search ends but on differences, its own or those by which an earlier one has ended close by.
fn within_bounds(objective: &mut Objective, from: Solution, held: &[usize], stop: StoppingCriterion) -> Solution {
    let mut here = from;
    let earlier = here.slopes.take();
    // With some held it has gone far from where they were made.
    let origin = if held.is_empty() { Origin::Earlier } else { Origin::Mended };
    let mut known = earlier.as_ref().map(|slopes| (objective.jacobian_of(slopes, &here.position), origin));
    let (mut damping, mut slopes, mut at_rest, mut is_doubted) = (LITTLE, earlier, false, false);
    let mut jumps = vec![None; objective.variables.len()];
    for _ in 0..stop.steps {
        if !objective.data.progress.permits("searches for a minimum to their end") {
            break;
        }
        let (jacobian, origin) = match known.take() {
            Some(known) => known,
            None => {
                let Some(own) = objective.slopes_about(&here, held, stop.differences) else { break };
                let jacobian = objective.jacobian_of(&own.matrix, &here.position);
                (slopes, jumps) = (Some(Arc::new(own.matrix)), own.jumps);
                (jacobian, Origin::Differences)
            }
        };
        let residuals = objective.residuals(&here.position, &here.predicted);
        let gradient = jacobian.transpose() * &residuals;
        let still = |i: usize| {
            let (variable, s) = (&objective.variables[i], here.position[i]);
            let is_barred_below = s <= variable.low || jumps[i] == Some(Jump::Below);
            let is_barred_above = s >= variable.high || jumps[i] == Some(Jump::Above);
            held.contains(&i) || (is_barred_below && gradient[i] > 0.0) || (is_barred_above && gradient[i] < 0.0)
        };
        let moving: Vec<usize> = (0..objective.variables.len()).filter(|i| !still(*i)).collect();
        let slope = Slope { jacobian: &jacobian, residuals: &residuals, gradient: &gradient, moving: &moving };
        let before = damping;
        let least = stop.tolerance * (1.0 + here.chi2);
        let descent = slope.descend(objective, &here, &mut damping, (origin, stop.is_precise()), least);
        let is_new = origin == Origin::Differences;
        let has_moved = matches!(descent, Descent::Lower(_));
        at_rest = match descent {
            Descent::Lower(step) => {
                let fall = here.chi2 - step.to.chi2;
                let is_last = fall <= least && (!stop.is_precise() || AS_PROMISED * step.promised <= least);
                if !is_last && fall >= AS_PROMISED * step.promised {
                    known = Some((slope.mended(objective, &here.position, &step.to), Origin::Mended));
                }
                here = step.to;
                is_doubted &= is_last;
                is_last && origin != Origin::Mended
            }
            Descent::Settled => origin != Origin::Mended,
            Descent::Barred => {
                damping = if is_new { damping } else { before };
                is_new
            }
        };
        // Under damping no step along a flat valley promises anything: once more, with next to none.
        if at_rest && damping > NEXT_TO_NONE && !is_doubted && stop.differences == Differences::Central {
            (damping, is_doubted, at_rest) = (NEXT_TO_NONE, true, false);
            known = (!has_moved).then_some((jacobian, origin));
        }
        if at_rest {
            break;
        }
    }
    // Those of a search that was cut short are of another place, and those with variables held are not all there.
    let is_at_rest = at_rest && held.is_empty();
    Solution { slopes: slopes.filter(|_| is_at_rest), is_at_rest, ..here }
}

/// Tolerance up to which a search is for a minimum. One that only sees how deep a valley may be ends where a step falls little,
/// and must come as far as plain steps do: the bend of one takes it where the next falls little.
const PRECISE: f64 = 1e-5;

/// Trials of the damping, with a Jacobian by differences and with a mended one.
const TRIALS: usize = 25;
const MENDED_TRIALS: usize = 2;
/// Part of the promised fall of χ² from which a Jacobian is mended and kept. A step that falls by less than is worth one is the
/// last if it has promised no more.
const AS_PROMISED: f64 = 0.5;
/// The same below which the step was too long (Moré 1978).
const POOR: f64 = 0.25;
/// Longest bend, as a part of the step, each variable measured by what it changes in the residuals by itself.
const MOST_BENT: f64 = 0.75;

/// Damping from which a search begins, and beyond which its end is doubted once.
const LITTLE: f64 = 1e-3;
const NEXT_TO_NONE: f64 = 1e-9;

/// Outcome of the damped steps of one linear model.
enum Descent {
    /// A step that lowers χ².
    Lower(Step),
    /// None does, and none promised a fall that is worth a step.
    Settled,
    /// No step that was tried lowers χ² as it promised.
    Barred,
}

/// A step that lowers χ².
struct Step {
    to: Solution,
    /// Fall of χ² by the linear model.
    promised: f64,
}

/// The linear model of the residuals about a point, in the variables that move.
struct Slope<'a> {
    jacobian: &'a DMatrix<f64>,
    residuals: &'a DVector<f64>,
    gradient: &'a DVector<f64>,
    moving: &'a [usize],
}

impl Slope<'_> {
    /// Finds the first damped step that lowers χ², as long as steps promise more than `least`.
    fn descend(
        &self,
        objective: &mut Objective,
        here: &Solution,
        damping: &mut f64,
        (origin, is_precise): (Origin, bool),
        least: f64,
    ) -> Descent {
        let (n, moving) = (self.moving.len(), self.moving);
        if n == 0 {
            return Descent::Settled;
        }
        let columns = DMatrix::from_fn(self.jacobian.nrows(), n, |r, c| self.jacobian[(r, moving[c])]);
        let normal = columns.transpose() * &columns;
        let downhill = DVector::from_fn(n, |i, _| -self.gradient[moving[i]]);
        let is_new = origin == Origin::Differences;
        for trial in 0..if is_new { TRIALS } else { MENDED_TRIALS } {
            let mut damped = normal.clone();
            for i in 0..n {
                damped[(i, i)] += *damping * normal[(i, i)].max(1e-30);
            }
            if let Some(factor) = damped.cholesky() {
                let (position, step) = self.moved(objective, &here.position, &factor.solve(&downhill));
                let promised = 2.0 * downhill.dot(&step) - step.dot(&(&normal * &step));
                let fall = |to: &Solution| here.chi2 - to.chi2;
                let straight = objective.evaluate(position);
                let short = straight
                    .as_ref()
                    .filter(|to| is_new && is_precise && promised > least && fall(to) < AS_PROMISED * promised);
                let bent = short.and_then(|to| self.bent(objective, &here.position, to, &columns, &factor));
                let bent = bent.filter(|to| fall(to) >= POOR * promised);
                let lower = bent.into_iter().chain(straight).filter(|to| fall(to) > 0.0);
                if let Some(to) = lower.min_by(|a, b| a.chi2.total_cmp(&b.chi2)) {
                    let is_poor = is_precise && fall(&to) < POOR * promised;
                    *damping = if is_poor { *damping * 4.0 } else { (*damping * 0.2).max(1e-12) };
                    return Descent::Lower(Step { to, promised });
                }
                if promised.abs() <= least {
                    return if trial == 0 || !is_precise { Descent::Settled } else { Descent::Barred };
                }
            }
            *damping *= 4.0;
        }
        Descent::Barred
    }

    /// The position after a step of the variables that move, and what of the step the bounds leave.
    fn moved(&self, objective: &Objective, from: &DVector<f64>, step: &DVector<f64>) -> (DVector<f64>, DVector<f64>) {
        let mut position = from.clone();
        for (&moved, by) in self.moving.iter().zip(step.iter()) {
            let variable = &objective.variables[moved];
            position[moved] = (position[moved] + by).clamp(variable.low, variable.high);
        }
        let left = DVector::from_iterator(step.len(), self.moving.iter().map(|&i| position[i] - from[i]));
        (position, left)
    }

    /// The step to a point bent along the valley in which it lies: by half the acceleration of the geodesic that sets out as
    /// the step does, told by the residuals that the linear model has missed at the point. `None` where the bend is no
    /// correction of the step, but another one.
    fn bent(
        &self,
        objective: &Objective,
        from: &DVector<f64>,
        to: &Solution,
        columns: &DMatrix<f64>,
        factor: &Cholesky<f64, Dyn>,
    ) -> Option<Solution> {
        let step = DVector::from_iterator(self.moving.len(), self.moving.iter().map(|&i| to.position[i] - from[i]));
        let missed = objective.residuals(&to.position, &to.predicted) - self.residuals - columns * &step;
        let bend = -factor.solve(&(columns.transpose() * missed));
        let length = |step: &DVector<f64>| {
            step.iter().zip(columns.column_iter()).map(|(s, column)| s * s * column.norm_squared()).sum::<f64>().sqrt()
        };
        (length(&bend) <= MOST_BENT * length(&step)).then_some(())?;
        objective.evaluate(self.moved(objective, from, &(step + bend)).0)
    }

    /// The Jacobian that gives what a step has changed, and is otherwise the nearest to this one, lengths
    /// measured in the units of the variables.
    fn mended(&self, objective: &Objective, from: &DVector<f64>, to: &Solution) -> DMatrix<f64> {
        let step = &to.position - from;
        let units = objective.variables.iter().map(|v| v.unit.powi(-2));
        let along = DVector::from_iterator(step.len(), step.iter().zip(units).map(|(s, w)| s * w));
        let seen = objective.residuals(&to.position, &to.predicted) - self.residuals;
        let missed = seen - self.jacobian * &step;
        self.jacobian + missed * along.transpose() / along.dot(&step)
    }
}
