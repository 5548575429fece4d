//! The process of a model.

use std::ops::Deref;
use std::sync::Arc;

use super::Campaign;
use super::recorded::Recorded;
use crate::process::{Coordinate, Process};

/// The process of a model, held so that a clone is cheap.
#[derive(Clone)]
pub enum ModelProcess {
    /// One of the catalogue.
    Catalogue(&'static dyn Process),
    /// One of the catalogue, of rows with further columns.
    Recorded(Arc<Recorded>),
    /// The one that tests make together.
    Tests(Arc<Campaign>),
}

impl ModelProcess {
    /// A process of the catalogue with the columns of files, and those of which a model says what they usually are.
    pub(super) fn of(process: &'static dyn Process, of_files: &[Coordinate], said: Vec<Coordinate>) -> Self {
        match Recorded::new(process, of_files, said) {
            Some(process) => Self::Recorded(Arc::new(process)),
            None => Self::Catalogue(process),
        }
    }
}

impl Deref for ModelProcess {
    type Target = dyn Process;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Catalogue(process) => *process,
            Self::Recorded(process) => &**process,
            Self::Tests(campaign) => &**campaign,
        }
    }
}
