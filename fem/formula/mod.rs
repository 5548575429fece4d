//! Formulas that users write: arithmetic over named quantities, checked for units, with the place of every
//! mistake.
//!
//! `2*a*(1 - exp(-time/tau))*x/1000`: numbers, names, `+ - * / ^`, parentheses, functions and `pi`. `^` binds
//! closer than a sign before it, as on paper: `-x^2` is −(x²).

mod check;
mod expression;
mod parse;

pub use expression::{Column, Formula, FormulaError, Name, ROWS};

use crate::units::Dimension;

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
        let of_names: Vec<Column> = of_names.iter().map(|value| Column::Same(*value)).collect();
        self.values(&of_names).at(0)
    }

    /// The values in some rows, when the names have these (SI).
    pub fn values(&self, of_names: &[Column]) -> Column {
        self.root.values(of_names)
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

    /// Row by row the same to the last bit, whether a name is the same in all of them or not.
    #[test]
    fn rows_are_computed_as_each_by_itself() {
        let text = "-a*exp(-x/tau)^1.3 + atan2(x, tau)/(1 + mod(x*a, 3)) - max(tau, a)";
        let formula = Formula::parse(text).unwrap();
        let x: [f64; ROWS] = std::array::from_fn(|i| (0.7 * i as f64 - 2.0).sin());
        for names in [
            [Column::Same(1.3), Column::new(x), Column::Same(0.4)],
            [Column::new(x), Column::Same(-0.2), Column::new(x)],
        ] {
            let together = formula.values(&names);
            for row in 0..ROWS {
                let alone = formula.value(&names.map(|name| name.at(row)));
                assert_eq!(together.at(row).to_bits(), alone.to_bits(), "row {row}");
            }
        }
        // What names nothing that differs is computed once.
        assert!(matches!(formula.values(&[0.5; 3].map(|own| Column::new([own; ROWS]))), Column::Same(_)));
        // A sum of as many terms as a formula has room for is no overflow.
        let sum = Formula::parse(&vec!["x"; 2000].join("+")).unwrap();
        assert_eq!(sum.values(&[Column::new(x)]).at(1), (0..1999).fold(x[1], |sum, _| sum + x[1]));
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
