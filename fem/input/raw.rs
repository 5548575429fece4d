//! Values of whatever type, kept as they are written: what they should be is known only when other tables are read, or
//! when they are put into another place.

use std::ops::Range;
use std::sync::Arc;

use serde_json::json;
use toml_edit::{Item, Value};

use super::{Problem, Reader};

/// A value of a file: a text, a number, a list, a table.
#[derive(Clone, Debug)]
pub struct Raw {
    /// The value, without the blanks and comments around it.
    value: Arc<Value>,
    /// Bytes of it in the file.
    pub span: Option<Range<usize>>,
}

/// Raw values are equal where the same is written, wherever it stands.
impl PartialEq for Raw {
    fn eq(&self, other: &Self) -> bool {
        self.value.to_string() == other.value.to_string()
    }
}

impl From<i64> for Raw {
    fn from(number: i64) -> Self {
        Self::of(Value::from(number), None)
    }
}

impl Raw {
    /// A value, which stands in these bytes of a file.
    pub fn of(value: Value, span: Option<Range<usize>>) -> Self {
        let mut value = value;
        value.decor_mut().clear();
        Self { value: Arc::new(value), span }
    }

    /// A value as a file writes it; `None` where the text is none.
    pub fn parse(text: &str) -> Option<Self> {
        text.trim().parse().ok().map(|value| Self::of(value, None))
    }

    /// A table of keys, each with what is written for it: numbers, and yes and no, as such, all else as text.
    pub fn of_keys<'k>(keys: impl IntoIterator<Item = (&'k str, &'k str)>) -> Self {
        let value = |text: &str| match text.trim().parse::<Value>() {
            Ok(value @ (Value::Integer(_) | Value::Float(_) | Value::Boolean(_))) => value,
            _ => Value::from(text.trim()),
        };
        let keys = keys.into_iter().map(|(key, text)| (key, value(text)));
        Self::of(Value::InlineTable(keys.collect()), None)
    }

    /// A list of these.
    pub fn of_list(all: impl IntoIterator<Item = Self>) -> Self {
        Self::of(Value::Array(all.into_iter().map(|own| (*own.value).clone()).collect()), None)
    }

    /// The value itself.
    pub fn value(&self) -> &Value {
        &self.value
    }

    /// The value on one line, without the comments within it.
    pub fn on_one_line(&self) -> String {
        let mut value = (*self.value).clone();
        flatten(&mut value);
        value.to_string()
    }

    /// Every text in it.
    pub fn texts(&self) -> Vec<&str> {
        texts(&self.value)
    }

    /// A text, or a number as a text.
    pub fn text(&self) -> Option<String> {
        super::written::text_of(&Item::Value((*self.value).clone()))
    }

    /// A whole number.
    pub fn whole(&self) -> Option<i64> {
        self.value.as_integer()
    }
}

/// Every text in a value.
pub fn texts(value: &Value) -> Vec<&str> {
    match value {
        Value::String(text) => vec![text.value()],
        Value::Array(list) => list.iter().flat_map(texts).collect(),
        Value::InlineTable(table) => table.iter().flat_map(|(_, own)| texts(own)).collect(),
        _ => Vec::new(),
    }
}

/// Writes lists and tables on one line.
fn flatten(value: &mut Value) {
    match value {
        Value::Array(list) => {
            list.iter_mut().for_each(flatten);
            list.fmt();
        }
        Value::InlineTable(table) => {
            table.iter_mut().for_each(|(_, own)| flatten(own));
            table.fmt();
        }
        _ => {}
    }
    value.decor_mut().clear();
}

/// As a user would write it: texts without quotes.
impl std::fmt::Display for Raw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text().unwrap_or_else(|| self.value.to_string()))
    }
}

impl Reader<'_> {
    /// A key with a value of any type.
    pub fn raw(&self, key: &'static str, about: &'static str) -> Option<Raw> {
        self.describe(key, || json!({ "type": ["string", "number", "boolean"], "description": about }), false);
        let item = self.item(key)?;
        match item.as_value() {
            Some(value) if !value.is_array() && !value.is_inline_table() => Some(Raw::of(value.clone(), item.span())),
            _ => {
                let problem = Problem::new(format!("`{key}`: expected one value, found {}", item.type_name()));
                self.refuse(problem.help(format!("write {key} = \"…\"")).at(item.span()));
                None
            }
        }
    }

    /// A key with a list of values of any type, empty where it is absent.
    pub fn raws(&self, key: &'static str, about: &'static str) -> Vec<Raw> {
        let items = json!({ "type": ["string", "number", "boolean"] });
        self.describe(key, || json!({ "type": "array", "description": about, "items": items }), false);
        let Some(item) = self.item(key) else { return Vec::new() };
        match item.as_array() {
            Some(array) => array.iter().map(|value| Raw::of(value.clone(), value.span())).collect(),
            None => {
                let problem = Problem::new(format!("`{key}`: expected a list, found {}", item.type_name()));
                self.refuse(problem.help(format!("write {key} = [\"…\", \"…\"]")).at(item.span()));
                Vec::new()
            }
        }
    }

    /// A key with a table of values of any type, each behind a path; none where it is absent.
    pub fn raw_table(&self, key: &'static str, about: &'static str) -> Vec<(String, Raw)> {
        self.describe(key, || json!({ "type": "object", "description": about }), false);
        let Some(item) = self.item(key) else { return Vec::new() };
        let Some(table) = item.as_table_like() else {
            let problem = Problem::new(format!("`{key}`: expected a table, found {}", item.type_name()));
            self.refuse(problem.help(format!("write {key} = {{ \"batch.cycle_time\" = \"8 min\" }}")).at(item.span()));
            return Vec::new();
        };
        let raw = |(path, item): (&str, &Item)| {
            let span = table.key(path).and_then(toml_edit::Key::span);
            item.clone().into_value().ok().map(|value| (path.to_string(), Raw::of(value, span)))
        };
        table.iter().filter_map(raw).collect()
    }
}
