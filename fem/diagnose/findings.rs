//! Findings about the measurement: its missing effects in the best model, and outlying rows.

use super::candidate_model::CandidateModel;
use super::diagnosis::{Cause, Diagnosis, Missing, Outlier};
use super::doubtful;
use super::instrument;
use super::largest_change::LargestChange;
use super::posterior::Posterior;
use super::verdict::{GoodnessOfFit, Verdict};
use crate::fit::{StoppingCriterion, minimise, size_estimate};
use crate::input::Name;
use crate::measure::{Repeats, grouping_name};
use crate::model::Data;
use crate::noise::{Acts, FROM, MEASUREMENT, Restricted, Term, beyond_chi2, effects};
use crate::process::{Description, Neutral};

/// The rows that are weighed down.
pub fn outliers(best: &CandidateModel) -> Vec<Outlier> {
    let (data, noise) = (best.objective.data, &best.objective.noise);
    let residuals = best.residuals();
    let left = noise.unshared(&residuals);
    let weighed = noise.terms.iter().filter(|t| matches!(t.effect.acts, Acts::Weighs));
    let outlier = |(row, factor): (usize, f64)| Outlier {
        record: data.record(row),
        observable: data.observable(row),
        line: data.line(row),
        value: data.observed[row],
        predicted: data.observed[row] - left[row],
        weight: 1.0 / (factor * factor),
    };
    weighed.flat_map(|t| t.rows.iter().map(|row| (*row, t.size))).map(outlier).collect()
}

/// Missing effects of the measurement: the terms of the best model that the file does not state, each with the goodness
/// of the model with it and those before it.
pub fn missing_effects(
    base: &CandidateModel,
    best: &CandidateModel,
    plain: Option<&CandidateModel>,
    repeats: &Repeats,
    posterior: &Posterior,
) -> Vec<Missing> {
    let Some(plain) = plain else { return Vec::new() };
    let Some(mean) = best.objective.mean(&best.solution) else { return Vec::new() };
    let (data, noise) = (best.objective.data, &best.objective.noise);
    let residuals = best.residuals();
    let shares = noise.shares(&residuals);
    let restricted = Restricted { measurements: data, residuals: &residuals, mean: &mean };
    let whole = restricted.minus_two_log(noise);
    let follows = doubtful::terms_that_follow(best);
    let tell = |(number, term): (usize, &Term)| {
        let others = noise.terms_but(number);
        let (own, _) = instrument::plain(best, repeats, &others);
        let without = restricted.minus_two_log(&restricted.estimate(&own, &others, others.len()));
        let mut grown = plain.clone();
        grown.objective.noise =
            instrument::plain(base, repeats, &noise.terms[..=number]).0.with(noise.terms[..=number].to_vec(), data);
        let solution = minimise(&mut grown.objective, &plain.solution.position, &[], StoppingCriterion::FULL);
        grown.solution = solution.unwrap_or_else(|| plain.solution.clone());
        let along = term.along.map(|along| &data.model.process.coordinates()[along.coordinate]);
        Missing {
            cause: Cause::Measurement {
                effect: term.effect,
                along: along.map(|coordinate| coordinate.name.clone()),
                period: term.period.zip(along.and_then(|coordinate| coordinate.holds.kind())),
                by: term.by.iter().map(|i| grouping_name(&*data.model.process, *i)).collect(),
                observable: term.observable.map(|o| data.model.process.observables()[o].name.clone()),
                records: records(term, data),
                from: term.effect.has(FROM).then(|| term.rows.first().map(|r| data.place(*r))).flatten(),
                from_line: term.effect.has(FROM).then(|| term.rows.first().map(|r| data.line(*r))).flatten(),
            },
            effect: instrument::description(term, data),
            before: Vec::new(),
            probability: posterior.of(term.effect.name),
            goodness: GoodnessOfFit::of(&grown, repeats, None),
            // At the edge of its range the size of a term has half of χ² with one degree of freedom.
            p_value: beyond_chi2(1.0, without - whole).map_or(1.0, |p| 0.5 * p),
            estimates: vec![size_estimate(term, data, &restricted, noise, number)],
            largest_change: LargestChange::of(&shares[number], &noise.sigma, data),
            indistinguishable_from: Vec::new(),
            bend: None,
            doubt: follows.iter().find(|(other, _)| *other == number).map(|(_, column)| follows_text(column)),
        }
    };
    let is_new = |(_, term): &(usize, &Term)| !term.is_among(&data.terms);
    noise.terms.iter().enumerate().filter(is_new).map(tell).collect()
}

/// Why zeros that follow a column are not those of an instrument.
fn follows_text(column: &Name) -> String {
    format!("it follows `{column}`, and what follows a column is no chance")
}

/// Says of the curve of a sensor's characteristic that it may be one of what is measured: rows that the sensor has shown
/// cannot tell the two, so that it is described and not explained.
pub fn doubt_sensors(diagnosis: &mut Diagnosis) {
    let is_curve = |m: &&mut Missing| m.effect.parameters.iter().any(|p| p.over.is_some());
    let mut all = diagnosis.missing.iter_mut().filter(is_curve).peekable();
    if all.peek().is_none() {
        return;
    }
    let text = "it may be a law of what is measured: only masters of known size tell that from the sensor";
    all.for_each(|missing| missing.doubt = Some(text.into()));
    diagnosis.verdict = Verdict::beside_what_describes(&diagnosis.missing);
}

/// Cause behind an effect that was found among the candidates.
pub fn cause(effect: &Description) -> Cause {
    if let Some((Neutral::Written(written, _), kind)) = effect.parameters.first().map(|p| (p.neutral, p.kind)) {
        return Cause::Value { written: kind.to_si(written) };
    }
    match effects::all().find(|e| effect.table == MEASUREMENT && e.name == effect.name) {
        Some(entry) => Cause::of(entry, effect.observable.clone()),
        None => Cause::Physical,
    }
}

/// Records of the file on which a term acts, counted from 1; those that the model weighs down already are left
/// out.
fn records(term: &Term, data: &Data) -> Vec<usize> {
    let is_weighed = |t: &Term| t.effect == term.effect && matches!(t.effect.acts, Acts::Weighs);
    let is_known = |row: &usize| data.terms.iter().any(|t| is_weighed(t) && t.rows.contains(row));
    let mut records: Vec<usize> = term.rows.iter().filter(|row| !is_known(row)).map(|row| data.record(*row)).collect();
    records.dedup();
    records
}
