//! Practice cases with a hidden physical effect for the process `turning`, made by other code and other numerics than the program
//! under test: unit-load integrals instead of finite elements, the force method and a bracketing root search instead of a Newton
//! iteration, a fine implicit finite-volume rod for the heat. Laws, signs and units are those that `fem effects turning` states.
//!
//! Every case is decided by its seed. lambda is the length of an effect's signature, in standard deviations, after projection onto
//! the tangent of all `+-` parameters of the written model with their prior rows appended.

pub mod additive;
pub mod catalogue;
pub mod dense;
pub mod design;
pub mod equilibrium;
pub mod foreign;
pub mod heat;
pub mod job;
pub mod random;
pub mod shaft;
pub mod story;
pub mod tuning;
pub mod visibility;
pub mod writing;

pub use catalogue::{Cause as Hidden, EFFECTS};
pub use job::NoiseKind;

use catalogue::draw;
use design::draw_job;
use foreign::{draw_shape, what_catalogue_leaves};
use job::Job;
use random::{Random, figures};
use tuning::{SIGMA, Tuned, apart, tune};
use visibility::{Nuisance, predict};

/// What sort of thing is hidden.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The written model is right.
    Nothing,
    /// Effects of the catalogue.
    Effects,
    /// Structure outside the catalogue.
    Outside,
}

/// What the generator knows and the program must find out.
#[derive(Debug, Clone)]
pub struct Truth {
    /// What sort of thing is hidden.
    pub kind: Kind,
    /// The hidden effects with their true parameters.
    pub hidden: Vec<Hidden>,
    /// Standard deviation of the noise, um.
    pub sigma: f64,
    /// Visibility of every hidden effect, or of the outside structure.
    pub lambda: Vec<f64>,
    /// What is left of each lambda when the other hidden effects are re-fitted too; for outside structure, when the best three
    /// effects of the catalogue are fitted to it.
    pub apart: Vec<f64>,
    /// Share of each lambda squared that stands in the rows; the rest is a contradiction of the written `+-` values.
    pub in_rows: Vec<f64>,
    /// lambda without the prior rows, the `+-` parameters wholly free: what the rows alone can show.
    pub free: Vec<f64>,
    /// True values of the shown `+-` parameters.
    pub shown: Vec<Hidden>,
    /// Name of the outside structure, else empty.
    pub shape: &'static str,
    /// Where the noise can be learnt from.
    pub noise: NoiseKind,
}

/// One practice case.
#[derive(Debug, Clone)]
pub struct Case {
    /// The model file.
    pub model: String,
    /// The measurement file.
    pub data: String,
    /// The same job measured again: same design, same truth, new noise.
    pub fresh: String,
    /// The model file with everything known and the hidden effects added: what a perfect diagnosis would arrive at.
    pub revealed: String,
    /// The observable without noise, um, row by row.
    pub exact: Vec<f64>,
    /// What is hidden.
    pub truth: Truth,
}

/// How many draws of job and effect are tried before a wish is given up.
const ATTEMPTS: usize = 60;

/// A case in which nothing is missing.
pub fn nothing(seed: u64) -> Case {
    let mut random = Random::new("nothing", seed);
    loop {
        if let Some(job) = draw_job(&[], &mut random) {
            let causes = job.causes(&true_values(&job, &mut random));
            let sigma = figures(random.log_uniform(0.3, 3.0), 6);
            let tuned = Tuned { hidden: Vec::new(), sigma, lambda: Vec::new(), in_rows: Vec::new(), free: Vec::new() };
            return finish(&job, &causes, tuned, Vec::new(), None, &mut random);
        }
    }
}

/// A case with one hidden effect at the given lambda; None if no draw of job and size reaches it.
pub fn single(effect: &str, lambda: f64, seed: u64) -> Option<Case> {
    let effect = EFFECTS.iter().find(|e| **e == effect)?;
    let mut random = Random::new(effect, seed);
    (0..ATTEMPTS).find_map(|_| attempt(&[effect], lambda, &mut random))
}

/// A case with `count` different hidden effects, the weakest at the given lambda, the others up to four times that.
/// Pairs that differ by nothing in diameters are avoided, and so are sets of which a member vanishes behind the others.
pub fn several(count: usize, lambda: f64, seed: u64) -> Case {
    let mut random = Random::new("several", seed);
    loop {
        let mut effects: Vec<&'static str> = Vec::new();
        while effects.len() < count.min(EFFECTS.len()) {
            let effect = random.pick(EFFECTS);
            if !effects.contains(&effect) {
                effects.push(effect);
            }
        }
        if effects.contains(&"guideway-taper") && effects.contains(&"tailstock-offset") {
            continue;
        }
        if let Some(case) = attempt(&effects, lambda, &mut random) {
            return case;
        }
    }
}

/// A case whose structure no effect of the catalogue can make, at the given lambda after the nuisance is projected out.
pub fn outside(lambda: f64, seed: u64) -> Case {
    let mut random = Random::new("outside", seed);
    loop {
        let Some(job) = draw_job(&[], &mut random) else { continue };
        let causes = job.causes(&true_values(&job, &mut random));
        let nuisance = Nuisance::new(&job, &causes);
        let sigma = figures(random.log_uniform(SIGMA.0.max(0.3), 3.0), 6);
        let (name, mut shape) = draw_shape(&job, &mut random);
        let size = nuisance.lambda(&shape, sigma);
        shape.iter_mut().for_each(|s| *s *= lambda / size);
        let left = what_catalogue_leaves(&job, &causes, &nuisance, &shape, sigma, &mut random);
        // At least half of the excess must stay unexplained, else naming the effect would be right.
        if left * left > 0.5 * lambda * lambda {
            let in_rows = vec![nuisance.in_rows(&shape, sigma)];
            let free = vec![nuisance.free_lambda(&shape, sigma)];
            let tuned = Tuned { hidden: Vec::new(), sigma, lambda: vec![lambda], in_rows, free };
            return finish(&job, &causes, tuned, vec![left], Some((name, shape)), &mut random);
        }
    }
}

/// True values of the shown parameters, drawn from what is written about them.
fn true_values(job: &Job, random: &mut Random) -> Vec<f64> {
    let truth = |s: &job::Shown| if s.written > 0.0 { 0.3 * s.written } else { f64::NEG_INFINITY };
    job.shown.iter().map(|s| (s.written + s.std * random.normal()).max(truth(s))).collect()
}

/// One draw of job, true values and effects, brought to the wanted lambda.
fn attempt(effects: &[&'static str], lambda: f64, random: &mut Random) -> Option<Case> {
    let job = draw_job(effects, random)?;
    let shown = job.causes(&true_values(&job, random));
    let drawn: Vec<Hidden> = effects.iter().map(|e| draw(e, job.shaft.length(), random)).collect();
    let tuned = tune(&job, &shown, drawn, lambda, random)?;
    // What only contradicts the priors could be any of many causes.
    if tuned.free.iter().zip(&tuned.lambda).any(|(free, lambda)| *free < 0.5 * lambda) {
        return None;
    }
    let apart = apart(&job, &shown, &tuned);
    // Behind the others' freedom less than 4 sigma is left: no method could name it.
    if apart.iter().any(|a| *a < 4.0) {
        return None;
    }
    Some(finish(&job, &shown, tuned, apart, None, random))
}

/// Adds the noise and writes the files.
fn finish(
    job: &Job,
    shown: &[Hidden],
    tuned: Tuned,
    apart: Vec<f64>,
    foreign: Option<(&'static str, Vec<f64>)>,
    random: &mut Random,
) -> Case {
    let mut causes = shown.to_vec();
    causes.extend(tuned.hidden.iter().cloned());
    let mut exact = predict(job, &causes);
    let (shape, structure) = foreign.unwrap_or(("", vec![0.0; exact.len()]));
    exact.iter_mut().zip(structure).for_each(|(e, s)| *e += s);
    let mut measured = || {
        let observed: Vec<f64> = exact.iter().map(|e| e + tuned.sigma * random.normal()).collect();
        writing::data(job, &observed, tuned.sigma)
    };
    let (data, fresh) = (measured(), measured());
    let values: Vec<f64> = shown.iter().map(|c| c.parameters[0].1).collect();
    let kind = match (shape, tuned.hidden.is_empty()) {
        ("", true) => Kind::Nothing,
        ("", false) => Kind::Effects,
        _ => Kind::Outside,
    };
    Case {
        model: writing::model(job, None, &[]),
        data,
        fresh,
        revealed: writing::model(job, Some(&values), &tuned.hidden),
        exact,
        truth: Truth {
            kind,
            hidden: tuned.hidden,
            sigma: tuned.sigma,
            lambda: tuned.lambda,
            apart,
            in_rows: tuned.in_rows,
            free: tuned.free,
            shown: shown.to_vec(),
            shape,
            noise: job.noise,
        },
    }
}
