//! Brings drawn effects to a wanted visibility: first by the noise, and where that would be absurd by the
//! effects' sizes.

use crate::job::Job;
use crate::law::{Cause, scaled};
use crate::random::{Random, figures};
use crate::visibility::Nuisance;

/// How much stronger than the weakest another hidden effect may be.
const SPREAD: f64 = 4.0;

/// Effects at the wanted visibility, and the noise that makes it so.
#[derive(Debug, Clone)]
pub struct Tuned {
    /// The effects with their final parameters.
    pub hidden: Vec<Cause>,
    /// um.
    pub sigma: f64,
    /// lambda of each.
    pub lambda: Vec<f64>,
    /// Share of lambda squared of each that stands in the rows.
    pub in_rows: Vec<f64>,
    /// lambda of each without the prior rows.
    pub free: Vec<f64>,
}

/// Solves for the noise at which the weakest of `drawn` has the wanted lambda; scales down effects more
/// than `SPREAD` times as visible, and all of them when the noise would be larger than plausible. None when
/// that fails.
pub fn tune(job: &dyn Job, shown: &[Cause], drawn: Vec<Cause>, lambda: f64, random: &mut Random) -> Option<Tuned> {
    let mut factors = vec![1.0; drawn.len()];
    let goals: Vec<f64> = drawn.iter().map(|_| random.log_uniform(1.0, SPREAD) * lambda).collect();
    let (least, largest) = job.noise_range();
    let most = random.uniform(0.4 * largest, largest);
    for _ in 0..12 {
        let hidden: Vec<Cause> = drawn.iter().zip(&factors).map(|(c, f)| scaled(job.laws(), c, *f)).collect();
        let mut causes = shown.to_vec();
        causes.extend(hidden.iter().cloned());
        let signatures: Vec<Vec<f64>> = (0..hidden.len()).map(|i| job.signature(&causes, shown.len() + i)).collect();
        let nuisance = Nuisance::new(job, &causes);
        let sigma = figures(nuisance.sigma_for(&signatures, lambda)?, 6);
        if sigma < least {
            return None;
        }
        let lambdas: Vec<f64> = signatures.iter().map(|s| nuisance.lambda(s, sigma)).collect();
        let too_strong: Vec<usize> = (0..lambdas.len()).filter(|&i| lambdas[i] > 1.02 * SPREAD * lambda).collect();
        if sigma <= largest && too_strong.is_empty() {
            let in_rows = signatures.iter().map(|s| nuisance.in_rows(s, sigma)).collect();
            let free = signatures.iter().map(|s| nuisance.free_lambda(s, sigma)).collect();
            return Some(Tuned { hidden, sigma, lambda: lambdas, in_rows, free });
        }
        for i in too_strong {
            factors[i] *= goals[i] / lambdas[i];
        }
        if sigma > largest {
            factors.iter_mut().for_each(|f| *f *= most / sigma);
        }
        if factors.iter().zip(&drawn).any(|(f, c)| *f < job.least_factor(c.effect)) {
            return None;
        }
    }
    None
}

/// What is left of each effect's lambda when the parameters of the other hidden effects are free as well.
pub fn apart(job: &dyn Job, shown: &[Cause], tuned: &Tuned) -> Vec<f64> {
    let mut causes = shown.to_vec();
    causes.extend(tuned.hidden.iter().cloned());
    let nuisance = Nuisance::new(job, &causes);
    let left = |i: usize| {
        let mut basis = nuisance.basis(tuned.sigma);
        for other in (shown.len()..causes.len()).filter(|&k| k != i) {
            for parameter in 0..causes[other].parameters.len() {
                basis.add(&nuisance.standardised(&job.tangent(&causes, other, parameter), tuned.sigma));
            }
        }
        let own = nuisance.standardised(&job.signature(&causes, i), tuned.sigma);
        crate::dense::norm(&basis.remainder(&own))
    };
    (shown.len()..causes.len()).map(left).collect()
}
