//! The search for terms of laws: the best of every pool of candidates, amplitudes by projection, constants by refinement, each
//! term at the price of its constants and of the width of the search.

use std::mem::{Discriminant, discriminant};

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::form::{Metric, Shapes};
use super::shape::Shape;
use super::variable::{Factor, Variable, product};
use crate::progress::Progress;

/// Most functions of one product.
pub const MOST_FUNCTIONS: usize = 6;
/// Refined laws of which shapes are exchanged and terms left out.
const POLISHED: usize = 24;
/// Fall of the criterion that refinement may bring.
const UNREFINED: f64 = 40.0;
/// Price of a law of the prediction, which follows from what the machine is asked to do: it says less than a law of that.
pub const PREDICTION: f64 = 6.0;
/// Part of the degrees of freedom that a law leaves at least, as χ².
const LEAST_LEFT: f64 = 0.9;
/// Part of a column that must be left beside others for it to be another.
const DEPENDENT: f64 = 1e-6;

/// A product of shapes that is added to one observable.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The observable, by its position in the process's list.
    pub observable: usize,
    /// Its factors.
    pub factors: Vec<Factor>,
}

/// Terms with what they explain together.
#[derive(Clone, Debug)]
pub struct Found {
    /// The terms.
    pub terms: Vec<Term>,
    /// Fall of χ².
    pub gain: f64,
    /// Number of their amplitudes that the rows tell apart, and of their constants.
    pub freedom: usize,
    /// −2 ln of their likelihood, and their price.
    pub criterion: f64,
    /// The price: ln n for each number, and the width of the search.
    pub price: f64,
}

impl Found {
    /// Whether it is another law with further factors or terms.
    pub fn is_more_than(&self, other: &Self) -> bool {
        let shapes = |law: &Self| -> Vec<FactorKind> {
            let family = |own: &Factor| (own.variable, own.other, discriminant(&own.shape.family()));
            law.terms.iter().flat_map(|term| term.factors.iter().map(family)).collect()
        };
        let mut own = shapes(self);
        let is_more = own.len() > shapes(other).len();
        is_more
            && shapes(other).iter().all(|shape| {
                let place = own.iter().position(|own| own == shape);
                place.map(|place| own.swap_remove(place)).is_some()
            })
    }
}

fn shape_of(own: &Factor) -> FactorKind {
    (own.variable, own.other, discriminant(&own.shape))
}

/// Residuals of a model, and the variables over which laws are sought.
pub struct Bench<'a, 'm> {
    /// Each observable and how its columns are weighed.
    pub metrics: Vec<(usize, Metric<'a, 'm>)>,
    /// The residual, in standard uncertainties, beside what the model's own parameters imitate.
    pub residual: &'a DVector<f64>,
    /// What the model's own parameters imitate: an orthonormal basis.
    pub tangent: &'a DMatrix<f64>,
    /// Its degrees of freedom.
    pub freedom: f64,
    /// Number of rows.
    pub rows: usize,
    /// Variables.
    pub variables: &'a [Variable],
    /// Shapes of each variable.
    pub factors: Vec<Vec<Factor>>,
    /// Their functions at every level of the variable, and at a few values in the place of all.
    pub at_levels: Vec<Shapes>,
    pub at_some: Vec<Shapes>,
    /// What of each variable is beyond a part of another.
    pub excesses: Vec<Factor>,
    /// Criterion that a law must not exceed, where something else explains the rows.
    pub most: f64,
}

/// The shapes of a term, without their constants: terms of one kind are rivals.
type FactorKind = (usize, Option<usize>, Discriminant<Shape>);

impl Bench<'_, '_> {
    /// −2 ln of the likelihood of what is left. While more is left than noise, its level is not known better than by what is
    /// left itself.
    pub fn misfit(&self, left: f64) -> f64 {
        if left > self.freedom { self.freedom * (1.0 + (left / self.freedom).ln()) } else { left }
    }

    /// The least criterion that a law can have with further terms.
    pub fn least_of_further(&self, law: &Found) -> f64 {
        let left = (self.residual.norm_squared() - law.gain).max(0.0);
        let least = self.factors.iter().map(|own| own.len().max(1)).min().unwrap_or(1);
        let width = ((self.variables.len() * least) as f64).ln();
        law.criterion - self.misfit(left)
            + self.misfit(LEAST_LEFT * self.freedom)
            + 2.0 * width
            + (self.rows as f64).ln()
    }

    /// How the columns of an observable are weighed.
    pub fn metric(&self, observable: usize) -> Option<&Metric<'_, '_>> {
        self.metrics.iter().find(|(own, _)| *own == observable).map(|(_, metric)| metric)
    }

    /// The functions of terms in every row, in standard uncertainties per unit of the error.
    pub fn seen(&self, terms: &[Term]) -> Vec<DVector<f64>> {
        let one = |term: &Term| {
            let columns: Vec<Vec<Vec<f64>>> = term.factors.iter().map(|own| own.columns(self.variables)).collect();
            self.metric(term.observable).map(|metric| metric.seen(&product(&columns))).unwrap_or_default()
        };
        terms.iter().flat_map(one).collect()
    }

    /// What orthonormal directions explain of the residual, χ².
    pub fn explained(&self, basis: &[DVector<f64>]) -> f64 {
        basis.iter().map(|own| own.dot(self.residual).powi(2)).sum()
    }

    /// Numbers of the variables of which a law is made, each once, rising.
    pub fn variables_of(&self, law: &Found) -> Vec<usize> {
        let factors = law.terms.iter().flat_map(|term| &term.factors);
        let mut all: Vec<usize> = factors.flat_map(|factor| factor.made_of(self.variables)).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The price of so many numbers and of a choice among so many laws, by its logarithm.
    pub fn price(&self, freedom: usize, width: f64) -> f64 {
        freedom as f64 * (self.rows as f64).ln() + 2.0 * width
    }

    /// Whether another law says the same of the rows to within so many standard uncertainties of all together.
    pub fn is_within(&self, law: &Found, other: &Found, least: f64) -> bool {
        let columns = self.seen(&law.terms);
        let Some(sizes) = amplitudes(&columns, self.residual) else { return false };
        let said =
            columns.iter().zip(sizes).fold(DVector::zeros(self.residual.len()), |sum, (own, size)| sum + own * size);
        let others = basis(self.seen(&other.terms));
        let rest = others.iter().fold(said.clone(), |rest, own| rest - own * own.dot(&said));
        rest.norm() < least
    }

    /// Terms with what they explain together.
    pub fn judged(&self, terms: Vec<Term>) -> Found {
        let gain = self.gain(&[], self.seen(&terms));
        self.priced(terms, gain)
    }

    /// Fall of χ² by columns beside others, which are orthonormal, and their number; columns that are not finite explain nothing.
    pub fn gain(&self, others: &[DVector<f64>], columns: Vec<DVector<f64>>) -> (f64, usize) {
        if columns.iter().any(|column| !column.norm().is_finite()) {
            return (0.0, 1);
        }
        let basis = beside(others, columns);
        (self.explained(&basis), basis.len().max(1))
    }

    /// Terms of which the fall of χ² and the number of amplitudes are known.
    pub fn priced(&self, terms: Vec<Term>, (gain, amplitudes): (f64, usize)) -> Found {
        let factors = || terms.iter().flat_map(|term| &term.factors);
        let constants: usize = factors().map(Factor::sought).sum();
        let freedom = amplitudes + constants;
        let predictions = factors().filter(|own| self.variables[own.variable].is_prediction).count();
        let price = self.price(freedom, self.width(&terms)) + PREDICTION * predictions as f64;
        let left = (self.residual.norm_squared() - gain).max(0.0);
        Found { terms, gain, freedom, criterion: self.misfit(left) + price, price }
    }

    /// Logarithm of the number of laws of as many shapes of these variables, or of others.
    pub fn width(&self, terms: &[Term]) -> f64 {
        let mut seen: Vec<&Factor> = Vec::new();
        let mut width = 0.0;
        for factor in terms.iter().flat_map(|term| &term.factors) {
            // What two terms have in common is chosen once.
            if !seen.contains(&factor) {
                width += self.width_of(factor, usize::MAX);
                seen.push(factor);
            }
        }
        width - (1..=seen.len()).map(|k| (k as f64).ln()).sum::<f64>()
    }

    /// Logarithm of the number of shapes in the place of one, those of a variable no more than `most`.
    pub fn width_of(&self, factor: &Factor, most: usize) -> f64 {
        ((self.variables.len() * self.factors[factor.variable].len().min(most)).max(1) as f64).ln()
    }

    /// The best further terms beside those of a law, refined with them, the best law first.
    pub fn further(&self, law: &Found, progress: &Progress) -> Vec<Found> {
        let beside = basis(self.seen(&law.terms));
        let mut all: Vec<Found> = Vec::new();
        for (observable, metric) in &self.metrics {
            let form = metric.beside(&beside);
            let mut pools = self.pools((law, beside.len()), *observable, metric, &form, progress);
            pools.retain(|own| own.criterion < self.most + UNREFINED);
            let mut refined: Vec<Found> = pools.into_par_iter().map(|own| self.refined(own)).collect();
            refined.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
            let rest = refined.split_off(POLISHED.min(refined.len()));
            all.extend(refined.into_par_iter().map(|own| self.polished(own)).collect::<Vec<_>>());
            all.extend(rest);
        }
        all.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        self.best_of_kinds(all, usize::MAX, 1)
    }

    /// The best of some laws, no more than `each` of the same shapes of the same variables.
    pub fn best_of_kinds(&self, mut found: Vec<Found>, most: usize, each: usize) -> Vec<Found> {
        found.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        let mut kinds: Vec<(Vec<FactorKind>, usize)> = Vec::new();
        let mut best = Vec::new();
        for own in found {
            let kind = kind(&own.terms);
            match kinds.iter_mut().find(|(other, _)| *other == kind) {
                Some((_, count)) if *count >= each => continue,
                Some((_, count)) => *count += 1,
                None => kinds.push((kind, 1)),
            }
            best.push(own);
            if best.len() == most {
                break;
            }
        }
        best
    }
}

/// The shapes of terms, in an order of their own.
pub fn kind(terms: &[Term]) -> Vec<FactorKind> {
    let sorted = |term: &Term| {
        let mut all: Vec<FactorKind> = term.factors.iter().map(shape_of).collect();
        all.sort_by_key(|own| (own.0, own.1, format!("{:?}", own.2)));
        all
    };
    let mut all: Vec<Vec<FactorKind>> = terms.iter().map(sorted).collect();
    all.sort_by_key(|term| term.iter().map(|own| (own.0, own.1)).collect::<Vec<_>>());
    all.concat()
}

/// An orthonormal basis of columns, without those that depend on others.
pub fn basis(columns: Vec<DVector<f64>>) -> Vec<DVector<f64>> {
    beside(&[], columns)
}

/// An orthonormal basis of what columns are beside others, which are orthonormal.
fn beside(others: &[DVector<f64>], columns: Vec<DVector<f64>>) -> Vec<DVector<f64>> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    for mut column in columns {
        let size = column.norm();
        for other in others.iter().chain(&basis) {
            let along = other.dot(&column);
            column.axpy(-along, other, 1.0);
        }
        let left = column.norm();
        if left.is_finite() && left > DEPENDENT * size.max(1e-9) {
            basis.push(column / left);
        }
    }
    basis
}

/// Amplitudes of columns by least squares, in units of the error.
pub fn amplitudes(columns: &[DVector<f64>], left: &DVector<f64>) -> Option<Vec<f64>> {
    let matrix = DMatrix::from_columns(columns);
    let svd = matrix.svd(true, true);
    svd.solve(left, 1e-9).ok().map(|own| own.iter().copied().collect())
}
