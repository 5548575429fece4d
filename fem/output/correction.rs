//! The answer of `fem correct`: what to command, and what will be left.

use serde_json::{Map, Value as Json, json};

use super::OutputError;
use super::answer::Answer;
use super::block::{Block, Cell, Column, Table};
use super::chart::{Svg, named};
use super::json::{finite, json as document};
use super::page::{Head, answered};
use super::staged::Staged;
use super::text::titled;
use super::{bands, csv, number, plots, program, tolerance};
use crate::compare::rms;
use crate::correct::{Correction, Masked, Offset, Programmed};
use crate::gcode;
use crate::model::Model;
use crate::process::{Advice, Column as Cells, Holds, Standing, Table as Sheet, range};
use crate::units::{Kind, TIME};

/// Changes of an offset below this are none, m: no control takes them.
const NONE: f64 = 1e-9;
/// Part of the largest error of which it is said that it is left between places.
const BETWEEN: f64 = 0.1;

/// The correction of a model, and the program that carries it, if one is given.
pub struct CorrectionAnswer<'a>(pub &'a Model, pub &'a Correction, pub Option<&'a Programmed>);

impl Answer for CorrectionAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(model, found, programmed) = *self;
        let title = titled(model.title.as_deref(), &model.source.name);
        let mut blocks = vec![Block::Sentence(format!("{title}: what to add to the {}", found.commanded.words))];
        blocks.push(self.errors());
        blocks.extend(cautions(found, self.kind()).into_iter().map(Block::Caution));
        blocks.extend(programmed.map(program::blocks).into_iter().flatten());
        let course = found.commanded.course;
        let beside = match programmed {
            Some(own) => Some((&own.with.offsets, " beside the program".to_string())),
            None => found.common.as_ref().map(|common| (&common.offsets, format!(" beside one {course}"))),
        };
        for (offsets, beside) in [(&found.offsets, String::new())].into_iter().chain(beside) {
            blocks.push(Block::Heading(format!("offset of the {}{beside}", found.commanded.words)));
            blocks.push(Block::List(self.offset_lines(offsets)));
        }
        if !found.advice.is_empty() {
            blocks.push(Block::Heading("beside the command".into()));
            blocks.push(Block::List(found.advice.iter().map(|advice| advice.text.clone()).collect()));
        }
        if !found.masked.is_empty() {
            blocks.push(Block::Heading("masked, not mended".into()));
            let kind = self.kind();
            let line = |own: &Masked| {
                let largest = number::fixed(kind.from_si(own.largest), 1);
                (format!("{}, up to {largest} {}", own.effect, kind.unit), own.why.to_string())
            };
            blocks.push(Block::Entries(found.masked.iter().map(line).collect()));
        }
        let [before, after] = &found.standings;
        if !before.is_empty() {
            blocks.push(Block::Heading("tolerance, as it is".into()));
            blocks.push(Block::List(tolerance::lines(before)));
            if let Some(common) = found.common.as_ref().filter(|common| common.offsets.len() > 1) {
                let standings = Standing::all(&*model.system, &found.rows, &common.left);
                let with = format!("tolerance, with one {course} and an offset{}", self.each());
                blocks.extend([Block::Heading(with), Block::List(tolerance::lines(&standings))]);
            }
            blocks.push(Block::Heading(format!("tolerance, with a {course}{}", self.each())));
            blocks.push(Block::List(tolerance::lines(after)));
        }
        blocks.extend(found.band.probability.as_ref().map(|own| Block::Sentence(tolerance::probability(own))));
        blocks
    }

    /// `fem correct --json`: `fem-correction/1`; SI.
    fn json(&self) -> Json {
        let Self(model, found, programmed) = *self;
        let coordinates = model.process.coordinates();
        let at = |row: usize, columns: &[usize]| -> Map<String, Json> {
            let one = |column: &usize| {
                let value = found.rows.columns[*column][row];
                let shown = match &coordinates[*column].holds {
                    Holds::Quantity(_) => finite(value),
                    Holds::Number(_) => json!(value as usize),
                    Holds::Word(words) => json!(words.of_value(value)),
                };
                (coordinates[*column].name.to_string(), shown)
            };
            columns.iter().map(one).collect()
        };
        let (key, shown): (_, Vec<usize>) = (found.commanded.key, shown(found).collect());
        let changed = |columns: &[usize], changes: &[f64]| -> Json {
            let one = |(row, change): (usize, &f64)| {
                let mut entry = at(row, columns);
                entry.insert(key.into(), finite(*change));
                Json::Object(entry)
            };
            changes.iter().enumerate().map(one).collect()
        };
        let left = found.left.iter().enumerate().map(|(row, value)| {
            let mut entry = at(row, &shown);
            entry.insert("value".into(), finite(*value));
            entry.insert("interval95".into(), found.band.interval[row].map(finite).into_iter().collect());
            Json::Object(entry)
        });
        let after = format!("after_{}", self.numbered().unwrap_or("part"));
        let offsets = |all: &[Offset]| {
            let one = |(number, change): (usize, f64)| json!({ after.as_str(): number, key: change });
            changes(all).into_iter().map(one).collect::<Json>()
        };
        // Rows of the first number stand for its contours.
        let of_one: Vec<usize> = shown.iter().copied().filter(|own| Some(*own) != found.commanded.number).collect();
        let probability = found.band.probability.as_ref();
        json!({
            "schema": "fem-correction/1",
            "model": &*model.source.name,
            "process": model.process.name(),
            "correction": changed(&shown, found.command.changes()),
            "left": left.collect::<Vec<_>>(),
            "unreached": found.unreached,
            "between": finite(found.between),
            "offsets": offsets(&found.offsets),
            "common_contour": found.common.as_ref().map(|common| changed(&of_one, &common.contour)),
            "common_offsets": found.common.as_ref().map(|common| offsets(&common.offsets)),
            "program": programmed.map(|own| program::json(own, key, offsets)),
            "rms": {
                "before": rms(&found.before),
                "with_offsets": rms(&found.left_by_offsets),
                "with_contour_and_offsets": found.common.as_ref().map(|common| rms(&common.left)),
                "left": rms(&found.left),
            },
            "actions": found.advice.iter().map(action).collect::<Vec<_>>(),
            "masked": found.masked.iter().map(|own| json!({ "effect": own.effect, "largest": finite(own.largest), "why": own.why })).collect::<Vec<_>>(),
            "uncertain_values": found.band.uncertain,
            "unexplained": finite(found.band.unexplained),
            "other_sets": found.band.others,
            "tolerance": {
                "probability_in": probability.map(|own| own.of_all),
                "parts": tolerance::parts(probability),
                "before": tolerance::json(&found.standings[0]),
                "after": tolerance::json(&found.standings[1]),
            },
        })
    }

    fn figures(&self) -> Vec<(String, Svg)> {
        plots::corrected(self.0, self.1).iter().map(named).collect()
    }

    /// `correction.csv` and `correction.json`, `correction.html` and its figures; of turned shafts `contour.ngc`, and the
    /// user's own program.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        self.stage_changes(files)?;
        if let (Some(work), [course]) = (self.0.system.program(), &self.1.common_courses()[..]) {
            let about = format!("{}: corrected finishing contour", self.0.source.name);
            if let Some(contour) = gcode::contour(&work, course, &about) {
                files.text("contour.ngc", &contour)?;
            }
        }
        if let Some(own) = self.2 {
            files.bytes(&*own.name, &own.corrected.bytes)?;
        }
        files.figures(self.figures())?;
        let head = Head::new("fem correct", self.0.title.as_deref(), &self.0.source.name, self.verdict());
        files.text("correction.html", &answered(head, self))?;
        files.text("correction.json", &document(self))
    }
}

impl CorrectionAnswer<'_> {
    /// `correction.csv`.
    pub(super) fn stage_changes(&self, files: &mut Staged) -> Result<(), OutputError> {
        files.text("correction.csv", &csv::table(&self.table()))
    }

    /// The change at every place of every part, what is left there, and its interval.
    pub fn table(&self) -> Sheet {
        let Self(model, found, _) = *self;
        let coordinates = model.process.coordinates();
        let of = |column: usize| Cells::coordinate(&coordinates[column], &found.rows.columns[column]);
        let kind = self.kind();
        let change = Cells::quantities(found.commanded.key, kind, found.command.changes());
        let left = Cells::quantities("left", kind, &found.left);
        let end = |which: usize| found.band.interval.iter().map(|own| own[which]).collect::<Vec<f64>>();
        let low = Cells::quantities("left_from", kind, &end(0));
        let high = Cells::quantities("left_to", kind, &end(1));
        let columns = shown(found).map(of).chain([change, left, low, high]).collect();
        Sheet { columns }
    }

    /// What is to be done, and what it comes to.
    fn verdict(&self) -> String {
        let Correction { commanded, before, left, band, rows, .. } = self.1;
        let aims = self.0.system.aims(rows);
        let off = |own: &[f64]| rms(&own.iter().zip(&aims).map(|(own, aim)| own - aim).collect::<Vec<f64>>());
        let kind = self.kind();
        let [before, left] = [before, left].map(|own| number::fixed(kind.from_si(off(own)), 2));
        let within = band.probability.as_ref().map(|own| format!("; {}", tolerance::probability(own)));
        format!(
            "with a {} corrected like this {left} {unit} rms off what is aimed at are left of {before} {unit}{}",
            commanded.course,
            within.unwrap_or_default(),
            unit = kind.unit
        )
    }

    /// What is left of the errors by each way of correcting them.
    fn errors(&self) -> Block {
        let Self(model, found, programmed) = *self;
        let kind = self.kind();
        let band = (!found.band.is_exact()).then(|| found.band.widest(0..found.rows.len()));
        let row = |name: String, values: &[f64], band: Option<f64>| {
            let (low, high) = range(values.iter().copied());
            let [rms, low, high] = [rms(values), low, high].map(|si| kind.from_si(si));
            let band = band.map_or(Cell::Missing, |si| Cell::number(kind.from_si(si)));
            vec![Cell::Text(name), Cell::number(rms), Cell::signed(low), Cell::signed(high), band]
        };
        let first = Column::new(&*model.process.observables()[found.commanded.observable].words, 46);
        let numbers = ["rms", "from", "to", "95 % ±"].map(|name| Column::new(name, 10));
        let columns = [first].into_iter().chain(numbers).chain([Column::remark(kind.unit.to_string(), 0)]);
        let (each, course) = (self.each(), found.commanded.course);
        let mut rows = vec![
            row("as it is".into(), &found.before, None),
            row(format!("with an offset{each}"), &found.left_by_offsets, band),
        ];
        // The same where there is one number.
        let common = found.common.as_ref().filter(|common| common.offsets.len() > 1);
        rows.extend(common.map(|own| row(format!("with one {course} and an offset{each}"), &own.left, band)));
        rows.push(row(format!("with a {course}{each}"), &found.left, band));
        rows.extend(programmed.map(|own| row(format!("with the program and an offset{each}"), &own.with.left, band)));
        Block::Table(Table::new(columns, rows))
    }

    /// Kind in which errors and changes are told: micrometres, or seconds of arc.
    fn kind(&self) -> Kind {
        self.0.process.observables()[self.1.commanded.observable].error_kind()
    }

    /// Name of what is numbered, if anything is.
    fn numbered(&self) -> Option<&str> {
        Some(&*self.0.process.coordinates()[self.1.commanded.number?].name)
    }

    fn each(&self) -> String {
        self.numbered().map_or_else(String::new, |number| format!(" for each {number}"))
    }

    /// The offsets as people enter them.
    fn offset_lines(&self, offsets: &[Offset]) -> Vec<String> {
        // Of a batch of which only the ends are predicted, the offset goes from the one to the other.
        let is_sampled = offsets.windows(2).any(|pair| pair[1].0 > pair[0].0.map(|number| number + 1));
        let (number, kind) = (self.numbered().unwrap_or_default(), self.kind());
        let line = |(after, change): (usize, f64)| {
            let when = match after {
                0 => "now".to_string(),
                after if is_sampled => format!("at {number} {}", after + 1),
                after => format!("after {number} {after}"),
            };
            format!("{when}: {} {}", number::signed(kind.from_si(change), 2), kind.unit)
        };
        changes(offsets).into_iter().map(line).collect()
    }
}

/// What a correction cannot do, or does not know.
fn cautions(found: &Correction, kind: Kind) -> Vec<String> {
    let mut all: Vec<String> = found.commanded.takes.map(str::to_string).into_iter().collect();
    all.extend(bands::failure(&found.band, kind));
    let worst = found.before.iter().fold(0.0f64, |worst, value| worst.max(value.abs()));
    if found.between > BETWEEN * worst {
        all.push(format!(
            "between the places up to {:.2} {} are left: what is there changes faster than {} places follow",
            kind.from_si(found.between),
            kind.unit,
            found.command.contours().iter().map(|(_, own)| own.len()).max().unwrap_or(0)
        ));
    }
    if found.unreached > 0 {
        all.push(format!(
            "{} of {} places cannot be brought to size: the tool does not reach there what it should",
            found.unreached,
            found.left.len()
        ));
    }
    if found.band.is_exact() {
        all.push("the model knows all its values exactly, so nothing is said of how far they may be off".into());
    }
    all
}

/// A piece of advice, SI but for minutes.
pub(super) fn action(advice: &Advice) -> Json {
    let (setting, from, to) =
        advice.setting.map_or((None, None, None), |(path, from, to)| (Some(path), Some(from), Some(to)));
    let minutes = advice.time.map(|seconds| TIME.from_si(seconds));
    json!({ "text": advice.text, "setting": setting, "from": from, "to": to, "gain": advice.gain, "minutes": minutes })
}

/// The coordinates that tell a row, by their positions.
fn shown(found: &Correction) -> impl Iterator<Item = usize> {
    found.commanded.apart().chain([found.commanded.along])
}

/// The offsets, each where it differs from the one before, with the number after which it is set.
fn changes(offsets: &[Offset]) -> Vec<(usize, f64)> {
    let mut all: Vec<(usize, f64)> = Vec::new();
    for (number, change) in offsets {
        if all.last().is_none_or(|(_, last)| (last - change).abs() > NONE) {
            all.push((number.map_or(0, |number| number.saturating_sub(1)), *change));
        }
    }
    all
}
