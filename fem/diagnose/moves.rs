//! Moves from one set of effects to another, ranked by the linear model of the prediction about the first: an effect more,
//! one less, one in the place of another, and two where one was or none.

use nalgebra::{DMatrix, DVector};

use super::candidate_model::{self, CandidateModel};
use super::change;
use super::gain::Gain;
use super::pairs::pairs;
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::sensitivity::CandidateEffect;
use crate::fit::{Objective, SearchVariable, Solution, StoppingCriterion, resume};
use crate::process::ON_TRIAL;

/// Starts of a fit: the best variants of an effect, each of another neighbourhood.
const STARTS: usize = 2;
/// Variants of an effect of which pairs are made.
const PAIRED: usize = 6;
/// Most moves by two effects from one set.
const PAIRS: usize = 12;
/// Most halvings of a start at which the model cannot be computed.
const HALVINGS: usize = 5;
/// χ² of the priors above which a fit also starts from the prior values.
const BENT: f64 = 9.0;
/// Stopping criterion of a few steps, after which only the best of several starts goes on.
const AHEAD: StoppingCriterion = StoppingCriterion::rough(6, 1e-3);
/// Stopping criterion that is enough to rank sets; the last set is fitted to full convergence.
pub const SEARCHING: StoppingCriterion = StoppingCriterion::rough(15, 1e-3);

/// A change of a set.
#[derive(Clone, Debug)]
pub struct Move {
    /// Members of the new set, in rising order.
    pub key: Vec<usize>,
    /// Member that is left out.
    pub dropped: Option<usize>,
    /// Effects that are added.
    pub added: Vec<usize>,
    /// Variants of the added effects with their amplitudes, a list for every start.
    starts: Vec<Vec<(usize, Vec<f64>)>>,
    /// χ² to first order.
    pub promised: f64,
}

/// How far moves go.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Reach {
    /// One effect more, less, or in the place of another.
    One,
    /// Also two more, or two in the place of one.
    Two,
}

/// All moves from a set to sets of no more than `most` effects, without those that cannot be seen.
pub fn moves(
    parent: &CandidateModel,
    candidates: &[CandidateEffect],
    is_unseen: &[bool],
    (most, reach): (usize, Reach),
) -> Vec<Move> {
    let Some(jacobian) = parent.jacobian() else { return Vec::new() };
    let mut all = Vec::new();
    for dropped in std::iter::once(None).chain(parent.members.iter().copied().map(Some)) {
        let stays = |m: &&usize| Some(**m) != dropped;
        let kept = || parent.members.iter().filter(stays).map(|m| &candidates[*m].effect);
        if dropped.is_some_and(|own| kept().any(|other| other.is_change_of(&candidates[own].effect.name))) {
            // What changes is there.
            continue;
        }
        let projected = without(parent, &jacobian, candidates, dropped);
        let size = parent.members.len() - usize::from(dropped.is_some());
        let chi2 = projected.residual.norm_squared();
        let make = |added: Vec<usize>, starts: Vec<Vec<(usize, Vec<f64>)>>, fall: f64| {
            let kept = parent.members.iter().filter(|m| Some(**m) != dropped).chain(&added).copied();
            let key = candidate_model::key(&kept.collect::<Vec<_>>());
            Move { key, dropped, added, starts, promised: chi2 - fall }
        };
        if dropped.is_some() {
            all.push(make(Vec::new(), vec![Vec::new()], 0.0));
        }
        if size >= most {
            continue;
        }
        // What was left out may come back in another shape.
        let is_absent = |i: &usize| {
            !parent.members.contains(i) && !is_unseen[*i] || dropped == Some(*i) && !candidates[*i].is_of_one_shape()
        };
        let model = parent.objective.data.model;
        let may_change = |i: &usize| change::has_its_effect(&candidates[*i].effect, model, kept());
        let absent: Vec<usize> = (0..candidates.len()).filter(is_absent).filter(may_change).collect();
        let gains: Vec<Vec<(usize, Gain)>> = absent.iter().map(|i| gains(&projected, &candidates[*i])).collect();
        for (added, gains) in absent.iter().zip(&gains) {
            let starts = apart(gains, STARTS);
            let Some((variant, best)) = starts.first() else { continue };
            let own = &candidates[*added].variants[*variant];
            if best.delta_chi2 == 0.0 && projected.seen(own).is_none() {
                if candidates[*added].effect.table == ON_TRIAL {
                    // A value of which the data say nothing stays as it is written.
                    continue;
                }
                // The others imitate all of it: it may be there for all that the data say, at a usual size.
                let amplitudes =
                    own.linear.iter().enumerate().map(|(i, p)| if i == 0 { p.size } else { 0.0 }).collect();
                all.push(make(vec![*added], vec![vec![(*variant, amplitudes)]], 0.0));
            } else if best.delta_chi2 > 0.0 {
                let starts = starts.iter().map(|(variant, gain)| vec![(*variant, gain.amplitudes.clone())]).collect();
                all.push(make(vec![*added], starts, best.delta_chi2));
            }
        }
        if reach == Reach::Two && size + 2 <= most {
            let some: Vec<CandidateEffect> =
                absent.iter().zip(&gains).map(|(i, gains)| few(&candidates[*i], gains)).collect();
            let mut two: Vec<_> =
                pairs(&Screening::new(&projected, &some.iter().collect::<Vec<_>>())).into_iter().collect();
            two.sort_by(|a, b| b.1.delta_chi2().total_cmp(&a.1.delta_chi2()));
            for ((one, other), pair) in two.into_iter().take(PAIRS) {
                let both = [&some[one], &some[other]];
                let start = |(i, number): (usize, usize)| {
                    let (variant, amplitudes) = pair.of(both, i);
                    (gains[number][variant].0, amplitudes.to_vec())
                };
                let start = [(0, one), (1, other)].map(start).to_vec();
                all.push(make(vec![absent[one], absent[other]], vec![start], pair.delta_chi2()));
            }
        }
    }
    all
}

/// Residual of a set without one of its members, to first order, with what the others can imitate projected out.
fn without(
    set: &CandidateModel,
    jacobian: &DMatrix<f64>,
    candidates: &[CandidateEffect],
    dropped: Option<usize>,
) -> ProjectedResidual {
    let objective = &set.objective;
    let mut residual = objective.residuals(&set.solution.position, &set.solution.predicted);
    let mut kept: Vec<usize> = (0..objective.data.model.parameters.len()).collect();
    let mut first = kept.len();
    for member in &set.members {
        let effect = &candidates[*member];
        let own = first..first + effect.parameters;
        first = own.end;
        if Some(*member) != dropped {
            kept.extend(own);
            continue;
        }
        for i in own {
            if effect.is_linear(i - (first - effect.parameters)) {
                let neutral = objective.neutral_at(i, set.solution.position.as_slice());
                residual.axpy(neutral - set.solution.position[i], &jacobian.column(i), 1.0);
            }
        }
    }
    ProjectedResidual::beside(objective, jacobian.select_columns(&kept), residual)
}

/// Gains of all variants of an effect, the best first.
fn gains(projected: &ProjectedResidual, candidate: &CandidateEffect) -> Vec<(usize, Gain)> {
    best_first(candidate.variants.iter().map(|v| projected.gain(v)).collect())
}

/// Gains with the numbers of their variants, the best first.
pub fn best_first(gains: Vec<Gain>) -> Vec<(usize, Gain)> {
    let mut all: Vec<(usize, Gain)> = gains.into_iter().enumerate().collect();
    all.sort_by(|a, b| b.1.delta_chi2.total_cmp(&a.1.delta_chi2));
    all
}

/// The best of these, each in another neighbourhood: neighbours on the grid run into the same minimum.
pub fn apart(gains: &[(usize, Gain)], most: usize) -> Vec<(usize, Gain)> {
    let mut chosen: Vec<(usize, Gain)> = Vec::new();
    for (i, gain) in gains {
        if chosen.len() < most && chosen.iter().all(|(j, _)| i.abs_diff(*j) > 1) {
            chosen.push((*i, gain.clone()));
        }
    }
    chosen
}

/// An effect with its most promising variants only, in their order.
fn few(candidate: &CandidateEffect, gains: &[(usize, Gain)]) -> CandidateEffect {
    let variants = gains.iter().take(PAIRED).map(|(i, _)| candidate.variants[*i].clone()).collect();
    CandidateEffect { variants, ..candidate.clone() }
}

/// Fits the set to which a move leads; `None` where it cannot be computed or nothing would test it. A fit ends after a few
/// steps where the χ² that is left by then is not hopeful.
pub fn fit<'a>(
    base: &CandidateModel<'a>,
    parent: &CandidateModel<'a>,
    to: &Move,
    candidates: &[CandidateEffect],
    is_hopeful: impl Fn(f64) -> bool,
) -> Option<CandidateModel<'a>> {
    let kept: Vec<usize> = parent.members.iter().copied().filter(|m| Some(*m) != to.dropped).collect();
    let members = [kept.clone(), to.added.clone()].concat();
    let mut objective = base.objective.clone();
    for member in &members {
        objective = objective.with(&candidates[*member].effect);
    }
    if objective.freedom() < 1.0 {
        // A model with as many parameters as rows fits anything.
        return None;
    }
    let from = parent.solution_of(&kept, candidates);
    let mut best: Option<Solution> = None;
    for start in &to.starts {
        let start = Start::new(&from, &to.added, start, candidates, &objective);
        // A model that lacks an effect is biased away from its priors; from there the way back may be barred.
        let bent = objective.prior_chi2(&start.position) > BENT;
        let written =
            bent.then(|| Start { position: objective.as_written(&start.position), slopes: None, ..start.clone() });
        for start in std::iter::once(start).chain(written) {
            best = best.into_iter().chain(start.ahead(&mut objective)).min_by(|a, b| a.chi2.total_cmp(&b.chi2));
        }
    }
    let best = best?;
    let solution = if is_hopeful(best.chi2) { resume(&mut objective, best, &[], SEARCHING) } else { best };
    let is_tested = members.len() <= 1 || objective.is_tested(&solution.predicted);
    is_tested.then_some(CandidateModel { members, objective, solution })
}

/// Start of a fit.
#[derive(Clone)]
struct Start {
    position: DVector<f64>,
    /// Slopes to first order; `None` where a shape has none.
    slopes: Option<DMatrix<f64>>,
    /// Linear parameters of the added effects (number of the search variable), with their neutral values.
    linear: Vec<(usize, f64)>,
}

impl Start {
    fn new(
        from: &Solution,
        added: &[usize],
        variants: &[(usize, Vec<f64>)],
        candidates: &[CandidateEffect],
        objective: &Objective,
    ) -> Self {
        let mut position: Vec<f64> = from.position.iter().copied().collect();
        // A set whose fit was cut short hands none on: a search by them would end by slopes on which none has come to rest.
        let slopes = from.slopes.as_ref().filter(|_| from.is_at_rest);
        let mut columns: Option<Vec<DVector<f64>>> =
            slopes.map(|slopes| slopes.column_iter().map(|c| c.into_owned()).collect());
        let mut linear = Vec::new();
        for (member, (variant, amplitudes)) in added.iter().zip(variants) {
            let variant = &candidates[*member].variants[*variant];
            let first = position.len();
            let variables: &[SearchVariable] = &objective.variables[first..];
            position.extend(variant.position(amplitudes, variables));
            let from = variant.moved(&mut position, first, objective);
            linear.extend(variant.linear.iter().zip(from).map(|(s, from)| (first + s.parameter, from)));
            columns = columns.zip(variant.slopes(amplitudes)).map(|(mut columns, own)| {
                columns.extend(own.column_iter().map(|column| column.into_owned()));
                columns
            });
        }
        let slopes = columns.filter(|columns| !columns.is_empty()).map(|columns| DMatrix::from_columns(&columns));
        Self { position: DVector::from_vec(position), slopes, linear }
    }

    /// Goes some steps, from amplitudes that are halved until the model can be computed there.
    fn ahead(mut self, objective: &mut Objective) -> Option<Solution> {
        for _ in 0..HALVINGS {
            if let Some(here) = objective.evaluate(self.position.clone()) {
                let slopes = self.slopes.map(std::sync::Arc::new);
                return Some(resume(objective, Solution { slopes, ..here }, &[], AHEAD));
            }
            for (variable, neutral) in &self.linear {
                let place = &mut self.position[*variable];
                *place = neutral + 0.5 * (*place - neutral);
            }
        }
        None
    }
}
