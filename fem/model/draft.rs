//! A model file of which nothing but the process is known yet: what its formulas may name hangs on the measurements that
//! it is held against.

use std::path::Path;

use super::tables::Tables;
use super::{LARGEST, Model, files, find_process};
use crate::input::{InputError, Kept, Source};
use crate::measure::Reading;
use crate::process::{Coordinate, Process};

/// A model file that was parsed.
pub struct Draft {
    source: Source,
    tables: Tables,
    process: &'static dyn Process,
}

impl Draft {
    /// Parses a model file.
    ///
    /// # Errors
    /// It cannot be read, is no TOML, or says no process.
    pub fn load(path: &Path) -> Result<Self, InputError> {
        Self::parse(Source::read(path, LARGEST)?)
    }

    /// Parses the text of a model.
    ///
    /// # Errors
    /// It is no TOML, or says no process.
    pub fn parse(source: Source) -> Result<Self, InputError> {
        let tables = Tables::parse(&source)?;
        let process = find_process(tables.now()).map_err(|problem| InputError::one(source.clone(), problem))?;
        Ok(Self { source, tables, process })
    }

    /// Name of the file.
    pub fn name(&self) -> &str {
        &self.source.name
    }

    /// The process that it models.
    pub fn process(&self) -> &'static dyn Process {
        self.process
    }

    /// How its measurement files are read where they do not say it themselves.
    ///
    /// # Errors
    /// The table `[data]` is wrong.
    pub fn reading(&self) -> Result<Reading, InputError> {
        files::of_document(&self.source, self.tables.now())
    }

    /// Every text that it has for a value: names of files are among them.
    #[doc(hidden)]
    pub fn texts(&self) -> Vec<String> {
        self.tables.texts()
    }

    /// The model of rows that have these further columns.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its place and remedy.
    pub fn with(self, recorded: &[Coordinate]) -> Result<Model, InputError> {
        let Self { source, tables, .. } = self;
        let refused = |problems| tables.refused(&source, problems);
        Model::of_tables(source.clone(), tables.clone(), Kept::default(), recorded).map_err(refused)
    }
}
