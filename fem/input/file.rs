//! Files that a model names: paths are relative to the folder of the model file.

use std::ffi::OsString;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use serde_json::json;

use super::bytes::{no_pipe, not_text, read};
use super::line_ends::one_line;
use super::visible::on_one_line;
use super::{Cache, FileKey, Problem, Reader, Source};

/// A file that a model names, and what it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedFile {
    /// Path from the working directory.
    pub path: PathBuf,
    /// Content of the file.
    pub bytes: Arc<[u8]>,
}

/// The files of a model, by their paths.
type Files = Cache<PathBuf, Arc<[u8]>, 16>;

impl Reader<'_> {
    /// A key with the path of a file of at most `limit` bytes, which is read; `None` where the key is absent,
    /// or the problem is noted.
    pub fn file(&self, key: &'static str, about: &'static str, limit: u64) -> Option<NamedFile> {
        self.named_file(key, about, limit, false)
    }

    /// The same with a key that must be there; its absence is a problem.
    pub fn required_file(&self, key: &'static str, about: &'static str, limit: u64) -> Option<NamedFile> {
        if !self.has(key) {
            self.missing(key, &format!("{key} = \"folder/name\""), about);
        }
        self.named_file(key, about, limit, true)
    }

    fn named_file(&self, key: &'static str, about: &str, limit: u64, required: bool) -> Option<NamedFile> {
        let about = format!("{about}; the path is relative to the folder of the model file");
        self.describe(key, || json!({ "type": "string", "description": about }), required);
        let item = self.item(key)?;
        let Some(written) = item.as_str().filter(|text| !text.is_empty()) else {
            let problem = Problem::new(format!("`{key}` names no file")).help(format!("write {key} = \"folder/name\""));
            self.refuse(problem.at(item.span()));
            return None;
        };
        self.keep_file(FileKey { written: written.into(), path: self.path_of(key).into() });
        let path = self.folder().join(written);
        let refused = one_line(written).and_then(|()| path.metadata().map_or(Ok(()), |about| no_pipe(&path, &about)));
        if let Err(Problem { message, help, .. }) = refused {
            let problem = Problem::new(format!("{}: {message}", on_one_line(&path.to_string_lossy())));
            self.refuse(Problem { help, ..problem }.at(item.span()));
            return None;
        }
        match self.kept::<Files>().get_or(path.clone(), |path| read(path, limit).map(Arc::from)) {
            Ok(bytes) => Some(NamedFile { path, bytes: bytes.as_ref().clone() }),
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

/// The way in which a path that is relative to the folder `from` is written in a file in the folder `to`:
/// unchanged where they are the same folder, or the path is absolute. Folders that do not exist are taken to
/// be no links.
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
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    let known = path.ancestors().find_map(|folder| Some((folder, folder.canonicalize().ok()?)));
    let Some((folder, mut place)) = known else { return path };
    for part in path.strip_prefix(folder).unwrap_or(Path::new("")).components() {
        match part {
            Component::ParentDir => drop(place.pop()),
            part => place.push(part),
        }
    }
    place
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
        // Folders that are still to be made.
        for to in ["made", "models/../made", "made/../made", "models/none/../../made"] {
            assert_eq!(seen("meshes/ring.msh", to), Path::new("../models/meshes/ring.msh"), "{to}");
        }
        assert_eq!(seen("meshes/ring.msh", "made/deep"), Path::new("../../models/meshes/ring.msh"));
    }
}
