//! Next measurement: the candidate experiment that tells most about which of the sets that fit is true (Bayesian design
//! of experiments).

use rayon::prelude::*;

use super::confounding::{Confounding, SEPARATE};
use super::contender::{Contender, contenders, entropy};
use super::look_alike::LookAlike;
use super::posterior::Posterior;
use super::prospect::Prospect;
use super::search::SearchResult;
use crate::process::{CandidateExperiment, Description, System};

/// Numbers of repeats of an experiment that are considered.
pub const REPEATS: &[usize] = &[1, 2, 4, 8];
/// Information below which an experiment is not worth the making, nats: one set of ten is expected to be ruled out.
const LEAST: f64 = 0.1;
/// Most experiments that are made one after the other as one measurement.
const STEPS: usize = 4;
/// Most rows of one measurement of several experiments, or of one that is repeated.
const MOST_ROWS: usize = 600;
/// Part of the most that any experiment tells which is enough for one that costs less to be preferred.
const ENOUGH: f64 = 0.9;
/// Squared distance, in standard uncertainties, from which sets that stay confounded are brought farther apart.
const HELPED: f64 = 1.0;

/// Measurement to make next.
#[derive(Clone, Debug)]
pub struct Next {
    /// Experiment to make.
    pub experiment: CandidateExperiment,
    /// Number of experiments of the process of which it consists, one after the other.
    pub steps: usize,
    /// Number of repeats of each of its rows.
    pub repeats: usize,
    /// Pairs of effects that it tells apart, or, where it is not enough, brings farther apart; those that stand for
    /// each other in the most probable sets first.
    pub pairs: Vec<(Description, Description)>,
    /// Effects of which it tells whether they are there.
    pub whether: Vec<Description>,
    /// Separation of the worst of them, in standard uncertainties.
    pub separation: f64,
    /// Whether that separation is enough to tell them apart.
    pub enough: bool,
    /// As how many equally probable sets those that fit now count, and those that are expected to be left; of a plan,
    /// which has no sets, nothing.
    pub sets: Option<(f64, f64)>,
}

impl Next {
    /// Number of rows, repeats included.
    pub fn observations(&self) -> usize {
        self.repeats * self.experiment.rows.len()
    }

    /// Time that it costs, s.
    pub fn cost(&self) -> f64 {
        self.experiment.cost(self.repeats)
    }
}

/// Chooses the experiment that tells most, or the cheapest of those that tell nearly as much; several are made one after the
/// other where that tells more. `None` where one set is certain, or no experiment would help.
pub fn next(
    found: &SearchResult,
    confoundings: &[Confounding],
    look_alikes: &[LookAlike],
    posterior: &Posterior,
) -> Option<Next> {
    let data = found.base.objective.data;
    let system = &*data.model.system;
    let contenders = contenders(found, confoundings, look_alikes, posterior);
    let entropy = entropy(&contenders);
    if entropy < LEAST {
        return None;
    }
    let experiments = system.candidate_experiments(&data.rows);
    let singles: Vec<Rated> =
        experiments.into_par_iter().filter_map(|experiment| Rated::new(&contenders, experiment)).collect();
    let combined = combined(system, &singles);
    let of = |own| REPEATS.iter().map(move |repeats| (own, *repeats, Rated::tells(own, *repeats)));
    let all: Vec<(&Rated, usize, f64)> =
        singles.iter().chain(&combined).flat_map(of).filter(|own| own.0.can_be_repeated(own.1)).collect();
    let most = all.iter().map(|own| own.2).fold(0.0, f64::max);
    let cost = |own: &(&Rated, usize, f64)| own.0.experiment.cost(own.1);
    let is_enough = |own: &&(&Rated, usize, f64)| own.2 >= LEAST.max(ENOUGH * most);
    let chosen = all.iter().filter(is_enough).min_by(|a, b| cost(a).total_cmp(&cost(b)).then(b.2.total_cmp(&a.2)));
    let (rated, repeats, tells) = chosen?;
    Some(rated.next(*repeats, (entropy.exp(), (entropy - tells).max(0.0).exp())))
}

/// Experiments one after the other: the one that tells most, and each time that with which it tells most.
fn combined<'c, 'r, 'a>(system: &dyn System, singles: &[Rated<'c, 'r, 'a>]) -> Vec<Rated<'c, 'r, 'a>> {
    let best = |all: Vec<(usize, Rated<'c, 'r, 'a>)>| {
        let told: Vec<f64> = all.par_iter().map(|own| own.1.tells(1)).collect();
        let all = all.into_iter().zip(told);
        all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(own, _)| own)
    };
    let mut chain: Vec<Rated> = Vec::new();
    let Some((first, mut last)) = best(singles.iter().cloned().enumerate().collect()) else { return chain };
    let mut left: Vec<usize> = (0..singles.len()).filter(|i| *i != first).collect();
    while chain.len() + 1 < STEPS {
        let more = left.iter().filter_map(|i| Some((*i, last.and(&singles[*i], system)?)));
        let Some((added, longer)) = best(more.collect()) else { break };
        left.retain(|i| *i != added);
        last = longer.clone();
        chain.push(longer);
    }
    chain
}

/// An experiment with what it is expected to tell.
#[derive(Clone)]
struct Rated<'c, 'r, 'a> {
    experiment: CandidateExperiment,
    steps: usize,
    /// The sets that can be computed at its rows, in the order of the prospect.
    seen: Vec<&'c Contender<'r, 'a>>,
    prospect: Prospect,
}

impl<'c, 'r, 'a> Rated<'c, 'r, 'a> {
    /// Of sets that cannot be computed at its rows nothing is expected.
    fn new(contenders: &'c [Contender<'r, 'a>], experiment: CandidateExperiment) -> Option<Self> {
        let of = |own: &'c Contender<'r, 'a>| Some((own, (own.weight, own.columns(&experiment.rows)?)));
        let (seen, predictions): (Vec<_>, Vec<_>) = contenders.iter().filter_map(of).unzip();
        let prospect = Prospect::new(predictions)?;
        Some(Self { experiment, steps: 1, seen, prospect })
    }

    /// The same and then another.
    fn and(&self, other: &Self, system: &dyn System) -> Option<Self> {
        let is_same = |(one, other): (&&Contender, &&Contender)| std::ptr::addr_eq(*one, *other);
        let are_same = self.seen.len() == other.seen.len() && self.seen.iter().zip(&other.seen).all(is_same);
        let experiment = are_same.then(|| system.in_sequence(&self.experiment, &other.experiment)).flatten()?;
        let prospect = self.prospect.and(&other.prospect);
        Some(Self { experiment, steps: self.steps + other.steps, seen: self.seen.clone(), prospect })
    }

    /// Whether so many repeats are not too much for one measurement.
    fn can_be_repeated(&self, repeats: usize) -> bool {
        self.steps * repeats == 1 || repeats * self.experiment.rows.len() <= MOST_ROWS
    }

    /// What it tells, nats.
    fn tells(&self, repeats: usize) -> f64 {
        self.prospect.information(|i, j| self.seen[i].asked == self.seen[j].asked, repeats)
    }

    /// Effects in which two sets differ by one, with the squared distance of these sets; those of the most probable sets
    /// first.
    fn differences(&self, repeats: usize) -> Vec<(Difference<'c>, f64)> {
        let mut all: Vec<(f64, Difference, f64)> = Vec::new();
        for (i, one) in self.seen.iter().enumerate() {
            for (j, other) in self.seen.iter().enumerate().filter(|(_, other)| other.asked != one.asked) {
                let Some(difference) = Difference::between(&one.effects, &other.effects) else { continue };
                let Some((distance, _)) = self.prospect.apart(i, j, repeats as f64) else { continue };
                all.push((one.weight * other.weight, difference, distance));
            }
        }
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        all.into_iter().map(|(_, difference, distance)| (difference, distance)).collect()
    }

    /// The measurement to make, of what counts as so many equally probable sets.
    fn next(&self, repeats: usize, sets: (f64, f64)) -> Next {
        let differences = self.differences(repeats);
        let is_told = |own: &&(Difference, f64)| own.1 >= SEPARATE;
        let enough = differences.iter().any(|own| is_told(&own));
        let is_helped = |own: &&(Difference, f64)| if enough { is_told(own) } else { own.1 > HELPED };
        let experiment = self.experiment.clone();
        let (pairs, whether, separation) = (Vec::new(), Vec::new(), f64::INFINITY);
        let mut next =
            Next { experiment, steps: self.steps, repeats, pairs, whether, separation, enough, sets: Some(sets) };
        for (difference, distance) in differences.iter().filter(is_helped) {
            if next.tell(difference) {
                next.separation = next.separation.min(distance.sqrt());
            }
        }
        next
    }
}

impl Next {
    /// Takes note of what it tells; whether that is new.
    fn tell(&mut self, difference: &Difference) -> bool {
        match *difference {
            Difference::Instead(a, b) => {
                let is_known = |(p, q): &(Description, Description)| (p, q) == (a, b) || (p, q) == (b, a);
                let is_new = !self.pairs.iter().any(is_known);
                is_new.then(|| self.pairs.push((a.clone(), b.clone())));
                is_new
            }
            Difference::Beside(a) => {
                let is_new = !self.whether.contains(a);
                is_new.then(|| self.whether.push(a.clone()));
                is_new
            }
        }
    }
}

/// In which one effect two sets differ.
enum Difference<'e> {
    /// One in the place of the other.
    Instead(&'e Description, &'e Description),
    /// One more.
    Beside(&'e Description),
}

impl<'e> Difference<'e> {
    fn between(one: &'e [Description], other: &'e [Description]) -> Option<Self> {
        let only = |a: &'e [Description], b: &[Description]| a.iter().filter(|e| !b.contains(e)).collect::<Vec<_>>();
        match (&only(one, other)[..], &only(other, one)[..]) {
            ([a], [b]) => Some(Self::Instead(a, b)),
            ([a], []) => Some(Self::Beside(a)),
            _ => None,
        }
    }
}
