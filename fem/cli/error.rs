//! Errors of commands, and their report.

use std::process::ExitCode;

use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource};

use super::look;
use super::say::say;
use crate::input::{InputError, Problem};
use crate::output::OutputError;
use crate::process::Failure;

/// Reason for which a command failed.
#[derive(Debug)]
pub enum Error {
    /// A file is wrong.
    Input(InputError),
    /// The command line asks for something impossible.
    Request(Problem),
    /// The computation gave no answer.
    Compute(Failure),
    /// A result cannot be written.
    Output(OutputError),
    /// Stdout cannot be written.
    Stdout(std::io::Error),
    /// A check failed; the result has been printed.
    Found,
}

impl From<InputError> for Error {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl From<Failure> for Error {
    fn from(error: Failure) -> Self {
        Self::Compute(error)
    }
}

impl From<OutputError> for Error {
    fn from(error: OutputError) -> Self {
        Self::Output(error)
    }
}

impl From<Problem> for Error {
    fn from(problem: Problem) -> Self {
        Self::Request(problem)
    }
}

impl Error {
    /// Reports the error on stderr and returns the exit status: 2 where the input is wrong, 1 where the
    /// computation or the writing failed.
    pub fn report(self) -> ExitCode {
        match self {
            Self::Input(error) => {
                say!("{}", rendered(&error, look::has_colour()).trim_end());
                ExitCode::from(2)
            }
            Self::Request(problem) => {
                tell(&problem.message, problem.help.as_deref());
                ExitCode::from(2)
            }
            Self::Compute(failure) => {
                tell(&failure.message, Some(&failure.help));
                ExitCode::from(1)
            }
            Self::Output(error @ OutputError::Read { .. }) => {
                tell(&error.to_string(), Some("name another file; models and measurements are never overwritten"));
                ExitCode::from(2)
            }
            Self::Output(error) => {
                tell(&error.to_string(), Some("choose another place with -o, or make room"));
                ExitCode::from(1)
            }
            Self::Stdout(error) => {
                tell(&format!("the output cannot be written: {error}"), None);
                ExitCode::from(1)
            }
            Self::Found => ExitCode::from(1),
        }
    }
}

fn tell(message: &str, help: Option<&str>) {
    say!("error: {message}");
    if let Some(help) = help {
        say!("  help: {help}");
    }
}

/// Renders every problem with its line and a mark under the text in question.
pub fn rendered(error: &InputError, has_colour: bool) -> String {
    let theme = match (look::is_ascii(), has_colour) {
        (true, _) => GraphicalTheme::none(),
        (false, true) => GraphicalTheme::unicode(),
        (false, false) => GraphicalTheme::unicode_nocolor(),
    };
    let handler = GraphicalReportHandler::new_themed(theme);
    let mut text = String::new();
    for problem in &error.problems {
        let place = problem.span.as_ref().map_or(String::new(), |span| {
            let (line, column) = error.source.line_column(span.start);
            format!(":{line}:{column}")
        });
        let mut diagnostic = MietteDiagnostic::new(format!("{}{place}: {}", error.source.name, problem.message));
        diagnostic.help = problem.help.clone();
        if let Some(span) = &problem.span {
            diagnostic = diagnostic.with_label(LabeledSpan::underline(span.clone()));
        }
        let source = NamedSource::new(&*error.source.name, error.source.text.to_string());
        let report = miette::Report::new(diagnostic).with_source_code(source);
        if !text.is_empty() {
            text.push('\n');
        }
        // Writing to a String does not fail.
        let _ = handler.render_report(&mut text, report.as_ref());
    }
    if error.problems.len() > 1 {
        text.push_str(&format!("\n{} problems in {}\n", error.problems.len(), error.source.name));
    }
    text
}
