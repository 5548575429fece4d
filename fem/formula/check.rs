//! Whether the units of a formula go together.

use super::expression::{Expression, FormulaError, Node, Operator, Units};
use crate::units::Dimension;

/// No law has a higher power of a quantity with a unit.
const HIGHEST: f64 = 12.0;

/// The dimension of an expression; `None` for a plain zero, which goes with everything.
pub fn dimension(e: &Expression, names: &[Dimension]) -> Result<Option<Dimension>, FormulaError> {
    match &e.node {
        Node::Number(value) => Ok((*value != 0.0).then_some(Dimension::NONE)),
        Node::Name(i) => Ok(Some(names[*i])),
        Node::Negative(of) => dimension(of, names),
        Node::Binary(operator, a, b) => {
            let (left, right) = (dimension(a, names)?, dimension(b, names)?);
            binary(e, *operator, left, right, b)
        }
        Node::Call(function, arguments) => {
            let all: Vec<Option<Dimension>> =
                arguments.iter().map(|a| dimension(a, names)).collect::<Result<_, _>>()?;
            match function.units {
                Units::Pure => match all.iter().flatten().find(|d| **d != Dimension::NONE) {
                    Some(d) => Err(wrong(
                        e,
                        format!("`{}` of a quantity in {d}", function.name),
                        "it takes a pure number: divide by another of the same kind",
                    )),
                    None => Ok(Some(Dimension::NONE)),
                },
                Units::Kept => agree(e, &all),
                Units::Ratio => agree(e, &all).map(|_| Some(Dimension::NONE)),
                Units::Root => match all[0].map(Dimension::root) {
                    Some(None) => {
                        Err(wrong(e, "the root of this has no unit".into(), "take the root of an even power"))
                    }
                    Some(root) => Ok(root),
                    None => Ok(None),
                },
            }
        }
    }
}

fn binary(
    e: &Expression,
    operator: Operator,
    left: Option<Dimension>,
    right: Option<Dimension>,
    exponent: &Expression,
) -> Result<Option<Dimension>, FormulaError> {
    let overflow = || wrong(e, "the unit of this is beyond measure".into(), "write it with smaller powers");
    let pure = |d: Option<Dimension>| d.unwrap_or(Dimension::NONE);
    match operator {
        Operator::Add | Operator::Subtract => agree(e, &[left, right]),
        Operator::Multiply => pure(left).times(pure(right)).map(Some).ok_or_else(overflow),
        Operator::Divide => pure(left).over(pure(right)).map(Some).ok_or_else(overflow),
        Operator::Power => {
            if pure(right) != Dimension::NONE {
                let message = format!("an exponent in {}", pure(right));
                return Err(wrong(e, message, "an exponent is a pure number: divide it by another of its kind"));
            }
            match left.filter(|d| *d != Dimension::NONE) {
                None => Ok(Some(Dimension::NONE)),
                Some(base) => {
                    let refuse = |power: String| {
                        let message = format!("a quantity in {base} to a power {power}");
                        wrong(e, message, "divide by another of the same kind first: (f/f0)^n")
                    };
                    let n = whole(exponent).ok_or_else(|| refuse("that is no whole number".into()))?;
                    let power = (n.abs() <= HIGHEST).then(|| base.to_the(n as i8)).flatten();
                    power.map(Some).ok_or_else(|| refuse(format!("beyond {HIGHEST}")))
                }
            }
        }
    }
}

/// A whole number that is written as such.
fn whole(e: &Expression) -> Option<f64> {
    match &e.node {
        Node::Number(n) if n.fract() == 0.0 => Some(*n),
        Node::Negative(of) => whole(of).map(|n| -n),
        _ => None,
    }
}

/// All of the same dimension; zeros go with any.
fn agree(e: &Expression, all: &[Option<Dimension>]) -> Result<Option<Dimension>, FormulaError> {
    let mut known = all.iter().flatten();
    let Some(first) = known.next() else { return Ok(None) };
    match known.find(|d| *d != first) {
        Some(other) => {
            let message = format!("a quantity in {first} meets one in {other}");
            Err(wrong(e, message, "both must be of one kind; a pure number is in 1"))
        }
        None => Ok(Some(*first)),
    }
}

fn wrong(e: &Expression, message: String, help: &str) -> FormulaError {
    FormulaError { message, help: help.into(), span: e.span.clone() }
}
