//! Searches for the missing effects: sets of effects grow while the gain is more than chance gives (beam
//! search).
//!
//! Forward selection, the best effect and then the next best, picks wrong pairs where sensitivities are
//! alike. So several sets of every size are re-fitted with all parameters free; all pairs are screened, and
//! larger sets grow from the best of the smaller ones.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;

use super::candidate_model::CandidateModel;
use super::lead::{Lead, fit_from, is_worth_a_fit, leads, refit, together, without};
use super::null_distribution::{MaxStatistic, Variance};
use super::pairs;
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::sensitivity::CandidateEffect;
use crate::progress::Progress;

/// Significance level: a set grows when chance alone gives as much in a smaller part of searches.
pub const SIGNIFICANCE: f64 = 0.01;
/// Breadth of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breadth {
    /// Number of sets from which larger ones grow (beam width).
    beam: usize,
    /// Number of sets that are re-fitted.
    refitted: usize,
}

impl Breadth {
    /// Breadth that is enough as a rule.
    pub const USUAL: Self = Self { beam: 6, refitted: 12 };
    /// Breadth where the usual one left structure: strong effects that are far from linear hide behind
    /// others.
    pub const WIDE: Self = Self { beam: 20, refitted: 60 };
}

/// How far a search goes, and what it knows beforehand.
#[derive(Clone, Copy)]
pub struct Extent<'e, 'a> {
    /// Most effects that are sought together.
    pub most: usize,
    /// Breadth.
    pub breadth: Breadth,
    /// Whether the best set, where it leaves structure, is brought to the deepest minimum that the profiles of
    /// its parameters come upon: as dear as the search itself.
    pub deepens: bool,
    /// Sets that an earlier search has fitted, under another noise.
    pub known: &'e [CandidateModel<'a>],
    /// Where progress is told.
    pub progress: &'e Progress,
}

/// Stretch of the null distributions.
const CHANCE: &str = "what chance gives";

/// Most rounds in which an effect of a set is exchanged.
const EXCHANGES: usize = 4;

/// Result of a search.
#[derive(Clone)]
pub struct SearchResult<'a> {
    /// Model without any candidate effect.
    pub base: CandidateModel<'a>,
    /// Candidate effects that were sought.
    pub candidates: Vec<CandidateEffect>,
    /// Most effects that were sought together.
    pub most: usize,
    /// Best set of each size, as long as the gain was significant.
    pub steps: Vec<CandidateModel<'a>>,
    /// Model with each candidate effect alone, where it can be computed.
    pub singles: Vec<Option<CandidateModel<'a>>>,
    /// All candidate models that were fitted.
    pub tried: Vec<CandidateModel<'a>>,
    /// Null distribution of the gain of the first effect.
    pub first_null_distribution: MaxStatistic,
    /// Null distribution of the gain of one effect more, on the last set.
    pub null_distribution: MaxStatistic,
}

impl<'a> SearchResult<'a> {
    /// Best set; the model itself where nothing was found.
    pub fn best(&self) -> &CandidateModel<'a> {
        self.steps.last().unwrap_or(&self.base)
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
    let Extent { most, breadth, known, progress, .. } = extent;
    let everyone: Vec<&CandidateEffect> = candidates.iter().collect();
    let projected = ProjectedResidual::new(&mut base.objective.clone(), &base.solution)?;
    let (screening, first_null_distribution) = progress.stretch(CHANCE, || {
        let screening = Screening::new(&projected, &everyone);
        let first = MaxStatistic::simulate(&screening, projected.freedom, variance);
        (screening, first)
    });
    let mut null_distribution = first_null_distribution.clone();
    // The map keeps an order, so that the same data always give the same answer.
    let mut tried: BTreeMap<Vec<usize>, CandidateModel<'a>> = BTreeMap::new();
    let mut beam = vec![base.clone()];
    let mut steps: Vec<CandidateModel<'a>> = Vec::new();
    let mut singles = Vec::new();
    progress.expect(most as u64);
    for size in 1..=most.max(1) {
        if size > 1 && !progress.permits(&format!("sets of {size} effects")) {
            break;
        }
        let mut leads = progress.stretch("sets worth fitting", || {
            let mut leads: Vec<Lead> = beam.par_iter().flat_map_iter(|parent| leads(parent, &candidates)).collect();
            if size == 2 {
                let pairs = pairs::pairs(&screening);
                for lead in &mut leads {
                    lead.look_at(&pairs, &base, projected.residual.norm_squared(), &candidates);
                }
            }
            leads
        });
        leads.sort_by(|a, b| a.promised.total_cmp(&b.promised));
        let mut seen = BTreeSet::new();
        leads.retain(|lead| seen.insert(lead.key()));
        leads.truncate(if size == 1 { usize::MAX } else { breadth.refitted });
        let fits = if size == 1 { "fits of one effect" } else { "fits of larger sets" };
        let fitted: Vec<CandidateModel<'a>> =
            progress.stretch(fits, || leads.par_iter().filter_map(|lead| refit(lead, &candidates, known)).collect());
        drop(leads);
        if size == 1 {
            let of = |i: usize| fitted.iter().find(|t| t.members == [i]).cloned();
            singles = (0..candidates.len()).map(of).collect();
        }
        beam = fitted.clone();
        beam.sort_by(|a, b| a.penalised_bic().total_cmp(&b.penalised_bic()));
        tried.extend(beam.iter().map(|t| (t.key(), t.clone())));
        let Some(mut best) = beam.first().cloned() else { break };
        if size > 1 {
            beam.truncate(breadth.beam);
            let exchanged = || exchange(&base, &candidates, best, &mut tried, extent);
            best = progress.stretch("exchanges of effects", exchanged);
            tried.insert(best.key(), best.clone());
            beam.insert(0, best.clone());
            beam.dedup_by_key(|t| t.key());
        }
        let before = steps.last().unwrap_or(&base);
        if !grows(before, &fitted, &best, &null_distribution, variance, candidates.len()) {
            break;
        }
        steps.push(best.clone());
        progress.advance(1);
        let beside = progress.stretch(CHANCE, || {
            let projected = ProjectedResidual::new(&mut best.objective.clone(), &best.solution)?;
            let others = candidates.iter().enumerate().filter(|(i, _)| !best.members.contains(i)).map(|(_, c)| c);
            let others = Screening::new(&projected, &others.collect::<Vec<_>>());
            Some(MaxStatistic::simulate(&others, projected.freedom, variance))
        });
        let Some(beside) = beside else { break };
        null_distribution = beside;
    }
    progress.advance((most.max(1) - steps.len()) as u64);
    let left_out = || prune(&base, &candidates, &mut steps, &tried, &null_distribution, variance);
    progress.stretch("effects left out again", left_out);
    Some(SearchResult {
        base,
        candidates,
        most,
        steps,
        singles,
        tried: tried.into_values().collect(),
        first_null_distribution,
        null_distribution,
    })
}

/// Leaves out effects that the best set does not need, found before others took their place (backward
/// elimination).
fn prune<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    steps: &mut [CandidateModel<'a>],
    tried: &BTreeMap<Vec<usize>, CandidateModel<'a>>,
    null_distribution: &MaxStatistic,
    variance: Variance,
) {
    let Some(best) = steps.last_mut() else { return };
    while best.members.len() > 1 {
        let all: Vec<_> = best.members.par_iter().filter_map(|m| smaller(base, candidates, best, *m, tried)).collect();
        let Some(least) = all.into_iter().min_by(|a, b| a.solution.chi2.total_cmp(&b.solution.chi2)) else { return };
        let gained = least.solution.chi2 - best.solution.chi2;
        let p_value =
            null_distribution.p_value(variance.statistic(gained, best.solution.chi2, best.objective.freedom()));
        if p_value < SIGNIFICANCE && best.penalised_bic() < least.penalised_bic() {
            return;
        }
        *best = least;
    }
}

/// Whether a larger set is needed: one effect more gains more than chance gives to a search as wide, or
/// another set gains so much that chance would not give it to any of as many; and the penalised BIC falls.
fn grows(
    before: &CandidateModel,
    fitted: &[CandidateModel],
    best: &CandidateModel,
    null_distribution: &MaxStatistic,
    variance: Variance,
    candidates: usize,
) -> bool {
    let p_value = |larger: &CandidateModel| {
        let gained = before.solution.chi2 - larger.solution.chi2;
        null_distribution.p_value(variance.statistic(gained, larger.solution.chi2, larger.objective.freedom()))
    };
    let nested = fitted.iter().filter(|t| before.members.iter().all(|m| t.members.contains(m)));
    let p_nested = nested.map(p_value).fold(1.0, f64::min);
    let sets = (0..best.members.len()).map(|i| (candidates - i) as f64 / (i + 1) as f64).product::<f64>();
    let p_other = p_value(best) * sets / (candidates - before.members.len()).max(1) as f64;
    p_nested.min(p_other) < SIGNIFICANCE && best.penalised_bic() < before.penalised_bic()
}

/// Exchanges one effect of a set for another, or for itself in another variant, or two for themselves in
/// other variants, as long as the set becomes better by it.
fn exchange<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    mut best: CandidateModel<'a>,
    tried: &mut BTreeMap<Vec<usize>, CandidateModel<'a>>,
    Extent { breadth, known, .. }: Extent<'_, 'a>,
) -> CandidateModel<'a> {
    for _ in 0..EXCHANGES {
        if !base.objective.data.progress.permits("exchanges of one effect for another") {
            break;
        }
        let smaller: Vec<CandidateModel> =
            best.members.par_iter().filter_map(|m| smaller(base, candidates, &best, *m, tried)).collect();
        let mut leads: Vec<Lead> = smaller.par_iter().flat_map_iter(|parent| leads(parent, candidates)).collect();
        let before = |lead: &Lead| tried.get(&lead.key());
        let is_open = |lead: &Lead, known: &CandidateModel| {
            is_worth_a_fit(&known.objective, known.solution.chi2, lead.believed(known.kept))
        };
        leads.retain(|lead| before(lead).is_none_or(|known| is_open(lead, known)));
        leads.sort_by(|a, b| a.promised.total_cmp(&b.promised));
        leads.truncate(breadth.refitted);
        let mut fitted: Vec<CandidateModel> =
            leads.par_iter().filter_map(|lead| refit(lead, candidates, known)).collect();
        if best.members.len() > 2 {
            fitted.extend(reseated(base, candidates, &best, tried));
        }
        fitted.sort_by(|a, b| a.penalised_bic().total_cmp(&b.penalised_bic()));
        // The next search under such a noise need not fit them again.
        for set in &fitted {
            let chi2 = tried.get(&set.key()).map_or(f64::INFINITY, |t| t.solution.chi2);
            if set.solution.chi2 < chi2 {
                tried.insert(set.key(), set.clone());
            }
        }
        let Some(better) = fitted.into_iter().next() else { break };
        if better.penalised_bic() >= best.penalised_bic() {
            break;
        }
        best = better;
    }
    best
}

/// Re-fits a set with every two of its effects started in the variants with the largest joint gain beside
/// the rest.
fn reseated<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    set: &CandidateModel<'a>,
    tried: &BTreeMap<Vec<usize>, CandidateModel<'a>>,
) -> Vec<CandidateModel<'a>> {
    let members = set.key();
    let twos: Vec<[usize; 2]> =
        (0..members.len()).flat_map(|j| (0..j).map(move |i| [i, j])).map(|two| two.map(|i| members[i])).collect();
    let reseat = |two: &[usize; 2]| {
        let rest = smaller(base, candidates, set, two[0], tried)?;
        let rest = smaller(base, candidates, &rest, two[1], tried)?;
        let projected = ProjectedResidual::new(&mut rest.objective.clone(), &rest.solution)?;
        let pairs = pairs::pairs(&Screening::new(&projected, &two.map(|i| &candidates[i])));
        let pair = pairs.get(&(0, 1))?;
        let believed = rest.solution.chi2 - set.kept * pair.delta_chi2();
        if !is_worth_a_fit(&set.objective, set.solution.chi2, believed) {
            return None;
        }
        let start = together(&rest, pair, *two, candidates);
        let objective = rest.objective.with(&candidates[two[0]].effect).with(&candidates[two[1]].effect);
        fit_from(&rest, two, objective, [start], None)
    };
    twos.par_iter().filter_map(reseat).collect()
}

/// The set without one of its members, as it was tried before or fitted now.
fn smaller<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    set: &CandidateModel<'a>,
    member: usize,
    tried: &BTreeMap<Vec<usize>, CandidateModel<'a>>,
) -> Option<CandidateModel<'a>> {
    let rest: Vec<usize> = set.key().into_iter().filter(|m| *m != member).collect();
    tried.get(&rest).cloned().or_else(|| without(base, candidates, set, member))
}
