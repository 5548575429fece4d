//! A key that holds a pair of quantities of one kind: a point in a plane.

use serde_json::json;
use toml_edit::Value;

use super::{Bounds, Name, Problem, Reader};
use crate::units::{Kind, Quantity};

impl Reader<'_> {
    /// A key with two quantities of `kind`, such as x and y, in SI units; `None`, with the problem noted,
    /// where it is absent or wrong.
    pub fn pair(&self, key: impl Into<Name>, kind: Kind, about: &'static str) -> Option<[f64; 2]> {
        let key = &key.into();
        let (item_of, example) = (json!({ "type": "string", "examples": [kind.example()] }), kind.example());
        let schema =
            || json!({ "type": "array", "description": about, "items": item_of, "minItems": 2, "maxItems": 2 });
        self.describe(key, schema, true);
        let written = format!("{key} = [\"{example}\", \"{example}\"]");
        let Some(item) = self.item(key.clone()) else {
            self.missing(key, &written, about);
            return None;
        };
        let values: Vec<&Value> = item.as_array().map_or(Vec::new(), |array| array.iter().collect());
        let [first, second] = values[..] else {
            self.refuse(Problem::new(format!("`{key}` is no pair")).help(format!("write {written}")).at(item.span()));
            return None;
        };
        let read = |i: usize, value: &Value| {
            let parsed = match value.as_str() {
                Some(text) => Quantity::parse(text, &kind),
                None => {
                    let problem = Problem::new(format!("`{key}` has no unit: {} is a string with its unit", kind.name));
                    self.refuse(problem.help(format!("write {written}")).at(value.span()));
                    return None;
                }
            };
            match parsed {
                Ok(quantity) => {
                    Some(self.note(&format!("{key}[{i}]"), (kind, Bounds::Any, None), quantity, value.span()))
                }
                Err(e) => {
                    let help = e.hint.unwrap_or_else(|| format!("write {written}"));
                    self.refuse(Problem::new(format!("`{key}`: {}", e.message)).help(help).at(value.span()));
                    None
                }
            }
        };
        let (first, second) = (read(0, first), read(1, second));
        Some([first?, second?])
    }
    /// All keys of this table that are not asked for otherwise, each a pair of quantities of `kind` with a name of the
    /// user's choice: points of a plane.
    pub fn named_pairs(&self, kind: Kind, about: &'static str) -> Vec<(Name, [f64; 2])> {
        if self.is_described() {
            self.pair("", kind, about);
            self.describe_further("");
        }
        self.further().into_iter().filter_map(|name| Some((name.clone(), self.pair(name, kind, about)?))).collect()
    }
}
