//! Models and measurements as the command line names them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args;
use super::error::Error;
use crate::ask::{self, Depth, Made, Page, read_all, refuse_mixed};
use crate::input::{InputError, stem};
use crate::measure::{Decimal, Measurements, Reading};
use crate::model::Model;
use crate::process::Process;
use crate::progress::Progress;

impl args::Reading {
    /// How the files are to be read.
    pub fn said(&self) -> Result<Reading, ask::Error> {
        let decimal = self.decimal.map(|mark| match mark {
            args::Mark::Comma => Decimal::Comma,
            args::Mark::Point => Decimal::Point,
        });
        let headings = self.header.map(|line| (line > 0).then_some(line));
        Ok(Reading::new(&self.columns, decimal)?.within(headings, self.sheet.clone()).as_typed(self.as_typed))
    }
}

impl args::Data {
    /// Reads the measurements of a process, of several files as one; their text stays with those that `are_written`
    /// again. `kept` is how the model's files are read.
    pub fn load(&self, process: &dyn Process, kept: &Reading, are_written: bool) -> Result<Measurements, Error> {
        let all = Measurements::load_all(&self.with, process, &self.reading.said()?.over(kept), false)?;
        Ok(if are_written { all } else { all.without_records() })
    }

    /// A model and the files of its measurements, which nothing may overwrite.
    pub fn reads(&self, model: &Path) -> Vec<PathBuf> {
        std::iter::once(model.to_path_buf()).chain(self.with.iter().cloned()).collect()
    }
}

impl args::Report {
    /// Makes the page of the files; `live` is the version of one that renews itself.
    pub fn page(&self, depth: Depth, live: Option<u64>, progress: &Arc<Progress>) -> Result<Made, ask::Error> {
        let (models, measurements) = match self.with.is_empty() {
            true => {
                let load = |path: &PathBuf| Model::load(path);
                (self.models.iter().map(load).collect::<Result<_, InputError>>()?, None)
            }
            false => {
                let said = self.reading.said()?;
                let measured = |process: &dyn Process, kept: &Reading| {
                    Ok(Measurements::load_all(&self.with, process, &said.over(kept), false)?)
                };
                read_all::<_, ask::Error>(&self.models, measured)?
                    .map_or((Vec::new(), None), |(models, measured)| (models, Some(measured)))
            }
        };
        refuse_mixed(&models)?;
        let files = models.iter().flat_map(Model::paths).chain(self.with.iter().cloned()).collect();
        let most_effects = usize::from(self.max_effects);
        Page { models: &models, measurements, files, most_effects, depth, live }.made(progress)
    }
}

/// Folder `out/NAME` for what is made of a file; `usual` where that has no name.
pub fn default_directory(file: &Path, usual: &str) -> PathBuf {
    Path::new("out").join(stem(file).unwrap_or(usual.as_ref()))
}
