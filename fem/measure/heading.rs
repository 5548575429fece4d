//! Headings as people and instruments spell them: name, unit, and the place at which a column was measured.

use super::lexicon;
use super::moment::Moment;
use super::vocabulary::Vocabulary;
use crate::input::Problem;
use crate::units::{Unit, plain_unit};

/// A coordinate that a heading fixes for its whole column, as in `temperature@x=12 mm`.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// The coordinate, by its position.
    pub coordinate: usize,
    /// Its value, in its unit.
    pub value: String,
    /// The unit; empty where it has none.
    pub unit: String,
}

/// Heading of a column, parsed.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// As the file writes it.
    pub written: String,
    /// The program's name of the column, where it knows one; else as written.
    pub name: String,
    /// Unit; empty where there is none.
    pub unit: String,
    /// Coordinates of the whole column.
    pub at: Vec<Condition>,
    /// Moment from which a column of times is counted, as text and read.
    pub since: Option<(String, Moment)>,
    /// Whether the program knows the column.
    pub is_known: bool,
}

impl Heading {
    /// Reads a heading in any spelling: `name [unit]`, `name (unit)`, `name / unit`, `name in unit`; capitals,
    /// blanks and hyphens do not matter. `others` are names that the file writes as the program does.
    ///
    /// # Errors
    /// It could mean two things, or fixes a coordinate that the process does not have.
    pub fn read(cell: &str, vocabulary: Vocabulary, others: &[String]) -> Result<Self, Problem> {
        let known = |name: &str| vocabulary.knows(base(name)) || lexicon::meant(base(name), vocabulary).is_some();
        let (spelled, unit) = parts(cell, |name| known(&plain(name)));
        let name = plain(spelled);
        let mut conditions = spelled.split('@');
        let own = plain(conditions.next().unwrap_or_default());
        // A word of another language means a column, unless that stands in the file itself.
        let foreign = if vocabulary.knows(&own) { None } else { lexicon::meant(&own, vocabulary) };
        let foreign = foreign.filter(|name| !others.iter().any(|other| plain(other) == **name));
        let (own, name) = foreign.map_or((own, name), |foreign| (foreign.to_string(), foreign.to_string()));
        // Beside a column of that very name this one is another.
        let is_known = vocabulary.knows(&own) && (foreign.is_some() || spelled == name || !others.contains(&name));
        let mut heading = Self {
            written: cell.trim().to_string(),
            name: own,
            unit: if unit == "-" { String::new() } else { plain_unit(unit) },
            at: Vec::new(),
            since: None,
            is_known,
        };
        if !is_known {
            return Ok(Self { name: spelled.to_string(), unit: unit.to_string(), ..heading });
        }
        if spelled.starts_with(['-', '−', '–']) {
            return Err(Problem::new(format!("`{spelled}` counts the other way round than {}", heading.name)).help(
                format!(
                    "give its numbers with the other sign and write {}, or leave it out: --columns '{spelled}=-'",
                    heading.name
                ),
            ));
        }
        // `U`, `U (k=2)`, `U_diameter`; a word that begins so is none.
        if spelled.strip_prefix('U').is_some_and(|rest| !rest.starts_with(char::is_alphabetic)) {
            return Err(Problem::new(format!("`{spelled}` often means an expanded uncertainty")).help(format!(
                "write {} [..] if it is the standard uncertainty, or say --columns '{spelled}={}'; else divide it \
                 by its coverage factor",
                heading.name, heading.name
            )));
        }
        for condition in conditions {
            heading.at.push(self::condition(condition, &heading.written, vocabulary)?);
        }
        if !heading.at.is_empty() && vocabulary.coordinate(&heading.name).is_some() {
            let problem = Problem::new(format!("`{}` is a coordinate and is measured nowhere", heading.name));
            return Err(problem.help("write the place behind the name of what is observed: temperature@x=12 mm [degC]"));
        }
        Ok(heading)
    }

    /// The heading of a column that the program makes.
    pub fn made(name: &str, unit: &str) -> Self {
        Self {
            written: name.to_string(),
            name: name.to_string(),
            unit: unit.to_string(),
            at: Vec::new(),
            since: None,
            is_known: true,
        }
    }

    /// The heading as the program writes it.
    pub fn cell(&self) -> String {
        match (self.is_known, &*self.unit) {
            (false, _) => self.written.clone(),
            (true, "") => self.name.clone(),
            (true, unit) => format!("{} [{unit}]", self.name),
        }
    }

    /// The same with the places of the whole column, as `--columns` says them.
    pub fn whole(&self, vocabulary: Vocabulary) -> String {
        let place = |own: &Condition| {
            let value = format!("{} {}", own.value, own.unit);
            format!("@{}={}", vocabulary.coordinates[own.coordinate].name, value.trim_end())
        };
        let places: String = self.at.iter().map(place).collect();
        if self.unit.is_empty() {
            format!("{}{places}", self.name)
        } else {
            format!("{}{places} [{}]", self.name, self.unit)
        }
    }

    /// Note on how it was read, where it is not written so; `None` where it is.
    pub fn note(&self, vocabulary: Vocabulary) -> Option<String> {
        let whole = self.whole(vocabulary);
        // A place behind a name is written by whoever knows the program's form.
        let is_own = plainly(&self.written) == plainly(&whole) || (!self.at.is_empty() && self.written.contains('@'));
        (self.is_known && !is_own).then(|| format!("`{}` as {whole}", self.written))
    }
}

fn plainly(text: &str) -> String {
    text.replace(' ', "")
}

/// A name in small letters, with underscores for blanks and hyphens; places behind it are left as they are.
pub fn plain(name: &str) -> String {
    let (own, places) = name.split_at(name.find('@').unwrap_or(name.len()));
    let words: Vec<&str> = own.split([' ', '-', '_', '\u{a0}']).filter(|word| !word.is_empty()).collect();
    words.join("_").to_lowercase() + places
}

fn base(name: &str) -> &str {
    name.split('@').next().unwrap_or_default()
}

/// Name and unit of a cell. Outside of square brackets a unit is one if it can be read, or if the name before
/// it is known.
pub fn parts(cell: &str, is_known: impl Fn(&str) -> bool) -> (&str, &str) {
    let cell = cell.trim();
    let brackets = cell.split_once('[').map(|(name, unit)| (name, unit.trim().trim_end_matches(']')));
    let round = || cell.strip_suffix(')').and_then(|text| text.split_once('('));
    let said = || cell.rsplit_once(" in ");
    let slash = || cell.split_once('/');
    let is_unit = |(name, unit): &(&str, &str)| is_known(name.trim()) || self::is_unit(unit.trim());
    let found = brackets.or_else(|| round().filter(is_unit)).or_else(|| said().filter(is_unit));
    let (name, unit) = found.or_else(|| slash().filter(is_unit)).unwrap_or((cell, ""));
    (name.trim(), unit.trim())
}

/// The unit of a cell that holds a unit alone, without the brackets around it.
pub fn bare_unit(cell: &str) -> &str {
    cell.trim_matches(['[', ']', '(', ')']).trim()
}

/// Whether a text is a unit, and not a number: a file of whole numbers has no units in its first row.
pub fn is_unit(text: &str) -> bool {
    text.contains(|c: char| c.is_alphabetic() || matches!(c, '°' | '℃')) && Unit::parse(text).is_ok()
}

/// Reads `x=12 mm` in a heading.
fn condition(text: &str, heading: &str, vocabulary: Vocabulary) -> Result<Condition, Problem> {
    let wrong = |message: String, help: String| Err(Problem::new(format!("`{heading}`: {message}")).help(help));
    let Some((name, value)) = text.split_once('=') else {
        return wrong(format!("`{text}` fixes nothing"), "write temperature@x=12 mm [degC]".into());
    };
    let (name, value) = (plain(name), value.trim());
    let Some(coordinate) = vocabulary.coordinates.iter().position(|c| c.name == name) else {
        let known: Vec<&str> = vocabulary.coordinates.iter().map(|c| &*c.name).collect();
        return wrong(format!("`{name}` is no coordinate"), format!("known are {}", known.join(", ")));
    };
    let Some(kind) = vocabulary.coordinates[coordinate].holds.kind() else {
        return Ok(Condition { coordinate, value: value.into(), unit: String::new() });
    };
    // The number may stand before its unit with or without a blank.
    let ends = (1..=value.len()).rev().filter(|end| value.is_char_boundary(*end));
    let number = ends.map(|end| value.split_at(end)).find(|(number, _)| number.trim().parse::<f64>().is_ok());
    let Some((number, unit)) = number else {
        return wrong(format!("`{value}` begins with no number"), format!("write {name}={} {}", kind.usual, kind.unit));
    };
    match kind.unit_of(unit.trim()) {
        Ok(_) => Ok(Condition { coordinate, value: number.trim().into(), unit: unit.trim().into() }),
        Err(error) => wrong(error.message, format!("write {name}={} {}", number.trim(), kind.unit)),
    }
}
