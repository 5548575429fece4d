//! Sensitivities: the change that each candidate effect would make in every row, by running the model with
//! it.
//!
//! A linear parameter (an amplitude, a compliance) enters almost linearly and gives one column: the change
//! of the prediction per unit. A nonlinear parameter (a time constant, an exponent, a place) is tried on a
//! grid; each point of the grid is a [`Variant`] with columns of its own.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use crate::fit::{Objective, SearchVariable, Solution};
use crate::input::Bounds;
use crate::process::{Description, Neutral};

/// Points of the grid along a single nonlinear parameter, a place, and each of several nonlinear parameters.
const ALONE: usize = 10;
const PLACE: usize = 16;
const TOGETHER: usize = 6;

/// Relative difference up to which an effect counts as quadratic in a parameter.
const SQUARE: f64 = 0.1;

/// Effect that the model does not have, with its sensitivities.
#[derive(Clone)]
pub struct CandidateEffect {
    /// The effect.
    pub effect: Description,
    /// Sensitivities over the grid of its nonlinear parameters; empty where they cannot be computed.
    pub variants: Vec<Variant>,
    /// Number of its parameters.
    pub parameters: usize,
}

/// Sensitivities of an effect at one point of the grid of its nonlinear parameters.
#[derive(Clone)]
pub struct Variant {
    /// Search variables of all parameters of the effect, the linear ones at neutral.
    pub position: Vec<f64>,
    /// Linear parameters of the effect.
    pub linear: Vec<LinearParameter>,
    /// Whether the amplitude of each column may be negative.
    pub signed: Vec<bool>,
    /// Change of every row in standard uncertainties per unit of the search variable, zeros for the priors;
    /// one column per linear parameter.
    pub columns: DMatrix<f64>,
}

/// Parameter in which an effect is linear or quadratic; at its neutral value the effect vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearParameter {
    /// Number among the effect's parameters.
    pub parameter: usize,
    /// Size at which its column was computed, in the search variable.
    pub size: f64,
    /// Whether the effect is quadratic in it, the same for either sign.
    is_square: bool,
}

impl LinearParameter {
    /// Search variable, from neutral, that gives this amplitude of the column.
    pub fn value(&self, amplitude: f64) -> f64 {
        if self.is_square { (amplitude.max(0.0) * self.size).sqrt() } else { amplitude }
    }
}

impl Variant {
    /// Position with these amplitudes.
    pub fn position(&self, amplitudes: &[f64], variables: &[SearchVariable]) -> Vec<f64> {
        let mut position = self.position.clone();
        for (parameter, amplitude) in self.linear.iter().zip(amplitudes) {
            let variable = &variables[parameter.parameter];
            let place = &mut position[parameter.parameter];
            *place = (*place + parameter.value(*amplitude)).clamp(variable.low, variable.high);
        }
        position
    }
}

/// Computes the sensitivities of all `effects` about a solution of the model without them.
pub fn candidates(objective: &Objective, base: &Solution, effects: &[Description]) -> Vec<CandidateEffect> {
    effects.par_iter().map(|effect| candidate(objective, base, effect)).collect()
}

fn candidate(objective: &Objective, base: &Solution, effect: &Description) -> CandidateEffect {
    let mut trial = objective.with(effect);
    let variables = trial.variables[objective.variables.len()..].to_vec();
    if !objective.data.progress.permits(&format!("what `{}` would change", effect.name)) {
        return CandidateEffect { effect: effect.clone(), variants: Vec::new(), parameters: variables.len() };
    }
    let mut probe = Probe { trial: &mut trial, base, variables: &variables };
    let variants = probe.variants(effect);
    CandidateEffect { effect: effect.clone(), variants, parameters: variables.len() }
}

struct Probe<'a, 'm> {
    trial: &'a mut Objective<'m>,
    base: &'a Solution,
    variables: &'a [SearchVariable],
}

impl Probe<'_, '_> {
    fn variants(&mut self, effect: &Description) -> Vec<Variant> {
        let neutral: Vec<f64> = self.variables.iter().map(SearchVariable::neutral).collect();
        let nonlinear: Vec<usize> =
            (0..neutral.len()).filter(|i| effect.parameters[*i].neutral == Neutral::Shape).collect();
        let alone = nonlinear.len() == 1;
        let grid = |i: &usize| {
            let count = match effect.parameters[*i].along {
                Some(_) => PLACE,
                None if alone => ALONE,
                None => TOGETHER,
            };
            let variable = &self.variables[*i];
            // A periodic parameter is tried over one period.
            match effect.parameters[*i].period.map(|p| 0.5 * effect.parameters[*i].kind.to_si(p)) {
                Some(half) => (*i, variable.grid_within(-half, half, count)),
                None => (*i, variable.grid(count)),
            }
        };
        let grids: Vec<(usize, Vec<f64>)> = nonlinear.iter().map(grid).collect();
        let points = combinations(&grids, &neutral);
        let Some(first) = points.first() else { return Vec::new() };
        let own = (0..neutral.len()).filter(|i| !nonlinear.contains(i));
        let linear: Vec<LinearParameter> = own.map(|i| self.linear(first, i)).collect();
        let name = format!("shapes of `{}`", effect.name);
        let mut variants = Vec::new();
        for position in points {
            // One shape is enough to try an effect at all.
            if !variants.is_empty() && !self.trial.data.progress.permits(&name) {
                break;
            }
            variants.extend(self.variant(effect, position, &linear));
        }
        variants
    }

    /// Tries whether a parameter is linear or quadratic, at the nonlinear parameters of `at`.
    fn linear(&mut self, at: &[f64], parameter: usize) -> LinearParameter {
        let variable = &self.variables[parameter];
        let (neutral, size) = (variable.neutral(), variable.unit.min(variable.high - variable.neutral()));
        let both = variable.low <= neutral - size;
        // The change per unit is the same from the other side if linear and opposite if quadratic; from half
        // as far it is the same, or half.
        let (other, sign) = if both { (-size, -1.0) } else { (0.5 * size, 2.0) };
        let is_square = match (self.column(at, parameter, size), self.column(at, parameter, other)) {
            (Some(far), Some(near)) => (&far - sign * &near).norm() < SQUARE * far.norm(),
            _ => false,
        };
        LinearParameter { parameter, size, is_square }
    }

    fn variant(&mut self, effect: &Description, position: Vec<f64>, linear: &[LinearParameter]) -> Option<Variant> {
        let columns: Vec<DVector<f64>> =
            linear.iter().map(|s| self.column(&position, s.parameter, s.size)).collect::<Option<_>>()?;
        let signed = linear.iter().map(|s| {
            let entry = &effect.parameters[s.parameter];
            entry.neutral != Neutral::Infinity && entry.bounds == Bounds::Any && !s.is_square
        });
        (!columns.is_empty()).then(|| Variant {
            signed: signed.collect(),
            linear: linear.to_vec(),
            columns: DMatrix::from_columns(&columns),
            position,
        })
    }

    /// Change of the standardised prediction per unit of one linear parameter, from neutral to `step` beside
    /// it.
    fn column(&mut self, position: &[f64], parameter: usize, step: f64) -> Option<DVector<f64>> {
        let mut moved = position.to_vec();
        moved[parameter] += step;
        let own = self.base.position.iter().copied();
        let there = DVector::from_iterator(own.len() + moved.len(), own.chain(moved));
        let predicted = self.trial.predict(&there)?;
        Some(self.trial.whiten(predicted.iter().zip(&self.base.predicted).map(|(p, q)| (p - q) / step)))
    }
}

/// Makes every combination of the grids' values, all else as in `at`.
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
