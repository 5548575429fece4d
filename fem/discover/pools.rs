//! The pools of candidates: every shape of every variable, every product and every sum of two, two shapes of one variable that
//! a further one sizes, products of three grown from the best.

use std::mem::discriminant;

use rayon::prelude::*;

use super::form::{Form, Metric, Shapes};
use super::search::{Bench, Found, MOST_FUNCTIONS, Term};
use super::shape::Shape;
use super::variable::{Factor, product};
use crate::progress::Progress;

/// Terms of each pool that are refined, and pairs from which triples are grown.
const REFINED: usize = 20;
const GROWN: usize = 8;

impl Bench<'_, '_> {
    /// Candidates of every pool beside a law with so many amplitudes, unrefined.
    pub fn pools(
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
}
