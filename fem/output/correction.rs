//! The answer of `fem correct`: what to command, and what will be left.

use serde_json::{Map, Value as Json, json};

use super::OutputError;
use super::answer::Answer;
use super::block::{Block, Cell, Column, Table};
use super::json::{finite, json as document};
use super::staged::Staged;
use super::text::titled;
use super::{csv, number, tolerance};
use crate::compare::rms;
use crate::correct::Correction;
use crate::model::Model;
use crate::process::{Advice, Column as Cells, Holds, Table as Sheet, range};
use crate::units::{MICRO, TIME};

/// Changes of an offset below this are none, m: no control takes them.
const NONE: f64 = 1e-9;
/// Part of the largest error of which it is said that it is left between places.
const BETWEEN: f64 = 0.1;

/// The correction of a model.
pub struct CorrectionAnswer<'a>(pub &'a Model, pub &'a Correction);

impl Answer for CorrectionAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(model, found) = *self;
        let observable = &model.process.observables()[found.commanded.observable];
        let title = titled(model.title.as_deref(), &model.source.name);
        let mut blocks = vec![Block::Sentence(format!("{title}: what to add to the {}", found.commanded.words))];
        let row = |name: &str, values: &[f64], band: Option<f64>| {
            let (low, high) = range(values.iter().copied());
            let [rms, low, high] = [rms(values), low, high].map(|si| MICRO.from_si(si));
            let band = band.map_or(Cell::Missing, |si| Cell::number(MICRO.from_si(si)));
            vec![Cell::Text(name.into()), Cell::number(rms), Cell::signed(low), Cell::signed(high), band]
        };
        let band = (found.uncertain > 0).then(|| widest(found));
        let first = Column::new(&*observable.words, 42);
        let numbers = ["rms", "from", "to", "95 % ±"].map(|name| Column::new(name, 10));
        let columns = [first].into_iter().chain(numbers).chain([Column::remark(MICRO.unit.to_string(), 0)]);
        let each = numbered(model, found).map_or_else(String::new, |number| format!(" for each {number}"));
        let one = found.left_by_one.as_ref().map(|left| {
            let name = format!("with one {} and an offset{each}", found.commanded.course);
            row(&name, left, band)
        });
        let rows =
            [row("as it is", &found.before, None), row(&format!("with an offset{each}"), &found.left_by_offsets, band)];
        let last = row(&format!("with a {}{each}", found.commanded.course), &found.left, band);
        blocks.push(Block::Table(Table::new(columns, rows.into_iter().chain(one).chain([last]))));
        let worst = |all: &[f64]| all.iter().fold(0.0f64, |worst, value| worst.max(value.abs()));
        if found.between > BETWEEN * worst(&found.before) {
            blocks.push(Block::Caution(format!(
                "between the places up to {:.2} {} are left: what is there changes faster than {} places follow",
                MICRO.from_si(found.between),
                MICRO.unit,
                found.command.contours().iter().map(|(_, own)| own.len()).max().unwrap_or(0)
            )));
        }
        if found.unreached > 0 {
            blocks.push(Block::Caution(format!(
                "{} of {} places cannot be brought to size: the tool does not reach there what it should",
                found.unreached,
                found.left.len()
            )));
        }
        if found.uncertain == 0 {
            blocks.push(Block::Caution(
                "the model knows all its values exactly, so nothing is said of how far they may be off".into(),
            ));
        }
        blocks.push(Block::Heading(format!("offset of the {}", found.commanded.words)));
        let steps = changes(found);
        // Of a batch of which only the ends are predicted, the offset goes from the one to the other.
        let is_sampled = found.offsets.windows(2).any(|pair| pair[1].0 > pair[0].0.map(|number| number + 1));
        let line = |(after, change): &(usize, f64)| {
            let number = numbered(model, found).unwrap_or_default();
            let when = match *after {
                0 => "now".to_string(),
                after if is_sampled => format!("at {number} {}", after + 1),
                after => format!("after {number} {after}"),
            };
            format!("{when}: {} {}", number::signed(MICRO.from_si(*change), 2), MICRO.unit)
        };
        blocks.push(Block::List(steps.iter().map(line).collect()));
        if !found.advice.is_empty() {
            blocks.push(Block::Heading("beside the command".into()));
            blocks.push(Block::List(found.advice.iter().map(|advice| advice.text.clone()).collect()));
        }
        let [before, after] = &found.standings;
        if !before.is_empty() {
            blocks.push(Block::Heading("tolerance, as it is".into()));
            blocks.push(Block::List(tolerance::lines(before)));
            blocks.push(Block::Heading(format!("tolerance, with a {}{each}", found.commanded.course)));
            blocks.push(Block::List(tolerance::lines(after)));
        }
        if let Some(probability) = &found.probability {
            let least = probability.of_parts.iter().min_by(|a, b| a.1.total_cmp(&b.1));
            let of_least = least.and_then(|(part, p)| Some(format!("; part {} with {:.0} %", (*part)?, 100.0 * p)));
            blocks.push(Block::Sentence(format!(
                "{} within with a probability of {:.0} %{}",
                if probability.of_parts.len() > 1 { "all parts are" } else { "it is" },
                100.0 * probability.of_all,
                of_least.unwrap_or_default()
            )));
        }
        blocks
    }

    /// `fem correct --json`: `fem-correction/1`; SI.
    fn json(&self) -> Json {
        let Self(model, found) = *self;
        let coordinates = model.process.coordinates();
        let at = |row: usize| -> Map<String, Json> {
            let one = |column: usize| {
                let value = found.rows.columns[column][row];
                let shown = match &coordinates[column].holds {
                    Holds::Quantity(_) => finite(value),
                    Holds::Number(_) => json!(value as usize),
                    Holds::Word(words) => json!(words.of_value(value)),
                };
                (coordinates[column].name.to_string(), shown)
            };
            shown(found).map(one).collect()
        };
        let correction = found.command.changes().iter().enumerate().map(|(row, change)| {
            let mut entry = at(row);
            entry.insert(found.commanded.key.into(), finite(*change));
            Json::Object(entry)
        });
        let left = found.left.iter().enumerate().map(|(row, value)| {
            let mut entry = at(row);
            entry.insert("value".into(), finite(*value));
            entry.insert("interval95".into(), found.interval[row].map(finite).into_iter().collect());
            Json::Object(entry)
        });
        let key = found.commanded.key;
        let after_number = format!("after_{}", numbered(model, found).unwrap_or("part"));
        let probability = found.probability.as_ref();
        json!({
            "schema": "fem-correction/1",
            "model": &*model.source.name,
            "process": model.process.name(),
            "correction": correction.collect::<Vec<_>>(),
            "left": left.collect::<Vec<_>>(),
            "unreached": found.unreached,
            "between": finite(found.between),
            "offsets": changes(found).iter().map(|(after, change)| json!({ after_number.as_str(): after, key: change })).collect::<Vec<_>>(),
            "rms": {
                "before": rms(&found.before),
                "with_offsets": rms(&found.left_by_offsets),
                "with_one_contour": found.left_by_one.as_deref().map(rms),
                "left": rms(&found.left),
            },
            "actions": found.advice.iter().map(action).collect::<Vec<_>>(),
            "uncertain_values": found.uncertain,
            "tolerance": {
                "probability_in": probability.map(|own| own.of_all),
                "parts": probability.map(|own| own.of_parts.iter().map(|(part, p)| json!({ "part": part, "probability_in": p })).collect::<Vec<_>>()),
                "before": tolerance::json(&found.standings[0]),
                "after": tolerance::json(&found.standings[1]),
            },
        })
    }

    /// `correction.csv` and `correction.json`.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        let Self(model, found) = *self;
        let coordinates = model.process.coordinates();
        let of = |column: usize| Cells::coordinate(&coordinates[column], &found.rows.columns[column]);
        let change = Cells::quantities(found.commanded.key, MICRO, found.command.changes());
        let left = Cells::quantities("left", MICRO, &found.left);
        let end = |which: usize| found.interval.iter().map(|own| own[which]).collect::<Vec<f64>>();
        let low = Cells::quantities("left_from", MICRO, &end(0));
        let high = Cells::quantities("left_to", MICRO, &end(1));
        let columns = shown(found).map(of).chain([change, left, low, high]).collect();
        files.text("correction.csv", &csv::table(&Sheet { columns }))?;
        files.text("correction.json", &document(self))
    }
}

/// A piece of advice, SI but for minutes.
fn action(advice: &Advice) -> Json {
    let (setting, from, to) =
        advice.setting.map_or((None, None, None), |(path, from, to)| (Some(path), Some(from), Some(to)));
    let minutes = advice.time.map(|seconds| TIME.from_si(seconds));
    json!({ "text": advice.text, "setting": setting, "from": from, "to": to, "gain": advice.gain, "minutes": minutes })
}

/// The coordinates that tell a row, by their positions.
fn shown(found: &Correction) -> impl Iterator<Item = usize> {
    found.commanded.apart().chain([found.commanded.along])
}

/// Name of what is numbered, if anything is.
fn numbered<'a>(model: &'a Model, found: &Correction) -> Option<&'a str> {
    Some(&*model.process.coordinates()[found.commanded.number?].name)
}

/// The offsets, each where it differs from the one before, with the number after which it is set.
fn changes(found: &Correction) -> Vec<(usize, f64)> {
    let mut all: Vec<(usize, f64)> = Vec::new();
    for (number, change) in &found.offsets {
        if all.last().is_none_or(|(_, last)| (last - change).abs() > NONE) {
            all.push((number.map_or(0, |number| number.saturating_sub(1)), *change));
        }
    }
    all
}

/// The widest half of an interval that holds what is left with 95 %.
fn widest(found: &Correction) -> f64 {
    found.interval.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.0, f64::max)
}
