//! Sums of the rows of a study, a line each: a table that somebody has sorted, rounded or mended by hand looks like the one that
//! was written, and is none to go on with.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};

use cap_std::fs::Dir;
use sha2::{Digest, Sha256};

use super::own::opened;

/// File beside the rows.
pub const FILE: &str = ".fem-rows.sums";
/// Bytes of a sum: hexadecimal digits and a line feed.
const LENGTH: usize = 17;

/// The sum of a line, with its line feed.
fn sum(line: &[u8]) -> [u8; LENGTH] {
    let digest = Sha256::digest(line);
    let mut digits = [b'\n'; LENGTH];
    for (place, byte) in digest[..(LENGTH - 1) / 2].iter().enumerate() {
        for (half, value) in [byte >> 4, byte & 15].into_iter().enumerate() {
            digits[2 * place + half] = b"0123456789abcdef"[usize::from(value)];
        }
    }
    digits
}

/// Sums that are read along with the rows.
pub struct Sums(Option<BufReader<File>>);

impl Sums {
    /// Those of a folder. Rows of earlier versions have none, and are taken as they are.
    pub fn of(dir: &Dir) -> Self {
        Self(
            opened(dir, FILE, false)
                .ok()
                .filter(|file| file.metadata().is_ok_and(|about| about.len() > 0))
                .map(BufReader::new),
        )
    }

    /// Whether the next line is the one that was written; where there are no sums, each is.
    pub fn has(&mut self, line: &[u8]) -> bool {
        let mut own = [0; LENGTH];
        self.0.as_mut().is_none_or(|reader| reader.read_exact(&mut own).is_ok() && own == sum(line))
    }

    /// Number of the first of some lines, from 0, that is not as it was written; `None` where all are.
    ///
    /// # Errors
    /// They cannot be read.
    pub fn first_altered(&mut self, mut lines: impl BufRead) -> io::Result<Option<u64>> {
        let mut line = Vec::new();
        for number in 0.. {
            line.clear();
            if lines.read_until(b'\n', &mut line)? == 0 {
                // A row that is gone has left its sum.
                let is_left = self.0.as_mut().is_some_and(|sums| sums.fill_buf().is_ok_and(|rest| !rest.is_empty()));
                return Ok(is_left.then_some(number));
            }
            if !self.has(&line) {
                return Ok(Some(number));
            }
        }
        Ok(None)
    }
}

/// Sums that are written along with the rows.
pub struct Writer(BufWriter<File>);

impl Writer {
    /// Behind those of the rows that stand there, which are read once more where they have none.
    ///
    /// # Errors
    /// The file cannot be written, or is not of this folder alone.
    pub fn behind(dir: &Dir, count: u64, rows: impl BufRead) -> io::Result<Self> {
        let mut file = opened(dir, FILE, true)?;
        let end = count * LENGTH as u64;
        if file.metadata()?.len() >= end {
            file.set_len(end)?;
            file.seek(SeekFrom::Start(end))?;
            return Ok(Self(BufWriter::new(file)));
        }
        file.set_len(0)?;
        let mut own = Self(BufWriter::new(file));
        let (mut rows, mut line) = (rows, Vec::new());
        for _ in 0..count {
            line.clear();
            rows.read_until(b'\n', &mut line)?;
            own.add(&line)?;
        }
        Ok(own)
    }

    /// Adds that of the next line.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn add(&mut self, line: &[u8]) -> io::Result<()> {
        self.0.write_all(&sum(line))
    }

    /// Hands them to the system: before their rows, so that a row that stands there has its sum.
    ///
    /// # Errors
    /// They cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}
