//! What a model says, key by key, and what it could say besides, by the schema of its process.

use serde_json::Value as Json;
use toml_edit::{Item, TableLike, Value};

use super::Model;
use super::schema::of_process;
use crate::processes;

/// Tables that say something of the knowledge about a model rather than of the machine, and have ways of their own to be
/// written.
const ASIDE: &[&str] = &["process", "machine", "recorded", "odds", "known", "measurement", "setting", "correction"];

/// The keys of a model, the lists of tables in it, and what it does without.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// Keys with a value, in the order of the file.
    pub keys: Vec<Key>,
    /// Lists of tables, those that the model lacks among them.
    pub lists: Vec<List>,
    /// Keys and tables that the model could have.
    pub absent: Vec<Key>,
}

/// A key.
#[derive(Clone, Debug)]
pub struct Key {
    /// Where it stands: `workpiece.segments[0].length`.
    pub path: String,
    /// What it is.
    pub about: String,
    /// The words of which it is one; none where it is no such word.
    pub choices: Vec<String>,
    /// What it holds.
    pub holds: Holds,
    /// A value as it could be written.
    pub example: String,
    /// Whether a table that has it cannot do without.
    pub is_needed: bool,
}

/// What a key holds, apart from quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    Text,
    Number,
    Flag,
    /// Keys of its own.
    Table,
}

/// A list of tables.
#[derive(Clone, Debug)]
pub struct List {
    /// Where it stands.
    pub path: String,
    /// What its tables are.
    pub about: String,
    /// The keys that a table may have, named by themselves.
    pub keys: Vec<Key>,
    /// Number of tables.
    pub rows: usize,
}

impl Model {
    /// The model key by key.
    pub fn outline(&self) -> Outline {
        let mut outline = Outline::default();
        // Several tests have no keys that are theirs together.
        if let Some(process) = processes::ALL.iter().find(|own| own.name() == self.process.name()) {
            walk(&of_process(*process), self.tables.now(), "", &mut outline);
        }
        outline
    }
}

fn walk(schema: &Json, table: &dyn TableLike, above: &str, outline: &mut Outline) {
    let Some(properties) = schema["properties"].as_object() else { return };
    let is_aside = |key: &str| above.is_empty() && ASIDE.contains(&key);
    let path = |key: &str| if above.is_empty() { key.to_string() } else { format!("{above}.{key}") };
    // Tables with names of the user's choice; those of effects have ways of their own.
    let further = schema.get("additionalProperties").filter(|own| own.is_object() && above != "effects");
    for (key, item) in table.iter() {
        if let Some(own) = properties.get(key).or(further).filter(|_| !is_aside(key)) {
            present(own, item, path(key), outline);
        }
    }
    // Effects are added by name, with all that they need.
    if above == "effects" {
        return;
    }
    for (key, own) in
        properties.iter().filter(|(key, _)| !table.contains_key(key) && !is_aside(key) && *key != "effects")
    {
        match items(own) {
            Some(rows) => outline.lists.push(List { path: path(key), about: about(own), keys: keys(rows), rows: 0 }),
            None => outline.absent.push(described(path(key), own, false)),
        }
    }
}

fn present(schema: &Json, item: &Item, path: String, outline: &mut Outline) {
    if let Some(rows) = items(schema) {
        let tables: Vec<&dyn TableLike> = match item {
            Item::ArrayOfTables(list) => list.iter().map(|own| own as &dyn TableLike).collect(),
            Item::Value(Value::Array(list)) => {
                list.iter().filter_map(|own| own.as_inline_table().map(|own| own as &dyn TableLike)).collect()
            }
            _ => Vec::new(),
        };
        let list = List { path: path.clone(), about: about(schema), keys: keys(rows), rows: tables.len() };
        outline.lists.push(list);
        for (number, table) in tables.into_iter().enumerate() {
            for (key, item) in table.iter() {
                if let Some(own) = rows["properties"].get(key) {
                    present(own, item, format!("{path}[{number}].{key}"), outline);
                }
            }
        }
        return;
    }
    match item.as_table_like() {
        Some(table) => walk(alternative(schema, Holds::Table), table, &path, outline),
        None if item.as_value().is_some_and(|own| !own.is_array()) => {
            let holds = match item.as_value() {
                Some(Value::Boolean(_)) => Holds::Flag,
                Some(Value::Integer(_) | Value::Float(_)) => Holds::Number,
                _ => Holds::Text,
            };
            let key = described(path, alternative(schema, holds), false);
            // Of several ways to write it one description stands above all.
            let about = if key.about.is_empty() { about(schema) } else { key.about };
            // A free text where a word could stand is no choice.
            let is_one = item.as_str().is_some_and(|text| key.choices.iter().any(|own| own == text));
            outline.keys.push(Key { holds, about, choices: if is_one { key.choices } else { Vec::new() }, ..key });
        }
        None => {}
    }
}

/// The schema of the tables in a list, where it is one of tables.
fn items(schema: &Json) -> Option<&Json> {
    schema.get("items").filter(|items| items.get("properties").is_some())
}

/// That of several schemas by which a key may be read which fits.
fn alternative(schema: &Json, holds: Holds) -> &Json {
    let all = schema["anyOf"].as_array().map_or(&[][..], Vec::as_slice);
    all.iter().find(|own| held(own) == holds).unwrap_or(schema)
}

fn held(schema: &Json) -> Holds {
    let is = |kind: &str| schema["type"] == kind || schema["type"].as_array().is_some_and(|all| all[0] == kind);
    match () {
        () if schema.get("properties").is_some() => Holds::Table,
        () if is("integer") || is("number") => Holds::Number,
        () if is("boolean") => Holds::Flag,
        () => Holds::Text,
    }
}

fn about(schema: &Json) -> String {
    let text = schema["description"].as_str().unwrap_or_default();
    // The example has its own place.
    text.split(" (e.g. ").next().unwrap_or_default().to_string()
}

/// The keys of a table.
fn keys(table: &Json) -> Vec<Key> {
    let needed = |key: &str| table["required"].as_array().is_some_and(|all| all.iter().any(|own| own == key));
    let properties = table["properties"].as_object().into_iter().flatten();
    properties.map(|(key, own)| described(key.clone(), own, needed(key))).collect()
}

/// A key of which only the schema is known.
fn described(path: String, schema: &Json, is_needed: bool) -> Key {
    let first = schema["anyOf"].as_array().and_then(|all| all.first()).unwrap_or(schema);
    let words = first["enum"].as_array().into_iter().flatten();
    let mut choices: Vec<String> = words.filter_map(|own| own.as_str().map(str::to_string)).collect();
    let holds = held(first);
    if holds == Holds::Flag {
        choices = vec!["true".into(), "false".into()];
    }
    let text = |own: &Json| own.as_str().map_or_else(|| own.to_string(), str::to_string);
    let given = first.get("examples").and_then(|all| all.get(0)).or(first.get("default")).map(text);
    let example = given.or_else(|| choices.first().cloned()).unwrap_or_else(|| match holds {
        Holds::Number => "1".into(),
        Holds::Flag => "true".into(),
        Holds::Text => "\u{2026}".into(),
        Holds::Table => table_example(first),
    });
    let about = if about(schema).is_empty() { about(first) } else { about(schema) };
    Key { path, about, choices, holds, example, is_needed }
}

/// A table with what it cannot do without, or else with its first key.
fn table_example(schema: &Json) -> String {
    let all = keys(schema);
    let some =
        |is_wanted: fn(&Key) -> bool| all.iter().filter(|own| is_wanted(own)).map(assignment).collect::<Vec<_>>();
    let needed = some(|own| own.is_needed);
    let shown = if needed.is_empty() { all.iter().take(1).map(assignment).collect() } else { needed };
    format!("{{ {} }}", shown.join(", "))
}

fn assignment(key: &Key) -> String {
    match key.holds {
        Holds::Text => format!("{} = \"{}\"", key.path, key.example),
        _ => format!("{} = {}", key.path, key.example),
    }
}
