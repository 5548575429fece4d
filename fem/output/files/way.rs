//! The way to a folder into which the program writes. No link on it is followed that may have come with the files of
//! others: below the folder in which the program was started, and below those of the files that it reads, every part
//! of the way is a folder itself. All that follows goes through handles of folders, one name at a time.

use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io;
use std::path::{Component, Path, PathBuf};

use cap_fs_ext::DirExt;
use cap_std::ambient_authority;
use cap_std::fs::Dir;

use crate::output::OutputError;

/// A folder that is to be written into, as far as it is there.
pub struct Way {
    /// The deepest folder on the way that is there, without links.
    path: PathBuf,
    /// Names of those below it that are still to be made.
    missing: Vec<OsString>,
}

impl Way {
    /// Finds the way to `directory`; `reads` are the files that the program reads.
    ///
    /// # Errors
    /// Something else than a folder stands on it, such as a link that others may have put there; or it cannot be
    /// entered.
    pub fn to(directory: &Path, reads: &[PathBuf]) -> Result<Self, OutputError> {
        let failed = OutputError::at(directory);
        let here = std::env::current_dir().and_then(|here| here.canonicalize()).map_err(&failed)?;
        let folders = reads.iter().flat_map(|file| folders_to(file)).chain([here.clone()]);
        let open_to_others: Vec<PathBuf> = folders.map(|folder| checkout_of(&folder)).collect();
        let mut way = Self { path: here, missing: Vec::new() };
        for part in directory.components() {
            match part {
                Component::Prefix(_) | Component::RootDir => way.path.push(part),
                Component::CurDir => {}
                Component::ParentDir => {
                    if way.missing.pop().is_none() {
                        way.path.pop();
                    }
                }
                Component::Normal(name) if !way.missing.is_empty() => way.missing.push(name.into()),
                Component::Normal(name) => {
                    let next = way.path.join(name);
                    match next.symlink_metadata() {
                        Ok(there) if there.is_dir() => way.path = next,
                        Ok(there) if there.is_symlink() => {
                            let target = next.canonicalize();
                            if open_to_others.iter().any(|folder| next.starts_with(folder)) {
                                return Err(OutputError::Link { path: next, target: target.ok() });
                            }
                            way.path = target.map_err(&failed)?;
                        }
                        Ok(_) => return Err(failed(io::ErrorKind::NotADirectory.into())),
                        Err(error) if error.kind() == io::ErrorKind::NotFound => way.missing.push(name.into()),
                        Err(error) => return Err(failed(error)),
                    }
                }
            }
        }
        Ok(way)
    }

    /// Whether the folder is there.
    pub fn is_whole(&self) -> bool {
        self.missing.is_empty()
    }

    /// Where it is, or will be.
    pub fn path(&self) -> PathBuf {
        self.path.join(self.missing.iter().collect::<PathBuf>())
    }

    /// The folder, made where it is missing.
    ///
    /// # Errors
    /// It cannot be made or entered.
    pub fn make(&self) -> io::Result<Dir> {
        self.missing.iter().try_fold(open(&self.path)?, |folder, name| make_in(&folder, name))
    }

    /// The folder in which it stands, made where it is missing, and its name there; `None` of the root of all.
    ///
    /// # Errors
    /// It cannot be made or entered.
    pub fn make_above(&self) -> io::Result<Option<(Dir, OsString)>> {
        if let Some((name, above)) = self.missing.split_last() {
            let folder = above.iter().try_fold(open(&self.path)?, |folder, name| make_in(&folder, name))?;
            return Ok(Some((folder, name.clone())));
        }
        match (self.path.parent(), self.path.file_name()) {
            (Some(above), Some(name)) => Ok(Some((open(above)?, name.into()))),
            _ => Ok(None),
        }
    }
}

/// The folders in which a file stands: that of its name, and of everything that links on the way to it name.
fn folders_to(file: &Path) -> Vec<PathBuf> {
    let (mut found, mut file) = (Vec::new(), file.to_path_buf());
    // Longer chains of links are not followed by any system.
    for _ in 0..40 {
        let Ok(folder) = folder_of(&file).canonicalize() else { break };
        found.push(folder.clone());
        let Ok(next) = std::fs::read_link(&file) else { break };
        file = folder.join(next);
    }
    found
}

/// The checkout to which a folder belongs, all of which comes from others; the folder itself where there is none.
fn checkout_of(folder: &Path) -> PathBuf {
    let root = folder.ancestors().find(|folder| folder.join(".git").symlink_metadata().is_ok());
    root.unwrap_or(folder).to_path_buf()
}

/// The folder at a path without links.
///
/// # Errors
/// It cannot be entered.
pub fn open(path: &Path) -> io::Result<Dir> {
    Dir::open_ambient_dir(path, ambient_authority())
}

/// A folder as a file that can be locked; `None` where the system has no such.
pub fn reader(folder: &Dir) -> Option<File> {
    // The handle that paths go through may be good for nothing else.
    folder.open(".").ok().map(cap_std::fs::File::into_std)
}

/// A folder in another one, made where it is missing.
fn make_in(folder: &Dir, name: &OsStr) -> io::Result<Dir> {
    match folder.create_dir(name) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
        _ => {}
    }
    folder.open_dir_nofollow(name)
}

/// The folder in which the file `name` of `folder` stands, and its own name there; `makes` those that are missing.
///
/// # Errors
/// A part of the name is none of a file below, or no folder, or cannot be made.
pub fn below<'a>(folder: &Dir, name: &'a Path, makes: bool) -> io::Result<(Dir, &'a OsStr)> {
    let mut parts = name.components();
    let Some(Component::Normal(file)) = parts.next_back() else { return Err(io::ErrorKind::InvalidInput.into()) };
    let mut inside = folder.try_clone()?;
    for part in parts {
        let Component::Normal(part) = part else { return Err(io::ErrorKind::InvalidInput.into()) };
        inside = if makes { make_in(&inside, part)? } else { inside.open_dir_nofollow(part)? };
    }
    Ok((inside, file))
}

/// The folder of a file.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}
