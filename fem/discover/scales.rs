//! Lengths and times that a model states, of which waves may have the period: leads, pitches of teeth, a day.

use std::f64::consts::TAU;

use toml_edit::{Document, Item, Table, Value};

use crate::input::Parameter;
use crate::model::Model;
use crate::units::{ANGLE, Kind, Knowledge, LENGTH, Quantity, TIME};

/// A day, s.
const DAY: f64 = 86_400.0;
/// Part of itself to within which two scales are one.
const SAME: f64 = 1e-9;
/// Most scales of one kind.
const MOST: usize = 12;

/// The scales of a model of the dimension of a kind, SI, rising.
pub fn scales(model: &Model, kind: Kind) -> Vec<f64> {
    let dimension = kind.canonical().dimension;
    let Some(own) = [LENGTH, TIME, ANGLE].into_iter().find(|own| own.canonical().dimension == dimension) else {
        return Vec::new();
    };
    let mut stated = Stated::default();
    if let Ok(document) = Document::parse(model.source.text.to_string()) {
        stated.of_table(document.as_table());
    }
    let mut all = match own {
        // A wheel comes round by a pitch; angles that a model states are places.
        ANGLE => stated.teeth.iter().map(|teeth| TAU / *teeth as f64).collect(),
        _ => stated.quantities(&own),
    };
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

/// What a model states.
#[derive(Default)]
struct Stated {
    texts: Vec<String>,
    /// Teeth of wheels.
    teeth: Vec<i64>,
}

impl Stated {
    /// The known quantities of a kind, SI.
    fn quantities(&self, kind: &Kind) -> Vec<f64> {
        let read = self.texts.iter().filter_map(|text| Quantity::parse(text, kind).ok());
        let known = read.filter(|quantity| quantity.knowledge == Knowledge::Known && quantity.value > 0.0);
        known.map(|quantity| quantity.value).collect()
    }

    fn of_table(&mut self, table: &Table) {
        for (key, item) in table {
            match item {
                Item::Value(value) => self.of_value(key, value),
                Item::Table(table) => self.of_table(table),
                Item::ArrayOfTables(tables) => tables.iter().for_each(|table| self.of_table(table)),
                Item::None => (),
            }
        }
    }

    fn of_value(&mut self, key: &str, value: &Value) {
        match value {
            Value::String(text) => self.texts.push(text.value().clone()),
            Value::Integer(count) if key == "teeth" && *count.value() > 0 => self.teeth.push(*count.value()),
            Value::Array(values) => values.iter().for_each(|value| self.of_value(key, value)),
            Value::InlineTable(table) => table.iter().for_each(|(key, value)| self.of_value(key, value)),
            _ => (),
        }
    }
}
