//! Files that appear whole: written beside, then renamed; the files of a run all together.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::OutputError;

/// What is being written, for [`abandon`]. Whoever makes a partial file holds the lock until it stands
/// here, so that none can be made behind the back of a program that is ending.
static PARTIAL: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn partial() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    // A panic while the set was held leaves it whole: entries are added and removed in one step each.
    PARTIAL.lock().unwrap_or_else(PoisonError::into_inner)
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
/// It is one of the files that were read; the directory cannot be made, the file not written (a full disk),
/// or not renamed.
pub fn write(path: &Path, bytes: &[u8], reads: &[PathBuf]) -> Result<(), OutputError> {
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let stage = Stage::new(directory, reads).map_err(failed(path))?;
    stage.write(Path::new(path.file_name().unwrap_or_default()), bytes)?;
    stage.publish()
}

/// Whether two paths are one file, by whatever way.
fn is_same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// Refuses to write to `path` where it is one of the files that are read, by whatever way.
///
/// # Errors
/// It is.
pub fn refuse_reads(path: &Path, reads: &[PathBuf]) -> Result<(), OutputError> {
    match reads.iter().any(|read| is_same(read, path)) {
        true => Err(OutputError::Read { path: path.to_path_buf() }),
        false => Ok(()),
    }
}

/// Files on their way into a directory: all of them appear, or none, and none over a file that was read.
pub struct Stage {
    directory: PathBuf,
    reads: Vec<PathBuf>,
    beside: PathBuf,
    files: Mutex<Vec<PathBuf>>,
}

impl Stage {
    /// Makes the directory if it is missing, and a hidden one in it for what is not finished.
    ///
    /// # Errors
    /// The directory cannot be made or written.
    pub fn new(directory: &Path, reads: &[PathBuf]) -> std::io::Result<Self> {
        std::fs::create_dir_all(directory)?;
        let mut partial = partial();
        let beside = tempfile::Builder::new().prefix(".fem-").suffix(".partial").tempdir_in(directory)?.keep();
        partial.insert(beside.clone());
        Ok(Self { directory: directory.to_path_buf(), reads: reads.to_vec(), beside, files: Mutex::default() })
    }

    /// Writes a file that will stand at `name` in the directory, at most one folder deep.
    ///
    /// # Errors
    /// It is a file that was read, or it cannot be written.
    pub fn write(&self, name: &Path, bytes: &[u8]) -> Result<(), OutputError> {
        refuse_reads(&self.directory.join(name), &self.reads)?;
        let failed = failed(&self.directory.join(name));
        if let Some(folder) = name.parent().filter(|f| !f.as_os_str().is_empty()) {
            // Not with its parents: once the stage is abandoned it must not come back.
            match std::fs::create_dir(self.beside.join(folder)) {
                Err(e) if e.kind() != std::io::ErrorKind::AlreadyExists => return Err(failed(e)),
                _ => {}
            }
        }
        std::fs::write(self.beside.join(name), bytes).map_err(failed)?;
        self.files.lock().unwrap_or_else(PoisonError::into_inner).push(name.to_path_buf());
        Ok(())
    }

    /// Renames every file to its place.
    ///
    /// # Errors
    /// A place is taken by a directory, or cannot be written.
    pub fn publish(self) -> Result<(), OutputError> {
        let files = std::mem::take(&mut *self.files.lock().unwrap_or_else(PoisonError::into_inner));
        for name in files {
            let path = self.directory.join(&name);
            let failed = failed(&path);
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent).map_err(&failed)?;
            }
            std::fs::rename(self.beside.join(&name), &path).map_err(&failed)?;
        }
        Ok(())
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        // What cannot be removed is hidden and harmless.
        let _ = std::fs::remove_dir_all(&self.beside);
        partial().remove(&self.beside);
    }
}

/// Removes what is being written. Nothing more can be begun afterwards: for a program that ends.
pub fn abandon() {
    let partial = partial();
    for beside in partial.iter() {
        // Another thread may be writing into it: once more catches the file it had open.
        for _ in 0..2 {
            let _ = std::fs::remove_dir_all(beside);
        }
    }
    std::mem::forget(partial);
}

/// Removes the frames of an earlier, longer run: `NAME_0123.vtu` or `.vtp` and no other file.
pub fn remove_frames_from(folder: &Path, name: &str, first: usize) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let number = |file: OsString| -> Option<usize> {
        let numbered = file.to_str()?.strip_prefix(name)?.strip_prefix('_')?;
        let digits = numbered.strip_suffix(".vtu").or(numbered.strip_suffix(".vtp"))?.to_string();
        (digits.len() >= 4 && digits.bytes().all(|b| b.is_ascii_digit())).then(|| digits.parse().ok())?
    };
    for entry in entries.flatten() {
        if number(entry.file_name()).is_some_and(|n| n >= first) {
            // A frame that stays is harmless: the .pvd does not name it.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}
