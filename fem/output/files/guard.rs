//! Protection of files that are not to be replaced.

use std::path::{Path, PathBuf};

use super::way::{Way, folder_of};
use crate::output::OutputError;

/// Rule by which files may be replaced.
#[derive(Clone, Copy, Debug)]
pub struct Guard<'a> {
    /// Files that were read: never.
    pub reads: &'a [PathBuf],
    /// Whether files that the program did not write may be replaced.
    pub force: bool,
}

impl Guard<'_> {
    /// Refuses to write to `path` where it is one of the files that are read, by whatever way, where a file
    /// stands that is not to be replaced, or where the way leads over a link that others may have put there.
    ///
    /// # Errors
    /// It is one, one stands there, or it does.
    pub fn check(&self, path: &Path) -> Result<(), OutputError> {
        // By where the way leads: `missing/../model.toml` is the model once `missing` is made.
        let place = Way::to(folder_of(path), self.reads)?.path().join(path.file_name().unwrap_or_default());
        self.check_reads(&place)?;
        match place.symlink_metadata() {
            Ok(there) if !there.is_dir() && !self.force => Err(OutputError::Exists { path: path.to_path_buf() }),
            Ok(there) if !(there.is_dir() || there.is_file() || there.is_symlink()) => {
                Err(OutputError::Special { path: path.to_path_buf() })
            }
            _ => Ok(()),
        }
    }

    /// Refuses to write to `path` where it is one of the files that are read.
    ///
    /// # Errors
    /// It is one.
    pub(super) fn check_reads(&self, path: &Path) -> Result<(), OutputError> {
        match self.reads.iter().any(|read| is_same(read, path)) {
            true => Err(OutputError::Read { path: path.to_path_buf() }),
            false => Ok(()),
        }
    }
}

/// Whether two paths are one file, by whatever way.
fn is_same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}
