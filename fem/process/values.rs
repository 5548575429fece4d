//! The values of a coordinate in every row.

use std::ops::Index;

/// Values of a coordinate in every row, SI; NaN where a row has none. What all rows share is kept once: most coordinates
/// of a file are left out of it, and files have a million rows.
#[derive(Clone, Debug, Default)]
pub struct Values {
    /// The value of each row, or one for all of them.
    kept: Vec<f64>,
    rows: usize,
}

impl Values {
    /// One value in all of so many rows.
    pub fn shared(value: f64, rows: usize) -> Self {
        Self { kept: vec![value], rows }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// The values, row by row.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &f64> + ExactSizeIterator + Clone {
        (0..self.rows).map(|row| &self[row])
    }

    /// The values, one for each row.
    pub fn to_vec(&self) -> Vec<f64> {
        self.iter().copied().collect()
    }

    /// Those of these rows, in this order.
    #[must_use]
    pub fn some(&self, rows: &[usize]) -> Self {
        match self.kept[..] {
            [value] => Self::shared(value, rows.len()),
            _ => rows.iter().map(|row| self[*row]).collect(),
        }
    }

    /// Gives all rows one value.
    pub fn fill(&mut self, value: f64) {
        self.kept = vec![value];
    }

    /// Gives a value to all rows that have none.
    pub fn fill_absent(&mut self, value: f64) {
        self.kept.iter_mut().filter(|own| own.is_nan()).for_each(|own| *own = value);
    }

    /// Gives a row a value of its own.
    ///
    /// # Panics
    /// There is no such row.
    pub fn set(&mut self, row: usize, value: f64) {
        if self[row].to_bits() != value.to_bits() {
            self.spread();
            self.kept[row] = value;
        }
    }

    /// Adds a row.
    pub fn push(&mut self, value: f64) {
        let is_shared = self.kept.first().is_none_or(|first| first.to_bits() == value.to_bits());
        if self.kept.is_empty() {
            self.kept.push(value);
        } else if self.kept.len() > 1 || !is_shared {
            self.spread();
            self.kept.push(value);
        }
        self.rows += 1;
    }

    /// Keeps a value for each row.
    fn spread(&mut self) {
        if let [value] = self.kept[..] {
            self.kept.resize(self.rows, value);
        }
    }
}

impl Index<usize> for Values {
    type Output = f64;

    fn index(&self, row: usize) -> &f64 {
        assert!(row < self.rows, "row {row} of {}", self.rows);
        &self.kept[if self.kept.len() == 1 { 0 } else { row }]
    }
}

impl From<Vec<f64>> for Values {
    fn from(mut kept: Vec<f64>) -> Self {
        let rows = kept.len();
        if kept.iter().all(|value| value.to_bits() == kept[0].to_bits()) {
            kept.truncate(1);
            kept.shrink_to_fit();
        }
        Self { kept, rows }
    }
}

impl FromIterator<f64> for Values {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        values.into_iter().collect::<Vec<_>>().into()
    }
}

impl PartialEq for Values {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_that_were_put_in_however_they_are_kept() {
        for all in [&[][..], &[1.0], &[2.0, 2.0, 2.0], &[2.0, 2.0, 3.0], &[0.0, -0.0], &[1.0, 2.0, 1.0]] {
            let made: Values = all.to_vec().into();
            let mut pushed = Values::default();
            all.iter().for_each(|value| pushed.push(*value));
            for values in [&made, &pushed] {
                assert_eq!(values.to_vec(), all);
                assert_eq!(values.len(), all.len());
            }
            assert_eq!(made, pushed);
        }
    }

    #[test]
    fn rows_change_by_themselves_and_together() {
        let mut values = Values::shared(f64::NAN, 3);
        values.fill_absent(4.0);
        assert_eq!(values.to_vec(), [4.0; 3]);
        values.set(1, 5.0);
        assert_eq!(values.to_vec(), [4.0, 5.0, 4.0]);
        values.push(f64::NAN);
        values.fill_absent(6.0);
        assert_eq!(values.to_vec(), [4.0, 5.0, 4.0, 6.0]);
        assert_eq!(values.some(&[3, 1]).to_vec(), [6.0, 5.0]);
        values.fill(1.0);
        values.push(1.0);
        assert_eq!(values.to_vec(), [1.0; 5]);
    }
}
