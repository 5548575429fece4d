//! Effects of the measurement that the residuals of a model ask for.

use std::sync::OnceLock;

use rayon::prelude::*;

use super::effects::{contradictions, sought};
use super::evidence::{Evidence, PROMISING};
use super::recurring::recurs;
use super::term::{Acts, Term};
use super::{Noise, Restricted};
use crate::measure::of_neighbours;

/// Ratio of the scatter of neighbouring rows to all scatter below which structure, not noise, is what
/// exceeds the stated uncertainty.
const ROUGH: f64 = 0.8;
/// Most rows in which terms are suspected.
const MOST_ROWS: usize = 20_000;

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

/// Terms that the residuals ask for more than chance would, one after another, with their sizes: what the
/// noise is besides what it is taken for.
pub fn suspects(evidence: &Evidence) -> Vec<Term> {
    let Evidence { measurements, noise, repeats, residuals, mean, .. } = *evidence;
    if measurements.len() > MOST_ROWS || is_round_off(residuals, &measurements.observed) {
        return Vec::new();
    }
    let restricted = Restricted { measurements, residuals, mean };
    let cost = |noise: &Noise| restricted.minus_two_log(noise) + noise.price();
    // Terms are weighed at the level that is most likely with them; what is here is too.
    let here = cost(noise).min(cost(&restricted.estimate(noise, &noise.terms, 0)));
    let judge = |terms: Vec<Term>| {
        let (own, _) = Noise::beside(&terms, measurements, repeats, residuals);
        let judged = restricted.estimate(&own, &terms, terms.len() - noise.terms.len());
        (cost(&judged), judged)
    };
    let sets = contradictions(evidence).into_iter().chain(sought(evidence, false));
    let all: Vec<(f64, Noise)> = sets.collect::<Vec<_>>().into_par_iter().map(judge).collect();
    let Evidence { process, as_read, .. } = *evidence;
    let is_chance = |noise: &Noise| {
        let scan = OnceLock::new();
        let under = Evidence { process, measurements, as_read, noise, repeats, residuals, mean, scan };
        is_rough(noise, residuals) && !recurs(&under, &evidence.noise.terms)
    };
    let likely = all.into_iter().filter(|(at, noise)| *at < here - PROMISING && is_chance(noise));
    let best = likely.min_by(|a, b| a.0.total_cmp(&b.0));
    let is_new = |term: &Term| !term.is_among(&noise.terms);
    best.map_or_else(Vec::new, |(_, noise)| noise.terms.into_iter().filter(is_new).collect())
}
