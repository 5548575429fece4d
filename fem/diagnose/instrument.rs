//! Effects of the measurement: which terms of the covariance the residuals of a model ask for.

use rayon::prelude::*;
use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::candidate_model::CandidateModel;
use super::diagnosis::{Cause, Missing, Outlier};
use super::verdict::GoodnessOfFit;
use crate::fit::{Estimate, Interval, StoppingCriterion, minimise};
use crate::input::{Bounds, Parameter};
use crate::measure::{Measurements, Repeats};
use crate::model::Data;
use crate::noise::{Acts, MeasurementEffect, Noise, NoiseSource, Restricted, Term, effects};
use crate::process::{self, Absent, Description, Holds, Neutral};
use crate::units::{Knowledge, LENGTH, Quantity, TIME};

/// Places at which a step of the zero is looked for.
const STEPS: usize = 240;
/// Prior odds against an outlying row, as a term of −2 ln L: 2·ln(0.99/0.01).
const ODDS: f64 = 9.2;
/// Largest part of the rows that can be outliers.
const FEW: f64 = 0.1;
/// Most groups whose zeros are sought.
const LEVELS: usize = 200;
/// Stopping criterion that is enough to rank terms.
const QUICK: StoppingCriterion = StoppingCriterion { steps: 8, tolerance: 1e-3 };
/// Fewest places that make a curve.
const LEAST_PLACES: usize = 4;
/// Most sensors at places of their own.
const MOST_SENSORS: usize = 16;
/// Ratio of the scatter of neighbouring rows to all scatter below which structure, not noise, is what
/// exceeds the stated uncertainty.
const ROUGH: f64 = 0.8;

/// Noise by which a model's rows are judged when terms are at work, without their shares yet.
fn plain(trial: &CandidateModel, repeats: &Repeats, terms: &[Term]) -> (Noise, Repeats) {
    Noise::beside(terms, trial.objective.data, repeats, &residuals(trial))
}

/// Residuals of the rows of a fitted model, SI.
pub fn residuals(trial: &CandidateModel) -> Vec<f64> {
    trial.objective.data.observed.iter().zip(&trial.solution.predicted).map(|(y, p)| y - p).collect()
}

/// −2 ln L of a fitted model with penalties on its parameters and on the terms of its noise.
pub fn criterion(trial: &CandidateModel) -> f64 {
    let data = trial.objective.data;
    let terms: f64 = trial.objective.noise.terms.iter().map(|term| penalty(term, data)).sum();
    trial.penalised_bic() + trial.objective.noise.log_determinant() + terms
}

/// Penalty on a term: ln n for its size, as for any parameter, and what it was chosen from.
fn penalty(term: &Term, measurements: &Measurements) -> f64 {
    let n = (measurements.len() as f64).ln();
    match term.effect.acts {
        Acts::Weighs => ODDS * term.rows.len() as f64,
        _ if *term.effect == effects::JUMP => 3.0 * n,
        _ => n,
    }
}

/// A term more, with the noise that it makes and the fall of the criterion.
pub struct Proposal {
    /// All terms and their sizes, the new one last.
    pub noise: Noise,
    /// Repeats within the groups that the terms set apart.
    pub repeats: Repeats,
    /// Criterion of the model, fitted again.
    pub criterion: f64,
}

/// Every term that the residuals of a model may ask for, the most promising first.
pub fn proposals(trial: &CandidateModel, repeats: &Repeats) -> Vec<Proposal> {
    let Some(mean) = trial.objective.mean(&trial.solution) else { return Vec::new() };
    let data = trial.objective.data;
    let residuals = residuals(trial);
    let restricted = Restricted { measurements: data, residuals: &residuals, mean: &mean };
    let present = &trial.objective.noise.terms;
    let mut trials: Vec<Vec<Term>> = Vec::new();
    let mut with = |term: Term| trials.push(present.iter().cloned().chain([term]).collect());
    for by in groupings(data) {
        for observable in own_observables(data) {
            let term = Term { by: by.clone(), observable, ..Term::new(&effects::ZERO_SHIFT) };
            if present.iter().all(|t| !t.is_like(&term)) {
                with(term);
            }
        }
    }
    let has = |effect: &MeasurementEffect| present.iter().any(|t| t.effect == effect);
    if !has(&effects::CORRELATED_NOISE) {
        with(Term::new(&effects::CORRELATED_NOISE));
    }
    if !has(&effects::UNCERTAINTY_SCALE) && data.uncertainty.is_some() {
        with(Term::new(&effects::UNCERTAINTY_SCALE));
    }
    for observable in own_observables(data) {
        let step = Term { observable, ..Term::new(&effects::JUMP) };
        with(Term { rows: vec![step_at(trial, &restricted, &step)], ..step.clone() });
        let drift = Term { observable, ..Term::new(&effects::DRIFT) };
        if present.iter().all(|t| !t.is_like(&drift)) {
            with(drift);
        }
    }
    if let Some(rows) = outlying(trial, repeats, &residuals) {
        let others = present.iter().filter(|t| *t.effect != effects::OUTLIERS).cloned();
        let term = Term { rows, size: effects::OUTLYING, ..Term::new(&effects::OUTLIERS) };
        trials.push(others.chain([term]).collect());
    }
    judged(trial, repeats, trials)
}

/// Estimates the sizes of terms beside a model, and fits it again under each.
fn judged(trial: &CandidateModel, repeats: &Repeats, trials: Vec<Vec<Term>>) -> Vec<Proposal> {
    let Some(mean) = trial.objective.mean(&trial.solution) else { return Vec::new() };
    let residuals = residuals(trial);
    let restricted = Restricted { measurements: trial.objective.data, residuals: &residuals, mean: &mean };
    let judge = |terms: Vec<Term>| {
        let (own, repeats) = plain(trial, repeats, &terms);
        let noise = restricted.estimate(&own, &terms, terms.len());
        let mut refitted = trial.clone();
        refitted.objective.noise = noise.clone();
        let solution = minimise(&mut refitted.objective, &trial.solution.position, &[], QUICK);
        refitted.solution = solution.unwrap_or_else(|| trial.solution.clone());
        Proposal { noise, repeats, criterion: criterion(&refitted) }
    };
    let mut all: Vec<Proposal> = trials.into_par_iter().map(judge).collect();
    all.retain(|p| p.criterion.is_finite() && is_rough(p, &residuals));
    all.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    all
}

/// The noise of a model's terms with their sizes estimated anew, and the repeats within their groups.
pub fn settled(trial: &CandidateModel, repeats: &Repeats) -> Option<(Noise, Repeats)> {
    let mean = trial.objective.mean(&trial.solution)?;
    let residuals = residuals(trial);
    let restricted = Restricted { measurements: trial.objective.data, residuals: &residuals, mean: &mean };
    let terms = trial.objective.noise.terms.clone();
    let (own, within) = plain(trial, repeats, &terms);
    Some((restricted.estimate(&own, &terms, terms.len()), within))
}

/// Every curve over places that the residuals of a model may ask for, the most promising first.
pub fn curves(trial: &CandidateModel, repeats: &Repeats) -> Vec<Proposal> {
    let data = trial.objective.data;
    let coordinates = data.model.process.coordinates();
    let counts = |by: &[usize]| data.levels(by).into_iter().max().map_or(0, |m| m + 1);
    let is_curve = |by: &Vec<usize>| (LEAST_PLACES..=LEVELS.min(data.len() / 3)).contains(&counts(by));
    let of_kind = |is: fn(Holds) -> bool| data.given.iter().copied().filter(move |i| is(coordinates[*i].holds));
    let places = || of_kind(|h| matches!(h, Holds::Quantity(_)));
    let words = || of_kind(|h| matches!(h, Holds::Word(_)));
    let both = places().flat_map(|i| words().map(move |j| vec![i, j]));
    let all = places().map(|i| vec![i]).chain(both).filter(is_curve);
    let with = |by: Vec<usize>| {
        own_observables(data).into_iter().map(move |observable| Term {
            by: by.clone(),
            observable,
            ..Term::new(&effects::DISCREPANCY)
        })
    };
    let present = &trial.objective.noise.terms;
    let trials = all.flat_map(with).map(|term| present.iter().cloned().chain([term]).collect());
    judged(trial, repeats, trials.collect())
}

/// Whether neighbouring rows scatter as much as a larger uncertainty says.
fn is_rough(proposal: &Proposal, residuals: &[f64]) -> bool {
    if proposal.noise.terms.iter().all(|t| !matches!(t.effect.acts, Acts::Scales)) {
        return true;
    }
    let z = proposal.noise.whiten(residuals.iter().copied());
    let mut squares: Vec<f64> = z.windows(3).map(|z| (z[0] - 2.0 * z[1] + z[2]).powi(2) / 6.0).collect();
    squares.sort_unstable_by(f64::total_cmp);
    squares.get(squares.len() / 2).is_none_or(|median| (median / 0.4549).sqrt() > ROUGH)
}

/// Coordinates whose levels may each have a zero of their own: parts, runs and directions, alone and two
/// together, conditions of few levels, and all of them together, which make a pass.
fn groupings(data: &Data) -> Vec<Vec<usize>> {
    let coordinates = data.model.process.coordinates();
    let counts = |by: &[usize]| data.levels(by).into_iter().max().map_or(0, |m| m + 1);
    let groups = |by: &[usize]| (2..=LEVELS.min(data.len() / 2)).contains(&counts(by));
    let given = || data.given.iter().copied();
    let time = given().find(|i| coordinates[*i].holds.kind() == Some(TIME));
    let is_sensor = |i: &usize| {
        // Few places at many times: a sensor stands at each.
        let few = counts(&[*i]) <= MOST_SENSORS && coordinates[*i].holds.kind() == Some(LENGTH);
        few && coordinates.iter().all(|c| !c.repeats) && time.is_some_and(|t| counts(&[t]) > counts(&[*i]))
    };
    let is_number = |i: &usize| matches!(coordinates[*i].holds, Holds::Number(_) | Holds::Word(_));
    let is_condition = |i: &usize| {
        let of_model = coordinates[*i].absent == Absent::Model && !is_number(i);
        of_model && (2..=MOST_SENSORS.min(data.len() / 8)).contains(&counts(&[*i]))
    };
    let numbers: Vec<usize> = given().filter(|i| is_number(i) && counts(&[*i]) > 1).collect();
    let conditions: Vec<usize> = given().filter(is_condition).collect();
    let pairs = numbers.iter().enumerate().flat_map(|(k, i)| numbers[k + 1..].iter().map(|j| vec![*i, *j]));
    let pass: Vec<usize> = numbers.iter().chain(&conditions).copied().collect();
    let several = numbers.iter().chain(&conditions).map(|i| vec![*i]).chain(pairs);
    let mut all: Vec<Vec<usize>> = given().filter(is_sensor).map(|i| vec![i]).collect();
    for by in several.chain((!conditions.is_empty()).then_some(pass)) {
        // What groups the rows as another does is not told twice.
        let levels = data.levels(&by);
        if groups(&by) && all.iter().all(|other| data.levels(other) != levels) {
            all.push(by);
        }
    }
    if numbers.is_empty() && all.is_empty() {
        // One series has one zero.
        all.push(Vec::new());
    }
    all
}

/// Observables on which a term may act: each by itself where there are several.
fn own_observables(measurements: &Measurements) -> Vec<Option<usize>> {
    match &measurements.observables[..] {
        [_] => vec![None],
        several => several.iter().map(|s| Some(s.position)).collect(),
    }
}

/// First row of the step that gains most.
fn step_at(trial: &CandidateModel, restricted: &Restricted, step: &Term) -> usize {
    let Acts::Shared(columns) = step.effect.acts else { return 0 };
    let data = trial.objective.data;
    let noise = &trial.objective.noise;
    let white = |values: Vec<f64>| nalgebra::DVector::from_vec(noise.whiten(values));
    let mean: Vec<_> = restricted.mean.column_iter().map(|c| white(c.iter().copied().collect())).collect();
    let basis = super::residual_projection::orthonormal_of(&mean, data.len());
    let z = white(restricted.residuals.to_vec());
    let gain = |row: usize| {
        let mut dense = vec![0.0; data.len()];
        let term = Term { rows: vec![row], ..step.clone() };
        columns(&term, data).into_iter().flatten().for_each(|(row, w)| dense[row] = w);
        let column = white(dense);
        let own = &column - &basis * (basis.transpose() * &column);
        own.dot(&z).powi(2) / own.norm_squared().max(1e-9)
    };
    let best = |rows: &[usize]| {
        let gains: Vec<f64> = rows.par_iter().map(|row| gain(*row)).collect();
        (0..rows.len()).max_by(|a, b| gains[*a].total_cmp(&gains[*b])).map_or(0, |i| rows[i])
    };
    let stride = data.len().div_ceil(STEPS);
    let coarse = best(&(1..data.len()).step_by(stride).collect::<Vec<_>>());
    best(&(coarse.saturating_sub(stride).max(1)..(coarse + stride + 1).min(data.len())).collect::<Vec<_>>())
}

/// Whether each row contradicts the rows that it repeats, whatever the model says: it lies far from their
/// median, measured by the median of all such distances.
fn contradicting(repeats: &Repeats, z: &[f64]) -> Vec<bool> {
    /// Fewest rows that tell which of them is wrong.
    const LEAST: usize = 4;
    /// Distance, in standard deviations, beyond which a row contradicts the others.
    const FAR: f64 = 6.0;
    let mut groups = vec![Vec::new(); repeats.groups];
    repeats.group.iter().enumerate().for_each(|(row, group)| groups[*group].push(row));
    let mut distances = vec![0.0; z.len()];
    for rows in groups.iter().filter(|rows| rows.len() >= LEAST) {
        let mut values: Vec<f64> = rows.iter().map(|row| z[*row]).collect();
        values.sort_unstable_by(f64::total_cmp);
        let median = 0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2]);
        rows.iter().for_each(|row| distances[*row] = (z[*row] - median).abs());
    }
    let mut sizes: Vec<f64> = distances.iter().copied().filter(|d| *d > 0.0).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    let usual = sizes.get(sizes.len() / 2).map_or(f64::INFINITY, |median| median / 0.6745);
    distances.into_iter().map(|d| d > FAR * usual).collect()
}

/// Outlying rows that contradict the rows that they repeat, as a term; `None` where there are none, or too
/// many to be single mistakes.
pub fn contradictions(trial: &CandidateModel, repeats: &Repeats) -> Option<Proposal> {
    let noise = &trial.objective.noise;
    let z: Vec<f64> = residuals(trial).iter().zip(&noise.sigma).map(|(r, s)| r / s).collect();
    let contradicts = contradicting(repeats, &z);
    let rows: Vec<usize> = (0..z.len()).filter(|row| contradicts[*row]).collect();
    let is_told = |row: &usize| noise.terms.iter().any(|t| t.rows.contains(row));
    if rows.iter().all(is_told) || rows.len() as f64 > FEW * z.len() as f64 {
        return None;
    }
    let others = noise.terms.iter().filter(|t| *t.effect != effects::OUTLIERS).cloned();
    let term = Term { rows, size: effects::OUTLYING, ..Term::new(&effects::OUTLIERS) };
    judged(trial, repeats, vec![others.chain([term]).collect()]).pop()
}

/// Rows that lie far outside of what the others scatter; `None` where there are none, or too many to be
/// single mistakes.
fn outlying(trial: &CandidateModel, repeats: &Repeats, residuals: &[f64]) -> Option<Vec<usize>> {
    let noise = &trial.objective.noise;
    let present: Vec<usize> = noise
        .terms
        .iter()
        .filter(|t| matches!(t.effect.acts, Acts::Weighs))
        .flat_map(|t| t.rows.iter().copied())
        .collect();
    let z: Vec<f64> = noise.unshared(residuals).iter().zip(&noise.sigma).map(|(r, s)| r / s).collect();
    let mut sizes: Vec<f64> = z.iter().map(|z| z.abs()).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    // The median of |z| is 0.6745 of a standard deviation.
    let usual = sizes[sizes.len() / 2] / 0.6745;
    let usual = if noise.source == NoiseSource::Column { usual.max(1.0) } else { usual };
    let threshold = ((2.0 * (z.len() as f64).ln()).sqrt() + 1.0) * usual;
    let contradicts = contradicting(repeats, &z);
    let is_out = |row: &usize| z[*row].abs() > threshold || contradicts[*row];
    let new: Vec<usize> = (0..z.len()).filter(|row| is_out(row) && !present.contains(row)).collect();
    let mut rows = [present, new.clone()].concat();
    rows.sort_unstable();
    (!new.is_empty() && rows.len() as f64 <= FEW * z.len() as f64).then_some(rows)
}

/// The rows that are weighed down.
pub fn outliers(best: &CandidateModel) -> Vec<Outlier> {
    let (data, noise) = (best.objective.data, &best.objective.noise);
    let residuals = residuals(best);
    let left = noise.unshared(&residuals);
    let weighed = noise.terms.iter().filter(|t| matches!(t.effect.acts, Acts::Weighs));
    let outlier = |(row, factor): (usize, f64)| Outlier {
        record: data.records_of[row] + 1,
        observable: data.observable(row),
        line: data.lines[row],
        value: data.observed[row],
        predicted: data.observed[row] - left[row],
        weight: 1.0 / (factor * factor),
    };
    weighed.flat_map(|t| t.rows.iter().map(|row| (*row, t.size))).map(outlier).collect()
}

/// Tells the terms of the best model as missing effects, each with the goodness of the model with it and
/// those before it.
pub fn told(
    base: &CandidateModel,
    best: &CandidateModel,
    plain: Option<&CandidateModel>,
    repeats: &Repeats,
) -> Vec<Missing> {
    let Some(plain) = plain else { return Vec::new() };
    let Some(mean) = best.objective.mean(&best.solution) else { return Vec::new() };
    let (data, noise) = (best.objective.data, &best.objective.noise);
    let residuals = residuals(best);
    let restricted = Restricted { measurements: data, residuals: &residuals, mean: &mean };
    let whole = restricted.minus_two_log(noise);
    let tell = |(number, term): (usize, &Term)| {
        let others: Vec<Term> =
            noise.terms.iter().enumerate().filter(|(i, _)| *i != number).map(|(_, t)| t.clone()).collect();
        let (own, _) = self::plain(best, repeats, &others);
        let without = restricted.minus_two_log(&restricted.estimate(&own, &others, others.len()));
        let mut grown = plain.clone();
        grown.objective.noise =
            self::plain(base, repeats, &noise.terms[..=number]).0.with(noise.terms[..=number].to_vec(), data);
        let solution = minimise(&mut grown.objective, &plain.solution.position, &[], StoppingCriterion::FULL);
        grown.solution = solution.unwrap_or_else(|| plain.solution.clone());
        Missing {
            cause: Cause::Measurement {
                effect: term.effect,
                by: term.by.iter().map(|i| data.model.process.coordinates()[*i].name).collect(),
                observable: term.observable.map(|o| data.model.process.observables()[o].name),
                records: records(term, data),
                from_line: (*term.effect == effects::JUMP).then(|| term.rows.first().map(|r| data.lines[*r])).flatten(),
            },
            effect: description(term, data),
            goodness: GoodnessOfFit::of(&grown, repeats, None),
            // At the edge of its range the size of a term has half of χ² with one degree of freedom.
            p_value: ChiSquared::new(1.0).map_or(1.0, |d| 0.5 * d.sf((without - whole).max(0.0))),
            estimates: vec![estimate(term, data, &restricted, noise, number)],
            indistinguishable_from: Vec::new(),
        }
    };
    let is_new = |(_, term): &(usize, &Term)| data.terms.iter().all(|t| !t.is_like(term));
    noise.terms.iter().enumerate().filter(is_new).map(tell).collect()
}

/// Records of the file on which a term acts, counted from 1; those that the model weighs down already are left
/// out.
fn records(term: &Term, data: &Data) -> Vec<usize> {
    let is_weighed = |t: &Term| t.effect == term.effect && matches!(t.effect.acts, Acts::Weighs);
    let is_known = |row: &usize| data.terms.iter().any(|t| is_weighed(t) && t.rows.contains(row));
    let mut records: Vec<usize> =
        term.rows.iter().filter(|row| !is_known(row)).map(|row| data.records_of[*row] + 1).collect();
    records.dedup();
    records
}

/// A term as the catalogue of effects tells one.
fn description(term: &Term, measurements: &Measurements) -> Description {
    let parameter = process::Parameter {
        name: term.effect.size.key(),
        kind: term.kind(measurements),
        about: term.effect.size.about(),
        neutral: Neutral::Value(0.0),
        range: (0.0, f64::INFINITY),
        bounds: Bounds::NotNegative,
        default: None,
        needed_with: None,
        along: None,
        period: None,
    };
    Description {
        name: term.effect.name,
        about: term.effect.about.into(),
        law: term.effect.law.into(),
        source: term.effect.source,
        parameters: vec![parameter].into(),
        look_alikes: &[],
    }
}

/// The size of a term with its 95 % interval, from the profile of the restricted likelihood.
fn estimate(
    term: &Term,
    measurements: &Measurements,
    restricted: &Restricted,
    noise: &Noise,
    number: usize,
) -> Estimate {
    let interval = match term.effect.acts {
        Acts::Weighs => [None, None],
        _ => restricted.interval(noise, number),
    };
    let interval = Interval { low: interval[0], high: interval[1] };
    let width = interval.high.zip(interval.low).map_or(f64::NAN, |(high, low)| (high - low) / 3.92);
    let kind = term.kind(measurements);
    Estimate {
        parameter: Parameter {
            path: format!("measurement.{}.{}", term.effect.name, term.effect.size.key()),
            kind,
            quantity: Quantity { value: term.size, knowledge: Knowledge::Free },
            bounds: Bounds::NotNegative,
            span: None,
        },
        value: term.size,
        std: width,
        interval,
        warnings: Vec::new(),
    }
}
