//! Steps that were taken, with what was before each, and those that were taken back.

use super::bench::Bench;

/// Most steps that can be undone.
const MOST: usize = 200;

/// The steps, the last one last.
#[derive(Default)]
pub struct Steps {
    undo: Vec<Step>,
    redo: Vec<Step>,
}

/// A step.
struct Step {
    label: String,
    /// The commands that would do the same.
    commands: Vec<String>,
    /// What was before it, or after it where it was taken back.
    other: Bench,
}

impl Steps {
    /// Takes a step from what is `now` to what is next, by its label and command.
    pub fn take(&mut self, now: &mut Bench, next: Bench, (label, command): (String, Option<String>)) {
        let commands = command.into_iter().collect();
        self.undo.push(Step { label, commands, other: std::mem::replace(now, next) });
        if self.undo.len() > MOST {
            self.undo.remove(0);
        }
        self.redo.clear();
    }

    /// What the last step was is done by one more command.
    pub fn also(&mut self, command: String) {
        if let Some(step) = self.undo.last_mut() {
            step.commands.push(command);
        }
    }

    /// Takes the last step back; `None` where there is none.
    pub fn undo(&mut self, now: &mut Bench) -> Option<()> {
        exchange((&mut self.undo, &mut self.redo), now)
    }

    /// Takes it again; `None` where none was taken back.
    pub fn redo(&mut self, now: &mut Bench) -> Option<()> {
        exchange((&mut self.redo, &mut self.undo), now)
    }

    /// Label of the step that would be undone.
    pub fn to_undo(&self) -> Option<&str> {
        self.undo.last().map(|step| &*step.label)
    }

    /// Label of the step that would be taken again.
    pub fn to_redo(&self) -> Option<&str> {
        self.redo.last().map(|step| &*step.label)
    }

    /// A name for the next file of a model that began as `file`, by the number of the step.
    pub fn short_name(&self, file: &str) -> String {
        let stem: String = file.chars().take(40).collect();
        format!("{}-{}.toml", stem.trim_end_matches(".toml"), self.undo.len() + 1)
    }

    /// Number of the steps.
    pub fn count(&self) -> usize {
        self.undo.len()
    }

    /// The commands that would do what was done.
    pub fn commands(&self) -> impl Iterator<Item = &str> {
        self.undo.iter().flat_map(|step| step.commands.iter().map(String::as_str))
    }
}

/// Goes over the last step of a list to its other side, and hands it to the other list.
fn exchange((from, to): (&mut Vec<Step>, &mut Vec<Step>), now: &mut Bench) -> Option<()> {
    let mut step = from.pop()?;
    std::mem::swap(now, &mut step.other);
    to.push(step);
    Some(())
}
