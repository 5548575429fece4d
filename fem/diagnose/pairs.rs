//! All pairs of effects at a glance: what each promises to take away, to first order, with the best shapes of both.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::gain::{Gain, gain};
use super::ground::Ground;
use super::signature::{Candidate, Variant};

/// A variant on the ground.
struct Projected<'a> {
    columns: DMatrix<f64>,
    gram: DMatrix<f64>,
    along: DVector<f64>,
    signed: &'a [bool],
}

impl<'a> Projected<'a> {
    fn new(ground: &Ground, variant: &'a Variant) -> Self {
        let columns = ground.project_columns(&variant.columns);
        let (gram, along) = (columns.transpose() * &columns, columns.transpose() * &ground.residual);
        Self { columns, gram, along, signed: &variant.signed }
    }

    /// What χ² gains with both.
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

/// Two candidates in the shapes that promise most together.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Variants of the one with the lower number and of the other.
    variants: [usize; 2],
    /// The amplitudes of both in the same order.
    gain: Gain,
}

impl Pair {
    /// How much χ² promises to fall.
    pub fn fall(&self) -> f64 {
        self.gain.fall
    }

    /// Variant and amplitudes of the candidate that has the lower number (0), or the higher (1).
    pub fn of(&self, candidates: [&Candidate; 2], which: usize) -> (usize, &[f64]) {
        let (first, second) = self.gain.amplitudes.split_at(candidates[0].variants[self.variants[0]].switches.len());
        (self.variants[which], [first, second][which])
    }
}

/// Every pair of candidates that promises something, by their numbers in rising order.
pub fn pairs(ground: &Ground, candidates: &[&Candidate]) -> BTreeMap<(usize, usize), Pair> {
    let all: Vec<Vec<Projected>> =
        candidates.iter().map(|c| c.variants.iter().map(|v| Projected::new(ground, v)).collect()).collect();
    let pairs: Vec<(usize, usize)> = (0..candidates.len()).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let best = |(i, j): (usize, usize)| {
        let both = all[i].iter().enumerate().flat_map(|(a, one)| {
            all[j].iter().enumerate().map(move |(b, other)| Pair { variants: [a, b], gain: one.with(other) })
        });
        let best = both.filter(|p| p.fall() > 0.0).max_by(|p, q| p.fall().total_cmp(&q.fall()))?;
        Some(((i, j), best))
    };
    pairs.into_par_iter().filter_map(best).collect()
}
