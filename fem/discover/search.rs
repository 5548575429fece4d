//! The search for terms of laws: every shape of every variable, every product and every sum of two, products of three grown
//! from the best; amplitudes by projection, constants by refinement, each term at the price of its constants and of the
//! width of the search.

use std::mem::{Discriminant, discriminant};

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::form::{Form, Metric, Shapes};
use super::shape::Shape;
use super::variable::{Factor, Variable, product};
use crate::progress::Progress;

/// Most functions of one product.
const MOST_FUNCTIONS: usize = 6;
/// Terms of each pool that are refined, and pairs from which triples are grown.
const REFINED: usize = 20;
const GROWN: usize = 8;
/// Refined laws of which shapes are exchanged and terms left out.
const POLISHED: usize = 24;
/// Fall of the criterion that refinement may bring.
const UNREFINED: f64 = 40.0;
/// Rounds of refinement, each with half the step.
const ROUNDS: usize = 7;
/// Rounds in which shapes are exchanged for others of the same variable.
const EXCHANGES: usize = 3;
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
    /// Numbers of its variables, each once, rising.
    pub fn variables(&self) -> Vec<usize> {
        let factors = self.terms.iter().flat_map(|term| &term.factors);
        let mut all: Vec<usize> = factors.flat_map(Factor::variables).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

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

    /// Terms with what they explain together.
    pub fn judged(&self, terms: Vec<Term>) -> Found {
        let columns = self.seen(&terms);
        let (gain, amplitudes) = match columns.iter().all(|column| column.norm().is_finite()) {
            false => (0.0, 1),
            true => {
                let basis = basis(columns);
                (self.explained(&basis), basis.len().max(1))
            }
        };
        self.priced(terms, (gain, amplitudes))
    }

    fn priced(&self, terms: Vec<Term>, (gain, amplitudes): (f64, usize)) -> Found {
        let factors = || terms.iter().flat_map(|term| &term.factors);
        let constants: usize = factors().filter(|own| !own.is_known).map(|own| own.constants.len()).sum();
        let freedom = amplitudes + constants;
        let predictions = factors().filter(|own| self.variables[own.variable].is_prediction).count();
        let price =
            freedom as f64 * (self.rows as f64).ln() + 2.0 * self.width(&terms) + PREDICTION * predictions as f64;
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

    /// Candidates of every pool beside a law with so many amplitudes, unrefined.
    fn pools(
        &self,
        (law, amplitudes): (&Found, usize),
        observable: usize,
        metric: &Metric,
        form: &Form,
        progress: &Progress,
    ) -> Vec<Found> {
        let rows = &metric.rows;
        let usable: Vec<usize> = (0..self.variables.len()).filter(|v| self.variables[*v].is_of(rows)).collect();
        let whole = self.residual.norm_squared() - form.chi2;
        // What terms with these factors explain beside the law.
        let further = |factors: Vec<Vec<Factor>>, (gain, count): (f64, usize)| {
            let own = factors.into_iter().map(|factors| Term { observable, factors });
            self.priced(law.terms.iter().cloned().chain(own).collect(), (whole + gain, amplitudes + count))
        };
        let (at_levels, at_some) = (&self.at_levels, &self.at_some);
        let ones = vec![vec![1.0; self.rows]];
        let levels = |v: usize| (self.variables[v].level.as_slice(), self.variables[v].levels.len());
        let some = |v: usize| (self.variables[v].coarse.1.as_slice(), self.variables[v].coarse.0.len());
        let spread = |v: usize, i: usize| at_levels[v].spread(i, &self.variables[v].level);
        let mut all = Vec::new();

        let excesses: Vec<&Factor> = self.excesses.iter().filter(|own| usable.contains(&own.variable)).collect();
        let mut singles = Vec::new();
        for v in &usable {
            let products = form.sums(rows, &ones, levels(*v)).products(&at_levels[*v]);
            let one = |i: usize| further(vec![vec![self.factors[*v][i].clone()]], products.gain(i));
            singles.extend((0..self.factors[*v].len()).into_par_iter().map(one).collect::<Vec<_>>());
        }
        let (nowhere, one) = (vec![0; self.rows], Shapes::new(&[vec![vec![1.0]]]));
        let of_excess = |own: &&Factor| {
            let sums = form.sums(rows, &own.columns(self.variables), (&nowhere, 1));
            further(vec![vec![(*own).clone()]], sums.products(&one).gain(0))
        };
        let of_excesses: Vec<Found> = excesses.par_iter().map(of_excess).collect();
        let grown_from = self.best_of_kinds(of_excesses.clone(), GROWN / 2, 1);
        singles.extend(of_excesses);
        all.extend(self.best_of_kinds(singles, REFINED, 2));
        if !progress.permits("products of two variables") {
            return all;
        }

        let pairs: Vec<(usize, usize)> =
            usable.iter().enumerate().flat_map(|(k, a)| usable[k..].iter().map(move |b| (*a, *b))).collect();
        let (mut products, mut together) = (Vec::new(), Vec::new());
        for (a, b) in pairs {
            let is_longer = self.variables[a].levels.len() > self.variables[b].levels.len();
            let (a, b) = if is_longer { (a, b) } else { (b, a) };
            let of_ones = form.sums(rows, &ones, some(b)).products(&at_some[b]);
            let with = |i: usize| {
                let own = &self.factors[a][i];
                let sums = form.sums(rows, &spread(a, i), some(b));
                let (of_products, of_both) = (sums.products(&at_some[b]), sums.together(&at_some[b], &of_ones));
                let (mut products, mut together) = (Vec::new(), Vec::new());
                for (j, other) in self.factors[b].iter().enumerate() {
                    let is_within = own.shape.functions() * other.shape.functions() <= MOST_FUNCTIONS;
                    // A variable may stand in a product with itself as the envelope of its wave.
                    let is_product = a != b || other.shape.is_envelope() && own.shape.is_wave();
                    let constants = if other.is_known { 0 } else { other.constants.len() };
                    let cheap = |(gain, count): (f64, usize)| {
                        self.misfit((form.chi2 - gain).max(0.0)) + (count + constants) as f64 * (self.rows as f64).ln()
                    };
                    if is_product && is_within {
                        let gain = of_products.gain(j);
                        products.push((cheap(gain), gain, j));
                    }
                    if a != b || i < j {
                        let gain = of_both.gain(j);
                        together.push((cheap(gain), gain, j));
                    }
                }
                // Whole laws are made of the few best alone, each of another shape.
                let best = |mut all: Vec<(f64, (f64, usize), usize)>, most: usize| {
                    all.sort_by(|x, y| x.0.total_cmp(&y.0));
                    let mut kinds = Vec::new();
                    all.retain(|(_, _, j)| {
                        let own = discriminant(&self.factors[b][*j].shape);
                        let is_new = kinds.len() < most && !kinds.contains(&own);
                        kinds.extend(is_new.then_some(own));
                        is_new
                    });
                    all
                };
                let two = |j: usize| [self.factors[b][j].clone(), own.clone()];
                let products = best(products, 3);
                let products = products.into_iter().map(|(_, gain, j)| further(vec![two(j).to_vec()], gain));
                let together = best(together, 2).into_iter();
                let together = together.map(|(_, gain, j)| further(two(j).map(|one| vec![one]).to_vec(), gain));
                (products.collect::<Vec<_>>(), together.collect::<Vec<_>>())
            };
            let own: Vec<_> = (0..self.factors[a].len()).into_par_iter().map(with).collect();
            let (one, other): (Vec<_>, Vec<_>) = own.into_iter().unzip();
            products.extend(self.best_of_kinds(one.into_iter().flatten().collect(), REFINED, 2));
            together.extend(self.best_of_kinds(other.into_iter().flatten().collect(), REFINED / 2, 1));
        }
        all.extend(self.best_of_kinds(together, REFINED / 2, 2));
        let products = self.best_of_kinds(products, REFINED, 2);
        all.extend(products.iter().cloned());

        // Two shapes of one variable that a further one switches or sizes together.
        let mut common = Vec::new();
        let is_common = |own: &Factor| matches!(own.shape, Shape::Sign | Shape::Word | Shape::Proportional);
        let is_plain = |own: &Factor| !own.shape.is_wave() && own.shape != Shape::Ringing;
        let of = |v: usize, is_wanted: &dyn Fn(&Factor) -> bool| -> Vec<usize> {
            (0..self.factors[v].len()).filter(|i| is_wanted(&self.factors[v][*i])).collect()
        };
        let is_own = |v: &&usize| !self.variables[**v].is_prediction;
        let sizes: Vec<(usize, usize)> =
            usable.iter().filter(is_own).flat_map(|a| of(*a, &is_common).into_iter().map(move |i| (*a, i))).collect();
        let plain: Vec<(usize, Vec<usize>)> = usable.iter().filter(is_own).map(|b| (*b, of(*b, &is_plain))).collect();
        for (a, i) in sizes {
            for (b, shapes) in plain.iter().filter(|(b, shapes)| *b != a && shapes.len() > 1) {
                let doubles = form.sums(rows, &spread(a, i), some(*b)).doubles(&at_some[*b]);
                let with = |k: usize| {
                    let one = shapes[k];
                    let two = |other: &usize| {
                        let factors =
                            [one, *other].map(|own| vec![self.factors[a][i].clone(), self.factors[*b][own].clone()]);
                        let (gain, count) = doubles.gain(one, *other);
                        (form.chi2 - gain, count, factors)
                    };
                    let best = shapes[k + 1..].iter().map(two).min_by(|x, y| x.0.total_cmp(&y.0));
                    best.map(|(left, count, factors)| further(factors.to_vec(), (form.chi2 - left, count)))
                };
                let own: Vec<Found> = (0..shapes.len()).into_par_iter().filter_map(with).collect();
                common.extend(self.best_of_kinds(own, REFINED / 4, 1));
            }
        }
        all.extend(self.best_of_kinds(common, REFINED / 2, 1));
        if !progress.permits("products of three variables") {
            return all;
        }

        let refined: Vec<Found> = products.into_par_iter().map(|own| self.refined(own)).collect();
        let refined = self.best_of_kinds(refined, GROWN, 2);
        let mut grown = Vec::new();
        for pair in refined.iter().chain(&grown_from) {
            let Some(term) = pair.terms.last() else { continue };
            let own = product(&term.factors.iter().map(|f| f.columns(self.variables)).collect::<Vec<_>>());
            let is_other = |v: &&usize| {
                !self.variables[**v].is_prediction
                    && term.factors.iter().all(|factor| factor.variable != **v && factor.other != Some(**v))
            };
            let others: Vec<usize> = usable.iter().filter(is_other).copied().collect();
            for v in others {
                let products = form.sums(rows, &own, some(v)).products(&at_some[v]);
                let with = |i: usize| {
                    let factor = &self.factors[v][i];
                    (own.len() * factor.shape.functions() <= MOST_FUNCTIONS).then(|| {
                        let factors = term.factors.iter().cloned().chain([factor.clone()]).collect();
                        further(vec![factors], products.gain(i))
                    })
                };
                grown.extend((0..self.factors[v].len()).into_par_iter().filter_map(with).collect::<Vec<_>>());
            }
        }
        all.extend(self.best_of_kinds(grown, REFINED, 2));
        all
    }

    /// Refined terms with the shapes and the number of them that say most.
    fn polished(&self, found: Found) -> Found {
        let mut best = found;
        for _ in 0..EXCHANGES {
            let before = best.criterion;
            if let Some(other) = self.exchanged(&best) {
                let other = self.refined(other);
                if other.criterion < best.criterion {
                    best = other;
                }
            }
            while best.terms.len() > 1 {
                let less = (0..best.terms.len()).map(|without| {
                    let kept = best.terms.iter().enumerate().filter(|(i, _)| *i != without);
                    self.judged(kept.map(|(_, term)| term.clone()).collect())
                });
                match less.min_by(|a, b| a.criterion.total_cmp(&b.criterion)) {
                    Some(less) if less.criterion < best.criterion => best = self.refined(less),
                    _ => break,
                }
            }
            if best.criterion > before - 1e-6 {
                break;
            }
        }
        best
    }

    /// The best law with one shape exchanged for another of the same variable.
    fn exchanged(&self, found: &Found) -> Option<Found> {
        let mut best: Option<Found> = None;
        for (t, term) in found.terms.iter().enumerate() {
            let metric = self.metric(term.observable)?;
            let rest: Vec<Term> =
                found.terms.iter().enumerate().filter(|(i, _)| *i != t).map(|(_, own)| own.clone()).collect();
            let others = basis(self.seen(&rest));
            let form = metric.beside(&others);
            let whole = self.residual.norm_squared() - form.chi2;
            for (f, factor) in term.factors.iter().enumerate().filter(|(_, factor)| factor.other.is_none()) {
                let beside = term.factors.iter().enumerate().filter(|(i, _)| *i != f);
                let columns: Vec<Vec<Vec<f64>>> = beside.map(|(_, own)| own.columns(self.variables)).collect();
                let own = if columns.is_empty() { vec![vec![1.0; self.rows]] } else { product(&columns) };
                let variable = &self.variables[factor.variable];
                let sums = form.sums(&metric.rows, &own, (&variable.level, variable.levels.len()));
                let products = sums.products(&self.at_levels[factor.variable]);
                for (shape, other) in self.factors[factor.variable].iter().enumerate() {
                    let is_twice = term.factors.iter().enumerate().any(|(i, own)| {
                        let is_envelope = own.shape.is_envelope() && other.shape.is_wave()
                            || own.shape.is_wave() && other.shape.is_envelope();
                        i != f && own.variable == factor.variable && !is_envelope
                    });
                    let is_long = own.len() * other.shape.functions() > MOST_FUNCTIONS;
                    if is_long || is_twice || other.shape == factor.shape {
                        continue;
                    }
                    let (gain, count) = products.gain(shape);
                    let mut terms = found.terms.clone();
                    terms[t].factors[f] = other.clone();
                    let judged = self.priced(terms, (whole + gain, others.len() + count));
                    if best.as_ref().is_none_or(|best| judged.criterion < best.criterion) {
                        best = Some(judged);
                    }
                }
            }
        }
        best
    }

    /// A search by steps along each constant, which are halved.
    pub fn refined(&self, found: Found) -> Found {
        let mut terms = found.terms;
        let mut step = 0.5;
        for _ in 0..ROUNDS {
            for _ in 0..2 {
                let moved = (0..terms.len()).filter(|t| self.moves(&mut terms, *t, step)).count();
                if moved == 0 {
                    break;
                }
            }
            step *= 0.5;
        }
        self.judged(terms)
    }

    /// Moves each constant of a term by a step either way where that explains more; whether one does.
    fn moves(&self, terms: &mut [Term], t: usize, step: f64) -> bool {
        let others: Vec<Term> = terms.iter().enumerate().filter(|(i, _)| *i != t).map(|(_, own)| own.clone()).collect();
        let others = basis(self.seen(&others));
        let Term { observable, factors } = &mut terms[t];
        let Some(metric) = self.metric(*observable) else { return false };
        let gain = |columns: &[Vec<Vec<f64>>]| {
            let seen = metric.seen(&product(columns));
            let is_finite = seen.iter().all(|column| column.norm().is_finite());
            if is_finite { self.explained(&beside(&others, seen)) } else { 0.0 }
        };
        let mut columns: Vec<Vec<Vec<f64>>> = factors.iter().map(|own| own.columns(self.variables)).collect();
        let before = gain(&columns);
        let mut best = before;
        for f in (0..factors.len()).filter(|f| !factors[*f].is_known).collect::<Vec<_>>() {
            for (constant, sign) in (0..factors[f].constants.len()).flat_map(|c| [(c, 1.0), (c, -1.0)]) {
                let ends = self.variables[factors[f].variable].ends();
                let to = moved(&factors[f], constant, sign * step, ends);
                let from = std::mem::replace(&mut factors[f].constants[constant], to);
                let columns_from = std::mem::replace(&mut columns[f], factors[f].columns(self.variables));
                let own = gain(&columns);
                if own > best {
                    best = own;
                } else {
                    factors[f].constants[constant] = from;
                    columns[f] = columns_from;
                }
            }
        }
        best > before * (1.0 + 1e-9)
    }

    /// The best of some laws, no more than `each` of the same shapes of the same variables.
    fn best_of_kinds(&self, mut found: Vec<Found>, most: usize, each: usize) -> Vec<Found> {
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

/// A constant moved by a part of its step: places by a tenth of the range, sizes by a ratio.
fn moved(own: &Factor, constant: usize, part: f64, (low, high): (f64, f64)) -> f64 {
    let here = own.constants[constant];
    match own.shape {
        _ if constant == 0 && own.shape.is_placed() => here + 0.2 * part * (high - low),
        Shape::Exponent => here + 0.5 * part,
        // A period is sharper than any width.
        Shape::Wave | Shape::Arch | Shape::Ringing if constant == 0 => {
            let turns = (high - low) / here;
            here * (0.25 * part / turns.max(0.5)).exp()
        }
        _ => here * part.exp(),
    }
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
