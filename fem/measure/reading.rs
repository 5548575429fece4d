//! Options by which a user explains a file: the meaning of its columns, and the decimal mark.

use super::decimal::Decimal;
use super::heading::{Heading, parts, plain};
use super::moment::Moment;
use super::vocabulary::Vocabulary;
use crate::input::{Problem, did_you_mean};
use crate::units::plain_unit;

/// How a file is to be read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// The decimal mark, where it was said.
    pub decimal: Option<Decimal>,
    /// The line in which the headings stand, from 1, where it was said, or that there are none.
    pub headings: Option<Option<usize>>,
    /// Whether readings are taken as they are typed, be they as far off as a slip of the pen, or copies of others above them.
    pub as_typed: bool,
    /// The sheet of a workbook, where it was said.
    pub sheet: Option<String>,
    /// Headings of the file, and what each is to be.
    columns: Vec<(String, String)>,
    /// What a model keeps of its files, for where a file says nothing itself and nobody has said more.
    pub(super) kept: Option<Box<Reading>>,
    /// Whether it is for several files, of which each may lack some of these headings.
    pub(super) is_of_several: bool,
}

impl Reading {
    /// Makes a reading of lists such as `T1=temperature@x=12 mm,Zeit=time [s]`.
    ///
    /// # Errors
    /// An entry says nothing of a column.
    pub fn new(lists: &[String], decimal: Option<Decimal>) -> Result<Self, Problem> {
        let mut columns: Vec<(String, String)> = Vec::new();
        for list in lists {
            let mut head = String::new();
            for part in list.split(',') {
                // A heading may hold a comma itself.
                head = if head.is_empty() { part.to_string() } else { format!("{head},{part}") };
                if let Some((from, to)) = head.split_once('=').filter(|(from, _)| !from.trim().is_empty()) {
                    columns.push((from.trim().to_string(), to.trim().to_string()));
                    head.clear();
                }
            }
            if !head.trim().is_empty() || columns.last().is_some_and(|(_, to)| to.is_empty()) {
                let problem = Problem::new(format!("--columns {list}: a column is to be nothing"));
                return Err(problem.help("write --columns 'HEADING=NAME [UNIT],HEADING=NAME', and - to leave one out"));
            }
        }
        Self::of_columns(columns, decimal)
    }

    /// Makes a reading of headings, and what each is to be.
    ///
    /// # Errors
    /// A heading is said to be two things.
    pub fn of_columns(columns: Vec<(String, String)>, decimal: Option<Decimal>) -> Result<Self, Problem> {
        let is_twice = |(i, (from, _)): (usize, &(String, String))| columns[..i].iter().any(|(other, _)| other == from);
        if let Some((_, (from, _))) = columns.iter().enumerate().find(|(i, entry)| is_twice((*i, *entry))) {
            let problem = Problem::new(format!("--columns: `{from}` is said to be two things"));
            return Err(problem.help("keep one of them"));
        }
        Ok(Self { decimal, columns, ..Self::default() })
    }

    /// The same with the line in which the headings stand, or that there are none, and the sheet of a workbook.
    #[must_use]
    pub fn within(self, headings: Option<Option<usize>>, sheet: Option<String>) -> Self {
        Self { headings, sheet, ..self }
    }

    /// The same, with readings as they are typed or without slips of the pen.
    #[must_use]
    pub fn as_typed(self, as_typed: bool) -> Self {
        Self { as_typed, ..self }
    }

    /// The same with what a model keeps of its files.
    #[must_use]
    pub fn over(self, kept: &Self) -> Self {
        let kept = (!kept.says_nothing()).then(|| Box::new(kept.clone()));
        Self { kept: kept.or(self.kept), ..self }
    }

    /// Headings and what each is to be, those that are kept behind those that were said.
    fn all_columns(&self) -> Vec<(String, String)> {
        let kept = self.kept.iter().flat_map(|kept| kept.all_columns());
        let is_new = |(from, _): &(String, String)| self.columns.iter().all(|(own, _)| own != from);
        self.columns.iter().cloned().chain(kept.filter(is_new)).collect()
    }

    /// The same with what is kept where nothing else was said.
    pub fn with_kept(&self) -> Self {
        let kept = self.kept.as_deref();
        Self {
            decimal: self.decimal.or(kept.and_then(|own| own.decimal)),
            headings: self.headings.or(kept.and_then(|own| own.headings)),
            sheet: self.sheet.clone().or(kept.and_then(|own| own.sheet.clone())),
            as_typed: self.as_typed,
            columns: self.all_columns(),
            kept: None,
            is_of_several: self.is_of_several,
        }
    }

    /// Whether nothing is said.
    pub fn says_nothing(&self) -> bool {
        !self.as_typed
            && self.decimal.is_none()
            && self.headings.is_none()
            && self.sheet.is_none()
            && self.columns.is_empty()
    }

    /// The same with the line of headings that a model keeps as if somebody had said it now; `None` where somebody said one.
    pub(super) fn kept_as_said(&self) -> Option<Self> {
        self.kept
            .as_ref()
            .filter(|_| self.headings.is_none())
            .map(|kept| Self { headings: kept.headings, ..self.clone() })
    }

    /// The same for one of several files, which may lack some of the headings, or for a single one.
    pub(super) fn of_several(&self, is_of_several: bool) -> Self {
        Self { is_of_several, ..self.clone() }
    }

    /// The options by which all of it is said.
    pub fn options(&self) -> Vec<String> {
        let columns = self.columns.iter().map(|(from, to)| format!("{from}={to}")).collect::<Vec<_>>().join(",");
        let decimal = self.decimal.map(|mark| match mark {
            Decimal::Comma => "comma",
            Decimal::Point => "point",
        });
        let columns = (!columns.is_empty()).then(|| ["--columns".to_string(), columns]);
        let decimal = decimal.map(|mark| ["--decimal".to_string(), mark.to_string()]);
        let header = self.headings.map(|line| ["--header".to_string(), line.unwrap_or(0).to_string()]);
        let sheet = self.sheet.as_ref().map(|name| ["--sheet".to_string(), name.clone()]);
        let as_typed = self.as_typed.then(|| "--as-typed".to_string());
        [columns, decimal, header, sheet].into_iter().flatten().flatten().chain(as_typed).collect()
    }

    /// Headings of the file, and what each is to be.
    pub fn columns(&self) -> &[(String, String)] {
        &self.columns
    }

    /// Headings of which something is said.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|(from, _)| &**from)
    }

    /// The user's heading for one of the file's, if one was given.
    pub(super) fn of(&self, cell: &str) -> Option<&str> {
        let own = self.columns.iter().find(|(from, _)| is_meant(from, cell)).map(|(_, to)| &**to);
        own.or_else(|| self.kept.as_ref()?.of(cell))
    }
}

/// Whether an entry names a heading: the whole of it, or without its unit.
pub(super) fn is_meant(from: &str, cell: &str) -> bool {
    let name = parts(cell, |_| false).0;
    from == cell.trim() || from == name || plain(from) == plain(name)
}

/// The heading that a column is said to have; `None` where it is to be left out.
///
/// # Errors
/// The process knows no such column, or the file says another unit.
pub(super) fn said(cell: &str, to: &str, vocabulary: Vocabulary) -> Result<Option<Heading>, Problem> {
    if to == "-" {
        return Ok(None);
    }
    let wrong = |problem: Problem| Problem { message: format!("--columns: {}", problem.message), ..problem };
    let (to, since) = match to.split_once(" since ") {
        Some((to, since)) => (to, Some(since.trim())),
        None => (to, None),
    };
    let mut heading = Heading::read(to, vocabulary, &[]).map_err(wrong)?;
    if !heading.is_known {
        let names: Vec<String> = vocabulary.names().collect();
        let near = did_you_mean(&heading.name, names.iter().map(String::as_str), '`');
        let problem = Problem::new(format!("`{}` is no column of {}", heading.name, vocabulary.process));
        return Err(wrong(problem.help(format!("{near}`fem effects {}` lists them", vocabulary.process))));
    }
    heading.since = match since.map(|text| (text, Moment::parse(text))) {
        Some((text, Some(moment))) => Some((text.to_string(), moment)),
        Some((text, None)) => {
            let problem = Problem::new(format!("`{text}` is no moment"));
            return Err(wrong(problem.help("write it as 2026-03-01T10:00:00")));
        }
        None => None,
    };
    let unit = plain_unit(parts(cell, |_| false).1);
    if heading.unit.is_empty() {
        heading.unit = unit;
    } else if !unit.is_empty() && unit != heading.unit {
        let problem = Problem::new(format!("`{cell}` is said to be in {}, and the file says {unit}", heading.unit));
        return Err(wrong(problem.help("leave the unit to one of them")));
    }
    heading.written = cell.trim().to_string();
    Ok(Some(heading))
}
