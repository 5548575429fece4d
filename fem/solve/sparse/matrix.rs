//! A symmetric matrix over all freedoms of a mesh.

use std::sync::Arc;

use super::Pattern;

/// A symmetric matrix: pattern and values of its lower triangle. Vectors are in the order of the matrix
/// ([`Freedoms::gather`](super::Freedoms::gather)).
#[derive(Clone, Debug)]
pub struct Matrix {
    pattern: Arc<Pattern>,
    values: Vec<f64>,
}

impl Matrix {
    pub(super) fn from_parts(pattern: Arc<Pattern>, values: Vec<f64>) -> Self {
        Self { pattern, values }
    }

    pub(super) fn parts_mut(&mut self) -> (&Pattern, &mut [f64]) {
        (&self.pattern, &mut self.values)
    }

    /// The pattern of the matrix.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// `own · self + factor · other`; both must have the same pattern.
    pub fn combined(&self, own: f64, other: &Self, factor: f64) -> Self {
        let values = self.values.iter().zip(&other.values).map(|(a, b)| own * a + factor * b).collect();
        Self { pattern: Arc::clone(&self.pattern), values }
    }

    /// Every entry times the mean of the factors of its row and of its column.
    #[must_use]
    pub fn averaged(&self, factors: &[f64]) -> Self {
        let mut own = self.clone();
        for (column, factor) in factors.iter().enumerate() {
            let start = self.pattern.starts[column] as usize;
            for (&row, value) in self.pattern.column(column).iter().zip(&mut own.values[start..]) {
                *value *= 0.5 * (factor + factors[row as usize]);
            }
        }
        own
    }

    /// Adds to the diagonal entry of a column.
    pub fn add_diagonal(&mut self, number: usize, value: f64) {
        self.values[self.pattern.starts[number] as usize] += value;
    }

    /// Diagonal entry of a column.
    pub fn diagonal(&self, number: usize) -> f64 {
        self.values[self.pattern.starts[number] as usize]
    }

    /// y += factor · A x.
    pub fn multiply_add(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        for column in 0..self.pattern.size() {
            let start = self.pattern.starts[column] as usize;
            let rows = self.pattern.column(column);
            let values = &self.values[start..start + rows.len()];
            let here = factor * x[column];
            let mut sum = values[0] * here;
            let mut across = 0.0;
            for (&row, &value) in rows[1..].iter().zip(&values[1..]) {
                y[row as usize] += value * here;
                across += value * x[row as usize];
            }
            sum += factor * across;
            y[column] += sum;
        }
    }

    /// y += factor · A x in the free rows, where `x` counts in the held columns only.
    pub fn add_held_columns(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        for (column, row, value) in self.border() {
            y[column] += factor * value * x[row];
        }
    }

    /// y += factor · A x in the held rows only.
    pub fn add_held_rows(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        for (column, row, value) in self.border() {
            y[row] += factor * value * x[column];
        }
        for column in self.pattern.free_rows.len()..self.pattern.size() {
            let start = self.pattern.starts[column] as usize;
            for (&row, &value) in self.pattern.column(column).iter().zip(&self.values[start..]) {
                y[row as usize] += factor * value * x[column];
                if row as usize != column {
                    y[column] += factor * value * x[row as usize];
                }
            }
        }
    }

    /// Entries (column, row, value) in free columns and held rows.
    fn border(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        self.pattern.border.iter().map(|&(column, entry)| {
            (column as usize, self.pattern.rows[entry as usize] as usize, self.values[entry as usize])
        })
    }

    /// A x.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        self.multiply_add(1.0, x, &mut y);
        y
    }

    /// Largest absolute entry.
    pub fn largest(&self) -> f64 {
        self.values.iter().fold(0.0, |largest, value| largest.max(value.abs()))
    }

    /// Bytes held by the values.
    pub fn bytes(&self) -> usize {
        8 * self.values.len()
    }
}
