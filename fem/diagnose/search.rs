//! The search for what is missing: sets of effects, growing while the gain is more than chance gives.
//!
//! Adding the best effect, then the next best, picks wrong pairs where signatures are alike. So every size has several sets on trial, each
//! re-fitted with all parameters free; pairs are all looked at, and larger sets grow from the best of the smaller ones.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::DVector;
use rayon::prelude::*;

use super::gain::Gain;
use super::ground::Ground;
use super::pairs::{self, Pair};
use super::price::{Price, Yardstick};
use super::signature::{Candidate, Variant};
use super::trial::{self, Trial};
use crate::fit::{Axis, Objective, Patience, Solution, minimise};
use crate::progress::Progress;

/// A set grows when chance alone gives so much in fewer searches than this.
pub const SIGNIFICANCE: f64 = 0.01;
/// How many sets of one size are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breadth {
    /// Sets from which larger ones grow.
    beam: usize,
    /// Sets that are re-fitted.
    refitted: usize,
}

impl Breadth {
    /// Enough, as a rule.
    pub const USUAL: Self = Self { beam: 6, refitted: 12 };
    /// Where that left structure: strong effects that are far from linear hide behind others.
    pub const WIDE: Self = Self { beam: 20, refitted: 60 };
}

/// Starts of a re-fit: the best shapes of an effect, each of another neighbourhood.
const STARTS: usize = 2;
/// Rounds in which an effect of a set is exchanged, at most.
const EXCHANGES: usize = 4;
/// How often a start that cannot be computed is brought nearer.
const HALVINGS: usize = 5;
/// χ² of the priors above which a re-fit also starts from what is written.
const BENT: f64 = 9.0;
/// Far enough to tell sets apart; the last one is fitted to the bottom.
const SEARCHING: Patience = Patience { steps: 25, fall: 1e-5 };

/// What the search found.
pub struct Found<'a> {
    /// The model without any of them.
    pub base: Trial<'a>,
    /// What was looked for.
    pub candidates: Vec<Candidate>,
    /// How many together, at most.
    pub most: usize,
    /// The best set of each size, as long as the gain was significant.
    pub steps: Vec<Trial<'a>>,
    /// Each candidate alone, where it can be computed.
    pub singles: Vec<Option<Trial<'a>>>,
    /// Everything that was fitted.
    pub tried: Vec<Trial<'a>>,
    /// What the first effect gains by chance.
    pub first_price: Price,
    /// What one effect more gains by chance, on the last set.
    pub price: Price,
}

impl<'a> Found<'a> {
    /// The best set: the model itself where nothing was found.
    pub fn best(&self) -> &Trial<'a> {
        self.steps.last().unwrap_or(&self.base)
    }
}

/// A set that is worth fitting.
struct Lead<'t, 'a> {
    parent: &'t Trial<'a>,
    added: usize,
    /// Variants of the added effect, with the gain that each promises.
    starts: Vec<(usize, Gain)>,
    /// Where the shapes of a pair that promise most together begin.
    together: Option<Start>,
    /// χ² that the best of them promises.
    promised: f64,
}

/// Where a re-fit begins.
#[derive(Clone)]
struct Start {
    position: DVector<f64>,
    /// Search variables that switch what was added, with their neutral values.
    switches: Vec<(usize, f64)>,
}

impl Start {
    /// What `values` say of the model's own, and then nothing yet.
    fn own(values: &DVector<f64>) -> Self {
        Self { position: values.clone(), switches: Vec::new() }
    }

    /// With one effect more, whose variables come next among `axes`.
    fn with(mut self, variant: &Variant, amplitudes: &[f64], axes: &[Axis]) -> Self {
        let first = self.position.len();
        let own = variant.position(amplitudes, &axes[first..]);
        self.switches.extend(variant.switches.iter().map(|s| (first + s.parameter, variant.position[s.parameter])));
        self.position = DVector::from_iterator(first + own.len(), self.position.iter().copied().chain(own));
        self
    }
}

/// Searches sets of up to `most` effects. `None` where the model cannot be computed beside its own best values.
pub fn search<'a>(
    base: Trial<'a>,
    candidates: Vec<Candidate>,
    yardstick: Yardstick,
    (most, breadth): (usize, Breadth),
    progress: &Progress,
) -> Option<Found<'a>> {
    let everyone: Vec<&Candidate> = candidates.iter().collect();
    let ground = Ground::new(&mut base.objective.clone(), &base.solution)?;
    let first_price = Price::simulate(&ground, &everyone, yardstick);
    let mut price = first_price.clone();
    // In an order of its own, so that the same data always give the same answer.
    let mut tried: BTreeMap<Vec<usize>, Trial<'a>> = BTreeMap::new();
    let mut beam = vec![base.clone()];
    let mut steps: Vec<Trial<'a>> = Vec::new();
    let mut singles = Vec::new();
    progress.expect(most as u64);
    for size in 1..=most.max(1) {
        let mut leads: Vec<Lead> = beam.par_iter().flat_map_iter(|parent| leads(parent, &candidates)).collect();
        if size == 2 {
            let pairs = pairs::pairs(&ground, &everyone);
            for lead in &mut leads {
                lead.look_at(&pairs, &base, ground.residual.norm_squared(), &candidates);
            }
        }
        leads.sort_by(|a, b| a.promised.total_cmp(&b.promised));
        let mut seen = BTreeSet::new();
        leads.retain(|lead| {
            let mut members = lead.parent.members.clone();
            members.push(lead.added);
            seen.insert(trial::key(&members))
        });
        leads.truncate(if size == 1 { usize::MAX } else { breadth.refitted });
        let fitted: Vec<Trial<'a>> = leads.par_iter().filter_map(|lead| refit(lead, &candidates)).collect();
        drop(leads);
        if size == 1 {
            let of = |i: usize| fitted.iter().find(|t| t.members == [i]).cloned();
            singles = (0..candidates.len()).map(of).collect();
        }
        beam = fitted.clone();
        beam.sort_by(|a, b| a.score().total_cmp(&b.score()));
        tried.extend(beam.iter().map(|t| (t.key(), t.clone())));
        let Some(mut best) = beam.first().cloned() else { break };
        if size > 1 {
            beam.truncate(breadth.beam);
            best = exchange(&base, &candidates, best, breadth);
            tried.insert(best.key(), best.clone());
            beam.insert(0, best.clone());
            beam.dedup_by_key(|t| t.key());
        }
        let before = steps.last().unwrap_or(&base);
        if !grows(before, &fitted, &best, &price, yardstick, candidates.len()) {
            break;
        }
        steps.push(best.clone());
        progress.advance(1);
        let Some(ground) = Ground::new(&mut best.objective.clone(), &best.solution) else { break };
        let others = candidates.iter().enumerate().filter(|(i, _)| !best.members.contains(i)).map(|(_, c)| c);
        price = Price::simulate(&ground, &others.collect::<Vec<_>>(), yardstick);
    }
    progress.advance((most.max(1) - steps.len()) as u64);
    prune(&base, &candidates, &mut steps, &price, yardstick);
    Some(Found { base, candidates, most, steps, singles, tried: tried.into_values().collect(), first_price, price })
}

/// Leaves out what the best set does not need: what was found before others took its place.
fn prune<'a>(base: &Trial<'a>, candidates: &[Candidate], steps: &mut [Trial<'a>], price: &Price, yardstick: Yardstick) {
    let Some(best) = steps.last_mut() else { return };
    while best.members.len() > 1 {
        let smaller = best.members.iter().filter_map(|m| without(base, candidates, best, *m));
        let Some(least) = smaller.min_by(|a, b| a.solution.chi2.total_cmp(&b.solution.chi2)) else { return };
        let gained = least.solution.chi2 - best.solution.chi2;
        let p_value = price.p_value(yardstick.measure(gained, best.solution.chi2, best.objective.freedom()));
        if p_value < SIGNIFICANCE && best.score() < least.score() {
            return;
        }
        *best = least;
    }
}

/// Whether a larger set is needed: adding one effect to the set gains more than chance gives to a search as wide, or another set gains so much that
/// chance would not give it to any of as many; and the gain is worth the parameters.
fn grows(
    before: &Trial,
    fitted: &[Trial],
    best: &Trial,
    price: &Price,
    yardstick: Yardstick,
    candidates: usize,
) -> bool {
    let p_value = |larger: &Trial| {
        let gained = before.solution.chi2 - larger.solution.chi2;
        price.p_value(yardstick.measure(gained, larger.solution.chi2, larger.objective.freedom()))
    };
    let nested = fitted.iter().filter(|t| before.members.iter().all(|m| t.members.contains(m)));
    let p_nested = nested.map(p_value).fold(1.0, f64::min);
    let sets = (0..best.members.len()).map(|i| (candidates - i) as f64 / (i + 1) as f64).product::<f64>();
    let p_other = p_value(best) * sets / (candidates - before.members.len()).max(1) as f64;
    p_nested.min(p_other) < SIGNIFICANCE && best.score() < before.score()
}

/// Every effect that could be added to a set, with its most promising shapes.
fn leads<'t, 'a>(parent: &'t Trial<'a>, candidates: &[Candidate]) -> Vec<Lead<'t, 'a>> {
    let Some(ground) = Ground::new(&mut parent.objective.clone(), &parent.solution) else { return Vec::new() };
    let lead = |added: usize| {
        let starts = starts(&ground, &candidates[added]);
        let fall = starts.first().map_or(0.0, |s| s.1.fall);
        Lead { parent, added, starts, together: None, promised: parent.solution.chi2 - fall }
    };
    (0..candidates.len()).filter(|i| !parent.members.contains(i)).map(lead).filter(|l| !l.starts.is_empty()).collect()
}

/// The most promising shapes of an effect on a ground.
pub fn starts(ground: &Ground, candidate: &Candidate) -> Vec<(usize, Gain)> {
    promising(candidate.variants.iter().map(|v| ground.gain(v)).collect())
}

/// The best of the gains of all variants, each in another neighbourhood: neighbours on the grid run into the same minimum.
pub fn promising(gains: Vec<Gain>) -> Vec<(usize, Gain)> {
    let mut all: Vec<(usize, Gain)> = gains.into_iter().enumerate().collect();
    all.sort_by(|a, b| b.1.fall.total_cmp(&a.1.fall));
    let mut chosen: Vec<(usize, Gain)> = Vec::new();
    for (i, gain) in all {
        if chosen.iter().all(|(j, _)| i.abs_diff(*j) > 1) && chosen.len() < STARTS {
            chosen.push((i, gain));
        }
    }
    chosen
}

/// A set less one of its effects, everything else standing as it did.
pub fn bare<'a>(base: &Trial<'a>, candidates: &[Candidate], set: &Trial<'a>, member: usize) -> Option<Trial<'a>> {
    let mut trial = base.clone();
    let mut position = set.solution.position.iter().copied();
    let mut kept: Vec<f64> = position.by_ref().take(base.objective.axes.len()).collect();
    for &m in &set.members {
        let values: Vec<f64> = position.by_ref().take(candidates[m].parameters).collect();
        if m != member {
            trial.objective = trial.objective.with(candidates[m].effect);
            trial.members.push(m);
            kept.extend(values);
        }
    }
    let position = DVector::from_vec(kept);
    let predicted = trial.objective.predict(&position)?;
    let chi2 = trial.objective.residuals(&position, &predicted).norm_squared();
    trial.solution = Solution { position, predicted, chi2 };
    Some(trial)
}

/// A set less one of its effects, fitted.
pub fn without<'a>(base: &Trial<'a>, candidates: &[Candidate], set: &Trial<'a>, member: usize) -> Option<Trial<'a>> {
    let mut trial = bare(base, candidates, set, member)?;
    let start = trial.solution.position.clone();
    trial.solution = minimise(&mut trial.objective, &start, &[], SEARCHING)?;
    Some(trial)
}

/// Exchanges one effect of a set for another, or for itself in another shape, or two for themselves in other shapes, as long as the set becomes better by it.
fn exchange<'a>(base: &Trial<'a>, candidates: &[Candidate], mut best: Trial<'a>, breadth: Breadth) -> Trial<'a> {
    for _ in 0..EXCHANGES {
        let smaller: Vec<Trial> = best.members.iter().filter_map(|m| without(base, candidates, &best, *m)).collect();
        let mut leads: Vec<Lead> = smaller.par_iter().flat_map_iter(|parent| leads(parent, candidates)).collect();
        leads.sort_by(|a, b| a.promised.total_cmp(&b.promised));
        leads.truncate(breadth.refitted);
        let mut fitted: Vec<Trial> = leads.par_iter().filter_map(|lead| refit(lead, candidates)).collect();
        if best.members.len() > 2 {
            fitted.extend(reseated(base, candidates, &best));
        }
        let Some(better) = fitted.into_iter().min_by(|a, b| a.score().total_cmp(&b.score())) else { break };
        if better.score() >= best.score() {
            break;
        }
        best = better;
    }
    best
}

/// A set with every two of its effects in the shapes that promise most together beside the rest of it.
fn reseated<'a>(base: &Trial<'a>, candidates: &[Candidate], set: &Trial<'a>) -> Vec<Trial<'a>> {
    let members = set.key();
    let twos: Vec<[usize; 2]> =
        (0..members.len()).flat_map(|j| (0..j).map(move |i| [i, j])).map(|two| two.map(|i| members[i])).collect();
    let reseat = |two: &[usize; 2]| {
        let rest = without(base, candidates, &without(base, candidates, set, two[0])?, two[1])?;
        let ground = Ground::new(&mut rest.objective.clone(), &rest.solution)?;
        let pairs = pairs::pairs(&ground, &two.map(|i| &candidates[i]));
        let start = together(&rest, pairs.get(&(0, 1))?, *two, candidates);
        let objective = rest.objective.with(candidates[two[0]].effect).with(candidates[two[1]].effect);
        fit_from(&rest, two, objective, [start])
    };
    twos.par_iter().filter_map(reseat).collect()
}

/// A start that can be computed: what the columns promise may lie where there is no model, and half of it, or a quarter, where there is one.
fn nearer(objective: &mut Objective, mut start: Start) -> Option<DVector<f64>> {
    for _ in 0..HALVINGS {
        if objective.predict(&start.position).is_some() {
            return Some(start.position);
        }
        for (variable, neutral) in &start.switches {
            let place = &mut start.position[*variable];
            *place = neutral + 0.5 * (*place - neutral);
        }
    }
    None
}

impl<'a> Lead<'_, 'a> {
    /// Looks at the two effects of a pair together: what the first made its own while it was alone may be the second's.
    fn look_at(
        &mut self,
        pairs: &BTreeMap<(usize, usize), Pair>,
        base: &Trial<'a>,
        left: f64,
        candidates: &[Candidate],
    ) {
        let two = [self.parent.members[0], self.added];
        let Some(pair) = pairs.get(&(two[0].min(two[1]), two[0].max(two[1]))) else { return };
        self.promised = self.promised.min(left - pair.fall());
        self.together = Some(together(base, pair, two, candidates));
        self.starts.truncate(STARTS - 1);
    }
}

/// Where a fit of a set with two effects more begins; they are added in the order of `two`.
fn together(rest: &Trial, pair: &Pair, two: [usize; 2], candidates: &[Candidate]) -> Start {
    let axes = two.iter().fold(rest.objective.clone(), |o, i| o.with(candidates[*i].effect)).axes;
    let rising = [two[0].min(two[1]), two[0].max(two[1])];
    let mut start = Start::own(&rest.solution.position);
    for number in two {
        let (variant, amplitudes) = pair.of(rising.map(|i| &candidates[i]), usize::from(number == rising[1]));
        start = start.with(&candidates[number].variants[variant], amplitudes, &axes);
    }
    start
}

/// Fits a set from its starts.
fn refit<'a>(lead: &Lead<'_, 'a>, candidates: &[Candidate]) -> Option<Trial<'a>> {
    let candidate = &candidates[lead.added];
    let objective = lead.parent.objective.with(candidate.effect);
    let starts = one_by_one(lead.parent, candidate, &lead.starts, &objective.axes);
    fit_from(lead.parent, &[lead.added], objective, starts.into_iter().chain(lead.together.clone()))
}

/// A set with one candidate more, fitted from the given starts.
pub fn fit_with<'a>(
    parent: &Trial<'a>,
    added: usize,
    candidate: &Candidate,
    starts: &[(usize, Gain)],
) -> Option<Trial<'a>> {
    let objective = parent.objective.with(candidate.effect);
    let starts = one_by_one(parent, candidate, starts, &objective.axes);
    fit_from(parent, &[added], objective, starts)
}

/// Starts where the set stands, with the new effect in each of its shapes.
fn one_by_one(parent: &Trial, candidate: &Candidate, starts: &[(usize, Gain)], axes: &[Axis]) -> Vec<Start> {
    let own = Start::own(&parent.solution.position);
    starts.iter().map(|(v, gain)| own.clone().with(&candidate.variants[*v], &gain.amplitudes, axes)).collect()
}

fn fit_from<'a>(
    parent: &Trial<'a>,
    added: &[usize],
    mut objective: Objective<'a>,
    starts: impl IntoIterator<Item = Start>,
) -> Option<Trial<'a>> {
    if objective.freedom() < 1.0 {
        // As many parameters as rows fit anything.
        return None;
    }
    let mut best: Option<Solution> = None;
    for start in starts {
        // A model that lacks an effect has bent what it knows; from there the way back may be barred.
        let bent = objective.pull(&start.position) > BENT;
        let written = bent.then(|| Start { position: objective.as_written(&start.position), ..start.clone() });
        for start in std::iter::once(start).chain(written) {
            let found =
                nearer(&mut objective, start).and_then(|start| minimise(&mut objective, &start, &[], SEARCHING));
            best = best.into_iter().chain(found).min_by(|a, b| a.chi2.total_cmp(&b.chi2));
        }
    }
    let solution = best?;
    Some(Trial { members: [&parent.members, added].concat(), objective, solution })
}
