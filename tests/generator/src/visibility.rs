//! lambda: how many standard deviations of an effect remain after the nuisance parameters have imitated what they can.

use crate::additive::additive_error;
use crate::catalogue::{Cause, in_equilibrium};
use crate::dense::{Basis, norm};
use crate::equilibrium::force_error;
use crate::job::Job;

/// Diameter error at every row from all causes, um.
pub fn predict(job: &Job, causes: &[Cause]) -> Vec<f64> {
    let (mut errors, added) = (force_error(job, causes), additive_error(job, causes));
    errors.iter_mut().zip(added).for_each(|(e, a)| *e += a);
    errors
}

/// The difference that `causes[index]` makes with all others present, um. Additive causes need no second equilibrium.
pub fn signature(job: &Job, causes: &[Cause], index: usize) -> Vec<f64> {
    if !in_equilibrium(causes[index].effect) {
        return additive_error(job, &causes[index..=index]);
    }
    let mut without = causes.to_vec();
    without.remove(index);
    difference(&force_error(job, causes), &force_error(job, &without), 1.0)
}

/// Derivative of the prediction with respect to one parameter of one cause, by a central difference.
pub fn tangent(job: &Job, causes: &[Cause], index: usize, parameter: usize) -> Vec<f64> {
    let at = causes[index].parameters[parameter].1;
    let step = if at == 0.0 { 1e-3 } else { 1e-3 * at.abs() };
    let moved = |by: f64| {
        let mut moved = causes.to_vec();
        moved[index].parameters[parameter].1 = at + by;
        if in_equilibrium(moved[index].effect) {
            force_error(job, &moved)
        } else {
            additive_error(job, &moved[index..=index])
        }
    };
    difference(&moved(step), &moved(-step), 2.0 * step)
}

fn difference(a: &[f64], b: &[f64], over: f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| (a - b) / over).collect()
}

/// Tangents of the `+-` parameters at the truth, with their prior rows: the directions in which a fit can bend the model.
#[derive(Debug, Clone)]
pub struct Nuisance {
    tangents: Vec<Vec<f64>>,
    weights: Vec<f64>,
}

impl Nuisance {
    /// `causes` begins with the shown effects, in the order of `job.shown`.
    pub fn new(job: &Job, causes: &[Cause]) -> Self {
        Self {
            tangents: (0..job.shown.len()).map(|i| tangent(job, causes, i, 0)).collect(),
            weights: job.shown.iter().map(|s| 1.0 / s.std).collect(),
        }
    }

    /// A direction in the standardised residual space: rows/sigma, then the prior rows (untouched by anything but the nuisance).
    pub fn standardised(&self, rows: &[f64], sigma: f64) -> Vec<f64> {
        rows.iter().map(|r| r / sigma).chain(self.weights.iter().map(|_| 0.0)).collect()
    }

    /// Basis of the nuisance parameters' tangents in the standardised space.
    pub fn basis(&self, sigma: f64) -> Basis {
        let mut basis = Basis::default();
        for (i, rows) in self.tangents.iter().enumerate() {
            let mut column = self.standardised(rows, sigma);
            column[rows.len() + i] = self.weights[i];
            basis.add(&column);
        }
        basis
    }

    /// lambda of a signature at this noise.
    pub fn lambda(&self, signature: &[f64], sigma: f64) -> f64 {
        norm(&self.basis(sigma).remainder(&self.standardised(signature, sigma)))
    }

    /// lambda of a signature when the priors are not counted.
    pub fn free_lambda(&self, signature: &[f64], sigma: f64) -> f64 {
        norm(&Basis::of(&self.tangents).remainder(signature)) / sigma
    }

    /// Share of lambda squared that stands in the measured rows; the rest is a contradiction of the priors.
    pub fn in_rows(&self, signature: &[f64], sigma: f64) -> f64 {
        let rest = self.basis(sigma).remainder(&self.standardised(signature, sigma));
        (norm(&rest[..signature.len()]) / norm(&rest)).powi(2)
    }

    /// The noise at which the weakest signature has just this lambda (lambda falls with sigma), or None outside 1e-3..1e3 um.
    pub fn sigma_for(&self, signatures: &[Vec<f64>], lambda: f64) -> Option<f64> {
        let weakest = |sigma: f64| signatures.iter().map(|s| self.lambda(s, sigma)).fold(f64::INFINITY, f64::min);
        let (mut low, mut high) = (1e-3_f64, 1e3_f64);
        if weakest(low) < lambda || weakest(high) > lambda {
            return None;
        }
        while high / low > 1.0 + 1e-9 {
            let middle = (low * high).sqrt();
            if weakest(middle) > lambda { low = middle } else { high = middle }
        }
        Some(low)
    }
}
