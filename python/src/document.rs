//! Model files as nested tables: read, written, and changed with every comment kept.

use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use serde_json::{Map, Value as Json};
use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, Value};

/// The keys of a model as JSON.
#[pyfunction]
pub fn keys(text: &str) -> PyResult<String> {
    Ok(plain_table(document(text)?.as_table().iter()).to_string())
}

/// The text of a model of these keys, as JSON.
#[pyfunction]
pub fn written(keys: &str) -> PyResult<String> {
    let Json::Object(keys) = parsed(keys)? else { return Err(PyValueError::new_err("expected a mapping of keys")) };
    Ok(DocumentMut::from(table(&keys)?).to_string())
}

/// The text with another value, as JSON, at a path of keys and of positions in arrays. Tables on the way are made.
#[pyfunction]
pub fn with_value(text: &str, path: Vec<String>, value: &str) -> PyResult<String> {
    let mut document = document(text)?;
    let (last, tables) = path.split_last().ok_or_else(|| PyValueError::new_err("expected a key"))?;
    let value = parsed(value)?;
    let mut parent = document.as_item_mut();
    for key in tables {
        if let Some(table) = parent.as_table_like_mut()
            && !table.contains_key(key)
        {
            let mut new = Table::new();
            new.set_implicit(true);
            table.insert(key, Item::Table(new));
        }
        parent = entered(parent, key)?;
    }
    if let Some(array) = parent.as_array_mut() {
        let known = last.parse().ok().and_then(|i: usize| array.get_mut(i)).ok_or_else(|| unknown(last))?;
        *known = beside(in_line(&value)?, known);
    } else if let Some(Item::Value(known)) = parent.get_mut(last) {
        *known = beside(in_line(&value)?, known);
    } else {
        let is_table = parent.is_table();
        let table = parent.as_table_like_mut().ok_or_else(|| unknown(last))?;
        table.insert(last, if is_table { item(&value)? } else { Item::Value(in_line(&value)?) });
    }
    Ok(document.to_string())
}

/// The text without the value at a path.
#[pyfunction]
pub fn without(text: &str, path: Vec<String>) -> PyResult<String> {
    let mut document = document(text)?;
    let (last, tables) = path.split_last().ok_or_else(|| PyValueError::new_err("expected a key"))?;
    let mut parent = document.as_item_mut();
    for key in tables {
        parent = entered(parent, key)?;
    }
    let removed = match parent.as_array_mut() {
        Some(array) => {
            let place = last.parse().ok().filter(|i: &usize| *i < array.len());
            place.map(|i| drop(array.remove(i)))
        }
        None => parent.as_table_like_mut().and_then(|table| table.remove(last)).map(drop),
    };
    removed.ok_or_else(|| unknown(last))?;
    Ok(document.to_string())
}

fn document(text: &str) -> PyResult<DocumentMut> {
    text.parse().map_err(|e: toml_edit::TomlError| PyValueError::new_err(e.to_string()))
}

fn parsed(json: &str) -> PyResult<Json> {
    serde_json::from_str(json).map_err(|e| PyValueError::new_err(e.to_string()))
}

fn unknown(key: &str) -> PyErr {
    PyKeyError::new_err(key.to_string())
}

fn entered<'i>(parent: &'i mut Item, key: &str) -> PyResult<&'i mut Item> {
    let is_list = parent.is_array() || parent.is_array_of_tables();
    let found = match key.parse::<usize>() {
        Ok(place) if is_list => parent.get_mut(place),
        _ => parent.get_mut(key),
    };
    found.ok_or_else(|| unknown(key))
}

/// A value with the comments and blanks of the one whose place it takes.
fn beside(mut value: Value, known: &Value) -> Value {
    *value.decor_mut() = known.decor().clone();
    value
}

/// What a key of a table holds: tables have lines of their own.
fn item(json: &Json) -> PyResult<Item> {
    match json {
        Json::Object(keys) => Ok(Item::Table(table(keys)?)),
        other => Ok(Item::Value(in_line(other)?)),
    }
}

fn table(keys: &Map<String, Json>) -> PyResult<Table> {
    let mut table = Table::new();
    // A table of nothing but tables needs no line of its own.
    table.set_implicit(!keys.is_empty() && keys.values().all(Json::is_object));
    for (key, value) in keys {
        table.insert(key, item(value)?);
    }
    Ok(table)
}

/// A value within a line.
fn in_line(json: &Json) -> PyResult<Value> {
    Ok(match json {
        Json::Null => return Err(PyValueError::new_err("a model has no None: leave the key out, or write \"?\"")),
        Json::Bool(flag) => (*flag).into(),
        Json::String(text) => text.into(),
        Json::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(count), _) => count.into(),
            (None, Some(number)) => number.into(),
            (None, None) => return Err(PyValueError::new_err(format!("{number} is no number of a model"))),
        },
        Json::Array(all) => all.iter().map(in_line).collect::<PyResult<Array>>()?.into(),
        Json::Object(keys) => {
            let entries = keys.iter().map(|(key, value)| Ok((key, in_line(value)?)));
            entries.collect::<PyResult<InlineTable>>()?.into()
        }
    })
}

fn plain_table<'t>(entries: impl Iterator<Item = (&'t str, &'t Item)>) -> Json {
    Json::Object(entries.map(|(key, item)| (key.to_string(), plain(item))).collect())
}

fn plain(item: &Item) -> Json {
    match item {
        Item::None => Json::Null,
        Item::Value(value) => plain_value(value),
        Item::Table(table) => plain_table(table.iter()),
        Item::ArrayOfTables(tables) => tables.iter().map(|table| plain_table(table.iter())).collect(),
    }
}

fn plain_value(value: &Value) -> Json {
    match value {
        Value::String(text) => text.value().clone().into(),
        Value::Integer(count) => (*count.value()).into(),
        Value::Float(number) => (*number.value()).into(),
        Value::Boolean(flag) => (*flag.value()).into(),
        Value::Datetime(moment) => moment.value().to_string().into(),
        Value::Array(all) => all.iter().map(plain_value).collect(),
        Value::InlineTable(table) => {
            Json::Object(table.iter().map(|(key, value)| (key.to_string(), plain_value(value))).collect())
        }
    }
}
