//! Results as JSON. No NaN, no infinity: what is unknown is null.

use serde_json::{Map, Value as Json, json};

use crate::model::{Model, Run, Share};
use crate::process::{Case, Description, Neutral, Parameter, Process, Tolerance};

/// `summary.json`, and what `fem run --json` prints: `fem-run/1`.
pub fn run(model: &Model, run: &Run) -> Json {
    let mut findings = Map::new();
    for finding in &run.outcome.findings {
        findings.insert(finding.key.to_string(), finding.json.clone());
    }
    let observables = model.process.observables();
    let share = |s: &Share| {
        let kind = s.kind(observables);
        let [rms, smallest, largest] = [s.rms, s.smallest, s.largest].map(|si| kind.from_si(si));
        json!({ "effect": s.name, "observable": observables[s.observable].name, "rms": rms, "smallest": smallest, "largest": largest, "unit": kind.unit })
    };
    json!({
        "schema": "fem-run/1",
        "model": &*model.source.name,
        "title": model.title,
        "process": model.process.name(),
        "effects": model.effects.iter().map(|e| e.description.name).collect::<Vec<_>>(),
        "findings": findings,
        "shares": run.shares.iter().map(share).collect::<Vec<_>>(),
        "warnings": run.outcome.warnings,
    })
}

/// `fem effects --json`: one entry of the catalogue.
pub fn effect(process: &dyn Process, effect: &Description) -> Json {
    let neutral = |n: Neutral| match n {
        Neutral::Value(value) => json!(value),
        Neutral::Infinity => json!("infinity"),
        Neutral::Shape => Json::Null,
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
pub fn validation(cases: &[Case]) -> Json {
    let number = |x: f64| if x.is_finite() { json!(x) } else { Json::Null };
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
    json!({ "schema": "fem-validation/1", "cases": cases.iter().map(case).collect::<Vec<_>>() })
}
