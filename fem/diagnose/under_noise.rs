//! A model beside the effects of the measurement that its residuals ask for: how likely its rows are when zeros, jumps and
//! noise that neighbours share may be at work too.

use super::candidate_model::CandidateModel;
use super::doubtful;
use super::failure::unsolvable;
use super::instrument::{self, Proposal};
use crate::fit::{self, Objective, Solution, StoppingCriterion};
use crate::model::Data;
use crate::noise::{Noise, PROMISING, Term};
use crate::process::Failure;
use crate::progress::Progress;

/// Most effects of the measurement.
const MOST_TERMS: usize = 3;

/// A fitted model with its noise.
pub struct UnderNoise {
    /// −2 ln L and the price of the terms, less a constant of the rows.
    pub criterion: f64,
    /// The terms that were found, beside those that the model states and those that follow a column.
    pub terms: Vec<Term>,
}

/// Fits a model under the noise that it states, its sizes estimated beside what is fitted.
///
/// # Errors
/// The model cannot be computed.
pub fn under_stated_noise<'m>(data: &'m Data<'m>) -> Result<(Objective<'m>, Solution), Failure> {
    let mut objective = Objective::new(data)?;
    let solution = fit::best(&mut objective)?;
    let residuals = data.residuals(&solution.predicted);
    let mean = objective.mean(&solution).ok_or_else(unsolvable)?;
    objective.noise = Noise::stated(&data.terms, data, data.repeats(), &residuals, &mean).0;
    let full = StoppingCriterion::FULL;
    let solution = fit::minimise(&mut objective, &solution.position, &[], full).ok_or_else(unsolvable)?;
    Ok((objective, solution))
}

/// Fits a model, and adds terms to its noise, the most promising first, as long as the likelihood rises by more than their
/// price. Those that only describe are left out.
///
/// # Errors
/// The model cannot be computed.
pub fn under_noise(data: &Data, progress: &Progress) -> Result<UnderNoise, Failure> {
    let repeats = data.repeats();
    let (objective, solution) = under_stated_noise(data)?;
    let mut trial = CandidateModel { members: Vec::new(), objective, solution };
    let price = |trial: &CandidateModel| instrument::minus_two_log(trial) + trial.objective.noise.price();
    for _ in 0..MOST_TERMS {
        if !progress.permits("a further effect of the measurement") {
            break;
        }
        let least = instrument::criterion(&trial) - PROMISING;
        let explains = |p: &Proposal| p.noise.terms.iter().all(|term| !term.effect.describes());
        let wanted = |p: &Proposal| p.criterion < least && explains(p);
        let Some(proposal) = instrument::proposals(&trial, repeats).into_iter().find(wanted) else { break };
        let mut further = trial.clone();
        further.objective.noise = proposal.noise;
        match instrument::resized(&further, repeats) {
            Some(resized) if price(&resized) < price(&trial) => trial = resized,
            _ => break,
        }
    }
    let follows = doubtful::terms_that_follow(&trial);
    let speaks = |(number, term): &(usize, &Term)| {
        !term.is_among(&data.terms) && follows.iter().all(|(other, _)| other != number)
    };
    let found = trial.objective.noise.terms.iter().enumerate().filter(speaks);
    let terms = found.map(|(_, term)| term.clone()).collect();
    Ok(UnderNoise { criterion: price(&trial), terms })
}
