//! Screens all pairs of effects: the gain of each pair, to first order, with the best variants of both.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::gain::{Gain, gain};
use super::residual_projection::ProjectedResidual;
use super::sensitivity::{CandidateEffect, Variant};

/// Variant with the model's own freedom projected out.
struct ProjectedVariant<'a> {
    columns: DMatrix<f64>,
    gram: DMatrix<f64>,
    along: DVector<f64>,
    signed: &'a [bool],
}

impl<'a> ProjectedVariant<'a> {
    fn new(projected: &ProjectedResidual, variant: &'a Variant) -> Self {
        let columns = projected.project_columns(&variant.columns);
        let (gram, along) = (columns.transpose() * &columns, columns.transpose() * &projected.residual);
        Self { columns, gram, along, signed: &variant.signed }
    }

    /// Gain with both variants.
    fn with(&self, other: &Self) -> Gain {
        let (m, n) = (self.columns.ncols(), other.columns.ncols());
        let cross = self.columns.transpose() * &other.columns;
        let mut gram = DMatrix::zeros(m + n, m + n);
        gram.view_mut((0, 0), (m, m)).copy_from(&self.gram);
        gram.view_mut((m, m), (n, n)).copy_from(&other.gram);
        gram.view_mut((0, m), (m, n)).copy_from(&cross);
        gram.view_mut((m, 0), (n, m)).copy_from(&cross.transpose());
        let along = DVector::from_iterator(m + n, self.along.iter().chain(other.along.iter()).copied());
        let signed = [self.signed, other.signed].concat();
        gain(&gram, &along, &signed)
    }
}

/// Two candidate effects in the variants with the largest joint gain.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Variant of the effect with the lower number, and that of the other.
    variants: [usize; 2],
    /// Joint gain, with the amplitudes of both in the same order.
    gain: Gain,
}

impl Pair {
    /// Fall of χ² to first order.
    pub fn delta_chi2(&self) -> f64 {
        self.gain.delta_chi2
    }

    /// Variant and amplitudes of the effect with the lower number (0) or the higher (1).
    pub fn of(&self, candidates: [&CandidateEffect; 2], which: usize) -> (usize, &[f64]) {
        let (first, second) = self.gain.amplitudes.split_at(candidates[0].variants[self.variants[0]].linear.len());
        (self.variants[which], [first, second][which])
    }
}

/// Finds the joint gain of every pair of candidate effects that has any, by their numbers in rising order.
pub fn pairs(projected: &ProjectedResidual, candidates: &[&CandidateEffect]) -> BTreeMap<(usize, usize), Pair> {
    let all: Vec<Vec<ProjectedVariant>> =
        candidates.iter().map(|c| c.variants.iter().map(|v| ProjectedVariant::new(projected, v)).collect()).collect();
    let pairs: Vec<(usize, usize)> = (0..candidates.len()).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let best = |(i, j): (usize, usize)| {
        let both = all[i].iter().enumerate().flat_map(|(a, one)| {
            all[j].iter().enumerate().map(move |(b, other)| Pair { variants: [a, b], gain: one.with(other) })
        });
        let best = both.filter(|p| p.delta_chi2() > 0.0).max_by(|p, q| p.delta_chi2().total_cmp(&q.delta_chi2()))?;
        Some(((i, j), best))
    };
    pairs.into_par_iter().filter_map(best).collect()
}
