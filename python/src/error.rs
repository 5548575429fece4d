//! Errors on their way to Python: `fem.ModelError`, `fem.DataError`, `fem.ComputationError` and `fem.Fault`.

use fem::ask::{self, Marks};
use fem::input::{InputError, Problem};
use pyo3::prelude::*;
use pyo3::types::PyList;

/// Why a question has no answer.
pub struct Error(Box<ask::Error>);

impl<E: Into<ask::Error>> From<E> for Error {
    fn from(error: E) -> Self {
        Self(Box::new(error.into()))
    }
}

impl Error {
    /// The exception that says it.
    pub fn raised(self, py: Python) -> PyErr {
        let name = match &*self.0 {
            ask::Error::Data(_) => "DataError",
            error if error.is_of_input() => "ModelError",
            _ => "ComputationError",
        };
        exception(py, name, &self.0).unwrap_or_else(|e| e)
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

fn exception(py: Python, name: &str, error: &ask::Error) -> PyResult<PyErr> {
    let module = py.import("fem._errors")?;
    let problem = |file: Option<&str>, place: Option<(usize, usize)>, problem: &Problem| {
        let (line, column) = place.unzip();
        module.getattr("Problem")?.call1((file, line, column, &problem.message, &problem.help))
    };
    let problems: Vec<Bound<PyAny>> = match error {
        ask::Error::Input(InputError { source, problems, .. })
        | ask::Error::Data(InputError { source, problems, .. }) => {
            let place = |p: &Problem| p.span.as_ref().map(|span| source.line_column(span.start));
            problems.iter().map(|p| problem(Some(&source.name), place(p), p)).collect::<PyResult<_>>()?
        }
        other => vec![problem(None, None, &other.problem())?],
    };
    let exception = module.getattr(name)?.call1((error.text(Marks::Plain), PyList::new(py, problems)?))?;
    Ok(PyErr::from_value(exception))
}
