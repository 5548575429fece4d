//! Putting a set of files into the place of another: one folder for the other in one step where the system can
//! do that, else file by file, which whoever comes next brings to the end if it is interrupted.

use std::collections::BTreeSet;
use std::io;
use std::path::{Component, Path, PathBuf};

/// Most files of others in a folder that are carried over when it is exchanged.
const MOST_CARRIED: usize = 2000;
/// In a partial folder whose files are on their way into place: the files to be taken away from there.
const GOING: &str = ".going";

/// Whether a folder can be exchanged for another one made in `parent`: both on one file system, and nobody's
/// working directory is within.
pub fn is_exchangeable(folder: &Path, parent: &Path) -> bool {
    if !EXCHANGES || folder.parent().is_none() {
        return false;
    }
    let stands_in = std::env::current_dir().and_then(|d| d.canonicalize()).map_or(true, |d| d.starts_with(folder));
    !stands_in && is_one_device(folder, parent) && files_below(folder, MOST_CARRIED).is_some()
}

/// Files below a folder by their paths from it, links as such; `None` where they are more than `most`, or
/// cannot be listed.
pub fn files_below(folder: &Path, most: usize) -> Option<Vec<PathBuf>> {
    let (mut found, mut open) = (Vec::new(), vec![PathBuf::new()]);
    while let Some(inside) = open.pop() {
        for entry in std::fs::read_dir(folder.join(&inside)).ok()? {
            let entry = entry.ok()?;
            let path = inside.join(entry.file_name());
            match entry.file_type().ok()?.is_dir() {
                true => open.push(path),
                false => found.push(path),
            }
            if found.len() + open.len() > most {
                return None;
            }
        }
    }
    Some(found)
}

/// Exchanges `folder` for `new` in one step, once `new` holds what is to stay of it: all files of `folder` but
/// those of `leave` and those that are in `new` already. `new` holds the old files afterwards.
///
/// # Errors
/// The file system knows no links or no exchange; nothing has changed then but for links in `new`.
pub fn exchange(folder: &Path, new: &Path, leave: &BTreeSet<PathBuf>) -> io::Result<()> {
    let stays = |path: &&PathBuf| !leave.contains(*path) && new.join(path).symlink_metadata().is_err();
    let all = files_below(folder, MOST_CARRIED + leave.len()).ok_or_else(|| io::Error::other("too many files"))?;
    for path in all.iter().filter(stays) {
        if let Some(inside) = path.parent() {
            std::fs::create_dir_all(new.join(inside))?;
        }
        std::fs::hard_link(folder.join(path), new.join(path))?;
    }
    std::fs::set_permissions(new, folder.metadata()?.permissions())?;
    swap(folder, new)?;
    // What somebody put into the folder in the meantime.
    for path in files_below(new, usize::MAX).unwrap_or_default().iter().filter(|p| !leave.contains(*p)) {
        let to = folder.join(path);
        if to.symlink_metadata().is_err() {
            let _ = to.parent().map(std::fs::create_dir_all);
            let _ = std::fs::rename(new.join(path), to);
        }
    }
    Ok(())
}

/// Moves the files of `new` into `folder`, one by one, and takes those of `leave` away from there.
///
/// # Errors
/// A place is taken by a directory, or cannot be written.
pub fn one_by_one(folder: &Path, new: &Path, leave: &[PathBuf]) -> Result<(), (PathBuf, io::Error)> {
    // From the folder in which the partial one stands, so that both may be moved together.
    let to = new.parent().and_then(|beside| folder.strip_prefix(beside).ok()).unwrap_or(Path::new(""));
    let lines: Vec<_> =
        std::iter::once(to).chain(leave.iter().map(PathBuf::as_path)).map(Path::to_string_lossy).collect();
    std::fs::write(new.join(GOING), lines.join("\n")).map_err(|e| (folder.to_path_buf(), e))?;
    finish(folder, new, leave)
}

fn finish(folder: &Path, new: &Path, leave: &[PathBuf]) -> Result<(), (PathBuf, io::Error)> {
    let at = |path: &Path| {
        let path = folder.join(path);
        move |error| (path, error)
    };
    for path in leave {
        // What is left over does no harm.
        let _ = std::fs::remove_file(folder.join(path));
    }
    for path in files_below(new, usize::MAX).unwrap_or_default().iter().filter(|p| *p != Path::new(GOING)) {
        if let Some(inside) = path.parent() {
            std::fs::create_dir_all(folder.join(inside)).map_err(at(path))?;
        }
        std::fs::rename(new.join(path), folder.join(path)).map_err(at(path))?;
    }
    Ok(())
}

/// Brings to the end what [`one_by_one`] of a dead program began from `new`, which stands in `directory`.
pub fn resume(new: &Path, directory: &Path) {
    let Ok(list) = std::fs::read_to_string(new.join(GOING)) else { return };
    let mut lines = list.split('\n').map(PathBuf::from);
    let folder = lines.next().unwrap_or_default();
    let leave: Vec<PathBuf> = lines.collect();
    let is_below = |path: &PathBuf| path.components().all(|part| matches!(part, Component::Normal(_)));
    if is_below(&folder) && leave.iter().all(is_below) {
        // Where it cannot be ended, nobody is left to be told.
        let _ = finish(&directory.join(folder), new, &leave);
    }
}

/// Whether the system exchanges folders.
const EXCHANGES: bool = cfg!(any(target_os = "linux", target_vendor = "apple"));

#[cfg(any(target_os = "linux", target_vendor = "apple"))]
fn swap(a: &Path, b: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    Ok(renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE)?)
}

#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
fn swap(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

#[cfg(unix)]
fn is_one_device(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    matches!((a.metadata(), b.metadata()), (Ok(a), Ok(b)) if a.dev() == b.dev())
}

#[cfg(not(unix))]
fn is_one_device(_: &Path, _: &Path) -> bool {
    false
}
