//! The answer of `fem effects`: entries of the catalogue, those of processes and those of the measurement.

use std::fmt::Write;

use serde_json::{Value, json};

use super::answer::Answer;
use super::block::Block;
use super::columns::columns;
use super::measurement;
use crate::noise::MeasurementEffect;
use crate::process::{Description, Neutral, Parameter, Process};

/// The catalogue of effects, or a part of it.
#[non_exhaustive]
pub struct CatalogueAnswer {
    /// Effects of processes, each with its own.
    pub effects: Vec<(&'static dyn Process, Description)>,
    /// Effects of the measurement.
    #[doc(hidden)]
    pub of_measurement: Vec<&'static MeasurementEffect>,
    /// Whether each is told in a line, and not on a page.
    pub is_list: bool,
    /// The process that was asked for, whose columns are listed behind its effects.
    pub process: Option<&'static dyn Process>,
}

impl Answer for CatalogueAnswer {
    fn blocks(&self) -> Vec<Block> {
        let text = match self.is_list {
            true => list(&self.effects, &self.of_measurement),
            false => {
                let own = self.effects.iter().map(|(process, e)| page(process.name(), e));
                own.chain(self.of_measurement.iter().map(|e| measurement::page(e))).collect::<Vec<_>>().join("\n")
            }
        };
        let columns = self.process.map_or(String::new(), |process| format!("\n{}", columns(process)));
        vec![Block::Lines(text + &columns)]
    }

    fn json(&self) -> Value {
        let own = self.effects.iter().map(|(process, e)| entry(*process, e));
        own.chain(self.of_measurement.iter().map(|e| measurement::entry(e))).collect()
    }
}

/// One entry of the catalogue in JSON.
fn entry(process: &dyn Process, effect: &Description) -> Value {
    let neutral = |n: Neutral| match n {
        Neutral::Value(value) | Neutral::Written(value, _) => json!(value),
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
        "odds": effect.odds.to_one,
        "odds_because": effect.odds.because,
        "parameters": effect.parameters.iter().map(parameter).collect::<Vec<_>>(),
        "look_alikes": effect.look_alikes.iter().map(|l| l.0).collect::<Vec<_>>(),
        "separated_by": effect.look_alikes.iter().map(|l| l.1).collect::<Vec<_>>(),
    })
}

/// The catalogue, process by process, and what they share: one line per effect.
fn list(entries: &[(&dyn Process, Description)], of_measurement: &[&MeasurementEffect]) -> String {
    let mut text = String::new();
    for of_process in entries.chunk_by(|a, b| a.0.name() == b.0.name()) {
        let process = of_process[0].0;
        let _ = writeln!(text, "{}: {}", process.name(), process.about());
        for (_, effect) in of_process {
            let _ = writeln!(text, "  {:<24} {}", effect.name, effect.about);
        }
    }
    if !of_measurement.is_empty() {
        text.push_str(&measurement::catalogue(of_measurement));
    }
    format!("{text}\n`fem effects NAME` tells all about one of them\n")
}

/// All about one effect.
fn page(process: &str, effect: &Description) -> String {
    let mut text = format!(
        "{} ({process})\n  {}\n\n  law     {}\n  source  {}\n  odds    {} to one: {}\n\n",
        effect.name, effect.about, effect.law, effect.source, effect.odds.to_one, effect.odds.because
    );
    for parameter in &*effect.parameters {
        let _ = writeln!(text, "  {}", parameter_line(parameter));
    }
    if !effect.look_alikes.is_empty() {
        let _ = writeln!(text, "\n  can look the same as");
        for (name, difference) in effect.look_alikes {
            let _ = writeln!(text, "    {name:<22} what separates them: {difference}");
        }
    }
    let _ = writeln!(text, "\n  in a model file\n    [effects.{}]", effect.name);
    for p in &*effect.parameters {
        let number = (p.example() * 1e6).round() / 1e6;
        let value = if p.kind.unit.is_empty() { format!("{number}") } else { format!("\"{number} {}\"", p.kind.unit) };
        let _ = writeln!(text, "    {} = {value}", p.name);
    }
    text
}

fn parameter_line(p: &Parameter) -> String {
    let neutral = match p.neutral {
        Neutral::Value(value) | Neutral::Written(value, _) => format!("vanishes at {value}"),
        Neutral::Infinity => "vanishes at infinity".into(),
        Neutral::Shape => "shapes the effect".into(),
    };
    let unit = if p.kind.unit.is_empty() { "-" } else { &p.kind.unit };
    let optional = match (p.default, p.needed_with) {
        (Some(si), _) => format!("; {} if left out", p.kind.from_si(si)),
        (None, Some(other)) => format!("; only with {other}"),
        (None, None) => String::new(),
    };
    format!("{:<14} {:<10} {}; plausible {} to {}; {neutral}{optional}", p.name, unit, p.about, p.range.0, p.range.1)
}
