//! Laws that are in no catalogue: what a model leaves is held against products and sums of shapes of every coordinate,
//! every recorded column and the prediction, and the law that is found is written as a formula that a model takes.

mod apart;
mod candidates;
mod diagnosis;
mod fitted;
mod form;
mod law;
mod left_out;
mod levels;
mod likeness;
mod pools;
mod refine;
mod scales;
mod search;
mod shape;
mod variable;
mod wandering;

pub use candidates::{Candidate, Tried, read_candidates};
pub use diagnosis::{diagnose, diagnose_with};
pub use fitted::{Law, Ranked};
pub use law::Written;
pub use left_out::LeftOut;
pub use levels::TooFew;
pub use wandering::Wandering;

use crate::compare::Judges;
use crate::diagnose::{ProjectedResidual, SIGNIFICANCE, thinned_to, under_noise, under_stated_noise, unsolvable};
use crate::fit::Objective;
use crate::model::Data;
use crate::noise::{Term, beyond_chi2};
use crate::process::Failure;
use crate::progress::Progress;
use crate::units::Kind;
use form::{Metric, Shapes};
use levels::{LEAST_NUMBERS, Settings, has_levels};
use rayon::prelude::*;
use search::{Bench, Found, kind};
use variable::{Factor, Variable};

/// Most terms of one law.
const MOST_TERMS: usize = 4;
/// Rows for each number of a law: with more it follows a curve, and is no law (Harrell, Regression modeling strategies, 2015, 4.4,
/// asks for 10 to 20).
const ROWS_EACH: usize = 8;
/// Most numbers of one law: two laws of physics have as many, and what asks for more follows a curve, on however many rows.
const MOST_NUMBERS: usize = 12;
/// Fall of the criterion from which a term is worth its price.
const WORTH: f64 = 10.0;
/// Laws that are grown further, and laws of which is seen what they leave beside the model's own values.
const GROWN: usize = 3;
const DRAFTED: usize = 12;
/// Most laws that settle beside the values of the model.
const SETTLED: usize = 5;
/// Standard uncertainties by which two laws differ somewhere, if they are two.
const DIFFERENT: f64 = 1.0;
/// Rise of the criterion up to which it is seen how the constants of a law settle beside the values of the model.
const NEAR: f64 = 40.0;
/// Rise of the criterion up to which a law is a rival of the best.
pub const RIVAL: f64 = 6.0;
/// Rise of the criterion up to which two laws are as good as equal.
const EQUAL: f64 = 2.0;
/// Rise of the criterion, after a few steps of a fit, up to which a law may turn out to be a rival.
const PERHAPS: f64 = 9.0;
/// Fall of −2 ln L, beyond its price, from which a law is told in the place of effects of the measurement.
const CLEARLY: f64 = 6.0;
/// Name of that step, for the note that it was left undone.
const INSTEAD: &str = "effects of the measurement in the place of a law";
/// Most rows that are searched.
const MOST_ROWS: usize = 500;

/// What was found; its laws as they were ranked, or fitted.
pub struct Discovery<L = Law> {
    /// χ² over the degrees of freedom before.
    pub before: f64,
    /// What these rows can tell of a model.
    pub judges: Judges,
    /// Whether nothing is left that a law could explain.
    pub is_nothing_left: bool,
    /// The laws, the best first: it, and its rivals.
    pub laws: Vec<L>,
    /// What the laws came to that somebody has in mind.
    pub tried: Vec<Tried>,
    /// Effects of the measurement that say as much as the best of them, where they do: it is held back then.
    pub instead: Vec<Term>,
    /// By how much the criterion of the best is below that of the effects of the measurement, where there are some.
    pub ahead: f64,
    /// The criterion of the best under the noise that the rows ask for beside it, where they ask for some.
    weighed: Option<f64>,
    /// A zero that wanders while rows are taken, where it says more than any law of the search.
    pub wandering: Option<Wandering>,
    /// Settings that are too few for the best of them, where they are: it is held back then.
    pub too_few: Option<TooFew>,
    /// What the best says of rows that were left out.
    pub left_out: Option<LeftOut>,
    /// The effect of the catalogue, of whatever process, that has the form of the best.
    pub like: Option<&'static str>,
    /// Names of the variables over which laws were sought.
    pub sought: Vec<String>,
    /// Ranges of the variables of the best, SI: beyond them nothing is known of it.
    pub ranges: Vec<(String, Kind, [f64; 2])>,
}

impl<L> Discovery<L> {
    /// Whether the rows tell what becomes of the model: a law, or that there is none and none is asked for.
    pub fn is_judged(&self) -> bool {
        match self.judges {
            Judges::Nothing => false,
            Judges::Wrong => self.told().is_some(),
            Judges::Both => true,
        }
    }

    /// The best law, where it is not held back.
    pub fn told(&self) -> Option<&L> {
        let foresees = self.left_out.is_none_or(|own| own.after < own.before);
        self.laws.first().filter(|_| foresees && self.instead.is_empty() && self.too_few.is_none())
    }
}

/// Searches for laws in what a model leaves, and fits the best and its rivals; laws that somebody has in mind are among those
/// that are tried.
///
/// # Errors
/// The model cannot be computed.
pub fn discover(data: &Data, candidates: &[Candidate], progress: &Progress) -> Result<Discovery, Failure> {
    let found = ranked(data, candidates, None, progress)?;
    let laws = progress.stretch("fits of laws", || {
        let mut all: Vec<Law> = Vec::new();
        for law in found.laws {
            if all.is_empty() || progress.permits("rivals of the law") {
                all.extend(fitted::fitted(data, law));
            }
        }
        all
    });
    Ok(Discovery {
        laws,
        before: found.before,
        judges: found.judges,
        is_nothing_left: found.is_nothing_left,
        tried: found.tried,
        instead: found.instead,
        ahead: found.ahead,
        weighed: found.weighed,
        wandering: found.wandering,
        too_few: found.too_few,
        left_out: found.left_out,
        like: found.like,
        sought: found.sought,
        ranges: found.ranges,
    })
}

/// Known effects that explain the rows.
#[derive(Clone, Copy)]
struct Explained {
    /// Their criterion.
    criterion: f64,
    /// Most terms of a law for which they are doubted.
    terms: usize,
}

/// Searches for laws in what a model leaves: the best, and its rivals. Where known effects explain the rows, laws are of
/// interest only that come near them; where the noise is not known nothing can be said of that.
fn ranked(
    data: &Data,
    candidates: &[Candidate],
    explained: Option<Explained>,
    progress: &Progress,
) -> Result<Discovery<Ranked>, Failure> {
    rayon::scope(|_| rank(data, candidates, explained, progress))
}

fn rank(
    whole: &Data,
    candidates: &[Candidate],
    explained: Option<Explained>,
    progress: &Progress,
) -> Result<Discovery<Ranked>, Failure> {
    let some = thinned_to(whole, MOST_ROWS);
    let data = some.as_ref().unwrap_or(whole);
    let (mut objective, solution) = under_stated_noise(data)?;
    let projected = ProjectedResidual::new(&mut objective, &solution).ok_or_else(unsolvable)?;
    let (chi2, freedom) = (projected.residual.norm_squared(), projected.freedom);
    let mut discovery = Discovery {
        before: chi2 / freedom,
        judges: Judges::of(data, &data.residuals(&solution.predicted), &objective.noise, data.repeats()),
        is_nothing_left: beyond_chi2(freedom, chi2).is_some_and(|p| p >= SIGNIFICANCE),
        laws: Vec::new(),
        tried: Vec::new(),
        instead: Vec::new(),
        ahead: f64::INFINITY,
        weighed: None,
        wandering: None,
        too_few: None,
        left_out: None,
        like: None,
        sought: Vec::new(),
        ranges: Vec::new(),
    };
    let noise = &objective.noise;
    if discovery.judges == Judges::Nothing
        || discovery.is_nothing_left
        || explained.is_some() && !noise.source.is_known()
    {
        return Ok(discovery);
    }
    let most = explained.map_or(f64::INFINITY, |own| own.criterion - noise.log_determinant() + CLEARLY);
    let variables = Variable::all(data, &solution.predicted);
    discovery.sought = variables.iter().map(|own| own.name.to_string()).collect();
    let mut bench = Bench { most, ..bench(data, &objective, &projected, &variables) };
    let wandering = Wandering::of(&bench, data.rows.observable.iter().copied());
    let mut laws = progress.stretch("search for laws", || grown(&bench, wandering.as_ref(), progress));
    let were_some = !laws.is_empty();
    laws.retain(|own| wandering.is_none_or(|other| !other.says_more_than(own, &bench)));
    discovery.wandering = wandering.filter(|_| were_some && laws.is_empty());
    let least = laws.first().map_or(f64::INFINITY, |best| best.criterion);
    let is_plain = |own: &Found| explained.is_none_or(|known| own.terms.len() <= known.terms);
    let is_near = |own: &Found| is_plain(own) && own.criterion < (least + NEAR).min(most);
    let near: Vec<Found> = laws.into_iter().filter(is_near).take(DRAFTED).collect();
    discovery.laws = progress.stretch("laws beside the values of the model", || {
        let draft = |found: &Found| fitted::drafted((&objective, &solution), &bench, found);
        let mut drafts: Vec<Ranked> = near.par_iter().filter_map(draft).collect();
        drafts.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        let Some((least, misfit)) = drafts.first().map(|best| (best.criterion, best.misfit())) else { return drafts };
        drafts.retain(|own| own.criterion < least + PERHAPS || own.misfit() < misfit + PERHAPS);
        drafts.truncate(SETTLED);
        let settle = |draft| fitted::settled((&objective, &solution), &bench, draft);
        let mut laws: Vec<Ranked> = drafts.into_par_iter().filter_map(settle).collect();
        laws.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        laws
    });
    // A law that somebody has in mind is a variable of its own, once its constants are found.
    let mut with_own = variables.clone();
    for candidate in candidates {
        let of = (candidate, candidates.len());
        let result = match candidates::ranked((&objective, &solution), &bench, of, with_own.len()) {
            Ok((law, variable)) => {
                let left = bench.residual.norm_squared() - law.found.gain;
                let numbers = law.found.freedom;
                with_own.push(variable);
                bench.factors.push(law.found.terms[0].factors.clone());
                discovery.laws.extend((law.criterion < most).then_some(law));
                Ok(left / (bench.freedom - numbers as f64).max(1.0))
            }
            Err(why) => Err(why),
        };
        discovery.tried.push(Tried { name: candidate.name.clone(), result });
    }
    let bench = Bench { variables: &with_own, ..bench };
    discovery.laws.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    if !discovery.laws.is_empty() && progress.permits(INSTEAD) {
        progress.stretch(INSTEAD, || discovery.weigh_against_noise(data, progress))?;
    }
    discovery.judge(&bench);
    Ok(discovery)
}

impl Discovery<Ranked> {
    /// Weighs the best law against the effects of the measurement that the rows ask for without it: what a law of many shapes
    /// makes of a few zeros is no law. Laws on the edge of where the model can be computed are left out.
    fn weigh_against_noise(&mut self, data: &Data, progress: &Progress) -> Result<(), Failure> {
        let without = under_noise(data, progress)?;
        while let Some(law) = self.laws.first().filter(|_| !without.terms.is_empty()) {
            let with = data.beside(&law.open);
            if let Some(with) = with.ok().and_then(|with| under_noise(&with, progress).ok()) {
                let weighed = with.criterion + law.found.price;
                (self.ahead, self.weighed) = (without.criterion - weighed, Some(weighed));
                if self.ahead < CLEARLY {
                    self.instead = without.terms;
                }
                break;
            }
            self.laws.remove(0);
        }
        Ok(())
    }

    /// Of laws that are as good as equal the one stands first whose shapes are plain.
    fn put_plain_first(&mut self) {
        let Some(least) = self.laws.first().map(|best| best.criterion) else { return };
        let curved = |law: &Ranked| {
            law.found.terms.iter().flat_map(|term| &term.factors).filter(|own| !own.shape.is_plain()).count()
        };
        let equal = self.laws.iter().take_while(|law| law.criterion < least + EQUAL);
        if let Some((plainest, _)) = equal.enumerate().min_by_key(|(_, law)| curved(law)) {
            self.laws[..=plainest].rotate_right(1);
        }
    }

    /// Keeps the best law and its rivals, and says of them what speaks for and against them.
    fn judge(&mut self, bench: &Bench) {
        self.put_plain_first();
        let Some(best) = self.laws.first() else { return };
        let (least, misfit, told) = (best.criterion, best.misfit(), best.found.clone());
        // What fits as well is a rival, at whatever price: further out it may say something else. What has something more
        // beside the best is none.
        let is_near = |law: &Ranked| law.criterion < least + RIVAL || law.misfit() < misfit + RIVAL;
        let rivals: Vec<Ranked> =
            self.laws.drain(1..).filter(|law| is_near(law) && !law.found.is_more_than(&told)).collect();
        for mut rival in rivals {
            rival.apart = apart::apart(bench, &told, &rival.found);
            // Nor what is the same everywhere.
            let is_other = match &rival.apart {
                Some(own) => own.sigmas > DIFFERENT,
                None => !bench.is_within(&told, &rival.found, DIFFERENT),
            };
            if is_other {
                self.laws.push(rival);
            }
        }
        self.ranges = ranges(bench, &told);
        self.like = likeness::like(bench, &told);
        let settings = Settings::of(bench, &told);
        self.too_few = levels::too_few(bench, &told, &settings);
        self.left_out = left_out::left_out(bench, &told, &settings);
    }
}

/// Ranges of the variables of a law, words left out.
fn ranges(bench: &Bench, law: &Found) -> Vec<(String, Kind, [f64; 2])> {
    let own = bench.variables_of(law).into_iter().map(|v| &bench.variables[v]).filter(|own| own.words == 0);
    own.map(|own| (own.name.to_string(), own.kind, own.ends().into())).collect()
}

fn bench<'a, 'm>(
    data: &Data,
    objective: &'a Objective<'m>,
    projected: &'a ProjectedResidual,
    variables: &'a [Variable],
) -> Bench<'a, 'm> {
    let of = |(i, own): (usize, &Variable)| own.factors(i, &scales::scales(data.model, own.kind));
    let factors: Vec<Vec<Factor>> = variables.iter().enumerate().map(of).collect();
    let all = |at: &dyn Fn(&Factor) -> Vec<Vec<f64>>| -> Vec<Shapes> {
        factors.iter().map(|own| Shapes::new(&own.iter().map(at).collect::<Vec<_>>())).collect()
    };
    let two = (0..variables.len()).flat_map(|i| (0..variables.len()).map(move |j| (i, j))).filter(|(i, j)| i != j);
    Bench {
        metrics: data
            .observables
            .iter()
            .map(|own| (own.position, Metric::new(objective, projected, own.position)))
            .collect(),
        residual: &projected.residual,
        tangent: projected.tangent(),
        freedom: projected.freedom,
        rows: data.len(),
        variables,
        at_levels: all(&|own| own.at_levels(variables)),
        at_some: all(&|own| own.at_some(variables)),
        factors,
        most: f64::INFINITY,
        excesses: two.flat_map(|(i, j)| variables[i].excesses(i, (j, &variables[j]))).collect(),
    }
}

/// Laws of one term and more, each grown from the best with a term less, the best first. What cannot say more than a zero that
/// wanders is not grown.
fn grown(bench: &Bench, wandering: Option<&Wandering>, progress: &Progress) -> Vec<Found> {
    let mut all: Vec<Found> = Vec::new();
    let mut open = vec![bench.judged(Vec::new())];
    let most_numbers = (bench.rows / ROWS_EACH).clamp(LEAST_NUMBERS, MOST_NUMBERS);
    while !open.is_empty() {
        let mut next: Vec<Found> = Vec::new();
        for law in open {
            if !all.is_empty() && !progress.permits("a further term of a law") {
                break;
            }
            let further = bench.further(&law, progress);
            let is_worth = |own: &Found| own.criterion < law.criterion - WORTH;
            let is_law = |own: &Found| own.freedom <= most_numbers && has_levels(bench, own) && is_worth(own);
            next.extend(further.into_iter().filter(is_law));
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
        open.retain(|own| bench.most.is_infinite() && bench.least_of_further(own) < least + RIVAL);
        open.retain(|own| wandering.is_none_or(|other| !other.says_more_than_any_of(own, bench)));
    }
    all.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    all
}
