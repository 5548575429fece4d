//! The text of a file and its name.

use std::ffi::OsStr;
use std::path::Path;
use std::sync::Arc;

/// A file's name and text, shared by everything that points into it.
#[derive(Clone, Debug)]
pub struct Source {
    /// Name as the user gave it.
    pub name: Arc<str>,
    /// The whole text.
    pub text: Arc<str>,
    /// SHA-256 of the bytes of the file, as they were read: a pipe cannot be read again. `None` of what did not come from a file.
    pub sha256: Option<[u8; 32]>,
}

/// Name of a file without its ending, which a folder may have too; `None` where nothing but dots is left.
pub fn stem(file: &Path) -> Option<&OsStr> {
    file.file_stem().filter(|stem| !stem.to_string_lossy().bytes().all(|byte| byte == b'.'))
}

impl Source {
    /// A text that did not come from a file.
    pub fn new(name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Self {
        Self { name: name.into(), text: text.into(), sha256: None }
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
