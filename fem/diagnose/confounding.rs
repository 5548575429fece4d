//! Confounding: effects that these data cannot tell apart. To name one of them alone would be a wrong
//! answer.

use nalgebra::DVector;
use rayon::prelude::*;

use super::candidate_model::CandidateModel;
use super::change;
use super::gain::{Gain, gain};
use super::lead::{bare, fit_with, promising, starts, without};
use super::posterior::{CERTAIN, Posterior, may_be_true};
use super::residual_projection::{ProjectedResidual, length_outside};
use super::search::SearchResult;
use super::sensitivity::{CandidateEffect, Variant};

/// Difference of χ² up to which candidate models of one size fit equally well.
pub const EQUAL_FIT: f64 = 6.0;
/// Squared separation, in standard uncertainties, below which noise confounds two models in more than one
/// case of twenty: (1.645 + 1.645)².
pub const SEPARATE: f64 = 11.0;
/// Difference of χ² to first order (a constant, and a part of the gain) beyond which an alternative is not
/// fitted; to first order it may look worse than it is.
const HOPELESS: (f64, f64) = (40.0, 0.25);

/// Alternative: another effect in the place of a member of the best model.
#[derive(Clone)]
pub struct Alternative<'a> {
    /// Candidate model with the other effect in place.
    pub model: CandidateModel<'a>,
    /// Number of the effect that stands in.
    pub candidate: usize,
    /// χ² of the alternative less that of the best model.
    pub delta_chi2: f64,
    /// Squared distance between the two predictions that no parameter of the alternative can bridge, in
    /// standard uncertainties.
    pub separation: f64,
}

impl Alternative<'_> {
    fn is_equal(&self) -> bool {
        self.delta_chi2 <= EQUAL_FIT || self.separation < SEPARATE
    }
}

/// Alternatives to one member of the best model, the best first.
pub struct Confounding<'a> {
    /// Number of the member.
    pub candidate: usize,
    /// χ² of the best model without it.
    pub chi2_without: f64,
    /// Alternatives that fit as well.
    pub alternatives: Vec<Alternative<'a>>,
}

impl Confounding<'_> {
    /// Leaves out alternatives that the sets of effects rule out: to a certain member those whose set is improbable, to
    /// another one those outside of its group.
    pub fn leave_out_what_is_ruled_out(&mut self, found: &SearchResult, posterior: &Posterior) {
        let name = |number: usize| &found.candidates[number].effect.name;
        let own = name(self.candidate);
        if posterior.of(own) >= CERTAIN {
            return self.alternatives.retain(|a| may_be_true(found, &a.model));
        }
        let group = posterior.groups.iter().find(|group| group.effects.contains(own));
        self.alternatives.retain(|a| group.is_some_and(|group| group.effects.contains(name(a.candidate))));
    }
}

/// Finds the alternatives to every member of the best model.
pub fn confoundings<'a>(found: &SearchResult<'a>) -> Vec<Confounding<'a>> {
    let best = found.best();
    let mut all: Vec<Confounding<'a>> =
        best.members.par_iter().filter_map(|member| confounding(found, best, *member)).collect();
    let Some(projected) = ProjectedResidual::new(&mut found.base.objective.clone(), &found.base.solution) else {
        return all;
    };
    // In models that differ in more than one effect, each effect stands for the member that it resembles
    // most.
    for other in found.tried.iter().map(|set| &set.model).filter(|t| t.members.len() == best.members.len()) {
        let new: Vec<usize> = other.members.iter().copied().filter(|m| !best.members.contains(m)).collect();
        if new.len() < 2 {
            continue;
        }
        let Some(alternative) = alternative(best, other.clone(), new[0]) else { continue };
        if !alternative.is_equal() {
            continue;
        }
        let mut open: Vec<usize> = best.members.iter().copied().filter(|m| !other.members.contains(m)).collect();
        for candidate in new {
            let likest = |m: &usize| likeness(&projected, &found.candidates[candidate], &found.candidates[*m]);
            let Some(i) = (0..open.len()).max_by(|a, b| likest(&open[*a]).total_cmp(&likest(&open[*b]))) else { break };
            let member = open.remove(i);
            let own = all.iter_mut().find(|p| p.candidate == member);
            if let Some(own) = own.filter(|p| p.alternatives.iter().all(|r| r.candidate != candidate)) {
                own.alternatives.push(Alternative { candidate, ..alternative.clone() });
            }
        }
    }
    all
}

fn confounding<'a>(found: &SearchResult<'a>, best: &CandidateModel<'a>, member: usize) -> Option<Confounding<'a>> {
    let without = without(&found.base, &found.candidates, best, member)?;
    let bare = bare(&found.base, &found.candidates, best, member)?;
    let projected = ProjectedResidual::new(&mut bare.objective.clone(), &bare.solution)?;
    let gained = projected.residual.norm_squared() - best.solution.chi2;
    let stand_in = |candidate: usize| {
        let stranger = &found.candidates[candidate];
        let mut starts = starts(&projected, stranger);
        let delta_chi2 = starts.first().map_or(0.0, |s| s.1.delta_chi2);
        if gained - delta_chi2 > HOPELESS.0 + HOPELESS.1 * gained {
            return None;
        }
        // Starts with all other parameters as they were: towards the residual, and towards what resembles
        // the member most.
        starts.extend(imitations(best, &bare, stranger));
        let trial = fit_with(&bare, candidate, stranger, &starts)?;
        alternative(best, trial, candidate).filter(Alternative::is_equal)
    };
    let may_change = |i: &usize| {
        change::has_its_effect(&found.candidates[*i].effect, best.objective.data.model, best.objective.added.iter())
    };
    let others = (0..found.candidates.len()).filter(|i| !best.members.contains(i)).filter(may_change);
    let mut alternatives: Vec<Alternative<'a>> = others.filter_map(stand_in).collect();
    alternatives.sort_by(|a, b| a.delta_chi2.total_cmp(&b.delta_chi2));
    Some(Confounding { candidate: member, chi2_without: without.solution.chi2, alternatives })
}

/// Variants of another effect that come closest to the contribution of the member.
fn imitations(best: &CandidateModel, bare: &CandidateModel, stranger: &CandidateEffect) -> Vec<(usize, Gain)> {
    let made = best.objective.whiten(best.change_from(bare));
    let imitation =
        |v: &Variant| gain(&(v.columns.transpose() * &v.columns), &(v.columns.transpose() * &made), &v.signed);
    promising(stranger.variants.iter().map(imitation).collect())
}

/// Compares a model with the best: by its χ², and by the residual that it would leave without noise if the
/// best were the truth.
fn alternative<'a>(best: &CandidateModel<'a>, trial: CandidateModel<'a>, candidate: usize) -> Option<Alternative<'a>> {
    let jacobian = trial.objective.jacobian(&trial.solution)?;
    let apart = trial.objective.noise.whiten(best.change_from(&trial)).into_iter().chain(priors_apart(best, &trial));
    let separation = length_outside(&jacobian, DVector::from_vec(apart.collect())).powi(2);
    let delta_chi2 = trial.solution.chi2 - best.solution.chi2;
    Some(Alternative { model: trial, candidate, delta_chi2, separation })
}

/// Differences of two models in the parameters with priors, in prior standard uncertainties.
fn priors_apart(best: &CandidateModel, alternative: &CandidateModel) -> Vec<f64> {
    let moved = |i: usize| {
        let variable = &alternative.objective.variables[i];
        let [a, b] = [best, alternative].map(|t| variable.value(t.solution.position[i]));
        variable.prior.map(|(_, std)| (a - b) / std)
    };
    (0..best.objective.data.model.parameters.len()).filter_map(moved).collect()
}

/// Largest |cosine| between sensitivities of two candidate effects, 0 to 1.
fn likeness(projected: &ProjectedResidual, a: &CandidateEffect, b: &CandidateEffect) -> f64 {
    let columns =
        |c: &CandidateEffect| c.variants.iter().map(|v| projected.project_columns(&v.columns)).collect::<Vec<_>>();
    let (of_a, of_b) = (columns(a), columns(b));
    let cosine = |x: &nalgebra::DMatrix<f64>, y: &nalgebra::DMatrix<f64>| {
        let (x, y) = (x.column(0), y.column(0));
        (x.dot(&y) / (x.norm() * y.norm()).max(f64::MIN_POSITIVE)).abs()
    };
    of_a.iter().flat_map(|x| of_b.iter().map(move |y| cosine(x, y))).fold(0.0, f64::max)
}
