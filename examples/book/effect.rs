//! The page of an effect: what it does, what it changes in a picture, its law, its parameters, and what it can be
//! mistaken for.

use std::error::Error;
use std::path::PathBuf;

use fem::model::{Contribution, Entry, Model, Setting, add_effect};
use fem::output::signatures;
use fem::process::{Active, Description, Neutral, Parameter, Process};
use fem::progress::Progress;

use super::Made;
use super::markdown::{block, code, plain, table};

/// What sources say of the sizes of effects.
const TYPICAL: &str = include_str!("../../docs/typical.md");

/// Where the page of an effect stands.
pub fn path(process: &str, effect: &str) -> PathBuf {
    PathBuf::from(format!("docs/effects/{process}/{effect}.md"))
}

/// The page with its pictures.
pub fn page(process: &dyn Process, effect: &Description, hosts: &[Model]) -> Result<Vec<Made>, Box<dyn Error>> {
    let host = hosts.iter().find(|host| host.system.admits(&effect.name).is_ok());
    let host = host.ok_or_else(|| format!("{}: no model admits it", effect.name))?;
    let is_there = host.effects.iter().any(|e| e.description.name == effect.name);
    let added = if is_there { None } else { Some(add_effect(host, &effect.name, &settings(effect)).map_err(problem)?) };
    let model = added.as_ref().unwrap_or(host);
    let active = model.effects.iter().find(|e| e.description.name == effect.name);
    let active = active.ok_or_else(|| format!("{}: it is not in its model", effect.name))?;
    let contributions = model.contribution_of(active, &Progress::default())?;
    let path = path(process.name(), &effect.name);
    let mut made = Vec::new();
    for svg in signatures(model, &contributions) {
        let number = if made.is_empty() { String::new() } else { format!("-{}", made.len() + 1) };
        made.push(Made { path: path.with_file_name(format!("{}{number}.svg", effect.name)), text: svg });
    }
    let text = [
        opening(process, effect),
        signature(process, active, &made, &contributions, std::ptr::eq(host, &hosts[0])),
        format!("## Law\n\n{}\nSource: {}\n", block("text", &effect.law), cited(effect.source)),
        parameters(effect),
        typical(process.name(), &effect.name),
        in_a_model(effect),
        alike(process, effect),
        needs(effect, hosts),
        format!("## The model of the picture\n\n{}", block("toml", &model.source.text)),
    ];
    made.insert(0, Made { path, text: text.join("\n") });
    Ok(made)
}

fn problem(problem: fem::input::Problem) -> String {
    problem.message
}

/// Values in the middle of what is plausible, as one would write them.
fn settings(effect: &Description) -> Vec<Setting> {
    let setting = |p: &Parameter| Setting { key: p.name.to_string(), value: Entry::Text(usual(p)) };
    effect.parameters.iter().map(setting).collect()
}

fn usual(p: &Parameter) -> String {
    let number = (p.example() * 1e6).round() / 1e6;
    format!("{number} {}", p.kind.unit).trim_end().to_string()
}

fn opening(process: &dyn Process, effect: &Description) -> String {
    let name = process.name();
    format!("# {}\n\nIn [{name}](../../processes/{name}.md): {}.\n", effect.name, plain(&effect.about))
}

/// What it changes: pictures and numbers.
fn signature(
    process: &dyn Process,
    active: &Active,
    pictures: &[Made],
    contributions: &[Contribution],
    is_start: bool,
) -> String {
    let mut text = "## Its signature\n\n".to_string();
    for Made { path, .. } in pictures {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        text.push_str(&format!("![What {} changes along the curve]({file})\n\n", active.description.name));
    }
    let observables = process.observables();
    text.push_str(&table(
        ["what it changes", "rms", "from", "to"],
        contributions.iter().map(|share| {
            let kind = share.kind(observables);
            let told = |si: f64| format!("{:+.3} {}", kind.from_si(si), kind.unit).trim_end().to_string();
            [
                plain(&observables[share.observable].words),
                told(share.rms).trim_start_matches('+').to_string(),
                told(share.smallest),
                told(share.largest),
            ]
        }),
    ));
    let of = match is_start {
        true => format!("that `fem new {}` writes", process.name()),
        false => format!("that `fem new {}` writes, with what this effect needs besides", process.name()),
    };
    let value = |(p, si): (&Parameter, &f64)| format!("{} = {}", p.name, p.kind.format(*si));
    let values: Vec<String> = active.description.parameters.iter().zip(&active.values).map(value).collect();
    let values = code(&values.join(", "));
    text + &format!(
        "\nThe prediction with the effect less that without it, in [the model](#the-model-of-the-picture) {of}, at {values}.\n"
    )
}

/// A source with a link to the bibliography.
pub fn cited(source: &str) -> String {
    let text = plain(source);
    let from = ["seed 000", "seed 001", "seed 002", "seed 003"];
    let linked = from.iter().fold(text, |text, seed| {
        text.replacen(seed, &format!("[{seed}](../../bibliography.md#{})", seed.replace(' ', "-")), 1)
    });
    linked + "."
}

fn parameters(effect: &Description) -> String {
    let row = |p: &Parameter| {
        let neutral = match p.neutral {
            Neutral::Value(value) | Neutral::Written(value, _) => format!("{value}"),
            Neutral::Infinity => "infinity".into(),
            Neutral::Shape => "never: it shapes the effect".into(),
        };
        let left_out = match (p.default, p.needed_with) {
            (Some(si), _) => p.kind.format(si),
            (None, Some(other)) => format!("only where `{other}` is not zero"),
            (None, None) => "it is needed".into(),
        };
        let range = format!("{} to {}", p.range.0, p.range.1);
        [code(&p.name), plain(p.about), code(&p.kind.unit), range, neutral, left_out]
    };
    let headings = ["key", "what it is", "unit", "plausible", "the effect vanishes at", "if left out"];
    format!("## Parameters\n\n{}", table(headings, effect.parameters.iter().map(row)))
}

/// The rows of the table of typical values: process, effect, value and source.
pub fn typical_rows() -> impl Iterator<Item = [&'static str; 4]> {
    let cells = |line: &'static str| {
        let mut cells = line.trim_matches('|').split(" | ").map(|cell| cell.trim());
        let mut next = || cells.next().unwrap_or_default();
        [next().trim_matches('`'), next().trim_matches('`'), next(), next()]
    };
    TYPICAL.lines().filter(|line| line.starts_with("| `")).map(cells)
}

fn typical(process: &str, effect: &str) -> String {
    let own = |row: &[&str; 4]| row[0] == process && row[1] == effect;
    let upwards = |text: &str| text.replace("](models.md", "](../../models.md");
    let rows: Vec<[String; 2]> =
        typical_rows().filter(own).map(|[.., value, source]| [value.to_string(), upwards(source)]).collect();
    let text = match rows.is_empty() {
        true => {
            "No source for its size is at hand; the plausible range is a judgement of those who wrote the program. \
                 [Typical values](../../typical.md) lists those that have one.\n"
                .to_string()
        }
        false => table(["typical", "source"], rows),
    };
    format!("## Typical values\n\n{text}")
}

fn in_a_model(effect: &Description) -> String {
    let mut toml = format!("[effects.{}]\n", effect.name);
    let mut command = format!("fem add model.toml {}", effect.name);
    for p in &*effect.parameters {
        let quote = if p.kind.unit.is_empty() { "" } else { "\"" };
        toml.push_str(&format!("{} = {quote}{}{quote}\n", p.name, usual(p)));
        command.push_str(&format!(" '{}={}'", p.name, usual(p)));
    }
    let command = block("sh", &format!("{command} -o with-{}.toml", effect.name));
    format!("## In a model file\n\n{}\nOr, to write a model that has it:\n\n{command}", block("toml", &toml))
}

fn alike(process: &dyn Process, effect: &Description) -> String {
    let all = process.effects();
    let link = |name: &str| format!("[{name}]({name}.md)");
    let own = effect.look_alikes.iter().map(|(name, difference)| [link(name), plain(difference)]);
    let others = all.iter().filter(|other| !effect.look_alikes.iter().any(|(name, _)| *name == other.name));
    let from_others = others.flat_map(|other| {
        let named = other.look_alikes.iter().filter(|(name, _)| *name == effect.name);
        named.map(|(_, difference)| [link(&other.name), plain(difference)])
    });
    let rows: Vec<[String; 2]> = own.chain(from_others).collect();
    let text = match rows.is_empty() {
        true => "No effect of the catalogue is known to look the same.\n".to_string(),
        false => table(["effect", "what separates the two"], rows),
    };
    format!("## What it can be mistaken for\n\n{text}")
}

/// Why it cannot act in some models, in their words.
fn needs(effect: &Description, hosts: &[Model]) -> String {
    let mut reasons: Vec<String> = hosts.iter().filter_map(|h| h.system.admits(&effect.name).err()).collect();
    reasons.dedup();
    if reasons.is_empty() {
        return String::new();
    }
    let list: String = reasons.iter().map(|reason| format!("- {}\n", plain(reason))).collect();
    format!("## What it needs\n\nSome models cannot have it, and the program says why:\n\n{list}")
}
