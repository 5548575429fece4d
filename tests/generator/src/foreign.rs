//! Whether the catalogue really cannot make a structure.

use crate::dense::{Basis, dot, norm};
use crate::job::Job;
use crate::law::Cause;
use crate::random::Random;
use crate::visibility::Nuisance;

/// Size of what three effects of the catalogue, the best of many draws, leave of the (standardised) shape;
/// negative amplitudes are allowed to them, which makes the check stricter than physics.
pub fn what_catalogue_leaves(
    job: &dyn Job,
    causes: &[Cause],
    nuisance: &Nuisance,
    shape: &[f64],
    sigma: f64,
    random: &mut Random,
) -> f64 {
    let mut pool = Vec::new();
    let is_absent = |effect: &str| causes.iter().all(|c| c.effect != effect);
    for (effect, _) in job.laws().iter().filter(|(e, _)| job.admits(e, causes) && is_absent(e)) {
        for _ in 0..job.draws(effect) {
            let mut with = causes.to_vec();
            with.push(job.draw(effect, random));
            pool.push(nuisance.standardised(&job.signature(&with, causes.len()), sigma));
        }
    }
    let mut basis = nuisance.basis(sigma);
    let mut rest = basis.remainder(&nuisance.standardised(shape, sigma));
    for _ in 0..3 {
        let gain = |s: &Vec<f64>, basis: &Basis| {
            let own = basis.remainder(s);
            let size = norm(&own);
            if size > 1e-6 * norm(s) { dot(&own, &rest).abs() / size } else { 0.0 }
        };
        let gains: Vec<f64> = pool.iter().map(|s| gain(s, &basis)).collect();
        let Some(best) = (0..pool.len()).max_by(|&i, &j| gains[i].total_cmp(&gains[j])) else { break };
        basis.add(&pool[best]);
        rest = basis.remainder(&rest);
    }
    norm(&rest)
}
