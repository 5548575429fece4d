//! All pairs of effects at a glance: what each promises to take away, to first order, with the best shapes of both.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::gain::gain;
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

    /// The fall of χ² with both.
    fn with(&self, other: &Self) -> f64 {
        let (m, n) = (self.columns.ncols(), other.columns.ncols());
        let cross = self.columns.transpose() * &other.columns;
        let mut gram = DMatrix::zeros(m + n, m + n);
        gram.view_mut((0, 0), (m, m)).copy_from(&self.gram);
        gram.view_mut((m, m), (n, n)).copy_from(&other.gram);
        gram.view_mut((0, m), (m, n)).copy_from(&cross);
        gram.view_mut((m, 0), (n, m)).copy_from(&cross.transpose());
        let along = DVector::from_iterator(m + n, self.along.iter().chain(other.along.iter()).copied());
        let signed = [self.signed, other.signed].concat();
        gain(&gram, &along, &signed).fall
    }
}

/// How much χ² each pair of candidates promises to fall; symmetric.
pub fn falls(ground: &Ground, candidates: &[Candidate]) -> DMatrix<f64> {
    let all: Vec<Vec<Projected>> =
        candidates.iter().map(|c| c.variants.iter().map(|v| Projected::new(ground, v)).collect()).collect();
    let n = candidates.len();
    let pairs: Vec<(usize, usize)> = (0..n).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let best = |(i, j): &(usize, usize)| {
        let both = all[*i].iter().flat_map(|a| all[*j].iter().map(move |b| a.with(b)));
        both.fold(0.0, f64::max)
    };
    let falls: Vec<f64> = pairs.par_iter().map(best).collect();
    let mut matrix = DMatrix::zeros(n, n);
    for ((i, j), fall) in pairs.into_iter().zip(falls) {
        matrix[(i, j)] = fall;
        matrix[(j, i)] = fall;
    }
    matrix
}
