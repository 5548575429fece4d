//! Sensitivities: the change that each candidate effect would make in every row, by running the model with
//! it.
//!
//! A linear parameter (an amplitude, a compliance) enters almost linearly and gives one column: the change
//! of the prediction per unit. A nonlinear parameter (a time constant, an exponent, a place) is tried on a
//! grid; each point of the grid is a [`Variant`] with columns of its own. One in which the law is a step is tried at
//! every border between measured parts, or at some of them if they are many.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use crate::fit::{MOST_STARTS, Objective, SearchVariable, Solution};
use crate::input::Bounds;
use crate::process::{Description, Neutral};
use crate::units::PERIOD;

/// Points of the grid along a single nonlinear parameter, a place, and each of several nonlinear parameters.
const ALONE: usize = 10;
const PLACE: usize = 16;
/// Points of the grid along the period of a wave: neighbours are less than a turn apart at the end of the rows.
const WAVES: usize = 24;
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
    /// The same in SI, of the rows alone.
    pub raw: DMatrix<f64>,
}

/// Parameter in which an effect is linear or quadratic; at its neutral value the effect vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearParameter {
    /// Number among the effect's parameters.
    pub parameter: usize,
    /// Size at which its column was computed, in the search variable.
    pub size: f64,
    /// Largest usual size, in the search variable.
    largest: f64,
    /// Whether the effect is quadratic in it, the same for either sign.
    is_square: bool,
    /// Phase, by its number among the effect's parameters, at which its column was computed, where it is the amplitude of
    /// a wave.
    phase: Option<Phase>,
}

/// A wave of any phase is the sum of one of phase zero and one a quarter of a period on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Phase {
    parameter: usize,
    at: f64,
    period: f64,
}

impl CandidateEffect {
    /// Whether it has no shape but that of its size.
    pub fn is_of_one_shape(&self) -> bool {
        self.variants.len() < 2
    }

    /// Whether a parameter, by its number, switches the effect off where it is neutral.
    pub fn is_linear(&self, parameter: usize) -> bool {
        self.effect.parameters[parameter].neutral != Neutral::Shape
    }
}

impl LinearParameter {
    /// Search variable, from neutral, that gives this amplitude of the column.
    pub fn value(&self, amplitude: f64) -> f64 {
        if self.is_square { (amplitude.max(0.0) * self.size).sqrt() } else { amplitude }
    }

    /// The position at which its column is computed.
    pub fn beside(&self, position: &[f64]) -> Vec<f64> {
        let mut position = position.to_vec();
        if let Some(Phase { parameter, at, .. }) = self.phase {
            position[parameter] = at;
        }
        position
    }
}

impl Variant {
    /// Number of the first of two columns, a sine and a cosine, where the effect is a wave of any phase.
    pub fn wave(&self) -> Option<usize> {
        self.linear.iter().position(|parameter| parameter.phase.is_some())
    }

    /// χ² that it makes at the largest usual sizes of its linear parameters, by columns of which what others can imitate
    /// is taken out.
    pub fn largest_chi2(&self, columns: &DMatrix<f64>) -> f64 {
        let of = |(parameter, column): (&LinearParameter, nalgebra::DVectorView<f64>)| {
            let amount = if parameter.is_square { parameter.largest * parameter.largest } else { parameter.largest };
            (amount * column.norm()).powi(2)
        };
        self.linear.iter().zip(columns.column_iter()).map(of).sum()
    }

    /// Position with these amplitudes.
    pub fn position(&self, amplitudes: &[f64], variables: &[SearchVariable]) -> Vec<f64> {
        let mut position = self.position.clone();
        let mut wave = [0.0; 2];
        for (parameter, amplitude) in self.linear.iter().zip(amplitudes) {
            let mut value = parameter.value(*amplitude);
            if let Some(Phase { parameter, at, period }) = parameter.phase {
                wave[usize::from(at != 0.0)] = *amplitude;
                let [zero, quarter] = wave;
                value = zero.hypot(quarter);
                position[parameter] = quarter.atan2(zero) * period / TAU;
            }
            let variable = &variables[parameter.parameter];
            let place = self.position[parameter.parameter] + value;
            position[parameter.parameter] = place.clamp(variable.low, variable.high);
        }
        position
    }

    /// Moves its linear parameters, which follow behind the `first` of a position, to where they stand by as much beside
    /// neutral there: what is neutral of the change of an effect depends on where the effect stands. Gives neutral.
    pub fn moved(&self, position: &mut [f64], first: usize, objective: &Objective) -> Vec<f64> {
        let mut neutral = Vec::with_capacity(self.linear.len());
        for parameter in &self.linear {
            let (own, was) = (first + parameter.parameter, self.position[parameter.parameter]);
            let is = objective
                .unchanged(own, &position[..first])
                .map_or(was, |_| objective.neutral_at(own, &position[..first]));
            if is != was {
                let variable = &objective.variables[own];
                position[own] = (position[own] - was + is).clamp(variable.low, variable.high);
            }
            neutral.push(is);
        }
        neutral
    }

    /// Slopes of the prediction of the rows over all parameters with these amplitudes, SI per unit of the search
    /// variables; `None` where some other shape has a share in them.
    pub fn slopes(&self, amplitudes: &[f64]) -> Option<DMatrix<f64>> {
        let n = self.position.len();
        let mut columns = vec![None; n];
        for (number, parameter) in self.linear.iter().enumerate() {
            let own = self.raw.column(number).into_owned();
            let Some(Phase { parameter: phase, at, period }) = parameter.phase else {
                columns[parameter.parameter] = Some(own);
                continue;
            };
            if at == 0.0 {
                let other = self.raw.column(number + 1);
                let (zero, quarter) = (amplitudes[number], amplitudes[number + 1]);
                let size = zero.hypot(quarter).max(f64::MIN_POSITIVE);
                let (cos, sin) = (zero / size, quarter / size);
                columns[parameter.parameter] = Some(&own * cos + other * sin);
                columns[phase] = Some((other * cos - &own * sin) * (size * TAU / period));
            }
        }
        let columns: Option<Vec<DVector<f64>>> = columns.into_iter().collect();
        columns.map(|columns| DMatrix::from_columns(&columns))
    }
}

/// Computes the sensitivities of all `effects` about a solution of the model without them.
pub fn candidates(objective: &Objective, base: &Solution, effects: &[Description]) -> Vec<CandidateEffect> {
    effects.par_iter().map(|effect| candidate(objective, base, effect)).collect()
}

fn candidate(objective: &Objective, base: &Solution, effect: &Description) -> CandidateEffect {
    let trial = objective.with(effect);
    let variables = trial.variables[objective.variables.len()..].to_vec();
    if !objective.data.progress.permits(&format!("what `{}` would change", effect.name)) {
        return CandidateEffect { effect: effect.clone(), variants: Vec::new(), parameters: variables.len() };
    }
    let probe = Probe { trial: &trial, base, variables: &variables };
    let variants = probe.variants(effect);
    CandidateEffect { effect: effect.clone(), variants, parameters: variables.len() }
}

struct Probe<'a, 'm> {
    trial: &'a Objective<'m>,
    base: &'a Solution,
    variables: &'a [SearchVariable],
}

impl Probe<'_, '_> {
    fn variants(&self, effect: &Description) -> Vec<Variant> {
        let own = self.base.position.len();
        let neutral: Vec<f64> = (own..own + self.variables.len())
            .map(|i| self.trial.neutral_at(i, self.base.position.as_slice()))
            .collect();
        let nonlinear: Vec<usize> =
            (0..neutral.len()).filter(|i| effect.parameters[*i].neutral == Neutral::Shape).collect();
        let wave = wave(effect);
        let nonlinear: Vec<usize> =
            nonlinear.into_iter().filter(|i| wave.is_none_or(|(_, p)| p.parameter != *i)).collect();
        let alone = nonlinear.len() == 1;
        let grid = |i: &usize| {
            let count = match effect.parameters[*i].along {
                Some(_) => PLACE,
                None if effect.parameters[*i].kind == PERIOD => WAVES,
                None if alone => ALONE,
                None => TOGETHER,
            };
            let variable = &self.variables[*i];
            if let Some(steps) = &variable.steps {
                return (*i, steps.spread(MOST_STARTS));
            }
            // A periodic parameter is tried over one period.
            match effect.parameters[*i].period.map(|p| 0.5 * effect.parameters[*i].kind.to_si(p)) {
                Some(half) => (*i, variable.grid_within(-half, half, count)),
                None => (*i, variable.grid(count)),
            }
        };
        let grids: Vec<(usize, Vec<f64>)> = nonlinear.iter().map(grid).collect();
        let points = combinations(&grids, &neutral);
        let Some(first) = points.first() else { return Vec::new() };
        let own = (0..neutral.len()).filter(|i| !nonlinear.contains(i) && wave.is_none_or(|(_, p)| p.parameter != *i));
        let of = |i: usize| match wave {
            Some((amplitude, phase)) if amplitude == i => {
                let size = self.size(i);
                let at = |at: f64| LinearParameter {
                    parameter: i,
                    size,
                    largest: self.largest(i),
                    is_square: false,
                    phase: Some(Phase { at, ..phase }),
                };
                vec![at(0.0), at(0.25 * phase.period)]
            }
            _ => vec![self.linear(first, i)],
        };
        let linear: Vec<LinearParameter> = own.flat_map(of).collect();
        if effect.changes.is_some() {
            return self.borders(effect, points, &linear);
        }
        let name = format!("shapes of `{}`", effect.name);
        let mut variants = Vec::new();
        for position in points {
            // One shape is enough to try an effect at all.
            if !variants.is_empty() && !self.trial.data.progress.permits(&name) {
                break;
            }
            let raw = self.raw(&position, &linear);
            variants.extend(raw.and_then(|raw| self.variant(effect, position, &linear, raw)));
        }
        variants
    }

    /// Variants of the change of an effect: what it makes of the rows is the same wherever the border lies, and nothing
    /// up to it.
    fn borders(&self, effect: &Description, points: Vec<Vec<f64>>, linear: &[LinearParameter]) -> Vec<Variant> {
        let Some(step) = effect.parameters.iter().position(|p| p.is_step) else { return Vec::new() };
        let data = self.trial.data;
        let along = effect.parameters[step].along.as_ref();
        let Some(column) = data.model.process.coordinates().iter().position(|c| Some(&c.name) == along) else {
            return Vec::new();
        };
        let Some(mut first) = points.first().cloned() else { return Vec::new() };
        first[step] = self.variables[step].low;
        let Some(whole) = self.raw(&first, linear) else { return Vec::new() };
        let numbers = &data.rows.columns[column];
        let at = |position: Vec<f64>| {
            let after = self.variables[step].value(position[step]);
            let beyond = |own: &DVector<f64>| {
                DVector::from_fn(own.len(), |row, _| if numbers[row] > after { own[row] } else { 0.0 })
            };
            self.variant(effect, position, linear, whole.iter().map(beyond).collect())
        };
        points.into_iter().filter_map(at).collect()
    }

    /// Tries whether a parameter is linear or quadratic, at the nonlinear parameters of `at`.
    fn linear(&self, at: &[f64], parameter: usize) -> LinearParameter {
        let variable = &self.variables[parameter];
        let (neutral, size) = (at[parameter], self.size(parameter));
        let both = variable.low <= neutral - size;
        // The change per unit is the same from the other side if linear and opposite if quadratic; from half
        // as far it is the same, or half.
        let (other, sign) = if both { (-size, -1.0) } else { (0.5 * size, 2.0) };
        let is_square = match (self.column(at, parameter, size), self.column(at, parameter, other)) {
            (Some(far), Some(near)) => (&far - sign * &near).norm() < SQUARE * far.norm(),
            _ => false,
        };
        // About a value that is not zero a square has a slope.
        let is_square = is_square && neutral == variable.neutral();
        LinearParameter { parameter, size, largest: self.largest(parameter), is_square, phase: None }
    }

    /// Largest usual size of a parameter.
    fn largest(&self, parameter: usize) -> f64 {
        self.variables[parameter].usual.map_or(f64::INFINITY, |usual| usual.largest())
    }

    /// Step, from neutral, at which the column of a parameter is computed.
    fn size(&self, parameter: usize) -> f64 {
        let variable = &self.variables[parameter];
        variable.unit.min(variable.high - variable.neutral())
    }

    /// Changes of the prediction per unit of the linear parameters at a position, SI.
    fn raw(&self, position: &[f64], linear: &[LinearParameter]) -> Option<Vec<DVector<f64>>> {
        linear.iter().map(|s| self.change(&s.beside(position), s.parameter, s.size)).collect()
    }

    fn variant(
        &self,
        effect: &Description,
        position: Vec<f64>,
        linear: &[LinearParameter],
        raw: Vec<DVector<f64>>,
    ) -> Option<Variant> {
        let signed = linear.iter().map(|s| {
            let entry = &effect.parameters[s.parameter];
            let is_signed = match entry.neutral {
                Neutral::Written(..) => true,
                Neutral::Infinity => false,
                Neutral::Value(_) | Neutral::Shape => entry.bounds == Bounds::Any && !s.is_square,
            };
            s.phase.is_some() || is_signed || effect.changes.is_some()
        });
        let whitened = |column: &DVector<f64>| self.trial.whiten(column.iter().copied());
        (!raw.is_empty()).then(|| Variant {
            signed: signed.collect(),
            linear: linear.to_vec(),
            columns: DMatrix::from_columns(&raw.iter().map(whitened).collect::<Vec<_>>()),
            raw: DMatrix::from_columns(&raw),
            position,
        })
    }

    /// Change of the standardised prediction per unit of one linear parameter, from neutral to `step` beside it.
    fn column(&self, position: &[f64], parameter: usize, step: f64) -> Option<DVector<f64>> {
        let change = self.change(position, parameter, step)?;
        Some(self.trial.whiten(change.iter().copied()))
    }

    /// Change of the prediction per unit of one linear parameter, from neutral to `step` beside it, SI.
    fn change(&self, position: &[f64], parameter: usize, step: f64) -> Option<DVector<f64>> {
        let mut moved = position.to_vec();
        moved[parameter] += step;
        let own = self.base.position.iter().copied();
        let there = DVector::from_iterator(own.len() + moved.len(), own.chain(moved));
        let predicted = self.trial.predict(&there)?;
        let changes = predicted.iter().zip(&self.base.predicted).map(|(p, q)| (p - q) / step);
        Some(DVector::from_iterator(predicted.len(), changes))
    }
}

/// Amplitude and phase of an effect that is a wave, by their numbers.
fn wave(effect: &Description) -> Option<(usize, Phase)> {
    let phase = effect.parameters.iter().position(|p| p.period.is_some() && p.neutral == Neutral::Shape)?;
    let mut amplitudes = (0..effect.parameters.len()).filter(|i| effect.parameters[*i].neutral != Neutral::Shape);
    let amplitude = amplitudes.next().filter(|_| amplitudes.next().is_none())?;
    let entry = &effect.parameters[phase];
    let period = entry.kind.to_si(entry.period?);
    Some((amplitude, Phase { parameter: phase, at: 0.0, period }))
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
