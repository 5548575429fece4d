//! Edits of a model, and the values that they put into it.

use toml_edit::{Array, InlineTable, Value};

use crate::input::{ParameterId, Raw};

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
    /// Whatever stands at a path, which may be new: keys of a table are put into the one that is there, all else takes the
    /// place of what is there.
    Write {
        /// The key.
        path: ParameterId,
        /// A value, a list or a table.
        value: Raw,
    },
    /// What stands at a path is left out, if it is there.
    Erase(ParameterId),
    /// A table of a list, `workpiece.segments[1]`, stands there twice, the second behind the first.
    Copy(ParameterId),
    /// A table of a list gets these keys and no others.
    Replace {
        /// The table: `workpiece.segments[1]`.
        path: ParameterId,
        /// Its keys.
        value: Raw,
    },
    /// A comment at the top.
    Remark(String),
}

/// Length beyond which a list of tables does not stand on one line.
const LINE: usize = 120;

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
    /// A list of tables, each with its keys: `[{ after = 5, duration = "30 min" }]`.
    Tables(Vec<Vec<(String, Entry)>>),
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
            Self::Tables(_) => Value::from(self).fmt(f),
        }
    }
}

impl From<&Entry> for Value {
    fn from(entry: &Entry) -> Self {
        match entry {
            Entry::Number(number) => Self::from(*number),
            Entry::Whole(number) => Self::from(*number),
            Entry::Flag(flag) => Self::from(*flag),
            Entry::Tables(tables) => {
                let table = |keys: &Vec<(String, Entry)>| -> Self {
                    keys.iter().map(|(key, entry)| (key, Self::from(entry))).collect::<InlineTable>().into()
                };
                let mut all: Array = tables.iter().map(table).collect();
                // What is long stands on lines of its own.
                if all.to_string().len() > LINE {
                    all.iter_mut().for_each(|own| own.decor_mut().set_prefix("\n  "));
                    all.set_trailing("\n");
                    all.set_trailing_comma(true);
                }
                Self::Array(all)
            }
            other => Self::from(other.to_string()),
        }
    }
}
