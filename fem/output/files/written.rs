//! The list of what the program wrote into a folder, by which it knows its own files again. The list is sealed: one
//! that came with the files of others tells nothing.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use cap_fs_ext::{FollowSymlinks, OpenOptionsFollowExt};
use cap_std::fs::{Dir, Metadata, OpenOptions};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::account::Account;
use super::way::below;

/// Name of the list.
pub const LIST: &str = ".fem-files.json";
const SCHEMA: &str = "fem-files/2";
/// A list that is longer was not written by this program.
const LONGEST: u64 = 1 << 28;

/// A file that was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Path from the folder.
    pub name: PathBuf,
    /// The command whose results it belongs to.
    pub of: String,
    bytes: u64,
    sha256: String,
}

impl Entry {
    /// Describes a content by its size and hash.
    pub fn new(name: &Path, of: &str, bytes: &[u8]) -> Self {
        Self { name: name.to_path_buf(), of: of.into(), bytes: bytes.len() as u64, sha256: digest(bytes) }
    }

    /// Describes the file of a name in a folder; `None` where no plain file stands there.
    pub fn of_file(folder: &Dir, name: &Path) -> Option<Self> {
        let mut file = open_plain(folder, name, u64::MAX).ok()?;
        let (mut hash, mut bytes, mut part) = (Sha256::new(), 0, vec![0; 1 << 16]);
        loop {
            match file.read(&mut part).ok()? {
                0 => break,
                read => {
                    hash.update(&part[..read]);
                    bytes += read as u64;
                }
            }
        }
        let sha256 = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        Some(Self { name: name.to_path_buf(), of: String::new(), bytes, sha256 })
    }

    /// Whether the file in `folder` is still what was written, and may be written.
    pub fn is_untouched(&self, folder: &Dir) -> bool {
        let about = below(folder, &self.name, false).and_then(|(inside, name)| inside.symlink_metadata(name));
        about.is_ok_and(|about| about.is_file() && about.len() == self.bytes && !about.permissions().readonly())
            && read_plain(folder, &self.name, self.bytes).is_ok_and(|bytes| digest(&bytes) == self.sha256)
    }

    /// Whether two are of one content.
    pub fn is_same(&self, other: &Self) -> bool {
        (self.bytes, &self.sha256) == (other.bytes, &other.sha256)
    }

    /// As JSON; `None` where the name is no text.
    pub fn to_json(&self) -> Option<Value> {
        Some(json!({ "name": self.name.to_str()?, "of": self.of, "bytes": self.bytes, "sha256": self.sha256 }))
    }

    /// Of JSON.
    pub fn of_json(value: &Value) -> Option<Self> {
        Some(Self {
            name: value["name"].as_str()?.into(),
            of: value["of"].as_str()?.into(),
            bytes: value["bytes"].as_u64()?,
            sha256: value["sha256"].as_str()?.into(),
        })
    }
}

fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The content of a plain file in a folder, reached by no link.
///
/// # Errors
/// It is no plain file, longer than `most`, or cannot be read.
pub fn read_plain(folder: &Dir, name: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open_plain(folder, name, most)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// A plain file of at most so many bytes.
fn open_plain(folder: &Dir, name: &Path, most: u64) -> io::Result<cap_std::fs::File> {
    let (inside, name) = below(folder, name, false)?;
    // A pipe would be waited for when it is opened.
    let is_plain = |about: Metadata| about.is_file() && about.len() <= most;
    if !is_plain(inside.symlink_metadata(name)?) {
        return Err(io::ErrorKind::InvalidInput.into());
    }
    inside.open_with(name, OpenOptions::new().read(true).follow(FollowSymlinks::No))
}

/// The list of a folder; `None` where there is none that this account has sealed.
pub fn read(folder: &Dir, account: Option<&Account>) -> Option<Vec<Entry>> {
    let text = read_plain(folder, Path::new(LIST), LONGEST).unwrap_or_default();
    if !account.is_some_and(|account| account.has_sealed_json(SCHEMA, &text)) {
        return None;
    }
    let all: Value = serde_json::from_slice(&text).unwrap_or_default();
    Some(all["files"].as_array()?.iter().filter_map(Entry::of_json).collect())
}

/// The text of a list.
pub fn text(entries: &[Entry], account: &Account) -> String {
    let lines: Vec<String> = entries.iter().filter_map(Entry::to_json).map(|file| format!("    {file}")).collect();
    let text = format!("{{\n  \"schema\": \"{SCHEMA}\",\n  \"files\": [\n{}\n  ]\n}}\n", lines.join(",\n"));
    account.sealed_json(SCHEMA, &text)
}
