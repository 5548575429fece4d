//! `fem` alone: what to do next, by what lies in the folder.

use std::path::{Path, PathBuf};

use super::error::Error;
use super::terminal::print;
use crate::input::text_of;
use crate::processes;

/// Most bytes of a file that is looked into.
const LARGEST: u64 = 1_000_000;

/// Says what to do next.
pub fn start() -> Result<(), Error> {
    let (models, data) = (models(), tables());
    let first = processes::ALL.first().map_or("", |p| p.name());
    let mut text = "fem predicts what a machine, a fixture and a workpiece do to a part, compares the prediction with \
                    measurements,\nand names the physical effect that is missing.\n\n"
        .to_string();
    let lines: Vec<(String, &str)> = match (models.first(), data.first()) {
        (None, _) => vec![
            ("fem demo".into(), "a lathe and its measurements, to try everything on"),
            ("fem new".into(), "what can be modelled, and how to begin"),
            (format!("fem new {first} -o model.toml"), "a commented model of your own"),
        ],
        (Some(model), None) => vec![
            (format!("fem run {model}"), "predict, summarise, write tables and figures"),
            (format!("fem report {model} -o report.html"), "the same as a page for a browser"),
            (format!("fem plan {model} --noise '1 um'"), "before measuring: what could be seen"),
        ],
        (Some(model), Some(data)) => vec![
            (format!("fem run {model}"), "predict, summarise, write tables and figures"),
            (format!("fem compare {model} --with {data}"), "how well it agrees with measurements"),
            (format!("fem diagnose {model} --with {data}"), "which effect is missing"),
            (format!("fem report {model} --with {data} -o report.html"), "all of it as a page for a browser"),
        ],
    };
    text.push_str(if models.is_empty() { "to begin\n" } else { "in this folder you could\n" });
    let width = lines.iter().map(|l| l.0.chars().count()).max().unwrap_or(0);
    for (command, about) in lines {
        text.push_str(&format!("  {command:<width$}  {about}\n"));
    }
    text.push_str("\n`fem help` lists all commands, `fem COMMAND --help` explains one\n");
    print(&text)
}

/// Names of the models in the folder, sorted: files that name a process.
fn models() -> Vec<String> {
    let is_model = |path: &Path| {
        let is_short = std::fs::metadata(path).is_ok_and(|about| about.len() <= LARGEST);
        let text = if is_short { text_of(path) } else { String::new() };
        text.lines().any(|line| line.strip_prefix("process").is_some_and(|rest| rest.trim_start().starts_with('=')))
    };
    files("toml").into_iter().filter(|path| is_model(path)).map(|path| name(&path)).collect()
}

fn tables() -> Vec<String> {
    files("csv").iter().map(|path| name(path)).collect()
}

/// The files of a kind in the folder, sorted.
fn files(ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(".").into_iter().flatten().flatten();
    // A name with a line end would stand there as a line of its own, as if it were said here.
    let is_shown = |path: &Path| path.is_file() && !path.to_string_lossy().contains(char::is_control);
    let mut found: Vec<PathBuf> =
        entries.map(|e| e.path()).filter(|p| is_shown(p) && p.extension().is_some_and(|e| e == ending)).collect();
    found.sort();
    found
}

/// The name as a shell takes it.
fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c)) && !name.starts_with('-');
    if is_plain { name } else { format!("'./{}'", name.replace('\'', "'\\''")) }
}
