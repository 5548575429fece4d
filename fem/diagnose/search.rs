//! Searches the sets of effects that are worth believing.
//!
//! Forward selection, the best effect and then the next best, picks wrong sets where sensitivities are alike, and the best
//! set alone is no answer where several say as much. So sets compete by their posterior weight: from every set near the
//! best the search goes on to sets with an effect more, less or exchanged, by the linear model about it, and fits those
//! that promise to be near the best; everything visited is kept.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::candidate_model::{CandidateModel, Weighed, key};
use super::laplace;
use super::lead::bare;
use super::like_a_curve;
use super::moves::{self, Move, Reach, SEARCHING};
use super::null_distribution::{MaxStatistic, Variance};
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::sensitivity::CandidateEffect;
use crate::fit::resume;
use crate::progress::Progress;

/// Significance level: an effect is told when chance alone gives as much in a smaller part of searches.
pub const SIGNIFICANCE: f64 = 0.01;

/// Rise of the criterion from the best set up to which sets are visited: all beyond it together weigh less than a hundredth.
const WINDOW: f64 = 12.0;
/// Rise of the criterion up to which a set is left by two effects at once.
const NEAR: f64 = 4.0;
/// Rise of the criterion up to which a set of fewer effects is told in the place of the most probable one: what nine times
/// of ten is there is told by its probability.
pub const PLAINER: f64 = 4.6;
/// Rise of the criterion from the best set beyond which a fit is not brought to its end.
const HOPELESS: f64 = 60.0;
/// Probability of all sets that are told together, and how many are told at most.
pub const TOLD: f64 = 0.95;
pub const MOST_TOLD: usize = 20;
/// Sets that are left, and moves that are fitted, together.
const TOGETHER: usize = 8;
/// Rounds of moves that bring less than this part of the weight of all sets, after which a search ends.
const IDLE: usize = 3;
const NEWS: f64 = 0.02;
/// Most sets that are fitted.
const MOST_FITS: usize = 400;
/// Sets of every size that are left, and moves of each that are made, where nothing near the best is left to do.
const ELSEWHERE: usize = 3;
/// Most sets that are left so.
const MOST_ELSEWHERE: usize = 32;
/// Fall of the criterion that a move must promise for a set to be fitted once more, and how often it is fitted at most.
const DEEPER: f64 = 6.0;
const MOST_TIMES: usize = 4;
/// Most times that the sensitivities are made anew.
const MOST_LOOKS: usize = 6;

/// How far a search goes, and what it knows beforehand.
#[derive(Clone, Copy)]
pub struct Extent<'e, 'a> {
    /// Most effects that are sought together.
    pub most: usize,
    /// Whether the best set, where it leaves structure, is brought to the deepest minimum that the profiles of
    /// its parameters come upon: as dear as the search itself.
    pub deepens: bool,
    /// Sets that an earlier search has fitted, under another noise.
    pub known: &'e [Weighed<'a>],
    /// How its noise differs from that one.
    pub noise: NoiseChange,
    /// Where progress is told.
    pub progress: &'e Progress,
}

/// How the noise of a search differs from that of an earlier one.
#[derive(Clone, Copy, PartialEq)]
pub enum NoiseChange {
    /// In its terms: everything is sought again.
    Terms,
    /// In its size: moves that were no use are no use now.
    Size,
    /// Hardly: what has been found is all that there is to find.
    Little,
}

/// Stretch of the null distributions.
const CHANCE: &str = "what chance gives";

/// Result of a search.
#[derive(Clone)]
pub struct SearchResult<'a> {
    /// Model without any candidate effect.
    pub base: CandidateModel<'a>,
    /// Candidate effects that were sought.
    pub candidates: Vec<CandidateEffect>,
    /// Most effects that were sought together.
    pub most: usize,
    /// Best set of each size, up to that of the set that is told.
    pub steps: Vec<CandidateModel<'a>>,
    /// Model with each candidate effect alone, where it can be computed.
    pub singles: Vec<Option<CandidateModel<'a>>>,
    /// All sets that were fitted, the most probable first.
    pub tried: Vec<Weighed<'a>>,
    /// Null distribution of the gain of the first effect.
    pub first_null_distribution: MaxStatistic,
    /// Null distribution of the gain of one effect more, on the last set.
    pub null_distribution: MaxStatistic,
}

impl<'a> SearchResult<'a> {
    /// Set that is told: the plainest of the most probable; the model itself where nothing was found.
    pub fn best(&self) -> &CandidateModel<'a> {
        self.steps.last().unwrap_or(&self.base)
    }

    /// Tells this set in the place of the one that is told.
    pub fn tell(&mut self, set: CandidateModel<'a>) {
        self.steps.truncate(set.members.len() - 1);
        self.steps.push(set);
    }

    /// The other sets that may be true, each with its weight beside this one; `None` where this one was not visited, and so has none.
    pub fn beside(&self, members: &[usize]) -> Option<impl Iterator<Item = (&CandidateModel<'a>, f64)>> {
        let members = key(members);
        let own = self.tried.iter().find(|set| set.model.key() == members)?.criterion;
        let others = self.credible().iter().filter(move |set| set.model.key() != members);
        Some(others.map(move |set| (&set.model, laplace::weight(set.criterion, own))))
    }

    /// The most probable sets, which together hold nearly all of the probability under this noise.
    pub fn credible(&self) -> &[Weighed<'a>] {
        let least = self.tried.first().map_or(0.0, |best| best.criterion);
        let weight = |set: &Weighed| laplace::weight(set.criterion, least);
        let whole: f64 = self.tried.iter().map(weight).sum();
        let mut told = 0.0;
        let is_credible = |set: &&Weighed| {
            told += weight(set);
            told - weight(set) < TOLD * whole
        };
        let count = self.tried.iter().take(MOST_TOLD).take_while(is_credible).count();
        &self.tried[..count]
    }
}

/// Searches sets of up to `most` effects. `None` where the model cannot be computed beside its own best
/// values.
pub fn search<'a>(
    base: CandidateModel<'a>,
    candidates: Vec<CandidateEffect>,
    variance: Variance,
    extent: Extent<'_, 'a>,
) -> Option<SearchResult<'a>> {
    let Extent { most, known, noise, progress, .. } = extent;
    let null_beside = |set: &CandidateModel| {
        progress.stretch(CHANCE, || {
            let projected = ProjectedResidual::new(&mut set.objective.clone(), &set.solution)?;
            // Changes pay for their borders by odds and place, and have a distribution of their own where one is told.
            let is_other = |i: usize, c: &CandidateEffect| !set.members.contains(&i) && c.effect.changes.is_none();
            let others = candidates.iter().enumerate().filter(|(i, c)| is_other(*i, c)).map(|(_, c)| c);
            let screening = Screening::new(&projected, &others.collect::<Vec<_>>());
            Some(MaxStatistic::simulate(&screening, projected.freedom, variance))
        })
    };
    let first_null_distribution = null_beside(&base)?;
    let mut pool = Pool {
        base: &base,
        is_unseen: unseen(&base, &candidates),
        candidates: candidates.clone(),
        most: most.max(1),
        visited: BTreeMap::new(),
        open: BTreeMap::new(),
        beside: None,
        looks: 0,
        looks_elsewhere: known.is_empty(),
        idle: if known.is_empty() { IDLE } else { 1 },
    };
    pool.visit(vec![base.clone()]);
    progress.stretch("sets that an earlier search has found", || pool.resume(known, noise));
    if noise != NoiseChange::Little {
        pool.leave(&[Vec::new()], Reach::Two);
        progress.stretch("fits of one effect", || pool.singles());
        progress.stretch("fits of sets", || pool.explore(progress));
    } else {
        // What else would be seen is told beside what has been found.
        pool.look_from_the_best();
    }
    let Pool { visited, candidates, .. } = pool;
    let single = |i: usize| visited.get(&vec![i]).map(|own| own.set.model.clone());
    let singles = (0..candidates.len()).map(single).collect();
    let mut tried: Vec<Weighed> = visited.into_values().map(|own| own.set).collect();
    tried.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    let steps = loop {
        let steps = plainest(&tried);
        let Some(last) = steps.last().filter(|last| last.objective.jacobian(&last.solution).is_none()) else {
            break steps;
        };
        // On the edge of where the model can be computed nothing can be said about its values.
        let edge = last.key();
        tried.retain(|set| set.model.key() != edge);
    };
    let null_distribution = match steps.last() {
        Some(best) => null_beside(best).unwrap_or_else(|| first_null_distribution.clone()),
        None => first_null_distribution.clone(),
    };
    Some(SearchResult { base, candidates, most, steps, singles, tried, first_null_distribution, null_distribution })
}

/// Whether each candidate is nothing that these data could show at a usual size, for the parameters of the model itself
/// take it up beside a set, or it is less than the noise.
fn unseen(set: &CandidateModel, candidates: &[CandidateEffect]) -> Vec<bool> {
    /// χ² below which all rows together do not show it.
    const LEAST: f64 = 1.0;
    let Some(jacobian) = set.jacobian() else { return vec![false; candidates.len()] };
    let own = jacobian.columns(0, set.objective.data.model.parameters.len()).into_owned();
    let residual = set.objective.residuals(&set.solution.position, &set.solution.predicted);
    let projected = ProjectedResidual::beside(&set.objective, own, residual);
    let is_unseen = |candidate: &CandidateEffect| {
        candidate.variants.iter().all(|v| v.largest_chi2(&projected.project_columns(&v.columns)) < LEAST)
    };
    candidates.par_iter().map(is_unseen).collect()
}

/// Best set of each size, up to the smallest that is told in the place of the most probable one.
fn plainest<'a>(tried: &[Weighed<'a>]) -> Vec<CandidateModel<'a>> {
    let near = tried.first().map_or(0.0, |best| best.criterion) + PLAINER;
    let size = tried.iter().take_while(|set| set.criterion <= near).map(|set| set.model.members.len()).min();
    let of_size = |size: usize| tried.iter().find(|set| set.model.members.len() == size).map(|set| set.model.clone());
    (1..=size.unwrap_or(0)).filter_map(of_size).collect()
}

/// A set that was fitted, and how far it was left.
struct Visited<'a> {
    set: Weighed<'a>,
    left: Option<Reach>,
}

/// A move that nobody has made yet, with the set from which it goes and the criterion that it promises.
struct Open {
    promised: f64,
    from: Vec<usize>,
    to: Move,
}

/// Sets that were visited, and moves that are open. Maps keep an order, so that the same data always give the same answer.
struct Pool<'p, 'a> {
    base: &'p CandidateModel<'a>,
    candidates: Vec<CandidateEffect>,
    most: usize,
    visited: BTreeMap<Vec<usize>, Visited<'a>>,
    open: BTreeMap<Vec<usize>, Open>,
    /// The set beside which the sensitivities of the others were made, and how often.
    beside: Option<Vec<usize>>,
    looks: usize,
    /// Whether each candidate is nothing that these data could show beside the model, whatever else there is: what the
    /// model's own freedom takes up, or too small at any usual size. Such an effect is as probable as its odds say, and has
    /// no place in sets.
    is_unseen: Vec<bool>,
    /// Whether it may still look elsewhere.
    looks_elsewhere: bool,
    /// Idle rounds after which it ends: of what an earlier search has found little is new.
    idle: usize,
}

impl<'a> Pool<'_, 'a> {
    /// Smallest criterion of all that were visited.
    fn best(&self) -> f64 {
        self.visited.values().map(|own| own.set.criterion).fold(f64::INFINITY, f64::min)
    }

    /// Weight of all that were visited, of a set with this criterion one.
    fn weight(&self, criterion: f64) -> f64 {
        self.visited.values().map(|own| laplace::weight(own.set.criterion, criterion)).sum()
    }

    fn visit(&mut self, sets: Vec<CandidateModel<'a>>) {
        let weigh = |model: CandidateModel<'a>| {
            let model = model.with_slopes()?;
            Some(Weighed { criterion: laplace::criterion(&model)?, model, fits: 1 })
        };
        let weighed: Vec<Weighed> = sets.into_par_iter().filter_map(weigh).collect();
        for set in weighed {
            let key = set.model.key();
            self.open.remove(&key);
            match self.visited.get_mut(&key) {
                Some(own) if own.set.criterion - DEEPER <= set.criterion => {
                    // Where what was promised is not kept, the linear model is of no use.
                    if set.criterion < own.set.criterion {
                        own.set = set;
                    }
                    own.set.fits = MOST_TIMES;
                }
                Some(own) => *own = Visited { set: Weighed { fits: own.set.fits + 1, ..set }, left: None },
                None => drop(self.visited.insert(key, Visited { set, left: None })),
            }
        }
    }

    /// Goes on from sets that an earlier search has found under another noise.
    fn resume(&mut self, known: &[Weighed<'a>], noise: NoiseChange) {
        let under = |earlier: &Weighed<'a>| {
            let members = earlier.model.members.clone();
            let mut objective = self.base.objective.clone();
            for member in &members {
                objective = objective.with(&self.candidates[*member].effect);
            }
            let mut solution = earlier.model.solution.clone();
            solution.chi2 = objective.residuals(&solution.position, &solution.predicted).norm_squared();
            let model = CandidateModel { members, objective, solution };
            Some(Weighed { criterion: laplace::criterion(&model)?, model, fits: earlier.fits })
        };
        let all: Vec<Weighed> =
            known.par_iter().filter(|set| !set.model.members.is_empty()).filter_map(under).collect();
        let most = all.iter().map(|set| set.criterion).fold(f64::INFINITY, f64::min) + WINDOW;
        let again = |Weighed { mut model, criterion, .. }: Weighed<'a>| {
            if criterion < most || model.members.len() == 1 {
                model.solution = resume(&mut model.objective, model.solution, &[], SEARCHING);
            }
            model
        };
        let fits: Vec<(Vec<usize>, usize)> = all.iter().map(|set| (set.model.key(), set.fits)).collect();
        let sets = all.into_par_iter().map(again).collect();
        self.visit(sets);
        if noise == NoiseChange::Terms {
            return;
        }
        for (key, fits) in fits {
            if let Some(own) = self.visited.get_mut(&key) {
                own.set.fits = fits;
            }
        }
    }

    /// Opens the moves from some sets.
    fn leave(&mut self, keys: &[Vec<usize>], reach: Reach) {
        let of = |key: &Vec<usize>| {
            let set = &self.visited.get(key)?.set;
            Some((key.clone(), moves::moves(&set.model, &self.candidates, &self.is_unseen, (self.most, reach))))
        };
        let all: Vec<(Vec<usize>, Vec<Move>)> = keys.par_iter().filter_map(of).collect();
        for (from, moves) in all {
            let Some(here) = self.visited.get_mut(&from) else { continue };
            here.left = Some(reach);
            let here = &self.visited[&from].set;
            let open: Vec<(f64, Move)> = moves.into_iter().map(|to| (self.promised(here, &to), to)).collect();
            for (promised, to) in open {
                let is_done = |own: &Visited| own.set.fits == MOST_TIMES || promised > own.set.criterion - DEEPER;
                let is_worse = |own: &Open| own.promised <= promised;
                if self.visited.get(&to.key).is_some_and(is_done) || self.open.get(&to.key).is_some_and(is_worse) {
                    continue;
                }
                self.open.insert(to.key.clone(), Open { promised, from: from.clone(), to });
            }
        }
    }

    /// The criterion of a set to which a move leads, by what it promises.
    fn promised(&self, from: &Weighed, to: &Move) -> f64 {
        self.criterion_at(to.promised.max(1e-3 * from.model.solution.chi2), from, to)
    }

    /// The criterion of a set to which a move leads, were its χ² this.
    fn criterion_at(&self, chi2: f64, from: &Weighed, to: &Move) -> f64 {
        let was = from.model.solution.chi2;
        let rise = laplace::misfit(&from.model, chi2) - laplace::misfit(&from.model, was);
        let price = |member: &usize| laplace::usual_price(&self.candidates[*member].effect);
        from.criterion + rise + to.added.iter().map(price).sum::<f64>() - to.dropped.iter().map(price).sum::<f64>()
    }

    /// Fits every effect alone.
    fn singles(&mut self) {
        let single = |key: &&Vec<usize>| key.len() == 1;
        let keys: Vec<Vec<usize>> = self.open.keys().filter(single).cloned().collect();
        self.make(&keys);
    }

    /// Makes open moves.
    fn make(&mut self, keys: &[Vec<usize>]) {
        let moves: Vec<Open> = keys.iter().filter_map(|key| self.open.remove(key)).collect();
        let most = self.best() + HOPELESS;
        let fit = |open: &Open| {
            let from = &self.visited[&open.from].set;
            let is_hopeful = |chi2: f64| self.criterion_at(chi2, from, &open.to) < most;
            moves::fit(self.base, &from.model, &open.to, &self.candidates, is_hopeful)
        };
        let fitted = moves.par_iter().filter_map(fit).collect();
        self.visit(fitted);
    }

    /// Makes the sensitivities of absent effects anew beside the best set, where that is another one than before: some
    /// act only where others do. Whether there is anything new to leave.
    fn look_from_the_best(&mut self) -> bool {
        let best = self.visited.values().min_by(|a, b| a.set.criterion.total_cmp(&b.set.criterion));
        let Some(best) = best.map(|own| &own.set.model) else { return false };
        if best.members.is_empty() || self.beside.as_ref() == Some(&best.key()) || self.looks == MOST_LOOKS {
            return false;
        }
        let beside = |number: usize| {
            let effect = std::slice::from_ref(&self.candidates[number].effect);
            if best.objective.added.iter().any(|own| own.is_change_of(&self.candidates[number].effect.name)) {
                // Beside its change it is felt in a part of the rows alone.
                return None;
            }
            let rest = match best.members.contains(&number) {
                true => bare(self.base, &self.candidates, best, number)?,
                false => best.clone(),
            };
            like_a_curve::candidates(&rest.objective, &rest.solution, effect).pop()
        };
        let anew: Vec<Option<CandidateEffect>> = (0..self.candidates.len()).into_par_iter().map(beside).collect();
        self.beside = Some(best.key());
        self.looks += 1;
        for (candidate, anew) in self.candidates.iter_mut().zip(anew) {
            if let Some(anew) = anew.filter(|anew| !anew.variants.is_empty()) {
                *candidate = anew;
            }
        }
        let is_unseen = unseen(best, &self.candidates);
        self.is_unseen.iter_mut().zip(is_unseen).for_each(|(own, anew)| *own &= anew);
        self.open.clear();
        let most = self.best() + WINDOW;
        self.visited.values_mut().filter(|own| own.set.criterion < most).for_each(|own| own.left = None);
        true
    }

    /// Follows the most promising moves from the best sets of every size, however far behind they are, once for each: the
    /// best of all may stand in a valley of its own. Whether there were any.
    fn look_elsewhere(&mut self) -> bool {
        if !std::mem::take(&mut self.looks_elsewhere) {
            return false;
        }
        let mut keys: Vec<Vec<usize>> = Vec::new();
        for size in 1..=self.most {
            let of_size = self.visited.iter().filter(|(key, own)| key.len() == size && own.left != Some(Reach::Two));
            let mut sets: Vec<(f64, &Vec<usize>)> = of_size.map(|(key, own)| (own.set.criterion, key)).collect();
            sets.sort_by(|a, b| a.0.total_cmp(&b.0));
            keys.extend(sets.into_iter().take(ELSEWHERE).map(|(_, key)| key.clone()));
        }
        keys.truncate(MOST_ELSEWHERE);
        self.leave(&keys, Reach::Two);
        let mut chosen: Vec<Vec<usize>> = Vec::new();
        for key in keys {
            let from = self.visited[&key].set.criterion;
            let mut moves: Vec<&Open> =
                self.open.values().filter(|open| open.from == key && open.promised < from).collect();
            moves.sort_by(|a, b| a.promised.total_cmp(&b.promised));
            chosen.extend(moves.iter().take(ELSEWHERE).map(|open| open.to.key.clone()));
        }
        self.make(&chosen);
        !chosen.is_empty()
    }

    /// Visits all sets that may be near the best.
    fn explore(&mut self, progress: &Progress) {
        let (mut fits, mut idle) = (0, 0);
        while fits < MOST_FITS && progress.permits("further sets of effects") {
            let best = self.best();
            let far = |left: Option<Reach>, criterion: f64| match left {
                None => criterion < best + WINDOW,
                Some(Reach::One) => criterion < best + NEAR,
                Some(Reach::Two) => false,
            };
            let mut near: Vec<(f64, Vec<usize>)> = self
                .visited
                .iter()
                .filter(|(_, own)| far(own.left, own.set.criterion))
                .map(|(key, own)| (own.set.criterion, key.clone()))
                .collect();
            near.sort_by(|a, b| a.0.total_cmp(&b.0));
            near.truncate(TOGETHER);
            let (two, one): (Vec<_>, Vec<_>) = near.into_iter().partition(|(criterion, _)| *criterion < best + NEAR);
            let keys = |sets: Vec<(f64, Vec<usize>)>| sets.into_iter().map(|(_, key)| key).collect::<Vec<_>>();
            let (two, one) = (keys(two), keys(one));
            self.leave(&two, Reach::Two);
            self.leave(&one, Reach::One);
            let mut promising: Vec<(f64, Vec<usize>)> = self
                .open
                .values()
                .filter(|o| o.promised < best + WINDOW)
                .map(|o| (o.promised, o.to.key.clone()))
                .collect();
            promising.sort_by(|a, b| a.0.total_cmp(&b.0));
            promising.truncate(TOGETHER);
            if idle >= self.idle || promising.is_empty() && two.is_empty() && one.is_empty() {
                idle = 0;
                if !self.look_from_the_best() && !self.look_elsewhere() {
                    break;
                }
                continue;
            }
            fits += promising.len();
            let before = self.weight(best);
            self.make(&keys(promising));
            idle = if self.weight(best) - before < NEWS * before { idle + 1 } else { 0 };
        }
    }
}
