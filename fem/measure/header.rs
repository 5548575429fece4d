//! Reads the header row: the meaning and the unit of every column.

use super::vocabulary::{MeasuredObservable, Purpose, Vocabulary};
use crate::input::{Problem, name_and_unit, nearest};
use crate::process::{Absent, Holds};
use crate::units::{Kind, TIME, Unit, UnitError};

/// Meaning of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Column {
    /// A coordinate, by its position, with its unit where it has one.
    Coordinate(usize, Option<Unit>),
    /// An observable, by its position.
    Observed(usize, Unit),
    /// The standard uncertainty of the observable with this position, or of the only one where none is
    /// named.
    Uncertainty(Option<usize>, Unit),
    /// A column that the process does not know.
    Unknown,
}

/// The columns of a file.
#[derive(Debug, Default)]
pub struct Header {
    pub columns: Vec<Column>,
    /// The observables, in the order of their columns; a design may have none.
    pub observables: Vec<MeasuredObservable>,
    pub notes: Vec<String>,
}

/// Reads the header cells. Problems carry no place, for they all stand in the same line.
pub fn read(cells: &[String], vocabulary: Vocabulary, purpose: Purpose) -> Result<Header, Vec<Problem>> {
    let mut header = Header::default();
    let mut problems = Vec::new();
    let (mut unknown, mut wrong): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
    for (i, cell) in cells.iter().enumerate() {
        let (name, unit) = name_and_unit(cell);
        if cells[..i].iter().any(|other| name_and_unit(other).0 == name) {
            problems.push(Problem::new(format!("the column `{name}` stands twice")).help("keep one of them"));
        }
        match column(name, unit, vocabulary) {
            Ok(column) => {
                if let Column::Observed(position, _) = column {
                    let observable = &vocabulary.observables[position];
                    let dimension = |position: usize| vocabulary.observables[position].kind.canonical().dimension;
                    if header.observables.iter().any(|s| dimension(s.position) == dimension(position)) {
                        let problem = Problem::new("two columns hold the same observable");
                        problems.push(problem.help("keep either of them"));
                    }
                    header.observables.push(MeasuredObservable::new(position, observable, unit));
                }
                if column == Column::Unknown {
                    unknown.push(name);
                    header.notes.extend(note(name, vocabulary));
                }
                header.columns.push(column);
            }
            Err(problem) => {
                wrong.push(name);
                problems.push(problem);
            }
        }
    }
    // A column that is wrong has been reported already, and is not missing.
    let absent = missing(&header, &unknown, vocabulary);
    let observable_told = vocabulary.observables.iter().any(|o| wrong.contains(&&*o.name));
    let not_asked = observable_told || purpose == Purpose::Design;
    let told = |name: &str| wrong.contains(&name) || (name.is_empty() && not_asked);
    problems.extend(absent.into_iter().filter(|(name, _)| !told(name)).map(|(_, problem)| problem));
    check_uncertainty(&mut header, vocabulary, &mut problems);
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
    let of = |name: &str| vocabulary.observables.iter().position(|o| o.name == name);
    let named = name.strip_prefix("u_").and_then(of);
    if name == "u" || named.is_some() {
        let unit = Unit::parse(unit).map_err(|e| Problem::new(format!("`{name}`: {}", e.message)))?;
        return Ok(Column::Uncertainty(named, unit));
    }
    Ok(Column::Unknown)
}

fn unfit(name: &str, kind: &Kind, error: UnitError) -> Problem {
    let is_time = kind.canonical().dimension == TIME.canonical().dimension;
    let or = if is_time { ", or dates with times, 2026-03-01T10:00:00, in its cells" } else { "" };
    Problem::new(format!("`{name}`: {}", error.message)).help(format!("write {name} [{}]{or}", kind.unit))
}

fn note(name: &str, vocabulary: Vocabulary) -> Option<String> {
    let names = vocabulary.coordinates.iter().map(|c| &*c.name).chain(vocabulary.observables.iter().map(|o| &*o.name));
    let near = nearest(name, names)?;
    Some(format!("the column `{name}` is none of the process's; did you mean `{near}`?"))
}

/// Lists the columns that must be there and are not, by name; one of the `unknown` columns may be it,
/// misspelt.
fn missing<'p>(header: &Header, unknown: &[&str], vocabulary: Vocabulary<'p>) -> Vec<(&'p str, Problem)> {
    let meant = |name: &str| {
        let same = |other: &&&str| nearest(&other.to_lowercase(), [name]).is_some();
        unknown.iter().find(same).map_or(String::new(), |other| format!("is `{other}` meant? "))
    };
    let mut problems = Vec::new();
    if header.observables.is_empty() {
        let names: Vec<String> =
            vocabulary.observables.iter().map(|o| format!("{} [{}]", o.name, o.kind.unit)).collect();
        let problem = Problem::new("no column holds what was observed");
        let near: String =
            vocabulary.observables.iter().map(|o| meant(&o.name)).find(|m| !m.is_empty()).unwrap_or_default();
        let help = format!("{near}add a column {}, or {}", names.join(" or "), said(&names[0], vocabulary));
        problems.push(("", problem.help(help)));
    }
    for (i, coordinate) in vocabulary.coordinates.iter().enumerate() {
        let given = header.columns.iter().any(|c| matches!(c, Column::Coordinate(j, _) if *j == i));
        let needed = match coordinate.absent {
            Absent::Refused => true,
            Absent::NeededBy(observable) => header.observables.iter().any(|s| s.position == observable),
            Absent::Value(_) | Absent::Model | Absent::ModelOf(_) => false,
        };
        if needed && !given {
            let unit = match coordinate.holds {
                Holds::Quantity(kind) => format!(" [{}]", kind.unit),
                _ => String::new(),
            };
            let problem = Problem::new(format!("the column `{}` is missing: {}", coordinate.name, coordinate.about));
            let name = format!("{}{unit}", coordinate.name);
            let said = said(&name, vocabulary);
            let help = format!("{}add a column {name}, or {said}", meant(&coordinate.name));
            problems.push((&coordinate.name, problem.help(help)));
        }
    }
    problems
}

/// How a column of another name is said to be this one, and where the names stand.
fn said(name: &str, vocabulary: Vocabulary) -> String {
    format!("say which one it is: --columns 'HEADING={name}'; `fem effects {}` lists all names", vocabulary.process)
}

/// Checks that every column of uncertainties belongs to an observable of the file, has its dimension, and
/// leaves no other observable without one.
fn check_uncertainty(header: &mut Header, vocabulary: Vocabulary, problems: &mut Vec<Problem>) {
    let seen: Vec<(usize, Kind)> = match &header.observables[..] {
        [] => vec![(0, vocabulary.observables[0].kind)],
        seen => seen.iter().map(|s| (s.position, s.kind)).collect(),
    };
    let name = |position: usize| &*vocabulary.observables[position].name;
    let mut given = Vec::new();
    for column in &mut header.columns {
        let Column::Uncertainty(of, unit) = column else { continue };
        let Some(&(position, kind)) = (match (*of, &seen[..]) {
            (None, [one]) => Some(one),
            (None, _) => {
                let names: Vec<String> = seen.iter().map(|s| format!("u_{} [{}]", name(s.0), s.1.unit)).collect();
                let problem = Problem::new("`u` does not say of which observable it is the uncertainty");
                problems.push(problem.help(format!("write {}", names.join(" and "))));
                return;
            }
            (Some(position), _) => seen.iter().find(|s| s.0 == position),
        }) else {
            let of = of.map_or("", name);
            let problem = Problem::new(format!("`u_{of}` is there, but no column `{of}`"));
            problems.push(problem.help("leave it out, or add the column"));
            continue;
        };
        *of = Some(position);
        given.push(position);
        if unit.dimension != kind.canonical().dimension {
            let problem = Problem::new(format!("the unit of `u` is not one of {}", kind.bare_name()));
            problems.push(problem.help(format!("write u [{}]", kind.unit)));
        }
    }
    if let (false, Some(without)) = (given.is_empty(), seen.iter().find(|s| !given.contains(&s.0))) {
        let problem = Problem::new(format!("`{}` has no uncertainty where the others have one", name(without.0)));
        problems.push(problem.help(format!(
            "add a column u_{} [{}], or leave all of them out",
            name(without.0),
            without.1.unit
        )));
    }
}
