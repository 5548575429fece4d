//! Single files.

use std::ffi::OsStr;
use std::io;
use std::path::Path;

use cap_std::fs::Dir;

use super::beside::Beside;
use super::guard::Guard;
use super::way::{Way, folder_of};
use super::work;
use crate::output::OutputError;

/// Writes one file beside its place and renames it there; missing directories are made.
///
/// # Errors
/// The guard refuses; the directory cannot be made, the file not written (a full disk), or not renamed.
pub fn write(path: &Path, bytes: &[u8], guard: Guard) -> Result<(), OutputError> {
    guard.check(path)?;
    let way = Way::to(folder_of(path), guard.reads)?;
    let written = || {
        let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?;
        put(&way.make()?, &way.path(), name, bytes, guard.force)
    };
    match written() {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            Err(OutputError::Exists { path: path.to_path_buf() })
        }
        written => written.map_err(OutputError::at(path)),
    }
}

/// Writes a file in a folder, whose path is `path`.
fn put(folder: &Dir, path: &Path, name: &OsStr, bytes: &[u8], force: bool) -> io::Result<()> {
    let account = work::account();
    let beside = Beside::new_in(folder, path, account.as_ref())?;
    beside.dir().write(name, bytes)?;
    // A link, unlike a rename, never replaces what has appeared in the meantime.
    let linked =
        if force { Err(io::ErrorKind::Unsupported.into()) } else { beside.dir().hard_link(name, folder, name) };
    match linked {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(error),
        // No file system has to know links.
        Err(_) => {
            if let Some(there) = folder.symlink_metadata(name).ok().filter(cap_std::fs::Metadata::is_file) {
                beside.dir().set_permissions(name, there.permissions())?;
            }
            beside.dir().rename(name, folder, name)
        }
        Ok(()) => Ok(()),
    }
}
