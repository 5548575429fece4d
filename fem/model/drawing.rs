//! The drawing of a machine, which stands in the machine's file: models that draw it too say what is theirs alone.

use std::path::PathBuf;

use toml_edit::{Document, DocumentMut, Item, Table, Value};

use super::entry::{Edit, Entry};
use super::machine::{LARGEST, MACHINE, STRUCTURE};
use super::way::way;
use crate::input::{InputError, Problem, Source};

/// The drawing in the file of a machine, under the one of a model.
pub(super) struct Drawing {
    /// The machine's file.
    source: Source,
    /// Bytes by which places in it stand further on among those of the model.
    offset: usize,
    /// The drawing.
    table: Table,
}

impl Drawing {
    /// Puts the drawing of the machine that a model names under the model's own: what the model writes itself stands, key by
    /// key. `None` where either draws nothing, or the file of the machine is none, which is told by who reads it.
    pub(super) fn under(model: &mut Table, source: &Source) -> Option<Self> {
        model.get(STRUCTURE)?.as_table_like()?;
        let named = model.get(MACHINE)?.as_str().filter(|name| !name.is_empty())?;
        // What everything is to read has to be a file: a pipe cannot be read twice.
        let path: PathBuf = source.folder().join(named);
        let file = path.is_file().then(|| Source::read(&path, LARGEST).ok()).flatten()?;
        let text = file.text.strip_prefix('\u{feff}').unwrap_or(&file.text);
        // Blanks in front, so that places in the two files differ.
        let offset = source.text.len() + 1;
        let document = Document::parse(format!("{}{text}", " ".repeat(offset))).ok()?;
        let table = document.get(STRUCTURE)?.as_table()?.clone();
        let mark = file.text.len() - text.len();
        let own = model.get_mut(STRUCTURE)?;
        if let Some(inline) = own.as_inline_table() {
            *own = Item::Table(inline.clone().into_table());
        }
        complete(own.as_table_mut()?, &table);
        Some(Self { source: file, offset: offset - mark, table })
    }

    /// The mistakes that stand in the file of the machine; `None` where none does.
    pub(super) fn refused(&self, problems: &[Problem]) -> Option<InputError> {
        let of_machine = problems.iter().filter_map(|problem| {
            let span = problem.span.as_ref().filter(|span| span.start >= self.offset)?;
            Some(problem.clone().at(Some(span.start - self.offset..span.end - self.offset)))
        });
        let of_machine: Vec<Problem> = of_machine.collect();
        (!of_machine.is_empty()).then(|| InputError::new(self.source.clone(), of_machine))
    }

    /// The edit that puts a value of the drawing into the text of the model, which then stands in the place of the machine's;
    /// `None` where the model has a table for it.
    pub(super) fn written_over(&self, document: &DocumentMut, edit: &Edit) -> Option<Edit> {
        let Edit::Set { path, entry } = edit else { return None };
        let (above, key) = path.strip_prefix(STRUCTURE)?.strip_prefix('.')?.rsplit_once('.')?;
        let is_there = way(document.as_table(), &format!("{STRUCTURE}.{above}"), true).is_some();
        let is_drawn = self.table.get(above).is_some_and(Item::is_table_like);
        let keys: Vec<(String, Entry)> = vec![(key.to_string(), entry.clone())];
        (is_drawn && !is_there).then(|| Edit::Add { parent: STRUCTURE, name: above.to_string(), keys })
    }
}

/// Gives a table the keys of another that it lacks itself, and so within the tables that both have.
fn complete(own: &mut Table, other: &Table) {
    for (name, theirs) in other {
        match (own.get_mut(name), theirs.as_table_like()) {
            (None, _) => {
                if let Some(key) = other.key(name) {
                    own.insert_formatted(key, theirs.clone());
                }
            }
            (Some(Item::Table(own)), Some(_)) => {
                if let Item::Table(theirs) = theirs {
                    complete(own, theirs);
                }
            }
            (Some(Item::Value(Value::InlineTable(own))), Some(theirs)) => {
                for (name, value) in theirs.iter().filter(|(_, item)| item.is_value()) {
                    if let (false, Some(value)) = (own.contains_key(name), value.as_value()) {
                        own.insert(name, value.clone());
                    }
                }
            }
            (Some(_), _) => {}
        }
    }
}
