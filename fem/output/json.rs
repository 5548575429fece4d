//! Answers as JSON. No NaN, no infinity: what is unknown is null.

use serde_json::{Value, json};

use super::answer::{Answer, left_undone};

/// An answer as a JSON document.
pub fn json(answer: &dyn Answer) -> String {
    let mut value = answer.json();
    let undone = left_undone(answer.progress());
    if let (Value::Object(all), false) = (&mut value, undone.is_empty()) {
        all.insert("left_undone".into(), undone.into());
    }
    format!("{value:#}\n")
}

/// A number, null where it is not finite.
pub fn finite(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}
