//! A value with its unit and its uncertainty.

use super::{Kind, UnitError};

/// Knowledge of a value, as its writer says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Knowledge {
    /// `"60 N/um"`: never changed by a fit.
    Known,
    /// `"60 +- 15 N/um"`: known with this standard uncertainty (SI), a prior for a fit.
    Rough(f64),
    /// `"? N/um"`, or `"? near 60 N/um"` where a search begins: unknown, to be fitted.
    Free,
}

/// A value in SI units with the knowledge of it. The value of a [`Knowledge::Free`] quantity is the place
/// where a search for it begins; NaN where none is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Value in SI units.
    pub value: f64,
    /// Known, roughly known or free.
    pub knowledge: Knowledge,
}

/// The word after `?` before the place where a search begins.
const NEAR: &str = "near ";

impl Quantity {
    /// A value that is known.
    pub fn known(value: f64) -> Self {
        Self { value, knowledge: Knowledge::Known }
    }

    /// Reads `NUMBER UNIT`, `NUMBER +- NUMBER UNIT` (or `±`), `? UNIT` or `? near NUMBER UNIT`.
    ///
    /// # Errors
    /// Not a finite number, a unit of another kind, or a standard uncertainty that is not positive.
    #[doc(hidden)]
    pub fn parse(text: &str, kind: &Kind) -> Result<Self, UnitError> {
        let text = text.trim();
        if let Some(rest) = text.strip_prefix('?') {
            let Some(near) = rest.trim_start().strip_prefix(NEAR) else {
                kind.unit_of(rest)?;
                return Ok(Self { value: f64::NAN, knowledge: Knowledge::Free });
            };
            let (value, rest) = number(near.trim_start(), kind)?;
            let unit = kind.unit_of(rest)?;
            return Ok(Self { value: finite(value * unit.factor + unit.offset)?, knowledge: Knowledge::Free });
        }
        let (value, rest) = number(text, kind)?;
        let uncertain = rest.strip_prefix("+-").or_else(|| rest.strip_prefix("±")).or_else(|| rest.strip_prefix("+/-"));
        let Some(rest) = uncertain else {
            let unit = kind.unit_of(rest)?;
            return finite(value * unit.factor + unit.offset).map(Self::known);
        };
        let (std, rest) = number(rest.trim_start(), kind)?;
        let unit = kind.unit_of(rest)?;
        if std <= 0.0 {
            return Err(UnitError::new(format!("the standard uncertainty after `+-` is {std}"))
                .hint("it must be above zero; leave it out if the value is known"));
        }
        let value = finite(value * unit.factor + unit.offset)?;
        Ok(Self { value, knowledge: Knowledge::Rough(finite(std * unit.factor)?) })
    }
}

/// The text behind the numbers of a written quantity: its unit.
pub fn unit_text(written: &str) -> &str {
    let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | '±' | '?' | ' ' | '/');
    let mut rest = written.trim();
    rest = rest.strip_prefix('?').and_then(|r| r.trim_start().strip_prefix(NEAR)).unwrap_or(rest);
    loop {
        rest = rest.trim_start_matches(number);
        // An exponent, not a unit: `1.5e3 N/um`.
        match rest.strip_prefix(['e', 'E']) {
            Some(after) if after.starts_with(|c: char| c.is_ascii_digit() || c == '+' || c == '-') => rest = after,
            _ => break,
        }
    }
    // A unit may begin with a slash: `/K`.
    let start = written.len() - rest.len();
    if written[..start].ends_with('/') && !rest.is_empty() { &written[start - 1..] } else { rest }
}

/// Splits a leading number off `text`.
fn number<'a>(text: &'a str, kind: &Kind) -> Result<(f64, &'a str), UnitError> {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let (byte, before) = (bytes[end], if end == 0 { b' ' } else { bytes[end - 1] });
        let exponent = matches!(byte, b'e' | b'E')
            && before.is_ascii_digit()
            && bytes.get(end + 1).is_some_and(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-'));
        // `5+-1 um`: the sign belongs to the uncertainty, not to the number before it.
        let sign = matches!(byte, b'+' | b'-') && (end == 0 || matches!(before, b'e' | b'E'));
        if !(byte.is_ascii_digit() || byte == b'.' || exponent || sign) {
            break;
        }
        end += 1;
    }
    let expected = || match &*kind.unit {
        "" => format!("a number such as `{}`", kind.example()),
        _ => format!("a number and a unit, such as `{}`", kind.example()),
    };
    let (digits, rest) = text.split_at(end);
    if rest.starts_with(',') {
        return Err(UnitError::new("the decimal mark is a comma").hint("write a decimal point: `0.5`, not `0,5`"));
    }
    let value: f64 = digits.parse().map_err(|_| {
        UnitError::new(format!("`{text}` does not begin with a number")).hint(format!("write {}", expected()))
    })?;
    Ok((finite(value)?, rest.trim_start()))
}

/// Largest number that is computed with, in SI units: powers and squares of what follows from it stay finite.
pub const LARGEST: f64 = 1e40;

fn finite(value: f64) -> Result<f64, UnitError> {
    if value.abs() <= LARGEST {
        Ok(value)
    } else {
        Err(UnitError::new("the number is too large to be computed with")
            .hint("no quantity of a workshop is beyond 1e40: is the exponent or the unit right?"))
    }
}

#[cfg(test)]
mod tests {
    use super::super::*;
    use super::*;

    #[test]
    fn units_are_found_behind_every_kind_of_number() {
        for (written, unit) in [
            ("60 +- 15 N/um", "N/um"),
            ("? min", "min"),
            ("1.5e3 +- 2e1 kN/mm", "kN/mm"),
            ("?", ""),
            ("11e-6 +- 1e-6 /K", "/K"),
            ("0.5 ± 0.1", ""),
        ] {
            assert_eq!(unit_text(written), unit, "{written}");
        }
    }

    #[test]
    fn quantities_are_read_in_any_unit_and_spelling() {
        let rough = |value, std| Quantity { value, knowledge: Knowledge::Rough(std) };
        let cases = [
            ("60 N/um", STIFFNESS, Quantity::known(60e6)),
            ("60N/um", STIFFNESS, Quantity::known(60e6)),
            ("6e1 kN/mm", STIFFNESS, Quantity::known(60e6)),
            ("60 +- 15 N/um", STIFFNESS, rough(60e6, 15e6)),
            ("60+-15N/um", STIFFNESS, rough(60e6, 15e6)),
            ("60 ± 15 N/µm", STIFFNESS, rough(60e6, 15e6)),
            ("-1.5e-3 m", LENGTH, Quantity::known(-1.5e-3)),
            ("0.5", NUMBER, Quantity::known(0.5)),
            ("0.5 +- 0.1", NUMBER, rough(0.5, 0.1)),
            ("11.5e-6 /K", EXPANSION, Quantity::known(11.5e-6)),
            ("2 um/N^n", CONTACT_COEFFICIENT, Quantity::known(2e-6)),
        ];
        for (text, kind, expected) in cases {
            let read = Quantity::parse(text, &kind).unwrap();
            assert!((read.value - expected.value).abs() <= 1e-15 * expected.value.abs(), "{text}: {read:?}");
            match (read.knowledge, expected.knowledge) {
                (Knowledge::Rough(a), Knowledge::Rough(b)) => assert!((a / b - 1.0).abs() < 1e-14, "{text}"),
                (a, b) => assert_eq!(a, b, "{text}"),
            }
        }
        assert_eq!(Quantity::parse("? N/um", &STIFFNESS).unwrap().knowledge, Knowledge::Free);
        assert_eq!(Quantity::parse("?", &NUMBER).unwrap().knowledge, Knowledge::Free);
        let near = Quantity::parse("? near 60 N/um", &STIFFNESS).unwrap();
        assert_eq!(near, Quantity { value: 60e6, knowledge: Knowledge::Free });
        assert_eq!(unit_text("? near 60 N/um"), "N/um");
    }

    #[test]
    fn what_is_no_quantity_is_refused() {
        for (text, kind, part) in [
            ("60", STIFFNESS, "unit is missing"),
            ("20", SLOPE, "unit is missing"),
            ("8", WEAR_RATE, "unit is missing"),
            ("?", WEAR_RATE, "unit is missing"),
            ("60 N", STIFFNESS, "measures a force"),
            ("60 Nm/um", STIFFNESS, "measures a force"),
            ("60 Nn/um", STIFFNESS, "no unit"),
            ("abc", LENGTH, "does not begin with a number"),
            ("", LENGTH, "does not begin with a number"),
            ("nan mm", LENGTH, "does not begin with a number"),
            ("inf mm", LENGTH, "does not begin with a number"),
            ("1e400 mm", LENGTH, "too large"),
            ("1e308 km", LENGTH, "too large"),
            ("1,5 mm", LENGTH, "comma"),
            ("5 +- -1 mm", LENGTH, "standard uncertainty"),
            ("5 +- 0 mm", LENGTH, "standard uncertainty"),
            ("0.2 mm", FEED, "not a feed per revolution"),
            ("600 Hz", SPINDLE_SPEED, "not a spindle speed"),
            ("0.5 mm", NUMBER, "not a pure number"),
        ] {
            let error = Quantity::parse(text, &kind).unwrap_err();
            assert!(error.message.contains(part), "{text}: {}", error.message);
        }
    }
}
