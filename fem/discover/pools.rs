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
/// Partners that a shape keeps of each variable: in products, and in sums.
const PARTNERS: (usize, usize) = (3, 2);

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
        let usable = (0..self.variables.len()).filter(|v| self.variables[*v].is_of(&metric.rows)).collect();
        let pools = Pools { bench: self, law, amplitudes, observable, rows: &metric.rows, form, usable };
        let (mut all, excesses) = pools.singles();
        if !progress.permits("products of two variables") {
            return all;
        }
        let (products, sums) = pools.pairs();
        all.extend(sums);
        all.extend(products.iter().cloned());
        all.extend(pools.common());
        if progress.permits("products of three variables") {
            all.extend(pools.triples(products, &excesses));
        }
        all
    }
}

/// What terms with some factors explain, and their number.
type Gain = (f64, usize);

/// The search for one more term, or two, of an observable.
struct Pools<'p, 'a, 'm> {
    bench: &'p Bench<'a, 'm>,
    /// The law that is grown, and the number of its amplitudes.
    law: &'p Found,
    amplitudes: usize,
    observable: usize,
    /// Rows of the observable.
    rows: &'p [usize],
    form: &'p Form,
    /// Variables that all of these rows have.
    usable: Vec<usize>,
}

impl Pools<'_, '_, '_> {
    /// The law with terms of these factors.
    fn further(&self, factors: Vec<Vec<Factor>>, (gain, count): Gain) -> Found {
        let whole = self.bench.residual.norm_squared() - self.form.chi2;
        let own = factors.into_iter().map(|factors| Term { observable: self.observable, factors });
        let terms = self.law.terms.iter().cloned().chain(own).collect();
        self.bench.priced(terms, (whole + gain, self.amplitudes + count))
    }

    fn ones(&self) -> Vec<Vec<f64>> {
        vec![vec![1.0; self.bench.rows]]
    }

    /// A few values of a variable in the place of all: which of them each row is near, and their number.
    fn some(&self, v: usize) -> (&[usize], usize) {
        let (values, level) = &self.bench.variables[v].coarse;
        (level, values.len())
    }

    /// The functions of a shape of a variable in every row.
    fn spread(&self, v: usize, shape: usize) -> Vec<Vec<f64>> {
        self.bench.at_levels[v].spread(shape, &self.bench.variables[v].level)
    }

    /// Shapes of one variable, and the best of what one variable is beyond a part of another.
    fn singles(&self) -> (Vec<Found>, Vec<Found>) {
        let bench = self.bench;
        let mut singles = Vec::new();
        for v in &self.usable {
            let own = &bench.variables[*v];
            let products = self.form.sums(self.rows, &self.ones(), (&own.level, own.levels.len()));
            let products = products.products(&bench.at_levels[*v]);
            let one = |i: usize| self.further(vec![vec![bench.factors[*v][i].clone()]], products.gain(i));
            singles.extend((0..bench.factors[*v].len()).into_par_iter().map(one).collect::<Vec<_>>());
        }
        let (nowhere, one) = (vec![0; bench.rows], Shapes::new(&[vec![vec![1.0]]]));
        let of_excess = |own: &&Factor| {
            let sums = self.form.sums(self.rows, &own.columns(bench.variables), (&nowhere, 1));
            self.further(vec![vec![(*own).clone()]], sums.products(&one).gain(0))
        };
        let usable: Vec<&Factor> = bench.excesses.iter().filter(|own| self.usable.contains(&own.variable)).collect();
        let excesses: Vec<Found> = usable.par_iter().map(of_excess).collect();
        singles.extend(excesses.iter().cloned());
        (bench.best_of_kinds(singles, REFINED, 2), bench.best_of_kinds(excesses, GROWN / 2, 1))
    }

    /// Products, and sums, of shapes of two variables.
    fn pairs(&self) -> (Vec<Found>, Vec<Found>) {
        let (mut products, mut sums) = (Vec::new(), Vec::new());
        for (k, a) in self.usable.iter().enumerate() {
            for b in &self.usable[k..] {
                let (one, other) = self.pair(*a, *b);
                products.extend(self.bench.best_of_kinds(one, REFINED, 2));
                sums.extend(self.bench.best_of_kinds(other, REFINED / 2, 1));
            }
        }
        (self.bench.best_of_kinds(products, REFINED, 2), self.bench.best_of_kinds(sums, REFINED / 2, 2))
    }

    /// Products and sums of every shape of one variable with the best of another.
    fn pair(&self, a: usize, b: usize) -> (Vec<Found>, Vec<Found>) {
        let bench = self.bench;
        let is_longer = bench.variables[a].levels.len() > bench.variables[b].levels.len();
        let (a, b) = if is_longer { (a, b) } else { (b, a) };
        let of_ones = self.form.sums(self.rows, &self.ones(), self.some(b)).products(&bench.at_some[b]);
        let with = |i: usize| {
            let own = &bench.factors[a][i];
            let sums = self.form.sums(self.rows, &self.spread(a, i), self.some(b));
            let (products, together) = (sums.products(&bench.at_some[b]), sums.together(&bench.at_some[b], &of_ones));
            // A variable may stand in a product with itself as the envelope of its wave.
            let is_product = |j: usize| {
                let other = &bench.factors[b][j];
                own.shape.functions() * other.shape.functions() <= MOST_FUNCTIONS
                    && (a != b || other.shape.is_envelope() && own.shape.is_wave())
            };
            let is_sum = |j: usize| a != b || i < j;
            let two = |j: usize| [bench.factors[b][j].clone(), own.clone()];
            let products = self.partners(b, PARTNERS.0, is_product, |j| products.gain(j));
            let products = products.into_iter().map(|(j, gain)| self.further(vec![two(j).to_vec()], gain));
            let sums = self.partners(b, PARTNERS.1, is_sum, |j| together.gain(j)).into_iter();
            let sums = sums.map(|(j, gain)| self.further(two(j).map(|one| vec![one]).to_vec(), gain));
            (products.collect::<Vec<_>>(), sums.collect::<Vec<_>>())
        };
        let own: Vec<_> = (0..bench.factors[a].len()).into_par_iter().map(with).collect();
        let (products, sums): (Vec<_>, Vec<_>) = own.into_iter().unzip();
        (products.concat(), sums.concat())
    }

    /// The few shapes of a variable, each unlike the others, that explain most in company: whole laws are made of these alone.
    fn partners(
        &self,
        v: usize,
        most: usize,
        is_wanted: impl Fn(usize) -> bool,
        gain: impl Fn(usize) -> Gain,
    ) -> Vec<(usize, Gain)> {
        let factors = &self.bench.factors[v];
        let cheap = |j: usize, (gain, count): Gain| {
            let numbers = (count + factors[j].sought()) as f64;
            self.bench.misfit((self.form.chi2 - gain).max(0.0)) + numbers * (self.bench.rows as f64).ln()
        };
        let all = (0..factors.len()).filter(|j| is_wanted(*j)).map(|j| (j, gain(j)));
        let mut all: Vec<(f64, usize, Gain)> = all.map(|(j, gain)| (cheap(j, gain), j, gain)).collect();
        all.sort_by(|x, y| x.0.total_cmp(&y.0));
        let (mut kinds, mut best) = (Vec::new(), Vec::new());
        for (_, j, gain) in all {
            let kind = discriminant(&factors[j].shape);
            if !kinds.contains(&kind) {
                kinds.push(kind);
                best.push((j, gain));
            }
            if best.len() == most {
                break;
            }
        }
        best
    }

    /// Two shapes of one variable that a further one switches or sizes together.
    fn common(&self) -> Vec<Found> {
        let bench = self.bench;
        let of = |v: usize, is_wanted: fn(Shape) -> bool| -> Vec<usize> {
            (0..bench.factors[v].len()).filter(|i| is_wanted(bench.factors[v][*i].shape)).collect()
        };
        let is_size = |own: Shape| matches!(own, Shape::Sign | Shape::Word | Shape::Proportional);
        let is_plain = |own: Shape| !own.is_wave() && own != Shape::Ringing;
        let own: Vec<usize> = self.usable.iter().copied().filter(|v| !bench.variables[*v].is_prediction).collect();
        let plain: Vec<(usize, Vec<usize>)> = own.iter().map(|b| (*b, of(*b, is_plain))).collect();
        let mut common = Vec::new();
        for (a, i) in own.iter().flat_map(|a| of(*a, is_size).into_iter().map(move |i| (*a, i))) {
            for (b, shapes) in plain.iter().filter(|(b, shapes)| *b != a && shapes.len() > 1) {
                let doubles = self.form.sums(self.rows, &self.spread(a, i), self.some(*b)).doubles(&bench.at_some[*b]);
                let with = |k: usize| {
                    let others = shapes[k + 1..].iter().map(|other| (*other, doubles.gain(shapes[k], *other)));
                    let (other, gain) = others.max_by(|x, y| x.1.0.total_cmp(&y.1.0).then(y.0.cmp(&x.0)))?;
                    let factors = |own: usize| vec![bench.factors[a][i].clone(), bench.factors[*b][own].clone()];
                    Some(self.further([shapes[k], other].map(factors).to_vec(), gain))
                };
                let own: Vec<Found> = (0..shapes.len()).into_par_iter().filter_map(with).collect();
                common.extend(bench.best_of_kinds(own, REFINED / 4, 1));
            }
        }
        bench.best_of_kinds(common, REFINED / 2, 1)
    }

    /// Products with a further variable, of the best of two, refined, and of excesses.
    fn triples(&self, products: Vec<Found>, excesses: &[Found]) -> Vec<Found> {
        let bench = self.bench;
        let refined: Vec<Found> = products.into_par_iter().map(|own| bench.refined(own)).collect();
        let refined = bench.best_of_kinds(refined, GROWN, 2);
        let mut grown = Vec::new();
        for term in refined.iter().chain(excesses).filter_map(|own| own.terms.last()) {
            let own = product(&term.factors.iter().map(|f| f.columns(bench.variables)).collect::<Vec<_>>());
            let is_in = |v: usize| term.factors.iter().any(|own| own.variable == v || own.other == Some(v));
            for v in self.usable.iter().copied().filter(|v| !bench.variables[*v].is_prediction && !is_in(*v)) {
                let products = self.form.sums(self.rows, &own, self.some(v)).products(&bench.at_some[v]);
                let with = |i: usize| {
                    let factor = &bench.factors[v][i];
                    (own.len() * factor.shape.functions() <= MOST_FUNCTIONS).then(|| {
                        let factors = term.factors.iter().cloned().chain([factor.clone()]).collect();
                        self.further(vec![factors], products.gain(i))
                    })
                };
                grown.extend((0..bench.factors[v].len()).into_par_iter().filter_map(with).collect::<Vec<_>>());
            }
        }
        bench.best_of_kinds(grown, REFINED, 2)
    }
}
