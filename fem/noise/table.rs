//! Reads the tables `[measurement.NAME]`: what a model says of its instrument, datum and surroundings.

use std::path::PathBuf;

use super::given::GivenCovariance;
use super::instrument::time_of;
use super::key::{ALONG, BY, FROM, HIGH, IN_FILE, Key, LOW, OBSERVABLE, PERIOD, ROWS, UNIT};
use super::size::{observed, size};
use super::term::{Acts, Along, MeasurementEffect, Size, Term};
use super::{covariance_file, effects};
use crate::input::{Cache, Reader, did_you_mean};
use crate::measure::{FILE, FILE_WORD};
use crate::process::{Coordinate, Holds, Parameter, Process};
use crate::units::{ANGLE, Kind, Knowledge, LENGTH, Quantity, Unit};

/// The covariances of a model, by their files and the factors of their units.
type Covariances = Cache<(PathBuf, u64), GivenCovariance, 4>;

/// Reads every measurement effect of a model. A size that is unknown (`?`) is not a number; rows are records
/// of the file, counted from 1.
pub fn read(model: &Reader, process: &dyn Process) -> Vec<Term> {
    let names: Vec<&'static str> = effects::all().map(|e| e.name).collect();
    let about = "what instrument, datum or surroundings do to the measurements";
    let read = |known: &'static str, name: &str, table: &Reader| match effects::named(known) {
        Some(effect) => terms(effect, name, table, process),
        None => Vec::new(),
    };
    model.tables_within(effects::MEASUREMENT, about, &names, read).into_iter().flatten().collect()
}

/// The terms of a table: one, or two where two sizes stand in it.
fn terms(effect: &'static MeasurementEffect, name: &str, table: &Reader, process: &dyn Process) -> Vec<Term> {
    let mut term = Term { table: name.to_string(), ..Term::new(effect) };
    if effect.has(BY) {
        term.by = coordinates(table, process);
    }
    if effect.has(OBSERVABLE) {
        term.observable = observable(table, process);
    }
    if effect.has(ROWS) {
        term.rows = numbers(table, &ROWS);
        if !table.has(ROWS.name) {
            table.problem(ROWS.name, "the rows that are wrong are not listed", "add rows = \"12, 40\"");
        }
    }
    if effect.has(FROM) {
        term.rows = numbers(table, &FROM);
        if !table.has(FROM.name) || term.rows.len() > 1 {
            table.problem(FROM.name, "a step begins at one row", "add from = \"46\"");
        }
    }
    if effect.has(IN_FILE) {
        term.file = table.text(IN_FILE.name, IN_FILE.about);
    }
    if effect.has(ALONG) {
        let along = along(table, process, effect);
        if effect.has(PERIOD) {
            term.period = period(table, along.map_or(LENGTH, |(_, kind)| kind));
        }
        term.along = along.map(|(along, _)| along);
    }
    match (effect.acts, effect.size, effect.beside) {
        (_, Size::OfReading(_), _) => characteristic(term, table, process),
        (_, Size::Quantity(Parameter { name, kind, about, .. }), _) => {
            let field = table.quantity(name.clone(), *kind, about);
            let field = if kind.unit.is_empty() { field.positive() } else { field };
            check_time(effect, table, process);
            vec![Term { size: field.required(), ..term }]
        }
        (Acts::Given, ..) => given(term, table).into_iter().collect(),
        (.., [other]) => two(term, other, table, process),
        _ => sized(term, table, process).into_iter().collect(),
    }
}

/// Both terms of a table with two sizes; one that is zero is left out.
fn two(term: Term, other: &'static MeasurementEffect, table: &Reader, process: &dyn Process) -> Vec<Term> {
    let first = sized(Term { effect: other, along: None, ..term.clone() }, table, process);
    let second = sized(term.clone(), table, process);
    let all: Vec<Term> = first.into_iter().chain(second).filter(|t| t.size != 0.0).collect();
    if all.is_empty() && !table.is_described() && table.is_sound() {
        let [first, second] = [other.size.key(), term.effect.size.key()];
        let message = format!("neither `{first}` nor `{second}` is at work");
        table.problem(second, message, "leave the table out, or write \"?\"");
    }
    all
}

/// The terms of a sensor's characteristic, one for each size that its table has.
fn characteristic(mut term: Term, table: &Reader, process: &dyn Process) -> Vec<Term> {
    let effect = term.effect;
    // Sizes are in the unit of what is observed.
    let several = process.observables().len() > 1 && !table.is_described();
    if several && !table.has(OBSERVABLE.name) {
        let names = process.observables().iter().map(|o| &*o.name).collect::<Vec<_>>();
        let help = format!("add observable = \"{}\", or another of {}", names[0], names.join(", "));
        table.problem(OBSERVABLE.name, "it is not said what the sensor measures", help);
        return Vec::new();
    }
    let own = &process.observables()[term.observable.unwrap_or(0)];
    let [low, high] = [LOW, HIGH].map(|key| table.quantity(key.name, own.kind, key.about).chosen().optional());
    term.range = low.zip(high).map(|(low, high)| [low, high]);
    let mut terms = Vec::new();
    for effect in effect.sizes() {
        let (Size::OfReading(parameter) | Size::Quantity(parameter)) = effect.size else { continue };
        let of_reading = matches!(effect.size, Size::OfReading(_));
        let kind = if of_reading { own.error_kind() } else { parameter.kind };
        let field = table.quantity(parameter.name.clone(), kind, parameter.about);
        let field = if of_reading { field } else { field.positive() };
        terms.extend(field.optional().map(|size| Term { effect, size, ..term.clone() }));
    }
    if table.is_described() || !table.is_sound() {
        return terms;
    }
    if terms.is_empty() {
        let all = effect.size_keys().join("`, `");
        table.problem("", format!("none of `{all}` is there"), "leave the table out, or write \"?\" for one of them");
    }
    let is_shape = |t: &Term| !matches!(t.effect.size.key(), "offset" | "scale");
    if let Some(shape) = terms.iter().find(|t| is_shape(t)) {
        let key = shape.effect.size.key();
        match term.range {
            None => {
                let message = format!("`{key}` is told between two values of what is observed");
                table.problem(key, message, "add low = \"0 mm\" and high = \"2 mm\", where the sensor's range ends");
            }
            Some([low, high]) if high <= low => {
                table.problem(HIGH.name, "`high` is not above `low`", "give the sensor a range");
            }
            Some(_) => {}
        }
    }
    terms
}

/// The term with the size that its table says.
fn sized(mut term: Term, table: &Reader, process: &dyn Process) -> Option<Term> {
    let effect = term.effect;
    let key = effect.size.key();
    let Some(text) = table.text_or_number(key, effect.size.about()) else {
        term.size = effect.usual;
        return Some(term);
    };
    match size(effect, &observed(process, term.observable), &text) {
        Ok((value, of)) => {
            term.size = value;
            // A unit that not all of several observables have tells on which the effect acts.
            let is_of_observable = matches!(effect.size, Size::OfObservable(..));
            match &of[..] {
                _ if !is_of_observable || of.len() == process.observables().len() => {}
                [only] => term.observable = Some(*only),
                _ => term.among = of,
            }
            Some(term)
        }
        Err(problem) => {
            table.problem(key, format!("`{key}`: {}", problem.message), problem.help.unwrap_or_default());
            None
        }
    }
}

/// The coordinate along which an effect changes, with its kind; `None` where none is said, and the problem is noted.
fn along(table: &Reader, process: &dyn Process, effect: &MeasurementEffect) -> Option<(Along, Kind)> {
    let names = || process.coordinates().iter().map(|c| &*c.name);
    let said = table.text(ALONG.name, ALONG.about);
    let listed = || {
        let is_quantity = |c: &&Coordinate| matches!(c.holds, Holds::Quantity(_));
        let all = process.coordinates().iter().filter(is_quantity).map(|c| &*c.name);
        format!("known are {}", all.collect::<Vec<_>>().join(", "))
    };
    let Some(said) = said else {
        let message = format!("it is not said along what `{}` changes", effect.name);
        table.problem(ALONG.name, message, format!("add along; {}", listed()));
        return None;
    };
    let Some(coordinate) = names().position(|name| name == said) else {
        let meant = did_you_mean(&said, names(), '"');
        table.problem(ALONG.name, format!("`{said}` is no coordinate"), format!("{meant}{}", listed()));
        return None;
    };
    let Some(kind) = process.coordinates()[coordinate].holds.kind() else {
        table.problem(ALONG.name, format!("`{said}` is no length, angle or time"), listed());
        return None;
    };
    Some((Along { coordinate, is_angle: kind == ANGLE }, kind))
}

/// The period of a wave; `None` where it is not known, and the problem is noted.
fn period(table: &Reader, kind: Kind) -> Option<f64> {
    let key = PERIOD.name;
    let Some(text) = table.text(key, PERIOD.about) else {
        table.problem(key, "the period of the wave is not said", format!("add period = \"{}\"", PERIOD.example));
        return None;
    };
    match Quantity::parse(&text, &kind) {
        Ok(Quantity { value, knowledge: Knowledge::Known }) if value > 0.0 => return Some(value),
        Ok(_) => {
            let help = "write the value alone, above zero; `fem diagnose` looks for one that is not known";
            table.problem(key, format!("`{text}` is no period"), help);
        }
        Err(e) => table.problem(key, format!("`{key}`: {}", e.message), e.hint.unwrap_or_default()),
    }
    None
}

/// The covariance that a file gives; `None` where there is none, and the problem is noted.
fn given(term: Term, table: &Reader) -> Option<Term> {
    let key = term.effect.size.key();
    let file = table.required_file(key, term.effect.size.about(), covariance_file::LARGEST);
    let unit = table.text(UNIT.name, UNIT.about);
    if !table.has(UNIT.name) {
        table.problem(UNIT.name, "the unit of the covariance is not said", "add unit = \"um\": its square is meant");
    }
    let (file, unit) = (file?, unit?);
    let factor = match Unit::parse(&unit) {
        Ok(unit) => unit.factor,
        Err(e) => {
            table.problem(UNIT.name, format!("`unit`: {}", e.message), e.hint.unwrap_or_default());
            return None;
        }
    };
    let asked = (file.path.clone(), factor.to_bits());
    match table.kept::<Covariances>().get_or(asked, |_| covariance_file::read(&file, factor)) {
        Ok(covariance) => Some(Term { covariance: Some(covariance), size: f64::NAN, ..term }),
        Err(problem) => {
            let message = format!("{}: {}", file.path.display(), problem.message);
            table.problem(key, message, problem.help.unwrap_or_default());
            None
        }
    }
}

/// Refuses a clock where nothing has a time.
fn check_time(effect: &MeasurementEffect, table: &Reader, process: &dyn Process) {
    if matches!(effect.acts, Acts::Times(_)) && time_of(process).is_none() && !table.is_described() {
        let message = format!("nothing in `{}` has a time", process.name());
        table.problem("", message, "leave the table out");
    }
}

fn coordinates(table: &Reader, process: &dyn Process) -> Vec<usize> {
    let names = || process.coordinates().iter().map(|c| &*c.name).chain([FILE_WORD]);
    let mut all = Vec::new();
    for name in table.text(BY.name, BY.about).iter().flat_map(|by| by.split(',')).map(str::trim) {
        match names().position(|n| n == name) {
            Some(last) if last == process.coordinates().len() => all.push(FILE),
            Some(coordinate) => all.push(coordinate),
            None => {
                let meant = did_you_mean(name, names(), '"');
                let known = names().collect::<Vec<_>>().join(", ");
                table.problem(BY.name, format!("`{name}` is no coordinate"), format!("{meant}known are {known}"));
            }
        }
    }
    all
}

fn observable(table: &Reader, process: &dyn Process) -> Option<usize> {
    let name = table.text(OBSERVABLE.name, OBSERVABLE.about)?;
    let names = || process.observables().iter().map(|o| &*o.name);
    let position = names().position(|n| n == name);
    if position.is_none() {
        let meant = did_you_mean(&name, names(), '"');
        let known = names().collect::<Vec<_>>().join(", ");
        table.problem(OBSERVABLE.name, format!("`{name}` is not observed"), format!("{meant}known are {known}"));
    }
    position
}

fn numbers(table: &Reader, key: &Key) -> Vec<usize> {
    let text = table.text_or_number(key.name, key.about);
    let mut rows = Vec::new();
    for word in text.iter().flat_map(|text| text.split(',')).map(str::trim) {
        match word.parse::<usize>() {
            Ok(row) if row > 0 => rows.push(row),
            _ => table.problem(
                key.name,
                format!("`{word}` is no row"),
                format!("rows are counted from 1: \"{}\"", key.example),
            ),
        }
    }
    rows
}
