//! Proof that a file is the program's own: a key that stands in the user's state folder and nowhere else. Nothing that
//! comes with a folder that was unpacked or cloned can have been sealed with it.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use etcetera::BaseStrategy;
use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;

/// Name and length of the key.
const KEY: &str = "key";
const LENGTH: usize = 32;

/// How an object of several lines begins, and what stands around the seal in it.
const OBJECT: &str = "{\n";
const FIELD: (&str, &str) = ("  \"seal\": \"", "\",\n");

/// The state folder of a user, and the key in it.
pub struct Account {
    folder: PathBuf,
    key: [u8; LENGTH],
}

impl Account {
    /// The state folder of whoever runs the program, which is made if it is missing.
    ///
    /// # Errors
    /// There is none, or it cannot be used. Nothing is known to be the program's own then.
    pub fn open() -> io::Result<Self> {
        let base = etcetera::choose_base_strategy().map_err(|_| io::Error::from(io::ErrorKind::NotFound))?;
        let folder = base.state_dir().unwrap_or_else(|| base.data_dir()).join("fem");
        // One that depends on where the program was started may have come with the files of others.
        if !folder.is_absolute() {
            return Err(io::ErrorKind::InvalidInput.into());
        }
        make_folder(&folder)?;
        let path = folder.join(KEY);
        // One of a disk that was full, or lost its power, is none.
        if path.symlink_metadata().is_ok_and(|about| about.is_file() && about.len() == 0 && is_ours(&about)) {
            std::fs::remove_file(&path)?;
        }
        if path.symlink_metadata().is_err() {
            make(&folder, &path)?;
        }
        let no_key = || io::Error::new(io::ErrorKind::InvalidData, format!("{} is no key", path.display()));
        let about = path.symlink_metadata()?;
        if !(about.is_file() && about.len() == LENGTH as u64 && is_ours(&about) && is_ours(&folder.metadata()?)) {
            return Err(no_key());
        }
        let key = std::fs::read(&path)?.try_into().map_err(|_| no_key())?;
        Ok(Self { folder, key })
    }

    /// Why the state folder cannot be used, where it cannot.
    pub fn unusable() -> Option<String> {
        Self::open().err().map(|error| format!("the state folder (XDG_STATE_HOME) cannot be used, {error}"))
    }

    /// Where what is under way is noted.
    pub fn works(&self) -> PathBuf {
        self.folder.join("works")
    }

    /// The seal of a content, as hexadecimal digits; `of` is what sort of content it is.
    pub fn seal(&self, of: &str, content: &[u8]) -> String {
        self.mac(of, content).finalize().into_bytes().iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// Whether this account sealed a content.
    pub fn has_sealed(&self, of: &str, content: &[u8], seal: &str) -> bool {
        let byte = |i: usize| u8::from_str_radix(seal.get(i..i + 2)?, 16).ok();
        let bytes: Option<Vec<u8>> = (0..seal.len()).step_by(2).map(byte).collect();
        bytes.is_some_and(|bytes| self.mac(of, content).verify_slice(&bytes).is_ok())
    }

    /// A JSON object of several lines with its seal as the first field.
    pub fn sealed_json(&self, of: &str, text: &str) -> String {
        let rest = text.strip_prefix(OBJECT).unwrap_or(text);
        format!("{OBJECT}{}{}{}{rest}", FIELD.0, self.seal(of, rest.as_bytes()), FIELD.1)
    }

    /// Whether this account sealed such an object, and it is as it was written.
    pub fn has_sealed_json(&self, of: &str, text: &[u8]) -> bool {
        let field = text.strip_prefix(OBJECT.as_bytes()).and_then(|text| text.strip_prefix(FIELD.0.as_bytes()));
        let parts = field.and_then(|field| field.split_at_checked(2 * LENGTH));
        parts.is_some_and(|(seal, rest)| {
            let rest = rest.strip_prefix(FIELD.1.as_bytes());
            rest.zip(str::from_utf8(seal).ok()).is_some_and(|(rest, seal)| self.has_sealed(of, rest, seal))
        })
    }

    fn mac(&self, of: &str, content: &[u8]) -> Hmac<Sha256> {
        // A key of any length is one.
        let mut mac = Hmac::<Sha256>::new_from_slice(&self.key).unwrap_or_else(|_| Hmac::new(&Default::default()));
        mac.update(of.as_bytes());
        mac.update(b"\n");
        mac.update(content);
        mac
    }
}

/// The state folder, which nobody else may look into.
#[cfg(unix)]
fn make_folder(folder: &Path) -> io::Result<()> {
    use std::os::unix::fs::DirBuilderExt;
    std::fs::DirBuilder::new().recursive(true).mode(0o700).create(folder)
}

#[cfg(not(unix))]
fn make_folder(folder: &Path) -> io::Result<()> {
    std::fs::create_dir_all(folder)
}

/// Whether something belongs to the account that runs the program, and nobody else may change it.
#[cfg(unix)]
fn is_ours(about: &std::fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    about.uid() == rustix::process::geteuid().as_raw() && about.mode() & 0o022 == 0
}

#[cfg(not(unix))]
fn is_ours(_: &std::fs::Metadata) -> bool {
    true
}

/// Random digits for a name that nobody can have used before.
pub fn digits() -> io::Result<String> {
    let mut bytes = [0; 12];
    getrandom::fill(&mut bytes).map_err(|_| io::Error::other("the system gives no random numbers"))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Makes the key; of two programs that make it at once, that of the first stays.
fn make(folder: &Path, path: &Path) -> io::Result<()> {
    let mut key = [0; LENGTH];
    getrandom::fill(&mut key).map_err(|_| io::Error::other("the system gives no random numbers"))?;
    let partial = folder.join(format!("{KEY}.{}", digits()?));
    let mut file = private(&partial)?;
    let made = file.write_all(&key).and_then(|()| match std::fs::hard_link(&partial, path) {
        Err(e) if e.kind() != io::ErrorKind::AlreadyExists => std::fs::rename(&partial, path),
        _ => Ok(()),
    });
    let _ = std::fs::remove_file(&partial);
    made
}

/// A new file that nobody else may read.
#[cfg(unix)]
fn private(path: &Path) -> io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    File::options().write(true).create_new(true).mode(0o600).open(path)
}

#[cfg(not(unix))]
fn private(path: &Path) -> io::Result<File> {
    File::create_new(path)
}
