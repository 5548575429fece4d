//! Columns that a file has beside those of its process: what somebody wrote down with every reading, the temperature of
//! the coolant, a batch, who measured.
//!
//! Each is a coordinate as those of the process are, unless it can tell nothing, and then it is said why.

use std::collections::BTreeMap;

use super::header::{Column, Header};
use super::moment::Moment;
use super::records::Records;
use super::{MeasuredObservable, Measurements};
use crate::input::{Name, name_and_unit};
use crate::process::{Coordinate, Holds, Values, Words};
use crate::units::{Kind, NUMBER, Unit, UnitSymbol};

/// Most columns that are used, and most words of one.
const MOST: usize = 24;
const MOST_WORDS: usize = 60;
/// Cells of columns that are held at once.
const MOST_CELLS: usize = 1_000_000;
/// Correlation from which a column says what another says, and what was observed; and fewest rows that show it.
const SAME: f64 = 1.0 - 1e-9;
const FOLLOWS: f64 = 0.999;
const FEWEST: usize = 8;
/// Part of the cells that are numbers from which the others are slips of the pen.
const NUMERIC: f64 = 0.8;

/// A column that is used.
pub struct Recorded {
    /// What it is.
    pub coordinate: Coordinate,
    /// Its values, SI, record by record.
    pub values: Vec<f64>,
}

/// Reads the columns of a file that its process does not know; with notes on those that are not used, or of which it is
/// not said in what they are.
pub fn read(header: &Header, cells: &[String], records: &Records) -> (Vec<Recorded>, Vec<String>) {
    let (mut used, mut notes): (Vec<Recorded>, Vec<String>) = (Vec::new(), Vec::new());
    let unknown: Vec<usize> = (0..header.columns.len()).filter(|i| header.columns[*i] == Column::Unknown).collect();
    // Of many columns so many at once that the records are not read again for each, and that they stay few in memory.
    let each = (MOST_CELLS / records.len().max(1)).max(1);
    let of_columns = unknown.chunks(each).flat_map(|columns| columns.iter().copied().zip(columns_of(columns, records)));
    for (column, own) in of_columns {
        let (name, unit) = name_and_unit(&cells[column]);
        match content(own, unit, records) {
            _ if used.len() == MOST => notes.push(format!("the column `{name}` is not used: {MOST} others are")),
            Ok((holds, values)) => {
                if holds == Holds::Quantity(NUMBER) {
                    notes.push(match unit {
                        "" => format!("the column `{name}` has no unit, and counts as a pure number"),
                        _ => format!("the unit `{unit}` of `{name}` is not known, and it counts as a pure number"),
                    });
                }
                let coordinate = Coordinate::recorded(identifier(name).into(), holds, usual(&values));
                used.push(Recorded { coordinate, values });
            }
            Err(reason) => notes.push(format!("the column `{name}` is not used: {reason}")),
        }
    }
    (used, notes)
}

/// The cells of some columns, record by record.
fn columns_of(columns: &[usize], records: &Records) -> Vec<Vec<String>> {
    let mut cells: Vec<Vec<String>> = columns.iter().map(|_| Vec::with_capacity(records.len())).collect();
    let mut reader = records.reader();
    for number in 0..records.len() {
        let record = reader.read(number);
        for (own, column) in cells.iter_mut().zip(columns) {
            own.push(record.get(*column).unwrap_or_default().trim().to_string());
        }
    }
    cells
}

/// What a column with these cells holds, and its values, SI.
fn content(cells: Vec<String>, unit: &str, records: &Records) -> Result<(Holds, Vec<f64>), String> {
    let count = cells.len();
    let empty = cells.iter().filter(|cell| cell.is_empty()).count();
    if empty == count {
        return Err("it is empty".into());
    }
    if empty > 0 {
        return Err(format!("{empty} of its {count} cells are empty"));
    }
    let numbers: Vec<Option<f64>> = cells.iter().map(|cell| parsed(cell)).collect();
    let is_number = numbers.iter().filter(|number| number.is_some()).count();
    if cells.iter().all(|cell| *cell == cells[0]) {
        return Err(format!("it is {} in every row", cells[0]));
    }
    if is_number == count {
        return of_numbers(unit, numbers.into_iter().flatten().collect());
    }
    if is_number as f64 >= NUMERIC * count as f64 {
        let first = numbers.iter().position(Option::is_none).unwrap_or(0);
        return Err(format!("`{}` in line {} is no number", cells[first], records.line(first)));
    }
    if !unit.is_empty() {
        return Err("it has a unit, and words".into());
    }
    if cells.iter().all(|cell| Moment::parse(cell).is_some()) {
        return Err("it holds dates; a column of times is `time`".into());
    }
    of_words(cells)
}

/// The number of a cell, with a point or a comma.
fn parsed(cell: &str) -> Option<f64> {
    let number = cell.parse().or_else(|_| cell.replace(',', ".").parse::<f64>());
    number.ok().filter(|number| number.is_finite())
}

fn of_numbers(unit: &str, numbers: Vec<f64>) -> Result<(Holds, Vec<f64>), String> {
    let counts = numbers.len() > 2 && numbers.windows(2).all(|two| two[1] - two[0] == 1.0);
    if counts && unit.is_empty() {
        return Err("it numbers the rows".into());
    }
    let known = Unit::parse(unit).ok().zip(UnitSymbol::written(unit)).filter(|_| !unit.is_empty());
    let Some((unit, symbol)) = known else { return Ok((Holds::Quantity(NUMBER), numbers)) };
    let kind = Kind { name: "a quantity", unit: symbol, usual: "1" };
    Ok((Holds::Quantity(kind), numbers.into_iter().map(|number| number * unit.factor + unit.offset).collect()))
}

fn of_words(cells: Vec<String>) -> Result<(Holds, Vec<f64>), String> {
    let count = cells.len();
    let mut positions: BTreeMap<String, usize> = BTreeMap::new();
    let mut words: Vec<Name> = Vec::new();
    let mut values = Vec::with_capacity(count);
    for cell in cells {
        let position = *positions.entry(cell).or_insert_with_key(|cell| {
            words.push(cell.clone().into());
            words.len() - 1
        });
        values.push(position as f64);
    }
    if words.len() > MOST_WORDS || 2 * words.len() > count {
        return Err(format!("its {} words are as good as different in every row", words.len()));
    }
    Ok((Holds::Word(Words::Recorded(words.into())), values))
}

/// The value that stands for a column where rows have none: its median.
fn usual(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

/// A name as formulas have it: letters, digits and underscores.
fn identifier(name: &str) -> String {
    let plain: String = name.trim().chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    match plain.starts_with(|c: char| c.is_numeric()) {
        true => format!("_{plain}"),
        false => plain,
    }
}

impl Measurements {
    /// Leaves recorded columns out that say again what another coordinate says, or what was observed.
    pub(super) fn leave_echoes_out(&mut self) {
        let own = self.rows.columns.len() - self.recorded.len();
        let mut echoes: Vec<(usize, String)> = Vec::new();
        for (number, coordinate) in self.recorded.iter().enumerate() {
            let x = self.rows.columns[own + number].to_vec();
            let Holds::Quantity(_) = coordinate.holds else { continue };
            let before = self.given.iter().copied().filter(|i| *i < own + number);
            let again = before.filter(|i| *i < own || echoes.iter().all(|(echo, _)| own + echo != *i));
            let same = again.clone().find(|i| correlation(&x, &self.rows.columns[*i].to_vec()) > SAME);
            let of_observable = |s: &&MeasuredObservable| {
                let rows: Vec<usize> = (0..x.len()).filter(|row| self.rows.observable[*row] == s.position).collect();
                let some = |all: &[f64]| rows.iter().map(|row| all[*row]).collect::<Vec<f64>>();
                rows.len() >= FEWEST && correlation(&some(&x), &some(&self.observed)) > FOLLOWS
            };
            let follows = self.observables.iter().find(of_observable);
            if let Some(observable) = follows {
                echoes.push((number, format!("it follows {} itself", observable.name)));
            } else if same.is_some() {
                echoes.push((number, "it says the same as another column".into()));
            }
        }
        for (number, reason) in echoes.into_iter().rev() {
            let name = self.recorded.remove(number).name;
            self.notes.push(format!("the column `{name}` is not used: {reason}"));
            self.rows.columns.remove(own + number);
            self.given.retain(|i| *i != own + number);
            self.given.iter_mut().filter(|i| **i > own + number).for_each(|i| *i -= 1);
        }
    }
}

/// Leaves in each of several files the recorded columns that all of them have, in one order and with the same words.
pub fn keep_shared(files: &mut [Measurements]) {
    let Some((first, others)) = files.split_first() else { return };
    let is_alike = |one: &Coordinate, other: &Coordinate| match (&one.holds, &other.holds) {
        (Holds::Quantity(one), Holds::Quantity(other)) => one.canonical().dimension == other.canonical().dimension,
        (Holds::Word(_), Holds::Word(_)) => true,
        _ => false,
    };
    let has = |file: &Measurements, own: &Coordinate| {
        file.recorded.iter().any(|other| other.name == own.name && is_alike(own, other))
    };
    let is_shared = |own: &&Coordinate| others.iter().all(|file| has(file, own));
    let mut shared: Vec<Coordinate> = first.recorded.iter().filter(is_shared).cloned().collect();
    for coordinate in &mut shared {
        if let Holds::Word(words) = &mut coordinate.holds {
            let of = |file: &Measurements| {
                let own = file.recorded.iter().find(|other| other.name == coordinate.name);
                own.map(|own| own.holds.clone())
            };
            let mut all: Vec<Name> = Vec::new();
            for holds in files.iter().filter_map(of) {
                let Holds::Word(own) = holds else { continue };
                let new: Vec<Name> =
                    own.iter().filter(|word| all.iter().all(|a| a != word)).map(|w| w.to_string().into()).collect();
                all.extend(new);
            }
            *words = Words::Recorded(all.into());
        }
    }
    files.iter_mut().for_each(|file| file.keep_recorded(&shared));
}

impl Measurements {
    /// Keeps these of the recorded columns, in this order; of those that are not there no row has a value.
    pub(crate) fn keep_recorded(&mut self, shared: &[Coordinate]) {
        if self.recorded == shared {
            return;
        }
        let own = self.rows.columns.len() - self.recorded.len();
        let columns = self.rows.columns.split_off(own);
        self.given.retain(|i| *i < own);
        for coordinate in shared {
            let Some(number) = self.recorded.iter().position(|other| other.name == coordinate.name) else {
                self.rows.columns.push(Values::shared(f64::NAN, self.rows.len()));
                continue;
            };
            self.given.push(self.rows.columns.len());
            let column = match (&self.recorded[number].holds, &coordinate.holds) {
                (Holds::Word(from), Holds::Word(to)) => {
                    let word = |value: f64| from.of_value(value).and_then(|word| to.position(word));
                    columns[number].iter().map(|value| word(*value).map_or(f64::NAN, |p| p as f64)).collect()
                }
                _ => columns[number].clone(),
            };
            self.rows.columns.push(column);
        }
        for lost in self.recorded.iter().filter(|other| shared.iter().all(|own| own.name != other.name)) {
            self.notes.push(format!("the column `{}` is not used: not every file has it", lost.name));
        }
        self.recorded = shared.to_vec();
    }
}

/// Size of the correlation of two columns.
fn correlation(x: &[f64], y: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (x0, y0) = (mean(x), mean(y));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for (x, y) in x.iter().zip(y) {
        xx += (x - x0) * (x - x0);
        xy += (x - x0) * (y - y0);
        yy += (y - y0) * (y - y0);
    }
    (xy / (xx * yy).sqrt()).abs()
}
