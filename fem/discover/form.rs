//! Inner products of columns as the noise weighs them, beside what is fitted along; summed over the levels of a variable,
//! so that a product with any shape of that variable costs its levels and not its rows.

use nalgebra::{DMatrix, DVector};

use crate::diagnose::ProjectedResidual;
use crate::fit::Objective;

/// Most directions by which rows that share noise are weighed in a search.
const MOST_SHARED: usize = 48;
/// Part of the squared length of a column that must be left beside others for it to be another.
const DEPENDENT: f64 = 1e-9;

/// How columns of one observable, in the unit of its error, are weighed: their whitening.
pub struct Metric<'a, 'm> {
    objective: &'a Objective<'m>,
    projected: &'a ProjectedResidual,
    /// Rows of the observable.
    pub rows: Vec<usize>,
    /// The unit of the error over the standard uncertainty of each row; of rows of another observable 0.
    weights: Vec<f64>,
    /// The whitening as a matrix, where rows share noise.
    shared: Option<DMatrix<f64>>,
}

/// A bilinear form of columns, and a linear one: what a column explains of a residual.
pub struct Form {
    /// Square of the weight of each row.
    squares: Vec<f64>,
    /// Directions that are fitted along: products with them are taken off.
    less: Vec<Vec<f64>>,
    /// The residual, weighed.
    left: Vec<f64>,
    /// χ² of the residual.
    pub chi2: f64,
}

/// Sums of a form over the rows of each level, of some functions.
pub struct Sums {
    levels: usize,
    functions: usize,
    left: Vec<f64>,
    less: Vec<f64>,
    squares: Vec<f64>,
    plain: Vec<f64>,
}

impl<'a, 'm> Metric<'a, 'm> {
    /// The metric of an observable.
    pub fn new(objective: &'a Objective<'m>, projected: &'a ProjectedResidual, observable: usize) -> Self {
        let data = objective.data;
        let unit = data.model.process.observables()[observable].error_kind().canonical().factor;
        let is_own = |row: usize| data.rows.observable[row] == observable;
        let rows: Vec<usize> = (0..data.len()).filter(|row| is_own(*row)).collect();
        let weight = |(row, sigma): (usize, &f64)| if is_own(row) { unit / sigma } else { 0.0 };
        let weights: Vec<f64> = objective.noise.sigma.iter().enumerate().map(weight).collect();
        let shared = objective.noise.is_shared().then(|| {
            let one = |column: usize| {
                let of = |row: usize| if row == column && is_own(row) { unit } else { 0.0 };
                objective.whiten((0..data.len()).map(of))
            };
            DMatrix::from_columns(&(0..data.len()).map(one).collect::<Vec<_>>())
        });
        Self { objective, projected, rows, weights, shared }
    }

    /// The unit of the error over the usual standard uncertainty of a row.
    pub fn weight(&self) -> f64 {
        let mut all: Vec<f64> = self.rows.iter().map(|row| self.weights[*row]).collect();
        all.sort_unstable_by(f64::total_cmp);
        all.get(all.len() / 2).copied().unwrap_or(0.0)
    }

    /// Columns in standard uncertainties, beside what the model's own parameters imitate.
    pub fn seen(&self, columns: &[Vec<f64>]) -> Vec<DVector<f64>> {
        let rows = self.objective.data.len();
        let own = |column: &Vec<f64>| {
            let mut whole = vec![0.0; rows];
            match &self.shared {
                None => {
                    self.rows.iter().for_each(|row| whole[*row] = self.weights[*row] * column[*row]);
                    let priors = self.projected.residual.len() - rows;
                    self.projected.project(DVector::from_iterator(
                        rows + priors,
                        whole.into_iter().chain(std::iter::repeat_n(0.0, priors)),
                    ))
                }
                Some(shared) => {
                    self.rows.iter().for_each(|row| whole[*row] = column[*row]);
                    self.projected.project(shared * DVector::from_vec(whole))
                }
            }
        };
        columns.iter().map(own).collect()
    }

    /// The form beside columns that are fitted along, orthonormal.
    pub fn beside(&self, columns: &[DVector<f64>]) -> Form {
        let mut left = self.projected.residual.clone();
        for other in columns {
            let along = other.dot(&left);
            left.axpy(-along, other, 1.0);
        }
        let along = self.projected.tangent().column_iter().map(|column| column.into_owned());
        let mut less: Vec<Vec<f64>> = along.chain(columns.iter().cloned()).map(|column| self.back(&column)).collect();
        less.extend(self.of_shared());
        let squares = self.weights.iter().map(|weight| weight * weight).collect();
        Form { squares, less, left: self.back(&left), chi2: left.norm_squared() }
    }

    /// The transposed of whitening.
    fn back(&self, white: &DVector<f64>) -> Vec<f64> {
        match &self.shared {
            None => self.weights.iter().zip(white.iter()).map(|(weight, value)| weight * value).collect(),
            Some(shared) => shared.tr_mul(white).iter().copied().collect(),
        }
    }

    /// What shared noise takes off the weights of single rows, as directions: the leading ones of a pivoted Cholesky
    /// factorisation.
    fn of_shared(&self) -> Vec<Vec<f64>> {
        let Some(shared) = &self.shared else { return Vec::new() };
        let mut rest = -(shared.transpose() * shared);
        self.weights.iter().enumerate().for_each(|(row, weight)| rest[(row, row)] += weight * weight);
        let most = rest.diagonal().max();
        let mut directions = Vec::new();
        while directions.len() < MOST_SHARED {
            let (pivot, size) = rest.diagonal().argmax();
            if size <= DEPENDENT * most {
                break;
            }
            let direction = rest.column(pivot) / size.sqrt();
            rest -= &direction * direction.transpose();
            directions.push(direction.iter().copied().collect());
        }
        directions
    }
}

impl Form {
    /// Sums of functions over the rows of each level; `level` of every row.
    pub fn sums(&self, rows: &[usize], functions: &[Vec<f64>], (level, levels): (&[usize], usize)) -> Sums {
        let count = functions.len();
        let mut left = vec![0.0; count * levels];
        let mut plain = vec![0.0; count * levels];
        let mut less = vec![0.0; self.less.len() * count * levels];
        let mut squares = vec![0.0; count * (count + 1) / 2 * levels];
        for (i, own) in functions.iter().enumerate() {
            for row in rows {
                left[i * levels + level[*row]] += self.left[*row] * own[*row];
                plain[i * levels + level[*row]] += self.squares[*row] * own[*row];
            }
            for (k, direction) in self.less.iter().enumerate() {
                let start = (k * count + i) * levels;
                rows.iter().for_each(|row| less[start + level[*row]] += direction[*row] * own[*row]);
            }
            for (j, other) in functions[..=i].iter().enumerate() {
                let start = pair(i, j) * levels;
                rows.iter()
                    .for_each(|row| squares[start + level[*row]] += self.squares[*row] * own[*row] * other[*row]);
            }
        }
        Sums { levels, functions: count, left, less, squares, plain }
    }
}

/// Position of a pair of functions, the second no later than the first.
fn pair(i: usize, j: usize) -> usize {
    i * (i + 1) / 2 + j
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Sums {
    fn of<'s>(&self, values: &'s [f64], position: usize) -> &'s [f64] {
        &values[position * self.levels..(position + 1) * self.levels]
    }

    /// Fall of χ² by the products of the functions with others, given at each level, and their number.
    pub fn gain_of_product(&self, others: &[Vec<f64>]) -> (f64, usize) {
        let columns: Vec<(usize, usize)> =
            (0..self.functions).flat_map(|i| (0..others.len()).map(move |j| (i, j))).collect();
        let along = |values: &[f64], position: usize, j: usize| dot(self.of(values, position), &others[j]);
        let left: Vec<f64> = columns.iter().map(|(i, j)| along(&self.left, *i, *j)).collect();
        let directions = self.less.len() / (self.functions * self.levels).max(1);
        let less: Vec<Vec<f64>> = (0..directions)
            .map(|k| columns.iter().map(|(i, j)| along(&self.less, k * self.functions + i, *j)).collect())
            .collect();
        let mut products = vec![0.0; self.levels];
        let square = |(i, j): (usize, usize), (k, l): (usize, usize)| {
            let both = self.of(&self.squares, pair(i.max(k), i.min(k)));
            products.iter_mut().zip(others[j].iter().zip(&others[l])).for_each(|(p, (a, b))| *p = a * b);
            dot(both, &products)
        };
        explained(&columns, &left, &less, square)
    }

    /// Fall of χ² by the functions and others, given at each level, together; `ones` are the sums of the function 1.
    pub fn gain_of_sum(&self, ones: &Self, others: &[Vec<f64>]) -> (f64, usize) {
        let columns: Vec<(bool, usize)> =
            (0..self.functions).map(|i| (true, i)).chain((0..others.len()).map(|j| (false, j))).collect();
        let whole = |values: &[f64], position: usize| self.of(values, position).iter().sum::<f64>();
        let left: Vec<f64> = columns
            .iter()
            .map(|(is_own, i)| if *is_own { whole(&self.left, *i) } else { dot(&ones.left, &others[*i]) })
            .collect();
        let directions = ones.less.len() / self.levels.max(1);
        let less: Vec<Vec<f64>> = (0..directions)
            .map(|k| {
                columns
                    .iter()
                    .map(|(is_own, i)| match is_own {
                        true => whole(&self.less, k * self.functions + i),
                        false => dot(ones.of(&ones.less, k), &others[*i]),
                    })
                    .collect()
            })
            .collect();
        let square = |a: (bool, usize), b: (bool, usize)| match (a, b) {
            ((true, i), (true, k)) => whole(&self.squares, pair(i.max(k), i.min(k))),
            ((true, i), (false, j)) | ((false, j), (true, i)) => dot(self.of(&self.plain, i), &others[j]),
            ((false, j), (false, l)) => {
                others[j].iter().zip(&others[l]).zip(&ones.squares).map(|((a, b), one)| a * b * one).sum()
            }
        };
        explained(&columns, &left, &less, square)
    }
}

/// Fall of χ² by columns of which the products with each other, the residual and the directions that are fitted along are
/// known, and how many of them are independent (Gram and Schmidt, by way of the Gram matrix).
fn explained<C: Copy>(
    columns: &[C],
    left: &[f64],
    less: &[Vec<f64>],
    mut square: impl FnMut(C, C) -> f64,
) -> (f64, usize) {
    let count = columns.len();
    let mut lower = DMatrix::<f64>::zeros(count, count);
    let mut solved = vec![0.0; count];
    let (mut gain, mut rank) = (0.0, 0);
    for i in 0..count {
        let whole = square(columns[i], columns[i]);
        let mut own = whole - less.iter().map(|along| along[i] * along[i]).sum::<f64>();
        let mut rest = left[i];
        for j in 0..i {
            if lower[(j, j)] == 0.0 {
                continue;
            }
            let mut both = square(columns[i], columns[j]) - less.iter().map(|along| along[i] * along[j]).sum::<f64>();
            for k in 0..j {
                both -= lower[(i, k)] * lower[(j, k)];
            }
            let along = both / lower[(j, j)];
            lower[(i, j)] = along;
            own -= along * along;
            rest -= along * solved[j];
        }
        if !own.is_finite() || !rest.is_finite() {
            return (0.0, 1);
        }
        if own > DEPENDENT * whole.max(f64::MIN_POSITIVE) {
            lower[(i, i)] = own.sqrt();
            solved[i] = rest / lower[(i, i)];
            gain += solved[i] * solved[i];
            rank += 1;
        }
    }
    (gain, rank.max(1))
}
