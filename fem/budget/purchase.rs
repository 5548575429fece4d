//! Which term of a budget to buy down: what the total becomes with less of it, and with how little of it alone the total keeps
//! its tolerance.

use super::estimate::by_rules;
use super::part::Swing;
use super::{Budget, Contribution};

/// Halvings after which the part of a term that may stay is known.
const HALVINGS: usize = 40;

/// What less of one term does to the total by the handbook. m.
#[derive(Clone, Debug, PartialEq)]
pub struct Purchase {
    /// Name of the term.
    pub name: String,
    /// The total with half of it.
    pub halved: f64,
    /// The total without it.
    pub without: f64,
    /// Part of it that may stay for the total to keep the tolerance, all else as it is; `None` where there is no tolerance, or
    /// not even the whole of it suffices.
    pub may_stay: Option<f64>,
}

/// Every term, the one whose half takes most off the total first.
pub(super) fn purchases(budget: &Budget, errors: &[Contribution], figures: &[f64], swings: &[Swing]) -> Vec<Purchase> {
    let parts = &budget.models.parts;
    let names = errors.iter().map(|own| own.name.clone()).chain(parts.iter().map(|own| own.name.clone()));
    let names = names.chain(swings.iter().map(|(name, ..)| name.clone()));
    let with = |term: usize, part: f64| {
        let of = |own: usize| if own == term { part } else { 1.0 };
        let errors: Vec<Contribution> = errors
            .iter()
            .enumerate()
            .map(|(i, own)| Contribution { value: of(i) * own.value, ..own.clone() })
            .collect();
        let figures: Vec<f64> = figures.iter().enumerate().map(|(i, own)| of(errors.len() + i) * own).collect();
        let first = errors.len() + figures.len();
        let swing = |(i, (name, law, (a, b))): (usize, &Swing)| {
            let part = of(first + i);
            (name.clone(), *law, (part * a, part * b))
        };
        let swings: Vec<Swing> = swings.iter().enumerate().map(swing).collect();
        by_rules(budget, &errors, &figures, &swings)
    };
    let keeps = |term: usize, part: f64, (lower, upper): (f64, f64)| {
        let own = with(term, part);
        lower <= own.systematic - own.random && own.systematic + own.random <= upper
    };
    let may_stay = |term: usize| {
        let tolerance = budget.tolerance?;
        if keeps(term, 1.0, tolerance) {
            return Some(1.0);
        }
        let (mut good, mut bad) = (0.0, 1.0);
        if !keeps(term, good, tolerance) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (good + bad);
            *(if keeps(term, middle, tolerance) { &mut good } else { &mut bad }) = middle;
        }
        Some(good)
    };
    let one = |(term, name): (usize, String)| {
        let [halved, without] = [0.5, 0.0].map(|part| with(term, part).total);
        Purchase { name, halved, without, may_stay: may_stay(term) }
    };
    let mut all: Vec<Purchase> = names.enumerate().map(one).collect();
    all.sort_by(|a, b| a.halved.total_cmp(&b.halved));
    all
}
