//! Says how to go on: the commands that add missing effects.

use std::fmt::Write;

use super::additions::{add, additions, quoted};
use super::campaign;
use crate::diagnose::Diagnosis;
use crate::model::Data;
use crate::units::Knowledge;

/// Writes the commands that add what is missing.
pub fn commands(text: &mut String, data: &Data, d: &Diagnosis) {
    if d.missing.is_empty() {
        return;
    }
    let model = data.model;
    let _ = writeln!(text, "\nto go on");
    if let Some(campaign) = &model.campaign {
        return campaign::commands(text, campaign, data, d);
    }
    let mut from = model.source.name.to_string();
    for (name, settings) in additions(data, d) {
        from = add(text, &from, &name, &settings);
    }
    let (file, data) = (quoted(&model.source.name), with(data));
    if model.parameters.is_empty() {
        let _ = writeln!(text, "  fem compare {} {data}", quoted(&from));
        let _ =
            writeln!(text, "  or all at once, every value re-fitted: fem diagnose {file} {data} --add-to better.toml");
        return;
    }
    // A fit with the effects' values in place would take them for priors, and count the data twice.
    let _ = writeln!(
        text,
        "  what the model knew roughly was bent by what was missing; all at once, every value re-fitted:\n  fem diagnose {file} {data} --add-to better.toml"
    );
    // A model with unknown values can be fitted, but not compared.
    let mut own = d.fit.estimates.iter().take(model.parameters.len());
    if own.all(|e| e.is_closed() || e.parameter.quantity.knowledge != Knowledge::Free) {
        let _ = writeln!(text, "  fem compare better.toml {data}");
    }
}

/// The options that name the measurements and how they are read.
pub fn with(data: &Data) -> String {
    let files = data.files.iter().flat_map(|file| ["--with", &*file.name]);
    let words: Vec<String> = files.chain(data.said.iter().map(String::as_str)).map(quoted).collect();
    words.join(" ")
}
