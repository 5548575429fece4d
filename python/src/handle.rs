//! Models as Python holds them.

use std::sync::Arc;

use fem::model;
use pyo3::prelude::*;

/// A model that was read without a problem. It does not change.
#[pyclass(frozen, module = "fem._fem")]
pub struct Model(pub Arc<model::Model>);
