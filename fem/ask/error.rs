//! Why a question has no answer.

use std::fmt;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, MietteError, MietteSpanContents, SourceCode,
    SourceSpan, SpanContents,
};

use crate::input::{Excerpt, InputError, Problem, visible};
use crate::model::Model;
use crate::output::OutputError;
use crate::output::study::StudyError;
use crate::process::Failure;

/// Why a question has no answer.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// A model, a plan or a budget is wrong.
    Input(InputError),
    /// The measurements are wrong.
    Data(InputError),
    /// Something impossible is asked.
    Request(Problem),
    /// The computation gave no answer.
    Compute(Failure),
    /// A result cannot be written.
    Output(OutputError),
}

/// The marks with which an error is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marks {
    /// ASCII alone.
    Ascii,
    /// Unicode without colours.
    Plain,
    /// Unicode in colours.
    Coloured,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) | Self::Data(error) => error.fmt(f),
            other => {
                let Problem { message, help, .. } = other.problem();
                f.write_str(&message)?;
                help.map_or(Ok(()), |help| write!(f, " ({help})"))
            }
        }
    }
}

impl std::error::Error for Error {}

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
    /// An error in measurements held against a model: of the model's file where that is named, else of the data.
    pub fn of_data(error: InputError, model: &Model) -> Self {
        if error.source.name == model.source.name { Self::Input(error) } else { Self::Data(error) }
    }

    /// Whether whoever asked can mend it: what was given is wrong, and not the computation or the writing.
    pub fn is_of_input(&self) -> bool {
        match self {
            Self::Input(_) | Self::Data(_) | Self::Request(_) => true,
            Self::Output(OutputError::File { .. } | OutputError::Shape { .. }) | Self::Compute(_) => false,
            Self::Output(_) => true,
        }
    }

    /// The error as people read it, with its remedy.
    #[doc(hidden)]
    pub fn text(&self, marks: Marks) -> String {
        if let Self::Input(error) | Self::Data(error) = self {
            return rendered(error, marks).trim_end().to_string();
        }
        let Problem { message, help, .. } = self.problem();
        let told = match help {
            Some(help) => format!("error: {message}\n  help: {help}"),
            None => format!("error: {message}"),
        };
        visible(&told).into_owned()
    }

    /// The error as one problem without its place; that of a file stands for all of them.
    pub fn problem(&self) -> Problem {
        match self {
            Self::Input(error) | Self::Data(error) => {
                error.problems.first().cloned().unwrap_or_else(|| Problem::new(""))
            }
            Self::Request(problem) => problem.clone(),
            Self::Compute(failure) => Problem::new(&failure.message).help(&failure.help),
            Self::Output(error) => Problem::new(error.to_string()).help(match error {
                OutputError::Read { .. } => "name another file; models and measurements are never overwritten",
                OutputError::Exists { .. } | OutputError::NotOwn { .. } => {
                    "name another place, or let it be replaced with --force"
                }
                OutputError::Special { .. } => "name another place",
                OutputError::Busy { .. } => "wait until that one has ended, and ask again",
                OutputError::Link { .. } => {
                    "it may have come with the files of others; if it is yours, name the folder that it leads to"
                }
                OutputError::File { .. } | OutputError::Shape { .. } => "choose another place with -o, or make room",
            }),
        }
    }
}

/// Renders every problem with its line and a mark under the text in question.
fn rendered(error: &InputError, marks: Marks) -> String {
    let theme = match marks {
        Marks::Ascii => GraphicalTheme::none(),
        Marks::Plain => GraphicalTheme::unicode_nocolor(),
        Marks::Coloured => GraphicalTheme::unicode(),
    };
    let handler = GraphicalReportHandler::new_themed(theme);
    let mut text = String::new();
    for problem in &error.problems {
        let excerpt = problem.span.as_ref().map(|span| Excerpt::new(&error.source, span));
        let place = excerpt.as_ref().map_or(String::new(), |excerpt| {
            let (line, column) = excerpt.line_column;
            format!(":{line}:{column}")
        });
        let message = format!("{}{place}: {}", error.source.name, problem.message);
        let mut diagnostic = MietteDiagnostic::new(visible(&message));
        diagnostic.help = problem.help.as_deref().map(|help| visible(help).into_owned());
        if let Some(excerpt) = &excerpt {
            diagnostic = diagnostic.with_label(LabeledSpan::underline(excerpt.place.clone()));
        }
        let report = miette::Report::new(diagnostic);
        let report = match excerpt {
            Some(excerpt) => report.with_source_code(Shown { name: visible(&error.source.name).into(), excerpt }),
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
        text.push_str(&format!("\n{} problems in {}{told}\n", error.found, visible(&error.source.name)));
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
