//! Signatures: what each absent effect would change in every row, by re-running the model with it.
//!
//! What switches an effect (an amplitude, a compliance) enters almost linearly and gives one column each: the change of the prediction per
//! unit. What shapes it (a time constant, an exponent, a place) does not, and is tried on a grid; each point of the grid is a
//! [`Variant`] with columns of its own.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use crate::fit::{Axis, Objective, Solution};
use crate::input::Bounds;
use crate::process::{Description, Neutral};

/// Points of the grid along a single shape, a place, and each of several shapes.
const ALONE: usize = 10;
const PLACE: usize = 16;
const TOGETHER: usize = 6;

/// An effect is a square that differs from one by less than this part.
const SQUARE: f64 = 0.1;

/// An effect that the model does not have, with its signatures.
#[derive(Clone)]
pub struct Candidate {
    /// Which effect.
    pub effect: &'static Description,
    /// Signatures over the grid of its shapes; empty where it cannot be computed.
    pub variants: Vec<Variant>,
    /// Number of its parameters.
    pub parameters: usize,
}

/// The signature of an effect at one choice of its shapes.
#[derive(Clone)]
pub struct Variant {
    /// Search variables of all parameters of the effect, those that switch it at neutral.
    pub position: Vec<f64>,
    /// Which of its parameters switch it.
    pub switches: Vec<Switch>,
    /// Whether the amplitude of each column may be negative.
    pub signed: Vec<bool>,
    /// Change of every row in standard uncertainties per unit of the search variable, zeros for the priors; one column per switch.
    pub columns: DMatrix<f64>,
}

/// A parameter that switches an effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// Which of the effect's.
    pub parameter: usize,
    /// The size at which its column was computed, in the search variable.
    pub size: f64,
    /// Whether the effect grows with its square, the same for either sign of it.
    is_square: bool,
}

impl Switch {
    /// The search variable, from neutral, that gives this amplitude of the column.
    pub fn value(&self, amplitude: f64) -> f64 {
        if self.is_square { (amplitude.max(0.0) * self.size).sqrt() } else { amplitude }
    }
}

impl Variant {
    /// The position with these amplitudes.
    pub fn position(&self, amplitudes: &[f64], axes: &[Axis]) -> Vec<f64> {
        let mut position = self.position.clone();
        for (switch, amplitude) in self.switches.iter().zip(amplitudes) {
            let axis = &axes[switch.parameter];
            let place = &mut position[switch.parameter];
            *place = (*place + switch.value(*amplitude)).clamp(axis.low, axis.high);
        }
        position
    }
}

/// The signatures of all `effects` about a solution of the model without them.
pub fn candidates(objective: &Objective, base: &Solution, effects: &[&'static Description]) -> Vec<Candidate> {
    effects.par_iter().map(|effect| candidate(objective, base, effect)).collect()
}

fn candidate(objective: &Objective, base: &Solution, effect: &'static Description) -> Candidate {
    let mut trial = objective.with(effect);
    let axes = trial.axes[objective.axes.len()..].to_vec();
    let mut probe = Probe { trial: &mut trial, base, axes: &axes };
    let variants = probe.variants(effect);
    Candidate { effect, variants, parameters: axes.len() }
}

struct Probe<'a, 'm> {
    trial: &'a mut Objective<'m>,
    base: &'a Solution,
    axes: &'a [Axis],
}

impl Probe<'_, '_> {
    fn variants(&mut self, effect: &'static Description) -> Vec<Variant> {
        let neutral: Vec<f64> = self.axes.iter().map(Axis::neutral).collect();
        let shapes: Vec<usize> =
            (0..neutral.len()).filter(|i| effect.parameters[*i].neutral == Neutral::Shape).collect();
        let alone = shapes.len() == 1;
        let grid = |i: &usize| {
            let count = match effect.parameters[*i].along {
                Some(_) => PLACE,
                None if alone => ALONE,
                None => TOGETHER,
            };
            let axis = &self.axes[*i];
            // What comes round is tried once around.
            match effect.parameters[*i].period.map(|p| 0.5 * effect.parameters[*i].kind.to_si(p)) {
                Some(half) => (*i, axis.grid_within(-half, half, count)),
                None => (*i, axis.grid(count)),
            }
        };
        let grids: Vec<(usize, Vec<f64>)> = shapes.iter().map(grid).collect();
        let points = combinations(&grids, &neutral);
        let Some(first) = points.first() else { return Vec::new() };
        let own = (0..neutral.len()).filter(|i| !shapes.contains(i));
        let switches: Vec<Switch> = own.map(|i| self.switch(first, i)).collect();
        points.into_iter().filter_map(|position| self.variant(effect, position, &switches)).collect()
    }

    /// The switch that a parameter is, tried with the shapes of `at`.
    fn switch(&mut self, at: &[f64], parameter: usize) -> Switch {
        let axis = &self.axes[parameter];
        let (neutral, size) = (axis.neutral(), axis.unit.min(axis.high - axis.neutral()));
        let both = axis.low <= neutral - size;
        // Per unit: the same from the other side for what is linear, the opposite for a square; from half as far the same, or half.
        let (other, sign) = if both { (-size, -1.0) } else { (0.5 * size, 2.0) };
        let is_square = match (self.column(at, parameter, size), self.column(at, parameter, other)) {
            (Some(far), Some(near)) => (&far - sign * &near).norm() < SQUARE * far.norm(),
            _ => false,
        };
        Switch { parameter, size, is_square }
    }

    fn variant(&mut self, effect: &'static Description, position: Vec<f64>, switches: &[Switch]) -> Option<Variant> {
        let columns: Vec<DVector<f64>> =
            switches.iter().map(|s| self.column(&position, s.parameter, s.size)).collect::<Option<_>>()?;
        let signed = switches.iter().map(|s| {
            let entry = &effect.parameters[s.parameter];
            entry.neutral != Neutral::Infinity && entry.bounds == Bounds::Any && !s.is_square
        });
        (!columns.is_empty()).then(|| Variant {
            signed: signed.collect(),
            switches: switches.to_vec(),
            columns: DMatrix::from_columns(&columns),
            position,
        })
    }

    /// Change of the standardised prediction per unit of one switch, from neutral to `step` beside it.
    fn column(&mut self, position: &[f64], parameter: usize, step: f64) -> Option<DVector<f64>> {
        let mut moved = position.to_vec();
        moved[parameter] += step;
        let own = self.base.position.iter().copied();
        let there = DVector::from_iterator(own.len() + moved.len(), own.chain(moved));
        let predicted = self.trial.predict(&there)?;
        let rows = predicted.iter().zip(&self.base.predicted).zip(&self.trial.noise.sigma);
        let change = rows.map(|((p, q), sigma)| (p - q) / sigma / step);
        let priors = std::iter::repeat_n(0.0, self.trial.priors());
        Some(DVector::from_vec(change.chain(priors).collect()))
    }
}

/// Every combination of the grids' values, all else as in `at`.
fn combinations(grids: &[(usize, Vec<f64>)], at: &[f64]) -> Vec<Vec<f64>> {
    let mut points = vec![at.to_vec()];
    for (i, values) in grids {
        let spread = |point: &Vec<f64>| {
            let with = |v: &f64| {
                let mut moved = point.clone();
                moved[*i] = *v;
                moved
            };
            values.iter().map(with).collect::<Vec<_>>()
        };
        points = points.iter().flat_map(spread).collect();
    }
    points
}
