//! The tables of a model, edited in memory: no text is written or read for an edit. The text of edited tables keeps
//! every comment and the order of the file.

use std::sync::Arc;

use toml_edit::{Document, DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::drawing::Drawing;
use super::entry::Edit;
use super::way::{copy, entry_of, erase, replace, set, way, write};
use crate::input::{InputError, Problem, Source, texts};

/// The tables of a model: those of its file, the drawing that it takes from the file of its machine, and the edits that were
/// made since it was read.
#[derive(Clone, Default)]
pub(super) struct Tables {
    /// The tables as they were read. Values know their places in the file.
    read: Arc<Table>,
    /// The tables with the edits.
    now: Arc<Table>,
    edits: Vec<Edit>,
    /// What stands in the file of its machine.
    drawing: Option<Arc<Drawing>>,
}

impl Tables {
    /// Reads the tables of a file.
    pub(super) fn parse(source: &Source) -> Result<Self, InputError> {
        let document = Document::parse(&*source.text).map_err(|e| {
            let problem = Problem::new(e.message().trim().replace('\n', ", ")).at(e.span());
            InputError::one(source.clone(), problem.help("a model file is TOML: [table], key = \"value\", # comment"))
        })?;
        let mut read = document.as_table().clone();
        let drawing = Drawing::under(&mut read, source).map(Arc::new);
        let read = Arc::new(read);
        Ok(Self { now: read.clone(), read, edits: Vec::new(), drawing })
    }

    /// What is wrong with them, in the file in which it stands: mistakes in the drawing of the machine are told alone.
    pub(super) fn refused(&self, source: &Source, problems: Vec<Problem>) -> InputError {
        match self.drawing.as_ref().and_then(|drawing| drawing.refused(&problems)) {
            Some(error) => error,
            None => InputError::new(source.clone(), problems),
        }
    }

    /// The tables as they are now.
    pub(super) fn now(&self) -> &Table {
        &self.now
    }

    /// The tables with these edits.
    ///
    /// # Errors
    /// An edit is about a table that is not there.
    pub(super) fn edited(&self, edits: &[Edit]) -> Result<Self, Problem> {
        let mut now = (*self.now).clone();
        for (number, edit) in edits.iter().enumerate() {
            apply(&mut now, edit, self.edits.len() + number)?;
        }
        Ok(Self { now: Arc::new(now), edits: [&self.edits, edits].concat(), ..self.clone() })
    }

    /// The value of a key, if the tables have it.
    pub(super) fn value(&self, path: &str) -> Option<&Item> {
        let way = way(&*self.now, path, false)?;
        let ((key, _), above) = way.split_last()?;
        let mut table: &dyn TableLike = &*self.now;
        for (key, entry) in above {
            table = entry_of(table.get(key)?, *entry)?;
        }
        table.get(key)
    }

    /// Every text that stands for a value.
    pub(super) fn texts(&self) -> Vec<String> {
        fn of_table(table: &Table) -> Vec<String> {
            let of_item = |(_, item): (&str, &Item)| match item {
                Item::Value(value) => texts(value).into_iter().map(str::to_string).collect(),
                Item::Table(table) => of_table(table),
                Item::ArrayOfTables(list) => list.iter().flat_map(of_table).collect(),
                Item::None => Vec::new(),
            };
            table.iter().flat_map(of_item).collect()
        }
        of_table(&self.now)
    }

    /// The tables before the last of the edits; `None` where they are as they were read.
    pub(super) fn undone(&self) -> Option<Self> {
        let (_, edits) = self.edits.split_last()?;
        // They could be made before.
        Self { now: self.read.clone(), edits: Vec::new(), ..self.clone() }.edited(edits).ok()
    }

    /// The edits that were made since the file was read.
    pub(super) fn edits(&self) -> &[Edit] {
        &self.edits
    }

    /// Comments at the top that edits have made, and lines of comment of the file.
    pub(super) fn remarks<'a>(&'a self, source: &'a Source) -> impl Iterator<Item = &'a str> {
        let text = source.text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&source.text);
        remarks(&self.edits).chain(text.lines().filter(|line| line.starts_with('#')))
    }

    /// The text with all edits and `more`.
    pub(super) fn text(&self, source: &Source, more: &[Edit]) -> String {
        let edits = [&self.edits, more].concat();
        if edits.is_empty() {
            return source.text.to_string();
        }
        // The library writes the ends of lines as \n, and leaves those within texts as they are.
        let is_crlf = source.text.matches('\n').count() == source.text.matches("\r\n").count();
        let text = if is_crlf { source.text.replace("\r\n", "\n") } else { source.text.to_string() };
        // It could be read before.
        let mut document: DocumentMut = text.parse().unwrap_or_default();
        for (number, edit) in edits.iter().enumerate() {
            if let Edit::Remove { parent, name } = edit {
                hand_comments_on(&mut document, parent, name);
            }
            let added = self.drawing.as_ref().and_then(|drawing| drawing.written_over(&document, edit));
            // They could be made before, when the model was edited.
            let _ = apply(&mut document, added.as_ref().unwrap_or(edit), number);
        }
        append(&mut document, &edits);
        let remarks: Vec<String> = remarks(&edits).map(|text| format!("# {text}\n")).collect();
        let remarks: String = remarks.into_iter().rev().collect();
        let mark = if source.text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK } else { "" };
        let text = format!("{mark}{remarks}{document}");
        if is_crlf { text.replace('\n', "\r\n") } else { text }
    }
}

/// Some editors put it before the text.
const BYTE_ORDER_MARK: &str = "\u{feff}";

/// Comments that edits leave at the top.
fn remarks(edits: &[Edit]) -> impl Iterator<Item = &str> {
    edits.iter().filter_map(|edit| if let Edit::Remark(text) = edit { Some(&**text) } else { None })
}

/// Puts the tables that were added behind the comments at the end of the file.
fn append(document: &mut DocumentMut, edits: &[Edit]) {
    let first = edits.iter().find_map(|edit| match edit {
        Edit::Add { parent, name, .. } => table_of(document, parent, name).and_then(Table::position),
        _ => None,
    });
    let Some(first) = first else { return };
    let end = document.trailing().as_str().unwrap_or_default().to_string();
    let gap = if end.is_empty() || end.ends_with('\n') { "\n" } else { "\n\n" };
    if let Some(table) = at_position(document.as_table_mut(), first) {
        table.decor_mut().set_prefix(format!("{end}{gap}"));
        document.set_trailing("");
    }
}

/// Leaves the comments before a table to whatever stands behind it.
fn hand_comments_on(document: &mut DocumentMut, parent: &str, name: &str) {
    let table = table_of(document, parent, name);
    let before = table.and_then(|table| table.decor().prefix()).and_then(|prefix| prefix.as_str());
    let Some(before) = before.filter(|text| text.contains('#')).map(str::to_string) else { return };
    // An empty line above the table goes with it.
    let comments = before.strip_suffix('\n').filter(|text| text.ends_with('\n')).unwrap_or(&before);
    let own = table.and_then(Table::position);
    let next = own.and_then(|own| positions(document.as_table()).into_iter().filter(|other| *other > own).min());
    match next.and_then(|next| at_position(document.as_table_mut(), next)) {
        Some(next) => {
            let behind = next.decor().prefix().and_then(|prefix| prefix.as_str()).unwrap_or("\n").to_string();
            next.decor_mut().set_prefix(format!("{comments}{behind}"));
        }
        None => {
            let behind = document.trailing().as_str().unwrap_or_default().to_string();
            document.set_trailing(format!("{comments}{behind}"));
        }
    }
}

/// Places in the file of a table and all within it.
fn positions(table: &Table) -> Vec<isize> {
    let within = table.iter().flat_map(|(_, item)| match item {
        Item::Table(table) => positions(table),
        Item::ArrayOfTables(list) => list.iter().flat_map(positions).collect(),
        _ => Vec::new(),
    });
    table.position().into_iter().chain(within).collect()
}

/// The table, itself or within it, that stands at a place in the file.
fn at_position(table: &mut Table, position: isize) -> Option<&mut Table> {
    if table.position() == Some(position) {
        return Some(table);
    }
    table.iter_mut().find_map(|(_, item)| match item {
        Item::Table(table) => at_position(table, position),
        Item::ArrayOfTables(list) => list.iter_mut().find_map(|table| at_position(table, position)),
        _ => None,
    })
}

/// The table of which another one is a part, if it is one, and its name there: the change of an effect stands within
/// the effect's table. Names may have dots themselves.
fn owned<'n>(tables: &dyn TableLike, name: &'n str) -> (Option<&'n str>, &'n str) {
    match name.rsplit_once('.') {
        Some((owner, own)) if !tables.contains_key(name) && tables.contains_key(owner) => (Some(owner), own),
        _ => (None, name),
    }
}

/// The table of an effect, or of another thing that stands in a table of tables.
fn table_of<'t>(document: &'t DocumentMut, parent: &str, name: &str) -> Option<&'t Table> {
    let within = document.get(parent)?;
    match owned(within.as_table_like()?, name) {
        (Some(owner), own) => within.get(owner)?.get(own)?.as_table(),
        (None, name) => within.get(name)?.as_table(),
    }
}

/// Makes one of a model's edits, by its number.
fn apply(tables: &mut Table, edit: &Edit, number: usize) -> Result<(), Problem> {
    match edit {
        Edit::Set { path, entry } => set(tables, path, Value::from(entry)).ok_or_else(|| {
            Problem::new(format!("the model has no table for `{path}`"))
                .help("name a key of a table that stands there, or of an entry of a list, from 0: `segments[0].length`")
        }),
        Edit::Add { parent, name, keys } => {
            let values = keys.iter().map(|(key, entry)| (key, Value::from(entry)));
            let inline = || Value::InlineTable(values.clone().collect::<InlineTable>());
            if let Some(Item::Value(Value::InlineTable(within))) = tables.get_mut(parent) {
                let (owner, own) = owned(within, name);
                let owner = owner.and_then(|owner| within.get_mut(owner)).and_then(Value::as_inline_table_mut);
                match owner {
                    Some(owner) => owner.insert(own, inline()),
                    None => within.insert(name, inline()),
                };
                return Ok(());
            }
            let mut table: Table = values.clone().map(|(key, value)| (key, Item::Value(value))).collect();
            // Behind every table of the file, and behind those that were added before.
            table.set_position(Some(isize::MAX / 2 + number as isize));
            let mut implicit = Table::new();
            implicit.set_implicit(true);
            let within = tables.entry(parent).or_insert(Item::Table(implicit)).as_table_mut();
            let within = within.ok_or_else(|| Problem::new(format!("`{parent}` is no table")))?;
            let (owner, own) = owned(within, name);
            match owner.and_then(|owner| within.get_mut(owner)) {
                Some(Item::Table(owner)) => owner.insert(own, Item::Table(table)),
                Some(Item::Value(Value::InlineTable(owner))) => owner.insert(own, inline()).map(Item::Value),
                _ => within.insert(name, Item::Table(table)),
            };
            Ok(())
        }
        Edit::Remove { parent, name } => {
            let within = tables.get_mut(parent).and_then(Item::as_table_like_mut);
            let removed = within.and_then(|tables| match owned(tables, name) {
                (Some(owner), own) => tables.get_mut(owner)?.as_table_like_mut()?.remove(own),
                (None, name) => tables.remove(name),
            });
            removed.map(drop).ok_or_else(|| Problem::new(format!("the model has no table [{parent}.{name}]")))
        }
        Edit::Write { path, value } => write(tables, path, value.value()).ok_or_else(|| {
            Problem::new(format!("`{path}` is no place in a model"))
                .help("name tables from the top of the file, and entries of lists that are there: `cut.feed`, `pass[0].depth`")
        }),
        Edit::Erase(path) => {
            erase(tables, path);
            Ok(())
        }
        Edit::Copy(path) => copy(tables, path).ok_or_else(|| {
            Problem::new(format!("`{path}` is no table of a list")).help("name one that is there, from 0: `segments[0]`")
        }),
        Edit::Replace { path, value } => replace(tables, path, value.value())
            .ok_or_else(|| Problem::new(format!("`{path}` is no table of a list")).help("name one that is there, from 0")),
        Edit::Remark(_) => Ok(()),
    }
}
