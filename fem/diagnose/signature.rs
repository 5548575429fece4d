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
/// A column this much smaller than the largest is no column: the parameter does nothing by itself.
const NOTHING: f64 = 1e-9;

/// An effect that the model does not have, with its signatures.
pub struct Candidate {
    /// Which effect.
    pub effect: &'static Description,
    /// Signatures over the grid of its shapes; empty where it cannot be computed.
    pub variants: Vec<Variant>,
    /// Number of its parameters.
    pub parameters: usize,
}

/// The signature of an effect at one choice of its shapes.
pub struct Variant {
    /// Search variables of all parameters of the effect, those that switch it at neutral.
    pub position: Vec<f64>,
    /// Which of its parameters switch it.
    pub switches: Vec<usize>,
    /// Whether each of them may be negative.
    pub signed: Vec<bool>,
    /// Change of every row in standard uncertainties per unit of the search variable, zeros for the priors; one column per switch.
    pub columns: DMatrix<f64>,
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
        let middle = |i: usize| self.axes[i].grid(1)[0];
        let shapes: Vec<usize> =
            (0..neutral.len()).filter(|i| effect.parameters[*i].neutral == Neutral::Shape).collect();
        let mut at = neutral.clone();
        shapes.iter().for_each(|i| at[*i] = middle(*i));
        let others: Vec<usize> = (0..neutral.len()).filter(|i| !shapes.contains(i)).collect();
        let sizes: Vec<f64> =
            others.iter().map(|i| self.column(&at, *i).map_or(0.0, |c| c.norm() * self.step(*i))).collect();
        let largest = sizes.iter().fold(0.0f64, |m, s| m.max(*s));
        // A parameter that does nothing by itself shapes the others: convection without heat.
        let (switches, idle): (Vec<_>, Vec<_>) =
            others.iter().zip(&sizes).partition(|(_, size)| **size > NOTHING * largest);
        let switches: Vec<usize> = switches.into_iter().map(|(i, _)| *i).collect();
        let mut grids: Vec<(usize, Vec<f64>)> = Vec::new();
        let alone = shapes.len() == 1;
        for &i in &shapes {
            let count = match effect.parameters[i].along {
                Some(_) => PLACE,
                None if alone => ALONE,
                None => TOGETHER,
            };
            grids.push((i, self.axes[i].grid(count)));
        }
        for (&i, _) in idle {
            let entry = &effect.parameters[i];
            let plausible = |v: f64| self.axes[i].position(entry.kind.to_si(v));
            let (low, high) = entry.range;
            grids.push((i, vec![neutral[i], plausible(low), plausible((low * high).abs().sqrt()), plausible(high)]));
        }
        let points = combinations(&grids, &at);
        points.into_iter().filter_map(|position| self.variant(effect, position, &switches)).collect()
    }

    fn variant(&mut self, effect: &'static Description, position: Vec<f64>, switches: &[usize]) -> Option<Variant> {
        let columns: Vec<DVector<f64>> = switches.iter().map(|i| self.column(&position, *i)).collect::<Option<_>>()?;
        let signed = switches
            .iter()
            .map(|i| effect.parameters[*i].neutral != Neutral::Infinity && effect.parameters[*i].bounds == Bounds::Any);
        (!columns.is_empty()).then(|| Variant {
            signed: signed.collect(),
            switches: switches.to_vec(),
            columns: DMatrix::from_columns(&columns),
            position,
        })
    }

    /// A usual size of a switch, to divide by.
    fn step(&self, parameter: usize) -> f64 {
        let axis = &self.axes[parameter];
        axis.unit.min(axis.high - axis.neutral())
    }

    /// Change of the standardised prediction per unit of one switch, from neutral to a usual size of it.
    fn column(&mut self, position: &[f64], parameter: usize) -> Option<DVector<f64>> {
        let step = self.step(parameter);
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
