//! Hidden folders for what is not finished, each under a name that nobody else can have used, and noted in the user's
//! state folder as long as it is there.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use cap_fs_ext::DirExt;
use cap_std::fs::Dir;

use super::account::Account;
use super::work::{Work, hidden, is_hidden};

/// Hidden folders being written, for [`abandon`], by their names, with the folder in which each stands and its note.
/// Whoever makes a hidden folder holds the lock until it stands here, so that none can be made behind the back of a
/// program that is ending.
static PARTIAL: Mutex<BTreeMap<String, (Dir, Option<PathBuf>)>> = Mutex::new(BTreeMap::new());

/// Whether the program is ending, and nothing more is to be written.
static IS_ENDING: AtomicBool = AtomicBool::new(false);

/// Whether the program is ending, and nothing more is to be written.
pub fn is_ending() -> bool {
    IS_ENDING.load(Ordering::SeqCst)
}

fn partial() -> MutexGuard<'static, BTreeMap<String, (Dir, Option<PathBuf>)>> {
    // A panic while the map was held leaves it whole: entries are added and removed in one step each.
    PARTIAL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A hidden folder, gone with its owner.
pub struct Beside {
    above: Dir,
    name: String,
    dir: Dir,
    /// Its note; `None` where the user has no state folder: what a killed program leaves is not swept then.
    work: Option<Work>,
    /// Whether another folder stands under its name.
    is_exchanged: bool,
}

impl Beside {
    /// Makes one in the folder `above`, whose path is `path`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn new_in(above: &Dir, path: &Path, account: Option<&Account>) -> io::Result<Self> {
        sweep_empty(above);
        let name = hidden()?;
        let mut partial = partial();
        let work = account.and_then(|account| Work::begin(account, &path.join(&name)).ok());
        above.create_dir(&name)?;
        let dir = above.open_dir_nofollow(&name)?;
        let note = work.as_ref().map(|work| work.path().to_path_buf());
        partial.insert(name.clone(), (above.try_clone()?, note));
        Ok(Self { above: above.try_clone()?, name, dir, work, is_exchanged: false })
    }

    /// The folder.
    pub fn dir(&self) -> &Dir {
        &self.dir
    }

    /// Its name there.
    pub fn name(&self) -> &OsStr {
        OsStr::new(&self.name)
    }

    /// Its note, if it has one.
    pub fn work(&mut self) -> Option<&mut Work> {
        self.work.as_mut()
    }

    /// Says that another folder stands under its name, which is not for this one to remove.
    pub fn exchanged(&mut self) {
        self.is_exchanged = true;
    }
}

/// Removes hidden folders in which nothing stands, left by programs that were killed where no note could be written. One that
/// somebody may just have made is left.
fn sweep_empty(above: &Dir) {
    const AGE: Duration = Duration::from_secs(3600);
    for entry in above.entries().into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_old = || {
            let about = above.symlink_metadata(&name).ok()?;
            let age = about.modified().ok()?.into_std().elapsed().ok()?;
            Some(about.is_dir() && age > AGE)
        };
        if name.to_str().is_some_and(is_hidden) && is_old() == Some(true) {
            // Of one with something in it nobody knows whose that is.
            let _ = above.remove_dir(&name);
        }
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        // What cannot be removed is hidden and harmless.
        if !self.is_exchanged {
            let _ = self.above.remove_dir_all(&self.name);
        }
        partial().remove(&self.name);
    }
}

/// Removes what is being written. Nothing more can be begun afterwards: for a program that ends.
pub fn abandon() {
    let partial = partial();
    IS_ENDING.store(true, Ordering::SeqCst);
    for (name, (above, note)) in partial.iter() {
        let is_gone = || above.remove_dir_all(name).is_ok() || above.symlink_metadata(name).is_err();
        // Other threads may still be writing the files that they had begun.
        for _ in 0..200 {
            if is_gone() {
                let _ = note.as_ref().map(std::fs::remove_file);
                break;
            }
            std::thread::sleep(Duration::from_millis(2));
        }
    }
    std::mem::forget(partial);
}

/// Keeps [`abandon`] off while files go into place.
pub fn undisturbed() -> impl Drop {
    partial()
}
