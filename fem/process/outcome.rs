//! What a run gives, before anyone has decided how to write it.

use serde_json::Value as Json;

use super::{Drawing, Frame};

/// The results of a run, in terms that every output format understands.
pub struct Outcome {
    /// The prediction at every point; a measurement file in itself.
    pub profile: Table,
    /// Further tables, each a CSV file of its name.
    pub tables: Vec<(&'static str, Table)>,
    /// What an engineer wants to know, in the order of interest.
    pub findings: Vec<Finding>,
    /// Small pictures of the prediction.
    pub plots: Vec<Plot>,
    /// Contours with magnified deviations, a picture file each.
    pub drawings: Vec<Drawing>,
    /// What should not be overlooked.
    pub warnings: Vec<String>,
    /// Shapes to play, if the process has any.
    pub animation: Option<Animation>,
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
    pub name: &'static str,
    /// Unit of the numbers as written; `None` for a label such as a part number.
    pub unit: Option<&'static str>,
    /// In that unit; of words, their positions among them.
    pub values: Vec<f64>,
    /// What the values stand for, where they are words; empty for numbers.
    pub words: &'static [&'static str],
}

impl Column {
    /// Numbers in a unit, or without one.
    pub fn numbers(name: &'static str, unit: Option<&'static str>, values: Vec<f64>) -> Self {
        Self { name, unit, values, words: &[] }
    }

    /// Words, by their positions among all that there are.
    pub fn words(name: &'static str, values: Vec<f64>, words: &'static [&'static str]) -> Self {
        Self { name, unit: None, values, words }
    }
}

/// One thing a run has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Key in JSON.
    pub key: &'static str,
    /// In front of the text.
    pub label: &'static str,
    /// For people.
    pub text: String,
    /// For programs.
    pub json: Json,
}

/// A curve to be drawn in text.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What is drawn over what, with units.
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
    /// Number of frames.
    pub frames: usize,
    /// Makes frame number i.
    pub frame: Box<dyn Fn(usize) -> Frame + Send + Sync>,
}
