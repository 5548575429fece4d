//! Writes a plan as text and JSON.

use std::fmt::Write;

use serde_json::{Value as Json, json};

use super::diagnosis::{bound, next as next_json};
use super::measurement;
use crate::diagnose::Plan;
use crate::measure::MeasuredObservable;
use crate::model::Data;

/// Makes the JSON of `fem plan --json`: `fem-plan/1`.
pub fn json(design: &Data, plan: &Plan) -> Json {
    let noise = |(seen, sigma): (&MeasuredObservable, &f64)| json!({ "observable": seen.name, "sigma": seen.kind.from_si(*sigma), "unit": seen.kind.unit });
    let mut noise: Vec<Json> = design.observables.iter().zip(&plan.sigma).map(noise).collect();
    let effect = |(d, v): &(crate::process::Description, Option<crate::diagnose::DetectionLimit>)| {
        let unit = v.as_ref().and_then(|v| d.parameters.iter().find(|p| p.name == v.parameter)).map(|p| p.kind.unit);
        json!({
            "effect": d.name,
            "observable": d.observable,
            "visible": v.as_ref().is_some_and(|v| v.detectable),
            "parameter": v.as_ref().map(|v| &v.parameter),
            "smallest": v.as_ref().and_then(|v| v.smallest),
            "unit": unit,
            "own_share": v.as_ref().map(|v| v.own_share),
        })
    };
    json!({
        "schema": "fem-plan/1",
        "model": &*design.model.source.name,
        "design": design.name,
        "observations": plan.rows,
        "measurement": measurement::json(&plan.terms, &*design.model.process, Some(design)),
        "left_aside": measurement::json(&plan.unknown, &*design.model.process, Some(design)),
        "cautions": design.cautions,
        "noise": if noise.len() == 1 { noise.remove(0) } else { json!(noise) },
        "effects": plan.effects.iter().map(effect).collect::<Vec<_>>(),
        "alike": plan.alike.iter().map(|a| json!({ "effects": [&a.one.name, &a.other.name], "separation": a.separation })).collect::<Vec<_>>(),
        "next_measurement": plan.next.as_ref().map(|n| next_json(n, design.model)),
    })
}

/// Most pairs that are told, the most alike first.
const MOST_PAIRS: usize = 12;

/// Writes a plan for people. Writing to a String does not fail.
pub fn text(design: &Data, plan: &Plan) -> String {
    let noise =
        |(seen, sigma): (&MeasuredObservable, &f64)| format!("{:.3} {}", seen.kind.from_si(*sigma), seen.kind.unit);
    let noise: Vec<String> = design.observables.iter().zip(&plan.sigma).map(noise).collect();
    let mut text =
        format!("{}: {} rows of {}, noise {}\n", design.model.source.name, plan.rows, design.name, noise.join(" and "));
    let model = &design.model.source.name;
    text.push_str(&measurement::at_work(model, &plan.terms, &*design.model.process, Some(design)));
    if !plan.unknown.is_empty() {
        let names: Vec<&str> = plan.unknown.iter().map(|t| t.effect.name).collect();
        let _ = writeln!(text, "{} left aside, for no size is known", names.join(", "));
    }
    for caution in &design.cautions {
        let _ = writeln!(text, "caution: {caution}");
    }
    let visible = || plan.effects.iter().filter_map(|(d, v)| v.as_ref().filter(|v| v.detectable).map(|v| (d, v)));
    let width = plan.effects.iter().map(|e| e.0.label().len()).max().unwrap_or(0);
    let _ = writeln!(text, "\nwould be seen, nine times in ten at a usual shape, from");
    for (d, v) in visible() {
        let size = v.smallest.map_or(String::new(), |s| bound(d, &v.parameter, s));
        let _ = writeln!(text, "  {:<width$}  {size:<28} {:>3.0} % of it is its own", d.label(), 100.0 * v.own_share);
    }
    let hidden: Vec<_> =
        plan.effects.iter().filter(|(_, v)| !v.as_ref().is_some_and(|v| v.detectable)).map(|e| e.0.label()).collect();
    if !hidden.is_empty() {
        let _ = writeln!(text, "\nwould not be seen: {}", hidden.join(", "));
    }
    if !plan.alike.is_empty() {
        let _ = writeln!(text, "\nwould look alike");
        for a in plan.alike.iter().take(MOST_PAIRS) {
            let _ = writeln!(
                text,
                "  {} and {}, {:.1} sigma apart where either shows by 15",
                a.one.label(),
                a.other.label(),
                a.separation
            );
        }
    }
    if plan.alike.len() > MOST_PAIRS {
        let _ = writeln!(text, "  and {} pairs more (--json has them all)", plan.alike.len() - MOST_PAIRS);
    }
    if let Some(next) = &plan.next {
        let pairs: Vec<String> = next.pairs.iter().map(|(a, b)| format!("{} from {}", a.label(), b.label())).collect();
        let often = if next.repeats > 1 { format!(", {} times", next.repeats) } else { String::new() };
        let _ = writeln!(
            text,
            "\nto tell most of them apart\n  {}{often}: {} rows more\n  tells {}",
            next.experiment.words,
            next.observations(),
            pairs.join(", ")
        );
    }
    text
}
