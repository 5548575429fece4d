//! Hidden folders for what is not finished. A folder is locked as long as its program lives, so that whoever
//! comes next can sweep what a killed one has left.

use std::collections::BTreeSet;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::replace;

/// What is being written, for [`abandon`]. Whoever makes a partial folder holds the lock until it stands
/// here, so that none can be made behind the back of a program that is ending.
static PARTIAL: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

const PREFIX: &str = ".fem-";
const SUFFIX: &str = ".partial";

fn partial() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    // A panic while the set was held leaves it whole: entries are added and removed in one step each.
    PARTIAL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A hidden folder, gone with its owner.
pub struct Beside {
    path: PathBuf,
    /// Held for as long as the folder is in use.
    _lock: Option<File>,
}

impl Beside {
    /// Makes one in a directory that is there, and sweeps what dead programs left beside it.
    ///
    /// # Errors
    /// The directory cannot be written.
    pub fn new_in(directory: &Path) -> io::Result<Self> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        sweep(directory);
        let mut partial = partial();
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let path = directory.join(format!("{PREFIX}{}-{number}{SUFFIX}", std::process::id()));
            match std::fs::create_dir(&path) {
                Err(e) if e.kind() == io::ErrorKind::AlreadyExists => continue,
                made => made?,
            }
            let lock = locked(&path);
            // Before it was locked, somebody may have taken it for a dead program's.
            if path.exists() {
                partial.insert(path.clone());
                return Ok(Self { path, _lock: lock });
            }
        }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        // What cannot be removed is hidden and harmless.
        let _ = std::fs::remove_dir_all(&self.path);
        partial().remove(&self.path);
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

/// Keeps [`abandon`] off while files go into place.
pub fn undisturbed() -> impl Drop {
    partial()
}

/// Locks a folder; `None` where the system has no such locks. Another program's lock is waited for.
pub fn locked(folder: &Path) -> Option<File> {
    let file = File::open(folder).ok()?;
    file.lock().ok()?;
    Some(file)
}

/// Removes the folders of programs that are dead; one that died while it put its files into place is helped to
/// the end first.
pub fn sweep(directory: &Path) {
    let Ok(entries) = std::fs::read_dir(directory) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let is_partial = name.to_str().is_some_and(|n| n.starts_with(PREFIX) && n.ends_with(SUFFIX));
        if !is_partial || !entry.file_type().is_ok_and(|t| t.is_dir()) {
            continue;
        }
        let Ok(lock) = File::open(entry.path()) else { continue };
        // Held by a program that lives, or by none that locks can tell of.
        if lock.try_lock().is_ok() {
            replace::resume(&entry.path(), directory);
            let _ = std::fs::remove_dir_all(entry.path());
        }
    }
}
