//! The list of what the program wrote into a folder, by which it knows its own files again.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

/// Name of the list.
pub const LIST: &str = ".fem-files.json";
const SCHEMA: &str = "fem-files/1";

/// A file that was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Path from the folder.
    pub name: PathBuf,
    /// The command whose results it belongs to.
    pub of: String,
    bytes: u64,
    /// FNV-1a (Fowler, Noll and Vo) of its content.
    digest: String,
}

impl Entry {
    /// What is known of a content.
    pub fn new(name: &Path, of: &str, bytes: &[u8]) -> Self {
        Self { name: name.to_path_buf(), of: of.into(), bytes: bytes.len() as u64, digest: digest(bytes) }
    }

    /// Whether the file in `folder` is still what was written.
    pub fn is_untouched(&self, folder: &Path) -> bool {
        let path = folder.join(&self.name);
        path.metadata().is_ok_and(|m| m.is_file() && m.len() == self.bytes)
            && std::fs::read(path).is_ok_and(|bytes| digest(&bytes) == self.digest)
    }
}

fn digest(bytes: &[u8]) -> String {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", bytes.iter().fold(0xcbf2_9ce4_8422_2325, step))
}

/// The list of a folder; empty where there is none, or none that can be read.
pub fn read(folder: &Path) -> Vec<Entry> {
    let text = std::fs::read(folder.join(LIST)).unwrap_or_default();
    let all: Value = serde_json::from_slice(&text).unwrap_or_default();
    let entry = |value: &Value| {
        Some(Entry {
            name: value["name"].as_str()?.into(),
            of: value["of"].as_str()?.into(),
            bytes: value["bytes"].as_u64()?,
            digest: value["fnv1a"].as_str()?.into(),
        })
    };
    let files = all["files"].as_array().filter(|_| all["schema"] == SCHEMA);
    files.into_iter().flatten().filter_map(entry).collect()
}

/// The text of a list.
pub fn text(entries: &[Entry]) -> String {
    let entry =
        |e: &Entry| json!({ "name": e.name.to_string_lossy(), "of": e.of, "bytes": e.bytes, "fnv1a": e.digest });
    let files: Vec<String> = entries.iter().map(|e| format!("    {}", entry(e))).collect();
    format!("{{\n  \"schema\": \"{SCHEMA}\",\n  \"files\": [\n{}\n  ]\n}}\n", files.join(",\n"))
}
