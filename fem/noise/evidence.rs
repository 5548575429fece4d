//! Which effects of the measurement the residuals of a model may ask for: terms of the covariance that are
//! worth weighing.

use nalgebra::DMatrix;
use rayon::prelude::*;

use super::contradiction::{FEW, contradicting, contradictions};
use super::scan::Scan;
use crate::measure::{FILE, Measurements, Repeats, of_neighbours};
use crate::model::Data;
use crate::noise::{Acts, Along, MeasurementEffect, Noise, Restricted, Term, effects, step_of};
use crate::process::{Absent, Holds};
use crate::units::{ANGLE, LENGTH, TIME};

/// Prior odds against an outlying row, as a term of −2 ln L: 2·ln(0.99/0.01).
const ODDS: f64 = 9.2;
/// Most groups whose zeros are sought.
const LEVELS: usize = 200;
/// Fewest places that make a curve.
const LEAST_PLACES: usize = 4;
/// Fewest groups that are seen to lie askew each in its own way.
const LEAST_ASKEW: usize = 3;
/// Most sensors at places of their own.
const MOST_SENSORS: usize = 16;
/// Ratio of the scatter of neighbouring rows to all scatter below which structure, not noise, is what
/// exceeds the stated uncertainty.
const ROUGH: f64 = 0.8;

/// Fall of −2 ln L, beyond its price, from which a term is suspected, and worth a search.
pub const PROMISING: f64 = 6.0;
/// Fewest and most rows in which terms are suspected.
const LEAST_ROWS: usize = 8;
const MOST_ROWS: usize = 20_000;

/// Price of the terms of a noise in −2 ln L.
pub fn price(noise: &Noise, measurements: &Measurements) -> f64 {
    noise.terms.iter().map(|term| penalty(term, measurements)).sum()
}

/// Penalty on a term: ln n for its size, as for any parameter, and what it was chosen from.
fn penalty(term: &Term, measurements: &Measurements) -> f64 {
    let n = (measurements.len() as f64).ln();
    match term.effect.acts {
        Acts::Weighs => ODDS * term.rows.len() as f64,
        // Read off the values, stated by the model, or taken from a file: not chosen by the residuals.
        Acts::Rounds | Acts::Reads | Acts::Given => 0.0,
        // A place among all rows counts as two parameters (Zhang and Siegmund 2007), and so does a period.
        _ if [&effects::JUMP, &effects::WAVE].contains(&term.effect) => 3.0 * n,
        _ => n,
    }
}

/// Whether neighbouring rows scatter as much as a larger uncertainty says.
pub fn is_rough(noise: &Noise, residuals: &[f64]) -> bool {
    if noise.terms.iter().all(|t| !matches!(t.effect.acts, Acts::Scales)) {
        return true;
    }
    of_neighbours(&noise.whiten(residuals.iter().copied())) > ROUGH
}

/// Whether nothing but the round-off of a computation is left: rows that the model itself made.
pub fn is_round_off(residuals: &[f64], observed: &[f64]) -> bool {
    /// Largest part of the observed values that counts as such.
    const ROUND_OFF: f64 = 1e-7;
    let largest = |values: &[f64]| values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    largest(residuals) <= ROUND_OFF * largest(observed)
}

/// Residuals of a model with the noise by which they are judged.
pub struct Suspicion<'a> {
    /// Rows.
    pub data: &'a Data<'a>,
    /// Noise, with the terms that are known to be at work.
    pub noise: &'a Noise,
    /// Repeats of the rows, whatever the terms.
    pub repeats: &'a Repeats,
    /// Residuals of all rows, SI.
    pub residuals: &'a [f64],
    /// Derivatives of the prediction by what was fitted, and datum directions.
    pub mean: &'a DMatrix<f64>,
}

impl Suspicion<'_> {
    /// Terms that the residuals ask for more than chance would, one after another, with their sizes: what the
    /// noise is besides what it is taken for.
    pub fn suspects(&self) -> Vec<Term> {
        if self.data.len() > MOST_ROWS || is_round_off(self.residuals, &self.data.observed) {
            return Vec::new();
        }
        let restricted = Restricted { measurements: self.data, residuals: self.residuals, mean: self.mean };
        let cost = |noise: &Noise| restricted.minus_two_log(noise) + price(noise, self.data);
        // Terms are weighed at the level that is most likely with them; what is here is too.
        let here = cost(self.noise).min(cost(&restricted.estimate(self.noise, &self.noise.terms, 0)));
        let judge = |terms: Vec<Term>| {
            let (own, _) = Noise::beside(&terms, self.data, self.repeats, self.residuals);
            let noise = restricted.estimate(&own, &terms, terms.len() - self.noise.terms.len());
            (cost(&noise), noise)
        };
        let sets = self.contradictions().into_iter().chain(self.terms());
        let all: Vec<(f64, Noise)> = sets.collect::<Vec<_>>().into_par_iter().map(judge).collect();
        let likely = all.into_iter().filter(|(at, noise)| *at < here - PROMISING && is_rough(noise, self.residuals));
        let best = likely.min_by(|a, b| a.0.total_cmp(&b.0));
        let is_new = |term: &Term| !term.is_among(&self.noise.terms);
        best.map_or_else(Vec::new, |(_, noise)| noise.terms.into_iter().filter(is_new).collect())
    }

    /// Every set of terms with one more than are at work; its size is still to be found.
    pub fn terms(&self) -> Vec<Vec<Term>> {
        let (data, present) = (self.data, &self.noise.terms);
        if data.len() < LEAST_ROWS {
            return Vec::new();
        }
        let mut trials: Vec<Vec<Term>> = Vec::new();
        let mut with = |term: Term| trials.push(present.iter().cloned().chain([term]).collect());
        for by in groupings(data) {
            for observable in own_observables(data) {
                let term = Term { by: by.clone(), observable, ..Term::new(&effects::ZERO_SHIFT) };
                if !term.is_among(present) {
                    with(term);
                }
            }
        }
        alignments(data).into_iter().filter(|term| !term.is_among(present)).for_each(&mut with);
        let has = |effect: &MeasurementEffect| present.iter().any(|t| t.effect == effect);
        if !has(&effects::CORRELATED_NOISE) && !has(&effects::COVARIANCE) {
            with(Term::new(&effects::CORRELATED_NOISE));
        }
        if !has(&effects::UNCERTAINTY_SCALE) && data.uncertainty.is_some() {
            with(Term::new(&effects::UNCERTAINTY_SCALE));
        }
        resolutions(data, self.noise).into_iter().for_each(&mut with);
        let scan = Scan::new(data, self.noise, self.residuals, self.mean);
        for observable in own_observables(data) {
            scan.step(&Term { observable, ..Term::new(&effects::JUMP) }).into_iter().for_each(&mut with);
            // Several waves make any curve, and none of them is there.
            let is_wave = |t: &Term| *t.effect == effects::WAVE && t.observable == observable;
            for along in places(data).filter(|_| !present.iter().any(is_wave)) {
                let wave = Term { observable, along: Some(along), ..Term::new(&effects::WAVE) };
                scan.wave(&wave).into_iter().for_each(&mut with);
            }
            let drift = Term { observable, ..Term::new(&effects::DRIFT) };
            if !drift.is_among(present) {
                with(drift);
            }
        }
        trials.extend(self.outlying().map(|rows| self.with_outliers(rows)));
        trials
    }

    /// Every set of terms with a curve over places more than are at work.
    pub fn curves(&self) -> Vec<Vec<Term>> {
        let data = self.data;
        let coordinates = data.model.process.coordinates();
        let counts = |by: &[usize]| count(data, by);
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
        let present = &self.noise.terms;
        let alone = all.flat_map(with).map(|term| vec![term]);
        // A curve that is the same in every direction, and what differs from one direction to the other: the
        // mean difference of directions is told by neither.
        let nested = places().flat_map(|i| words().map(move |j| [vec![i], vec![i, j]])).filter(|by| is_curve(&by[1]));
        let nested = nested.flat_map(|[whole, own]| with(whole).zip(with(own)).map(|(a, b)| vec![a, b]));
        alone.chain(nested).map(|terms| present.iter().cloned().chain(terms).collect()).collect()
    }

    /// The terms with outlying rows that contradict the rows that they repeat; `None` where there are none, or
    /// too many to be single mistakes.
    pub fn contradictions(&self) -> Option<Vec<Term>> {
        let noise = self.noise;
        let z: Vec<f64> = self.residuals.iter().zip(noise.sigma.iter()).map(|(r, s)| r / s).collect();
        let rows = contradictions(&self.repeats.groups_of_rows(), &z);
        let is_new = rows.iter().any(|row| !noise.is_weighed_down(*row));
        is_new.then(|| self.with_outliers(rows))
    }

    /// The terms at work with these outlying rows in the place of any others.
    fn with_outliers(&self, rows: Vec<usize>) -> Vec<Term> {
        let others = self.noise.terms.iter().filter(|t| *t.effect != effects::OUTLIERS).cloned();
        let term = Term { rows, size: effects::OUTLYING, ..Term::new(&effects::OUTLIERS) };
        others.chain([term]).collect()
    }

    /// Rows that lie far outside of what the others scatter; `None` where there are none, or too many to be
    /// single mistakes.
    fn outlying(&self) -> Option<Vec<usize>> {
        let noise = self.noise;
        let present: Vec<usize> = (0..noise.sigma.len()).filter(|row| noise.is_weighed_down(*row)).collect();
        let z: Vec<f64> = noise.unshared(self.residuals).iter().zip(noise.sigma.iter()).map(|(r, s)| r / s).collect();
        let mut sizes: Vec<f64> = z.iter().map(|z| z.abs()).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        // The median of |z| is 0.6745 of a standard deviation.
        let usual = sizes[sizes.len() / 2] / 0.6745;
        let usual = if noise.source.is_known() { usual.max(1.0) } else { usual };
        let threshold = ((2.0 * (z.len() as f64).ln()).sqrt() + 1.0) * usual;
        let contradicts = contradicting(&self.repeats.groups_of_rows(), &z);
        let is_out = |row: &usize| z[*row].abs() > threshold || contradicts[*row];
        let new: Vec<usize> = (0..z.len()).filter(|row| is_out(row) && !present.contains(row)).collect();
        let mut rows = [present, new.clone()].concat();
        rows.sort_unstable();
        (!new.is_empty() && rows.len() as f64 <= FEW * z.len() as f64).then_some(rows)
    }
}

/// Coordinates whose levels may each have a zero of their own: parts, runs and directions, alone and two
/// together, conditions of few levels, and all of them together, which make a pass.
fn groupings(data: &Data) -> Vec<Vec<usize>> {
    let coordinates = data.model.process.coordinates();
    let counts = |by: &[usize]| count(data, by);
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
    let several_files = (data.files.len() > 1).then_some(FILE);
    let numbers = given().filter(|i| is_number(i) && counts(&[*i]) > 1);
    let numbers: Vec<usize> = numbers.chain(several_files).collect();
    let conditions: Vec<usize> = given().filter(is_condition).collect();
    let pairs = numbers.iter().enumerate().flat_map(|(k, i)| numbers[k + 1..].iter().map(|j| vec![*i, *j]));
    let pass: Vec<usize> = numbers.iter().chain(&conditions).copied().collect();
    // What is off by the same whenever an approach or a branch comes again is not set anew: it is the machine's.
    let returns = |i: &usize| {
        let stretches = 1 + data.levels(&[*i]).windows(2).filter(|two| two[0] != two[1]).count();
        matches!(coordinates.get(*i).map(|c| c.holds), Some(Holds::Word(_))) && stretches > counts(&[*i])
    };
    let alone = numbers.iter().filter(|i| !returns(i)).chain(&conditions);
    let several = alone.map(|i| vec![*i]).chain(pairs);
    let mut all: Vec<Vec<usize>> = given().filter(is_sensor).map(|i| vec![i]).collect();
    for by in several.chain((!conditions.is_empty()).then_some(pass)) {
        // What groups the rows as another does is not told twice.
        let levels = data.levels(&by);
        if groups(&by) && all.iter().all(|other| data.levels(other) != levels) {
            all.push(by);
        }
    }
    if numbers.is_empty() && all.is_empty() && time.is_some() {
        // One series has one zero.
        all.push(Vec::new());
    }
    all
}

/// Coordinates that are places, angles or times, along which things change.
fn places(data: &Data) -> impl Iterator<Item = Along> {
    let coordinates = data.model.process.coordinates();
    data.given.iter().filter_map(|i| match coordinates[*i].holds {
        Holds::Quantity(kind) if [LENGTH, ANGLE, TIME].contains(&kind) => {
            Some(Along { coordinate: *i, is_angle: kind == ANGLE })
        }
        _ => None,
    })
}

/// Slopes along places, anew for every part, run or file: how it was put into the instrument. The slope that all of
/// them share is the machine's as well as the instrument's, and is told by neither.
fn alignments(data: &Data) -> Vec<Term> {
    let coordinates = data.model.process.coordinates();
    let is_label = |i: &usize| {
        coordinates.get(*i).is_none_or(|c| c.repeats || matches!(c.holds, Holds::Number(_) | Holds::Word(_)))
    };
    let is_time = |i: usize| coordinates[i].holds.kind() == Some(TIME);
    let is_place =
        |a: &Along| !is_label(&a.coordinate) && !is_time(a.coordinate) && count(data, &[a.coordinate]) >= LEAST_PLACES;
    let places: Vec<Along> = places(data).filter(is_place).collect();
    let by = groupings(data).into_iter().filter(|by| by.iter().all(is_label) && count(data, by) >= LEAST_ASKEW);
    let of_one = |(by, place): (&Vec<usize>, &Along)| {
        let term = Term { by: by.clone(), along: Some(*place), ..Term::new(&effects::ALIGNMENT) };
        own_observables(data).into_iter().map(move |observable| Term { observable, ..term.clone() })
    };
    by.flat_map(|by| places.iter().flat_map(move |place| of_one((&by, place))).collect::<Vec<_>>()).collect()
}

/// The step of the instrument where the values of the file show one that is coarse beside their noise.
fn resolutions(data: &Data, noise: &Noise) -> Vec<Term> {
    /// Standard deviation of rounding, over the noise, from which a step is coarse.
    const COARSE: f64 = 0.5;
    let has = |o: Option<usize>| noise.terms.iter().any(|t| *t.effect == effects::RESOLUTION && t.observable == o);
    let own = own_observables(data).into_iter().enumerate().filter(|(_, observable)| !has(*observable));
    let term = |(number, observable): (usize, Option<usize>)| {
        let size = step_of(data, data.as_read(), number)?;
        let usual = noise.usual(data, data.observables[number].position);
        let is_coarse = size / 12f64.sqrt() > COARSE * usual;
        is_coarse.then(|| Term { observable, size, ..Term::new(&effects::RESOLUTION) })
    };
    own.filter_map(term).collect()
}

/// Number of levels of some coordinates together.
fn count(measurements: &Measurements, by: &[usize]) -> usize {
    measurements.levels(by).into_iter().max().map_or(0, |most| most + 1)
}

/// Observables on which a term may act: each by itself where there are several.
pub fn own_observables(measurements: &Measurements) -> Vec<Option<usize>> {
    match &measurements.observables[..] {
        [_] => vec![None],
        several => several.iter().map(|s| Some(s.position)).collect(),
    }
}
