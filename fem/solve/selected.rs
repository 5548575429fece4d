//! Entries of an inverse where its Cholesky factor has entries (K. Takahashi, J. Fagan, M.-S. Chen, 8th PICA Conference,
//! 1973): from A⁻¹ = L⁻ᵀ·L⁻¹ follows, column by column from the last,
//!
//! ```text
//!     Z_ij = δ_ij/L_jj² − Σ Z_ik·L_kj / L_jj        k > j, L_kj ≠ 0, i in the same rows or j
//! ```
//!
//! and all of these Z_ik stand in the factor's pattern themselves. It costs about as much as the factor, where every column of
//! the inverse costs a solution.

use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;

use super::cholesky::Factor;

/// The entries of an inverse on the pattern of its factor.
pub(in crate::solve) struct Selected {
    /// Row of the factor by row of the matrix.
    place: Vec<usize>,
    starts: Vec<usize>,
    /// Rows of each column, the diagonal first, rising.
    rows: Vec<usize>,
    values: Vec<f64>,
}

impl Selected {
    /// The inverse of what is factored; `None` of a factor in dense blocks.
    pub fn of(factor: &Factor) -> Option<Self> {
        let SymbolicCholeskyRaw::Simplicial(symbolic) = factor.symbolic.raw() else { return None };
        let (starts, rows, lower) = (symbolic.col_ptr(), symbolic.row_idx(), &factor.values);
        let count = starts.len() - 1;
        let mut values = vec![0.0; lower.len()];
        // Of the rows of a column, where they stand in it; and what is summed up for each.
        let (mut order, mut sums) = (vec![usize::MAX; count], Vec::new());
        for column in (0..count).rev() {
            let own = starts[column]..starts[column + 1];
            let (first, below) = (own.start, own.start + 1..own.end);
            let diagonal = lower[first];
            below.clone().enumerate().for_each(|(k, at)| order[rows[at]] = k);
            sums.clear();
            sums.resize(below.len(), 0.0);
            for (k, at) in below.clone().enumerate() {
                let inverse = rows[at];
                for z in starts[inverse]..starts[inverse + 1] {
                    let i = order[rows[z]];
                    if i == usize::MAX {
                        continue;
                    }
                    sums[i] += values[z] * lower[at];
                    if i != k {
                        sums[k] += values[z] * lower[first + 1 + i];
                    }
                }
            }
            let mut own_sum = 0.0;
            for (k, at) in below.enumerate() {
                order[rows[at]] = usize::MAX;
                values[at] = -sums[k] / diagonal;
                own_sum += values[at] * lower[at];
            }
            values[first] = (1.0 / diagonal - own_sum) / diagonal;
        }
        let place = match factor.symbolic.perm() {
            Some(order) => order.arrays().1.to_vec(),
            None => (0..count).collect(),
        };
        Some(Self { place, starts: starts.to_vec(), rows: rows.to_vec(), values })
    }

    /// An entry; `None` where the factor has none.
    pub fn at(&self, row: usize, column: usize) -> Option<f64> {
        let (a, b) = (self.place[row], self.place[column]);
        let (column, row) = (a.min(b), a.max(b));
        let own = self.starts[column]..self.starts[column + 1];
        self.rows[own.clone()].binary_search(&row).ok().map(|at| self.values[own.start + at])
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;
    use nalgebra_sparse::{CooMatrix, CscMatrix};

    use super::*;
    use crate::solve::cholesky::Pattern;

    /// A ring of nodes with two chords, so that the factor fills in, in faer's own order and as it stands.
    #[test]
    fn entries_are_those_of_the_dense_inverse() {
        let count = 12;
        let mut matrix = DMatrix::zeros(count, count);
        let chords = [(0, 7), (3, 10)];
        for (i, (a, b)) in (0..count).map(|i| (i, (i + 1) % count)).chain(chords).enumerate() {
            let stiffness = 1.0 + 0.3 * i as f64;
            for (p, q, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                matrix[(p, q)] += sign * stiffness;
            }
        }
        matrix[(5, 5)] += 0.1;
        let mut upper = CooMatrix::new(count, count);
        for column in 0..count {
            (0..=column).filter(|row| matrix[(*row, column)] != 0.0).for_each(|row| {
                upper.push(row, column, matrix[(row, column)]);
            });
        }
        let upper = CscMatrix::from(&upper);
        let inverse = matrix.clone().try_inverse().unwrap();
        for pattern in [Pattern::scattered(&upper), Pattern::banded(&upper)] {
            let Ok(factor) = pattern.and_then(|pattern| pattern.factor(&upper)) else { panic!("no factor") };
            let selected = Selected::of(&factor).unwrap();
            for i in 0..count {
                for j in 0..count {
                    let own = selected.at(i, j);
                    assert!(own.is_some() || matrix[(i, j)] == 0.0, "{i} {j}");
                    let error = own.map_or(0.0, |own| (own - inverse[(i, j)]).abs());
                    assert!(error < 1e-12 * inverse[(i, i)], "{i} {j} {error}");
                }
            }
        }
    }
}
