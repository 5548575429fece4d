//! Why something cannot be done, for the page.

use serde_json::{Value as Json, json};

use crate::ask::Error;
use crate::input::{InputError, Problem};
use crate::output::OutputError;
use crate::process::Failure;

/// A refusal, with what to do instead.
#[derive(Clone, Debug)]
pub struct Refusal {
    problem: String,
    help: Option<String>,
    /// The field of the page that it is about, by the path of its value.
    path: Option<String>,
    /// The file that it is about, by its name.
    file: Option<String>,
}

impl Refusal {
    /// That of a problem.
    pub fn new(problem: impl Into<String>, help: impl Into<String>) -> Self {
        Self { problem: problem.into(), help: Some(help.into()), path: None, file: None }
    }

    /// It belongs to a field.
    #[must_use]
    pub fn at(mut self, path: &str) -> Self {
        self.path = Some(path.to_string());
        self
    }

    /// It is about a file.
    #[must_use]
    pub fn of(mut self, file: &str) -> Self {
        self.file = Some(file.to_string());
        self
    }

    /// For the page.
    pub fn json(&self) -> Json {
        json!({ "problem": self.problem, "help": self.help, "path": self.path, "file": self.file })
    }

    /// In one sentence.
    pub fn text(&self) -> String {
        match &self.help {
            Some(help) => format!("{}: {help}", self.problem),
            None => self.problem.clone(),
        }
    }
}

impl From<Problem> for Refusal {
    fn from(problem: Problem) -> Self {
        Self { problem: problem.message, help: problem.help, path: None, file: None }
    }
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        match &error {
            Error::Input(all) | Error::Data(all) => {
                let file = std::path::Path::new(&*all.source.name).file_name();
                let file = file.map(|name| name.to_string_lossy().into_owned());
                Self { problem: all.to_string(), help: None, path: None, file }
            }
            _ => error.problem().into(),
        }
    }
}

impl From<InputError> for Refusal {
    fn from(error: InputError) -> Self {
        Error::from(error).into()
    }
}

impl From<Failure> for Refusal {
    fn from(error: Failure) -> Self {
        Error::from(error).into()
    }
}

impl From<OutputError> for Refusal {
    fn from(error: OutputError) -> Self {
        Error::from(error).into()
    }
}
