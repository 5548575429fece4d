//! Symmetric tridiagonal matrices.

/// A symmetric tridiagonal matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Tridiagonal {
    /// (n)
    pub diagonal: Vec<f64>,
    /// Between i and i + 1. (n − 1)
    pub beside: Vec<f64>,
}

impl Tridiagonal {
    pub fn zeros(size: usize) -> Self {
        Self { diagonal: vec![0.0; size], beside: vec![0.0; size.saturating_sub(1)] }
    }

    /// Adds own·[[1, 0], [0, 1]] + mixed·[[0, 1], [1, 0]] between i and i + 1.
    pub fn add_pair(&mut self, i: usize, own: f64, mixed: f64) {
        self.diagonal[i] += own;
        self.diagonal[i + 1] += own;
        self.beside[i] += mixed;
    }

    /// to += factor · self · x
    pub fn multiply_add(&self, factor: f64, x: &[f64], to: &mut [f64]) {
        for ((to, d), x) in to.iter_mut().zip(&self.diagonal).zip(x) {
            *to += factor * d * x;
        }
        for (i, b) in self.beside.iter().enumerate() {
            to[i] += factor * b * x[i + 1];
            to[i + 1] += factor * b * x[i];
        }
    }

    /// Sums of the rows.
    pub fn row_sums(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.diagonal.len()];
        self.multiply_add(1.0, &vec![1.0; sums.len()], &mut sums);
        sums
    }
}

/// L·D·Lᵀ of a positive definite tridiagonal matrix.
#[derive(Clone, Debug)]
pub struct Factor {
    lower: Vec<f64>,
    /// 1/D
    inverse: Vec<f64>,
}

impl Factor {
    /// Of a + factor · b, both positive semidefinite and a definite, so that no pivot vanishes.
    pub fn of_sum(a: &Tridiagonal, factor: f64, b: &Tridiagonal) -> Self {
        let size = a.diagonal.len();
        let (mut lower, mut inverse) = (vec![0.0; size], vec![0.0; size]);
        let mut carried = 0.0;
        for i in 0..size {
            let pivot = a.diagonal[i] + factor * b.diagonal[i] - carried;
            inverse[i] = 1.0 / pivot;
            if i + 1 < size {
                let beside = a.beside[i] + factor * b.beside[i];
                lower[i] = beside * inverse[i];
                carried = lower[i] * beside;
            }
        }
        Self { lower, inverse }
    }

    /// Solves in place.
    pub fn solve(&self, x: &mut [f64]) {
        for i in 1..x.len() {
            x[i] -= self.lower[i - 1] * x[i - 1];
        }
        let last = x.len() - 1;
        x[last] *= self.inverse[last];
        for i in (0..last).rev() {
            x[i] = x[i] * self.inverse[i] - self.lower[i] * x[i + 1];
        }
    }
}
