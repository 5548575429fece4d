//! The columns of a process's measurement files, as its observables and coordinates say them.

use crate::process::{Absent, Coordinate, Holds, Process};

/// A column: its heading, what happens where it is left out, and what it holds.
struct Column {
    heading: String,
    need: String,
    about: String,
}

/// Lists the columns of a process's measurement files, a line each.
pub fn columns(process: &dyn Process) -> String {
    let all = all(process);
    let width = |of: fn(&Column) -> &str| all.iter().map(|c| of(c).chars().count()).max().unwrap_or(0);
    let (headings, needs) = (width(|c| &c.heading), width(|c| &c.need));
    let line = |c: &Column| format!("  {:<headings$}  {:<needs$}  {}\n", c.heading, c.need, c.about);
    let title = "columns of its measurement files (CSV; any unit of the kind will do; in any order)\n";
    title.to_string() + &all.iter().map(line).collect::<String>()
}

/// The same as comments of a model file.
pub fn commented(process: &dyn Process) -> String {
    let name = process.name();
    let text = columns(process).replacen("its", &format!("the {name}"), 1);
    text.lines().map(|line| format!("# {line}\n")).collect()
}

/// The heading of each, and what it holds.
pub fn all_columns(process: &dyn Process) -> Vec<(String, String)> {
    all(process).into_iter().map(|own| (own.heading, own.about)).collect()
}

fn all(process: &dyn Process) -> Vec<Column> {
    let observables = process.observables();
    let alike = |i: usize| (0..observables.len()).any(|j| j != i && observables[j].is_instead_of(&observables[i]));
    let observed = observables.iter().enumerate().map(|(i, o)| Column {
        heading: heading(&o.name, &o.kind.unit),
        need: match observables.len() {
            1 => "observed".into(),
            _ if alike(i) && observables.len() > 2 => "observed, or another".into(),
            _ if alike(i) => "observed, or the other".into(),
            2 => "observed, or the other, or both".into(),
            _ => "observed, alone or with others".into(),
        },
        about: format!("what effects change: {}", o.words),
    });
    let of_coordinate = |c: &Coordinate| {
        let unit = c.holds.kind().map(|kind| kind.unit).unwrap_or_default();
        let actual = c.actual.map(|observable| Column {
            heading: heading(&format!("actual_{}", c.name), &unit),
            need: format!("instead of {}", observables[observable].name),
            about: format!("which then is its difference from {}", c.name),
        });
        let own = Column { heading: heading(&c.name, &unit), need: need(c, process), about: about(c) };
        std::iter::once(own).chain(actual).collect::<Vec<_>>()
    };
    let coordinates = process.coordinates().iter().flat_map(of_coordinate);
    let several = observables.len() > 1 && !alike(0);
    let uncertain = observables.iter().take(if several { observables.len() } else { 1 }).map(|o| Column {
        heading: heading(&if several { format!("u_{}", o.name) } else { "u".into() }, &o.error_kind().unit),
        need: "if known".into(),
        about: "standard uncertainty of the row; from repeats, or estimated, where it is left out".into(),
    });
    observed.chain(coordinates).chain(uncertain).collect()
}

fn heading(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.into() } else { format!("{name} [{unit}]") }
}

/// Whether the column is needed, and its default where it is left out.
fn need(coordinate: &Coordinate, process: &dyn Process) -> String {
    let only = |observable: usize| &process.observables()[observable].name;
    let either =
        |first: usize, last: usize| (first..=last).map(|o| only(o).to_string()).collect::<Vec<_>>().join(" or ");
    match coordinate.absent {
        Absent::Refused => "needed".into(),
        Absent::NeededBut(observable) => format!("needed, but for {}", only(observable)),
        Absent::NeededBy(first, last) => format!("needed with {}", either(first, last)),
        Absent::Model => "the model's if left out".into(),
        Absent::ModelOf(first, last) => format!("the model's if left out, with {}", either(first, last)),
        Absent::Value(value) => match &coordinate.holds {
            Holds::Quantity(kind) => format!("{} if left out", kind.format(value)),
            Holds::Number(_) => format!("{value} if left out"),
            Holds::Word(words) => format!("{} if left out", words.of_value(value).unwrap_or_default()),
        },
    }
}

/// Content of the column. Words are numbers to formulas, counted from 0.
fn about(coordinate: &Coordinate) -> String {
    match &coordinate.holds {
        Holds::Quantity(_) => coordinate.about.into(),
        Holds::Number(least) => format!("{}, from {least} on", coordinate.about),
        Holds::Word(words) => {
            let numbered: Vec<String> = words.iter().enumerate().map(|(i, word)| format!("{i} for {word}")).collect();
            format!("{}; in formulas {}", coordinate.about, numbered.join(", "))
        }
    }
}
