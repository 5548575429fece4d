//! Weighs effects of the measurement against those of the machine: a search under every noise that the
//! residuals ask for.

use std::cell::RefCell;

use super::candidate_model::{CandidateModel, Weighed};
use super::failure::unsolvable;
use super::few_places::few_places;
use super::hypothesis::{Hypothesis, is_greedy, stands_or_falls};
use super::instrument::{self, Proposal};
use super::null_distribution::variance;
use super::pool::NoiseChange;
use super::posterior::Visit;
use super::search::{Extent, PLAINER, SIGNIFICANCE, SearchResult};
use super::settle::{SETTLED, look_until_settled};
use super::verdict::is_explained;
use crate::fit::{Objective, Solution};
use crate::measure::Repeats;
use crate::noise::MeasurementEffect;
use crate::noise::{PROMISING, is_round_off};
use crate::process::{Description, Failure, Holds};
use crate::progress::Progress;

/// Most effects of the measurement that are sought.
const MOST_TERMS: usize = 3;
/// Fall of −2 ln L, beyond its price, from which a curve is kept, which could be anything.
const DESCRIBED: f64 = 15.0;
/// Rise of −2 ln L up to which a term is tried in the place of all effects of the machine.
const INSTEAD: f64 = 15.0;
/// Terms of which each is tried in a search of its own.
const TOGETHER: usize = 3;
/// Ratio of two sizes of a term up to which they are neighbours.
const NEIGHBOUR: f64 = 2.0;
/// Fall of −2 ln L from which a curve is told in the place of causes that stand on few places: odds of ten to one.
const CLEAR: f64 = 4.6;
/// Searches in which the sizes of terms settle.
const ROUNDS: usize = 2;

/// Name of the search for effects of the measurement, for the note that it was left undone.
const MEASUREMENT: &str = "effects of the measurement";

/// Constants of a search over noises.
pub struct Exploration<'e> {
    /// Minimum of the model alone, where every search begins.
    pub start: &'e Solution,
    /// Effects that the model does not have.
    pub absent: &'e [Description],
    /// Repeats of the rows, whatever the terms.
    pub repeats: &'e Repeats,
    /// Most effects that are sought together.
    pub most: usize,
    /// Where progress is told.
    pub progress: &'e Progress,
    /// All sets that were visited, under whatever noise.
    pub visits: &'e RefCell<Vec<Visit>>,
}

impl Exploration<'_> {
    /// Looks for effects of the measurement together with those of the machine: terms are added to the noise one
    /// after another, the most promising first, and everything is sought again under each, as long as the
    /// likelihood rises by more than its price. The first hypothesis comes first, the best last.
    pub fn weigh<'a>(&self, first: Hypothesis<'a>) -> Result<Vec<Hypothesis<'a>>, Failure> {
        let best = first.found.best();
        if is_round_off(&best.residuals(), &best.objective.data.observed) {
            return Ok(vec![first]);
        }
        let mut path = vec![first];
        if !self.progress.permits(MEASUREMENT) {
            return Ok(path);
        }
        // Rows that contradict their own repeats are wrong whatever the model says.
        let wrong = path.first().and_then(|first| instrument::contradictions(&first.found.base, self.repeats));
        if let (Some(wrong), Some(first)) = (wrong, path.first()) {
            let without = self.under(&first.found, wrong)?;
            if !self.progress.permits(MEASUREMENT) {
                return Ok(path);
            }
            path.push(without);
        }
        self.grow(&mut path, |_| true)?;
        if path.last().is_some_and(|h| h.stands_or_falls() && !h.explains) {
            // What could swallow everything and does not is no reason to overlook the others.
            while path.len() > 1 && path.last().is_some_and(Hypothesis::stands_or_falls) {
                path.pop();
            }
            self.grow(&mut path, |proposal| !stands_or_falls(&proposal.noise.terms))?;
        }
        if path.last().is_some_and(|h| !h.found.best().members.is_empty()) {
            let alone = path.first().map_or(Ok(None), |first| self.alone(first))?;
            let criterion = path.last().map_or(f64::INFINITY, |h| h.criterion);
            path.extend(alone.filter(|alone| alone.explains && alone.criterion < criterion));
        }
        self.last_resort(path)
    }

    /// Adds terms to the model alone, one after another, and searches under those that explain everything together:
    /// several zeros that were set anew can look like effects of the machine as long as one of them is missing.
    fn alone<'a>(&self, first: &Hypothesis<'a>) -> Result<Option<Hypothesis<'a>>, Failure> {
        let mut trial = first.found.base.clone();
        let mut found = None;
        for _ in 0..MOST_TERMS {
            if !self.progress.permits(MEASUREMENT) {
                break;
            }
            let least = instrument::criterion(&trial) - PROMISING;
            let is_wanted = |p: &Proposal| p.criterion < least && !is_greedy(&p.noise.terms);
            let Some(proposal) = instrument::proposals(&trial, self.repeats).into_iter().find(is_wanted) else { break };
            trial.objective.noise = proposal.noise.clone();
            let Some(resized) = instrument::resized(&trial, self.repeats) else { break };
            trial = resized;
            found = Some(proposal);
        }
        let explains = |proposal: &Proposal| is_explained(&trial, &proposal.repeats);
        found.filter(explains).map(|proposal| self.under(&first.found, proposal)).transpose()
    }

    /// Adds terms that are wanted to the last hypothesis, one after another, as long as they are worth it.
    fn grow<'a>(&self, path: &mut Vec<Hypothesis<'a>>, is_wanted: impl Fn(&Proposal) -> bool) -> Result<(), Failure> {
        for _ in 0..MOST_TERMS {
            if !self.progress.permits(MEASUREMENT) {
                break;
            }
            let Some(here) = path.last() else { break };
            let mut proposals = instrument::proposals(here.found.best(), self.repeats);
            proposals.retain(|p| p.criterion < here.criterion - PROMISING);
            if !here.found.best().members.is_empty() {
                let instead = instrument::proposals(&here.found.base, self.repeats);
                proposals.extend(instead.into_iter().filter(|p| p.criterion < here.criterion + INSTEAD));
            }
            proposals.retain(&is_wanted);
            let Some(better) = self.further(here, proposals, PROMISING)? else { break };
            path.push(better);
        }
        Ok(())
    }

    /// Searches widely where structure remains, and beside a curve over places that no law here has, by which
    /// causes are judged; leaves out what cannot be believed.
    fn last_resort<'a>(&self, mut path: Vec<Hypothesis<'a>>) -> Result<Vec<Hypothesis<'a>>, Failure> {
        if !self.progress.permits("the wider search, and what is left out again") {
            return Ok(path);
        }
        let Some(mut last) = path.pop() else { return Err(unsolvable()) };
        let hardly = few_places(last.found.best()).is_some();
        if !last.explains || hardly {
            let curves = instrument::curves(last.found.best(), self.repeats);
            let bare = instrument::curves(&last.found.base, self.repeats);
            // A curve by place and direction that is sized without play takes up the play, which is not seen beside
            // it any more.
            let singles = last.found.singles.iter().flatten().filter(|single| goes_by_words(single, &last.found.base));
            let beside = singles.flat_map(|single| instrument::curves(single, self.repeats));
            let least = last.criterion + INSTEAD;
            let curves = curves.into_iter().chain(bare).chain(beside).filter(|p| p.criterion < least).collect();
            // A law that bends describes too, and a curve has to describe better.
            let least = if hardly { CLEAR } else { DESCRIBED };
            if let Some(beside) = self.further(&last, curves, least)? {
                path.push(std::mem::replace(&mut last, beside));
            }
        }
        path.push(self.eliminated(last)?);
        Ok(path)
    }

    /// Leaves out terms that are not worth their price any more, beside what was found after them.
    fn eliminated<'a>(&self, mut last: Hypothesis<'a>) -> Result<Hypothesis<'a>, Failure> {
        loop {
            let rest = instrument::with_a_term_less(last.found.best(), self.repeats);
            let most = last.criterion + PROMISING;
            let Some(rest) = rest.into_iter().find(|rest| rest.criterion < most) else { return Ok(last) };
            let without = self.under(&last.found, rest)?;
            if !self.progress.permits(MEASUREMENT) {
                return Ok(last);
            }
            if without.criterion > most || last.explains && !without.explains {
                return Ok(last);
            }
            last = without;
        }
    }

    /// The best hypothesis with one term more, of those that are worth a search and better by more than `least`; else `None`.
    fn further<'a>(
        &self,
        here: &Hypothesis<'a>,
        mut proposals: Vec<Proposal>,
        least: f64,
    ) -> Result<Option<Hypothesis<'a>>, Failure> {
        proposals.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        let mut all: Vec<Hypothesis> = Vec::new();
        let mut looked: Vec<(&MeasurementEffect, f64)> = Vec::new();
        for proposal in proposals {
            if !self.progress.permits(MEASUREMENT) {
                break;
            }
            // The best of each effect is looked at: their neighbours would say the same.
            let Some(newest) = proposal.noise.terms.last() else { continue };
            let is_neighbour = |own: &(&MeasurementEffect, f64)| {
                own.0 == newest.effect && (1.0 / NEIGHBOUR..NEIGHBOUR).contains(&(own.1 / newest.size))
            };
            if looked.len() == TOGETHER || looked.iter().any(is_neighbour) {
                continue;
            }
            looked.push((newest.effect, newest.size));
            if all.iter().any(|b| b.explains && proposal.criterion > b.criterion + INSTEAD) {
                // What explains everything is not likely to be beaten from so far behind.
                continue;
            }
            let own = self.under(&here.found, proposal)?;
            // A search that was cut off says nothing about its noise.
            if self.progress.permits(MEASUREMENT) {
                all.push(own);
            }
        }
        all.sort_by(|a, b| a.least.total_cmp(&b.least));
        let is_better = |h: &Hypothesis| h.least < here.least - least;
        let Some(best) = all.first().filter(|h| is_better(h)) else { return Ok(None) };
        let near = best.least + PLAINER;
        let causes = |h: &Hypothesis| h.found.best().members.len() + h.found.best().objective.noise.terms.len();
        Ok(all.into_iter().filter(|h| h.criterion <= near).min_by_key(causes))
    }

    /// Searches under a noise; its sizes are settled with what is found. The search begins with what an earlier
    /// one has found.
    fn under<'a>(&self, earlier: &SearchResult<'a>, proposal: Proposal) -> Result<Hypothesis<'a>, Failure> {
        self.progress.stretch("searches under further terms", || self.searched_under(earlier, proposal))
    }

    fn searched_under<'a>(&self, earlier: &SearchResult<'a>, proposal: Proposal) -> Result<Hypothesis<'a>, Failure> {
        let mut objective = earlier.base.objective.clone();
        let mut solution = self.start.clone();
        let mut within = proposal.repeats;
        objective.noise = proposal.noise;
        let mut look =
            |objective: &mut Objective<'a>, within: &Repeats, (known, noise): (&[Weighed<'a>], NoiseChange)| {
                let (most, progress) = (self.most, self.progress);
                let extent = Extent { most, deepens: false, known, noise, progress };
                look_until_settled(objective, &mut solution, self.absent, within, extent)
            };
        let mut found = look(&mut objective, &within, (&earlier.tried, NoiseChange::Terms))?;
        for _ in 0..ROUNDS {
            if !self.progress.permits(MEASUREMENT) {
                break;
            }
            let Some((noise, own)) = instrument::settled(found.best(), self.repeats) else { break };
            let sizes = noise.terms.iter().zip(&found.best().objective.noise.terms);
            let is_settled = sizes.into_iter().all(|(a, b)| (1.0 / SETTLED..SETTLED).contains(&(a.size / b.size)));
            (objective.noise, within) = (noise, own);
            let change = NoiseChange::of_size(is_settled);
            found = look(&mut objective, &within, (&std::mem::take(&mut found.tried), change))?;
            if is_settled {
                break;
            }
        }
        self.take_back(&mut found);
        let own = Hypothesis::new(found, within);
        // What is believed only where it explains everything says nothing where it does not.
        if own.explains || !own.stands_or_falls() {
            self.visits.borrow_mut().extend(Visit::all(&own.found, &own.bent));
        }
        Ok(own)
    }

    /// Takes back effects that gain no more than chance gives once the noise is sized without them too: a
    /// correlation that was sized beside an effect is too short to weigh that very effect.
    fn take_back(&self, found: &mut SearchResult) {
        while let Some((last, rest)) = found.steps.split_last() {
            if !is_greedy(&last.objective.noise.terms) {
                return;
            }
            let before = rest.last().unwrap_or(&found.base);
            let Some(without) = instrument::resized(before, self.repeats) else { return };
            let gained = instrument::minus_two_log(&without) - instrument::minus_two_log(last);
            let variance = variance(&last.objective.noise, self.repeats);
            let statistic = variance.statistic(gained, last.solution.chi2, last.objective.freedom());
            if found.first_null_distribution.p_value(statistic) < SIGNIFICANCE {
                return;
            }
            found.steps.pop();
        }
    }
}

/// Whether what an effect adds is the same at every place, and differs from one direction or branch to the other.
fn goes_by_words(single: &CandidateModel, base: &CandidateModel) -> bool {
    let data = base.objective.data;
    let coordinates = data.model.process.coordinates();
    let words = data.given.iter().copied().filter(|i| matches!(coordinates[*i].holds, Holds::Word(_)));
    let levels = data.levels(&words.collect::<Vec<_>>());
    single.goes_by(base, &levels)
}
