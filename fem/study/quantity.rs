//! Paths of quantities that a plan or a table names.

use crate::input::did_you_mean;
use crate::model::Model;

/// Most names that a remedy lists.
pub const LISTED: usize = 40;

/// Message and remedy for a path at which the model has no quantity.
pub fn no_quantity(model: &Model, path: &str) -> (String, String) {
    let all = || model.quantities.iter().map(|quantity| &*quantity.path);
    let listed: Vec<&str> = all().take(LISTED).collect();
    let meant = did_you_mean(path, all(), '`');
    let message = format!("{} has no quantity `{path}`", model.source.name);
    (message, format!("{meant}what it leaves out must be written there first; it has {}", listed.join(", ")))
}
