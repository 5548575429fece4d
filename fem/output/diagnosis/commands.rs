//! Says how to go on: the commands that add missing effects.

use super::additions::{Addition, add, additions, leave_out, quoted, set};
use super::campaign;
use crate::diagnose::Diagnosis;
use crate::model::Data;
use crate::units::Knowledge;

/// The command that adds all that is missing at once; of several tests there is none.
pub fn command(data: &Data, d: &Diagnosis) -> Option<String> {
    let is_one = data.model.campaign().is_none() && !d.missing.is_empty();
    is_one.then(|| diagnosed(data, "--add-to better.toml"))
}

/// The command that writes the rows to measure next, where some are advised; of several tests there is none.
pub fn next_rows(data: &Data, d: &Diagnosis) -> Option<String> {
    let is_one = data.model.campaign().is_none() && d.next.is_some();
    is_one.then(|| diagnosed(data, "--next rows.csv"))
}

/// The commands that seek a law in what is left, where something is: of several tests in each by itself.
pub fn discover(data: &Data, d: &Diagnosis) -> Vec<String> {
    match data.model.campaign() {
        _ if !d.leaves_structure() => Vec::new(),
        Some(campaign) => campaign::discover(campaign, data),
        None => vec![format!("fem discover {} {}", quoted(&data.model.source.name), with(data))],
    }
}

/// The command that diagnoses the model again, and writes something.
fn diagnosed(data: &Data, written: &str) -> String {
    format!("fem diagnose {} {} {written}", quoted(&data.model.source.name), with(data))
}

/// The commands that add what is missing.
pub fn commands(data: &Data, d: &Diagnosis) -> Vec<String> {
    if d.missing.is_empty() {
        return Vec::new();
    }
    let model = data.model;
    if let Some(campaign) = model.campaign() {
        return campaign::commands(campaign, data, d);
    }
    let (mut lines, mut from) = (Vec::new(), model.source.name.to_string());
    for addition in additions(data, d) {
        let (line, to) = match &addition {
            Addition::Effect(name, settings) => add(&from, name, settings),
            Addition::Value(setting) => set(&from, setting),
            Addition::Without(name) => leave_out(&from, name),
        };
        lines.push(line);
        from = to;
    }
    let Some(all) = command(data, d) else { return lines };
    let data = with(data);
    if model.parameters.is_empty() {
        lines.push(format!("fem compare {} {data}", quoted(&from)));
        lines.push(format!("or all at once, every value re-fitted: {all}"));
        return lines;
    }
    // A fit with the effects' values in place would take them for priors, and count the data twice.
    let bent = "what the model knew roughly was bent by what was missing; all at once, every value re-fitted:";
    lines.extend([bent.to_string(), all]);
    // A model with unknown values can be fitted, but not compared.
    if d.fit.of(model).all(|e| e.is_closed() || e.parameter.quantity.knowledge != Knowledge::Free) {
        lines.push(format!("fem compare better.toml {data}"));
    }
    lines
}

/// The options that name the measurements and how they are read.
pub fn with(data: &Data) -> String {
    let files = data.files.iter().flat_map(|file| ["--with", &*file.name]);
    let words: Vec<String> = files.chain(data.said.iter().map(String::as_str)).map(quoted).collect();
    words.join(" ")
}
