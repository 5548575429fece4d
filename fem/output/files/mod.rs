//! Files that appear whole: single ones written beside their place and renamed, those of a run all together.
//! What is there already and was not written by this program stays, unless the user says otherwise.

mod beside;
mod replace;
mod stage;
mod written;

use std::path::{Path, PathBuf};

pub use beside::abandon;
pub use stage::Stage;

use super::OutputError;

/// What may be replaced, and what not.
#[derive(Clone, Copy, Debug)]
pub struct Guard<'a> {
    /// Files that were read: never.
    pub reads: &'a [PathBuf],
    /// Whether files that the program did not write may be replaced.
    pub force: bool,
}

impl Guard<'_> {
    /// Refuses to write to `path` where it is one of the files that are read, by whatever way, or where a file
    /// stands that is not to be replaced.
    ///
    /// # Errors
    /// It is one, or one stands there.
    pub fn check(&self, path: &Path) -> Result<(), OutputError> {
        self.check_reads(path)?;
        match !self.force && path.symlink_metadata().is_ok_and(|m| !m.is_dir()) {
            true => Err(OutputError::Exists { path: path.to_path_buf() }),
            false => Ok(()),
        }
    }

    fn check_reads(&self, path: &Path) -> Result<(), OutputError> {
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

fn failed(path: &Path) -> impl Fn(std::io::Error) -> OutputError + use<> {
    let path = path.to_path_buf();
    // The operating system's own words, without the name of a partial file.
    move |error| {
        let error = error.raw_os_error().map_or(error, std::io::Error::from_raw_os_error);
        OutputError::File { path: path.clone(), error }
    }
}

/// Writes one file beside its place and renames it there; missing directories are made.
///
/// # Errors
/// The guard refuses; the directory cannot be made, the file not written (a full disk), or not renamed.
pub fn write(path: &Path, bytes: &[u8], guard: Guard) -> Result<(), OutputError> {
    guard.check(path)?;
    let failed = failed(path);
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(directory).map_err(&failed)?;
    let beside = beside::Beside::new_in(directory).map_err(&failed)?;
    let partial = beside.path().join(path.file_name().unwrap_or_default());
    std::fs::write(&partial, bytes).map_err(&failed)?;
    match guard.force {
        true => std::fs::rename(&partial, path).map_err(failed),
        // A link, unlike a rename, never replaces what has appeared in the meantime.
        false => match std::fs::hard_link(&partial, path) {
            Ok(()) => Ok(()),
            Err(e) if e.kind() == std::io::ErrorKind::AlreadyExists && !path.is_dir() => {
                Err(OutputError::Exists { path: path.to_path_buf() })
            }
            // No file system has to know links.
            Err(_) => std::fs::rename(&partial, path).map_err(failed),
        },
    }
}
