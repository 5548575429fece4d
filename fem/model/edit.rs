//! Edits of a model: what it kept of files and meshes is used again, and one edit less is the model before.

use std::path::Path;

use super::Model;
use super::entry::{Edit, Entry};
use super::tables::Tables;
use crate::input::{Problem, Raw, seen_from};
use crate::process::Coordinate;

impl Model {
    /// The model with these edits. What it kept of files and meshes is used again.
    ///
    /// # Errors
    /// They do not make a model; several tests together are not edited.
    #[doc(hidden)]
    pub fn edited(&self, edits: &[Edit]) -> Result<Self, Problem> {
        self.read_again(self.tables.edited(edits)?, self.recorded())
    }

    /// The model before the last of its edits; `None` where it is as it was read.
    ///
    /// # Errors
    /// A file that it names has changed, and makes no model any more.
    #[doc(hidden)]
    pub fn undone(&self) -> Result<Option<Self>, Problem> {
        self.tables.undone().map(|tables| self.read_again(tables, self.recorded())).transpose()
    }

    /// The edits that were made since it was read.
    #[doc(hidden)]
    pub fn edits(&self) -> &[Edit] {
        self.tables.edits()
    }

    /// The text behind a key, as it is written: `60 +- 15 N/um`; `None` where the model does not have the key, or a
    /// number stands there.
    pub fn written(&self, path: &str) -> Option<&str> {
        self.tables.value(path)?.as_str()
    }

    /// The value behind a key, if the model has it.
    #[doc(hidden)]
    pub fn raw(&self, path: &str) -> Option<Raw> {
        let item = self.tables.value(path)?;
        item.clone().into_value().ok().map(|value| Raw::of(value, item.span()))
    }

    /// The model of these tables, of rows with these further columns.
    pub(super) fn read_again(&self, tables: Tables, recorded: &[Coordinate]) -> Result<Self, Problem> {
        if self.campaign().is_some() {
            let problem = Problem::new(format!("{} are several tests", self.source.name));
            return Err(problem.help("edit the model of one of them"));
        }
        let read = Self::of_tables(self.source.clone(), tables, self.kept.clone(), recorded);
        // The mistake stands in the edit, not in the file.
        let first = |problems: Vec<Problem>| {
            let none = || Problem::new("the model would not be right");
            problems.into_iter().next().unwrap_or_else(none).at(None)
        };
        let model = read.map_err(first)?;
        let entered: Vec<(&str, f64)> = self.entered.iter().map(|(path, value)| (&**path, *value)).collect();
        if entered.is_empty() {
            return Ok(model);
        }
        model.with_values(&entered).map_err(|failure| Problem::new(failure.message).help(failure.help))
    }

    /// Its text.
    pub fn text(&self) -> String {
        self.tables.text(&self.source, &[])
    }

    /// Its text for a file at `path`: paths from its own folder are rewritten to be found from there.
    pub fn text_at(&self, path: &Path) -> String {
        let folder = path.parent().unwrap_or(Path::new(""));
        let seen = self.files.iter().filter_map(|file| {
            let seen = seen_from(&file.written, self.source.folder(), folder);
            let entry = Entry::Text(seen.display().to_string());
            (seen != file.written).then(|| Edit::Set { path: file.path.clone(), entry })
        });
        self.tables.text(&self.source, &seen.collect::<Vec<_>>())
    }
}
