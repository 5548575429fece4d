//! The answer of `fem run`: what a model predicts.

use std::path::Path;

use serde_json::{Map, Value, json};

use super::OutputError;
use super::answer::Answer;
use super::block::{Block, Cell, Column, Table};
use super::chart::{Svg, named};
use super::json::{finite, json as document};
use super::staged::Staged;
use super::text::titled;
use super::{allowed, bands, csv, drawing, measurement, plots, sketch, tolerance};
use crate::knowledge::Band;
use crate::model::{Contribution, Model, Run};
use crate::process::{Datum, Figure, Observable};
use crate::units::{Kind, UnitSymbol};

/// The prediction of a model, and how far it may be off where the model knows its values only roughly.
#[derive(Clone, Copy)]
pub struct RunAnswer<'a>(pub &'a Model, pub &'a Run, pub Option<&'a Band>);

impl Answer for RunAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(model, run, band) = *self;
        let title = titled(model.title.as_deref(), &model.source.name);
        let mut text = format!("{title}\n{}: {}\n\n", model.process.name(), model.process.about());
        for figure in &run.report.figures {
            text += &labelled(&figure.label, &figure.lines);
        }
        if !run.standings.is_empty() {
            text += &labelled("tolerance", &tolerance::lines(&run.standings));
        }
        if let Some(band) = band {
            text += &labelled("95 % band", &bands::lines(model, band));
        }
        if let Some(failure) = band.and_then(|band| bands::failure(band, model.process.size_kind())) {
            text += &format!("\ncaution: {failure}\n");
        }
        let own = measurement::at_work(&model.source.name, &model.measurement, &*model.process, None);
        if !own.is_empty() {
            text += &format!("\n{own}a run predicts the part, and leaves the instrument aside\n");
        }
        let observables = model.process.observables();
        let shares = run.contributions.chunk_by(|a, b| a.observable == b.observable);
        let tables = shares.map(|shares| Block::Table(changes(observables, shares)));
        let untold: String = run.untold.iter().map(|own| format!("\ncaution: {}\n", own.clause())).collect();
        let untold = (!untold.is_empty()).then_some(Block::Lines(untold));
        let curves = run.report.plots.iter().cloned().map(Block::Curve);
        [Block::Lines(text)].into_iter().chain(tables).chain(untold).chain(curves).collect()
    }

    /// `summary.json`, and what `fem run --json` prints: `fem-run/1`.
    fn json(&self) -> Value {
        let Self(model, run, band) = *self;
        let findings: Map<String, Value> = run.report.figures.iter().map(|f| (f.key.to_string(), figure(f))).collect();
        let observables = model.process.observables();
        let share = |s: &Contribution| {
            let kind = s.kind(observables);
            let [rms, smallest, largest] = [s.rms, s.smallest, s.largest].map(|si| kind.from_si(si));
            json!({ "effect": s.name, "observable": observables[s.observable].name, "rms": rms, "smallest": smallest, "largest": largest, "unit": kind.unit })
        };
        json!({
            "schema": "fem-run/1",
            "model": &*model.source.name,
            "title": model.title,
            "process": model.process.name(),
            "effects": model.effects.iter().map(|e| &e.description.name).collect::<Vec<_>>(),
            "measurement": measurement::json(&model.measurement, &*model.process, None),
            "findings": findings,
            "tolerance": tolerance::json(&run.standings),
            "band": band.map(|band| bands::json(model, band)),
            "shares": run.contributions.iter().map(share).collect::<Vec<_>>(),
            "untold": run.untold.iter().map(|own| json!({ "effect": own.name, "why": own.why.message })).collect::<Vec<_>>(),
            "warnings": run.report.warnings,
        })
    }

    /// Machine and contours, then curves and maps.
    fn figures(&self) -> Vec<(String, Svg)> {
        let charts = plots::predicted(self.0, self.1, self.2).into_iter().chain(plots::parts(self.0, self.1));
        drawings(self.1).into_iter().chain(charts.map(|chart| named(&chart))).collect()
    }

    /// `profile.csv`, further tables as `NAME.csv`, `bands.csv` where values are known roughly, the animation as
    /// `NAME.pvd` with its frames in `NAME/`, `allowed.pvd` where the drawing asks something, figures as
    /// `NAME.svg`, and `summary.json`.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        let Self(model, run, band) = *self;
        let found = &run.report;
        let tables = [("profile", &found.profile)].into_iter().chain(found.tables.iter().map(|(name, t)| (*name, t)));
        for (name, table) in tables {
            files.text(format!("{name}.csv"), &csv::table(table))?;
        }
        for (name, table) in band
            .map(|band| bands::tables(model, &model.system.programme(), &run.prediction, band))
            .into_iter()
            .flatten()
        {
            files.text(format!("{name}.csv"), &csv::table(&table))?;
        }
        for (number, animation) in found.animations.iter().enumerate() {
            let script = if number == 0 { "view.py".into() } else { format!("view-{}.py", animation.name) };
            files.animation(animation, &script, model, Path::new(""))?;
        }
        if let Some(animation) = allowed::animation(model, run, band) {
            files.animation(&animation, "view-allowed.py", model, Path::new(""))?;
        }
        files.figures(self.figures())?;
        files.text("summary.json", &document(self))
    }
}

/// Lines behind a label: the first one beside it, the others below it.
fn labelled(label: &str, lines: &[String]) -> String {
    format!("  {label:<24} {}\n", lines.join(&format!("\n{:27}", "")))
}

/// The machine to scale, and the contours that it makes.
pub fn drawings(run: &Run) -> Vec<(String, Svg)> {
    let machine = run.report.sketch.iter().map(|s| ("machine".to_string(), sketch::sketch(s)));
    machine.chain(run.report.drawings.iter().map(|d| (d.name.to_string(), drawing::drawing(d)))).collect()
}

/// Contributions to one observable, which all of `shares` have in common.
fn changes(observables: &[Observable], shares: &[Contribution]) -> Table {
    let observable = &observables[shares[0].observable];
    let (whole, change) = (observable.kind.unit, observable.error_kind().unit);
    let unit = if whole == change { whole.to_string() } else { format!("{whole}, changes in {change}") };
    let numbers = ["rms", "from", "to"].map(|name| Column::new(name, 10));
    let first = Column::new(format!("what changes {}", observable.words), 27);
    let columns = [first].into_iter().chain(numbers).chain([Column::remark(unit, 0)]);
    Table::new(columns, shares.iter().map(|share| change_of(share, observables).into()))
}

/// The cells of a contribution: its name, root mean square, smallest and largest change.
pub fn change_of(share: &Contribution, observables: &[Observable]) -> [Cell; 4] {
    let kind = share.kind(observables);
    let name = if share.name == "ideal" { "without any effect" } else { &share.name };
    let [rms, low, high] = [share.rms, share.smallest, share.largest].map(|si| kind.from_si(si));
    [Cell::Text(name.into()), Cell::number(rms), Cell::signed(low), Cell::signed(high)]
}

/// A figure: its entries, then the units in which they are told.
fn figure(figure: &Figure) -> Value {
    let mut units = Units { keys: figure.unit_keys.clone(), used: Vec::new() };
    let mut all = Map::new();
    for (key, entry) in &figure.entries {
        all.insert(key.to_string(), units.datum(key, entry));
    }
    for (key, unit) in units.used {
        all.insert(key, json!(unit));
    }
    Value::Object(all)
}

/// The units of a figure, and the keys under which they are told.
struct Units {
    keys: Vec<(&'static str, Kind)>,
    used: Vec<(String, UnitSymbol)>,
}

impl Units {
    fn datum(&mut self, key: &str, datum: &Datum) -> Value {
        match datum {
            Datum::Quantity(kind, si) => {
                self.note(key, kind);
                finite(kind.from_si(*si))
            }
            Datum::Quantities(kind, values) => {
                self.note(key, kind);
                values.iter().map(|si| finite(kind.from_si(*si))).collect()
            }
            Datum::Number(value) => finite(*value),
            Datum::Count(count) => json!(count),
            Datum::Flag(flag) => json!(flag),
            Datum::Word(word) => json!(word),
            Datum::Missing => Value::Null,
            Datum::Record(entries) => {
                Value::Object(entries.iter().map(|(key, entry)| (key.to_string(), self.datum(key, entry))).collect())
            }
            Datum::List(list) => list.iter().map(|entry| self.datum(key, entry)).collect(),
        }
    }

    fn note(&mut self, key: &str, kind: &Kind) {
        if kind.unit.is_empty() || self.used.iter().any(|(_, unit)| kind.unit == *unit) {
            return;
        }
        let said = self.keys.iter().find(|(_, k)| k.unit == kind.unit).map(|(key, _)| key.to_string());
        let is_taken =
            self.used.iter().any(|(key, _)| key == "unit") || self.keys.iter().any(|(key, _)| *key == "unit");
        let usual = || if is_taken { format!("{key}_unit") } else { "unit".to_string() };
        self.used.push((said.unwrap_or_else(usual), kind.unit));
    }
}
