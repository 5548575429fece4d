//! The cells of a record.

/// The cells of a record in one piece of memory: files of a million rows stand in it whole.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cells(Box<str>);

/// Stands between cells, where no text has it (ASCII: unit separator).
const BETWEEN: char = '\u{1f}';

impl Cells {
    /// The cells from the first on.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        self.0.split(BETWEEN)
    }

    /// The cell of a column, if the record is so long.
    pub fn get(&self, column: usize) -> Option<&str> {
        self.iter().nth(column)
    }

    /// The same record with another cell in a column.
    #[must_use]
    pub fn with(&self, column: usize, cell: &str) -> Self {
        self.iter().enumerate().map(|(i, own)| if i == column { cell } else { own }).collect()
    }
}

impl<T: AsRef<str>> FromIterator<T> for Cells {
    fn from_iter<I: IntoIterator<Item = T>>(cells: I) -> Self {
        let mut text = String::new();
        for (column, cell) in cells.into_iter().enumerate() {
            if column > 0 {
                text.push(BETWEEN);
            }
            text.extend(cell.as_ref().chars().map(|c| if c == BETWEEN { ' ' } else { c }));
        }
        Self(text.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_as_they_were_put_in() {
        for cells in [&["1", "", "x y"][..], &[""], &["", ""], &["\u{e9}\u{1f5ff}", "2"]] {
            let record: Cells = cells.iter().collect();
            assert_eq!(record.iter().collect::<Vec<_>>(), cells);
            assert_eq!(record.get(cells.len()), None);
        }
        let record: Cells = ["1", "2", "3"].iter().collect();
        assert_eq!(record.with(1, "b").iter().collect::<Vec<_>>(), ["1", "b", "3"]);
        assert_eq!(["a\u{1f}b"].iter().collect::<Cells>().iter().collect::<Vec<_>>(), ["a b"]);
    }
}
