//! Limits as a model file has them.

use super::iso286;
use super::limits::Limits;
use crate::input::Reader;
use crate::units::{Kind, Knowledge, Quantity};

impl Limits {
    /// Limits behind a key: a tolerance class where there is a nominal size (m), "±10 um", or "-16 um to 0 um"; `None` where
    /// there are none, or what is written is none, which is noted.
    pub fn read(t: &Reader, key: &'static str, about: &'static str, kind: Kind, size: Option<f64>) -> Option<Self> {
        let text = t.text(key, about)?;
        match Self::parse(&text, kind, size) {
            Ok(limits) => Some(limits),
            Err(message) => {
                let class = if size.is_some() { "\"h6\", " } else { "" };
                let help =
                    format!("write {key} = {class}\"±10 {unit}\" or \"-16 {unit} to 0 {unit}\"", unit = kind.unit);
                t.problem(key, format!("`{key}`: {message}"), help);
                None
            }
        }
    }

    fn parse(text: &str, kind: Kind, size: Option<f64>) -> Result<Self, String> {
        let text = text.trim();
        let value = |text: &str| {
            let quantity = Quantity::parse(text, &kind).map_err(|error| error.to_string())?;
            let is_known = quantity.knowledge == Knowledge::Known && quantity.value.is_finite();
            is_known.then_some(quantity.value).ok_or_else(|| format!("\"{text}\" is no known deviation"))
        };
        if let Some(rest) = ["±", "+-", "+/-"].iter().find_map(|sign| text.strip_prefix(sign)) {
            let half = value(rest)?;
            return Self { lower: -half, upper: half }.checked(text);
        }
        if let Some((low, high)) = text.split_once(" to ") {
            let upper = value(high)?;
            let unit = high.trim_start_matches(|c: char| !c.is_alphabetic() && c != 'µ');
            let lower = value(low).or_else(|_| value(&format!("{low} {unit}")))?;
            return Self { lower, upper }.checked(text);
        }
        match size {
            // Of a size that is still unknown nobody can tell.
            Some(size) if size.is_nan() => Ok(Self { lower: f64::NAN, upper: f64::NAN }),
            Some(size) => iso286::limits(text, size).map_err(|why| format!("\"{text}\": {why}")),
            None => Err(format!("\"{text}\" has no limits")),
        }
    }

    fn checked(self, text: &str) -> Result<Self, String> {
        if self.lower < self.upper {
            Ok(self)
        } else {
            Err(format!("\"{text}\": the lower limit is not below the upper one"))
        }
    }
}
