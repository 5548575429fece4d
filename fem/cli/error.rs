//! Errors of commands, and their report.

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, MietteError, MietteSpanContents, SourceCode,
    SourceSpan, SpanContents,
};

use super::look;
use super::say::say;
use crate::input::{Excerpt, InputError, Problem};
use crate::output::OutputError;
use crate::output::study::StudyError;
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

impl From<StudyError> for Error {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Refused(problem) => Self::Request(problem),
            StudyError::Output(error) => Self::Output(error),
        }
    }
}

impl From<Problem> for Error {
    fn from(problem: Problem) -> Self {
        Self::Request(problem)
    }
}

impl Error {
    /// Reports the error on stderr and returns the exit status.
    pub fn report(&self) -> u8 {
        let text = self.text(look::has_colour());
        if !text.is_empty() {
            say!("{text}");
        }
        self.status()
    }

    /// Exit status: 2 where the input is wrong, 1 where the computation or the writing failed.
    pub fn status(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Request(_) => 2,
            Self::Output(OutputError::File { .. } | OutputError::Shape { .. }) => 1,
            Self::Output(_) => 2,
            Self::Compute(_) | Self::Stdout(_) | Self::Found => 1,
        }
    }

    /// The error as people read it, with its remedy; empty where the result has told it.
    pub fn text(&self, has_colour: bool) -> String {
        if let Self::Input(error) = self {
            return rendered(error, has_colour).trim_end().to_string();
        }
        let Problem { message, help, .. } = self.problem();
        match help {
            _ if message.is_empty() => String::new(),
            Some(help) => format!("error: {message}\n  help: {help}"),
            None => format!("error: {message}"),
        }
    }

    /// The error as one problem without its place; that of a file stands for all of them.
    pub fn problem(&self) -> Problem {
        match self {
            Self::Input(error) => error.problems.first().cloned().unwrap_or_else(|| Problem::new("")),
            Self::Request(problem) => problem.clone(),
            Self::Compute(failure) => Problem::new(&failure.message).help(&failure.help),
            Self::Output(error) => Problem::new(error.to_string()).help(match error {
                OutputError::Read { .. } => "name another file; models and measurements are never overwritten",
                OutputError::Exists { .. } => "name another place, or let it be replaced with --force",
                OutputError::Special { .. } => "name another place",
                OutputError::Link { .. } => {
                    "it may have come with the files of others; if it is yours, name the folder that it leads to"
                }
                OutputError::File { .. } | OutputError::Shape { .. } => "choose another place with -o, or make room",
            }),
            Self::Stdout(error) => Problem::new(format!("the output cannot be written: {error}")),
            Self::Found => Problem::new(""),
        }
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
        let excerpt = problem.span.as_ref().map(|span| Excerpt::new(&error.source, span));
        let place = excerpt.as_ref().map_or(String::new(), |excerpt| {
            let (line, column) = excerpt.line_column;
            format!(":{line}:{column}")
        });
        let mut diagnostic = MietteDiagnostic::new(format!("{}{place}: {}", error.source.name, problem.message));
        diagnostic.help = problem.help.clone();
        if let Some(excerpt) = &excerpt {
            diagnostic = diagnostic.with_label(LabeledSpan::underline(excerpt.place.clone()));
        }
        let report = miette::Report::new(diagnostic);
        let report = match excerpt {
            Some(excerpt) => report.with_source_code(Shown { name: error.source.name.clone(), excerpt }),
            None => report,
        };
        if !text.is_empty() {
            text.push('\n');
        }
        // Writing to a String does not fail.
        let _ = handler.render_report(&mut text, report.as_ref());
    }
    if error.found > 1 {
        let told = if error.found > error.problems.len() {
            format!(", of which the first {} are told", error.problems.len())
        } else {
            String::new()
        };
        text.push_str(&format!("\n{} problems in {}{told}\n", error.found, error.source.name));
    }
    text
}

/// An excerpt under the name and the line numbers of its source.
struct Shown {
    name: std::sync::Arc<str>,
    excerpt: Excerpt,
}

impl SourceCode for Shown {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let Excerpt { text, first_line, line_column: (line, column), .. } = &self.excerpt;
        // The place alone is asked for where the head of the excerpt names it.
        let (line, column) = if lines_before + lines_after == 0 { (line - 1, column - 1) } else { (first_line - 1, 0) };
        let whole = SourceSpan::from(0..text.len());
        let span = if lines_before + lines_after == 0 { *span } else { whole };
        let data = text.as_bytes().get(span.offset()..span.offset() + span.len()).unwrap_or_default();
        let lines = text.lines().count();
        Ok(Box::new(MietteSpanContents::new_named(self.name.to_string(), data, span, line, column, lines)))
    }
}
