//! Files that a study keeps in its folder.

use std::fs::File;
use std::io;

use cap_fs_ext::{FollowSymlinks, MetadataExt, OpenOptionsFollowExt};
use cap_std::fs::{Dir, OpenOptions};

/// A file that stands in this folder and nowhere else; to be written it may be new.
///
/// # Errors
/// It cannot be opened, or is none of this folder alone.
pub fn opened(dir: &Dir, name: &str, is_written: bool) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(is_written).follow(FollowSymlinks::No);
    let is_there = match dir.symlink_metadata(name) {
        Ok(about) if about.is_file() && about.nlink() == 1 => true,
        Ok(_) => return Err(io::Error::new(io::ErrorKind::AlreadyExists, "it is no file of this folder alone")),
        Err(_) => false,
    };
    Ok(dir.open_with(name, options.create_new(is_written && !is_there))?.into_std())
}
