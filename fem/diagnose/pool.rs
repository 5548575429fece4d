//! The sets that a search has visited, and the moves that are open to it.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::candidate_model::{CandidateModel, Weighed};
use super::laplace;
use super::lead::bare;
use super::like_a_curve;
use super::moves::{self, Move, Reach, SEARCHING};
use super::residual_projection::ProjectedResidual;
use super::sensitivity::CandidateEffect;
use crate::fit::resume;
use crate::progress::Progress;

/// Rise of the criterion from the best set up to which sets are visited: all beyond it together weigh less than a hundredth.
const WINDOW: f64 = 12.0;
/// Rise of the criterion up to which a set is left by two effects at once.
const NEAR: f64 = 4.0;
/// Rise of the criterion from the best set beyond which a fit is not brought to its end.
const HOPELESS: f64 = 60.0;
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

impl NoiseChange {
    /// The change from a noise of the same terms, where it has settled or has not.
    pub fn of_size(has_settled: bool) -> Self {
        if has_settled { Self::Little } else { Self::Size }
    }
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
pub struct Pool<'p, 'a> {
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

impl<'p, 'a> Pool<'p, 'a> {
    /// A pool that holds the model without any candidate effect; a search that knows no sets from before looks further.
    pub fn new(base: &'p CandidateModel<'a>, candidates: Vec<CandidateEffect>, most: usize, is_first: bool) -> Self {
        let mut pool = Self {
            base,
            is_unseen: unseen(base, &candidates),
            candidates,
            most,
            visited: BTreeMap::new(),
            open: BTreeMap::new(),
            beside: None,
            looks: 0,
            looks_elsewhere: is_first,
            idle: if is_first { IDLE } else { 1 },
        };
        pool.visit(vec![(base.clone(), 1)]);
        pool
    }

    /// All sets that were visited, and the candidate effects as they were seen last.
    pub fn emptied(self) -> (Vec<Weighed<'a>>, Vec<CandidateEffect>) {
        (self.visited.into_values().map(|own| own.set).collect(), self.candidates)
    }

    /// Smallest criterion of all that were visited.
    fn best(&self) -> f64 {
        self.visited.values().map(|own| own.set.criterion).fold(f64::INFINITY, f64::min)
    }

    /// Weight of all that were visited, of a set with this criterion one.
    fn weight(&self, criterion: f64) -> f64 {
        self.visited.values().map(|own| laplace::weight(own.set.criterion, criterion)).sum()
    }

    /// Takes in sets, each with how often it was fitted for it.
    fn visit(&mut self, sets: Vec<(CandidateModel<'a>, usize)>) {
        let weigh = |(model, fits): (CandidateModel<'a>, usize)| {
            let model = model.with_slopes()?;
            Some(Weighed { criterion: laplace::criterion(&model)?, model, fits })
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
                Some(own) => *own = Visited { set: Weighed { fits: own.set.fits + set.fits, ..set }, left: None },
                None => drop(self.visited.insert(key, Visited { set, left: None })),
            }
        }
    }

    /// Goes on from sets that an earlier search has found under another noise.
    pub fn resume(&mut self, known: &[Weighed<'a>], noise: NoiseChange) {
        let under = |earlier: &Weighed<'a>| {
            let members = earlier.model.members.clone();
            let mut objective = self.base.objective.clone();
            for member in &members {
                objective = objective.with(&self.candidates[*member].effect);
            }
            let mut solution = earlier.model.solution.clone();
            solution.chi2 = objective.residuals(&solution.position, &solution.predicted).norm_squared();
            let model = CandidateModel { members, objective, solution };
            let fits = if noise == NoiseChange::Terms { 1 } else { earlier.fits };
            Some(Weighed { criterion: laplace::criterion(&model)?, model, fits })
        };
        let all: Vec<Weighed> =
            known.par_iter().filter(|set| !set.model.members.is_empty()).filter_map(under).collect();
        let most = all.iter().map(|set| set.criterion).fold(f64::INFINITY, f64::min) + WINDOW;
        let again = |Weighed { mut model, criterion, fits }: Weighed<'a>| {
            if criterion < most || model.members.len() == 1 {
                model.solution = resume(&mut model.objective, model.solution, &[], SEARCHING);
            }
            (model, fits)
        };
        let sets = all.into_par_iter().map(again).collect();
        self.visit(sets);
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
    pub fn singles(&mut self) {
        self.leave(&[Vec::new()], Reach::Two);
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
            Some((moves::fit(self.base, &from.model, &open.to, &self.candidates, is_hopeful)?, 1))
        };
        let fitted = moves.par_iter().filter_map(fit).collect();
        self.visit(fitted);
    }

    /// Makes the sensitivities of absent effects anew beside the best set, where that is another one than before: some
    /// act only where others do. Whether there is anything new to leave.
    pub fn look_from_the_best(&mut self) -> bool {
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
    pub fn explore(&mut self, progress: &Progress) {
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
