//! Lengths and times that a model states, of which waves may have the period: leads, pitches, a day.

use toml_edit::{Document, Item, Table, Value};

use crate::input::Parameter;
use crate::model::Model;
use crate::units::{Kind, Knowledge, LENGTH, Quantity, TIME};

/// A day, s.
const DAY: f64 = 86_400.0;
/// Part of itself to within which two scales are one.
const SAME: f64 = 1e-9;
/// Most scales of one kind.
const MOST: usize = 12;

/// The scales of a model of the dimension of a kind, SI, rising.
pub fn scales(model: &Model, kind: Kind) -> Vec<f64> {
    let dimension = kind.canonical().dimension;
    let Some(own) = [LENGTH, TIME].into_iter().find(|own| own.canonical().dimension == dimension) else {
        return Vec::new();
    };
    let mut texts = Vec::new();
    if let Ok(document) = Document::parse(model.source.text.to_string()) {
        of_table(document.as_table(), &mut texts);
    }
    let read = texts.iter().filter_map(|text| Quantity::parse(text, &own).ok());
    let known = read.filter(|quantity| quantity.knowledge == Knowledge::Known && quantity.value > 0.0);
    let mut all: Vec<f64> = known.map(|quantity| quantity.value).collect();
    if dimension == TIME.canonical().dimension {
        all.push(DAY);
    }
    all.sort_unstable_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() <= SAME * b.abs());
    all.truncate(MOST);
    all
}

/// The path of a known quantity of the machine that has this value (SI), by which a formula can name it.
pub fn name(model: &Model, kind: Kind, value: f64) -> Option<&str> {
    let is_plain = |path: &str| path.bytes().all(|b| b.is_ascii_alphanumeric() || b"_.".contains(&b));
    let is_it = |own: &&Parameter| {
        let Quantity { value: other, knowledge } = own.quantity;
        own.kind.canonical().dimension == kind.canonical().dimension
            && knowledge == Knowledge::Known
            && (other - value).abs() <= SAME * value.abs()
            && model.effect_of(&own.path).is_none()
            && own.path.contains('.')
            && is_plain(&own.path)
    };
    model.quantities.iter().find(is_it).map(|own| &*own.path)
}

fn of_table(table: &Table, texts: &mut Vec<String>) {
    for (_, item) in table {
        match item {
            Item::Value(value) => of_value(value, texts),
            Item::Table(table) => of_table(table, texts),
            Item::ArrayOfTables(tables) => tables.iter().for_each(|table| of_table(table, texts)),
            Item::None => (),
        }
    }
}

fn of_value(value: &Value, texts: &mut Vec<String>) {
    match value {
        Value::String(text) => texts.push(text.value().clone()),
        Value::Array(values) => values.iter().for_each(|value| of_value(value, texts)),
        Value::InlineTable(table) => table.iter().for_each(|(_, value)| of_value(value, texts)),
        _ => (),
    }
}
