//! Files that appear whole: single ones written beside their place and renamed, those of a run all together.
//! What is there already and was not written by this program stays, unless the user says otherwise.

mod account;
mod beside;
mod replace;
mod stage;
mod way;
mod work;
mod written;

use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

use cap_std::fs::Dir;

pub use beside::abandon;
pub use stage::Stage;

pub(super) use account::Account;
pub(super) use way::{Way, reader};
pub(super) use written::read_plain;

use super::OutputError;

/// What may be replaced, and what not.
#[derive(Clone, Copy, Debug)]
pub struct Guard<'a> {
    /// Files that were read: never.
    pub reads: &'a [PathBuf],
    /// Whether files that the program did not write may be replaced.
    pub force: bool,
}

impl Guard<'_> {
    /// Refuses to write to `path` where it is one of the files that are read, by whatever way, where a file
    /// stands that is not to be replaced, or where the way leads over a link that others may have put there.
    ///
    /// # Errors
    /// It is one, one stands there, or it does.
    pub fn check(&self, path: &Path) -> Result<(), OutputError> {
        self.check_reads(path)?;
        Way::to(folder_of(path), self.reads)?;
        match path.symlink_metadata() {
            Ok(there) if !there.is_dir() && !self.force => Err(OutputError::Exists { path: path.to_path_buf() }),
            Ok(there) if !(there.is_dir() || there.is_file() || there.is_symlink()) => {
                Err(OutputError::Special { path: path.to_path_buf() })
            }
            _ => Ok(()),
        }
    }

    fn check_reads(&self, path: &Path) -> Result<(), OutputError> {
        match self.reads.iter().any(|read| is_same(read, path)) {
            true => Err(OutputError::Read { path: path.to_path_buf() }),
            false => Ok(()),
        }
    }
}

/// Whether two paths are one file, by whatever way.
fn is_same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

fn failed(path: &Path) -> impl Fn(std::io::Error) -> OutputError + use<> {
    let path = path.to_path_buf();
    // The operating system's own words, without the name of a partial file.
    move |error| {
        let error = error.raw_os_error().map_or(error, std::io::Error::from_raw_os_error);
        OutputError::File { path: path.clone(), error }
    }
}

/// The folder of a file.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

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
        written => written.map_err(failed(path)),
    }
}

/// Writes a file in a folder, whose path is `path`.
fn put(folder: &Dir, path: &Path, name: &OsStr, bytes: &[u8], force: bool) -> io::Result<()> {
    let account = Account::open().ok();
    account.as_ref().inspect(|account| work::sweep(account));
    let beside = beside::Beside::new_in(folder, path, account.as_ref())?;
    beside.dir().write(name, bytes)?;
    // A link, unlike a rename, never replaces what has appeared in the meantime.
    let linked =
        if force { Err(io::ErrorKind::Unsupported.into()) } else { beside.dir().hard_link(name, folder, name) };
    match linked {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(error),
        // No file system has to know links.
        Err(_) => beside.dir().rename(name, folder, name),
        Ok(()) => Ok(()),
    }
}

/// What stands around the seal of a page, in its last line.
const SEAL: (&str, &str) = ("<!-- sealed ", " -->\n");
const OF_PAGE: &str = "page";

/// A page with a last line by which this account knows it again; as it is where there is no key.
pub fn sealed(page: &str) -> String {
    let seal = |account: Account| format!("{page}{}{}{}", SEAL.0, account.seal(OF_PAGE, page.as_bytes()), SEAL.1);
    Account::open().map_or_else(|_| page.to_string(), seal)
}

/// Whether a file is a page that this account has sealed, as it was written.
pub fn is_sealed(path: &Path) -> bool {
    let is_own = || {
        let bytes = read_plain(&way::open(folder_of(path)).ok()?, Path::new(path.file_name()?), u64::MAX).ok()?;
        let (page, seal) = std::str::from_utf8(&bytes).ok()?.rsplit_once(SEAL.0)?;
        Some(Account::open().ok()?.has_sealed(OF_PAGE, page.as_bytes(), seal.strip_suffix(SEAL.1)?))
    };
    is_own().unwrap_or(false)
}
