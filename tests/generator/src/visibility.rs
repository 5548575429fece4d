//! lambda: how many standard deviations of an effect remain after the nuisance parameters have imitated
//! what they can.

use crate::dense::{Basis, norm};
use crate::job::Job;
use crate::law::Cause;

/// Tangents of the `+-` parameters at the truth, with their prior rows, and what cannot be measured: the
/// directions in which a fit can bend the model. Rows are told in the noise of each at a noise of one.
#[derive(Debug, Clone)]
pub struct Nuisance {
    tangents: Vec<Vec<f64>>,
    weights: Vec<f64>,
    blind: Vec<Vec<f64>>,
    scales: Vec<f64>,
}

impl Nuisance {
    /// `causes` begins with the shown effects, in the order of `job.shown()`.
    pub fn new(job: &dyn Job, causes: &[Cause]) -> Self {
        Self {
            tangents: (0..job.shown().len()).map(|i| job.tangent(causes, i, 0)).collect(),
            weights: job.shown().iter().map(|s| 1.0 / s.std).collect(),
            blind: job.blind(),
            scales: job.scales(),
        }
    }

    /// A direction in the standardised residual space: rows/sigma, then the prior rows (untouched by
    /// anything but the nuisance).
    pub fn standardised(&self, rows: &[f64], sigma: f64) -> Vec<f64> {
        let rows = rows.iter().zip(&self.scales).map(|(r, scale)| r / (sigma * scale));
        rows.chain(self.weights.iter().map(|_| 0.0)).collect()
    }

    /// Basis of the nuisance parameters' tangents in the standardised space.
    pub fn basis(&self, sigma: f64) -> Basis {
        let mut basis = Basis::default();
        for blind in &self.blind {
            basis.add(&self.standardised(blind, sigma));
        }
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
        let scaled = |rows: &Vec<f64>| rows.iter().zip(&self.scales).map(|(r, scale)| r / scale).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = self.blind.iter().chain(&self.tangents).map(scaled).collect();
        norm(&Basis::of(&columns).remainder(&scaled(&signature.to_vec()))) / sigma
    }

    /// Share of lambda squared that stands in the measured rows; the rest is a contradiction of the priors.
    pub fn in_rows(&self, signature: &[f64], sigma: f64) -> f64 {
        let rest = self.basis(sigma).remainder(&self.standardised(signature, sigma));
        (norm(&rest[..signature.len()]) / norm(&rest)).powi(2)
    }

    /// The noise at which the weakest signature has just this lambda (lambda falls with sigma), or None
    /// outside 1e-3..1e3 um.
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
