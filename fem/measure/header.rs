//! Reads the header row: the meaning and the unit of every column.

use super::vocabulary::{MeasuredObservable, Purpose, Vocabulary};
use crate::input::{Problem, name_and_unit, nearest};
use crate::process::{Absent, Coordinate, Holds};
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
                    let own = MeasuredObservable::new(position, &vocabulary.observables[position], unit);
                    if header
                        .observables
                        .iter()
                        .any(|s| s.position == position || s.observable.is_instead_of(&own.observable))
                    {
                        let problem = Problem::new("two columns hold the same observable");
                        problems.push(problem.help("keep either of them"));
                    }
                    header.observables.push(own);
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
    let observable_told = vocabulary.observables.iter().any(|o| wrong.contains(&&*o.name));
    let absent = Absence {
        observed: header.observables.is_empty() && !observable_told && purpose != Purpose::Design,
        coordinates: missing(&header, vocabulary).filter(|c| !wrong.contains(&&*c.name)).collect(),
    };
    problems.extend(absent.problem(&unknown, vocabulary));
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
    // Another unit behind the same numbers would make others of them.
    let help = match error.hint {
        Some(hint) if hint.ends_with('?') => {
            format!("{hint} Or give the numbers in {} and write {name} [{}]{or}", kind.unit, kind.unit)
        }
        Some(hint) => format!("{hint}; or give the numbers in {} and write {name} [{}]{or}", kind.unit, kind.unit),
        None => format!("write the unit that the numbers have; in {} it is {name} [{}]{or}", kind.unit, kind.unit),
    };
    Problem::new(format!("`{name}`: {}", error.message)).help(help)
}

fn note(name: &str, vocabulary: Vocabulary) -> Option<String> {
    let names = vocabulary.coordinates.iter().map(|c| &*c.name).chain(vocabulary.observables.iter().map(|o| &*o.name));
    let near = nearest(name, names)?;
    Some(format!("the column `{name}` is none of the process's; did you mean `{near}`?"))
}

/// What must be there, and is not.
struct Absence<'p> {
    /// No column of any observable.
    observed: bool,
    coordinates: Vec<&'p Coordinate>,
}

/// The coordinates that must be there, and are not.
fn missing<'p>(header: &Header, vocabulary: Vocabulary<'p>) -> impl Iterator<Item = &'p Coordinate> {
    let given = |i: usize| header.columns.iter().any(|c| matches!(c, Column::Coordinate(j, _) if *j == i));
    let needed = |coordinate: &Coordinate| match coordinate.absent {
        Absent::Refused => true,
        Absent::NeededBy(first, last) => header.observables.iter().any(|s| (first..=last).contains(&s.position)),
        Absent::NeededBut(observable) => {
            header.observables.is_empty() || header.observables.iter().any(|s| s.position != observable)
        }
        Absent::Value(_) | Absent::Model | Absent::ModelOf(..) => false,
    };
    let all = vocabulary.coordinates.iter().enumerate();
    all.filter(move |(i, coordinate)| needed(coordinate) && !given(*i)).map(|(_, coordinate)| coordinate)
}

impl Absence<'_> {
    /// All that is missing as one problem, for one remedy mends it; one of the `unknown` columns may be it, misspelt.
    fn problem(&self, unknown: &[&str], vocabulary: Vocabulary) -> Option<Problem> {
        let observed = observed(vocabulary);
        let names: Vec<String> = self.coordinates.iter().map(|c| column_of(c)).collect();
        let message = match (self.observed, &self.coordinates[..]) {
            (false, []) => return None,
            (true, []) => "no column holds what was observed".to_string(),
            (false, [one]) => format!("the column `{}` is missing: {}", one.name, one.about),
            (true, [one]) => format!("no column holds what was observed, and `{}` is missing: {}", one.name, one.about),
            (is_observed_missing, several) => {
                let begin = if is_observed_missing { "no column holds what was observed, and " } else { "" };
                let names: Vec<String> = several.iter().map(|c| format!("`{}`", c.name)).collect();
                format!("{begin}the columns {} are missing", names.join(" and "))
            }
        };
        let wanted = || vocabulary.observables.iter().map(|o| &*o.name).filter(|_| self.observed);
        let meant = wanted().chain(self.coordinates.iter().map(|c| &*c.name)).find_map(|name| {
            let other = unknown.iter().find(|other| nearest(&other.to_lowercase(), [name]).is_some())?;
            Some(format!("is `{other}` meant? "))
        });
        let to_add = observed.iter().filter(|_| self.observed).take(1).chain(&names);
        let said: Vec<String> = to_add.map(|name| format!("HEADING={name}")).collect();
        let either = observed.join(" or ");
        let columns: Vec<&str> =
            Some(&*either).filter(|_| self.observed).into_iter().chain(names.iter().map(String::as_str)).collect();
        let (article, which) =
            if columns.len() == 1 { ("a column", "which one it is") } else { ("columns", "which they are") };
        Some(Problem::new(message).help(format!(
            "{}add {article} {}, or say {which}: --columns '{}'; `fem effects {}` lists all names",
            meant.unwrap_or_default(),
            columns.join(" and "),
            said.join(","),
            vocabulary.process
        )))
    }
}

/// Columns of what can be observed, with their units.
fn observed(vocabulary: Vocabulary) -> Vec<String> {
    vocabulary.observables.iter().map(|o| format!("{} [{}]", o.name, o.kind.unit)).collect()
}

/// The column of a coordinate, with its unit.
fn column_of(coordinate: &Coordinate) -> String {
    match coordinate.holds {
        Holds::Quantity(kind) => format!("{} [{}]", coordinate.name, kind.unit),
        _ => coordinate.name.to_string(),
    }
}

/// Columns without which a file tells nothing: those of the first observable.
pub fn needed(vocabulary: Vocabulary) -> Vec<String> {
    let is_needed =
        |c: &&Coordinate| matches!(c.absent, Absent::Refused | Absent::NeededBy(0, _) | Absent::NeededBut(1..));
    let coordinates = vocabulary.coordinates.iter().filter(is_needed).map(column_of);
    coordinates.chain(observed(vocabulary).into_iter().take(1)).collect()
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
