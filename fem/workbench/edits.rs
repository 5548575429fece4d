//! The model of a session is edited: its values, its lists of tables, its effects.

use super::bench::Bench;
use super::refusal::Refusal;
use super::session::Session;
use crate::ask::{mended, revised};
use crate::input::Raw;
use crate::model::{Edit, Entry, Model, Setting, add_effect};
use crate::output::{add_command, leave_out_command, quoted, set_command};

/// Longest name of a file that tells all that was done to a model, bytes.
const LONGEST: usize = 100;

/// What may be done with the tables of a list.
#[derive(Clone, Copy)]
pub enum Row<'a> {
    /// One is put there a second time.
    Copy(usize),
    /// One is left out.
    Remove(usize),
    /// One more, with these keys and what is written for them.
    Add(&'a [(String, String)]),
}

impl Session {
    /// Puts another model in the place of the one that is open, `by` a command that writes a file.
    pub(super) fn change(&mut self, label: String, by: Option<(String, String)>, model: Model, is_told: bool) {
        let mut next = Bench { model: Some(model), ..self.now.clone() };
        let command = by.map(|(command, to)| {
            let short = self.steps.short_name(&self.now.by_commands);
            let (command, to) = match to.len() > LONGEST {
                true => (command.replace(&quoted(&to), &quoted(&short)), short),
                false => (command, to),
            };
            next.by_commands = to;
            command
        });
        next.compare();
        if is_told {
            next.note(label.clone());
        }
        self.step(label, command, next);
    }

    /// Writes another value: `450 +- 20 N`, `? N`.
    ///
    /// # Errors
    /// The model would not be right.
    pub fn set(&mut self, path: &str, text: &str) -> Result<(), Refusal> {
        let model = self.model()?;
        self.folder.keeps(text)?;
        if let Some(written) = Raw::parse(text) {
            written.texts().into_iter().try_for_each(|own| self.folder.keeps(own))?;
        }
        let setting = Setting { key: path.to_string(), value: Entry::Text(text.to_string()) };
        let next =
            revised(model, std::slice::from_ref(&setting), &[]).map_err(|problem| Refusal::from(problem).at(path))?;
        self.folder.holds(&next)?;
        let command = set_command(&self.now.by_commands, &setting);
        self.change(format!("{path} = {text}"), Some(command), next, false);
        Ok(())
    }

    /// Puts one more table into a list, or takes one out.
    ///
    /// # Errors
    /// There is no such list or table, or the model would not be right.
    pub fn row(&mut self, path: &str, row: Row) -> Result<(), Refusal> {
        let model = self.model()?;
        let rows = model.outline().lists.into_iter().find(|own| own.path == path).map_or(0, |own| own.rows);
        let at = |number: usize| format!("{path}[{number}]").into();
        let edits = match row {
            Row::Copy(number) => vec![Edit::Copy(at(number))],
            Row::Remove(number) if number < rows => vec![Edit::Erase(at(number))],
            Row::Remove(number) => {
                return Err(Refusal::new(format!("{path} has no table {number}"), "name one that is there, from 0"));
            }
            Row::Add(keys) => {
                keys.iter().try_for_each(|(_, text)| self.folder.keeps(text))?;
                let table = Raw::of_keys(keys.iter().map(|(key, text)| (key.as_str(), text.as_str())));
                match rows {
                    0 => vec![Edit::Write { path: path.into(), value: Raw::of_list([table]) }],
                    // Like those that are there, so that it stands as they do.
                    rows => vec![Edit::Copy(at(rows - 1)), Edit::Replace { path: at(rows), value: table }],
                }
            }
        };
        let next = model.edited(&edits).map_err(|problem| Refusal::from(problem).at(path))?;
        self.folder.holds(&next)?;
        let written = next.raw(path).map_or("[]".to_string(), |own| own.on_one_line());
        let setting = Setting { key: path.to_string(), value: Entry::Text(written) };
        let command = set_command(&self.now.by_commands, &setting);
        let label = match row {
            Row::Copy(number) => format!("copy {path}[{number}]"),
            Row::Remove(number) => format!("remove {path}[{number}]"),
            Row::Add(_) => format!("add to {path}"),
        };
        self.change(label, Some(command), next, false);
        Ok(())
    }

    /// Adds an effect: with the values of the last diagnosis where that found it, with unknown ones else.
    ///
    /// # Errors
    /// It is none of this process, it is there, or it cannot act in this model.
    pub fn add(&mut self, effect: &str) -> Result<(), Refusal> {
        let model = self.model()?;
        let found = self.now.diagnosed.as_ref().and_then(|own| {
            let place = own.json["missing"].as_array()?.iter().position(|cause| cause["effect"] == effect)?;
            own.additions.get(place)
        });
        let (next, command) = match found {
            Some(addition) => (mended(model, addition)?, addition.command(&self.now.by_commands)),
            None => (add_effect(model, effect, &[])?, add_command(&self.now.by_commands, effect, &[])),
        };
        self.change(format!("+ {effect}"), Some(command), next, true);
        Ok(())
    }

    /// Leaves an effect out.
    ///
    /// # Errors
    /// The model has none of the name.
    pub fn remove(&mut self, effect: &str) -> Result<(), Refusal> {
        let next = revised(self.model()?, &[], &[effect.to_string()])?;
        let command = leave_out_command(&self.now.by_commands, effect);
        self.change(format!("- {effect}"), Some(command), next, true);
        Ok(())
    }
}
