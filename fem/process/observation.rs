//! Observables of a process, and the coordinates and conditions under which they are observed.

use std::ops::RangeInclusive;

use super::{Values, Words};
use crate::input::Name;
use crate::units::{Kind, LENGTH, MICRO, TEMPERATURE, TEMPERATURE_RISE};

/// A quantity that is predicted and can be measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Observable {
    /// Column name in files.
    pub name: Name,
    /// In a sentence: what effects change.
    pub words: Name,
    /// Its kind, with the unit in which results give it.
    pub kind: Kind,
    /// Difference from the prediction, SI, beyond which readings as a whole are in another unit or of another part.
    pub largest: f64,
    /// Whether a sensor shows it as it is, so that the curve of its characteristic runs over it; what differs from a set
    /// value stands anywhere on the sensor's scale.
    pub is_sensed: bool,
    /// Whether an instrument traces it point by point.
    pub is_traced: bool,
}

impl Observable {
    /// An observable by its column name, what effects change in a sentence, and its kind.
    pub const fn new(name: &'static str, words: &'static str, kind: Kind) -> Self {
        Self::within(name, words, kind, f64::INFINITY)
    }

    /// The same with the difference from the prediction, SI, beyond which readings as a whole are in another unit or of
    /// another part.
    pub const fn within(name: &'static str, words: &'static str, kind: Kind, largest: f64) -> Self {
        Self { name: Name::new(name), words: Name::new(words), kind, largest, is_sensed: false, is_traced: false }
    }

    /// The same, which a sensor shows as it is.
    #[must_use]
    pub const fn sensed(mut self) -> Self {
        self.is_sensed = true;
        self
    }

    /// The same, which an instrument traces point by point: nobody types it, and what stands out is a spike.
    #[must_use]
    pub const fn traced(mut self) -> Self {
        self.is_traced = true;
        self
    }

    /// Whether both tell the same in two ways, as a height and a deviation do; not what sensors show as it is.
    pub fn is_instead_of(&self, other: &Self) -> bool {
        let dimension = |own: &Self| own.kind.canonical().dimension;
        dimension(self) == dimension(other) && !(self.is_sensed && other.is_sensed)
    }

    /// Kind of errors and changes of it: in micrometres those of a length, in kelvins those of a temperature.
    pub fn error_kind(&self) -> Kind {
        match self.kind {
            LENGTH => MICRO,
            TEMPERATURE => TEMPERATURE_RISE,
            kind => kind,
        }
    }
}

/// A column that says where, when or under which conditions something is observed.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    /// Column name in files.
    pub name: Name,
    /// Its meaning, in a few words.
    pub about: &'static str,
    /// Content of the column: a quantity, a number or a word.
    pub holds: Holds,
    /// Default where the column is left out.
    pub absent: Absent,
    /// Whether rows that differ in it alone repeat each other.
    pub repeats: bool,
    /// The observable, by its position, that is the actual value of the coordinate less this commanded one.
    pub actual: Option<usize>,
    /// Name in the field, and explanation, of a curve along it that no law has.
    pub curve: Option<(&'static str, &'static str)>,
    /// Whether it is no coordinate of the process, but a column that a file records beside them: a condition of the day,
    /// a batch, who measured.
    pub is_recorded: bool,
}

impl Coordinate {
    /// A coordinate in which rows that repeat each other agree.
    pub const fn new(name: &'static str, about: &'static str, holds: Holds, absent: Absent) -> Self {
        Self {
            name: Name::new(name),
            about,
            holds,
            absent,
            repeats: false,
            actual: None,
            curve: None,
            is_recorded: false,
        }
    }

    /// A column that a file records beside the coordinates of its process; `usual` (SI) is its value where rows have
    /// none.
    pub fn recorded(name: Name, holds: Holds, usual: f64) -> Self {
        let about = "recorded beside what the process knows";
        Self { name, is_recorded: true, ..Self::new("", about, holds, Absent::Value(usual)) }
    }

    /// Rows that differ in it alone repeat each other.
    #[must_use]
    pub const fn repeating(mut self) -> Self {
        self.repeats = true;
        self
    }

    /// An observable, by its position, is the actual value of the coordinate less this commanded one.
    #[must_use]
    pub const fn of_actual(mut self, observable: usize) -> Self {
        self.actual = Some(observable);
        self
    }

    /// A curve along it that no law has bears this name in the field, and is explained so.
    #[must_use]
    pub const fn with_curve(mut self, name: &'static str, explanation: &'static str) -> Self {
        self.curve = Some((name, explanation));
        self
    }
}

/// Content of a coordinate's column.
#[derive(Clone, Debug, PartialEq)]
pub enum Holds {
    /// A quantity with a unit, kept in SI.
    Quantity(Kind),
    /// A whole number without a unit, from this one on.
    Number(u32),
    /// One of these words, kept as its position among them.
    Word(Words),
}

impl Holds {
    /// One of the words that a process knows.
    pub const fn word(words: &'static [&'static str]) -> Self {
        Self::Word(Words::Known(words))
    }

    /// Kind of the quantity, where it is one.
    pub const fn kind(&self) -> Option<Kind> {
        match self {
            Self::Quantity(kind) => Some(*kind),
            Self::Number(_) | Self::Word(_) => None,
        }
    }
}

/// Default where a column is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Absent {
    /// It must be there.
    Refused,
    /// This value, in SI.
    Value(f64),
    /// The model's value. Such a coordinate is NaN in [`Rows`].
    Model,
    /// It must be there where one of these observables is, by the first and the last of their positions in the process's
    /// list, and is nothing (NaN) where another is.
    NeededBy(usize, usize),
    /// It must be there, but where this observable alone is, of which it is nothing (NaN).
    NeededBut(usize),
    /// The model's value (NaN), of these observables, from the first to the last; of another it is nothing.
    ModelOf(usize, usize),
}

impl Absent {
    /// The observables that alone have the coordinate, if it is not for all.
    pub fn only_of(self) -> Option<RangeInclusive<usize>> {
        match self {
            Self::NeededBy(first, last) | Self::ModelOf(first, last) => Some(first..=last),
            Self::Refused | Self::Value(_) | Self::Model | Self::NeededBut(_) => None,
        }
    }
}

/// Observations to be predicted: values of every coordinate, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// One column per coordinate, in the order of the process's list; SI.
    pub columns: Vec<Values>,
    /// Observable of each row, by its position in the process's list.
    pub observable: Values<usize>,
}

impl Rows {
    /// Rows of these columns.
    pub fn new<V: Into<Values>>(columns: impl IntoIterator<Item = V>, observable: impl Into<Values<usize>>) -> Self {
        Self { columns: columns.into_iter().map(V::into).collect(), observable: observable.into() }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.observable.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.observable.is_empty()
    }

    /// These rows and more.
    #[must_use]
    pub fn and(&self, more: &Self) -> Self {
        // Rows that the process itself proposes have none of what a file records.
        let column =
            |own: &Self, i: usize| own.columns.get(i).cloned().unwrap_or_else(|| Values::shared(f64::NAN, own.len()));
        let both = (0..self.columns.len().max(more.columns.len())).map(|i| (column(self, i), column(more, i)));
        Self {
            columns: both.map(|(a, b)| a.iter().chain(b.iter()).copied().collect()).collect(),
            observable: self.observable.iter().chain(more.observable.iter()).copied().collect(),
        }
    }

    /// Those of these rows, in this order.
    #[must_use]
    pub fn some(&self, rows: &[usize]) -> Self {
        Self {
            columns: self.columns.iter().map(|column| column.some(rows)).collect(),
            observable: self.observable.some(rows),
        }
    }

    /// Coordinate number `column` of row `row`, if the row has one.
    pub fn get(&self, column: usize, row: usize) -> Option<f64> {
        self.columns.get(column).filter(|c| row < c.len()).map(|c| c[row]).filter(|v| !v.is_nan())
    }
}

/// Where measured rows lie on the body, and which way what is observed moves it there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    /// Of each row, m.
    pub points: Vec<[f64; 3]>,
    /// Displacement of the surface per unit of the observable.
    pub directions: Vec<[f64; 3]>,
    /// Coordinate along which the rows of a frame are joined to a line.
    pub along: Vec<f64>,
    /// Value subtracted from the observable before it moves the surface: a set diameter.
    pub references: Vec<f64>,
    /// Value that the rows of a frame have in common, such as the part's number.
    pub frames: Vec<f64>,
}

/// A direction in the space of rows that the way of measuring sets to zero, such as where the centre of a
/// least-squares circle lies. Of unit length, and orthogonal to the others that come with it.
#[derive(Clone, Debug, PartialEq)]
pub struct DatumDirection {
    /// The rows in which it is not zero, from 0.
    pub rows: Vec<usize>,
    /// Its components there.
    pub components: Vec<f64>,
}

impl DatumDirection {
    /// Takes out of `values` (one per row) what lies along the direction.
    pub fn take_out(&self, values: &mut [f64]) {
        let along: f64 = self.rows.iter().zip(&self.components).map(|(row, c)| values[*row] * c).sum();
        for (row, component) in self.rows.iter().zip(&self.components) {
            values[*row] -= along * component;
        }
    }

    /// The direction over so many rows, zero where it has no component.
    pub fn whole(&self, rows: usize) -> Vec<f64> {
        let mut whole = vec![0.0; rows];
        self.rows.iter().zip(&self.components).for_each(|(row, component)| whole[*row] = *component);
        whole
    }
}

/// A further experiment: what could be measured besides.
#[derive(Clone, Debug, PartialEq)]
pub struct CandidateExperiment {
    /// Instruction, as a sentence for the shop.
    pub words: String,
    /// The coordinate that is new.
    pub coordinate: Name,
    /// Its new values, SI.
    pub values: Vec<f64>,
    /// The rows to measure.
    pub rows: Rows,
    /// A count in the model file, by its path, that must be raised to this for the rows to lie in the model: the parts
    /// of a batch.
    pub raises: Option<(&'static str, usize)>,
    /// Time that the machine needs for it, besides the readings, s.
    pub duration: f64,
}

impl CandidateExperiment {
    /// Time of a reading, s: of a diameter with a micrometer, of a place with an indicator.
    const READING: f64 = 60.0;

    /// An experiment with new values of a coordinate.
    pub fn new(words: impl Into<String>, coordinate: &Coordinate, values: impl Into<Vec<f64>>, rows: Rows) -> Self {
        Self {
            words: words.into(),
            coordinate: coordinate.name.clone(),
            values: values.into(),
            rows,
            raises: None,
            duration: 0.0,
        }
    }

    /// The same, for which the machine needs this time, s.
    #[must_use]
    pub fn taking(self, duration: f64) -> Self {
        Self { duration, ..self }
    }

    /// This experiment and then another, as one measurement.
    #[must_use]
    pub fn then(&self, other: &Self) -> Self {
        Self {
            words: format!("{}, then {}", self.words, other.words),
            rows: self.rows.and(&other.rows),
            raises: self.raises.max(other.raises),
            duration: self.duration + other.duration,
            ..self.clone()
        }
    }

    /// The same, where experiments are numbered along a coordinate: the second has the numbers after those of the first.
    #[must_use]
    pub fn then_the_next(&self, other: &Self, numbered: usize) -> Self {
        let numbers = |own: &Self| own.rows.columns[numbered].to_vec();
        let last = numbers(self).into_iter().fold(0.0, f64::max);
        let first = numbers(other).into_iter().fold(f64::INFINITY, f64::min);
        let mut other = other.clone();
        other.rows.columns[numbered] =
            other.rows.columns[numbered].map(|number| number + (last + 1.0 - first).max(0.0));
        self.then(&other)
    }

    /// Time that it costs with each of its rows measured so often, s.
    pub fn cost(&self, repeats: usize) -> f64 {
        self.duration + (repeats * self.rows.len()) as f64 * Self::READING
    }
}

/// A row that the system cannot be asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Misplaced {
    /// Row number, from 0.
    pub row: usize,
    /// Position of the coordinate in the process's list.
    pub coordinate: usize,
    /// Reason, as a sentence.
    pub message: String,
}
