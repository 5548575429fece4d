//! Reports as JSON. No NaN, no infinity: what is unknown is null.

use serde_json::{Map, Value, json};

use super::report::{Format, Report};
use super::{OutputError, budget, comparison, compensation, diagnosis, fit, measurement, plan, study};

use crate::model::{Contribution, Model, Run};
use crate::process::{Datum, Description, Figure, Neutral, Parameter, Process};
use crate::units::{Kind, UnitSymbol};
use crate::validation::{Case, Tolerance};

/// One JSON document per report.
pub struct Json;

impl Format for Json {
    fn write(&self, report: &Report) -> Result<String, OutputError> {
        let mut value = match report {
            Report::Run(model, found) => run(model, found),
            Report::Comparison(models, measurements, comparisons) => {
                let [first, ..] = models else { return Ok(String::new()) };
                comparison::json(&*first.process, measurements, comparisons)
            }
            Report::Fit(data, found) => fit::json(data, found),
            Report::Diagnosis(data, found) => diagnosis::json(data, found),
            Report::Plan(design, found) => plan::json(design, found),
            Report::Compensation(data, found, supplied) => compensation::json(data, found, supplied),
            Report::Budget(file, estimate) => budget::json(file, *estimate),
            Report::Study(layout, summary) => study::json(layout, summary),
            Report::Effects(entries, of_measurement, _) => {
                let own = entries.iter().map(|(process, e)| effect(*process, e));
                own.chain(of_measurement.iter().map(|e| measurement::entry(e))).collect()
            }
            Report::Validation(cases, total) => validation(cases, *total),
        };
        let undone = report.left_undone();
        if let (Value::Object(all), false) = (&mut value, undone.is_empty()) {
            all.insert("left_undone".into(), json!(undone));
        }
        Ok(format!("{value:#}\n"))
    }
}

/// `summary.json`, and what `fem run --json` prints: `fem-run/1`.
fn run(model: &Model, run: &Run) -> Value {
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
        "effects": model.effects.iter().map(|e| e.description.name.clone()).collect::<Vec<_>>(),
        "measurement": measurement::json(&model.measurement, &*model.process, None),
        "findings": findings,
        "shares": run.contributions.iter().map(share).collect::<Vec<_>>(),
        "warnings": run.report.warnings,
    })
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
        let number = |value: f64| if value.is_finite() { json!(value) } else { Value::Null };
        match datum {
            Datum::Quantity(kind, si) => {
                self.note(key, kind);
                number(kind.from_si(*si))
            }
            Datum::Quantities(kind, values) => {
                self.note(key, kind);
                values.iter().map(|si| number(kind.from_si(*si))).collect()
            }
            Datum::Number(value) => number(*value),
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
        if kind.unit.is_empty() || self.used.iter().any(|(_, unit)| *unit == kind.unit) {
            return;
        }
        let said = self.keys.iter().find(|(_, k)| k.unit == kind.unit).map(|(key, _)| key.to_string());
        let is_taken =
            self.used.iter().any(|(key, _)| key == "unit") || self.keys.iter().any(|(key, _)| *key == "unit");
        let usual = || if is_taken { format!("{key}_unit") } else { "unit".to_string() };
        self.used.push((said.unwrap_or_else(usual), kind.unit));
    }
}

/// `fem effects --json`: one entry of the catalogue.
fn effect(process: &dyn Process, effect: &Description) -> Value {
    let neutral = |n: Neutral| match n {
        Neutral::Value(value) => json!(value),
        Neutral::Infinity => json!("infinity"),
        Neutral::Shape => Value::Null,
    };
    let parameter = |p: &Parameter| {
        json!({
            "name": p.name,
            "unit": p.kind.unit,
            "neutral": neutral(p.neutral),
            "range": [p.range.0, p.range.1],
            "about": p.about,
            "default": p.default.map(|si| p.kind.from_si(si)),
        })
    };
    json!({
        "process": process.name(),
        "effect": effect.name,
        "about": effect.about,
        "law": effect.law,
        "source": effect.source,
        "parameters": effect.parameters.iter().map(parameter).collect::<Vec<_>>(),
        "look_alikes": effect.look_alikes.iter().map(|l| l.0).collect::<Vec<_>>(),
        "separated_by": effect.look_alikes.iter().map(|l| l.1).collect::<Vec<_>>(),
    })
}

/// `fem validate --json`: `fem-validation/1`.
fn validation(cases: &[Case], total: usize) -> Value {
    let number = |x: f64| if x.is_finite() { json!(x) } else { Value::Null };
    let case = |c: &Case| {
        json!({
            "name": c.name,
            "quantity": c.quantity,
            "expected": number(c.expected),
            "computed": number(c.computed),
            "unit": c.unit,
            "error": number(c.error()),
            "error_is": match c.tolerance { Tolerance::Relative(_) => "relative", Tolerance::Absolute(_) => "absolute" },
            "tolerance": c.allowed(),
            "source": c.source,
            "passed": c.passed(),
        })
    };
    json!({ "schema": "fem-validation/1", "cases": cases.iter().map(case).collect::<Vec<_>>(), "total": total })
}
