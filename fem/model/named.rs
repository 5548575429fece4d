//! Models that other files name: budgets, plans of studies.

use std::cell::RefCell;

use super::{LARGEST, Model};
use crate::input::{InputError, Reader};

impl Model {
    /// Reads the model that the key of another file names, which must be there; `None` where there is a problem.
    /// Those of the model file itself go to `broken`, for they lie in that file.
    #[doc(hidden)]
    pub fn named(
        t: &Reader,
        key: &'static str,
        about: &'static str,
        broken: &RefCell<Option<InputError>>,
    ) -> Option<Self> {
        match t.required_file(key, about, LARGEST)?.text() {
            Ok(source) => Self::parse(source).map_err(|e| broken.replace(Some(e))).ok(),
            Err(problem) => {
                t.problem(key, problem.message, problem.help.unwrap_or_default());
                None
            }
        }
    }
}
