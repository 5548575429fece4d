//! The values of a column in every row.

use std::ops::Index;

/// Values in every row: of a coordinate in SI, NaN where a row has none. What all rows share is kept once: most coordinates
/// of a file are left out of it, and files have a million rows.
#[derive(Clone, Debug)]
pub struct Values<T = f64> {
    /// The value of each row, or one for all of them.
    kept: Vec<T>,
    rows: usize,
    /// Rows for which there will be room.
    expected: usize,
}

/// What rows may share.
pub trait Shared: Copy {
    /// Whether two values are the same to the last bit.
    fn is_same(self, other: Self) -> bool;
}

impl Shared for f64 {
    fn is_same(self, other: Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl Shared for usize {
    fn is_same(self, other: Self) -> bool {
        self == other
    }
}

impl<T: Shared> Values<T> {
    /// One value in all of so many rows.
    pub fn shared(value: T, rows: usize) -> Self {
        Self { kept: vec![value], rows, expected: 0 }
    }

    /// No rows yet of about so many, for which room is made as soon as they differ.
    pub fn with_capacity(expected: usize) -> Self {
        Self { expected, ..Self::default() }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// The value of the first row, if there is one.
    pub fn first(&self) -> Option<&T> {
        self.kept.first().filter(|_| self.rows > 0)
    }

    /// Whether a row has this value.
    pub fn contains(&self, value: &T) -> bool {
        self.rows > 0 && self.kept.iter().any(|own| own.is_same(*value))
    }

    /// The values, row by row.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &T> + ExactSizeIterator + Clone {
        (0..self.rows).map(|row| &self[row])
    }

    /// The values, one for each row.
    pub fn to_vec(&self) -> Vec<T> {
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

    /// Each of the values, changed.
    #[must_use]
    pub fn map(&self, change: impl FnMut(T) -> T) -> Self {
        Self { kept: self.kept.iter().copied().map(change).collect(), rows: self.rows, expected: 0 }
    }

    /// Gives all rows one value.
    pub fn fill(&mut self, value: T) {
        self.kept = vec![value];
    }

    /// Gives a row a value of its own.
    ///
    /// # Panics
    /// There is no such row.
    pub fn set(&mut self, row: usize, value: T) {
        if !self[row].is_same(value) {
            self.spread();
            self.kept[row] = value;
        }
    }

    /// Adds a row.
    pub fn push(&mut self, value: T) {
        let is_shared = self.kept.first().is_none_or(|first| first.is_same(value));
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
            self.kept.reserve_exact(self.expected.max(self.rows) - 1);
            self.kept.resize(self.rows, value);
        }
    }
}

impl Values {
    /// Gives a value to all rows that have none.
    pub fn fill_absent(&mut self, value: f64) {
        self.kept.iter_mut().filter(|own| own.is_nan()).for_each(|own| *own = value);
    }
}

impl<T> Index<usize> for Values<T> {
    type Output = T;

    fn index(&self, row: usize) -> &T {
        assert!(row < self.rows, "row {row} of {}", self.rows);
        &self.kept[if self.kept.len() == 1 { 0 } else { row }]
    }
}

impl<T: Shared> From<Vec<T>> for Values<T> {
    fn from(mut kept: Vec<T>) -> Self {
        let rows = kept.len();
        if kept.iter().all(|value| value.is_same(kept[0])) {
            kept.truncate(1);
            kept.shrink_to_fit();
        }
        Self { kept, rows, expected: 0 }
    }
}

impl<T: Shared> FromIterator<T> for Values<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        values.into_iter().collect::<Vec<_>>().into()
    }
}

impl<T: Shared> Extend<T> for Values<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        values.into_iter().for_each(|value| self.push(value));
    }
}

impl<T> Default for Values<T> {
    fn default() -> Self {
        Self { kept: Vec::new(), rows: 0, expected: 0 }
    }
}

impl<T: Shared + PartialEq> PartialEq for Values<T> {
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
