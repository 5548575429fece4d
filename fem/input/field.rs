//! One key of a table: its kind, its bounds, and whether it may be left out.

use serde_json::json;
use toml_edit::{Item, Value};

use super::{Bounds, Doubt, Name, Problem, Reader, did_you_mean};
use crate::units::{Kind, Knowledge, LARGEST, Quantity};

impl<'a> Reader<'a> {
    /// A key with a quantity of `kind`.
    pub fn quantity(&self, key: impl Into<Name>, kind: Kind, about: &'static str) -> Field<'_, 'a> {
        Field::new(self, key, kind, about)
    }

    /// A key with a whole number.
    pub fn count(&self, key: impl Into<Name>, about: &'static str) -> Count<'_, 'a> {
        Count::new(self, key, about)
    }

    /// A key with one of `words`.
    pub fn choice<T: Copy + 'static>(
        &self,
        key: &'static str,
        about: &'static str,
        words: &'static [(&'static str, T)],
    ) -> Choice<'_, 'a, T> {
        Choice::new(self, key, about, words)
    }
}

/// A key that holds a physical quantity or a pure number.
#[must_use = "say whether the key is required, optional or has a default"]
pub struct Field<'r, 'a> {
    pub(super) reader: &'r Reader<'a>,
    pub(super) key: Name,
    pub(super) kind: Kind,
    pub(super) about: &'static str,
    bounds: Bounds,
    is_chosen: bool,
    doubt: Option<Doubt>,
}

impl<'r, 'a> Field<'r, 'a> {
    pub(super) fn new(reader: &'r Reader<'a>, key: impl Into<Name>, kind: Kind, about: &'static str) -> Self {
        Self { reader, key: key.into(), kind, about, bounds: Bounds::Any, is_chosen: false, doubt: None }
    }

    /// Is chosen by whoever computes, as a step or a size of elements: no measurement tells it, and it is never unknown.
    pub fn chosen(mut self) -> Self {
        self.is_chosen = true;
        self
    }

    /// Is what people measure or estimate, so that a diagnosis may doubt it where it is written as known.
    pub fn estimated(mut self, doubt: Doubt) -> Self {
        self.doubt = Some(doubt);
        self
    }

    /// Must lie within `bounds`.
    pub fn bounds(mut self, bounds: Bounds) -> Self {
        self.bounds = bounds;
        self
    }

    /// Must be above zero.
    pub fn positive(self) -> Self {
        self.bounds(Bounds::Positive)
    }

    /// Must be zero or more.
    pub fn not_negative(self) -> Self {
        self.bounds(Bounds::NotNegative)
    }

    /// Must be above `low` and at most `high`, both in SI units.
    pub fn within(self, low: f64, high: f64) -> Self {
        self.bounds(Bounds::Within(low, high))
    }

    /// The value in SI units; an absent key is a problem.
    pub fn required(self) -> f64 {
        self.describe(true);
        match self.read() {
            Some(value) => value,
            None => {
                self.reader.missing(&self.key, &self.example(), self.about);
                f64::NAN
            }
        }
    }

    /// The value in SI units, or `None` where the key is absent.
    pub fn optional(self) -> Option<f64> {
        self.describe(false);
        self.read()
    }

    /// The value in SI units, or `default` (SI) where the key is absent.
    pub fn or(self, default: f64) -> f64 {
        self.optional().unwrap_or(default)
    }

    fn example(&self) -> String {
        let quote = if self.kind.unit.is_empty() { "" } else { "\"" };
        format!("{} = {quote}{}{quote}", self.key, self.kind.example())
    }

    pub(super) fn describe(&self, required: bool) {
        self.reader.describe(&self.key, || self.schema(), required);
    }

    fn schema(&self) -> serde_json::Value {
        match &*self.kind.unit {
            "" => json!({ "type": ["number", "string"], "description": self.about }),
            unit => {
                let about = format!("{} (e.g. \"{}\")", self.about, self.kind.example());
                let unknown = (!self.is_chosen).then(|| format!("? {unit}"));
                let examples: Vec<String> = [self.kind.example().to_string()].into_iter().chain(unknown).collect();
                json!({ "type": "string", "description": about, "examples": examples })
            }
        }
    }

    /// `None` where the key is absent; NaN, with a problem noted, where it is wrong.
    fn read(&self) -> Option<f64> {
        let item = self.reader.item(self.key.clone())?;
        match self.parse(item).and_then(|q| self.check(q)) {
            Ok(quantity) => {
                Some(self.reader.note(&self.key, (self.kind, self.bounds, self.doubt), quantity, item.span()))
            }
            Err(problem) => {
                self.reader.refuse(problem.at(item.span()));
                Some(f64::NAN)
            }
        }
    }

    fn parse(&self, item: &Item) -> Result<Quantity, Problem> {
        let wrong = |message: String| Problem::new(message).help(format!("write {}", self.example()));
        match item.as_value() {
            Some(Value::String(text)) => Quantity::parse(text.value(), &self.kind).map_err(|e| {
                let problem = Problem::new(format!("`{}`: {}", self.key, e.message));
                match e.hint {
                    Some(hint) => problem.help(hint),
                    None => problem.help(format!("write {}", self.example())),
                }
            }),
            Some(Value::Integer(_) | Value::Float(_)) if self.kind.unit.is_empty() => {
                let number = item.as_float().or_else(|| item.as_integer().map(|i| i as f64)).unwrap_or(f64::NAN);
                match number.abs() <= LARGEST {
                    true => Ok(Quantity::known(number)),
                    false if number.is_finite() => {
                        Err(wrong(format!("`{}` is too large to be computed with", self.key)))
                    }
                    false => Err(wrong(format!("`{}` is not a finite number", self.key))),
                }
            }
            Some(Value::Integer(_) | Value::Float(_)) => {
                Err(wrong(format!("`{}` has no unit: {} is a string with its unit", self.key, self.kind.name)))
            }
            _ => Err(wrong(format!("`{}` is no {}", self.key, self.kind.bare_name()))),
        }
    }

    pub(super) fn check(&self, quantity: Quantity) -> Result<Quantity, Problem> {
        if self.is_chosen && quantity.knowledge != Knowledge::Known {
            let message = format!("`{}` is chosen, and nothing that is measured tells it", self.key);
            return Err(Problem::new(message).help(format!("write {}", self.example())));
        }
        // An unknown value has no bounds to keep, but the place where a search for it begins has.
        if quantity.value.is_nan() {
            return Ok(quantity);
        }
        let value = quantity.value;
        let shown = |si: f64| format!("{} {}", self.kind.from_si(si), self.kind.unit).trim_end().to_string();
        let expected = match self.bounds {
            Bounds::Positive if value <= 0.0 => "above zero".to_string(),
            Bounds::NotNegative if value < 0.0 => "zero or more".to_string(),
            Bounds::Within(low, high) if !(value > low && value <= high) => {
                format!("above {} and at most {}", shown(low), shown(high))
            }
            _ => return Ok(quantity),
        };
        Err(Problem::new(format!("`{}` is {}", self.key, shown(value))).help(format!("it must be {expected}")))
    }
}

/// A key that holds a whole number of things.
#[must_use = "say whether the key is required or has a default"]
pub struct Count<'r, 'a> {
    reader: &'r Reader<'a>,
    key: Name,
    about: &'static str,
    range: (usize, usize),
}

impl<'r, 'a> Count<'r, 'a> {
    pub(super) fn new(reader: &'r Reader<'a>, key: impl Into<Name>, about: &'static str) -> Self {
        Self { reader, key: key.into(), about, range: (0, 1_000_000) }
    }

    /// Both ends belong to what is allowed.
    pub fn between(mut self, low: usize, high: usize) -> Self {
        self.range = (low, high);
        self
    }

    /// The number, or `default` where the key is absent.
    pub fn or(self, default: usize) -> usize {
        self.describe(json!(default), false);
        self.read().unwrap_or(default)
    }

    /// The number, or `None` where the key is absent.
    pub fn optional(self) -> Option<usize> {
        self.describe(serde_json::Value::Null, false);
        self.read()
    }

    /// The number; an absent key is a problem.
    pub fn required(self) -> usize {
        self.describe(serde_json::Value::Null, true);
        self.read().unwrap_or_else(|| {
            self.reader.missing(&self.key, &format!("{} = {}", self.key, self.range.0), self.about);
            self.range.0
        })
    }

    fn describe(&self, default: serde_json::Value, required: bool) {
        let schema = || {
            let mut shape = json!({ "type": "integer", "description": self.about, "minimum": self.range.0, "maximum": self.range.1 });
            if !default.is_null() {
                shape["default"] = default;
            }
            shape
        };
        self.reader.describe(&self.key, schema, required);
    }

    fn read(&self) -> Option<usize> {
        let item = self.reader.item(self.key.clone())?;
        let (low, high) = self.range;
        match item.as_integer().and_then(|i| usize::try_from(i).ok()).filter(|i| (low..=high).contains(i)) {
            Some(count) => Some(count),
            None => {
                let given = item.to_string();
                let problem = Problem::new(format!("`{}` is {}", self.key, given.trim()))
                    .help(format!("it must be a whole number from {low} to {high}"));
                self.reader.refuse(problem.at(item.span()));
                Some(low)
            }
        }
    }
}

/// A key whose value is one word of a few.
#[must_use = "say whether the key is required or has a default"]
pub struct Choice<'r, 'a, T: Copy + 'static> {
    reader: &'r Reader<'a>,
    key: &'static str,
    about: &'static str,
    words: &'static [(&'static str, T)],
}

impl<'r, 'a, T: Copy + 'static> Choice<'r, 'a, T> {
    pub(super) fn new(
        reader: &'r Reader<'a>,
        key: &'static str,
        about: &'static str,
        words: &'static [(&'static str, T)],
    ) -> Self {
        Self { reader, key, about, words }
    }

    /// The meaning of the word; an absent key is a problem, and `fallback` lets the reading go on after one.
    pub fn required(self, fallback: T) -> T {
        self.describe(None, true);
        self.read(fallback).unwrap_or_else(|| {
            let first = self.words.first().map_or("", |w| w.0);
            self.reader.missing(self.key, &format!("{} = \"{first}\"", self.key), self.about);
            fallback
        })
    }

    /// The meaning of the word, if the key is there.
    pub fn optional(self) -> Option<T> {
        self.describe(None, false);
        self.words.first().and_then(|(_, first)| self.read(*first))
    }

    /// The meaning of the word; that of the first of the list where the key is absent.
    pub fn or_first(self, fallback: T) -> T {
        self.describe(self.words.first().map(|w| w.0), false);
        self.read(fallback).unwrap_or(fallback)
    }

    /// The meaning of each word of a list, in its order; all of the words where the key is absent. A single
    /// word may stand without a list.
    pub fn several(self) -> Vec<T> {
        self.reader.describe(
            self.key,
            || {
                let words: Vec<&str> = self.words.iter().map(|w| w.0).collect();
                let items = json!({ "enum": words });
                let list = json!({ "type": "array", "items": items, "uniqueItems": true, "minItems": 1 });
                json!({ "anyOf": [list, items], "description": self.about, "default": words })
            },
            false,
        );
        let all = || self.words.iter().map(|w| w.1).collect();
        let Some(item) = self.reader.item(self.key) else { return all() };
        let given: Vec<(&str, _)> = match item.as_value() {
            Some(Value::Array(array)) => {
                array.iter().map(|v| (v.as_str().unwrap_or_default(), v.span().or(item.span()))).collect()
            }
            _ => vec![(item.as_str().unwrap_or_default(), item.span())],
        };
        let words: Vec<String> = self.words.iter().map(|w| format!("\"{}\"", w.0)).collect();
        let refuse = |message: String, help: String, span| {
            self.reader.refuse(Problem::new(message).help(help).at(span));
        };
        if given.is_empty() {
            refuse(format!("`{}` is empty", self.key), format!("list some of {}", words.join(", ")), item.span());
        }
        let mut found = Vec::with_capacity(given.len());
        for (i, (word, span)) in given.iter().enumerate() {
            match self.words.iter().find(|w| w.0 == *word) {
                Some(_) if given[..i].iter().any(|(other, _)| other == word) => {
                    let message = format!("\"{word}\" stands twice in `{}`", self.key);
                    refuse(message, "name it once".into(), span.clone());
                }
                Some((_, meaning)) => found.push(*meaning),
                None => {
                    let meant = did_you_mean(word, self.words.iter().map(|w| w.0), '"');
                    let message = format!("\"{word}\" in `{}` is none of its words", self.key);
                    refuse(message, format!("{meant}take some of {}", words.join(", ")), span.clone());
                }
            }
        }
        if found.is_empty() { all() } else { found }
    }

    fn describe(&self, default: Option<&str>, is_required: bool) {
        let schema = || {
            let words: Vec<&str> = self.words.iter().map(|w| w.0).collect();
            let mut shape = json!({ "enum": words, "description": self.about });
            if let Some(default) = default {
                shape["default"] = json!(default);
            }
            shape
        };
        self.reader.describe(self.key, schema, is_required);
    }

    fn read(&self, fallback: T) -> Option<T> {
        let item = self.reader.item(self.key)?;
        let given = item.as_str().unwrap_or_default();
        if let Some((_, meaning)) = self.words.iter().find(|w| w.0 == given) {
            return Some(*meaning);
        }
        let words: Vec<String> = self.words.iter().map(|w| format!("\"{}\"", w.0)).collect();
        let meant = did_you_mean(given, self.words.iter().map(|w| w.0), '"');
        let problem = Problem::new(format!("`{}` is {}", self.key, item.to_string().trim()))
            .help(format!("{meant}it must be one of {}", words.join(", ")));
        self.reader.refuse(problem.at(item.span()));
        Some(fallback)
    }
}
