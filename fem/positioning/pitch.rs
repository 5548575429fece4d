//! Reversal and pitch errors by the scheme of seed 001: six points, five steps, there and back.
//!
//! P_i and N_i are the mean deviations at target i approached forwards and backwards, b_i = P_i − N_i. A
//! controller adds one value for backlash wherever the axis is; the best is midway, (b_max + b_min)/2, and
//! (b_max − b_min)/2 of reversal is left. The sign here is that of lost motion: b = N − P, positive where the
//! axis lags. Pitch errors are differences of deviations of one direction, in which the reversal does not
//! count: from target to target (relative) and from the first target of that direction (absolute; printed in
//! the seed for both directions from the first point forwards, which would mix the reversal in).

use super::{Direction, Evaluation, Target};

/// The reversal along an axis. m.
#[derive(Clone, Debug, PartialEq)]
pub struct Reversal {
    /// (position, lost motion N − P) of every target approached from both sides.
    pub lost: Vec<(f64, f64)>,
    /// The backlash value (b_max + b_min)/2.
    pub value: f64,
    /// The rest that no single value can remove, (b_max − b_min)/2.
    pub rest: f64,
}

/// Pitch errors of one target or step. m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Begin of the step; for absolute errors the first target.
    pub from: f64,
    /// End of the step.
    pub to: f64,
    /// Error d⁺ forwards.
    pub forward: Option<f64>,
    /// Error d⁻ backwards.
    pub backward: Option<f64>,
}

/// Pitch errors along an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct PitchErrors {
    /// Errors from target to target.
    pub relative: Vec<Step>,
    /// Errors from the first target of each direction.
    pub absolute: Vec<Step>,
}

impl Reversal {
    /// The reversal of a test; `None` where no target was approached from both sides.
    pub fn of(evaluation: &Evaluation) -> Option<Self> {
        let lost: Vec<(f64, f64)> =
            evaluation.targets.iter().filter_map(|t| Some((t.position, -t.reversal()?))).collect();
        let high = lost.iter().map(|b| b.1).fold(f64::NEG_INFINITY, f64::max);
        let low = lost.iter().map(|b| b.1).fold(f64::INFINITY, f64::min);
        (!lost.is_empty()).then_some(Self { value: 0.5 * (high + low), rest: 0.5 * (high - low), lost })
    }
}

impl Step {
    /// d = (d⁺ + d⁻)/2, or the one that is known.
    pub fn mean(&self) -> Option<f64> {
        match (self.forward, self.backward) {
            (Some(forward), Some(backward)) => Some(0.5 * (forward + backward)),
            (one, other) => one.or(other),
        }
    }
}

impl PitchErrors {
    /// The pitch errors of a test.
    pub fn of(evaluation: &Evaluation) -> Self {
        let targets = &evaluation.targets;
        let difference = |a: &Target, b: &Target, direction| Some(b.side(direction)?.mean - a.side(direction)?.mean);
        let step = |forward_from: &Target, backward_from: &Target, to: &Target| Step {
            from: forward_from.position.min(backward_from.position),
            to: to.position,
            forward: difference(forward_from, to, Direction::Forward),
            backward: difference(backward_from, to, Direction::Backward),
        };
        let first = |direction| targets.iter().find(|t| t.side(direction).is_some()).or(targets.first());
        let absolute = first(Direction::Forward).zip(first(Direction::Backward));
        Self {
            relative: targets.windows(2).map(|w| step(&w[0], &w[0], &w[1])).collect(),
            absolute: absolute.map_or_else(Vec::new, |(f, b)| targets.iter().map(|t| step(f, b, t)).collect()),
        }
    }
}
