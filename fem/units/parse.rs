//! Reading of unit expressions.

use super::spelling::{self, MARKS};
use super::{Dimension, Unit, UnitError};

/// A named unit: name, SI units per unit, exponents over m, kg, s, K, rad, and the SI prefixes that are in use with it: of
/// the others a word of another language, `Grad`, would be a unit nobody measures in.
struct Named(&'static str, f64, [i8; 5], &'static [&'static str]);

const PI: f64 = std::f64::consts::PI;

/// Every unit a file may use. Inch, pound-force and psi are exact by definition.
const UNITS: &[Named] = &[
    Named("m", 1.0, [1, 0, 0, 0, 0], &["p", "n", "u", "m", "c", "d", "k"]),
    Named("g", 1e-3, [0, 1, 0, 0, 0], &["u", "m", "k"]),
    Named("s", 1.0, [0, 0, 1, 0, 0], &["n", "u", "m"]),
    Named("K", 1.0, [0, 0, 0, 1, 0], &["m", "k"]),
    Named("rad", 1.0, [0, 0, 0, 0, 1], &["n", "u", "m"]),
    Named("N", 1.0, [1, 1, -2, 0, 0], &["u", "m", "c", "d", "da", "k", "M", "G"]),
    Named("Pa", 1.0, [-1, 1, -2, 0, 0], &["m", "h", "k", "M", "G", "T"]),
    Named("J", 1.0, [2, 1, -2, 0, 0], &["n", "u", "m", "k", "M", "G"]),
    // The calorie of the International Table, as old handbooks of engineering have it.
    Named("cal", 4.1868, [2, 1, -2, 0, 0], &["k"]),
    Named("W", 1.0, [2, 1, -3, 0, 0], &["n", "u", "m", "k", "M"]),
    Named("Hz", 1.0, [0, 0, -1, 0, 0], &["m", "k", "M", "G"]),
    Named("bar", 1e5, [-1, 1, -2, 0, 0], &["u", "m"]),
    Named("min", 60.0, [0, 0, 1, 0, 0], &[]),
    Named("h", 3600.0, [0, 0, 1, 0, 0], &[]),
    Named("deg", PI / 180.0, [0, 0, 0, 0, 1], &["m"]),
    Named("°", PI / 180.0, [0, 0, 0, 0, 1], &[]),
    Named("gon", PI / 200.0, [0, 0, 0, 0, 1], &["m"]),
    Named("arcmin", PI / 10_800.0, [0, 0, 0, 0, 1], &[]),
    Named("arcsec", PI / 648_000.0, [0, 0, 0, 0, 1], &[]),
    Named("rev", 2.0 * PI, [0, 0, 0, 0, 1], &[]),
    Named("rpm", PI / 30.0, [0, 0, -1, 0, 1], &[]),
    Named("degC", 1.0, [0, 0, 0, 1, 0], &[]),
    Named("°C", 1.0, [0, 0, 0, 1, 0], &[]),
    Named("℃", 1.0, [0, 0, 0, 1, 0], &[]),
    Named("ppm", 1e-6, [0, 0, 0, 0, 0], &[]),
    Named("%", 1e-2, [0, 0, 0, 0, 0], &[]),
    Named("l", 1e-3, [3, 0, 0, 0, 0], &["u", "m", "c", "d", "h"]),
    Named("L", 1e-3, [3, 0, 0, 0, 0], &["u", "m", "c", "d", "h"]),
    // Numbers of hardness, each on a scale of its own.
    Named("HV", 1.0, [0, 0, 0, 0, 0], &[]),
    Named("HB", 1.0, [0, 0, 0, 0, 0], &[]),
    Named("HBW", 1.0, [0, 0, 0, 0, 0], &[]),
    Named("HRC", 1.0, [0, 0, 0, 0, 0], &[]),
    Named("in", 0.0254, [1, 0, 0, 0, 0], &[]),
    Named("kgf", 9.806_65, [1, 1, -2, 0, 0], &[]),
    Named("lbf", 4.448_221_615_260_5, [1, 1, -2, 0, 0], &[]),
    Named("psi", 6_894.757_293_168_361, [-1, 1, -2, 0, 0], &[]),
];

const PREFIXES: &[(&str, f64)] = &[
    ("p", 1e-12),
    ("n", 1e-9),
    ("u", 1e-6),
    ("m", 1e-3),
    ("c", 1e-2),
    ("d", 1e-1),
    ("da", 1e1),
    ("h", 1e2),
    ("k", 1e3),
    ("M", 1e6),
    ("G", 1e9),
    ("T", 1e12),
];

/// 0 degC in kelvin.
const CELSIUS_ZERO: f64 = 273.15;

pub(super) fn unit(text: &str) -> Result<Unit, UnitError> {
    let text = text.trim();
    if text.is_empty() {
        return Ok(Unit { factor: 1.0, offset: 0.0, dimension: Dimension::NONE });
    }
    if matches!(text, "degC" | "°C" | "℃" | "ºC" | "˚C" | "deg C" | "° C") {
        let dimension = Dimension::base([0, 0, 0, 1, 0]);
        return Ok(Unit { factor: 1.0, offset: CELSIUS_ZERO, dimension });
    }
    let mut reader = Reader { rest: text, whole: text };
    let unit = reader.product(0)?;
    if !reader.rest.is_empty() {
        return Err(reader.unexpected());
    }
    Ok(unit)
}

struct Reader<'a> {
    rest: &'a str,
    whole: &'a str,
}

impl Reader<'_> {
    /// product = ["/"] factor { ("*" | "·" | "/") factor }, read from left to right.
    fn product(&mut self, depth: usize) -> Result<Unit, UnitError> {
        let mut unit = Unit { factor: 1.0, offset: 0.0, dimension: Dimension::NONE };
        let mut sign = if self.take("/") { -1 } else { 1 };
        loop {
            let factor = self.factor(depth)?;
            unit.factor *= if sign == 1 { factor.factor } else { 1.0 / factor.factor };
            unit.dimension = unit.dimension.combine(factor.dimension, sign).ok_or_else(|| self.too_high())?;
            if self.take("/") {
                sign = -1;
            } else if self.take("*") || self.take("·") {
                sign = 1;
            } else {
                return Ok(unit);
            }
        }
    }

    /// factor = ( name | whole number | "(" product ")" ) [ "^" exponent | "²" | "³" ].
    fn factor(&mut self, depth: usize) -> Result<Unit, UnitError> {
        let base = if depth < 8 && self.take("(") {
            let inner = self.product(depth + 1)?;
            if !self.take(")") {
                return Err(UnitError::new(format!("`{}` lacks a closing parenthesis", self.whole)));
            }
            inner
        } else {
            let end = self.rest.find(|c| MARKS.contains(&c) || c == ' ').unwrap_or(self.rest.len());
            let (name, rest) = self.rest.split_at(end);
            let base = match (named(name), spelling::meant(name)) {
                (Some(base), _) => base,
                (None, Some(own)) => unit(own)?,
                (None, None) => return Err(self.unknown(name)),
            };
            self.rest = rest;
            base
        };
        self.raise(base)
    }

    fn raise(&mut self, base: Unit) -> Result<Unit, UnitError> {
        let exponent: i8 = if self.take("²") {
            2
        } else if self.take("³") {
            3
        } else if self.take("^n") {
            if (base.factor - 1.0).abs() > 1e-12 {
                return Err(UnitError::new(format!("`{}` raises a prefixed unit to the power n", self.whole))
                    .hint("write the force of a contact law in N: `um/N^n`"));
            }
            let dimension = base.dimension.power_n().ok_or_else(|| self.too_high())?;
            return Ok(Unit { dimension, ..base });
        } else if self.take("^") {
            let end = self
                .rest
                .char_indices()
                .find(|&(i, c)| !(c.is_ascii_digit() || (i == 0 && c == '-')))
                .map_or(self.rest.len(), |(i, _)| i);
            let (digits, rest) = self.rest.split_at(end);
            let exponent = digits.parse::<i8>().ok().filter(|e| (-9..=9).contains(e));
            self.rest = rest;
            exponent.ok_or_else(|| {
                UnitError::new(format!("`{}` has an exponent that is not a whole number from -9 to 9", self.whole))
            })?
        } else {
            1
        };
        let dimension = base.dimension.power(exponent).ok_or_else(|| self.too_high())?;
        Ok(Unit { factor: base.factor.powi(exponent.into()), offset: 0.0, dimension })
    }

    fn take(&mut self, mark: &str) -> bool {
        let trimmed = self.rest.trim_start();
        match trimmed.strip_prefix(mark) {
            Some(rest) => {
                self.rest = rest.trim_start();
                true
            }
            None => {
                if trimmed.is_empty() {
                    self.rest = trimmed;
                }
                false
            }
        }
    }

    fn unknown(&self, name: &str) -> UnitError {
        if name.is_empty() {
            return self.unexpected();
        }
        let error = UnitError::new(format!("`{name}` is no unit that is known here"));
        if let Some(help) = spelling::doubt(name) {
            return error.hint(help);
        }
        // Every other name is a neighbour of a single letter.
        match nearest(name).filter(|_| name.chars().count() > 1) {
            Some(near) => error.hint(format!("did you mean `{near}`?")),
            None => error.hint("units are built from m, g, s, K, rad, N, Pa, J, W, min, h, deg, rev, rpm, degC with SI prefixes, `*`, `/` and `^`"),
        }
    }

    fn unexpected(&self) -> UnitError {
        UnitError::new(format!("`{}` is no unit", self.whole))
            .hint("write a unit such as `N/um`, `W/m^2/K` or `mm/rev`")
    }

    fn too_high(&self) -> UnitError {
        UnitError::new(format!("`{}` has exponents that are too high", self.whole))
    }
}

/// A unit by its name: exact names first (so that `min` is a minute, not a milli-inch), then prefix and name,
/// then a whole number as a plain factor (`um/1000`).
fn named(name: &str) -> Option<Unit> {
    let plain = |factor: f64, exponents: [i8; 5]| Unit { factor, offset: 0.0, dimension: Dimension::base(exponents) };
    if let Some(unit) = UNITS.iter().find(|u| u.0 == name) {
        return Some(plain(unit.1, unit.2));
    }
    // Greek mu and the micro sign.
    let micro = name.strip_prefix(['µ', 'μ']).map(|rest| ("u", rest));
    for (prefix, scale) in PREFIXES {
        let rest = micro.filter(|(u, _)| u == prefix).map(|(_, rest)| rest);
        let Some(rest) = rest.or_else(|| name.strip_prefix(prefix)) else { continue };
        if let Some(unit) = UNITS.iter().find(|u| u.0 == rest && u.3.contains(prefix)) {
            return Some(plain(scale * unit.1, unit.2));
        }
    }
    let digits = !name.is_empty() && name.len() <= 9 && name.bytes().all(|b| b.is_ascii_digit());
    let factor: f64 = if digits { name.parse().ok()? } else { return None };
    (factor > 0.0).then_some(plain(factor, [0; 5]))
}

/// Most bytes of a word that may be a slip for a unit's name.
const LONGEST_NAME: usize = 20;

/// The known unit (with its prefix) that differs from `name` in letter case or by one slip.
fn nearest(name: &str) -> Option<String> {
    if name.len() > LONGEST_NAME {
        return None;
    }
    let mut best: Option<((bool, usize), String)> = None;
    let prefixed = UNITS.iter().flat_map(|u| u.3.iter().map(move |prefix| format!("{prefix}{}", u.0)));
    for candidate in UNITS.iter().map(|u| u.0.to_string()).chain(prefixed) {
        let other_letters = !candidate.eq_ignore_ascii_case(name);
        let distance = strsim::damerau_levenshtein(name, &candidate);
        let likeness = (other_letters, distance);
        if (distance <= 1 || !other_letters) && best.as_ref().is_none_or(|(l, _)| likeness < *l) {
            best = Some((likeness, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

impl Unit {
    /// Reads a unit such as `N/um`, `W/m^2/K`, `kN*m/rad`, `mm/rev`, `/K` or `um/N^n`; the empty text is the
    /// unit of pure numbers.
    ///
    /// # Errors
    /// Says which word is no unit and, where one is near, which was probably meant.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        unit(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_their_si_value() {
        let cases: &[(&str, f64, &str)] = &[
            ("N/um", 1e6, "kg·s^-2"),
            ("um", 1e-6, "m"),
            ("µm", 1e-6, "m"),
            ("μm", 1e-6, "m"),
            ("min", 60.0, "s"),
            ("mm/rev", 1e-3 / (2.0 * PI), "m·rad^-1"),
            ("rpm", PI / 30.0, "s^-1·rad"),
            ("kN*m/rad", 1e3, "m^2·kg·s^-2·rad^-1"),
            ("W/m^2/K", 1.0, "kg·s^-3·K^-1"),
            ("W/m²/K", 1.0, "kg·s^-3·K^-1"),
            ("W/(m^2*K)", 1.0, "kg·s^-3·K^-1"),
            ("N/(mm^2/s)", 1e6, "m^-1·kg·s^-1"),
            ("/K", 1.0, "K^-1"),
            ("1/K", 1.0, "K^-1"),
            ("um/N^n", 1e-6, "m·m^(-1n)·kg^(-1n)·s^(2n)"),
            ("um/1000", 1e-9, "m"),
            ("um/km", 1e-9, "1"),
            ("GPa", 1e9, "m^-1·kg·s^-2"),
            ("kg*mm", 1e-3, "m·kg"),
            ("J/kg/K", 1.0, "m^2·s^-2·K^-1"),
            ("in", 0.0254, "m"),
            ("kcal", 4186.8, "m^2·kg·s^-2"),
            ("Grad", PI / 180.0, "rad"),
            ("gon", PI / 200.0, "rad"),
            ("U/min", PI / 30.0, "s^-1·rad"),
            ("Nm/arcsec", 648_000.0 / PI, "m^2·kg·s^-2·rad^-1"),
            ("kgf", 9.80665, "m·kg·s^-2"),
            ("kgf/mm", 9806.65, "kg·s^-2"),
            ("kgf/mm^2", 9.80665e6, "m^-1·kg·s^-2"),
        ];
        for (text, factor, dimension) in cases {
            let unit = Unit::parse(text).unwrap();
            assert!((unit.factor / factor - 1.0).abs() < 1e-15, "{text}: {} for {factor}", unit.factor);
            assert_eq!(unit.dimension.to_string(), *dimension, "{text}");
        }
    }

    #[test]
    fn what_is_no_unit_is_refused_with_the_nearest() {
        for (text, hint) in [
            ("Mpa", "MPa"),
            ("newton", ""),
            ("N/", ""),
            ("N//m", ""),
            ("N^99", ""),
            ("(N", ""),
            ("kmh", ""),
            ("N/kN^n", ""),
            ("Um", "um"),
            ("Gdeg", ""),
            ("Grd", ""),
            ("Tm", ""),
        ] {
            let error = Unit::parse(text).unwrap_err();
            assert!(error.hint.unwrap_or_default().contains(hint), "{text}");
        }
        assert!(Unit::parse("((((((((((m").is_err());
        assert!(Unit::parse("m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9").is_err());
    }
}
