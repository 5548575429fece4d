//! A model file: a process, its tables, and the effects that are present.

mod add;
mod run;
mod schema;
mod written;

pub use add::{Setting, add_effect};
pub use run::{Run, Share};
pub use schema::schema;

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use toml_edit::Document;

use crate::input::{
    FileKey, Found, InputError, Names, Parameter, Problem, Reader, Source, did_you_mean, nearest, seen_from,
};
use crate::process::{self, Active, Description, Failure, Job, Process, System};
use crate::units::Knowledge;

/// Largest model file, bytes. A model is written by people.
const LARGEST: u64 = 4_000_000;

/// A model that was read without a problem.
pub struct Model {
    /// The file.
    pub source: Source,
    /// `title`, if it has one.
    pub title: Option<String>,
    /// Which process it models.
    pub process: &'static dyn Process,
    /// The ideal system that its tables describe.
    pub system: Arc<dyn System>,
    /// Its effects, in the order of the file.
    pub effects: Vec<Active>,
    /// What it does not know exactly.
    pub parameters: Vec<Parameter>,
    /// The files that it names.
    files: Vec<FileKey>,
    document: Document<String>,
}

impl Model {
    /// Reads a model file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, with places and remedies.
    pub fn load(path: &Path) -> Result<Self, InputError> {
        Self::parse(Source::read(path, LARGEST)?)
    }

    /// Reads a model from its text.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn parse(source: Source) -> Result<Self, InputError> {
        let document = Document::parse(source.text.to_string()).map_err(|e| {
            let problem = Problem::new(e.message().trim().replace('\n', ", ")).at(e.span());
            InputError::one(source.clone(), problem.help("a model file is TOML: [table], key = \"value\", # comment"))
        })?;
        let process = find_process(&document).map_err(|problem| InputError::one(source.clone(), problem))?;
        let ((title, system, effects), found) =
            Reader::of_file(document.as_table(), source.folder(), HashMap::new(), |model| read(model, process));
        if !found.problems.is_empty() {
            return Err(InputError::new(source, found.problems));
        }
        let Found { parameters, files, .. } = found;
        Ok(Self { title, process, system, effects, parameters, files, source, document })
    }

    /// The model with what it does not know exactly at these values (SI, in the order of `parameters`), ready to predict.
    ///
    /// # Errors
    /// The values make no model: a trial of a search went where there is none.
    pub fn job_at(&self, values: &[f64]) -> Result<Box<dyn Job>, Failure> {
        self.job_with(values, &[])
    }

    /// The same with further effects acting that the file does not have.
    ///
    /// # Errors
    /// The values make no model.
    pub fn job_with(&self, values: &[f64], added: &[Active]) -> Result<Box<dyn Job>, Failure> {
        if let Some(mut effects) = self.effects_at(values) {
            effects.extend_from_slice(added);
            return Ok(process::equip(&self.system, &effects));
        }
        let trial = self.parameters.iter().map(|p| p.path.clone()).zip(values.iter().copied()).collect();
        let ((_, system, mut effects), found) =
            Reader::of_file(self.document.as_table(), self.source.folder(), trial, |model| read(model, self.process));
        match found.problems.first() {
            None => {
                effects.extend_from_slice(added);
                Ok(process::equip(&system, &effects))
            }
            Some(problem) => {
                Err(Failure { message: problem.message.clone(), help: problem.help.clone().unwrap_or_default() })
            }
        }
    }

    /// The model as it is written, ready to predict.
    pub fn job(&self) -> Box<dyn Job> {
        process::equip(&self.system, &self.effects)
    }

    /// The text of the model for a file at `path`: what it names by paths from its own folder is found from there.
    pub fn text_at(&self, path: &Path) -> String {
        let mut text = self.source.text.to_string();
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut files: Vec<&FileKey> = self.files.iter().collect();
        files.sort_by_key(|file| std::cmp::Reverse(file.span.start));
        for FileKey { written, span } in files {
            let seen = seen_from(written, self.source.folder(), folder);
            if seen != *written {
                text.replace_range(span.clone(), &toml_edit::Value::from(seen.display().to_string()).to_string());
            }
        }
        text
    }

    /// The effects with other values, if nothing else is unknown; the system then need not be read again.
    fn effects_at(&self, values: &[f64]) -> Option<Vec<Active>> {
        let mut effects = self.effects.clone();
        for (parameter, value) in self.parameters.iter().zip(values) {
            let (effect, name) = parameter.path.strip_prefix("effects.")?.split_once('.')?;
            let active = effects.iter_mut().find(|e| e.description.name == effect)?;
            let position = active.description.parameters.iter().position(|p| p.name == name)?;
            active.values[position] = *value;
        }
        Some(effects)
    }

    /// Whether a parameter, by its path, belongs to an effect that the user has written.
    pub fn is_written(&self, path: &str) -> bool {
        let effect = path.strip_prefix("effects.").and_then(|p| p.split_once('.')).map(|p| p.0);
        self.effects.iter().any(|e| e.written.is_some() && Some(e.description.name) == effect)
    }

    /// The catalogue's entry of a parameter of an effect, by its path.
    pub fn catalogue(&self, path: &str) -> Option<&'static crate::process::Parameter> {
        let (effect, name) = path.strip_prefix("effects.")?.split_once('.')?;
        let active = self.effects.iter().find(|e| e.description.name == effect && e.written.is_none())?;
        active.description.parameters.iter().find(|p| p.name == name)
    }

    /// Refuses a model with parameters that are still unknown (`?`).
    ///
    /// # Errors
    /// Names each of them.
    pub fn require_values(&self) -> Result<(), InputError> {
        let free = self.parameters.iter().filter(|p| p.quantity.knowledge == Knowledge::Free);
        let problem = |p: &Parameter| {
            let example = p.kind.example();
            Problem::new(format!("`{}` is unknown (`?`)", p.path))
                .help(format!("give it a value such as \"{example}\", or let `fem fit` find it from measurements"))
                .at(p.span.clone())
        };
        let problems: Vec<Problem> = free.map(problem).collect();
        if problems.is_empty() { Ok(()) } else { Err(InputError::new(self.source.clone(), problems)) }
    }
}

fn find_process(document: &Document<String>) -> Result<&'static dyn Process, Problem> {
    let names = || process::ALL.iter().map(|p| p.name());
    let listed = || names().map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ");
    let Some(item) = document.get("process") else {
        let example = names().next().unwrap_or_default();
        let problem = Problem::new("the model does not say which process it models");
        return Err(problem
            .help(format!("add process = \"{example}\" at the top; known are {}", listed()))
            .at(Some(0..0)));
    };
    let given = item.as_str().unwrap_or_default();
    process::ALL.iter().copied().find(|p| p.name() == given).ok_or_else(|| {
        let meant = did_you_mean(given, names(), '"');
        let problem = Problem::new(format!("{} is no process known here", item.to_string().trim()));
        problem.help(format!("{meant}known are {}", listed())).at(item.span())
    })
}

/// Reads everything a model file may hold; also the ground of its schema.
fn read(model: &Reader, process: &'static dyn Process) -> (Option<String>, Arc<dyn System>, Vec<Active>) {
    let title = model.text("title", "what is modelled, for people");
    model.text("process", "which process is modelled");
    let system: Arc<dyn System> = process.read(model).into();
    let effects = read_effects(model, process, &*system);
    (title, system, effects)
}

fn read_effects(model: &Reader, process: &'static dyn Process, system: &dyn System) -> Vec<Active> {
    let known = process.effects();
    let names: Vec<&'static str> = known.iter().map(|d| d.name).collect();
    let find = |name: &str, is_written: bool| match names.iter().find(|n| **n == name) {
        Some(known) => Ok(*known),
        None if is_written => Ok(process::written::word(name)),
        None => Err(unknown_effect(name, process, &names)),
    };
    let read = |name: &'static str, table: &Reader| {
        let Some(description) = known.iter().find(|d| d.name == name) else {
            return written::read(name, table, process);
        };
        if let Err(reason) = system.admits(name) {
            table.problem("", reason, "remove the effect, or change what it acts on");
        }
        Some(description.read(table))
    };
    let about = "physical effects beyond the ideal system; one of your own has a formula";
    let names = Names { known: &names, mark: "formula", find: &find };
    model.named_tables("effects", about, names, read).into_iter().flatten().collect()
}

fn unknown_effect(name: &str, process: &dyn Process, names: &[&'static str]) -> Problem {
    let owner = process::ALL.iter().find(|p| p.effects().iter().any(|d| d.name == name));
    if let Some(owner) = owner {
        let message = format!("`{name}` is an effect of `{}`, not of `{}`", owner.name(), process.name());
        return Problem::new(message).help(format!("`fem effects {}` lists those that fit", process.name()));
    }
    let problem = Problem::new(format!("`{name}` is no effect known here"));
    match nearest(name, names.iter().copied()) {
        Some(near) => problem.help(format!("did you mean `{near}`? `fem effects {}` lists all", process.name())),
        None => problem.help(format!(
            "`fem effects {}` lists those that are; an effect of your own has a `formula`",
            process.name()
        )),
    }
}

/// The effect of a process by its name.
pub fn effect_of(process: &dyn Process, name: &str) -> Result<&'static Description, Problem> {
    let known = process.effects();
    let names: Vec<&'static str> = known.iter().map(|d| d.name).collect();
    known.into_iter().find(|d| d.name == name).ok_or_else(|| unknown_effect(name, process, &names))
}
