//! Pieces of which answers are made for people. Text and page lay out the same ones.

use super::number;
use crate::process::Plot;

/// A piece of an answer.
pub enum Block {
    /// Lines that are laid out already, which text alone shows.
    Lines(String),
    /// Something to be read before the rest is believed.
    Caution(String),
    /// A heading of the blocks below it.
    Heading(String),
    /// A sentence without its capital and its full stop.
    Sentence(String),
    /// The same by itself, wrapped where it is longer than a line.
    Paragraph(String),
    /// Items of equal weight.
    List(Vec<String>),
    /// Items behind their shares or names.
    Labelled(Vec<(String, String)>),
    /// Entries behind labels of one width, wrapped; one without a label belongs to the label before.
    Entries(Vec<(String, String)>),
    /// Cells in columns.
    Table(Table),
    /// Commands to go on with, and remarks between them.
    Commands(Vec<String>),
    /// A curve in characters; the page has charts instead.
    Curve(Plot),
}

/// Cells in columns.
pub struct Table {
    /// Caption on the page; text says it around the table.
    pub caption: String,
    /// The columns, that of the names first.
    pub columns: Vec<Column>,
    /// The rows, each with as many cells as columns or fewer.
    pub rows: Vec<Vec<Cell>>,
    /// Whether the order of the rows means nothing.
    pub is_sortable: bool,
}

/// A column of a table.
pub struct Column {
    /// Heading.
    pub name: String,
    /// Characters that it takes in text; `None` if as many as its widest cell.
    pub width: Option<usize>,
    /// Whether it holds remarks on the row, apart from the numbers.
    pub is_remark: bool,
}

/// A cell of a table.
pub enum Cell {
    /// Words.
    Text(String),
    /// A number as it is written, and its value, by which rows are sorted.
    Number(String, f64),
    /// A number that is not there.
    Missing,
}

impl Table {
    /// A table whose order means something.
    pub fn new(columns: impl IntoIterator<Item = Column>, rows: impl IntoIterator<Item = Vec<Cell>>) -> Self {
        let (columns, rows) = (columns.into_iter().collect(), rows.into_iter().collect());
        Self { caption: String::new(), columns, rows, is_sortable: false }
    }
}

impl Column {
    /// A column of so many characters.
    pub fn new(name: impl Into<String>, width: usize) -> Self {
        Self { name: name.into(), width: Some(width), is_remark: false }
    }

    /// A column as wide as its cells.
    pub fn wide(name: impl Into<String>) -> Self {
        Self { name: name.into(), width: None, is_remark: false }
    }

    /// A column of remarks.
    pub fn remark(name: impl Into<String>, width: usize) -> Self {
        Self { is_remark: true, ..Self::new(name, width) }
    }
}

impl Cell {
    /// A number with three decimals.
    pub fn number(value: f64) -> Self {
        Self::Number(format!("{value:.3}"), value)
    }

    /// A number with three decimals and its sign.
    pub fn signed(value: f64) -> Self {
        Self::Number(number::signed(value, 3), value)
    }

    /// A number with three decimals, if it is one.
    pub fn finite(value: f64) -> Self {
        if value.is_finite() { Self::Number(number::fixed(value, 3), value) } else { Self::Missing }
    }
}
