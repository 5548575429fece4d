//! Wide files, which have a column for every sensor: each column becomes rows of its own.

use super::heading::{Condition, Heading};
use super::records::Records;
use super::vocabulary::Vocabulary;
use crate::input::Problem;
use crate::units::Unit;

/// Makes a record of each place that headings name, with its coordinates in columns; what has no place keeps a
/// record of its own where it observes anything.
///
/// # Errors
/// A coordinate stands in a heading and in a column, or columns of one name differ in their units.
pub fn lengthened(
    headings: Vec<Heading>,
    records: Records,
    vocabulary: Vocabulary,
    told: &mut Vec<String>,
) -> Result<(Vec<Heading>, Records), Problem> {
    let mut places: Vec<&[Condition]> = Vec::new();
    for heading in headings.iter().filter(|h| !h.at.is_empty()) {
        if !places.contains(&&*heading.at) {
            places.push(&heading.at);
        }
    }
    if places.is_empty() {
        return Ok((headings, records));
    }
    let plain: Vec<usize> = (0..headings.len()).filter(|i| headings[*i].at.is_empty()).collect();
    let is_observable = |h: &Heading| vocabulary.observables.iter().any(|o| o.name == h.name);
    let has_own = plain.iter().any(|i| is_observable(&headings[*i]));
    let fixed = fixed(&places);
    let names = names(&headings)?;
    if let Some(name) = fixed
        .iter()
        .map(|(i, _)| &*vocabulary.coordinates[*i].name)
        .find(|name| plain.iter().any(|i| headings[*i].name == *name && headings[*i].is_known))
    {
        let problem = Problem::new(format!("`{name}` stands in a heading and has a column"));
        return Err(problem.help(format!("leave one of them out: --columns '{name}=-'")));
    }
    let mut long: Vec<Heading> = plain.iter().map(|i| headings[*i].clone()).collect();
    long.extend(fixed.iter().map(|(i, unit)| Heading::made(&vocabulary.coordinates[*i].name, unit)));
    long.extend(names.iter().map(|(name, unit)| Heading::made(name, unit)));
    let all = has_own.then_some(&[] as &[Condition]).into_iter().chain(places.iter().copied());
    let all: Vec<&[Condition]> = all.collect();
    let column = |name: &str, place: &[Condition]| {
        headings.iter().position(|h| h.name == name && h.at == place && !place.is_empty())
    };
    let coordinates: Vec<Vec<String>> =
        all.iter().map(|place| fixed.iter().map(|(i, unit)| value(place, *i, unit)).collect()).collect();
    let observed: Vec<Vec<Option<usize>>> =
        all.iter().map(|place| names.iter().map(|(name, _)| column(name, place)).collect()).collect();
    let mut lengthened = Records::written(records.text().clone(), long.len());
    let mut reader = records.reader();
    for number in 0..records.len() {
        let cells = reader.read(number);
        for ((place, coordinates), observed) in all.iter().zip(&coordinates).zip(&observed) {
            let own = plain.iter().map(|i| match (is_observable(&headings[*i]), place) {
                (true, [_, ..]) => "",
                _ => &cells[*i],
            });
            let observed = observed.iter().map(|column| column.map_or("", |i| &cells[i]));
            lengthened
                .push_written(records.byte(number), own.chain(coordinates.iter().map(String::as_str)).chain(observed));
        }
    }
    told.push(format!("a row for each of {} places in the header", places.len()));
    Ok((long, lengthened))
}

/// The coordinates that places fix, each with the unit in which its column is written.
fn fixed(places: &[&[Condition]]) -> Vec<(usize, String)> {
    let mut all: Vec<(usize, String)> = Vec::new();
    for condition in places.iter().copied().flatten() {
        if all.iter().all(|(coordinate, _)| *coordinate != condition.coordinate) {
            all.push((condition.coordinate, condition.unit.clone()));
        }
    }
    all
}

/// Names of the columns that have places, each with the unit that all of them must have.
fn names(headings: &[Heading]) -> Result<Vec<(String, String)>, Problem> {
    let mut all: Vec<(String, String)> = Vec::new();
    for heading in headings.iter().filter(|h| !h.at.is_empty()) {
        match all.iter().find(|(name, _)| *name == heading.name) {
            Some((_, unit)) if Unit::parse(unit).is_ok_and(|own| Unit::parse(&heading.unit) == Ok(own)) => {}
            Some((name, unit)) => {
                let message = format!("columns of `{name}` are in {unit} and in {}", heading.unit);
                return Err(Problem::new(message).help("write all of them in one unit"));
            }
            None => all.push((heading.name.clone(), heading.unit.clone())),
        }
        let alike = |h: &&Heading| h.name == heading.name && h.at == heading.at;
        if headings.iter().filter(alike).count() > 1 {
            return Err(Problem::new(format!("the column `{}` stands twice", heading.written)).help("keep one of them"));
        }
    }
    Ok(all)
}

/// The value of a coordinate at a place, in a unit; empty where the place does not fix it.
fn value(place: &[Condition], coordinate: usize, unit: &str) -> String {
    let Some(own) = place.iter().find(|c| c.coordinate == coordinate) else { return String::new() };
    let factor = |unit: &str| Unit::parse(unit).map_or(1.0, |unit| unit.factor);
    match own.value.parse::<f64>() {
        Ok(number) if own.unit != unit => (number * factor(&own.unit) / factor(unit)).to_string(),
        _ => own.value.clone(),
    }
}
