//! A hidden file of the folder, in which what is not saved yet is kept.

use std::net::{Ipv4Addr, SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Value as Json;

use super::folder::Folder;
use crate::output::files::{self, Guard};

/// How the names of such files begin, and how they end.
const BEGINS: &str = ".fem-session";
const ENDS: &str = "json";
/// What they say of themselves.
const SCHEMA: &str = "fem-session/1";
/// Largest of them, bytes: models have four megabytes.
const LARGEST: u64 = 10 << 20;

/// Time in which a program of this computer answers.
const ANSWERS: Duration = Duration::from_millis(200);

/// Where a session keeps what is not saved.
#[derive(Default)]
pub struct Kept {
    /// The file; none before there is something to keep.
    pub path: Option<PathBuf>,
    /// Where this session is served.
    pub port: u16,
    /// Number of the state that is in it.
    pub version: u64,
    /// What a session before left, and its file.
    pub last: Option<(PathBuf, Json)>,
}

/// Whether a session is that of a program that runs: it answers at its port.
fn is_served(told: &Json) -> bool {
    let port = told["port"].as_u64().and_then(|port| u16::try_from(port).ok()).filter(|port| *port > 0);
    let at = |port: u16| SocketAddr::from((Ipv4Addr::LOCALHOST, port));
    port.is_some_and(|port| TcpStream::connect_timeout(&at(port), ANSWERS).is_ok())
}

impl Kept {
    /// Looks for what a session before has left in a folder: the newest.
    pub fn of(folder: &Path) -> Self {
        let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
        let named = entries.filter(|entry| {
            let name = entry.file_name();
            name.to_str().is_some_and(|name| name.starts_with(BEGINS) && name.ends_with(ENDS))
        });
        let file = named.filter_map(|entry| {
            let about = entry.metadata().ok().filter(|own| own.is_file() && own.len() < LARGEST)?;
            Some((about.modified().ok()?, entry.path()))
        });
        let last = file.max().and_then(|(_, path)| {
            let told: Json = serde_json::from_slice(&std::fs::read(&path).ok()?).ok()?;
            (told["schema"] == SCHEMA && !is_served(&told)).then_some((path, told))
        });
        Self { last, ..Self::default() }
    }

    /// Writes what is not saved. A folder that cannot be written keeps nothing: saving there says why.
    pub fn write(&mut self, folder: &Folder, mut told: Json) {
        (told["schema"], told["port"]) = (SCHEMA.into(), self.port.into());
        let path = self.path.clone().unwrap_or_else(|| folder.path().join(folder.free(BEGINS, ENDS)));
        if files::write(&path, told.to_string().as_bytes(), Guard { reads: &[], force: true }).is_ok() {
            self.path = Some(path);
        }
    }

    /// Everything is saved.
    pub fn clear(&mut self) {
        if let Some(path) = self.path.take() {
            let _ = std::fs::remove_file(path);
        }
    }
}
