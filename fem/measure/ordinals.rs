//! Numbers that rows have in some order, most of which count up.

/// Whole numbers of rows, such as the lines in which they stand: of runs in which each is one more than the one before
/// only the first is kept.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ordinals {
    /// First row of each run, and its number.
    runs: Vec<(u32, u32)>,
    rows: u32,
}

impl Ordinals {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows as usize
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// The number of a row; `None` where there is no such row.
    pub fn get(&self, row: usize) -> Option<usize> {
        if row >= self.len() {
            return None;
        }
        let run = self.runs.partition_point(|(first, _)| *first as usize <= row).checked_sub(1)?;
        let (first, number) = self.runs[run];
        Some(number as usize + (row - first as usize))
    }

    /// The numbers, row by row.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        let ends = self.runs.iter().skip(1).map(|(first, _)| *first).chain([self.rows]);
        self.runs.iter().zip(ends).flat_map(|((first, number), end)| (*number as usize..).take((end - first) as usize))
    }

    /// Adds a row.
    pub fn push(&mut self, number: usize) {
        let counted = self.runs.last().map(|(first, number)| *number as usize + (self.rows - first) as usize);
        if counted != Some(number) {
            self.runs.push((self.rows, number as u32));
        }
        self.rows += 1;
    }
}

impl Extend<usize> for Ordinals {
    fn extend<I: IntoIterator<Item = usize>>(&mut self, numbers: I) {
        numbers.into_iter().for_each(|number| self.push(number));
    }
}

impl FromIterator<usize> for Ordinals {
    fn from_iter<I: IntoIterator<Item = usize>>(numbers: I) -> Self {
        let mut all = Self::default();
        all.extend(numbers);
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_that_were_put_in() {
        for all in [&[][..], &[7], &[0, 1, 2, 3], &[0, 0, 0, 1, 1, 1], &[2, 3, 9, 4, 5, 0]] {
            let numbers: Ordinals = all.iter().copied().collect();
            assert_eq!(numbers.iter().collect::<Vec<_>>(), all);
            assert_eq!((0..all.len()).filter_map(|row| numbers.get(row)).collect::<Vec<_>>(), all);
            assert_eq!((numbers.len(), numbers.get(all.len())), (all.len(), None));
        }
        assert_eq!((5..1000).collect::<Ordinals>().runs, [(0, 5)]);
    }
}
