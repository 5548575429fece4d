//! Inner products of columns as the noise weighs them, beside what is fitted along; summed over the levels of a variable,
//! so that a product with any shape of that variable costs its levels and not its rows.

use nalgebra::{DMatrix, DVector};

use crate::diagnose::ProjectedResidual;
use crate::fit::Objective;
use crate::units::Kind;

/// Most directions by which rows that share noise are weighed in a search.
const MOST_SHARED: usize = 48;
/// Part of the squared length of a column that must be left beside others for it to be another.
const DEPENDENT: f64 = 1e-9;

/// How columns of one observable, in the unit of its error, are weighed: their whitening.
pub struct Metric<'a, 'm> {
    objective: &'a Objective<'m>,
    projected: &'a ProjectedResidual,
    /// Kind of the error of the observable.
    pub kind: Kind,
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

/// Shapes of a variable at its levels, all of their functions in one matrix.
pub struct Shapes {
    /// Each function, a row, at every level, a column.
    values: DMatrix<f64>,
    /// Products of two functions of one shape, as [`pair`] numbers them.
    squares: DMatrix<f64>,
    /// Where the functions of each shape begin, and where its products do.
    first: Vec<(usize, usize)>,
}

/// Sums of a form over the rows of each level, of some functions.
pub struct Sums {
    functions: usize,
    /// Products with the residual and with each direction that is fitted along, one after another, of every function: levels
    /// are rows.
    along: DMatrix<f64>,
    /// Products of two functions, as [`pair`] numbers them.
    squares: DMatrix<f64>,
    plain: DMatrix<f64>,
}

/// What functions and shapes explain by their products.
pub struct Products {
    functions: usize,
    first: Vec<(usize, usize)>,
    along: DMatrix<f64>,
    squares: DMatrix<f64>,
}

/// What functions and shapes explain together.
pub struct Together<'p> {
    ones: &'p Products,
    functions: usize,
    along: Vec<f64>,
    squares: Vec<f64>,
    both: DMatrix<f64>,
}

/// What the products of a function with two shapes explain together.
pub struct Doubles {
    first: Vec<(usize, usize)>,
    along: DMatrix<f64>,
    gram: DMatrix<f64>,
}

impl<'a, 'm> Metric<'a, 'm> {
    /// The metric of an observable.
    pub fn new(objective: &'a Objective<'m>, projected: &'a ProjectedResidual, observable: usize) -> Self {
        let data = objective.data;
        let kind = data.model.process.observables()[observable].error_kind();
        let unit = kind.canonical().factor;
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
        Self { objective, projected, kind, rows, weights, shared }
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
        let mut along = DMatrix::zeros(levels, count * (1 + self.less.len()));
        let mut plain = DMatrix::zeros(levels, count);
        let mut squares = DMatrix::zeros(levels, count * (count + 1) / 2);
        for (i, own) in functions.iter().enumerate() {
            let mut plain = plain.column_mut(i);
            rows.iter().for_each(|row| plain[level[*row]] += self.squares[*row] * own[*row]);
            for (k, direction) in std::iter::once(&self.left).chain(&self.less).enumerate() {
                let mut sum = along.column_mut(k * count + i);
                rows.iter().for_each(|row| sum[level[*row]] += direction[*row] * own[*row]);
            }
            for (j, other) in functions[..=i].iter().enumerate() {
                let mut sum = squares.column_mut(pair(i, j));
                rows.iter().for_each(|row| sum[level[*row]] += self.squares[*row] * own[*row] * other[*row]);
            }
        }
        Sums { functions: count, along, squares, plain }
    }
}

/// Position of a pair of functions, in any order.
fn pair(i: usize, j: usize) -> usize {
    let (i, j) = (i.max(j), i.min(j));
    i * (i + 1) / 2 + j
}

impl Shapes {
    /// The functions of each shape, each at every level.
    pub fn new(shapes: &[Vec<Vec<f64>>]) -> Self {
        let levels = shapes.first().and_then(|own| own.first()).map_or(0, Vec::len);
        let (mut functions, mut products, mut first) = (Vec::new(), Vec::new(), Vec::new());
        for own in shapes {
            first.push((functions.len(), products.len()));
            for (i, one) in own.iter().enumerate() {
                products.extend(
                    own[..=i].iter().map(|other| -> Vec<f64> { one.iter().zip(other).map(|(a, b)| a * b).collect() }),
                );
            }
            functions.extend(own);
        }
        first.push((functions.len(), products.len()));
        let values = DMatrix::from_fn(functions.len(), levels, |function, level| functions[function][level]);
        let squares = DMatrix::from_fn(products.len(), levels, |product, level| products[product][level]);
        Self { values, squares, first }
    }

    /// The functions of a shape in every row, of which the level is given.
    pub fn spread(&self, shape: usize, level: &[usize]) -> Vec<Vec<f64>> {
        let functions = self.first[shape].0..self.first[shape + 1].0;
        functions.map(|function| level.iter().map(|at| self.values[(function, *at)]).collect()).collect()
    }
}

impl Sums {
    /// What the products of the functions with each of some shapes explain.
    pub fn products(&self, shapes: &Shapes) -> Products {
        Products {
            functions: self.functions,
            first: shapes.first.clone(),
            along: &shapes.values * &self.along,
            squares: &shapes.squares * &self.squares,
        }
    }

    /// What the functions and each of some shapes explain together; `ones` is what the shapes do alone.
    pub fn together<'p>(&self, shapes: &Shapes, ones: &'p Products) -> Together<'p> {
        let whole = |own: &DMatrix<f64>| own.column_iter().map(|column| column.sum()).collect();
        Together {
            ones,
            functions: self.functions,
            along: whole(&self.along),
            squares: whole(&self.squares),
            both: &shapes.values * &self.plain,
        }
    }

    /// What the products of the only function with each two of some shapes explain together.
    pub fn doubles(&self, shapes: &Shapes) -> Doubles {
        let mut weighed = shapes.values.clone();
        for (mut column, square) in weighed.column_iter_mut().zip(self.squares.column(0).iter()) {
            column *= *square;
        }
        Doubles {
            first: shapes.first.clone(),
            along: &shapes.values * &self.along,
            gram: weighed * shapes.values.transpose(),
        }
    }
}

impl Products {
    /// Fall of χ² by the products with a shape, and their number.
    pub fn gain(&self, shape: usize) -> (f64, usize) {
        let ((first, of_pairs), (end, _)) = (self.first[shape], self.first[shape + 1]);
        let count = end - first;
        let column = |c: usize| (c / count, c % count);
        let along = |k: usize, c: usize| {
            let (i, j) = column(c);
            self.along[(first + j, k * self.functions + i)]
        };
        let square = |c: usize, d: usize| {
            let ((i, j), (k, l)) = (column(c), column(d));
            self.squares[(of_pairs + pair(j, l), pair(i, k))]
        };
        explained(self.functions * count, self.along.ncols() / self.functions - 1, along, square)
    }
}

impl Together<'_> {
    /// Fall of χ² by the functions and a shape together, and the number of both.
    pub fn gain(&self, shape: usize) -> (f64, usize) {
        let ((first, of_pairs), (end, _)) = (self.ones.first[shape], self.ones.first[shape + 1]);
        let own = self.functions;
        let along = |k: usize, c: usize| match c < own {
            true => self.along[k * own + c],
            false => self.ones.along[(first + c - own, k)],
        };
        let square = |c: usize, d: usize| match (c < own, d < own) {
            (true, true) => self.squares[pair(c, d)],
            (false, true) => self.both[(first + c - own, d)],
            (true, false) => self.both[(first + d - own, c)],
            (false, false) => self.ones.squares[(of_pairs + pair(c - own, d - own), 0)],
        };
        explained(own + end - first, self.ones.along.ncols() - 1, along, square)
    }
}

impl Doubles {
    /// Fall of χ² by the products with two shapes, and their number.
    pub fn gain(&self, one: usize, other: usize) -> (f64, usize) {
        let of = |shape: usize| (self.first[shape].0, self.first[shape + 1].0 - self.first[shape].0);
        let ((a, count), (b, more)) = (of(one), of(other));
        let at = |c: usize| if c < count { a + c } else { b + c - count };
        let along = |k: usize, c: usize| self.along[(at(c), k)];
        explained(count + more, self.along.ncols() - 1, along, |c, d| self.gram[(at(c), at(d))])
    }
}

/// Fall of χ² by columns of which the products with each other and with the residual (0) and the directions that are fitted
/// along (from 1 on) are known, and how many of them are independent (Gram and Schmidt, by way of the Gram matrix).
fn explained(
    count: usize,
    directions: usize,
    along: impl Fn(usize, usize) -> f64,
    square: impl Fn(usize, usize) -> f64,
) -> (f64, usize) {
    /// Room for the functions of two factors, which are six at most.
    const MOST: usize = 8;
    let count = count.min(MOST);
    let mut lower = [[0.0; MOST]; MOST];
    let mut solved = [0.0; MOST];
    let (mut gain, mut rank) = (0.0, 0);
    for i in 0..count {
        let whole = square(i, i);
        let mut own = whole - (1..=directions).map(|k| along(k, i).powi(2)).sum::<f64>();
        let mut rest = along(0, i);
        for j in 0..i {
            if lower[j][j] == 0.0 {
                continue;
            }
            let mut both = square(i, j) - (1..=directions).map(|k| along(k, i) * along(k, j)).sum::<f64>();
            both -= lower[i].iter().zip(&lower[j]).take(j).map(|(one, other)| one * other).sum::<f64>();
            let part = both / lower[j][j];
            lower[i][j] = part;
            own -= part * part;
            rest -= part * solved[j];
        }
        if !own.is_finite() || !rest.is_finite() {
            return (0.0, 1);
        }
        if own > DEPENDENT * whole.max(f64::MIN_POSITIVE) {
            lower[i][i] = own.sqrt();
            solved[i] = rest / lower[i][i];
            gain += solved[i] * solved[i];
            rank += 1;
        }
    }
    (gain, rank.max(1))
}
