//! Files that appear whole: written beside, then renamed.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use super::OutputError;

/// Files that are being written, for [`abandon`].
static PARTIAL: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn partial() -> std::sync::MutexGuard<'static, BTreeSet<PathBuf>> {
    // A panic while the set was held leaves it whole: entries are added and removed in one step each.
    PARTIAL.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// Writes a file beside its place and renames it there; missing directories are made.
///
/// # Errors
/// The directory cannot be made, the file not written (a full disk), or not renamed.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    let failed = |error| OutputError::File { path: path.to_path_buf(), error };
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(directory).map_err(failed)?;
    let mut file =
        tempfile::Builder::new().prefix(".fem-").suffix(".partial").tempfile_in(directory).map_err(failed)?;
    let beside = file.path().to_path_buf();
    partial().insert(beside.clone());
    let result = file.write_all(bytes).and_then(|()| publish(file, path));
    partial().remove(&beside);
    result.map_err(failed)
}

/// Renames the finished file to its place, readable as any file the user makes.
fn publish(file: tempfile::NamedTempFile, path: &Path) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = std::fs::metadata(path).map_or(0o644, |m| m.permissions().mode());
        file.as_file().set_permissions(std::fs::Permissions::from_mode(mode))?;
    }
    file.persist(path).map(|_| ()).map_err(|e| e.error)
}

/// Removes what was being written when the program is told to stop.
pub fn abandon() {
    for path in partial().iter() {
        // Nothing more can be done about a file that will not go.
        let _ = std::fs::remove_file(path);
    }
}

/// Removes the files of an earlier, longer run from a folder of frames.
pub fn remove_others(folder: &Path, keep: impl Fn(&str) -> bool) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let stale = name.to_str().is_some_and(|n| n.ends_with(".vtu") && !keep(n));
        if stale {
            // A frame that stays is harmless: the .pvd does not name it.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}
