//! The pages of the effects of the measurement.

use std::path::PathBuf;

use fem::noise::{Key, MeasurementEffect, effects};

use super::chapters::Chapter;
use super::effect::cited;
use super::markdown::{block, code, plain, table};
use super::{Made, Pages};

/// A page for each of them.
pub fn all(deep: usize) -> Pages {
    let page = |effect: &'static MeasurementEffect| {
        let path = PathBuf::from(format!("docs/effects/measurement/{}.md", effect.name));
        (Chapter::new(effect.name, &path, deep), vec![Made { path, text: page(effect) }])
    };
    effects::all().map(page).collect()
}

fn page(effect: &MeasurementEffect) -> String {
    let MeasurementEffect { name, about, law, source, separates, .. } = effect;
    let keys = effect.all_keys();
    let row = |key: &Key| [code(key.name), plain(key.about), code(key.example)];
    [
        format!(
            "# {name}\n\nOf the [measurement](../../measurement-effects.md), in every process: {}.\n",
            plain(about)
        ),
        format!("## Law\n\n{}\nSource: {}\n", block("text", law), cited(source)),
        format!("## Keys\n\nIn the table `[measurement.{name}]` of a model file:\n"),
        table(["key", "what it holds", "for example"], keys.iter().map(row)),
        format!("## What separates it from effects of the machine\n\n{}\n", sentence(separates)),
    ]
    .join("\n")
}

/// A phrase as a sentence.
fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    plain(&format!("{first}{}.", letters.as_str()))
}
