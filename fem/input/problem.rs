//! Problems of an input: the mistake, its place, and the remedy.

use std::fmt;
use std::ops::Range;

use super::Source;
use super::excerpt::shortened;

/// Most problems of an input that are told: who has mended these knows more.
const MOST: usize = 20;
/// Most bytes of a word that may be a slip of the pen: comparing costs the square of them.
const LONGEST_WORD: usize = 80;
/// Most characters of a message and of a remedy, which may repeat what is written.
const LONGEST: usize = 400;
const LONGEST_HELP: usize = 1200;

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Problem {
    /// The finding, in one sentence.
    pub message: String,
    /// The remedy.
    pub help: Option<String>,
    /// Bytes of the source that it is about.
    pub span: Option<Range<usize>>,
}

impl Problem {
    /// A problem without place or remedy yet.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: shortened(&message.into(), LONGEST).into_owned(), help: None, span: None }
    }

    /// The problem with its place in the source.
    #[must_use]
    pub fn at(mut self, span: Option<Range<usize>>) -> Self {
        self.span = span;
        self
    }

    /// The problem with its remedy.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(shortened(&help.into(), LONGEST_HELP).into_owned());
        self
    }
}

/// Everything that is wrong with one input, found in one reading.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct InputError {
    /// The source that was read.
    pub source: Source,
    /// The problems in the order of their places: the first ones.
    pub problems: Vec<Problem>,
    /// Number of problems that were found.
    pub found: usize,
}

impl InputError {
    /// Sorted by place, so that a reader can walk down the file.
    pub fn new(source: Source, mut problems: Vec<Problem>) -> Self {
        problems.sort_by_key(|p| p.span.as_ref().map_or(0, |s| s.start));
        let found = problems.len();
        problems.truncate(MOST);
        Self { source, problems, found }
    }

    /// One problem of a source.
    pub fn one(source: Source, problem: Problem) -> Self {
        Self::new(source, vec![problem])
    }
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.problems.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "{}", self.source.name)?;
            if let Some(span) = &problem.span {
                let (line, column) = self.source.line_column(span.start);
                write!(f, ":{line}:{column}")?;
            }
            write!(f, ": {}", problem.message)?;
            if let Some(help) = &problem.help {
                write!(f, " ({help})")?;
            }
        }
        match self.found - self.problems.len() {
            0 => Ok(()),
            more => write!(f, "\nand {more} more"),
        }
    }
}

impl std::error::Error for InputError {}

/// "did you mean …? ", to stand before a list of what is known; empty where nothing is near.
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>, quote: char) -> String {
    nearest(word, candidates).map_or(String::new(), |near| format!("did you mean {quote}{near}{quote}? "))
}

/// The candidate that `word` most likely means, if one is near enough.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > LONGEST_WORD {
        return None;
    }
    let near = |c: &str| strsim::normalized_damerau_levenshtein(&word.to_lowercase(), c);
    candidates
        .into_iter()
        .map(|candidate| (near(candidate), candidate))
        .filter(|(likeness, _)| *likeness >= 0.5)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}
