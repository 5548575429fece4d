//! A lathe of which one spring changed between two parts, and nobody noticed: rows up to the border are of one machine,
//! rows beyond it of another one.

use super::design;
use super::equilibrium::errors;
use super::job::Job;
use crate::job::{Job as _, difference};
use crate::law::Cause;
use crate::random::{Random, figures};
use crate::visibility::Nuisance;

/// Draws that are tried.
const ATTEMPTS: usize = 60;
/// Smallest and largest ratio of the stiffness after to that before; or the other way round.
const RATIO: (f64, f64) = (0.35, 0.8);
/// Noise of a workshop, um.
const NOISE: (f64, f64) = (0.05, 6.0);

/// What the model knows roughly, what changed, and what was measured.
#[derive(Debug, Clone)]
pub struct Changed {
    /// The model file.
    pub model: String,
    /// The measurement file.
    pub data: String,
    /// The effect that changed.
    pub effect: &'static str,
    /// The last part before.
    pub after: usize,
    /// Its stiffness before and after, N/um.
    pub stiffness: [f64; 2],
}

/// A job of which a stiffness that the model has changed at this visibility; `None` where no draw reaches it.
pub fn case(lambda: f64, seed: u64) -> Option<Changed> {
    let mut random = Random::new("changed", seed);
    (0..ATTEMPTS).find_map(|_| attempt(lambda, &mut random))
}

fn attempt(lambda: f64, random: &mut Random) -> Option<Changed> {
    let job = design::draw_job(&[], random)?;
    let known: Vec<f64> =
        job.shown.iter().map(|s| (s.written + s.std * random.normal()).max(0.3 * s.written)).collect();
    let springs: Vec<usize> = (0..job.shown.len()).filter(|i| job.shown[*i].parameter == "stiffness").collect();
    if springs.is_empty() {
        return None;
    }
    let number = random.pick(&springs);
    let after = random.whole(1, job.parts - 1);
    let ratio = random.log_uniform(RATIO.0, RATIO.1);
    let ratio = if random.chance(0.7) { ratio } else { 1.0 / ratio };
    let before = job.causes(&known);
    let mut behind = before.clone();
    behind[number].parameters[0].1 = figures(known[number] * ratio, 5);
    let exact = observed(&job, &before, &behind, after);
    let signature = difference(&exact, &job.predict(&before), 1.0);
    let nuisance = Nuisance::new(&job, &before);
    let sigma = figures(nuisance.sigma_for(std::slice::from_ref(&signature), lambda)?, 5);
    let is_of_workshop = (NOISE.0..NOISE.1).contains(&sigma);
    if !is_of_workshop || nuisance.free_lambda(&signature, sigma) < 0.5 * lambda {
        return None;
    }
    let measured: Vec<f64> = exact.iter().map(|e| e + sigma * random.normal()).collect();
    Some(Changed {
        model: crate::writing::model(&job, None, &[]),
        data: job.data(&measured, sigma),
        effect: job.shown[number].effect,
        after,
        stiffness: [known[number], behind[number].parameters[0].1],
    })
}

/// Rows up to a part of one machine, and beyond it of another.
fn observed(job: &Job, before: &[Cause], behind: &[Cause], after: usize) -> Vec<f64> {
    let both = errors(job, before).into_iter().zip(errors(job, behind));
    both.zip(&job.rows).map(|((before, behind), row)| if row.part > after { behind } else { before }).collect()
}
