//! What each candidate effect would be in the place of what is told, and from which size it would have been seen.

use rayon::prelude::*;

use super::candidate_model::{CandidateModel, Weighed};
use super::detection_limit::{DetectionLimit, detection_limit};
use super::diagnosis::Outlook;
use super::null_distribution::Variance;
use super::posterior::{Posterior, RULED_OUT};
use super::residual_projection::ProjectedResidual;
use super::search::{SIGNIFICANCE, SearchResult};
use super::{laplace, verdict};

/// Evaluates every candidate effect; detection limits hold in nine tenths of the weight of all sets that may be true.
pub fn outlooks(
    found: &SearchResult,
    best: &CandidateModel,
    variance: Variance,
    posterior: &Posterior,
) -> Vec<Outlook> {
    let threshold = found.null_distribution.quantile(SIGNIFICANCE);
    let credible = found.credible();
    let mut projections: Vec<Projection> = credible.par_iter().filter_map(Projection::of).collect();
    if projections.is_empty() {
        let own = ProjectedResidual::new(&mut best.objective.clone(), &best.solution);
        projections.extend(own.map(|residual| Projection { members: best.members.clone(), criterion: 0.0, residual }));
    }
    let outlook = |number: usize| {
        let (candidate, single) = (&found.candidates[number], &found.singles[number]);
        // What was not tried for want of time would not have been found.
        let is_tried = single.is_some() || !best.objective.data.progress.is_over();
        let without = projections.iter().filter(|own| is_tried && !own.members.contains(&number));
        let without = without.filter(|_| candidate.effect.changes.is_none());
        let limit = |own: &Projection| Some((own.criterion, detection_limit(&own.residual, candidate, threshold)?));
        let gained = single.as_ref().map_or(0.0, |t| found.base.solution.chi2 - t.solution.chi2);
        let measured =
            single.as_ref().map_or(0.0, |t| variance.statistic(gained, t.solution.chi2, t.objective.freedom()));
        Outlook {
            effect: candidate.effect.clone(),
            probability: posterior.of(&candidate.effect.name),
            rms: single.as_ref().map(verdict::rms),
            delta_bic: single.as_ref().map_or(0.0, |t| t.bic() - found.base.bic()),
            p_value: found.first_null_distribution.p_value(measured),
            detection_limit: nine_in_ten(without.filter_map(limit).collect()),
        }
    };
    let mut all: Vec<Outlook> = (0..found.candidates.len()).into_par_iter().map(outlook).collect();
    // That nothing changed is no news.
    let is_told = |name: &str| best.objective.added.iter().any(|own| own.name == *name);
    all.retain(|own| own.effect.changes.is_none() || is_told(&own.effect.name) || own.probability >= RULED_OUT);
    all.sort_by(|a, b| a.delta_bic.total_cmp(&b.delta_bic));
    all
}

/// A set with what its free parameters leave.
struct Projection {
    members: Vec<usize>,
    criterion: f64,
    residual: ProjectedResidual,
}

impl Projection {
    fn of(set: &Weighed) -> Option<Self> {
        let CandidateModel { members, objective, solution } = &set.model;
        let residual = objective.residuals(&solution.position, &solution.predicted);
        let residual = ProjectedResidual::beside(objective, set.model.jacobian()?, residual);
        Some(Self { members: members.clone(), criterion: set.criterion, residual })
    }
}

/// The limit, of sets with these criteria, that holds in nine tenths of their weight.
fn nine_in_ten(mut limits: Vec<(f64, DetectionLimit)>) -> Option<DetectionLimit> {
    limits.sort_by(|a, b| a.1.own_share.total_cmp(&b.1.own_share));
    let least = limits.iter().map(|l| l.0).fold(f64::INFINITY, f64::min);
    let mut left = 0.1 * limits.iter().map(|l| laplace::weight(l.0, least)).sum::<f64>();
    let holds = |limit: &(f64, DetectionLimit)| {
        left -= laplace::weight(limit.0, least);
        left < 0.0
    };
    limits.into_iter().find(holds).map(|limit| limit.1)
}
