//! The files of one command on their way into a folder.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::beside::{Beside, locked, sweep, undisturbed};
use super::written::{self, Entry, LIST};
use super::{Guard, failed, replace};
use crate::output::OutputError;

/// Files on their way into a directory: all of them appear in the place of the earlier ones, or none, none
/// over a file that was read, and without leave none over a file that the program did not write.
pub struct Stage<'a> {
    directory: PathBuf,
    guard: Guard<'a>,
    /// The command whose results these are.
    of: &'static str,
    beside: Beside,
    /// Whether the hidden folder stands beside the directory, to be exchanged for it.
    exchanged: bool,
    files: Mutex<Vec<Entry>>,
}

impl<'a> Stage<'a> {
    /// Prepares the results of a command: makes what is missing above the directory, and a hidden folder for
    /// what is not finished.
    ///
    /// # Errors
    /// The directory cannot be made or written.
    pub fn new(directory: &Path, of: &'static str, guard: Guard<'a>) -> io::Result<Self> {
        // What a link names is exchanged, not the link.
        let directory = directory.canonicalize().unwrap_or_else(|_| directory.to_path_buf());
        if directory.symlink_metadata().is_ok_and(|m| !m.is_dir()) {
            return Err(io::ErrorKind::NotADirectory.into());
        }
        let parent = directory.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        std::fs::create_dir_all(parent)?;
        sweep(&directory);
        let beside = match !directory.exists() || replace::is_exchangeable(&directory, parent) {
            true => Beside::new_in(parent).ok(),
            false => None,
        };
        let exchanged = beside.is_some();
        let beside = match beside {
            Some(beside) => beside,
            None => {
                std::fs::create_dir_all(&directory)?;
                Beside::new_in(&directory)?
            }
        };
        Ok(Self { directory, guard, of, beside, exchanged, files: Mutex::default() })
    }

    /// Writes a file that will stand at `name` in the directory.
    ///
    /// # Errors
    /// It is a file that was read, or it cannot be written.
    pub fn write(&self, name: &Path, bytes: &[u8]) -> Result<(), OutputError> {
        self.guard.check_reads(&self.directory.join(name))?;
        let failed = failed(&self.directory.join(name));
        let mut folder = self.beside.path().to_path_buf();
        for part in name.parent().into_iter().flatten() {
            folder.push(part);
            // Not with its parents: once the stage is abandoned it must not come back.
            match std::fs::create_dir(&folder) {
                Err(e) if e.kind() != io::ErrorKind::AlreadyExists => return Err(failed(e)),
                _ => {}
            }
        }
        std::fs::write(self.beside.path().join(name), bytes).map_err(failed)?;
        let entry = Entry::new(name, self.of, bytes);
        self.files.lock().unwrap_or_else(PoisonError::into_inner).push(entry);
        Ok(())
    }

    /// Puts the files into place, and takes away what an earlier run of the same command left there.
    ///
    /// # Errors
    /// A file stands in the way that the program did not write; a place is taken by a directory, or cannot be
    /// written.
    pub fn publish(self) -> Result<(), OutputError> {
        loop {
            // One program at a time; whoever waited may find another folder under the name.
            let was_there = self.directory.exists();
            let lock = was_there.then(|| locked(&self.directory)).flatten();
            if lock.as_ref().is_some_and(|lock| !is_at(lock, &self.directory)) {
                continue;
            }
            let is_placed = if was_there { self.place()? } else { self.appear()? };
            if is_placed {
                return Ok(());
            }
        }
    }

    /// Puts the folder where none was; `false` where another program has put one there in the meantime, whose files are
    /// to be looked at under lock.
    fn appear(&self) -> Result<bool, OutputError> {
        let new = self.files.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let beside = self.beside.path();
        std::fs::write(beside.join(LIST), written::text(&new)).map_err(failed(&self.directory.join(LIST)))?;
        match std::fs::rename(beside, &self.directory) {
            Ok(()) => Ok(true),
            Err(_) if self.directory.exists() => Ok(false),
            Err(error) => Err(failed(&self.directory)(error)),
        }
    }

    /// Puts the files into the place of others; `false` where the folder has gone in the meantime.
    fn place(&self) -> Result<bool, OutputError> {
        let new = self.files.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let names: BTreeSet<&PathBuf> = new.iter().map(|entry| &entry.name).collect();
        let old = written::read(&self.directory);
        for entry in &new {
            self.check(entry, &old)?;
        }
        let is_stale = |e: &Entry| e.of == self.of && !names.contains(&e.name) && e.is_untouched(&self.directory);
        let (stale, kept): (Vec<Entry>, Vec<Entry>) = old.into_iter().partition(is_stale);
        let kept = kept.into_iter().filter(|e| !names.contains(&e.name));
        let list = written::text(&kept.chain(new.iter().cloned()).collect::<Vec<_>>());
        let beside = self.beside.path();
        std::fs::write(beside.join(LIST), list).map_err(failed(&self.directory.join(LIST)))?;
        let stale: Vec<PathBuf> = stale.into_iter().map(|e| e.name).collect();
        if self.exchanged && !self.directory.exists() {
            return Ok(false);
        }
        let leave: BTreeSet<PathBuf> = new.iter().map(|e| e.name.clone()).chain(stale.iter().cloned()).collect();
        let leave = leave.into_iter().chain([LIST.into()]).collect();
        let _undisturbed = undisturbed();
        if self.exchanged && replace::exchange(&self.directory, beside, &leave).is_ok() {
            return Ok(true);
        }
        replace::one_by_one(&self.directory, beside, &stale).map_err(|(path, error)| failed(&path)(error))?;
        Ok(true)
    }

    /// Refuses to replace what is not known to be the program's own.
    fn check(&self, entry: &Entry, old: &[Entry]) -> Result<(), OutputError> {
        let path = self.directory.join(&entry.name);
        let Ok(there) = path.symlink_metadata() else { return Ok(()) };
        if there.is_dir() {
            return Err(failed(&path)(io::ErrorKind::IsADirectory.into()));
        }
        let is_own = || old.iter().any(|o| o.name == entry.name && o.is_untouched(&self.directory));
        match self.guard.force || is_own() {
            true => Ok(()),
            false => Err(OutputError::Exists { path }),
        }
    }
}

/// Whether a locked folder is the one at a path.
#[cfg(unix)]
fn is_at(lock: &std::fs::File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    matches!((lock.metadata(), path.metadata()), (Ok(a), Ok(b)) if (a.dev(), a.ino()) == (b.dev(), b.ino()))
}

#[cfg(not(unix))]
fn is_at(_: &std::fs::File, _: &Path) -> bool {
    true
}
