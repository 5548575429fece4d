//! What the sets share: the probability of every effect, and groups of which some are there though nobody can say which.

use std::collections::BTreeMap;

use super::candidate_model::{CandidateModel, Weighed};
use super::laplace;
use super::search::{MOST_TOLD, PLAINER, SearchResult, TOLD};
use crate::input::Name;
use crate::process::Description;

/// Probability from which an effect, or a number of a group, is certain.
pub const CERTAIN: f64 = 0.9;
/// Probability below which an effect is ruled out, for all that these data show.
pub const RULED_OUT: f64 = 0.05;
/// Probability from which an effect may stand for another in a group.
const GROUPED: f64 = 0.01;
/// Ratio of the probability of two effects together to that of independent ones below which they stand for each other.
const INSTEAD: f64 = 0.8;

/// Ratio of the odds with the data to those before them (Bayes factor) from which an effect is told as found: below,
/// the evidence is "not worth more than a bare mention" (Kass and Raftery 1995).
const NOTABLE: f64 = 3.0;

/// Whether data that raise a probability from `before` to `now` speak for an effect.
pub fn speaks(now: f64, before: f64) -> bool {
    let odds = |p: f64| p / (1.0 - p);
    odds(now) >= NOTABLE * odds(before)
}

/// Whether a fitted set is not ruled out beside the most probable one of a search.
pub fn may_be_true(found: &SearchResult, set: &CandidateModel) -> bool {
    let best = found.tried.first().map_or(f64::INFINITY, |set| set.criterion);
    laplace::criterion(set).is_some_and(|own| laplace::weight(own, best) >= RULED_OUT)
}

/// A set of effects with its criterion.
#[derive(Clone, Debug)]
pub struct Visit {
    effects: Vec<Name>,
    criterion: f64,
    reduced_chi2: f64,
}

impl Visit {
    /// The sets that a search has visited, and those that are likelier where one of their laws bends.
    pub fn all(found: &SearchResult, bent: &[(usize, f64)]) -> Vec<Self> {
        let bent =
            bent.iter().map(|(number, criterion)| Self { criterion: *criterion, ..Self::of(&found.tried[*number]) });
        found.tried.iter().map(Self::of).chain(bent).collect()
    }

    fn of(set: &Weighed) -> Self {
        let Weighed { model, criterion, .. } = set;
        Self {
            effects: effects(model),
            criterion: *criterion,
            reduced_chi2: model.solution.chi2 / model.objective.freedom().max(1.0),
        }
    }
}

/// Names of the effects that a model has beyond what the file states.
fn effects(model: &CandidateModel) -> Vec<Name> {
    let objective = &model.objective;
    let stated = &objective.data.terms;
    let terms =
        objective.noise.terms.iter().filter(|term| !term.is_among(stated)).map(|term| Name::new(term.effect.name));
    let mut all: Vec<Name> = objective.added.iter().map(|effect| effect.name.clone()).chain(terms).collect();
    all.sort();
    all
}

/// A set with its probability.
#[derive(Clone, Debug, PartialEq)]
pub struct Believed {
    /// Names of its effects.
    pub effects: Vec<Name>,
    /// Its probability among all sets that were visited.
    pub probability: f64,
    /// χ² over the degrees of freedom.
    pub reduced_chi2: f64,
}

/// Effects of which some are there, though these data cannot say which.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// How many of them are there for certain.
    pub at_least: usize,
    /// Names of the effects.
    pub effects: Vec<Name>,
    /// Probability that so many are there.
    pub probability: f64,
}

/// Posterior over the sets of effects.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Posterior {
    /// The most probable sets, the first first, which hold nearly all of the probability.
    pub sets: Vec<Believed>,
    /// Groups of effects that stand for each other.
    pub groups: Vec<Group>,
    probabilities: BTreeMap<Name, f64>,
}

impl Posterior {
    /// Weighs all sets that were visited; of a set that was visited under several noises each counts.
    pub fn new(visits: &[Visit]) -> Self {
        let least = visits.iter().map(|v| v.criterion).fold(f64::INFINITY, f64::min);
        let mut sets: BTreeMap<Vec<Name>, (f64, f64, f64)> = BTreeMap::new();
        for visit in visits {
            // The same set in two searches of one noise counts once.
            let weight = laplace::weight(visit.criterion, least);
            let own = sets.entry(visit.effects.clone()).or_insert((0.0, f64::INFINITY, 0.0));
            if visit.criterion < own.1 {
                *own = (weight, visit.criterion, visit.reduced_chi2);
            }
        }
        let whole: f64 = sets.values().map(|own| own.0).sum();
        let mut all: Vec<Believed> = sets
            .into_iter()
            .map(|(effects, (weight, _, reduced_chi2))| Believed { effects, probability: weight / whole, reduced_chi2 })
            .collect();
        all.sort_by(|a, b| b.probability.total_cmp(&a.probability));
        let mut probabilities: BTreeMap<Name, f64> = BTreeMap::new();
        for set in &all {
            let mut names = set.effects.clone();
            names.dedup();
            for name in names {
                *probabilities.entry(name).or_default() += set.probability;
            }
        }
        let groups = groups(&all, &probabilities);
        let mut told = 0.0;
        let mut is_told = |set: &Believed| {
            told += set.probability;
            told - set.probability < TOLD
        };
        let sets = all.into_iter().take(MOST_TOLD).take_while(|set| is_told(set)).collect();
        Self { sets, groups, probabilities }
    }

    /// Leaves a share of the probability to another explanation, beside which other sets are likely.
    pub fn share(&mut self, share: f64, other: &Self) {
        self.sets.iter_mut().for_each(|set| set.probability *= 1.0 - share);
        self.groups.iter_mut().for_each(|group| group.probability *= 1.0 - share);
        self.probabilities.values_mut().for_each(|own| *own *= 1.0 - share);
        for (name, own) in &other.probabilities {
            *self.probabilities.entry(name.clone()).or_default() += share * own;
        }
    }

    /// Takes a share of the probability from one effect.
    pub fn doubt(&mut self, name: &Name, share: f64) {
        self.probabilities.entry(name.clone()).and_modify(|own| *own *= 1.0 - share);
    }

    /// Probability of an effect.
    pub fn of(&self, name: &str) -> f64 {
        self.probabilities.get(name).map_or(0.0, |p| p.min(1.0))
    }

    /// Lets a search tell a set that has all of what is certain and as many of each group as there are for certain, where the one
    /// that it tells has not: the plainest of the most probable of those that do, if any of them may be true.
    pub fn tell_what_is_certain(&self, found: &mut SearchResult) {
        let name = |own: &usize| &found.candidates[*own].effect.name;
        let certain: Vec<usize> = (0..found.candidates.len()).filter(|own| self.of(name(own)) >= CERTAIN).collect();
        let has_all = |set: &CandidateModel| {
            let own = effects(set);
            let of_group = |group: &Group| own.iter().filter(|name| group.effects.contains(name)).count();
            certain.iter().all(|own| set.members.contains(own))
                && self.groups.iter().all(|group| of_group(group) >= group.at_least)
        };
        if has_all(found.best()) {
            return;
        }
        let mut with_all = found.tried.iter().filter(|set| has_all(&set.model)).peekable();
        let Some(least) = with_all.peek().filter(|set| may_be_true(found, &set.model)).map(|set| set.criterion) else {
            return;
        };
        let near = with_all.take_while(|set| set.criterion <= least + PLAINER);
        let told = near.min_by_key(|set| set.model.members.len()).map(|set| set.model.clone());
        if let Some(told) = told.filter(|told| told.objective.jacobian(&told.solution).is_some()) {
            found.tell(told);
        }
    }

    /// Whether the data speak for an effect.
    pub fn is_notable(&self, effect: &Description) -> bool {
        let before = effect.odds.to_one / (1.0 + effect.odds.to_one);
        speaks(self.of(&effect.name), before)
    }

    /// Whether two effects stand for each other in a group.
    pub fn are_grouped(&self, one: &Name, other: &Name) -> bool {
        self.groups.iter().any(|group| group.effects.contains(one) && group.effects.contains(other))
    }

    /// Effects that may be there, in no group, with their probabilities, the most probable first.
    pub fn open(&self) -> Vec<(Name, f64)> {
        let is_grouped = |name: &Name| self.groups.iter().any(|group| group.effects.contains(name));
        let is_open = |(name, p): &(&Name, &f64)| **p >= RULED_OUT && !is_grouped(name);
        let mut open: Vec<(Name, f64)> =
            self.probabilities.iter().filter(is_open).map(|(name, p)| (name.clone(), *p)).collect();
        open.sort_by(|a, b| b.1.total_cmp(&a.1));
        open
    }
}

/// Effects that are open and stand for each other, of which some are there.
fn groups(sets: &[Believed], probabilities: &BTreeMap<Name, f64>) -> Vec<Group> {
    let open: Vec<&Name> =
        probabilities.iter().filter(|(_, p)| (GROUPED..CERTAIN).contains(*p)).map(|(name, _)| name).collect();
    let together = |a: &Name, b: &Name| {
        let both = sets.iter().filter(|set| set.effects.contains(a) && set.effects.contains(b));
        both.map(|set| set.probability).sum::<f64>()
    };
    let are_rivals = |a: &Name, b: &Name| together(a, b) < INSTEAD * probabilities[a] * probabilities[b];
    let mut left = open;
    let mut groups = Vec::new();
    while let Some(first) = left.pop() {
        let mut members = vec![first];
        let mut next = 0;
        while next < members.len() {
            let own = members[next];
            let (rivals, others): (Vec<&Name>, Vec<&Name>) = left.into_iter().partition(|other| are_rivals(own, other));
            members.extend(rivals);
            left = others;
            next += 1;
        }
        let at_least = |count: usize| {
            let has = |set: &&Believed| members.iter().filter(|m| set.effects.contains(m)).count() >= count;
            sets.iter().filter(has).map(|set| set.probability).sum::<f64>()
        };
        let most = (1..=members.len()).rev().find(|count| at_least(*count) >= CERTAIN);
        if let Some(count) = most.filter(|_| members.len() > 1) {
            let mut effects: Vec<Name> = members.iter().map(|name| (*name).clone()).collect();
            effects.sort_by(|a, b| probabilities[b].total_cmp(&probabilities[a]));
            groups.push(Group { at_least: count, effects, probability: at_least(count).min(1.0) });
        }
    }
    groups
}
