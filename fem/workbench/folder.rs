//! The folder that is open. Nothing outside of it is read or written, whatever a page asks for.

use std::path::{Path, PathBuf};

use super::refusal::Refusal;
use crate::input::on_one_line;
use crate::model::Model;
use crate::output::files::{self, Guard};

/// Most bytes of a file of measurements.
pub const LARGEST: usize = 64 << 20;
/// Most entries of a folder that are looked at.
const MOST: usize = 2_000;
/// Endings of files that may hold measurements.
const MEASURED: &[&str] = &["csv", "txt", "tsv", "xlsx", "xls", "ods", "dat"];
/// Endings of programs of controls.
const PROGRAMS: &[&str] = &["ngc", "nc", "cnc", "gcode", "tap", "mpf", "spf"];

/// Files of a folder, each kind in the order of their names.
#[derive(Default)]
pub struct Listing {
    pub models: Vec<String>,
    pub measurements: Vec<String>,
    pub programs: Vec<String>,
}

/// A folder, by its path without links.
#[derive(Clone, Debug)]
pub struct Folder(PathBuf);

impl Folder {
    /// Opens a folder.
    ///
    /// # Errors
    /// There is none.
    pub fn open(path: &Path) -> Result<Self, Refusal> {
        let absent =
            |_| Refusal::new(format!("{} cannot be opened", path.display()), "name a folder, or a model in one");
        let path = path.canonicalize().map_err(absent)?;
        match path.is_dir() {
            true => Ok(Self(path)),
            false => Err(Refusal::new(format!("{} is no folder", path.display()), "name a folder, or a model in one")),
        }
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// The files in it that are of use here, by their names.
    pub fn listing(&self) -> Listing {
        let entries = std::fs::read_dir(&self.0).into_iter().flatten().take(MOST).filter_map(Result::ok);
        let is_shown = |name: &String| !name.starts_with('.') && self.file(name).is_ok();
        let mut names: Vec<String> =
            entries.filter_map(|entry| entry.file_name().into_string().ok()).filter(is_shown).collect();
        names.sort();
        let ending = |name: &String| name.rsplit_once('.').map_or(String::new(), |(_, end)| end.to_ascii_lowercase());
        let mut listing = Listing::default();
        for name in names {
            match &*ending(&name) {
                "toml" => listing.models.push(name),
                own if MEASURED.contains(&own) => listing.measurements.push(name),
                own if PROGRAMS.contains(&own) => listing.programs.push(name),
                _ => {}
            }
        }
        listing
    }

    /// A name of a file here: no way out, nothing hidden.
    fn name(name: &str) -> Result<&str, Refusal> {
        let is_name = Path::new(name).file_name().is_some_and(|own| own == name) && !name.contains(['\\', '\0', ':']);
        // A line end in a name would make lines of its own wherever the name is shown.
        let is_plain = !name.starts_with('.') && name.len() < 200 && !name.contains(char::is_control);
        match is_name && is_plain {
            true => Ok(name),
            false => {
                let problem = format!("`{}` is no name of a file here", on_one_line(name));
                Err(Refusal::new(problem, "name a file of this folder, without control characters"))
            }
        }
    }

    /// The path of a file that is there.
    ///
    /// # Errors
    /// It is no file of this folder, or a link that leads out of it.
    pub fn file(&self, name: &str) -> Result<PathBuf, Refusal> {
        let path = self.0.join(Self::name(name)?);
        let real = path.canonicalize().ok().filter(|real| real.is_file() && real.starts_with(&self.0));
        match real {
            Some(_) => Ok(path),
            None => Err(Refusal::new(format!("there is no file `{name}` in this folder"), "name one that is there")),
        }
    }

    /// The path of a file of measurements that is there, and not too large for a page.
    ///
    /// # Errors
    /// It is none, or it is.
    pub fn measurements(&self, name: &str) -> Result<PathBuf, Refusal> {
        let path = self.file(name).map_err(|refusal| refusal.of(name))?;
        match path.metadata().is_ok_and(|own| own.len() > LARGEST as u64) {
            false => Ok(path),
            true => {
                let problem = format!("{name} is too large for a page, which takes {} MB", LARGEST >> 20);
                Err(Refusal::new(problem, "thin it out first, or ask by commands: `fem compare`").of(name))
            }
        }
    }

    /// Refuses the text of a model that names a file elsewhere, before anything of that is read.
    ///
    /// # Errors
    /// One of its values is the path of such a file.
    pub fn keeps(&self, value: &str) -> Result<(), Refusal> {
        let is_path = !value.is_empty() && value.len() < 4096 && !value.contains('\0');
        let real = self.0.join(value).canonicalize().ok().filter(|_| is_path);
        match real.filter(|real| !real.starts_with(&self.0)) {
            None => Ok(()),
            Some(_) => Err(Self::elsewhere(value)),
        }
    }

    fn elsewhere(path: &str) -> Refusal {
        let problem = format!("the model reads {path}, which is not in this folder");
        Refusal::new(problem, "open the folder above, or copy the file here")
    }

    /// Refuses a model that reads files from elsewhere.
    ///
    /// # Errors
    /// It does.
    pub fn holds(&self, model: &Model) -> Result<(), Refusal> {
        let is_elsewhere = |path: &PathBuf| path.canonicalize().is_ok_and(|real| !real.starts_with(&self.0));
        match model.paths().into_iter().find(is_elsewhere) {
            None => Ok(()),
            Some(path) => Err(Self::elsewhere(&path.display().to_string())),
        }
    }

    /// Writes a file, whole or not at all; `over` whether it may take the place of one.
    ///
    /// # Errors
    /// There is one already, or it cannot be written.
    pub fn write(&self, name: &str, bytes: &[u8], over: bool) -> Result<PathBuf, Refusal> {
        let path = self.0.join(Self::name(name)?);
        files::write(&path, bytes, Guard { reads: &[], force: over })?;
        Ok(path)
    }

    /// The path of a folder in this one that is not there yet.
    ///
    /// # Errors
    /// It is no name, or something has it.
    pub fn fresh(&self, name: &str) -> Result<PathBuf, Refusal> {
        let path = self.0.join(Self::name(name)?);
        match path.symlink_metadata().is_ok() {
            false => Ok(path),
            true => Err(Refusal::new(format!("there is `{name}` already"), "write into a folder of another name")),
        }
    }

    /// A name that nothing has yet: `rows.csv`, `rows-2.csv`.
    pub fn free(&self, stem: &str, ending: &str) -> String {
        let names = (1..).map(|number| match number {
            1 => format!("{stem}.{ending}"),
            number => format!("{stem}-{number}.{ending}"),
        });
        names.into_iter().find(|name| !self.0.join(name).exists()).unwrap_or_default()
    }
}
