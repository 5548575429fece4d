//! Least-squares projection by Gram-Schmidt with re-orthogonalisation: the columns are few, so nothing
//! finer is needed.

/// An orthonormal basis of a growing span.
#[derive(Debug, Clone, Default)]
pub struct Basis {
    vectors: Vec<Vec<f64>>,
}

impl Basis {
    /// The basis of the span of `columns`; columns that depend on earlier ones are dropped.
    pub fn of(columns: &[Vec<f64>]) -> Self {
        let mut basis = Self::default();
        for column in columns {
            basis.add(column);
        }
        basis
    }

    /// Adds one direction unless it already lies in the span (to 1e-9 of its length).
    pub fn add(&mut self, column: &[f64]) {
        let rest = self.remainder(column);
        let size = norm(&rest);
        if size > 1e-9 * norm(column) && size > 0.0 {
            self.vectors.push(rest.iter().map(|v| v / size).collect());
        }
    }

    /// What of `vector` the span cannot imitate. Twice is enough (Kahan): the second pass removes the first
    /// one's rounding.
    pub fn remainder(&self, vector: &[f64]) -> Vec<f64> {
        let mut rest = vector.to_vec();
        for _ in 0..2 {
            for direction in &self.vectors {
                let along = dot(direction, &rest);
                rest.iter_mut().zip(direction).for_each(|(r, d)| *r -= along * d);
            }
        }
        rest
    }
}

/// Scalar product.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Euclidean length.
pub fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// Solves the small square system `matrix * x = right` by elimination with row exchange.
pub fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| matrix[i][k].abs().total_cmp(&matrix[j][k].abs())).unwrap_or(k);
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        for i in k + 1..n {
            let factor = matrix[i][k] / matrix[k][k];
            let (upper, lower) = matrix.split_at_mut(i);
            lower[0].iter_mut().zip(&upper[k]).skip(k).for_each(|(a, b)| *a -= factor * b);
            right[i] -= factor * right[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| matrix[k][j] * right[j]).sum();
        right[k] = (right[k] - known) / matrix[k][k];
    }
    right
}

/// Root of `f` between `low` and `high`, where it changes sign, by Chandrupatla's mixture of bisection and
/// inverse quadratic steps: safe at the infinite slope of a contact law at zero force, and a few steps
/// where the function is nearly straight.
pub fn root(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b, mut fa, mut fb) = (high, low, f(high), f(low));
    let (mut c, mut fc);
    let mut share = 0.5;
    if fa == 0.0 || fb == 0.0 || fa.signum() == fb.signum() {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    for _ in 0..200 {
        let x = a + share * (b - a);
        let fx = f(x);
        if fx.signum() == fa.signum() {
            (c, fc) = (a, fa);
        } else {
            (c, b, fc, fb) = (b, a, fb, fa);
        }
        (a, fa) = (x, fx);
        let (best, size) = if fa.abs() < fb.abs() { (a, fa) } else { (b, fb) };
        let tolerance = 2e-15 * best.abs() + 1e-14 * (high - low).abs();
        let limit = 0.5 * tolerance / (b - a).abs();
        if limit > 0.25 || size == 0.0 {
            return best;
        }
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        share = if phi * phi < xi && (1.0 - phi).powi(2) < 1.0 - xi {
            fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        } else {
            0.5
        };
        share = share.clamp(limit, 1.0 - limit);
    }
    a
}
