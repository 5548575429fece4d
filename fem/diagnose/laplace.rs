//! The marginal likelihood of a set of effects by Laplace's approximation, and with the prior odds of its effects its
//! posterior weight.
//!
//! −2 ln Z = χ² − 2 ln p(u) + ln |JᵀJ + P|, at the most probable point. Sizes enter by their logarithm, in which a usual
//! size has a normal distribution with heavy tails (Student's t): a size a hundred times the usual costs as much as one
//! standard deviation more of a few rows; beyond that a set has no weight. The most probable point is found in the linear
//! model of the prediction about the best fit: along what the data cannot tell the usual decides, and no run of the
//! model is needed. (MacKay 2003, chapter 27; Kass and Raftery 1995.)

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::candidate_model::CandidateModel;
use crate::fit::Usual;
use crate::process::{Description, Neutral, Parameter};

/// Degrees of freedom of the distribution of what is usual.
const TAILS: f64 = 4.0;
/// Steps by which the most probable point is found.
const STEPS: usize = 30;
/// Standard deviations below the centre at which the logarithm of a vanishing size begins.
const VANISHING: f64 = 4.0;
/// Standard deviation of a parameter of the model of which nothing is known, in its own unit.
const ANYWHERE: f64 = 100.0;

/// −2 ln of the marginal likelihood of a fitted model times the prior odds of what was added to it; `None` where the model
/// cannot be computed beside its best values, or explains the rows by a size that no machine has.
pub fn criterion(trial: &CandidateModel) -> Option<f64> {
    let mut values = trial.objective.variables.iter().zip(&trial.solution.position);
    if values.any(|(variable, position)| variable.is_beyond_belief(*position)) {
        return None;
    }
    Some(minus_two_log(trial)? + price(trial))
}

/// The same where nothing is held to be usual: each value that was added costs ln n (Schwarz 1978). By it sets of effects are
/// held against laws, of whose constants nobody knows what is usual.
pub fn criterion_of_values(trial: &CandidateModel) -> f64 {
    let CandidateModel { objective, solution, .. } = trial;
    let added = objective.variables.len() - objective.data.model.parameters.len();
    let likelihood = misfit(trial, solution.chi2) + objective.noise.log_determinant();
    likelihood + price(trial) + added as f64 * (objective.data.len() as f64).ln()
}

/// −2 ln of the prior odds of what was added to a model, and the price of its noise.
fn price(trial: &CandidateModel) -> f64 {
    let objective = &trial.objective;
    objective.added.iter().map(|effect| -2.0 * effect.odds.to_one.ln()).sum::<f64>() + objective.noise.price()
}

/// Weight of a set with a criterion beside one with another: the ratio of their probabilities.
pub fn weight(criterion: f64, beside: f64) -> f64 {
    (0.5 * (beside - criterion)).exp()
}

/// −2 ln of the marginal likelihood.
fn minus_two_log(trial: &CandidateModel) -> Option<f64> {
    let linear = Linear::about(trial)?;
    let (here, factor) = linear.most_probable()?;
    let volume = 2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
    let misfit = misfit(trial, trial.solution.chi2);
    Some(misfit + here.value + volume + linear.unseen(trial, &here) + trial.objective.noise.log_determinant())
}

/// Signature, in standard uncertainties of the rows, below which an effect is not asked for: that it is there by less than
/// the rows show, nobody learns from them.
const ASKED_FOR: f64 = 4.0;

/// What data and prior leave of the parameters of a fitted set.
pub struct Left {
    /// Step from the fit to the most probable point, in the search variables.
    pub step: DVector<f64>,
    /// A root of their covariance: V = root·rootᵀ.
    pub root: DMatrix<f64>,
}

/// What data and prior leave of the parameters of a fitted set; `None` where the model cannot be computed beside its best
/// values.
pub fn left(trial: &CandidateModel) -> Option<Left> {
    let linear = Linear::about(trial)?;
    let (here, factor) = linear.most_probable()?;
    // The covariance of u is H⁻¹ = L⁻ᵀL⁻¹.
    let mut root = factor.l().tr_solve_lower_triangular(&DMatrix::identity(here.u.len(), here.u.len()))?;
    for (i, slope) in here.slopes.iter().enumerate() {
        root.row_mut(i).scale_mut(*slope);
    }
    Some(Left { step: here.step, root })
}

/// The parameters of a fitted model as the prior sees them.
fn axes(trial: &CandidateModel) -> Vec<Axis> {
    let variables = trial.objective.variables.iter().zip(&trial.solution.position);
    variables.map(|(v, at)| Axis::new(v.usual, v.unit, *at)).collect()
}

/// How far each value of a fitted set is from what is usual of it, in standard deviations of that.
pub fn deviations(trial: &CandidateModel) -> Vec<f64> {
    axes(trial).iter().zip(&trial.solution.position).map(|(axis, s)| axis.from(*s)).collect()
}

/// Price of a noise that is larger than what is known of it, beyond that of the effect of the measurement that says so.
const UNSAID: f64 = 12.0;

/// −2 ln of the likelihood, less a constant, of a model that leaves this χ².
pub fn misfit(trial: &CandidateModel, chi2: f64) -> f64 {
    misfit_and_level(trial, chi2).0
}

/// The same, and the variance of the noise in units of what is known or assumed of it. What a set leaves beyond the noise is
/// no reason to believe in more effects as if these were all that could be wrong: it may count as noise, at a price.
fn misfit_and_level(trial: &CandidateModel, chi2: f64) -> (f64, f64) {
    let objective = &trial.objective;
    let rows = objective.data.len() as f64;
    let level = (chi2 / objective.freedom().max(1.0)).max(f64::MIN_POSITIVE);
    let free = rows * level.ln() + chi2 / level;
    if !objective.noise.source.is_known() {
        return (free, level);
    }
    let larger = free + rows.ln() + UNSAID;
    if level > 1.0 && larger < chi2 { (larger, level) } else { (chi2, 1.0) }
}

/// A parameter as the prior sees it: u has a standard deviation of one.
enum Axis {
    /// s = ± exp(centre + spread·u).
    Size { centre: f64, spread: f64 },
    /// s = centre + spread·u.
    Place { centre: f64, spread: f64 },
    /// s = spread·u, and u is normal.
    Adjusted { spread: f64 },
    /// s stays where it is, one of so many places: a step has no slope.
    OneOf { at: f64, places: f64 },
}

impl Axis {
    fn new(usual: Option<Usual>, unit: f64, at: f64) -> Self {
        match usual {
            Some(Usual::OneOf(count)) => Self::OneOf { at, places: count as f64 },
            Some(Usual::Size { centre, spread }) => Self::Size { centre, spread },
            Some(Usual::Place { centre, spread }) => Self::Place { centre, spread },
            Some(Usual::Adjusted { spread }) => Self::Adjusted { spread },
            None => Self::Adjusted { spread: ANYWHERE * unit },
        }
    }

    /// The prior's variable where the search stands.
    fn from(&self, s: f64) -> f64 {
        match self {
            Self::Size { centre, spread } => ((s.abs().ln() - centre) / spread).max(-VANISHING),
            Self::Place { centre, spread } => (s - centre) / spread,
            Self::Adjusted { spread } => s / spread,
            Self::OneOf { .. } => 0.0,
        }
    }

    /// The search variable and its slope; the sign is that of where the search stands.
    fn to(&self, u: f64, sign: f64) -> (f64, f64) {
        match self {
            Self::Size { centre, spread } => {
                let s = sign * (centre + spread * u).exp();
                (s, spread * s)
            }
            Self::Place { centre, spread } => (centre + spread * u, *spread),
            Self::Adjusted { spread } => (spread * u, *spread),
            Self::OneOf { at, .. } => (*at, 0.0),
        }
    }

    /// −2 ln of its density, and half of that's slope over u.
    fn price(&self, u: f64) -> (f64, f64) {
        match self {
            Self::Adjusted { .. } => (u * u, 1.0),
            Self::OneOf { places, .. } => (2.0 * places.ln(), 1.0),
            _ => ((TAILS + 1.0) * (u * u / TAILS).ln_1p(), (TAILS + 1.0) / (TAILS + u * u)),
        }
    }
}

/// The linear model of the residuals about a fit, in units of the noise.
struct Linear {
    jacobian: DMatrix<f64>,
    level: f64,
    normal: DMatrix<f64>,
    gradient: DVector<f64>,
    at: DVector<f64>,
    axes: Vec<Axis>,
}

/// A point of the linear model.
struct Point {
    u: DVector<f64>,
    step: DVector<f64>,
    slopes: DVector<f64>,
    weights: DVector<f64>,
    /// Rise of χ² from the fit and the price of what is unusual.
    value: f64,
}

impl Linear {
    fn about(trial: &CandidateModel) -> Option<Self> {
        let objective = &trial.objective;
        let jacobian = trial.jacobian()?;
        let residuals = objective.residuals(&trial.solution.position, &trial.solution.predicted);
        let (_, level) = misfit_and_level(trial, trial.solution.chi2);
        Some(Self {
            level,
            normal: jacobian.tr_mul(&jacobian) / level,
            gradient: jacobian.tr_mul(&residuals) / level,
            at: trial.solution.position.clone(),
            axes: axes(trial),
            jacobian,
        })
    }

    /// What it costs to bring the effects that were added to the size at which they are asked for, where the rows let
    /// them fade away.
    fn unseen(&self, trial: &CandidateModel, here: &Point) -> f64 {
        let mut first = trial.objective.data.model.parameters.len();
        let there: Vec<f64> = self.at.iter().zip(here.step.iter()).map(|(at, step)| at + step).collect();
        let of = |effect: &Description| {
            let own = first..first + effect.parameters.len();
            first = own.end;
            let sizes = own.zip(effect.parameters.iter()).filter(|(_, parameter)| parameter.neutral != Neutral::Shape);
            let signature = sizes.fold(DVector::zeros(self.jacobian.nrows()), |sum: DVector<f64>, (i, _)| {
                sum + self.jacobian.column(i) * (there[i] - trial.objective.neutral_at(i, &there))
            });
            (ASKED_FOR - signature.norm() / self.level.sqrt()).max(0.0).powi(2)
        };
        trial.objective.added.iter().map(of).sum()
    }

    /// The most probable point, and the factor of the curvature there.
    fn most_probable(&self) -> Option<(Point, Cholesky<f64, Dyn>)> {
        let n = self.at.len();
        let mut here = self.point(DVector::from_fn(n, |i, _| self.axes[i].from(self.at[i])));
        let mut damping = 1e-3;
        for _ in 0..STEPS {
            let curvature = self.curvature(&here);
            let along = &self.gradient + &self.normal * &here.step;
            let downhill = DVector::from_fn(n, |i, _| -(here.slopes[i] * along[i] + here.weights[i] * here.u[i]));
            let mut damped = curvature;
            for i in 0..n {
                damped[(i, i)] += damping * (1.0 + damped[(i, i)]);
            }
            let Some(factor) = Cholesky::new(damped) else {
                damping *= 10.0;
                continue;
            };
            let step = factor.solve(&downhill).map(|step| step.clamp(-2.0, 2.0));
            let there = self.point(&here.u + &step);
            let fall = here.value - there.value;
            if fall > 0.0 {
                here = there;
                damping *= 0.2;
                if fall < 1e-3 {
                    break;
                }
            } else {
                damping *= 8.0;
                if damping > 1e8 {
                    break;
                }
            }
        }
        let factor = Cholesky::new(self.curvature(&here))?;
        Some((here, factor))
    }

    fn point(&self, u: DVector<f64>) -> Point {
        let n = u.len();
        let (mut step, mut slopes, mut weights) = (DVector::zeros(n), DVector::zeros(n), DVector::zeros(n));
        let mut price = 0.0;
        for i in 0..n {
            let sign = if self.at[i] < 0.0 { -1.0 } else { 1.0 };
            let (s, slope) = self.axes[i].to(u[i], sign);
            let (own, weight) = self.axes[i].price(u[i]);
            (step[i], slopes[i], weights[i]) = (s - self.at[i], slope, weight);
            price += own;
        }
        let value = 2.0 * self.gradient.dot(&step) + step.dot(&(&self.normal * &step)) + price;
        Point { u, step, slopes, weights, value }
    }

    /// Half of the second derivatives of −2 ln of the posterior over u.
    fn curvature(&self, point: &Point) -> DMatrix<f64> {
        let n = point.u.len();
        DMatrix::from_fn(n, n, |r, c| {
            point.slopes[r] * self.normal[(r, c)] * point.slopes[c] + if r == c { point.weights[r] } else { 0.0 }
        })
    }
}

/// Price of the part after which something happened, of a dozen.
const STEP: f64 = 5.0;

/// Price of an effect at a usual size among a hundred rows, odds included, by which sets are ranked before they are
/// fitted.
pub fn usual_price(effect: &Description) -> f64 {
    let of = |parameter: &Parameter| match parameter.neutral {
        Neutral::Shape if parameter.is_step => STEP,
        Neutral::Shape => 2.0,
        _ => 5.0,
    };
    effect.parameters.iter().map(of).sum::<f64>() - 2.0 * effect.odds.to_one.ln()
}
