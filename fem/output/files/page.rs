//! Pages that this account knows again.

use std::path::{Path, PathBuf};

use super::account::Account;
use super::guard::Guard;
use super::single::write;
use super::way::{self, folder_of};
use super::written::read_plain;
use crate::output::OutputError;

/// Start and end of the comment around the seal of a page, in its last line.
const SEAL: (&str, &str) = ("<!-- sealed ", " -->\n");
const OF_PAGE: &str = "page";
/// A file that is longer is no page.
const LONGEST: u64 = 1 << 29;

/// A page with a last line by which this account knows it again; as it is where there is no key.
pub fn sealed(page: &str) -> String {
    let seal = |account: Account| format!("{page}{}{}{}", SEAL.0, account.seal(OF_PAGE, page.as_bytes()), SEAL.1);
    Account::open().map_or_else(|_| page.to_string(), seal)
}

/// Whether a file is a page that this account has sealed, as it was written.
fn is_sealed(path: &Path) -> bool {
    let is_own = || {
        // One that was locked is to stay.
        if path.symlink_metadata().ok()?.permissions().readonly() {
            return None;
        }
        let bytes = read_plain(&way::open(folder_of(path)).ok()?, Path::new(path.file_name()?), LONGEST).ok()?;
        let (page, seal) = std::str::from_utf8(&bytes).ok()?.rsplit_once(SEAL.0)?;
        Some(Account::open().ok()?.has_sealed(OF_PAGE, page.as_bytes(), seal.strip_suffix(SEAL.1)?))
    };
    is_own().unwrap_or(false)
}

/// The guard of a page: an earlier page may be replaced by a newer one.
pub fn page_guard<'a>(path: &Path, reads: &'a [PathBuf], force: bool) -> Guard<'a> {
    Guard { reads, force: force || is_sealed(path) }
}

/// Writes a page with its seal.
///
/// # Errors
/// As those of [`write`]: what stands there is not to be replaced, or cannot be.
pub fn write_page(path: &Path, page: &str, reads: &[PathBuf], force: bool) -> Result<(), OutputError> {
    write(path, sealed(page).as_bytes(), page_guard(path, reads, force))
}
