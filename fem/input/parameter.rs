//! Quantities of a file that are not exactly known, and the names by which they are called.

use std::borrow::Borrow;
use std::fmt;
use std::ops::{Deref, Range};
use std::sync::Arc;

use super::{Bounds, Doubt};
use crate::units::{Kind, Quantity};

/// Name of a quantity among all of a model: the path of its key, as in `effects.tool-wear.rate` or
/// `workpiece.segments[1].diameter`. Clones share it.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParameterId(Arc<str>);

impl ParameterId {
    /// The last key of the path: `rate`.
    pub fn key(&self) -> &str {
        self.0.rsplit('.').next().unwrap_or_default()
    }
}

impl From<String> for ParameterId {
    fn from(path: String) -> Self {
        Self(path.into())
    }
}

impl From<&str> for ParameterId {
    fn from(path: &str) -> Self {
        Self(path.into())
    }
}

impl Deref for ParameterId {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

impl Borrow<str> for ParameterId {
    fn borrow(&self) -> &str {
        &self.0
    }
}

impl PartialEq<str> for ParameterId {
    fn eq(&self, other: &str) -> bool {
        &*self.0 == other
    }
}

impl PartialEq<&str> for ParameterId {
    fn eq(&self, other: &&str) -> bool {
        &*self.0 == *other
    }
}

impl PartialEq<String> for ParameterId {
    fn eq(&self, other: &String) -> bool {
        *self.0 == **other
    }
}

impl fmt::Display for ParameterId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

/// A quantity of the model that is not exactly known (`+-` or `?`).
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name.
    pub path: ParameterId,
    /// Kind of the quantity, with the canonical unit.
    pub kind: Kind,
    /// Value in SI and knowledge.
    pub quantity: Quantity,
    /// Range in which it may lie, SI.
    #[doc(hidden)]
    pub bounds: Bounds,
    /// Bytes of its value in the model file; `None` where the file does not have it.
    pub span: Option<Range<usize>>,
    /// How far it may be off where it is written as known, if it is what people estimate.
    #[doc(hidden)]
    pub doubt: Option<Doubt>,
}
