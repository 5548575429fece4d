//! The text of a file and its name.

use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use super::{InputError, Problem};

/// A file's name and text, shared by everything that points into it.
#[derive(Clone, Debug)]
pub struct Source {
    /// As the user gave it.
    pub name: Arc<str>,
    /// The whole text.
    pub text: Arc<str>,
}

impl Source {
    /// A text that did not come from a file.
    pub fn new(name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Self {
        Self { name: name.into(), text: text.into() }
    }

    /// Reads a file of UTF-8 text of at most `limit` bytes.
    ///
    /// # Errors
    /// The file cannot be read, is larger than `limit`, or is not UTF-8 (the error points at the first bad byte).
    pub fn read(path: &Path, limit: u64) -> Result<Self, InputError> {
        let name: Arc<str> = path.display().to_string().into();
        let refuse = |problem: Problem| InputError::one(Self::new(name.clone(), ""), problem);
        let io = |e: std::io::Error| refuse(Problem::new(format!("the file cannot be read: {e}")).help(unreadable(&e)));
        let metadata = std::fs::metadata(path).map_err(io)?;
        if metadata.is_dir() {
            return Err(refuse(Problem::new("this is a directory").help("name the file in it")));
        }
        if metadata.len() > limit {
            let (size, limit) = (metadata.len() as f64 / 1e6, limit as f64 / 1e6);
            let message = format!("the file has {size:.1} MB; at most {limit:.0} MB are read");
            return Err(refuse(Problem::new(message).help("is it the right file?")));
        }
        let mut bytes = Vec::new();
        // A device or a pipe has no length to be judged by.
        std::fs::File::open(path).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes)).map_err(io)?;
        if bytes.len() as u64 > limit {
            let message = format!("there are more than {:.0} MB to read", limit as f64 / 1e6);
            return Err(refuse(Problem::new(message).help("is it the right file?")));
        }
        let text = String::from_utf8(bytes).map_err(|e| {
            let line = 1 + e.as_bytes()[..e.utf8_error().valid_up_to()].iter().filter(|b| **b == b'\n').count();
            let message = format!("the file is not UTF-8 text: line {line} holds a byte that is not");
            refuse(Problem::new(message).help("save it as UTF-8"))
        })?;
        Ok(Self::new(name, text))
    }

    /// Line and column, both from 1, columns in characters.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let before = self.text.get(..offset).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        (1 + before.matches('\n').count(), 1 + before[line_start..].chars().count())
    }
}

fn unreadable(error: &std::io::Error) -> &'static str {
    match error.kind() {
        std::io::ErrorKind::NotFound => "check the path; `fem new PROCESS` writes a starting model",
        std::io::ErrorKind::PermissionDenied => "check the file's permissions",
        _ => "check the path",
    }
}
