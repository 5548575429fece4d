//! The records of a file, with cells in the program's form.

use std::collections::BTreeSet;
use std::io::Cursor;
use std::ops::Range;
use std::sync::Arc;

use csv::{Position, Reader, ReaderBuilder, StringRecord};

use super::alike::Alike;
use crate::input::{Problem, line_at};

/// Records of a file. What the file writes is read from its text again when it is asked for, and what the program has
/// written in its place is kept beside: files have a million rows, and a second copy of them would be the largest thing
/// in memory.
#[derive(Clone, Debug, Default)]
pub struct Records {
    text: Arc<str>,
    separator: u8,
    /// Byte of the text from which each record is looked for: blank lines and comments may stand before it.
    places: Vec<u32>,
    columns: Vec<Column>,
}

#[derive(Clone, Debug)]
enum Column {
    /// As the file writes it in its column of this number, from 0.
    OfFile(usize),
    /// As the program writes it.
    Written(Cells),
}

/// What was wrong with cells.
#[derive(Debug, Default)]
pub struct Refused {
    /// Problems, each of them once.
    pub problems: Vec<Problem>,
    /// Bytes from which the records with these cells are looked for.
    pub records: BTreeSet<usize>,
}

impl Refused {
    /// Adds what was wrong with others.
    pub fn add(&mut self, other: Self) {
        self.problems.extend(other.problems);
        self.records.extend(other.records);
    }
}

/// The cells of a column in one piece of memory.
#[derive(Clone, Debug, Default)]
struct Cells {
    text: String,
    ends: Vec<usize>,
}

/// Largest text whose records can be found again, bytes.
pub const LARGEST_TEXT: usize = u32::MAX as usize;

/// How the records of a text are parted: cells without the blanks around them, comments left out.
pub fn csv_builder(separator: u8) -> ReaderBuilder {
    let mut builder = ReaderBuilder::new();
    builder.comment(Some(b'#')).trim(csv::Trim::All).delimiter(separator);
    builder
}

impl Records {
    /// No records yet, of so many columns as the file writes them in its text.
    pub fn of_file(text: Arc<str>, separator: u8, columns: usize) -> Self {
        Self { text, separator, places: Vec::new(), columns: (0..columns).map(Column::OfFile).collect() }
    }

    /// No records yet, of so many columns that the program makes of a text.
    pub fn written(text: Arc<str>, columns: usize) -> Self {
        let columns = (0..columns).map(|_| Column::Written(Cells::default())).collect();
        Self { text, separator: b',', places: Vec::new(), columns }
    }

    /// Adds the record that stands at this byte of the text.
    pub fn push(&mut self, place: usize) {
        self.places.push(u32::try_from(place).unwrap_or(u32::MAX));
    }

    /// Adds a record that was made of what stands at this byte of the text.
    pub fn push_written<T: AsRef<str>>(&mut self, place: usize, cells: impl IntoIterator<Item = T>) {
        self.push(place);
        let mut cells = cells.into_iter();
        for column in &mut self.columns {
            if let Column::Written(own) = column {
                own.push(cells.next().as_ref().map_or("", T::as_ref));
            }
        }
    }

    /// Number of records.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The text in which they stand.
    pub fn text(&self) -> &Arc<str> {
        &self.text
    }

    /// Bytes of the text that are the line of a record.
    pub fn place(&self, record: usize) -> Range<usize> {
        line_at(&self.text, self.places[record] as usize, 0)
    }

    /// Byte from which a record is looked for.
    pub fn byte(&self, record: usize) -> usize {
        self.places[record] as usize
    }

    /// Line of each record, from 1.
    pub fn lines(&self) -> impl Iterator<Item = u64> {
        let (mut line, mut counted) = (1, 0);
        (0..self.len()).map(move |record| {
            let start = self.place(record).start;
            // Records of instruments need not stand in the order of their lines.
            if start < counted {
                (line, counted) = (1, 0);
            }
            line += self.text.as_bytes()[counted..start].iter().filter(|byte| **byte == b'\n').count() as u64;
            counted = start;
            line
        })
    }

    /// Line of a record, from 1.
    pub fn line(&self, record: usize) -> u64 {
        1 + self.text[..self.place(record).start].matches('\n').count() as u64
    }

    /// The cells of a record.
    pub fn get(&self, record: usize) -> StringRecord {
        self.reader().read(record).clone()
    }

    /// Reads records one after the other.
    pub fn reader(&self) -> RecordReader<'_> {
        let text = Cursor::new(self.text.as_bytes());
        RecordReader {
            records: self,
            file: csv_builder(self.separator).flexible(true).has_headers(false).from_reader(text),
            of_file: StringRecord::new(),
            record: StringRecord::new(),
        }
    }

    /// Leaves these columns, in this order.
    pub fn keep(&mut self, columns: &[usize]) {
        self.columns = columns.iter().map(|column| self.columns[*column].clone()).collect();
    }

    /// Leaves the first record out.
    pub fn leave_first_out(&mut self) {
        self.places.remove(0);
        for column in &mut self.columns {
            if let Column::Written(cells) = column {
                cells.leave_first_out();
            }
        }
    }

    /// Keeps the first records alone.
    pub fn keep_first(&mut self, count: usize) {
        self.places.truncate(count);
    }

    /// Writes cells of some columns otherwise: those for which `write`, given the number of a record, its cells and the
    /// column, says how.
    pub fn rewrite(&mut self, columns: &[usize], mut write: impl FnMut(usize, &StringRecord, usize) -> Option<String>) {
        self.rewrite_or_refuse(columns, |number, cells, column| Ok(write(number, cells, column)));
    }

    /// The same where cells may be refused.
    pub fn rewrite_or_refuse(
        &mut self,
        columns: &[usize],
        mut write: impl FnMut(usize, &StringRecord, usize) -> Result<Option<String>, Problem>,
    ) -> Refused {
        let (mut alike, mut refused) = (Alike::default(), Refused::default());
        let mut written = vec![(Cells::default(), false); columns.len()];
        let mut reader = self.reader();
        for number in 0..self.len() {
            let record = reader.read(number);
            for ((cells, is_other), column) in written.iter_mut().zip(columns) {
                let cell = write(number, record, *column).unwrap_or_else(|problem| {
                    alike.push(problem, Some(self.place(number)));
                    refused.records.insert(self.byte(number));
                    None
                });
                *is_other |= cell.is_some();
                cells.push(cell.as_deref().unwrap_or(&record[*column]));
            }
        }
        for ((cells, is_other), column) in written.into_iter().zip(columns) {
            if is_other {
                self.columns[*column] = Column::Written(cells);
            }
        }
        refused.problems = alike.problems();
        refused
    }
}

impl Cells {
    fn push(&mut self, cell: &str) {
        self.text.push_str(cell);
        self.ends.push(self.text.len());
    }

    fn get(&self, record: usize) -> &str {
        let start = record.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.text[start..self.ends[record]]
    }

    fn leave_first_out(&mut self) {
        let first = self.ends.remove(0);
        self.text.replace_range(..first, "");
        self.ends.iter_mut().for_each(|end| *end -= first);
    }
}

/// Reads records, which is fastest in their order.
pub struct RecordReader<'a> {
    records: &'a Records,
    file: Reader<Cursor<&'a [u8]>>,
    of_file: StringRecord,
    record: StringRecord,
}

impl RecordReader<'_> {
    /// The cells of a record.
    ///
    /// # Panics
    /// There is no such record.
    pub fn read(&mut self, record: usize) -> &StringRecord {
        let columns = &self.records.columns;
        if columns.iter().any(|column| matches!(column, Column::OfFile(_))) {
            let byte = u64::from(self.records.places[record]);
            // Neither fails in memory, and on text that was read before.
            if self.file.position().byte() != byte {
                let mut place = Position::new();
                place.set_byte(byte);
                let _ = self.file.seek(place);
            }
            let _ = self.file.read_record(&mut self.of_file);
        }
        self.record.clear();
        for column in columns {
            self.record.push_field(match column {
                Column::OfFile(number) => self.of_file.get(*number).unwrap_or_default(),
                Column::Written(cells) => cells.get(record),
            });
        }
        &self.record
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "a,b\n# none\n1, 2\n\n\"3\n3\",\"4, \"\"4\"\"\"\n5,6";

    fn records() -> Records {
        let mut records = Records::of_file(TEXT.into(), b',', 2);
        ["\n# none", "\n\"3", "\n5"].iter().for_each(|start| records.push(TEXT.find(start).unwrap() + 1));
        records
    }

    fn all(records: &Records) -> Vec<Vec<String>> {
        let mut reader = records.reader();
        (0..records.len()).map(|number| reader.read(number).iter().map(str::to_string).collect()).collect()
    }

    #[test]
    fn cells_are_those_of_the_file_in_any_order() {
        let records = records();
        assert_eq!(all(&records), [["1", "2"], ["3\n3", "4, \"4\""], ["5", "6"]]);
        let mut reader = records.reader();
        for number in [2, 0, 0, 1, 2, 1] {
            assert_eq!(*reader.read(number), records.get(number));
        }
        assert_eq!(records.lines().collect::<Vec<_>>(), [3, 5, 7]);
        for (number, line) in [(0, "1, 2"), (1, "\"3"), (2, "5,6")] {
            assert_eq!(&TEXT[records.place(number)], line);
            assert_eq!(records.line(number), records.lines().nth(number).unwrap());
        }
    }

    #[test]
    fn cells_that_were_written_otherwise_stand_beside_those_of_the_file() {
        let mut records = records();
        records.rewrite(&[0, 1], |number, record, column| {
            (column == 1 && number != 1).then(|| format!("{}{}", &record[0], &record[1]))
        });
        assert_eq!(all(&records), [["1", "12"], ["3\n3", "4, \"4\""], ["5", "56"]]);
        records.leave_first_out();
        assert_eq!(all(&records), [["3\n3", "4, \"4\""], ["5", "56"]]);
        records.keep(&[1]);
        assert_eq!(all(&records), [["4, \"4\""], ["56"]]);
    }

    #[test]
    fn records_are_made_of_a_text_in_an_order_of_their_own() {
        let mut records = Records::written("x\ny\nz".into(), 2);
        records.push_written(4, ["1", ""]);
        records.push_written(0, ["", "\u{e9}"]);
        records.push_written(4, ["2", "3"]);
        assert_eq!(all(&records), [["1", ""], ["", "\u{e9}"], ["2", "3"]]);
        assert_eq!(records.lines().collect::<Vec<_>>(), [3, 1, 3]);
    }
}
