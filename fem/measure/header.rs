//! The header row: which column is what, in which unit.

use super::{Purpose, Vocabulary};
use crate::input::{Problem, nearest};
use crate::process::{Absent, Holds};
use crate::units::{Kind, Unit, UnitError};

/// What a column is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Column {
    /// A coordinate, by its position, with its unit where it has one.
    Coordinate(usize, Option<Unit>),
    /// The observable, by its position.
    Observed(usize, Unit),
    /// Its standard uncertainty.
    Uncertainty(Unit),
    /// Kept, but not used.
    Unknown,
}

/// The columns of a file.
#[derive(Debug, Default)]
pub struct Header {
    pub columns: Vec<Column>,
    pub observable: usize,
    /// Unit of the observable, as written.
    pub unit: String,
    pub notes: Vec<String>,
}

/// `name [unit]` in two parts.
fn split(cell: &str) -> (&str, &str) {
    match cell.trim().split_once('[') {
        Some((name, unit)) => (name.trim(), unit.trim().trim_end_matches(']').trim()),
        None => (cell.trim(), ""),
    }
}

/// Reads the header cells; problems carry no place, for they all stand in the same line.
pub fn read(cells: &[String], vocabulary: Vocabulary, purpose: Purpose) -> Result<Header, Vec<Problem>> {
    let mut header = Header::default();
    let mut problems = Vec::new();
    let mut observed = None;
    let (mut unknown, mut wrong): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
    for (i, cell) in cells.iter().enumerate() {
        let (name, unit) = split(cell);
        if cells[..i].iter().any(|other| split(other).0 == name) {
            problems.push(Problem::new(format!("the column `{name}` stands twice")).help("keep one of them"));
        }
        match column(name, unit, vocabulary) {
            Ok(column) => {
                if let Column::Observed(position, _) = column {
                    if observed.replace(position).is_some() {
                        let problem = Problem::new("two columns hold the same observable");
                        problems.push(problem.help("keep either of them"));
                    }
                    header.unit = unit.to_string();
                }
                if column == Column::Unknown {
                    unknown.push(name);
                    header.notes.push(note(name, vocabulary));
                }
                header.columns.push(column);
            }
            Err(problem) => {
                wrong.push(name);
                problems.push(problem);
            }
        }
    }
    // A column that is wrong has been told of already, and is not missing.
    let absent = missing(&header, observed, &unknown, vocabulary);
    let observable_told = vocabulary.observables.iter().any(|o| wrong.contains(&o.name));
    let not_asked = observable_told || purpose == Purpose::Design;
    let told = |name: &str| wrong.contains(&name) || (name.is_empty() && not_asked);
    problems.extend(absent.into_iter().filter(|(name, _)| !told(name)).map(|(_, problem)| problem));
    header.observable = observed.unwrap_or(0);
    if let Some(kind) = vocabulary.observables.get(header.observable).map(|o| o.kind) {
        check_uncertainty(&header, kind, &mut problems);
    }
    if problems.is_empty() { Ok(header) } else { Err(problems) }
}

fn column(name: &str, unit: &str, vocabulary: Vocabulary) -> Result<Column, Problem> {
    let of_kind = |kind: Kind| kind.unit_of(unit).map_err(|e| unfit(name, &kind, e));
    if let Some(i) = vocabulary.coordinates.iter().position(|c| c.name == name) {
        return match vocabulary.coordinates[i].holds {
            Holds::Quantity(kind) => Ok(Column::Coordinate(i, Some(of_kind(kind)?))),
            _ if unit.is_empty() => Ok(Column::Coordinate(i, None)),
            _ => Err(Problem::new(format!("`{name}` is a label and has no unit")).help(format!("write {name} alone"))),
        };
    }
    if let Some(i) = vocabulary.observables.iter().position(|o| o.name == name) {
        return Ok(Column::Observed(i, of_kind(vocabulary.observables[i].kind)?));
    }
    if name == "u" {
        let unit = Unit::parse(unit).map_err(|e| Problem::new(format!("`u`: {}", e.message)))?;
        return Ok(Column::Uncertainty(unit));
    }
    Ok(Column::Unknown)
}

fn unfit(name: &str, kind: &Kind, error: UnitError) -> Problem {
    Problem::new(format!("`{name}`: {}", error.message)).help(format!("write {name} [{}]", kind.unit))
}

fn note(name: &str, vocabulary: Vocabulary) -> String {
    let names = vocabulary.coordinates.iter().map(|c| c.name).chain(vocabulary.observables.iter().map(|o| o.name));
    match nearest(name, names) {
        Some(near) => format!("the column `{name}` is not used; did you mean `{near}`?"),
        None => format!("the column `{name}` is not used"),
    }
}

/// What must be there and is not, by name; `unknown` are the columns of which one may be it, misspelt.
fn missing(
    header: &Header,
    observed: Option<usize>,
    unknown: &[&str],
    vocabulary: Vocabulary,
) -> Vec<(&'static str, Problem)> {
    let meant = |name: &str| {
        let same = |other: &&&str| nearest(&other.to_lowercase(), [name]).is_some();
        unknown.iter().find(same).map_or(String::new(), |other| format!("is `{other}` meant? "))
    };
    let mut problems = Vec::new();
    if observed.is_none() {
        let names: Vec<String> =
            vocabulary.observables.iter().map(|o| format!("{} [{}]", o.name, o.kind.unit)).collect();
        let problem = Problem::new("no column holds what was observed");
        let near: String =
            vocabulary.observables.iter().map(|o| meant(o.name)).find(|m| !m.is_empty()).unwrap_or_default();
        problems.push(("", problem.help(format!("{near}add a column {}", names.join(" or ")))));
    }
    for (i, coordinate) in vocabulary.coordinates.iter().enumerate() {
        let given = header.columns.iter().any(|c| matches!(c, Column::Coordinate(j, _) if *j == i));
        if coordinate.absent == Absent::Refused && !given {
            let unit = match coordinate.holds {
                Holds::Quantity(kind) => format!(" [{}]", kind.unit),
                _ => String::new(),
            };
            let problem = Problem::new(format!("the column `{}` is missing: {}", coordinate.name, coordinate.about));
            let help = format!("{}add a column {}{unit}", meant(coordinate.name), coordinate.name);
            problems.push((coordinate.name, problem.help(help)));
        }
    }
    problems
}

fn check_uncertainty(header: &Header, kind: Kind, problems: &mut Vec<Problem>) {
    for column in &header.columns {
        if let Column::Uncertainty(unit) = column
            && unit.dimension != kind.canonical().dimension
        {
            problems.push(
                Problem::new(format!("the unit of `u` is not one of {}", kind.bare_name()))
                    .help(format!("write u [{}]", kind.unit)),
            );
        }
    }
}
