//! What is missing, as a diagnosis says it.

use serde_json::{Value as Json, json};

use super::super::bench::Diagnosed;
use crate::model::Model;

/// What is missing, by the last diagnosis.
pub fn diagnosis(found: &Diagnosed, model: Option<&Model>, is_current: bool) -> Json {
    let is_there = |name: &str| model.is_some_and(|m| m.effects.iter().any(|own| own.description.name == *name));
    let list = |key: &str| found.json[key].as_array().map_or(&[][..], Vec::as_slice);
    // What tells an effect from another is said of pairs.
    let apart = |name: &str| {
        let is_of = |own: &&Json| own["separates"].as_array().is_some_and(|all| all.iter().any(|own| own == name));
        let texts: Vec<&str> =
            list("separated_by").iter().filter(is_of).filter_map(|own| own["text"].as_str()).collect();
        (!texts.is_empty()).then(|| texts.join("; "))
    };
    let cause = |(number, own): (usize, &Json)| {
        let name = own["effect"].as_str().unwrap_or_default();
        let probability = own["probability"].as_f64().unwrap_or(0.0);
        let values = own["parameters"].as_object().into_iter().flatten().map(|(key, value)| {
            format!("{key} {:.4} {}", value["value"].as_f64().unwrap_or(f64::NAN), value["unit"].as_str().unwrap_or(""))
        });
        json!({
            "effect": name,
            "label": name,
            "about": about(model, name),
            "probability": probability,
            "class": if probability >= 0.9 { "certain" } else { "perhaps" },
            "rms_after": own["rms_after"],
            "unit": found.json["noise"]["unit"],
            "values": values.collect::<Vec<_>>(),
            "alike": own["indistinguishable_from"],
            "separated_by": apart(name),
            "doubt": own["doubt"],
            "can_add": found.additions.get(number).is_some() && !is_there(name),
            "is_added": is_there(name),
        })
    };
    let other = |own: &Json| {
        let name = own["effect"].as_str().unwrap_or_default();
        json!({ "effect": name, "about": about(model, name), "probability": own["probability"], "rms_alone": own["rms_after"] })
    };
    let mut chosen: Vec<&Json> = list("missing").iter().map(|own| &own["effect"]).collect();
    chosen.sort_by_key(|own| own.as_str());
    let set = |own: &Json| {
        let mut effects: Vec<&Json> = own["effects"].as_array().into_iter().flatten().collect();
        effects.sort_by_key(|own| own.as_str());
        json!({ "effects": effects, "probability": own["probability"], "is_chosen": effects == chosen })
    };
    json!({
        "is_current": is_current,
        "verdict": found.verdict,
        "html": found.html,
        "rms_before": found.json["before"]["rms"],
        "causes": list("missing").iter().enumerate().map(cause).collect::<Vec<_>>(),
        "others": list("candidates").iter().map(other).collect::<Vec<_>>(),
        "sets": list("sets").iter().map(set).collect::<Vec<_>>(),
        "groups": found.groups.iter().map(|(text, effects)| json!({ "text": text, "effects": effects })).collect::<Vec<_>>(),
        "next": found.next.as_ref().map(|(html, rows)| json!({ "html": html, "rows": rows })),
    })
}

/// What an effect is, where the catalogue of the model's process has it.
fn about(model: Option<&Model>, name: &str) -> Option<String> {
    model?.process.effects().iter().find(|own| own.name == *name).map(|own| own.about.to_string())
}
