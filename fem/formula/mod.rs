//! Formulas that users write: arithmetic over named quantities, checked for units, with the place of every mistake.
//!
//! `2*a*(1 - exp(-time/tau))*x/1000`: numbers, names, `+ - * / ^`, parentheses, functions and `pi`. `^` binds closer than a sign before it, as on paper:
//! `-x^2` is −(x²).

mod check;
mod parse;

use std::ops::Range;

use crate::units::Dimension;

/// A formula that was read; names are kept by their position in [`Formula::names`].
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Every name that occurs, once.
    pub names: Vec<Name>,
    root: Expression,
}

/// A name in a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// As written.
    pub text: String,
    /// Bytes of its first occurrence.
    pub span: Range<usize>,
}

/// What is wrong with a formula, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct FormulaError {
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: String,
    /// Bytes of the formula.
    pub span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
struct Expression {
    node: Node,
    span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
enum Node {
    Number(f64),
    Name(usize),
    Negative(Box<Expression>),
    Binary(Operator, Box<Expression>, Box<Expression>),
    Call(Function, Vec<Expression>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// What a function does with units.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Units {
    /// Pure numbers in, a pure number out.
    Pure,
    /// What goes in comes out; several must agree.
    Kept,
    /// Several must agree, and a pure number comes out.
    Ratio,
    /// Half of every exponent.
    Root,
}

#[derive(Clone, Copy, Debug)]
struct Function {
    name: &'static str,
    arguments: usize,
    units: Units,
    value: fn(&[f64]) -> f64,
}

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

const fn function(name: &'static str, arguments: usize, units: Units, value: fn(&[f64]) -> f64) -> Function {
    Function { name, arguments, units, value }
}

const FUNCTIONS: &[Function] = &[
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

/// Longer formulas are no laws.
const LONGEST: usize = 4000;

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// The first thing that cannot be read, with its place.
    pub fn parse(text: &str) -> Result<Self, FormulaError> {
        if text.len() > LONGEST {
            let message = format!("the formula has {} characters", text.len());
            return Err(FormulaError { message, help: format!("write it in at most {LONGEST}"), span: 0..text.len() });
        }
        parse::parse(text)
    }

    /// The dimension of the result, when every name has this one.
    ///
    /// # Errors
    /// Units that do not go together, with the place.
    pub fn dimension(&self, of_names: &[Dimension]) -> Result<Dimension, FormulaError> {
        // An angle is a pure number where it is computed with.
        let pure: Vec<Dimension> = of_names.iter().map(|d| d.without_angle()).collect();
        check::dimension(&self.root, &pure).map(|d| d.unwrap_or(Dimension::NONE))
    }

    /// The value, when the names have these (SI).
    pub fn value(&self, of_names: &[f64]) -> f64 {
        self.root.value(of_names)
    }
}

impl Expression {
    fn value(&self, names: &[f64]) -> f64 {
        match &self.node {
            Node::Number(value) => *value,
            Node::Name(i) => names[*i],
            Node::Negative(of) => -of.value(names),
            Node::Binary(operator, a, b) => {
                let (a, b) = (a.value(names), b.value(names));
                match operator {
                    Operator::Add => a + b,
                    Operator::Subtract => a - b,
                    Operator::Multiply => a * b,
                    Operator::Divide => a / b,
                    Operator::Power => a.powf(b),
                }
            }
            Node::Call(function, arguments) => {
                let mut values = [0.0; 2];
                for (value, argument) in values.iter_mut().zip(arguments) {
                    *value = argument.value(names);
                }
                (function.value)(&values)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{FORCE, LENGTH, TIME};

    fn value(text: &str) -> f64 {
        let formula = Formula::parse(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        formula.value(&vec![3.0; formula.names.len()])
    }

    #[test]
    fn arithmetic_is_that_of_paper() {
        for (text, expected) in [
            ("-2^2", -4.0),
            ("2^-2", 0.25),
            ("2^3^2", 512.0),
            ("8/4/2", 1.0),
            ("1 - 2 - 3", -4.0),
            ("-x^2*2", -18.0),
            ("1.5e-3 * 2E3", 3.0),
            ("2*-x", -6.0),
            ("exp(-(x/3)^2)", (-1f64).exp()),
            ("max(0, x - 1) + min(x, 1)", 3.0),
            ("cos(pi)", -1.0),
            ("step(x - 4) + step(x - 3)", 1.0),
            ("mod(x, 2)", 1.0),
        ] {
            assert!((value(text) - expected).abs() < 1e-15, "{text} = {}", value(text));
        }
    }

    #[test]
    fn mistakes_are_found_at_their_places() {
        for (text, at) in [
            ("", 0..0),
            ("2 +", 3..3),
            ("(x", 0..1),
            ("x)", 1..2),
            ("2 x", 2..3),
            ("sine(x)", 0..4),
            ("min(x)", 0..6),
            ("1.2.3", 0..5),
            ("x $ y", 2..3),
            ("sin", 0..3),
        ] {
            assert_eq!(Formula::parse(text).map_err(|e| e.span), Err(at), "{text}");
        }
        // However deep, it is an error and no overflow.
        assert!(Formula::parse(&"(".repeat(100_000)).is_err());
        assert!(Formula::parse(&"-".repeat(100_000)).is_err());
    }

    #[test]
    fn units_must_go_together() {
        let (m, s, n) = (LENGTH.canonical().dimension, TIME.canonical().dimension, FORCE.canonical().dimension);
        let of = |text: &str| {
            let formula = Formula::parse(text)?;
            let dimensions = formula.names.iter().map(|name| match name.text.as_str() {
                "x" | "a" => m,
                "t" | "tau" => s,
                "f" => n,
                _ => Dimension::NONE,
            });
            let dimensions: Vec<Dimension> = dimensions.collect();
            formula.dimension(&dimensions)
        };
        for (text, expected) in [
            ("2*a*(1 - exp(-t/tau))", m),
            ("sqrt(x*a)", m),
            ("x^2/a", m),
            ("max(0, x - a)", m),
            ("a*(f/f)^k", m),
            ("a*step(t - tau)", m),
            ("atan2(x, a)", Dimension::NONE),
        ] {
            assert_eq!(of(text), Ok(expected), "{text}");
        }
        for (text, at) in
            [("x + t", 0..5), ("exp(x)", 0..6), ("x^k", 0..3), ("2^x", 0..3), ("sqrt(x)", 0..7), ("1 + x", 0..5)]
        {
            assert_eq!(of(text).map_err(|e| e.span), Err(at), "{text}");
        }
    }
}
