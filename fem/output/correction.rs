//! The answer of `fem correct`: what to command, and what will be left.

use serde_json::{Map, Value as Json, json};

use super::OutputError;
use super::answer::Answer;
use super::block::{Block, Cell, Column, Table};
use super::json::{finite, json as document};
use super::staged::Staged;
use super::text::titled;
use super::{csv, number, program, tolerance};
use crate::compare::rms;
use crate::correct::{Correction, Programmed};
use crate::gcode;
use crate::model::Model;
use crate::process::{Column as Cells, Table as Sheet, range};
use crate::units::MICRO;

/// Changes of an offset below this are none, m: no control takes them.
const NONE: f64 = 1e-9;

/// The correction of a model, and the program that carries it, if one is given.
pub struct CorrectionAnswer<'a>(pub &'a Model, pub &'a Correction, pub Option<&'a Programmed>);

impl Answer for CorrectionAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(model, found, programmed) = *self;
        let observable = &model.process.observables()[found.commanded.observable];
        let title = titled(model.title.as_deref(), &model.source.name);
        let mut blocks =
            vec![Block::Sentence(format!("{title}: what to add to the programmed {}", found.commanded.words))];
        let row = |name: &str, values: &[f64], band: Option<f64>| {
            let (low, high) = range(values.iter().copied());
            let [rms, low, high] = [rms(values), low, high].map(|si| MICRO.from_si(si));
            let band = band.map_or(Cell::Missing, |si| Cell::number(MICRO.from_si(si)));
            vec![Cell::Text(name.into()), Cell::number(rms), Cell::signed(low), Cell::signed(high), band]
        };
        let band = (found.uncertain > 0).then(|| widest(found));
        let first = Column::new(&*observable.words, 46);
        let numbers = ["rms", "from", "to", "95 % ±"].map(|name| Column::new(name, 10));
        let columns = [first].into_iter().chain(numbers).chain([Column::remark(MICRO.unit.to_string(), 0)]);
        let mut rows = vec![
            row("as it is", &found.before, None),
            row("with an offset for each part", &found.left_by_offsets, band),
            row("with one contour and an offset for each part", &found.common.left, band),
            row("with a contour for each part", &found.left, band),
        ];
        rows.extend(programmed.map(|own| row("with the program and an offset for each part", &own.with.left, band)));
        blocks.push(Block::Table(Table::new(columns, rows)));
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
        blocks.push(offset_list(&found.offsets));
        blocks.extend(programmed.map(program::blocks).into_iter().flatten());
        let (beside, of) = match programmed {
            Some(own) => (&own.with.offsets, "the program"),
            None => (&found.common.offsets, "one contour"),
        };
        blocks.push(Block::Heading(format!("offset of the {} beside {of}", found.commanded.words)));
        blocks.push(offset_list(beside));
        let [before, after] = &found.standings;
        if !before.is_empty() {
            blocks.push(Block::Heading("tolerance, as it is".into()));
            blocks.push(Block::List(tolerance::lines(before)));
            blocks.push(Block::Heading("tolerance, with a contour for each part".into()));
            blocks.push(Block::List(tolerance::lines(after)));
        }
        if let Some(probability) = &found.probability {
            let least = probability.of_parts.iter().min_by(|a, b| a.1.total_cmp(&b.1));
            let of_least = least.and_then(|(part, p)| Some(format!("; part {} with {:.0} %", (*part)?, 100.0 * p)));
            blocks.push(Block::Sentence(format!(
                "all parts are within with a probability of {:.0} %{}",
                100.0 * probability.of_all,
                of_least.unwrap_or_default()
            )));
        }
        blocks
    }

    /// `fem correct --json`: `fem-correction/1`; SI.
    fn json(&self) -> Json {
        let Self(model, found, programmed) = *self;
        let coordinates = model.process.coordinates();
        let shown = [found.commanded.along, found.commanded.number];
        let at = |row: usize| -> Map<String, Json> {
            let one = |column: &usize| {
                let value = found.rows.columns[*column][row];
                let is_number = *column == found.commanded.number;
                (coordinates[*column].name.to_string(), if is_number { json!(value as usize) } else { finite(value) })
            };
            shown.iter().map(one).collect()
        };
        let correction = found.command.changes.iter().enumerate().map(|(row, change)| {
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
        let probability = found.probability.as_ref();
        let offsets = |all: &[(usize, f64)]| {
            let one = |(after, change): (usize, f64)| json!({ "after_part": after, key: change });
            changes(all).into_iter().map(one).collect::<Json>()
        };
        let along = &*coordinates[found.commanded.along].name;
        let contour = found.command.places.iter().zip(&found.common.contour);
        json!({
            "schema": "fem-correction/1",
            "model": &*model.source.name,
            "process": model.process.name(),
            "correction": correction.collect::<Vec<_>>(),
            "left": left.collect::<Vec<_>>(),
            "unreached": found.unreached,
            "offsets": offsets(&found.offsets),
            "common_contour": contour.map(|(x, change)| json!({ along: x, key: change })).collect::<Vec<_>>(),
            "common_offsets": offsets(&found.common.offsets),
            "program": programmed.map(|own| program::json(own, key, offsets)),
            "rms": {
                "before": rms(&found.before),
                "with_offsets": rms(&found.left_by_offsets),
                "with_contour_and_offsets": rms(&found.common.left),
                "left": rms(&found.left),
            },
            "uncertain_values": found.uncertain,
            "tolerance": {
                "probability_in": probability.map(|own| own.of_all),
                "parts": probability.map(|own| own.of_parts.iter().map(|(part, p)| json!({ "part": part, "probability_in": p })).collect::<Vec<_>>()),
                "before": tolerance::json(&found.standings[0]),
                "after": tolerance::json(&found.standings[1]),
            },
        })
    }

    /// `correction.csv` and `correction.json`; of a process with programs `contour.ngc` and the user's own.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        let Self(model, found, programmed) = *self;
        let coordinates = model.process.coordinates();
        let of = |column: usize| Cells::coordinate(&coordinates[column], &found.rows.columns[column]);
        let change = Cells::quantities(found.commanded.key, MICRO, &found.command.changes);
        let left = Cells::quantities("left", MICRO, &found.left);
        let end = |which: usize| found.interval.iter().map(|own| own[which]).collect::<Vec<f64>>();
        let low = Cells::quantities("left_from", MICRO, &end(0));
        let high = Cells::quantities("left_to", MICRO, &end(1));
        let columns = vec![of(found.commanded.number), of(found.commanded.along), change, left, low, high];
        files.text("correction.csv", &csv::table(&Sheet { columns }))?;
        if let Some(work) = model.system.program() {
            let about = format!("{}: corrected finishing contour", model.source.name);
            let contour = gcode::contour(&work, (&found.command.places, &found.common.contour), &about);
            files.text("contour.ngc", &contour)?;
        }
        if let Some(own) = programmed {
            files.bytes(&*own.name, &own.corrected.bytes)?;
        }
        files.text("correction.json", &document(self))
    }
}

/// The offsets as people enter them.
fn offset_list(offsets: &[(usize, f64)]) -> Block {
    let line = |(after, change): &(usize, f64)| {
        let when = if *after == 0 { "now".to_string() } else { format!("after part {after}") };
        format!("{when}: {} {}", number::signed(MICRO.from_si(*change), 2), MICRO.unit)
    };
    Block::List(changes(offsets).iter().map(line).collect())
}

/// The offsets, each where it differs from the one before, with the part after which it is set.
fn changes(offsets: &[(usize, f64)]) -> Vec<(usize, f64)> {
    let mut all: Vec<(usize, f64)> = Vec::new();
    for (number, change) in offsets {
        if all.last().is_none_or(|(_, last)| (last - change).abs() > NONE) {
            all.push((number.saturating_sub(1), *change));
        }
    }
    all
}

/// The widest half of an interval that holds what is left with 95 %.
fn widest(found: &Correction) -> f64 {
    found.interval.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.0, f64::max)
}
