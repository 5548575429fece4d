//! Files that a model names: paths are relative to the folder of the model file.

use std::ffi::OsString;
use std::io::Read;
use std::ops::Range;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use serde_json::json;

use super::{Problem, Reader, Source};

/// A file that a model names, and what it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedFile {
    /// Where it is, from the working directory.
    pub path: PathBuf,
    /// Its content.
    pub bytes: Arc<[u8]>,
}

/// Where a model names a file.
#[derive(Clone, Debug, PartialEq)]
pub struct FileKey {
    /// As the model writes it.
    pub written: PathBuf,
    /// Bytes of its value in the model file, quotes included.
    pub span: Range<usize>,
}

impl Reader<'_> {
    /// A key with the path of a file of at most `limit` bytes, which is read; `None` where the key is absent, or the problem is noted.
    pub fn file(&self, key: &'static str, about: &'static str, limit: u64) -> Option<NamedFile> {
        let about = format!("{about}; the path is relative to the folder of the model file");
        self.describe(key, || json!({ "type": "string", "description": about }), false);
        let item = self.item(key)?;
        let Some(written) = item.as_str().filter(|text| !text.is_empty()) else {
            let problem = Problem::new(format!("`{key}` names no file")).help(format!("write {key} = \"folder/name\""));
            self.refuse(problem.at(item.span()));
            return None;
        };
        if let Some(span) = item.span() {
            self.keep_file(FileKey { written: written.into(), span });
        }
        let path = self.folder().join(written);
        match read(&path, limit) {
            Ok(bytes) => Some(NamedFile { path, bytes: bytes.into() }),
            Err(problem) => {
                let message = format!("{}: {}", path.display(), problem.message);
                let help = "the path is relative to the folder of the model file";
                self.refuse(Problem::new(message).help(help).at(item.span()));
                None
            }
        }
    }
}

impl NamedFile {
    /// The file as text, to which problems can point.
    ///
    /// # Errors
    /// It is not UTF-8; says where it ceases to be.
    pub fn text(&self) -> Result<Source, Problem> {
        let name = self.path.display().to_string();
        match std::str::from_utf8(&self.bytes) {
            Ok(text) => Ok(Source::new(name, text)),
            Err(e) => Err(not_text(&self.bytes, e.valid_up_to())),
        }
    }
}

/// Reads at most `limit` bytes.
pub(super) fn read(path: &Path, limit: u64) -> Result<Vec<u8>, Problem> {
    let io = |e: std::io::Error| Problem::new(format!("the file cannot be read: {e}")).help(unreadable(&e));
    let metadata = std::fs::metadata(path).map_err(io)?;
    if metadata.is_dir() {
        return Err(Problem::new("this is a directory").help("name the file in it"));
    }
    if metadata.len() > limit {
        let (size, limit) = (metadata.len() as f64 / 1e6, limit as f64 / 1e6);
        let message = format!("the file has {size:.1} MB; at most {limit:.0} MB are read");
        return Err(Problem::new(message).help("is it the right file?"));
    }
    let mut bytes = Vec::new();
    // A device or a pipe has no length to be judged by.
    std::fs::File::open(path).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes)).map_err(io)?;
    if bytes.len() as u64 > limit {
        let message = format!("there are more than {:.0} MB to read", limit as f64 / 1e6);
        return Err(Problem::new(message).help("is it the right file?"));
    }
    Ok(bytes)
}

/// What is not UTF-8 from byte `valid` on.
pub(super) fn not_text(bytes: &[u8], valid: usize) -> Problem {
    let line = 1 + bytes[..valid].iter().filter(|b| **b == b'\n').count();
    let message = format!("the file is not UTF-8 text: line {line} holds a byte that is not");
    Problem::new(message).help("save it as UTF-8")
}

fn unreadable(error: &std::io::Error) -> &'static str {
    match error.kind() {
        std::io::ErrorKind::NotFound => "check the path; for a first model, `fem new PROCESS` writes one",
        std::io::ErrorKind::PermissionDenied => "check the file's permissions",
        _ => "check the path",
    }
}

/// How a path that is relative to the folder `from` is written in a file in the folder `to`: unchanged where they are the same folder, or the path is absolute.
/// Folders that do not exist are taken to be no links.
pub fn seen_from(path: &Path, from: &Path, to: &Path) -> PathBuf {
    let (from, to) = (absolute(from), absolute(to));
    if path.is_absolute() || from == to {
        return path.to_path_buf();
    }
    let target = absolute(&from.join(path));
    let shared = target.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    // Another drive, or nothing but the root in common: an absolute path says it better.
    if shared < 2 {
        return target;
    }
    let up = std::iter::repeat_n(Component::ParentDir, to.components().count() - shared);
    let parts: Vec<OsString> = up.chain(target.components().skip(shared)).map(|c| c.as_os_str().to_owned()).collect();
    parts.iter().collect()
}

/// A path from the root, without links where it exists and without `.` and `..` where it does not.
fn absolute(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    path.canonicalize().or_else(|_| std::path::absolute(path)).unwrap_or_else(|_| path.to_path_buf())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_follow_the_model_to_another_folder() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| place.path().join(name);
        std::fs::create_dir_all(at("models/meshes")).unwrap();
        std::fs::create_dir_all(at("new")).unwrap();
        std::fs::write(at("models/meshes/ring.msh"), "").unwrap();
        let seen = |path: &str, to: &str| seen_from(Path::new(path), &at("models"), &at(to));
        assert_eq!(seen("meshes/ring.msh", "models"), Path::new("meshes/ring.msh"));
        assert_eq!(seen("meshes/ring.msh", "new"), Path::new("../models/meshes/ring.msh"));
        assert_eq!(seen("meshes/ring.msh", "."), Path::new("models/meshes/ring.msh"));
        assert_eq!(seen("/root/ring.msh", "new"), Path::new("/root/ring.msh"));
    }
}
