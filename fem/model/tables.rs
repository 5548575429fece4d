//! The tables of a model, edited in memory: no text is written or read for an edit. The text of edited tables keeps
//! every comment and the order of the file.

use std::sync::Arc;

use toml_edit::{Document, InlineTable, Item, Table, TableLike, Value};

use crate::input::{InputError, ParameterId, Problem, Source};

/// A change of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// A value for a key of a table that is there, in place of the one that it has.
    Set {
        /// The key.
        path: ParameterId,
        /// Its new value.
        entry: Entry,
    },
    /// One more table `[parent.name]`, behind all others.
    Add {
        /// Table in which it stands.
        parent: &'static str,
        /// Its name there.
        name: String,
        /// Its keys.
        keys: Vec<(String, Entry)>,
    },
    /// The table `[parent.name]` is left out.
    Remove {
        /// Table in which it stands.
        parent: &'static str,
        /// Its name there.
        name: String,
    },
    /// A comment at the top.
    Remark(String),
}

/// Value of a key, as a model holds it.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// A word, or a quantity with its unit: `8.0 +- 0.5 um/km`.
    Text(String),
    /// A pure number.
    Number(f64),
    /// A number of things.
    Whole(i64),
    /// Yes or no.
    Flag(bool),
    /// Names in a text: `part, operator`.
    Words(Vec<String>),
    /// Rows of a file, from 1, in a text: `12, 40`.
    Rows(Vec<usize>),
}

impl std::fmt::Display for Entry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Number(number) => write!(f, "{number}"),
            Self::Whole(number) => write!(f, "{number}"),
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::Words(words) => f.write_str(&words.join(", ")),
            Self::Rows(rows) => f.write_str(&rows.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
        }
    }
}

impl From<&Entry> for Value {
    fn from(entry: &Entry) -> Self {
        match entry {
            Entry::Number(number) => Self::from(*number),
            Entry::Whole(number) => Self::from(*number),
            Entry::Flag(flag) => Self::from(*flag),
            other => Self::from(other.to_string()),
        }
    }
}

/// The tables of a model: those of its file, and the edits that were made since it was read.
#[derive(Clone, Default)]
pub(super) struct Tables {
    /// The file; several tests together have none.
    document: Option<Arc<Document<String>>>,
    /// The tables as they are now. Values of the file know their places there.
    now: Arc<Table>,
    edits: Vec<Edit>,
}

impl Tables {
    /// Reads the tables of a file.
    pub(super) fn parse(source: &Source) -> Result<Self, InputError> {
        let document = Document::parse(source.text.to_string()).map_err(|e| {
            let problem = Problem::new(e.message().trim().replace('\n', ", ")).at(e.span());
            InputError::one(source.clone(), problem.help("a model file is TOML: [table], key = \"value\", # comment"))
        })?;
        let now = Arc::new(document.as_table().clone());
        Ok(Self { document: Some(Arc::new(document)), now, edits: Vec::new() })
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
        let edits = [&self.edits, edits].concat();
        Ok(Self { document: self.document.clone(), now: Arc::new(now), edits })
    }

    /// The value of a key, if the tables have it.
    pub(super) fn value(&self, path: &str) -> Option<&Item> {
        let (key, number, rest) = first(&*self.now, path)?;
        let (mut item, mut number, mut rest) = (self.now.get(key)?, number, rest);
        while !rest.is_empty() {
            let table = entry_of(item, number)?;
            let (key, next, behind) = first(table, rest)?;
            (item, number, rest) = (table.get(key)?, next, behind);
        }
        Some(item)
    }

    /// The tables before the last of the edits; `None` where they are as they were read.
    pub(super) fn undone(&self) -> Option<Self> {
        let (document, (_, edits)) = (self.document.as_ref()?, self.edits.split_last()?);
        let read =
            Self { document: Some(document.clone()), now: Arc::new(document.as_table().clone()), edits: Vec::new() };
        // They could be made before.
        read.edited(edits).ok()
    }

    /// The edits that were made since the file was read.
    pub(super) fn edits(&self) -> &[Edit] {
        &self.edits
    }

    /// Comments at the top that edits have made, and lines of comment of the file.
    pub(super) fn remarks<'a>(&'a self, source: &'a Source) -> impl Iterator<Item = &'a str> {
        let made =
            self.edits.iter().filter_map(|edit| if let Edit::Remark(text) = edit { Some(&**text) } else { None });
        made.chain(source.text.lines().filter(|line| line.starts_with('#')))
    }

    /// The text with all edits and `more`.
    pub(super) fn text(&self, source: &Source, more: &[Edit]) -> String {
        let edits = [&self.edits, more].concat();
        let (Some(document), false) = (&self.document, edits.is_empty()) else { return source.text.to_string() };
        let mut document = (**document).clone().into_mut();
        for (number, edit) in edits.iter().enumerate() {
            // They could be made before, when the model was edited.
            let _ = apply(&mut document, edit, number);
        }
        let end = document.trailing().as_str().unwrap_or_default().to_string();
        let gap = if end.is_empty() || end.ends_with('\n') { "\n" } else { "\n\n" };
        let added = edits.iter().find_map(|edit| match edit {
            Edit::Add { parent, name, .. } => Some((*parent, &**name)).filter(|(parent, name)| {
                document.get(parent).and_then(|tables| tables.get(name)).is_some_and(Item::is_table)
            }),
            _ => None,
        });
        // Comments at the end of the file stay before what is added behind it.
        if let Some(table) = added.and_then(|(parent, name)| document[parent][name].as_table_mut()) {
            table.decor_mut().set_prefix(format!("{end}{gap}"));
            document.set_trailing("");
        }
        let remarks =
            edits.iter().rev().filter_map(|edit| if let Edit::Remark(text) = edit { Some(text) } else { None });
        let remarks: String = remarks.map(|text| format!("# {text}\n")).collect();
        let mark = if source.text.starts_with('\u{feff}') { "\u{feff}" } else { "" };
        let text = format!("{mark}{remarks}{document}");
        // The library writes ends of lines as \n, whatever the file has.
        if source.text.contains("\r\n") { text.replace('\n', "\r\n") } else { text }
    }
}

/// The first key of a path, the number behind it in `key[1]`, and the rest of the path. Keys may have dots themselves.
fn first<'t, 'p>(table: &'t dyn TableLike, path: &'p str) -> Option<(&'t str, Option<usize>, &'p str)> {
    table.iter().find_map(|(key, _)| {
        let rest = path.strip_prefix(key)?;
        let (number, rest) = match rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
            Some((number, rest)) => (Some(number.parse().ok()?), rest),
            None => (None, rest),
        };
        if rest.is_empty() { Some((key, number, rest)) } else { Some((key, number, rest.strip_prefix('.')?)) }
    })
}

/// A table, or one of a list of tables.
fn entry_of(item: &Item, number: Option<usize>) -> Option<&dyn TableLike> {
    match (item, number) {
        (item, None) => item.as_table_like(),
        (Item::ArrayOfTables(list), Some(number)) => list.get(number).map(|table| table as &dyn TableLike),
        (item, Some(number)) => item.as_array()?.get(number)?.as_inline_table().map(|table| table as &dyn TableLike),
    }
}

/// The same, to be changed.
fn entry_of_mut(item: &mut Item, number: Option<usize>) -> Option<&mut dyn TableLike> {
    match (item, number) {
        (item, None) => item.as_table_like_mut(),
        (Item::ArrayOfTables(list), Some(number)) => list.get_mut(number).map(|table| table as &mut dyn TableLike),
        (item, Some(number)) => {
            item.as_array_mut()?.get_mut(number)?.as_inline_table_mut().map(|table| table as &mut dyn TableLike)
        }
    }
}

/// Makes one of a model's edits, by its number.
fn apply(tables: &mut Table, edit: &Edit, number: usize) -> Result<(), Problem> {
    match edit {
        Edit::Set { path, entry } => set(tables, path, entry)
            .ok_or_else(|| Problem::new(format!("the model has no table for `{path}`")).help("add the table first")),
        Edit::Add { parent, name, keys } => {
            let values = keys.iter().map(|(key, entry)| (key, Value::from(entry)));
            if let Some(Item::Value(Value::InlineTable(within))) = tables.get_mut(parent) {
                within.insert(name, Value::InlineTable(values.collect::<InlineTable>()));
                return Ok(());
            }
            let mut table: Table = values.map(|(key, value)| (key, Item::Value(value))).collect();
            // Behind every table of the file, and behind those that were added before.
            table.set_position(Some(isize::MAX / 2 + number as isize));
            let mut implicit = Table::new();
            implicit.set_implicit(true);
            let within = tables.entry(parent).or_insert(Item::Table(implicit)).as_table_mut();
            let within = within.ok_or_else(|| Problem::new(format!("`{parent}` is no table")))?;
            within.insert(name, Item::Table(table));
            Ok(())
        }
        Edit::Remove { parent, name } => {
            let within = tables.get_mut(parent).and_then(Item::as_table_like_mut);
            let removed = within.and_then(|tables| tables.remove(name));
            removed.map(drop).ok_or_else(|| Problem::new(format!("the model has no table [{parent}.{name}]")))
        }
        Edit::Remark(_) => Ok(()),
    }
}

/// Puts a value behind a key; `None` where its table is missing.
fn set(tables: &mut Table, path: &str, entry: &Entry) -> Option<()> {
    let mut table: &mut dyn TableLike = tables;
    let mut rest = path;
    loop {
        // A key that is not there yet is whatever remains of the path.
        let Some((key, number, behind)) =
            first(table, rest).map(|(key, number, behind)| (key.to_string(), number, behind))
        else {
            return (!rest.contains(['.', '['])).then(|| drop(table.insert(rest, Item::Value(entry.into()))));
        };
        let item = table.get_mut(&key)?;
        if behind.is_empty() && number.is_none() {
            let decor = item.as_value().map(Value::decor).cloned();
            let mut value = Value::from(entry);
            if let Some(decor) = decor {
                *value.decor_mut() = decor;
            }
            *item = Item::Value(value);
            return Some(());
        }
        table = entry_of_mut(item, number)?;
        rest = behind;
    }
}
