//! Readings that no machine gives: a unit is another, or the part is.

use super::Model;
use crate::input::Problem;
use crate::measure::Measurements;
use crate::process::{Observable, Rows};

/// Most rows that are looked at.
const MOST: usize = 2000;

/// Mistakes of units: by what the readings are to be multiplied, and how it is told.
const MISTAKES: &[(f64, &str)] = &[
    (25.4, "they are in inches"),
    (1.0 / 25.4, "they are in mm, and taken for inches"),
    (1e3, "they are in mm where m is said, or in m where km is"),
    (1e-3, "they are in um where mm is said, or in mm where m is"),
    (2.0, "they are radii"),
    (0.5, "they are diameters, and taken for radii"),
];

/// Part of the difference that may be left where a mistake explains it.
const EXPLAINED: f64 = 0.1;

/// Part of a commanded value by which an actual one differs at most.
const SAME_PLACE: f64 = 0.02;
/// Times as far off as any difference is, from which a reading is of nothing that was made.
const NOTHING: f64 = 20.0;

/// The problem of readings of a difference that are the actual values themselves: nearly as large as what was commanded.
fn are_actual(
    model: &Model,
    measurements: &Measurements,
    rows: &Rows,
    (position, own): (usize, &[usize]),
) -> Option<Problem> {
    let coordinates = model.process.coordinates();
    let commanded = coordinates.iter().position(|own| own.actual == Some(position))?;
    let places = || own.iter().filter_map(|row| Some((*row, rows.get(commanded, *row).filter(|at| *at != 0.0)?)));
    let is_one = |(row, at): &(usize, f64)| (measurements.observed[*row] - at).abs() < SAME_PLACE * at.abs();
    let (all, count) = (places().count(), places().filter(is_one).count());
    let (row, _) = places().find(is_one).filter(|_| count >= 3 && 10 * count >= 9 * all)?;
    let observable = &model.process.observables()[position];
    let problem = Problem::new(format!(
        "readings of `{}` are as large as `{}`, {} in {}: they are actual values, and no differences",
        observable.name,
        coordinates[commanded].name,
        observable.kind.format(measurements.observed[row]),
        measurements.place(row),
    ));
    Some(problem.help("name their column `actual`: --columns 'HEADING=actual'"))
}

/// The problem of a few readings (row, predicted) among others that lie farther off than any difference is, where one mistake
/// explains all of them: a part that was measured in inches.
fn some_far_off(observable: &Observable, measurements: &Measurements, readings: &[(usize, f64)]) -> Option<Problem> {
    let off = |(row, predicted): &(usize, f64), factor: f64| (factor * measurements.observed[*row] - predicted).abs();
    let far: Vec<&(usize, f64)> = readings.iter().filter(|own| off(own, 1.0) > observable.largest).collect();
    let explains = |factor: f64| far.iter().all(|own| off(own, factor) < EXPLAINED * off(own, 1.0));
    let (row, _) = **far.first()?;
    let meant = MISTAKES.iter().find(|(factor, _)| explains(*factor)).filter(|_| far.len() > 1);
    let is_nothing = far.iter().all(|own| off(own, 1.0) > NOTHING * observable.largest);
    let meant = match meant {
        Some((_, what)) => format!("; as if {what}"),
        None if is_nothing => String::new(),
        None => return None,
    };
    let problem = Problem::new(format!(
        "{} of `{}` {} more than {} from what the drawing says, and the others do not, as {} in {}{meant}",
        if far.len() == 1 { "one reading".into() } else { format!("{} readings", far.len()) },
        observable.name,
        if far.len() == 1 { "lies" } else { "lie" },
        observable.error_kind().format(observable.largest),
        observable.kind.format(measurements.observed[row]),
        measurements.place(row),
    ));
    Some(problem.help("write them in the unit of the column, or leave them out"))
}

/// The problem of a reading beyond what the process lets a prediction be.
fn not_to_be_meant(model: &Model, measurements: &Measurements, rows: &Rows, position: usize) -> Option<Problem> {
    let limit = model.system.limit(position)?;
    let is_beyond = |row: &usize| rows.observable[*row] == position && measurements.observed[*row].abs() >= limit.size;
    let row = (0..rows.len()).find(is_beyond)?;
    let observable = &model.process.observables()[position];
    let shown = observable.kind.format(measurements.observed[row]);
    let problem =
        Problem::new(format!("`{}` is {shown} in {}: {}", observable.name, measurements.place(row), limit.why));
    Some(problem.help("write it in the unit of the column, or leave it out"))
}

/// The problem of readings whose middle lies farther from what the drawing says than any such difference is.
pub fn implausible(model: &Model, measurements: &Measurements, rows: &Rows) -> Option<Problem> {
    for (position, observable) in model.process.observables().iter().enumerate() {
        let own: Vec<usize> = (0..rows.len()).filter(|row| rows.observable[*row] == position).collect();
        let step = own.len().div_ceil(MOST).max(1);
        let own: Vec<usize> = own.into_iter().step_by(step).collect();
        if let Some(problem) = are_actual(model, measurements, rows, (position, &own)) {
            return Some(problem);
        }
        if own.is_empty() {
            continue;
        }
        if !observable.largest.is_finite() {
            match not_to_be_meant(model, measurements, rows, position) {
                Some(problem) => return Some(problem),
                None => continue,
            }
        }
        // An error is nought where all is as the drawing says; all else is what the ideal system makes.
        let predicted = match observable.error_kind() == observable.kind {
            true => vec![0.0; own.len()],
            false => match model.system.with_effects(&[]).observe(&rows.some(&own)) {
                Ok(predicted) => predicted,
                Err(_) => continue,
            },
        };
        let off = |factor: f64| {
            let differences =
                own.iter().zip(&predicted).map(|(row, p)| (factor * measurements.observed[*row] - p).abs());
            let mut all: Vec<f64> = differences.filter(|own| own.is_finite()).collect();
            all.sort_unstable_by(f64::total_cmp);
            all.get(all.len() / 2).copied()
        };
        let Some(difference) = off(1.0).filter(|own| *own > observable.largest) else {
            let readings: Vec<(usize, f64)> = own.iter().copied().zip(predicted).collect();
            match some_far_off(observable, measurements, &readings) {
                Some(problem) => return Some(problem),
                None => continue,
            }
        };
        let (row, name) = (own[own.len() / 2], &observable.name);
        let shown = observable.kind.format(measurements.observed[row]);
        let is_meant = |(factor, _): &&(f64, &str)| off(*factor).is_some_and(|left| left < EXPLAINED * difference);
        let meant = MISTAKES.iter().find(is_meant).map_or(String::new(), |(_, what)| format!("; as if {what}"));
        let problem = Problem::new(format!(
            "half of the readings of `{name}` lie more than {} from what the drawing says, as {shown} in {}{meant}",
            observable.error_kind().format(difference),
            measurements.place(row),
        ));
        let unit = observable.kind.unit;
        return Some(problem.help(format!(
            "is the unit right, is it the part of the model? say the unit: --columns 'HEADING={name} [{unit}]', or mend the model"
        )));
    }
    None
}
