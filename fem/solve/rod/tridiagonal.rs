//! Symmetric tridiagonal matrices.

/// A symmetric tridiagonal matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Tridiagonal {
    /// Diagonal entries (n).
    pub diagonal: Vec<f64>,
    /// Entries between i and i + 1 (n − 1).
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

    /// to −= self · x
    pub fn subtract_product(&self, x: &[f64], to: &mut [f64]) {
        let last = x.len() - 1;
        let (diagonal, beside) = (&self.diagonal[..=last], &self.beside[..last]);
        if last == 0 {
            to[0] -= diagonal[0] * x[0];
            return;
        }
        to[0] -= diagonal[0] * x[0] + beside[0] * x[1];
        let inner = to[1..last].iter_mut().zip(&diagonal[1..last]).zip(x.windows(3)).zip(beside.windows(2));
        for (((to, d), x), b) in inner {
            *to -= b[0] * x[0] + d * x[1] + b[1] * x[2];
        }
        to[last] -= diagonal[last] * x[last] + beside[last - 1] * x[last - 1];
    }

    /// Sums of the rows.
    pub fn row_sums(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.diagonal.len()];
        self.subtract_product(&vec![-1.0; sums.len()], &mut sums);
        sums
    }
}

/// A positive definite tridiagonal matrix, eliminated from both ends towards the middle: the two ways do not
/// wait for each other.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Multiplier that carries each row to the next one towards the middle.
    carried: Vec<f64>,
    /// Inverse of each pivot.
    inverse: Vec<f64>,
}

impl Factor {
    /// The factor of a + factor · b, both positive semidefinite and a definite, so that no pivot vanishes.
    pub fn of_sum(a: &Tridiagonal, factor: f64, b: &Tridiagonal) -> Self {
        let size = a.diagonal.len();
        let beside = |i: usize| a.beside[i] + factor * b.beside[i];
        let mut pivot: Vec<f64> = a.diagonal.iter().zip(&b.diagonal).map(|(a, b)| a + factor * b).collect();
        let mut carried = vec![0.0; size];
        let middle = size / 2;
        for i in 0..middle {
            carried[i] = beside(i) / pivot[i];
            pivot[i + 1] -= carried[i] * beside(i);
        }
        for i in (middle + 1..size).rev() {
            carried[i] = beside(i - 1) / pivot[i];
            pivot[i - 1] -= carried[i] * beside(i - 1);
        }
        Self { carried, inverse: pivot.into_iter().map(f64::recip).collect() }
    }

    /// Solves in place.
    pub fn solve(&self, x: &mut [f64]) {
        let size = x.len();
        let middle = size / 2;
        let (carried, inverse) = (&self.carried[..size], &self.inverse[..size]);
        let (lower, upper) = x.split_at_mut(middle);
        // Rows 0 .. middle and, from the other end, size − 1 .. middle.
        let (mut below, mut above) = (0.0, 0.0);
        let steps = lower.len().min(upper.len() - 1);
        for i in 0..steps {
            let j = upper.len() - 1 - i;
            lower[i] -= below;
            upper[j] -= above;
            below = carried[i] * lower[i];
            above = carried[middle + j] * upper[j];
        }
        if lower.len() > steps {
            lower[steps] -= below;
            below = carried[steps] * lower[steps];
        }
        upper[0] = (upper[0] - below - above) * inverse[middle];
        let (mut below, mut above) = (upper[0], upper[0]);
        let steps = lower.len().min(upper.len() - 1);
        for i in 0..steps {
            let (k, j) = (lower.len() - 1 - i, 1 + i);
            lower[k] = lower[k] * inverse[k] - carried[k] * below;
            upper[j] = upper[j] * inverse[middle + j] - carried[middle + j] * above;
            (below, above) = (lower[k], upper[j]);
        }
        if lower.len() > steps {
            lower[0] = lower[0] * inverse[0] - carried[0] * below;
        }
    }
}

/// Σ aᵢ·bᵢ by four sums side by side.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (fours, rest) = a.as_chunks::<4>();
    let (others, last) = b.as_chunks::<4>();
    for (a, b) in fours.iter().zip(others) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    let rest: f64 = rest.iter().zip(last).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_solves_systems_of_any_size() {
        for size in 1..12 {
            let mut matrix = Tridiagonal::zeros(size);
            for i in 0..size {
                matrix.diagonal[i] = 3.0 + i as f64;
                if i + 1 < size {
                    matrix.beside[i] = -1.0 - 0.1 * i as f64;
                }
            }
            let zero = Tridiagonal::zeros(size);
            let exact: Vec<f64> = (0..size).map(|i| (i as f64).cos()).collect();
            let mut x = vec![0.0; size];
            matrix.subtract_product(&exact, &mut x);
            x.iter_mut().for_each(|x| *x = -*x);
            Factor::of_sum(&matrix, 1.0, &zero).solve(&mut x);
            assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-14), "{size}: {x:?} {exact:?}");
        }
    }
}
