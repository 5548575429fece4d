//! The extension module `fem._fem`: hands models, questions and answers over to Python and back. Whatever makes them
//! pleasant to use is written in Python, beside it.

mod answer;
mod compute;
mod data;
mod document;
mod error;
mod handle;
mod model;
mod next;
mod study;

use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use fem::ask;
use fem::output::{BudgetAnswer, json, text};
use fem::progress::Progress;
use pyo3::prelude::*;

use compute::compute;
use handle::Model;

/// Runs the command `fem` by its arguments, the name of the program first, and returns its exit status.
#[pyfunction]
fn command(py: Python, arguments: Vec<OsString>) -> u8 {
    py.detach(|| fem::command(arguments))
}

/// The commented model to start from.
#[pyfunction]
fn starting_model(py: Python, process: String) -> PyResult<String> {
    compute(py, &Arc::default(), move |_| Ok(ask::starting_file(&process)?.text))
}

/// A model and what was measured, to try everything on: the texts of their files.
#[pyfunction]
fn demo() -> (&'static str, &'static str) {
    let [(_, model), (_, measured), _] = ask::STORY;
    (model, measured)
}

/// The catalogue of effects as JSON and as text, whole or of a process or an effect.
#[pyfunction]
#[pyo3(signature = (name=None))]
fn catalogue(py: Python, name: Option<String>) -> PyResult<(String, String)> {
    compute(py, &Arc::default(), move |_| {
        let found = ask::catalogue(name.as_deref())?;
        Ok((json(&found), text(&found, None)))
    })
}

/// The budget of a file as JSON and as text, and what should not be overlooked.
#[pyfunction]
fn budget(py: Python, path: PathBuf) -> PyResult<(String, String, Vec<String>)> {
    compute(py, &Arc::default(), move |progress: &Arc<Progress>| {
        let file = fem::budget::Budget::load(&path)?;
        let estimate = file.estimate(progress)?;
        let answer = BudgetAnswer(&file, estimate.as_ref());
        Ok((json(&answer), text(&answer, None), answer.warnings()))
    })
}

/// A computation that goes wrong inside, or one that never ends unless it is stopped: whoever builds on the module can
/// see what becomes of them.
#[pyfunction]
fn rehearse(py: Python, fault: bool) -> PyResult<()> {
    compute(py, &Arc::default(), move |progress: &Arc<Progress>| {
        assert!(!fault, "a rehearsal");
        while !progress.is_stopped() {
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(())
    })
}

#[pymodule]
fn _fem(module: &Bound<PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<Model>()?;
    module.add_class::<study::Study>()?;
    module.add_function(wrap_pyfunction!(command, module)?)?;
    module.add_function(wrap_pyfunction!(starting_model, module)?)?;
    module.add_function(wrap_pyfunction!(demo, module)?)?;
    module.add_function(wrap_pyfunction!(catalogue, module)?)?;
    module.add_function(wrap_pyfunction!(budget, module)?)?;
    module.add_function(wrap_pyfunction!(rehearse, module)?)?;
    module.add_function(wrap_pyfunction!(document::keys, module)?)?;
    module.add_function(wrap_pyfunction!(document::written, module)?)?;
    module.add_function(wrap_pyfunction!(document::with_value, module)?)?;
    module.add_function(wrap_pyfunction!(document::without, module)?)?;
    module.add_function(wrap_pyfunction!(study::study_jobs, module)?)?;
    module.add_function(wrap_pyfunction!(model::compare, module)?)?;
    module.add_function(wrap_pyfunction!(next::next_part, module)?)?;
    module.add_function(wrap_pyfunction!(model::report, module)?)
}
