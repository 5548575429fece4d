//! The page of a process, with the pages of its effects behind it.

use std::error::Error;
use std::path::PathBuf;

use fem::model::{Model, Run};
use fem::output::{RunAnswer, columns, figures};
use fem::process::{Description, Process};
use fem::processes::ALL;
use fem::progress::Progress;
use rayon::prelude::*;

use super::chapters::Chapter;
use super::markdown::{block, plain, table};
use super::{Made, Pages, effect, hosts};

/// The pages of every process and effect.
pub fn all(deep: usize) -> Result<Pages, Box<dyn Error>> {
    let mut pages = Vec::new();
    for process in ALL {
        let hosts = hosts::models(*process)?;
        let made = page(*process, &hosts[0])?;
        pages.push((Chapter::new(process.name(), &made[0].path, deep), made));
        let effects = process.effects();
        let page = |effect: &Description| effect::page(*process, effect, &hosts).map_err(|e| e.to_string());
        let all = effects.par_iter().map(page).collect::<Result<Vec<_>, String>>()?;
        let chapter =
            |made: Vec<Made>, effect: &Description| (Chapter::new(&effect.name, &made[0].path, deep + 4), made);
        pages.extend(all.into_iter().zip(&effects).map(|(made, effect)| chapter(made, effect)));
    }
    Ok(pages)
}

fn page(process: &dyn Process, model: &Model) -> Result<Vec<Made>, Box<dyn Error>> {
    let name = process.name();
    let path = PathBuf::from(format!("docs/processes/{name}.md"));
    let run = model.run(&Progress::default())?;
    let file = |stem: &str| format!("{name}-{stem}.svg");
    let pictures = figures(&RunAnswer(model, &run, None));
    let shown: String = pictures.iter().map(|(stem, _)| format!("![{name}: {stem}]({})\n\n", file(stem))).collect();
    let effects = process.effects();
    let text = [
        format!("# {name}\n\nThe process `{name}` predicts the {}.\n", plain(process.about())),
        format!(
            "[Keys of its model files](../models.md#{name}) · [columns of its measurement \
             files](../measurements.md#{name}) · [rows of validation](../validation/{name}.md) · \
             [limits](../limits.md)\n"
        ),
        format!("## What it shows\n\n{shown}{}", found(&run)),
        format!("## Its effects\n\n{}", catalogue(name, &effects)),
        format!("## What can be mistaken for what\n\n{}", alike(name, &effects)),
        format!("## What can be measured\n\n{}", block("text", &columns(process))),
        format!(
            "## A model to start from\n\n`fem new {name} -o model.toml` writes it; `fem run model.toml` makes the \
             pictures above.\n\n{}",
            block("toml", process.starting_model())
        ),
    ];
    let mut made = vec![Made { path: path.clone(), text: text.join("\n") }];
    made.extend(pictures.into_iter().map(|(stem, text)| Made { path: path.with_file_name(file(&stem)), text }));
    Ok(made)
}

/// What a run found, in its own words.
fn found(run: &Run) -> String {
    let mut text = String::new();
    for figure in &run.report.figures {
        let lines = figure.lines.join(&format!("\n{:25}", ""));
        text.push_str(&format!("{:<24} {lines}\n", figure.label));
    }
    block("text", &text)
}

fn link(process: &str, effect: &str) -> String {
    format!("[{effect}](../effects/{process}/{effect}.md)")
}

fn catalogue(process: &str, effects: &[Description]) -> String {
    table(["effect", "what happens"], effects.iter().map(|e| [link(process, &e.name), plain(&e.about)]))
}

fn alike(process: &str, effects: &[Description]) -> String {
    let rows = effects.iter().filter(|e| !e.look_alikes.is_empty()).map(|e| {
        let others: Vec<String> = e.look_alikes.iter().map(|(other, _)| link(process, other)).collect();
        [link(process, &e.name), others.join(", ")]
    });
    table(["effect", "can look the same as"], rows) + "\nThe page of an effect says what separates it from each.\n"
}
