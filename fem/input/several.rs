//! Keys that hold several quantities of one kind: places, and stretches of time.

use serde_json::json;
use toml_edit::Value;

use super::{Problem, Reader};
use crate::units::{Kind, LARGEST, Quantity};

impl Reader<'_> {
    /// A key with any number of quantities, in SI units; `None` where it is absent. What is wrong is noted
    /// and left out.
    pub fn quantities(&self, key: &'static str, kind: Kind, about: &'static str) -> Option<Vec<f64>> {
        let types = if kind.unit.is_empty() { json!(["number", "string"]) } else { json!("string") };
        let item = json!({ "type": types, "examples": [kind.example()] });
        self.describe(key, || json!({ "type": "array", "description": about, "items": item }), false);
        let written = format!("{key} = [\"{}\", …]", kind.example());
        let entries = self.entries(key, &written)?;
        let read = |(i, value): (usize, &Value)| self.entry(&format!("{key}[{i}]"), value, kind, &written);
        Some(entries.into_iter().enumerate().filter_map(read).collect())
    }

    /// A key with any number of intervals `[from, to]`, in SI units, each with `from` below `to`; `None`
    /// where it is absent.
    pub fn intervals(&self, key: &'static str, kind: Kind, about: &'static str) -> Option<Vec<[f64; 2]>> {
        let item = json!({ "type": "string", "examples": [kind.example()] });
        let pair = json!({ "type": "array", "items": item, "minItems": 2, "maxItems": 2 });
        self.describe(key, || json!({ "type": "array", "description": about, "items": pair }), false);
        let written = format!("{key} = [[\"0 {0}\", \"{1}\"], …]", kind.unit, kind.example());
        let read = |(i, value): (usize, &Value)| {
            let ends: Vec<&Value> = value.as_array().map_or(Vec::new(), |array| array.iter().collect());
            let [from, to] = ends[..] else {
                let problem = Problem::new(format!("an entry of `{key}` is no interval"));
                self.refuse(problem.help(format!("write {written}")).at(value.span()));
                return None;
            };
            let end = |j: usize, end: &Value| self.entry(&format!("{key}[{i}][{j}]"), end, kind, &written);
            let (from, to) = (end(0, from), end(1, to));
            let [from, to] = [from?, to?];
            if from >= to {
                let problem = Problem::new(format!("an interval of `{key}` ends before it begins"));
                self.refuse(problem.help("write the earlier end first").at(value.span()));
                return None;
            }
            Some([from, to])
        };
        Some(self.entries(key, &written)?.into_iter().enumerate().filter_map(read).collect())
    }

    /// A key with names: one, or a list of them; `None` where it is absent. What is no text is noted and left out.
    pub fn texts(&self, key: &'static str, about: &'static str) -> Option<Vec<String>> {
        let list = json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 });
        self.describe(key, || json!({ "anyOf": [{ "type": "string" }, list], "description": about }), false);
        if let Some(one) = self.written(key) {
            self.item(key);
            return Some(vec![one.to_string()]);
        }
        let read = |value: &Value| {
            if value.as_str().is_none() {
                let problem =
                    Problem::new(format!("an entry of `{key}`: expected a name, found {}", value.type_name()));
                self.refuse(problem.help(format!("write {key} = [\"…\", …]")).at(value.span()));
            }
            value.as_str().map(str::to_string)
        };
        Some(self.entries(key, &format!("{key} = [\"…\", …]"))?.into_iter().filter_map(read).collect())
    }

    fn entries(&self, key: &'static str, written: &str) -> Option<Vec<&Value>> {
        let item = self.item(key)?;
        match item.as_array() {
            Some(array) => Some(array.iter().collect()),
            None => {
                let problem = Problem::new(format!("`{key}`: expected a list, found {}", item.type_name()));
                self.refuse(problem.help(format!("write {written}")).at(item.span()));
                None
            }
        }
    }

    /// One quantity of a list; `path` is where it stands, `written` how the list is written.
    fn entry(&self, path: &str, value: &Value, kind: Kind, written: &str) -> Option<f64> {
        let refuse = |problem: Problem| {
            self.refuse(problem.at(value.span()));
            None
        };
        let number = value.as_float().or_else(|| value.as_integer().map(|i| i as f64));
        if let (Some(number), true) = (number.filter(|n| n.abs() <= LARGEST), kind.unit.is_empty()) {
            return Some(number);
        }
        let Some(text) = value.as_str() else {
            let problem = Problem::new(format!("`{path}` has no unit: {} is a string with its unit", kind.name));
            return refuse(problem.help(format!("write {written}")));
        };
        match Quantity::parse(text, &kind) {
            Ok(quantity) => Some(self.note(path, (kind, super::Bounds::Any, None), quantity, value.span())),
            Err(error) => {
                let help = error.hint.unwrap_or_else(|| format!("write {written}"));
                refuse(Problem::new(format!("`{path}`: {}", error.message)).help(help))
            }
        }
    }
}
