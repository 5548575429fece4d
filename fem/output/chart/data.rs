//! Charts as plain data, in the units of their axes.

use super::number::number;

/// A figure with its axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// File stem.
    pub name: String,
    /// Subject of the figure, in a few words.
    pub title: String,
    /// Key to dots, lines and bars.
    pub note: String,
    /// The plane and what lies in it.
    pub plane: Plane,
}

/// Coordinate system of a chart, with the data in it.
#[derive(Clone, Debug, PartialEq)]
pub enum Plane {
    /// Curves over an axis.
    Curves {
        /// Abscissa.
        x: Axis,
        /// Ordinate.
        y: Axis,
        /// From the back to the front.
        series: Vec<Series>,
    },
    /// Deviations from a circle; the abscissa is the angle in degrees.
    Polar {
        /// Of the deviation, outwards positive.
        y: Axis,
        /// From the back to the front.
        series: Vec<Series>,
    },
    /// A value over two axes.
    Map {
        /// Abscissa.
        x: Axis,
        /// Ordinate.
        y: Axis,
        /// Quantity that the colours show; limits about zero make it a scale of two colours.
        value: Axis,
        /// Abscissa, ordinate and value, in any order.
        cells: Vec<[f64; 3]>,
    },
}

/// An axis with its unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// Name of the quantity along it.
    pub name: String,
    /// Unit; empty for a pure number.
    pub unit: String,
    /// Words that stand for the values 0, 1, …; empty where they are numbers.
    pub words: Vec<String>,
    /// Ends, where they do not follow from what is drawn.
    pub limits: Option<(f64, f64)>,
}

/// A series of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Written beside its end; empty for none.
    pub label: String,
    /// Number of its colour.
    pub colour: usize,
    /// Form in which it is drawn.
    pub form: Form,
    /// Points in their order.
    pub points: Vec<Point>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A line.
    Line,
    /// A broken line.
    Dashed,
    /// A line in the background.
    Faint,
    /// Dots, with bars where their uncertainty is known.
    Dots,
    /// The area between y − u and y + u.
    Band,
}

/// A point of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Abscissa, in the unit of its axis.
    pub x: f64,
    /// Ordinate.
    pub y: f64,
    /// Half of the length of the bar; NaN for none.
    pub u: f64,
}

impl Series {
    /// A series with what is written beside its end.
    pub fn new(label: impl Into<String>, colour: usize, form: Form, points: Vec<Point>) -> Self {
        Self { label: label.into(), colour, form, points }
    }
}

impl Point {
    /// A point without a bar.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y, u: f64::NAN }
    }

    /// Lower and upper end of the bar, or the point itself twice.
    pub fn ends(&self) -> [f64; 2] {
        let u = if self.u.is_finite() { self.u } else { 0.0 };
        [self.y - u, self.y + u]
    }
}

impl Axis {
    /// An axis of numbers.
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { name: name.into(), unit: unit.into(), ..Self::default() }
    }

    /// The name with its unit: `x [mm]`.
    pub fn label(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }

    /// Formats a value with its unit, or as the word that it stands for.
    pub fn format(&self, value: f64) -> String {
        match self.words.get(value as usize) {
            Some(word) => word.clone(),
            None => format!("{} {}", number(value), self.unit).trim_end().to_string(),
        }
    }
}
