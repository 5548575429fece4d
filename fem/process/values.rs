//! The values of a column in every row.

use std::ops::Index;

/// Values in every row: of a coordinate in SI, NaN where a row has none. Files have a million rows, and most of their
/// coordinates one value in all of them, for they are left out, or a few: a number of a run, a target, the place of a
/// sensor.
#[derive(Clone, Debug)]
pub struct Values<T = f64> {
    kept: Kept<T>,
    rows: usize,
    /// Rows for which there will be room.
    expected: usize,
}

#[derive(Clone, Debug)]
enum Kept<T> {
    /// One value for all rows; none where there are no rows yet.
    Shared(Option<T>),
    /// A few values, and which of them each row has.
    Few(Vec<T>, Vec<u8>),
    /// A value for each row.
    Each(Vec<T>),
}

/// Most values that are a few.
const FEW: usize = 64;

/// Values that are the same only to the last bit.
pub trait SameBits: Copy {
    /// Whether two values are the same to the last bit.
    fn is_same(self, other: Self) -> bool;
}

impl SameBits for f64 {
    fn is_same(self, other: Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl SameBits for usize {
    fn is_same(self, other: Self) -> bool {
        self == other
    }
}

impl<T: SameBits> Values<T> {
    /// One value in all of so many rows.
    pub fn shared(value: T, rows: usize) -> Self {
        Self { kept: Kept::Shared(Some(value)), rows, expected: 0 }
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
        (self.rows > 0).then(|| &self[0])
    }

    /// Whether a row has this value.
    pub fn contains(&self, value: &T) -> bool {
        match &self.kept {
            Kept::Shared(own) => self.rows > 0 && own.is_some_and(|own| own.is_same(*value)),
            _ => self.iter().any(|own| own.is_same(*value)),
        }
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
        let kept = match &self.kept {
            Kept::Shared(value) => Kept::Shared(*value),
            Kept::Few(values, of_row) => Kept::Few(values.clone(), rows.iter().map(|row| of_row[*row]).collect()),
            Kept::Each(values) => return rows.iter().map(|row| values[*row]).collect(),
        };
        Self { kept, rows: rows.len(), expected: 0 }
    }

    /// Each of the values, changed.
    #[must_use]
    pub fn map(&self, change: impl FnMut(T) -> T) -> Self {
        let kept = match &self.kept {
            Kept::Shared(value) => Kept::Shared(value.map(change)),
            Kept::Few(values, of_row) => Kept::Few(values.iter().copied().map(change).collect(), of_row.clone()),
            Kept::Each(values) => Kept::Each(values.iter().copied().map(change).collect()),
        };
        Self { kept, rows: self.rows, expected: 0 }
    }

    /// Gives all rows one value.
    pub fn fill(&mut self, value: T) {
        self.kept = Kept::Shared(Some(value));
    }

    /// Gives a row a value of its own.
    ///
    /// # Panics
    /// There is no such row.
    pub fn set(&mut self, row: usize, value: T) {
        if !self[row].is_same(value) {
            let mut values = self.take_each();
            values[row] = value;
            self.kept = Kept::Each(values);
        }
    }

    /// Adds a row.
    pub fn push(&mut self, value: T) {
        let room = self.expected.max(self.rows + 1);
        match &mut self.kept {
            Kept::Shared(None) => self.kept = Kept::Shared(Some(value)),
            Kept::Shared(Some(own)) if own.is_same(value) => {}
            Kept::Shared(Some(own)) => {
                let mut of_row = Vec::with_capacity(room);
                of_row.resize(self.rows, 0);
                of_row.push(1);
                self.kept = Kept::Few(vec![*own, value], of_row);
            }
            Kept::Few(values, of_row) => match values.iter().position(|own| own.is_same(value)) {
                Some(number) => of_row.push(number as u8),
                None if values.len() < FEW => {
                    of_row.push(values.len() as u8);
                    values.push(value);
                }
                None => {
                    let mut values = self.take_each();
                    values.push(value);
                    self.kept = Kept::Each(values);
                }
            },
            Kept::Each(values) => values.push(value),
        }
        self.rows += 1;
    }

    /// Takes out a value for each row.
    fn take_each(&mut self) -> Vec<T> {
        if let Kept::Each(values) = &mut self.kept {
            return std::mem::take(values);
        }
        let mut values = Vec::with_capacity(self.expected.max(self.rows));
        values.extend(self.iter().copied());
        values
    }
}

impl Values {
    /// Gives a value to all rows that have none.
    pub fn fill_absent(&mut self, value: f64) {
        let fill = |own: &mut f64| {
            if own.is_nan() {
                *own = value;
            }
        };
        match &mut self.kept {
            Kept::Shared(own) => own.iter_mut().for_each(fill),
            Kept::Few(values, _) | Kept::Each(values) => values.iter_mut().for_each(fill),
        }
    }
}

impl<T> Index<usize> for Values<T> {
    type Output = T;

    fn index(&self, row: usize) -> &T {
        match &self.kept {
            Kept::Each(values) => &values[row],
            Kept::Few(values, of_row) => &values[usize::from(of_row[row])],
            Kept::Shared(Some(value)) if row < self.rows => value,
            Kept::Shared(_) => panic!("row {row} of {}", self.rows),
        }
    }
}

impl<T: SameBits> From<Vec<T>> for Values<T> {
    fn from(values: Vec<T>) -> Self {
        let rows = values.len();
        let first = values.first().copied();
        let is_shared = first.is_none_or(|first| values.iter().all(|value| value.is_same(first)));
        Self { kept: if is_shared { Kept::Shared(first) } else { Kept::Each(values) }, rows, expected: 0 }
    }
}

impl<T: SameBits> FromIterator<T> for Values<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        values.into_iter().collect::<Vec<_>>().into()
    }
}

impl<T: SameBits> Extend<T> for Values<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        values.into_iter().for_each(|value| self.push(value));
    }
}

impl<T> Default for Values<T> {
    fn default() -> Self {
        Self { kept: Kept::Shared(None), rows: 0, expected: 0 }
    }
}

impl<T: SameBits + PartialEq> PartialEq for Values<T> {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_that_were_put_in_however_they_are_kept() {
        let many: Vec<f64> = (0..300).map(|row| f64::from(row % 100)).collect();
        for all in [&[][..], &[1.0], &[2.0; 3], &[2.0, 2.0, 3.0], &[0.0, -0.0], &[1.0, 2.0, 1.0], &many] {
            let made: Values = all.to_vec().into();
            let mut pushed = Values::with_capacity(all.len());
            all.iter().for_each(|value| pushed.push(*value));
            let last: Vec<usize> = (0..all.len()).rev().take(2).collect();
            for values in [&made, &pushed] {
                assert_eq!(values.to_vec(), all);
                assert_eq!((values.len(), values.first()), (all.len(), all.first()));
                assert_eq!(values.map(|v| v + 1.0).to_vec(), all.iter().map(|v| v + 1.0).collect::<Vec<_>>());
                assert_eq!(values.some(&last).to_vec(), all.iter().rev().take(2).copied().collect::<Vec<_>>());
                assert_eq!([1.0, 2.0, 99.0].map(|v| values.contains(&v)), [1.0, 2.0, 99.0].map(|v| all.contains(&v)));
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
        values.fill(1.0);
        values.push(1.0);
        assert_eq!(values.to_vec(), [1.0; 5]);
        // Of a few values one is given to all that have none, and a row changes alone.
        let mut few = Values::default();
        few.extend([1.0, f64::NAN, 1.0, f64::NAN]);
        few.fill_absent(3.0);
        few.set(2, 3.0);
        assert_eq!(few.to_vec(), [1.0, 3.0, 3.0, 3.0]);
    }
}
