//! A file of the user's to which whole entries are added. What stands in it is never written again, and no other run writes it
//! meanwhile.

use std::fs::TryLockError;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use cap_fs_ext::{FollowSymlinks, OpenOptionsFollowExt};
use cap_std::fs::OpenOptions;

use super::way::{Way, folder_of, open};
use crate::output::OutputError;

/// A file that is held until it is dropped.
pub struct Appended {
    path: PathBuf,
    file: std::fs::File,
    bytes: Vec<u8>,
}

impl Appended {
    /// Opens a file that is there, reads it, and holds it against other runs.
    ///
    /// # Errors
    /// It cannot be read or written, a link that others may have put there leads to it, or another run holds it.
    pub fn open(path: &Path) -> Result<Self, OutputError> {
        let failed = OutputError::at(path);
        let way = Way::to(folder_of(path), &[])?;
        let name = path.file_name().ok_or_else(|| failed(io::ErrorKind::InvalidInput.into()))?;
        let folder = open(&way.path()).map_err(&failed)?;
        if folder.symlink_metadata(name).map_err(&failed)?.is_symlink() {
            return Err(OutputError::Link { path: path.to_path_buf(), target: path.canonicalize().ok() });
        }
        let mut options = OpenOptions::new();
        options.read(true).write(true).follow(FollowSymlinks::No);
        let mut file = folder.open_with(name, &options).map_err(&failed)?.into_std();
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => return Err(OutputError::Busy { path: path.to_path_buf() }),
            // Some file systems know no locks; nothing else can be done there.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(&failed)?;
        Ok(Self { path: path.to_path_buf(), file, bytes })
    }

    /// What stands in it.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Adds an entry behind the first `whole` bytes, in one writing; what stands behind these is what another run could not
    /// write to its end. On disk when this returns.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn append(&mut self, whole: usize, entry: &str) -> Result<(), OutputError> {
        let mut written = || {
            if whole < self.bytes.len() {
                self.file.set_len(whole as u64)?;
            }
            self.file.seek(SeekFrom::Start(whole as u64))?;
            self.file.write_all(entry.as_bytes())?;
            self.file.sync_all()
        };
        written().map_err(OutputError::at(&self.path))
    }
}
