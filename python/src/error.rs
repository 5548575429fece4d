//! Errors on their way to Python: `fem.ModelError`, `fem.DataError`, `fem.ComputationError` and `fem.Fault`.

use fem::cli;
use fem::input::{InputError, Problem};
use fem::model::Model;
use pyo3::prelude::*;
use pyo3::types::PyList;

/// Why a question has no answer.
pub enum Error {
    /// What a command would say.
    Command(Box<cli::Error>),
    /// The measurements are wrong.
    Data(InputError),
}

impl<E: Into<cli::Error>> From<E> for Error {
    fn from(error: E) -> Self {
        Self::Command(Box::new(error.into()))
    }
}

impl Error {
    /// What is wrong with measurements that were held against a model: a row of them, or a table of the model.
    pub fn of_data(error: InputError, model: &Model) -> Self {
        if error.source.name == model.source.name { error.into() } else { Self::Data(error) }
    }

    /// The exception that says it.
    pub fn raised(self, py: Python) -> PyErr {
        let (name, error) = match self {
            Self::Data(error) => ("DataError", cli::Error::Input(error)),
            Self::Command(error) if error.status() == 2 => ("ModelError", *error),
            Self::Command(error) => ("ComputationError", *error),
        };
        exception(py, name, &error).unwrap_or_else(|e| e)
    }
}

/// The exception of a fault in the program.
pub fn fault(py: Python, message: &str) -> PyErr {
    let made = || {
        let class = py.import("fem._errors")?.getattr("Fault")?;
        Ok(PyErr::from_value(class.call1((message,))?))
    };
    made().unwrap_or_else(|e: PyErr| e)
}

fn exception(py: Python, name: &str, error: &cli::Error) -> PyResult<PyErr> {
    let module = py.import("fem._errors")?;
    let problem = |file: Option<&str>, place: Option<(usize, usize)>, problem: &Problem| {
        let (line, column) = place.unzip();
        module.getattr("Problem")?.call1((file, line, column, &problem.message, &problem.help))
    };
    let problems: Vec<Bound<PyAny>> = match error {
        cli::Error::Input(InputError { source, problems, .. }) => {
            let place = |p: &Problem| p.span.as_ref().map(|span| source.line_column(span.start));
            problems.iter().map(|p| problem(Some(&source.name), place(p), p)).collect::<PyResult<_>>()?
        }
        other => vec![problem(None, None, &other.problem())?],
    };
    let exception = module.getattr(name)?.call1((error.text(false), PyList::new(py, problems)?))?;
    Ok(PyErr::from_value(exception))
}
