//! The text of a file and its name.

use std::path::Path;
use std::sync::Arc;

use super::{InputError, Problem, file};

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
        let bytes = file::read(path, limit).map_err(refuse)?;
        let text =
            String::from_utf8(bytes).map_err(|e| refuse(file::not_text(e.as_bytes(), e.utf8_error().valid_up_to())))?;
        Ok(Self::new(name, text))
    }

    /// The folder of the file, from the working directory: what paths in it are relative to.
    pub fn folder(&self) -> &Path {
        Path::new(&*self.name).parent().unwrap_or(Path::new(""))
    }

    /// Line and column, both from 1, columns in characters.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let before = self.text.get(..offset).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        (1 + before.matches('\n').count(), 1 + before[line_start..].chars().count())
    }
}
