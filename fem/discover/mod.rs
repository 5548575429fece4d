//! Laws that are in no catalogue: what a model leaves is held against products and sums of shapes of every coordinate,
//! every recorded column and the prediction, and the law that is found is written as a formula that a model takes.

mod fitted;
mod form;
mod law;
mod levels;
mod scales;
mod search;
mod shape;
mod variable;

pub use fitted::Law;
pub use law::Written;
pub use levels::TooFew;

use crate::diagnose::{ProjectedResidual, SIGNIFICANCE, under_noise};
use crate::fit::{self, Objective, StoppingCriterion};
use crate::model::Data;
use crate::noise::{Noise, Term, beyond_chi2};
use crate::process::Failure;
use crate::progress::Progress;
use form::Metric;
use rayon::prelude::*;
use search::{AtLevels, Bench, Found, kind};
use variable::{Factor, Variable};

/// Most terms of one law.
const MOST_TERMS: usize = 4;
/// Fall of the criterion from which a term is worth its price.
const WORTH: f64 = 10.0;
/// Laws that are grown further, and laws that are fitted.
const GROWN: usize = 3;
const FITTED: usize = 6;
/// Rise of the criterion up to which a law is fitted: its constants settle beside those of the model.
const NEAR: f64 = 40.0;
/// Rise of the criterion up to which a law is a rival of the best.
pub const RIVAL: f64 = 6.0;
/// Fall of −2 ln L, beyond its price, from which a law is told in the place of effects of the measurement.
const CLEARLY: f64 = 6.0;
/// Most rows that are searched.
const MOST_ROWS: usize = 500;

/// What was found.
pub struct Discovery {
    /// χ² over the degrees of freedom before.
    pub before: f64,
    /// Whether nothing is left that a law could explain.
    pub is_nothing_left: bool,
    /// The laws, the best first: it, and its rivals.
    pub laws: Vec<Law>,
    /// Effects of the measurement that say as much as the best of them, where they do: it is held back then.
    pub instead: Vec<Term>,
    /// Settings that are too few for the best of them, where they are: it is held back then.
    pub too_few: Option<TooFew>,
}

impl Discovery {
    /// The best law, where it is not held back.
    pub fn told(&self) -> Option<&Law> {
        self.laws.first().filter(|_| self.instead.is_empty() && self.too_few.is_none())
    }
}

/// Searches for laws in what a model leaves.
///
/// # Errors
/// The model cannot be computed.
pub fn discover(data: &Data, progress: &Progress) -> Result<Discovery, Failure> {
    rayon::scope(|_| discover_all(data, progress))
}

fn discover_all(whole: &Data, progress: &Progress) -> Result<Discovery, Failure> {
    let some = thinned(whole);
    let data = some.as_ref().unwrap_or(whole);
    let unsolvable = || Failure {
        message: "the model cannot be computed beside its best values".into(),
        help: "run it first: fem run".into(),
    };
    let repeats = data.repeats();
    let mut objective = Objective::new(data)?;
    let mut solution = fit::best(&mut objective)?;
    let residuals = data.residuals(&solution.predicted);
    let mean = objective.mean(&solution).ok_or_else(unsolvable)?;
    objective.noise = Noise::stated(&data.terms, data, repeats, &residuals, &mean).0;
    let full = StoppingCriterion::FULL;
    solution = fit::minimise(&mut objective, &solution.position, &[], full).ok_or_else(unsolvable)?;
    let projected = ProjectedResidual::new(&mut objective, &solution).ok_or_else(unsolvable)?;
    let (chi2, freedom) = (projected.residual.norm_squared(), projected.freedom);
    let before = chi2 / freedom;
    let is_nothing_left = beyond_chi2(freedom, chi2).is_some_and(|p| p >= SIGNIFICANCE);
    let mut discovery = Discovery { before, is_nothing_left, laws: Vec::new(), instead: Vec::new(), too_few: None };
    if is_nothing_left {
        return Ok(discovery);
    }
    let variables = Variable::all(data, &solution.predicted);
    let bench = bench(data, &objective, &projected, &variables);
    let laws = progress.stretch("search for laws", || grown(&bench, progress));
    let Some(least) = laws.first().map(|best| best.criterion) else { return Ok(discovery) };
    let near = laws.into_iter().filter(|own| own.criterion < least + NEAR).take(FITTED);
    progress.stretch("fits of laws", || {
        for found in near {
            if discovery.laws.is_empty() || progress.permits("rivals of the law") {
                discovery.laws.extend(fitted::fitted(whole, &bench, &found));
            }
        }
    });
    discovery.laws.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    let least = discovery.laws.first().map_or(0.0, |best| best.criterion);
    discovery.laws.retain(|law| law.criterion < least + RIVAL);
    discovery.too_few = discovery.laws.first().and_then(|best| levels::too_few(&bench, &best.found));
    if let Some(best) = discovery.told().filter(|_| progress.permits("effects of the measurement instead")) {
        discovery.instead = progress.stretch("effects of the measurement instead", || instead(data, best, progress))?;
    }
    Ok(discovery)
}

/// Effects of the measurement that say as much as a law, at its price: what a law of many shapes makes of a few zeros is
/// no law.
fn instead(data: &Data, law: &Law, progress: &Progress) -> Result<Vec<Term>, Failure> {
    let without = under_noise(data, progress)?;
    let with = Data::of(&law.open, data.clone().into_measurements())
        .map_err(|e| Failure { message: e.to_string(), help: "discover without it".into() })?;
    let with = under_noise(&with, progress)?;
    let is_instead = !without.terms.is_empty() && without.criterion < with.criterion + law.price + CLEARLY;
    Ok(if is_instead { without.terms } else { Vec::new() })
}

/// The rows that are searched, where they are too many to search all.
fn thinned<'m>(data: &Data<'m>) -> Option<Data<'m>> {
    let every = data.len().div_ceil(MOST_ROWS);
    (every > 1).then(|| {
        let keep = data.one_in(every, data.repeats());
        data.some(|row| keep[row])
    })
}

fn bench<'a, 'm>(
    data: &Data,
    objective: &'a Objective<'m>,
    projected: &'a ProjectedResidual,
    variables: &'a [Variable],
) -> Bench<'a, 'm> {
    let of = |(i, own): (usize, &Variable)| own.factors(i, &scales::scales(data.model, own.kind));
    let factors: Vec<Vec<Factor>> = variables.iter().enumerate().map(of).collect();
    let all = |at: &(dyn Fn(&Factor) -> AtLevels + Sync)| -> Vec<Vec<AtLevels>> {
        factors.iter().map(|own| own.par_iter().map(at).collect()).collect()
    };
    let two = (0..variables.len()).flat_map(|i| (0..variables.len()).map(move |j| (i, j))).filter(|(i, j)| i != j);
    Bench {
        metrics: data
            .observables
            .iter()
            .map(|own| (own.position, Metric::new(objective, projected, own.position)))
            .collect(),
        residual: &projected.residual,
        freedom: projected.freedom,
        rows: data.len(),
        variables,
        at_levels: all(&|own| own.at_levels(variables)),
        at_some: all(&|own| own.at_some(variables)),
        factors,
        excesses: two.flat_map(|(i, j)| variables[i].excesses(i, (j, &variables[j]))).collect(),
    }
}

/// Laws of one term and more, each grown from the best with a term less, the best first.
fn grown(bench: &Bench, progress: &Progress) -> Vec<Found> {
    let none = bench.judged(Vec::new());
    let mut all: Vec<Found> = Vec::new();
    let mut open = vec![none.clone()];
    while !open.is_empty() {
        let mut next: Vec<Found> = Vec::new();
        for law in open {
            if !all.is_empty() && !progress.permits("a further term of a law") {
                break;
            }
            let further = bench.further(&law, progress);
            next.extend(further.into_iter().filter(|own| own.criterion < law.criterion - WORTH));
        }
        next.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        let mut kinds = Vec::new();
        next.retain(|own| {
            let kind = kind(&own.terms);
            let is_new = !kinds.contains(&kind) && all.iter().all(|other| self::kind(&other.terms) != kind);
            kinds.push(kind);
            is_new
        });
        open = next.iter().filter(|own| own.terms.len() < MOST_TERMS).take(GROWN).cloned().collect();
        all.extend(next);
        // What leaves no more than noise is not grown: a term more explains chance.
        open.retain(|own| bench.residual.norm_squared() - own.gain > bench.freedom);
        let least = all.iter().map(|own| own.criterion).fold(f64::INFINITY, f64::min);
        open.retain(|own| bench.least_of_further(own) < least + RIVAL);
    }
    all.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    all
}
