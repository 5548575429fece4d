//! The process of a model.

use std::ops::Deref;
use std::sync::Arc;

use super::Campaign;
use crate::process::Process;

/// The process of a model, held so that a clone is cheap.
#[derive(Clone)]
pub enum ModelProcess {
    /// One of the catalogue.
    Catalogue(&'static dyn Process),
    /// The one that tests make together.
    Tests(Arc<Campaign>),
}

impl Deref for ModelProcess {
    type Target = dyn Process;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Catalogue(process) => *process,
            Self::Tests(campaign) => &**campaign,
        }
    }
}
