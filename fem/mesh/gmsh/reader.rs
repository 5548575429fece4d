//! Numbers out of the sections of a Gmsh file, written as text or in binary.

use super::GmshError;

/// The encoding of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Little,
    Big,
}

/// Reads one section number by number.
pub(super) struct Reader<'f> {
    bytes: &'f [u8],
    at: usize,
    encoding: Encoding,
    section: &'static str,
}

impl<'f> Reader<'f> {
    /// Reads `bytes` from the place `at`.
    pub fn new(bytes: &'f [u8], at: usize, encoding: Encoding, section: &'static str) -> Self {
        Self { bytes, at, encoding, section }
    }

    /// An error at the present place.
    pub fn problem(&self, problem: impl Into<String>) -> GmshError {
        let place = match self.encoding {
            Encoding::Text => {
                let line = 1 + self.bytes[..self.at].iter().filter(|&&byte| byte == b'\n').count();
                format!("line {line}")
            }
            _ => format!("byte {}", self.at),
        };
        GmshError::Syntax { section: self.section, place, problem: problem.into() }
    }

    /// A 32-bit integer.
    pub fn int(&mut self) -> Result<i32, GmshError> {
        match self.encoding {
            Encoding::Text => self.parsed("a whole number"),
            Encoding::Little => Ok(i32::from_le_bytes(self.raw()?)),
            Encoding::Big => Ok(i32::from_be_bytes(self.raw()?)),
        }
    }

    /// A count or tag of 64 bits.
    pub fn size(&mut self) -> Result<u64, GmshError> {
        match self.encoding {
            Encoding::Text => self.parsed("a count or tag"),
            Encoding::Little => Ok(u64::from_le_bytes(self.raw()?)),
            Encoding::Big => Ok(u64::from_be_bytes(self.raw()?)),
        }
    }

    /// A double.
    pub fn float(&mut self) -> Result<f64, GmshError> {
        match self.encoding {
            Encoding::Text => self.parsed("a number"),
            Encoding::Little => Ok(f64::from_le_bytes(self.raw()?)),
            Encoding::Big => Ok(f64::from_be_bytes(self.raw()?)),
        }
    }

    /// A string in double quotes (in text only).
    pub fn quoted(&mut self) -> Result<String, GmshError> {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|&byte| byte == b'"').map(|quote| quote + 1);
        let name = start.and_then(|start| {
            let end = start + rest[start..].iter().position(|&byte| byte == b'"' || byte == b'\n')?;
            (rest[end] == b'"').then_some((start, end))
        });
        let Some((start, end)) = name else { return Err(self.problem("expected a name in double quotes")) };
        self.at += end + 1;
        Ok(String::from_utf8_lossy(&rest[start..end]).into_owned())
    }

    fn parsed<T: std::str::FromStr>(&mut self, expected: &str) -> Result<T, GmshError> {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
        let word = &rest[start..];
        let length = word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len());
        let word = String::from_utf8_lossy(&word[..length]);
        self.at += start;
        let value = word.parse().map_err(|_| self.problem(format!("expected {expected}, found `{word}`")))?;
        self.at += length;
        Ok(value)
    }

    fn raw<const N: usize>(&mut self) -> Result<[u8; N], GmshError> {
        let found = self.bytes.get(self.at..self.at + N).and_then(|bytes| bytes.try_into().ok());
        let found = found.ok_or_else(|| self.problem("the file ends here"))?;
        self.at += N;
        Ok(found)
    }
}
