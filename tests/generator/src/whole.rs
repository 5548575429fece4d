//! Whole machines: the model that a user writes first, in which nothing gives way, warms or wears, and the
//! measurements of a machine that has three to six effects at once.

use crate::dense::{Basis, norm};
use crate::job::{Job, NoiseKind};
use crate::law::Cause;
use crate::random::{Random, figures};
use crate::tuning::{Tuned, apart};
use crate::typical::weight;
use crate::visibility::Nuisance;
use crate::{Case, Process, finish};

/// How many effects a machine has, where its process knows so many.
const EFFECTS: (usize, usize) = (3, 6);
/// Lengths of signatures in standard uncertainties, nothing else being free: plainly visible, and within what an
/// instrument of a workshop tells apart.
const VISIBLE: (f64, f64) = (10.0, 1000.0);
/// The weakest is drawn up to this.
const WEAKEST: f64 = 40.0;

/// A machine of which an ideal model is written.
pub struct Whole {
    /// Its files, and what is hidden.
    pub case: Case,
    /// What was made and measured, without anything that the model could show.
    pub job: Box<dyn Job>,
}

impl Process {
    /// A machine with three to six effects, typical ones more often, none of which stands in the model; each is
    /// at least `VISIBLE` from the others' company, in a design in which the noise can be learnt.
    pub fn whole_machine(&self, seed: u64) -> Whole {
        let mut random = Random::new(&format!("{}whole", self.name), seed);
        loop {
            let effects = self.typical_effects(&mut random);
            if let Some(whole) = self.ideal(&effects, &mut random) {
                return whole;
            }
        }
    }

    /// Effects by their weights, each once, none with one from which no measurement tells it.
    fn typical_effects(&self, random: &mut Random) -> Vec<&'static str> {
        let count = random.whole(EFFECTS.0, EFFECTS.1);
        let mut left: Vec<&'static str> = self.laws.iter().map(|law| law.0).collect();
        let mut drawn: Vec<&'static str> = Vec::new();
        while drawn.len() < count && !left.is_empty() {
            let own = left.remove(pick(&left, random));
            left.retain(|other| !self.never_together.iter().any(|pair| pair.contains(&own) && pair.contains(other)));
            drawn.push(own);
        }
        drawn
    }

    /// One draw of job, sizes and noise; None where it admits one of the effects not, or shows it too little.
    fn ideal(&self, effects: &[&'static str], random: &mut Random) -> Option<Whole> {
        let mut job = (self.draw_job)(effects, random)?;
        job.forget();
        let hidden: Vec<Cause> = effects.iter().map(|effect| job.draw(effect, random)).collect();
        if job.noise() == NoiseKind::Neither || !effects.iter().all(|effect| job.admits(effect, &hidden)) {
            return None;
        }
        let tuned = made_visible(&*job, hidden, random)?;
        let apart = apart(&*job, &[], &tuned);
        let case = finish(&*job, &[], tuned, apart, None, None, random);
        Some(Whole { case, job })
    }
}

/// Index of one of some effects, by their weights.
fn pick(effects: &[&str], random: &mut Random) -> usize {
    let whole: f64 = effects.iter().map(|effect| weight(effect)).sum();
    let mut at = random.uniform(0.0, whole);
    let is_it = |effect: &&str| {
        at -= weight(effect);
        at < 0.0
    };
    effects.iter().position(is_it).unwrap_or(effects.len() - 1)
}

/// The effects at their sizes under a noise of a workshop in which all of them are visible.
fn made_visible(job: &dyn Job, hidden: Vec<Cause>, random: &mut Random) -> Option<Tuned> {
    let signatures: Vec<Vec<f64>> = (0..hidden.len()).map(|i| job.signature(&hidden, i)).collect();
    let nuisance = Nuisance::new(job, &hidden);
    let (least, largest) = job.noise_range();
    let wanted = random.log_uniform(VISIBLE.0, WEAKEST);
    let most = random.uniform(0.4 * largest, largest);
    let sigma = figures(nuisance.sigma_for(&signatures, wanted)?.min(most), 6);
    let lambda: Vec<f64> = signatures.iter().map(|s| nuisance.lambda(s, sigma)).collect();
    if sigma < least || lambda.iter().any(|l| !(0.99 * VISIBLE.0..=VISIBLE.1).contains(l)) {
        return None;
    }
    let in_rows = signatures.iter().map(|s| nuisance.in_rows(s, sigma)).collect();
    Some(Tuned { hidden, sigma, free: lambda.clone(), lambda, in_rows })
}

/// What is left of each effect in all that was measured when the parameters of the others are free, standard
/// uncertainties: what no way of reading these rows can name without the others stands near zero.
pub fn apart_in(jobs: &[Box<dyn Job>], hidden: &[Cause], sigma: f64) -> Vec<f64> {
    let whitened = |job: &dyn Job, rows: Vec<f64>| -> Vec<f64> {
        rows.iter().zip(job.scales()).map(|(value, scale)| value / (sigma * scale)).collect()
    };
    let over_all = |of: &dyn Fn(&dyn Job) -> Vec<f64>| -> Vec<f64> {
        jobs.iter().flat_map(|job| whitened(&**job, of(&**job))).collect()
    };
    let mut common = Basis::default();
    let mut before = 0;
    let all: usize = jobs.iter().map(|job| job.rows()).sum();
    for job in jobs {
        for blind in job.blind() {
            let mut column = vec![0.0; all];
            column[before..before + job.rows()].copy_from_slice(&whitened(&**job, blind));
            common.add(&column);
        }
        before += job.rows();
    }
    let left = |i: usize| {
        let mut basis = common.clone();
        for other in (0..hidden.len()).filter(|other| *other != i) {
            for parameter in 0..hidden[other].parameters.len() {
                basis.add(&over_all(&|job| job.tangent(hidden, other, parameter)));
            }
        }
        norm(&basis.remainder(&over_all(&|job| job.signature(hidden, i))))
    };
    (0..hidden.len()).map(left).collect()
}
