//! Candidate model: the model with a set of effects more, fitted.

use std::sync::Arc;

use nalgebra::DVector;

use super::sensitivity::CandidateEffect;
use crate::fit::{Objective, Solution};
use crate::noise::MEASUREMENT;
use crate::process::Neutral;
use crate::units::{PERIOD, TIME};

/// Penalty in χ² on an added effect that is larger than is plausible.
const IMPLAUSIBLE: f64 = 6.0;

/// Penalty in χ² on a scale or a clock of the instrument, which somebody has adjusted: where the machine may be at fault
/// as well, it is named, and the instrument beside it.
const ADJUSTED: f64 = 6.0;

/// Factor beyond the plausible range at which no effect is believed, though it explains everything.
const ABSURD: f64 = 3.0;

/// Model with some candidate effects more, fitted.
#[derive(Clone)]
pub struct CandidateModel<'a> {
    /// Numbers of the candidate effects that were added, in the order of adding.
    pub members: Vec<usize>,
    /// Objective that was minimised.
    pub objective: Objective<'a>,
    /// Minimum of the objective.
    pub solution: Solution,
    /// Part of the fall of χ² that was promised to first order, and kept by the fit; 1 where nothing was.
    pub kept: f64,
}

impl CandidateModel<'_> {
    /// Residuals of the rows, SI.
    pub fn residuals(&self) -> Vec<f64> {
        self.objective.data.residuals(&self.solution.predicted)
    }

    /// Penalised BIC by which candidate models are ranked: χ² with a penalty on every parameter (Schwarz
    /// 1978), on every effect that is larger than is plausible, and on every one of the instrument.
    pub fn penalised_bic(&self) -> f64 {
        self.solution.chi2 + self.penalty()
    }

    /// Penalty on the parameters, on what is larger than is plausible, and on what is the instrument's.
    pub fn penalty(&self) -> f64 {
        let parameters = self.objective.variables.len() - self.objective.priors();
        parameters as f64 * (self.objective.data.len() as f64).ln()
            + IMPLAUSIBLE * self.implausible() as f64
            + ADJUSTED * self.objective.added.iter().filter(|d| d.table == MEASUREMENT).count() as f64
    }

    /// By how much its prediction of every row differs from that of another model, SI.
    pub fn change_from(&self, other: &CandidateModel) -> impl Iterator<Item = f64> {
        self.solution.predicted.iter().zip(&other.solution.predicted).map(|(own, other)| own - other)
    }

    /// Whether its prediction differs from that of another model by the same wherever rows are of the same level.
    pub fn goes_by(&self, other: &CandidateModel, levels: &[usize]) -> bool {
        /// Largest share of the difference's variance within levels.
        const WITHIN: f64 = 0.01;
        let change: Vec<f64> = self.change_from(other).collect();
        sum_of_squares(&change, levels) < WITHIN * sum_of_squares(&change, &vec![0; change.len()])
    }

    /// Number of added effects that are larger than is plausible.
    fn implausible(&self) -> usize {
        let own = self.objective.data.model.parameters.len();
        (own..self.objective.variables.len()).filter(|i| self.is_too_large(*i, 1.0)).count()
    }

    /// Whether a parameter makes its effect larger than is plausible, by more than a factor.
    fn is_too_large(&self, parameter: usize, factor: f64) -> bool {
        let Some(entry) = self.objective.catalogue(parameter) else { return false };
        let value = entry.kind.from_si(self.objective.variables[parameter].value(self.solution.position[parameter]));
        match entry.neutral {
            Neutral::Infinity => factor * value < entry.range.0,
            Neutral::Value(neutral) => (value - neutral).abs() > factor * (entry.range.1 - neutral),
            Neutral::Shape => false,
        }
    }

    /// Whether the rows differ in nothing but time, and less of it than a period (s): any bow is a piece of some wave,
    /// where nothing else about the wave is seen.
    fn is_a_piece_of_a_wave(&self, period: f64) -> bool {
        let data = self.objective.data;
        let coordinates = data.model.process.coordinates();
        let span = |i: usize| {
            let column = &data.rows.columns[i];
            let ends = column.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
            ends.1 - ends.0
        };
        let varying: Vec<usize> = data.given.iter().copied().filter(|i| span(*i) > 0.0).collect();
        matches!(varying[..], [time] if coordinates[time].holds.kind() == Some(TIME) && period > span(time))
    }

    /// Member with an amplitude at a bound of what can be computed other than where the effect vanishes, or
    /// far larger than is plausible, or a wave of which only a piece is seen; with an amplitude just larger or a shape
    /// other than is plausible, if that is asked for.
    pub fn unbelievable(&self, if_implausible: bool) -> Option<usize> {
        let mut first = self.objective.data.model.parameters.len();
        for (number, effect) in self.members.iter().zip(&self.objective.added) {
            let own = first..first + effect.parameters.len();
            first = own.end;
            for (i, entry) in own.zip(&*effect.parameters) {
                let (variable, s) = (&self.objective.variables[i], self.solution.position[i]);
                let is_at_bound = |bound: f64| bound.is_finite() && (s - bound).abs() <= 1e-9 * bound.abs();
                let ends = [variable.low, variable.high].into_iter().filter(|b| (*b - variable.neutral()).abs() > 0.0);
                let value = entry.kind.from_si(variable.value(s));
                let is_plausible = (entry.range.0..=entry.range.1).contains(&value);
                let is_amplitude = entry.neutral != Neutral::Shape;
                // An exponent of 1 is the end of what can be, and most metals are there.
                let is_at_end = !is_plausible && ends.into_iter().any(is_at_bound);
                let too_large = self.is_too_large(i, if if_implausible { 1.0 } else { ABSURD });
                let is_odd = if_implausible && !is_amplitude && !is_plausible;
                let is_piece = entry.kind == PERIOD && self.is_a_piece_of_a_wave(variable.value(s));
                if is_amplitude && (is_at_end || too_large) || is_odd || is_piece {
                    return Some(*number);
                }
            }
        }
        None
    }

    /// Whether an instrument would have to be off beyond belief. It is adjusted: what only that explains, it does not
    /// explain.
    pub fn reads_beyond_belief(&self) -> bool {
        let mut first = self.objective.data.model.parameters.len();
        self.objective.added.iter().any(|effect| {
            let own = first..first + effect.parameters.len();
            first = own.end;
            effect.table == MEASUREMENT && own.into_iter().any(|i| self.is_too_large(i, 1.0))
        })
    }

    /// Where the same set stands with its members in another order; χ² is that of its own noise.
    pub fn solution_of(&self, members: &[usize], candidates: &[CandidateEffect]) -> Solution {
        let mut first = self.objective.data.model.parameters.len();
        let mut order: Vec<usize> = (0..first).collect();
        let mut of_member = std::collections::BTreeMap::new();
        for member in &self.members {
            let end = first + candidates[*member].parameters;
            of_member.insert(*member, first..end);
            first = end;
        }
        order.extend(members.iter().filter_map(|m| of_member.get(m).cloned()).flatten());
        let Solution { position, predicted, chi2, slopes } = &self.solution;
        Solution {
            position: DVector::from_iterator(order.len(), order.iter().map(|i| position[*i])),
            predicted: predicted.clone(),
            chi2: *chi2,
            slopes: slopes.as_ref().map(|slopes| Arc::new(slopes.select_columns(&order))),
        }
    }

    /// Members in rising order, by which equal sets are recognised.
    pub fn key(&self) -> Vec<usize> {
        key(&self.members)
    }
}

/// Members in rising order.
pub fn key(members: &[usize]) -> Vec<usize> {
    let mut sorted = members.to_vec();
    sorted.sort_unstable();
    sorted
}

/// Sum of squares of values about the mean of their level.
fn sum_of_squares(values: &[f64], levels: &[usize]) -> f64 {
    let mut sums = vec![(0.0, 0.0, 0.0); values.len()];
    for (value, level) in values.iter().zip(levels) {
        let (n, sum, square) = &mut sums[*level];
        *n += 1.0;
        *sum += value;
        *square += value * value;
    }
    sums.iter().filter(|s| s.0 > 0.0).map(|(n, sum, square)| square - sum * sum / n).sum()
}
