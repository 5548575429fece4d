//! Report of a run as plain data, before anyone has decided how to write it.

use super::{Coordinate, Drawing, Figure, Frame, Holds, Observable, Rows, Sketch, Values, View, Words};
use crate::input::Name;
use crate::units::{Kind, UnitSymbol};

/// The results of a run, in terms that every output format understands.
#[derive(Default)]
#[non_exhaustive]
pub struct RunReport {
    /// The prediction at every point; a measurement file in itself.
    #[doc(hidden)]
    pub profile: Table,
    /// Further tables, each a CSV file of its name.
    #[doc(hidden)]
    pub tables: Vec<(&'static str, Table)>,
    /// Key results for an engineer, in the order of interest.
    pub figures: Vec<Figure>,
    /// Small pictures of the prediction.
    #[doc(hidden)]
    pub plots: Vec<Plot>,
    /// Contours with magnified deviations, a picture file each.
    #[doc(hidden)]
    pub drawings: Vec<Drawing>,
    /// The machine to scale, if the process has one to draw.
    #[doc(hidden)]
    pub sketch: Option<Sketch>,
    /// Warnings that should not be overlooked, as sentences.
    pub warnings: Vec<String>,
    /// Shapes to play, the part's first.
    #[doc(hidden)]
    pub animations: Vec<Animation>,
}

/// Columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// From left to right.
    pub columns: Vec<Column>,
}

/// A named column of numbers, or of words.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Without the unit.
    pub name: Name,
    /// Unit of the numbers as written; `None` for a label such as a part number.
    pub unit: Option<UnitSymbol>,
    /// In that unit; of words, their positions among them.
    pub values: Vec<f64>,
    /// Words for which the values stand; empty for numbers.
    pub words: Words,
}

impl Table {
    /// Rows with some of their coordinates, by their positions in the process's list, and what was observed
    /// (SI): with every condition written out it reads back as a measurement file.
    pub fn of_rows(
        (coordinates, shown): (&[Coordinate], &[usize]),
        rows: &Rows,
        observable: &Observable,
        observed: &[f64],
    ) -> Self {
        let mut columns: Vec<Column> =
            shown.iter().map(|i| Column::coordinate(&coordinates[*i], &rows.columns[*i])).collect();
        columns.push(Column::quantities(observable.name.clone(), observable.kind, observed));
        Self { columns }
    }
}

impl Column {
    /// Quantities, given in SI.
    pub fn quantities(name: impl Into<Name>, kind: Kind, si: &[f64]) -> Self {
        let unit = kind.canonical();
        let values = si.iter().map(|v| (v - unit.offset) / unit.factor).collect();
        Self::numbers(name, (!kind.unit.is_empty()).then_some(&kind.unit), values)
    }

    /// The values of a coordinate, SI, without the digits that conversion leaves: 1000 mm/min is written as
    /// 1000.
    pub fn coordinate(coordinate: &Coordinate, si: &Values) -> Self {
        let si = si.to_vec();
        match &coordinate.holds {
            Holds::Quantity(kind) => {
                let mut column = Self::quantities(coordinate.name.clone(), *kind, &si);
                column.values.iter_mut().for_each(|v| *v = clean(*v));
                column
            }
            Holds::Number(_) => Self::numbers(coordinate.name.clone(), None, si),
            Holds::Word(words) => Self::words(coordinate.name.clone(), si, words.clone()),
        }
    }

    /// Numbers in a unit, or without one.
    ///
    /// # Panics
    /// The unit is longer than any symbol.
    pub fn numbers(name: impl Into<Name>, unit: Option<&str>, values: Vec<f64>) -> Self {
        Self { name: name.into(), unit: unit.map(UnitSymbol::new), values, words: Words::NONE }
    }

    /// Words, by their positions among all that there are.
    pub fn words(name: impl Into<Name>, values: Vec<f64>, words: Words) -> Self {
        Self { name: name.into(), unit: None, values, words }
    }
}

/// A curve to be drawn in text.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Ordinate and abscissa, with units.
    pub title: String,
    /// Unit of the abscissa.
    pub x_unit: &'static str,
    /// (x, y) in the units of the title, in rising x.
    pub points: Vec<(f64, f64)>,
}

/// A series of frames, made one at a time so that a long one needs no memory.
pub struct Animation {
    /// File stem.
    pub name: &'static str,
    /// The scalar field on the points that colours the bodies.
    pub shown: &'static str,
    /// Name and unit of the frames' time: `time, s`.
    pub time: &'static str,
    /// From where it is looked at.
    pub view: View,
    /// The frame that tells most, for a picture that stands still.
    pub telling: usize,
    /// Displacements magnified further than this are no picture of the body any more: a contour tangles.
    pub most_magnified: f64,
    /// Number of frames.
    pub frames: usize,
    /// Makes frame number i.
    pub frame: Box<dyn Fn(usize) -> Frame + Send + Sync>,
}

impl Animation {
    /// The same with so many frames at most, two or more: evenly spaced, the first, the last and the telling one among them.
    #[must_use]
    pub fn thinned(self, most: usize) -> Self {
        let most = most.max(2);
        if self.frames <= most {
            return self;
        }
        let last = self.frames - 1;
        let mut chosen: Vec<usize> = (0..most).map(|i| (i * last) / (most - 1)).collect();
        let telling = match self.telling {
            0 => 0,
            own if own >= last => most - 1,
            // Two frames are the ends, of which none can be given for it.
            _ if most == 2 => 1,
            own => {
                let next = (1..most - 1).min_by_key(|i| chosen[*i].abs_diff(own)).unwrap_or(1);
                chosen[next] = own;
                next
            }
        };
        let Self { frame, .. } = self;
        Self { telling, frames: most, frame: Box::new(move |i| frame(chosen[i])), ..self }
    }
}

/// A number to 13 digits, half of the last of them going either way. Within the range of whole powers of ten that a
/// double holds exactly the quotient is the double nearest to the digits; columns may have millions of rows.
fn clean(value: f64) -> f64 {
    let shift = 12.0 - value.abs().log10().floor();
    if !(0.0..=22.0).contains(&shift) {
        return format!("{value:.12e}").parse().unwrap_or(value);
    }
    let power = 10f64.powi(shift as i32);
    (value * power).round() / power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_animation_keeps_its_ends_and_the_frame_that_tells_most() {
        let of = |frames: usize, telling: usize, most: usize| {
            let frame = |i: usize| Frame { time: i as f64, ..Frame::default() };
            let own = Animation {
                name: "",
                shown: "",
                time: "",
                view: View::Oblique,
                telling,
                most_magnified: 1.0,
                frames,
                frame: Box::new(frame),
            };
            let own = own.thinned(most);
            let times: Vec<f64> = (0..own.frames).map(|i| (own.frame)(i).time).collect();
            assert!(times.windows(2).all(|two| two[0] < two[1]), "{times:?}");
            (times.len(), times[0], times[own.telling], times[times.len() - 1])
        };
        assert_eq!(of(101, 37, 26), (26, 0.0, 37.0, 100.0));
        assert_eq!(of(101, 100, 26), (26, 0.0, 100.0, 100.0));
        assert_eq!(of(101, 1, 3), (3, 0.0, 1.0, 100.0));
        assert_eq!(of(19, 7, 26), (19, 0.0, 7.0, 18.0));
    }

    #[test]
    fn cleaned_numbers_are_those_of_their_digits() {
        for i in 1..2000 {
            for scale in [1e-9, 1e-3, 0.1, 1.0, 60.0, 1e6, 1e15] {
                let value = -scale * (f64::from(i) * 0.754_877_666).fract() / 3.0;
                let digits: f64 = format!("{value:.12e}").parse().unwrap();
                // Half of the last digit goes either way.
                assert!((clean(value) - digits).abs() <= 1e-12 * digits.abs() * (1.0 + 1e-3), "{value:e}");
            }
        }
        assert_eq!((clean(0.0), clean(999.999_999_999_999_9)), (0.0, 1000.0));
    }
}
