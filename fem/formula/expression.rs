//! Expressions: what a formula is made of, and its value.

use std::ops::Range;

/// A formula that was read; names are kept by their position in [`Formula::names`].
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Every name that occurs, once.
    pub names: Vec<Name>,
    pub(super) root: Expression,
}

/// A name in a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The name as written.
    pub text: String,
    /// Bytes of its first occurrence.
    pub span: Range<usize>,
}

/// A mistake in a formula, with its place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct FormulaError {
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub help: String,
    /// Bytes of the formula.
    pub span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Expression {
    pub(super) node: Node,
    pub(super) span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    Number(f64),
    Name(usize),
    Negative(Box<Expression>),
    Binary(Operator, Box<Expression>, Box<Expression>),
    Call(Function, Vec<Expression>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// The rule by which a function treats units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Units {
    /// Pure numbers in, a pure number out.
    Pure,
    /// The unit of the arguments; several must agree.
    Kept,
    /// Several must agree, and a pure number comes out.
    Ratio,
    /// Half of every exponent.
    Root,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Function {
    pub(super) name: &'static str,
    pub(super) arguments: usize,
    pub(super) units: Units,
    pub(super) value: fn(&[f64]) -> f64,
}

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

const fn function(name: &'static str, arguments: usize, units: Units, value: fn(&[f64]) -> f64) -> Function {
    Function { name, arguments, units, value }
}

pub(super) const FUNCTIONS: &[Function] = &[
    function("sqrt", 1, Units::Root, |v| v[0].sqrt()),
    function("exp", 1, Units::Pure, |v| v[0].exp()),
    function("ln", 1, Units::Pure, |v| v[0].ln()),
    function("log10", 1, Units::Pure, |v| v[0].log10()),
    function("sin", 1, Units::Pure, |v| v[0].sin()),
    function("cos", 1, Units::Pure, |v| v[0].cos()),
    function("tan", 1, Units::Pure, |v| v[0].tan()),
    function("asin", 1, Units::Pure, |v| v[0].asin()),
    function("acos", 1, Units::Pure, |v| v[0].acos()),
    function("atan", 1, Units::Pure, |v| v[0].atan()),
    function("sinh", 1, Units::Pure, |v| v[0].sinh()),
    function("cosh", 1, Units::Pure, |v| v[0].cosh()),
    function("tanh", 1, Units::Pure, |v| v[0].tanh()),
    function("floor", 1, Units::Pure, |v| v[0].floor()),
    function("abs", 1, Units::Kept, |v| v[0].abs()),
    // 1 from zero on, 0 below: what begins somewhere.
    function("step", 1, Units::Ratio, |v| f64::from(u8::from(v[0] >= 0.0))),
    function("min", 2, Units::Kept, |v| v[0].min(v[1])),
    function("max", 2, Units::Kept, |v| v[0].max(v[1])),
    function("mod", 2, Units::Kept, |v| v[0].rem_euclid(v[1])),
    function("atan2", 2, Units::Ratio, |v| v[0].atan2(v[1])),
];

/// Rows that are computed together.
pub const ROWS: usize = 8;

/// Values in some rows.
#[derive(Clone, Copy, Debug)]
pub enum Column {
    /// The same in all.
    Same(f64),
    /// One in each.
    Each([f64; ROWS]),
}

impl Column {
    /// These values, as one where they are the same to the last bit: what depends on them is then computed once.
    pub fn new(values: [f64; ROWS]) -> Self {
        match values.iter().all(|value| value.to_bits() == values[0].to_bits()) {
            true => Self::Same(values[0]),
            false => Self::Each(values),
        }
    }

    /// The value in a row, below [`ROWS`].
    pub fn at(&self, row: usize) -> f64 {
        match self {
            Self::Same(value) => *value,
            Self::Each(values) => values[row],
        }
    }

    fn map(self, of: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Same(value) => Self::Same(of(value)),
            Self::Each(values) => Self::Each(values.map(of)),
        }
    }

    fn with(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        match (self, other) {
            (Self::Same(a), Self::Same(b)) => Self::Same(of(a, b)),
            (a, b) => Self::Each(std::array::from_fn(|row| of(a.at(row), b.at(row)))),
        }
    }
}

impl Operator {
    fn of_both(self, a: Column, b: Column) -> Column {
        a.with(b, |a, b| self.of(a, b))
    }

    fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => a.powf(b),
        }
    }
}

impl Function {
    fn of(self, arguments: &[Expression], names: &[Column]) -> Column {
        let mut values = [Column::Same(0.0); 2];
        for (value, argument) in values.iter_mut().zip(arguments) {
            *value = argument.values(names);
        }
        let [a, b] = values;
        a.with(b, |a, b| (self.value)(&[a, b]))
    }
}

impl Expression {
    pub(super) fn values(&self, names: &[Column]) -> Column {
        match &self.node {
            Node::Number(value) => Column::Same(*value),
            Node::Name(i) => names[*i],
            Node::Negative(of) => of.values(names).map(|value| -value),
            Node::Binary(operator, a, b) => operator.of_both(a.values(names), b.values(names)),
            Node::Call(function, arguments) => function.of(arguments, names),
        }
    }
}
