//! Effects of the measurement: which terms of the covariance the residuals of a model ask for.

use nalgebra::DMatrix;
use rayon::prelude::*;

use super::candidate_model::CandidateModel;
use super::laplace;
use crate::fit::{StoppingCriterion, minimise};
use crate::measure::Repeats;
use crate::model::Data;
use crate::noise::{
    Acts, Evidence, MEASUREMENT, MeasurementEffect, Noise, Restricted, Size, Term, effects, is_rough, own_observables,
    time_of,
};
use crate::process::{self, Belongs, Description, Odds};

/// Stopping criterion that is enough to rank terms.
const QUICK: StoppingCriterion = StoppingCriterion::rough(12, 1e-3);
/// Odds of a scale or a clock that is off, which somebody has adjusted: where the machine may be at fault as well, it is
/// named, and the instrument beside it.
const ADJUSTED: f64 = 0.05;
/// How far the characteristics of sensors bend away from a line, as parts of their range: from good ones to poor ones.
const BOWED: [f64; 2] = [1e-4, 0.02];

/// Noise by which a model's rows are judged when terms are at work, without their shares yet.
pub fn plain(trial: &CandidateModel, repeats: &Repeats, terms: &[Term]) -> (Noise, Repeats) {
    Noise::beside(terms, trial.objective.data, repeats, &trial.residuals())
}

/// −2 ln L of a fitted model with penalties on its parameters and on the terms of its noise.
pub fn criterion(trial: &CandidateModel) -> f64 {
    laplace::criterion(trial).unwrap_or(f64::INFINITY)
}

/// −2 ln L of a fitted model, less a constant. Repeats that happen to scatter more than what is left do not tell the
/// level of the noise any better than the other rows: it is the most likely one then, as it is beside terms.
pub fn minus_two_log(trial: &CandidateModel) -> f64 {
    let (noise, rows) = (&trial.objective.noise, trial.objective.data.len() as f64);
    let square = match trial.solution.chi2 / rows {
        ratio if ratio < 1.0 && ratio > 0.0 && !noise.source.is_known() => rows * (1.0 + ratio.ln()),
        _ => trial.solution.chi2,
    };
    square + noise.log_determinant()
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
    proposed(trial, repeats, |evidence| effects::sought(evidence, false))
}

/// Every curve over places that the residuals of a model may ask for, the most promising first.
pub fn curves(trial: &CandidateModel, repeats: &Repeats) -> Vec<Proposal> {
    proposed(trial, repeats, |evidence| effects::sought(evidence, true))
}

/// Outlying rows that contradict the rows that they repeat, as a term; `None` where there are none, or too
/// many to be single mistakes.
pub fn contradictions(trial: &CandidateModel, repeats: &Repeats) -> Option<Proposal> {
    proposed(trial, repeats, |evidence| effects::contradictions(evidence).into_iter().collect()).pop()
}

/// Estimates the sizes of the terms that `seek` finds beside a model, and fits it again under each.
fn proposed(trial: &CandidateModel, repeats: &Repeats, seek: impl Fn(&Evidence) -> Vec<Vec<Term>>) -> Vec<Proposal> {
    let Some(mean) = trial.objective.mean(&trial.solution) else { return Vec::new() };
    let (data, noise, residuals) = (trial.objective.data, &trial.objective.noise, trial.residuals());
    let mut all = data.progress.stretch("terms of the noise", || {
        let sets = seek(&data.evidence(noise, repeats, &residuals, &mean));
        judged(trial, repeats, &mean, sets)
    });
    all.retain(|p| is_rough(&p.noise, &residuals));
    all
}

/// The noise of a model less each of the terms that were found, the least needed first.
pub fn with_a_term_less(trial: &CandidateModel, repeats: &Repeats) -> Vec<Proposal> {
    let Some(mean) = trial.objective.mean(&trial.solution) else { return Vec::new() };
    let (stated, noise) = (&trial.objective.data.terms, &trial.objective.noise);
    let found = (0..noise.terms.len()).filter(|number| !noise.terms[*number].is_among(stated));
    judged(trial, repeats, &mean, found.map(|number| noise.terms_but(number)).collect())
}

/// Estimates the sizes of each of these sets of terms beside a model, and fits it again under each.
fn judged(trial: &CandidateModel, repeats: &Repeats, mean: &DMatrix<f64>, sets: Vec<Vec<Term>>) -> Vec<Proposal> {
    let residuals = trial.residuals();
    let restricted = Restricted { measurements: trial.objective.data, residuals: &residuals, mean };
    let judge = |terms: Vec<Term>| {
        let (own, repeats) = plain(trial, repeats, &terms);
        let noise = sized(&restricted, own, &terms, &trial.objective.data.terms);
        let mut refitted = trial.clone();
        refitted.objective.noise = noise.clone();
        let solution = minimise(&mut refitted.objective, &trial.solution.position, &[], QUICK);
        refitted.solution = solution.unwrap_or_else(|| trial.solution.clone());
        Proposal { noise, repeats, criterion: criterion(&refitted) }
    };
    let mut all: Vec<Proposal> = sets.into_par_iter().map(judge).collect();
    all.retain(|p| p.criterion.is_finite());
    all.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    all
}

/// The noise of a model's terms with their sizes estimated anew, and the repeats within their groups.
pub fn settled(trial: &CandidateModel, repeats: &Repeats) -> Option<(Noise, Repeats)> {
    let mean = trial.objective.mean(&trial.solution)?;
    let residuals = trial.residuals();
    let restricted = Restricted { measurements: trial.objective.data, residuals: &residuals, mean: &mean };
    let terms = trial.objective.noise.terms.clone();
    let (own, within) = plain(trial, repeats, &terms);
    Some((sized(&restricted, own, &terms, &trial.objective.data.terms), within))
}

/// The noise with the sizes of its terms at their most likely values; without terms repeats tell its level.
fn sized(restricted: &Restricted, own: Noise, terms: &[Term], stated: &[Term]) -> Noise {
    if terms.is_empty() {
        return own;
    }
    let of_found = |term: &Term| match term.is_among(stated) {
        true => term.clone(),
        false => effects::outlying_by(term, restricted.residuals, &own),
    };
    let terms: Vec<Term> = terms.iter().map(of_found).collect();
    restricted.estimate(&own, &terms, terms.len())
}

/// A model with the sizes of its terms estimated anew, fitted again.
pub fn resized<'a>(trial: &CandidateModel<'a>, repeats: &Repeats) -> Option<CandidateModel<'a>> {
    let mut resized = trial.clone();
    resized.objective.noise = settled(trial, repeats)?.0;
    let start = &trial.solution.position;
    resized.solution = minimise(&mut resized.objective, start, &[], StoppingCriterion::FULL)?;
    Some(resized)
}

/// Effects of reading that the instrument may have and the model lacks, to be sought like the effects of the machine: a
/// scale for each observable, and a clock where there are times.
pub fn absent_readings(data: &Data) -> Vec<Description> {
    let of_reading = effects::all().filter(|e| e.acts.is_reading());
    let is_absent =
        |effect: &MeasurementEffect| data.model.measurement.iter().all(|term| term.effect.name != effect.name);
    let of = |effect: &'static MeasurementEffect| match effect.acts {
        Acts::Times(_) => {
            let time = time_of(&*data.model.process).filter(|time| data.given.contains(time));
            time.map_or(Vec::new(), |_| vec![Term::new(effect)])
        }
        _ => {
            let range = |term: &Term| matches!(effect.size, Size::OfReading(_)).then(|| sensed(term, data));
            let own = own_observables(data).into_iter().map(|observable| Term { observable, ..Term::new(effect) });
            own.filter_map(|term| Some(Term { range: range(&term).map_or(Some(None), |r| r.map(Some))?, ..term }))
                .collect()
        }
    };
    of_reading.filter(|e| is_absent(e)).flat_map(of).map(|term| description(&term, data)).collect()
}

/// The range, SI, of what a sensor shows as it is: from its zero, at which sensors are set, over all readings; `None`
/// where it is none, or hardly changes.
fn sensed(term: &Term, data: &Data) -> Option<[f64; 2]> {
    let own = data.observables.iter().find(|s| term.observable.is_none_or(|o| o == s.position))?;
    let is_sensed = data.model.process.observables()[own.position].is_sensed;
    let values = (0..data.len()).filter(|row| term.is_of(data, *row)).map(|row| data.observed[row]);
    let zero = data.model.process.observables()[own.position].kind.to_si(0.0);
    let (low, high) = process::range(values.chain([zero]));
    (is_sensed && high > low).then_some([low, high])
}

/// A term as the catalogue of effects tells one.
pub fn description(term: &Term, data: &Data) -> Description {
    let parameter = match term.effect.size {
        Size::Quantity(parameter) => {
            // Of what is late by more than the file lasts it shows nothing.
            let time = matches!(term.effect.acts, Acts::Times(_)).then(|| time_of(&*data.model.process)).flatten();
            let along = time.map(|time| data.model.process.coordinates()[time].name.clone());
            process::Parameter { along, ..parameter.clone() }
        }
        Size::OfReading(parameter) => {
            let kind = term.kind(data);
            let span = term.range.map_or(f64::INFINITY, |[low, high]| (high - low) / kind.canonical().factor);
            let range = BOWED.map(|part| part * span).into();
            process::Parameter { kind, range, over: term.range, ..parameter.clone() }
        }
        size => {
            let kind = term.kind(data);
            process::Parameter::amplitude(size.key(), kind, size.about(), (0.0, f64::INFINITY))
        }
    };
    Description {
        table: MEASUREMENT,
        name: term.effect.name.into(),
        observable: term.observable.map(|o| data.model.process.observables()[o].name.clone()),
        about: term.effect.about.into(),
        law: term.effect.law.into(),
        source: term.effect.source,
        belongs: Belongs::Test,
        odds: Odds::of(ADJUSTED, "instruments are adjusted"),
        parameters: vec![parameter].into(),
        look_alikes: &[],
        changes: None,
    }
}
