//! Figures of a report: what a run found, as quantities in SI and sentences about them. JSON, units and
//! layout are made of them in `output`.

use std::borrow::Cow;

use super::{Coordinate, Holds, Observable, Rows};
use crate::units::{ANGLE, Kind, UnitSymbol};

/// One thing that a run has found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Figure {
    /// Key in JSON.
    pub key: &'static str,
    /// In front of the text.
    pub label: Cow<'static, str>,
    /// For people, line by line; quantities in them are written by [`Kind::shown`].
    pub lines: Vec<String>,
    /// For programs, in their order.
    #[doc(hidden)]
    pub entries: Vec<(Cow<'static, str>, Datum)>,
    /// Keys under which the units of the entries are told. Where a unit has none here, it is told as `unit`
    /// if it is the first of the figure, else as `KEY_unit`, KEY being the first entry that has it.
    pub unit_keys: Vec<(&'static str, Kind)>,
}

/// A value of a figure.
#[derive(Clone, Debug, PartialEq)]
pub enum Datum {
    /// A quantity in SI, told in the unit of its kind. What is not finite is unknown.
    Quantity(Kind, f64),
    /// Several quantities of a kind.
    Quantities(Kind, Vec<f64>),
    /// A pure number; what is not finite is unknown.
    Number(f64),
    /// How many.
    Count(usize),
    /// Yes or no.
    Flag(bool),
    /// A word.
    Word(Cow<'static, str>),
    /// Unknown, or not there.
    Missing,
    /// Values of their own.
    Record(Vec<(Cow<'static, str>, Datum)>),
    /// Several alike.
    List(Vec<Datum>),
}

impl Figure {
    /// A figure that says nothing yet.
    pub fn new(key: &'static str, label: impl Into<Cow<'static, str>>) -> Self {
        Self { key, label: label.into(), lines: Vec::new(), entries: Vec::new(), unit_keys: Vec::new() }
    }

    /// With a line for people.
    #[must_use]
    pub fn line(mut self, line: impl Into<String>) -> Self {
        self.lines.push(line.into());
        self
    }

    /// With lines for people.
    #[must_use]
    pub fn lines(mut self, lines: impl IntoIterator<Item = String>) -> Self {
        self.lines.extend(lines);
        self
    }

    /// With a value for programs.
    #[must_use]
    #[doc(hidden)]
    pub fn entry(mut self, key: impl Into<Cow<'static, str>>, datum: impl Into<Datum>) -> Self {
        self.entries.push((key.into(), datum.into()));
        self
    }

    /// With a quantity (SI) for programs.
    #[must_use]
    pub fn quantity(self, key: impl Into<Cow<'static, str>>, kind: Kind, si: f64) -> Self {
        self.entry(key, Datum::Quantity(kind, si))
    }

    /// With the unit of `kind` told under a key of its own.
    #[must_use]
    pub fn unit(mut self, key: &'static str, kind: Kind) -> Self {
        self.unit_keys.push((key, kind));
        self
    }

    /// A number by its path, `key` or `/list/0/step`, in the unit of its kind.
    pub fn value_at(&self, path: &str) -> Option<f64> {
        match self.datum(path)? {
            Datum::Quantity(kind, si) => Some(kind.from_si(si)),
            Datum::Number(number) => Some(number),
            Datum::Count(count) => Some(count as f64),
            _ => None,
        }
    }

    /// A value by its path, as [`Self::value_at`] takes it.
    #[doc(hidden)]
    pub fn datum(&self, path: &str) -> Option<Datum> {
        let mut steps = path.trim_start_matches('/').split('/');
        let first = steps.next()?;
        let start = &self.entries.iter().find(|(key, _)| key == first)?.1;
        let mut rest = steps.peekable();
        let mut datum = start;
        while let Some(step) = rest.next() {
            datum = match datum {
                Datum::Record(entries) => &entries.iter().find(|(key, _)| key == step)?.1,
                Datum::List(list) => list.get(step.parse::<usize>().ok()?)?,
                Datum::Quantities(kind, values) if rest.peek().is_none() => {
                    return values.get(step.parse::<usize>().ok()?).map(|si| Datum::of(*kind, *si));
                }
                _ => return None,
            };
        }
        Some(datum.clone())
    }
}

impl Datum {
    /// A quantity in SI.
    pub fn of(kind: Kind, si: f64) -> Self {
        Self::Quantity(kind, si)
    }

    /// A quantity in SI, if it is there.
    pub fn maybe(kind: Kind, si: Option<f64>) -> Self {
        si.map_or(Self::Missing, |si| Self::Quantity(kind, si))
    }

    /// Values of their own.
    pub fn record<const N: usize>(entries: [(&'static str, Datum); N]) -> Self {
        Self::Record(entries.into_iter().map(|(key, datum)| (key.into(), datum)).collect())
    }
}

impl From<f64> for Datum {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Datum {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<bool> for Datum {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl From<&'static str> for Datum {
    fn from(word: &'static str) -> Self {
        Self::Word(word.into())
    }
}

impl From<UnitSymbol> for Datum {
    fn from(symbol: UnitSymbol) -> Self {
        Self::Word(String::from(symbol).into())
    }
}

impl From<String> for Datum {
    fn from(word: String) -> Self {
        Self::Word(word.into())
    }
}

impl<T: Into<Datum>> From<Option<T>> for Datum {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}

/// The least and the greatest of some values; infinite the wrong way round of none.
pub fn range(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

/// The greatest less the least.
pub fn spread(values: &[f64]) -> f64 {
    let (low, high) = range(values.iter().copied());
    high - low
}

/// Position of the value that `beats` all others by more than round-off: of equal ones the first; 0 of none.
pub fn first_extreme(values: &[f64], beats: fn(&f64, &f64) -> bool) -> usize {
    let scale = values.iter().fold(0.0f64, |size, v| size.max(v.abs()));
    let better = |best: usize, i: usize| {
        let apart = (values[i] - values[best]).abs() > 1e-9 * scale;
        if apart && beats(&values[i], &values[best]) { i } else { best }
    };
    (0..values.len()).reduce(better).unwrap_or(0)
}

/// The largest and the smallest of an observable's values (SI, one per row), with the coordinates of their
/// rows that are to be told, by their positions in the process's list.
pub fn extremes(
    what: &str,
    observable: &Observable,
    (coordinates, told): (&[Coordinate], &[usize]),
    rows: &Rows,
    values: &[f64],
) -> Vec<Figure> {
    let figure = |key, word: &str, beats| {
        let row = first_extreme(values, beats);
        let kind = observable.error_kind();
        let mut figure = Figure::new(key, format!("{word} {what}")).quantity("value", kind, values[row]);
        let mut at = Vec::new();
        for &column in told {
            let (coordinate, value) = (&coordinates[column], rows.columns[column][row]);
            let (datum, words) = match &coordinate.holds {
                Holds::Quantity(kind) => (Datum::of(*kind, value), format!("{:.1}", kind.shown(value))),
                Holds::Number(_) => (Datum::Count(value as usize), format!("{} {value}", coordinate.name)),
                Holds::Word(words) => {
                    let word = words.of_value(value).unwrap_or_default();
                    (Datum::from(word.to_string()), word.to_string())
                }
            };
            // Degrees need no name.
            let is_named = matches!(coordinate.holds, Holds::Quantity(kind) if kind != ANGLE);
            at.push(if is_named { format!("{} = {words}", coordinate.name) } else { words });
            figure = figure.entry(coordinate.name.clone(), datum);
        }
        figure.line(format!("{:+.3} at {}", kind.shown(values[row]), at.join(", ")))
    };
    vec![figure("largest", "largest", f64::gt), figure("smallest", "smallest", f64::lt)]
}
