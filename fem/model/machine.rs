//! The machine that a model names: a file of its own, which several models share.

use std::path::{Path, PathBuf};

use toml_edit::{Document, Item};

use crate::input::{Cache, NamedFile, Problem, Reader, Source};

/// Largest machine file, bytes; people write machines by hand.
pub(super) const LARGEST: u64 = 1_000_000;
/// The key by which a model names it.
pub(super) const MACHINE: &str = "machine";
/// The drawing of the machine, which models of it share.
pub(super) const STRUCTURE: &str = "structure";
/// What stands on a drawing, which is each model's own.
pub(super) const PORTS: &str = "ports";

/// A machine with its units, of which tests see one thing or another.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// Path of its file from the working directory.
    pub path: PathBuf,
    /// Its name, for people.
    pub name: Option<String>,
    /// Names of its units.
    pub units: Vec<String>,
}

impl Machine {
    /// Whether two models name the same file, by whatever ways.
    pub fn is(&self, other: &Self) -> bool {
        let place = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        place(&self.path) == place(&other.path)
    }
}

/// Reads the machine that a model names, and holds the `unit` that it tests against it.
pub fn read(model: &Reader, unit: Option<&str>) -> Option<Machine> {
    let file = model.file(MACHINE, "the file of the machine, which other models name too", LARGEST)?;
    // A search reads the model again and again, and the machine stays.
    let known = model.kept::<Cache<NamedFile, Machine, 2>>();
    let machine = known.get_or(file.clone(), parse).map_err(|problem| {
        let message = format!("{}: {}", file.path.display(), problem.message);
        model.problem(MACHINE, message, problem.help.unwrap_or_default());
    });
    let machine = machine.ok()?.as_ref().clone();
    if let Some(unit) = unit.filter(|unit| machine.units.iter().all(|own| own != unit)) {
        let file = machine.path.display();
        let help =
            format!("write [machine.{unit}] into {file}, or name one of its units: {}", machine.units.join(", "));
        model.problem(MACHINE, format!("{file} has no unit `{unit}`"), help);
    }
    Some(machine)
}

fn parse(file: &NamedFile) -> Result<Machine, Problem> {
    /// Form of a machine file, as a remedy.
    const FORM: &str = "write [machine] with a name, and a table without values for each unit: [machine.tailstock]";
    let wrong = |source: &Source, item: Option<&Item>, message: String| {
        let line = item.and_then(Item::span).map(|span| source.line_column(span.start).0);
        Problem::new(line.map_or(message.clone(), |line| format!("line {line}: {message}"))).help(FORM)
    };
    let source = file.text()?;
    let document = Document::parse(source.text.to_string())
        .map_err(|e| Problem::new(e.message().trim().replace('\n', ", ")).help(FORM))?;
    if let Some((key, item)) = document.iter().find(|(key, _)| ![MACHINE, STRUCTURE].contains(key)) {
        return Err(wrong(&source, Some(item), format!("`{key}` is not known in a machine file")));
    }
    if let Some(drawing) = document.get(STRUCTURE) {
        let Some(drawing) = drawing.as_table_like() else {
            let problem = wrong(&source, Some(drawing), format!("`{STRUCTURE}` is no table"));
            return Err(problem.help("write [structure.nodes] and a table for each member and joint"));
        };
        if let Some(ports) = drawing.get(PORTS) {
            let message = "tests stand on a machine in places of their own: `ports` are not known in a machine file";
            let problem = wrong(&source, Some(ports), message.into());
            return Err(problem.help("write [structure.ports] into each model"));
        }
    }
    let Some(table) = document.get(MACHINE).and_then(Item::as_table_like) else {
        return Err(wrong(&source, None, "there is no table [machine]".into()));
    };
    let mut machine = Machine { path: file.path.clone(), name: None, units: Vec::new() };
    for (key, item) in table.iter() {
        match (key, item.as_str(), item.as_table_like()) {
            ("name", Some(name), _) => machine.name = Some(name.to_string()),
            ("name", None, _) => return Err(wrong(&source, Some(item), "`name` is no text".into())),
            (_, _, Some(unit)) => {
                if let Some((value, item)) = unit.iter().next() {
                    let message =
                        format!("`{key}.{value}`: a machine file holds the names of units, and no values yet");
                    let problem = wrong(&source, Some(item), message);
                    return Err(problem.help("write the value into each model that knows it"));
                }
                machine.units.push(key.to_string());
            }
            _ => return Err(wrong(&source, Some(item), format!("`{key}` is no unit"))),
        }
    }
    Ok(machine)
}
