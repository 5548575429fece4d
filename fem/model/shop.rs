//! The tables `[[setting]]`: what a shop can change, within which limits, and what it costs. They change nothing by
//! themselves; whoever asks what to change tries them.

use std::ops::Range;

use super::Edit;
use crate::input::{ParameterId, Raw, Reader};
use crate::units::{Kind, TIME};

/// Most of them: pairs of them are tried, too.
const MOST: usize = 40;
/// Most values of one of them.
const MOST_VALUES: usize = 100;
/// The key of the list.
const KEY: &str = "setting";

/// One thing that a shop can change.
#[derive(Clone, Debug, PartialEq)]
pub struct ShopSetting {
    /// What people call it; the path of its quantity where nothing is said.
    pub name: String,
    /// The quantity, count or word that varies, by its path, and how far.
    pub varies: Option<(ParameterId, Reach)>,
    /// What is written into the model with it, and what is left out: a steady rest, another way of holding.
    pub edits: Vec<Edit>,
    /// Time that changing it costs once, and for every part, s.
    pub once: f64,
    /// See `once`.
    pub each: f64,
    /// The range in which the model was held against measurements, as it is written.
    pub measured: Option<[Raw; 2]>,
    /// Bytes of the table in the file.
    pub span: Option<Range<usize>>,
}

/// Reads the largest change of the command that the machine may be given, SI, told in `kind`, if the model says one.
pub fn largest_change(model: &Reader, kind: Kind) -> Option<f64> {
    let about = "what the machine may be commanded otherwise than the drawing says, for `fem correct`";
    let largest = |t: &Reader| {
        let about = "the largest change of the command, either way: what a control or its operator allows";
        t.quantity("largest", kind, about).chosen().positive().optional()
    };
    model.optional_table("correction", about, largest).flatten()
}

/// How far a quantity may be changed, as it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Reach {
    /// From one value to another.
    Between([Raw; 2]),
    /// One of these.
    OneOf(Vec<Raw>),
}

impl ShopSetting {
    /// Reads all of them.
    pub fn all(model: &Reader) -> Vec<Self> {
        let about = "what the shop can change, for `fem correct --remedies`";
        if !model.is_described() && !model.is_as_written() {
            // Trial values change none of them.
            model.list(KEY, about, |t, _| t.accept_any());
            return Vec::new();
        }
        let all: Vec<Self> = model.list(KEY, about, |t, _| Self::read(t)).into_iter().flatten().collect();
        if all.len() > MOST {
            model.problem(KEY, format!("{} settings are more than {MOST}", all.len()), "leave out the least likely");
        }
        for (i, own) in all.iter().enumerate() {
            if all[..i].iter().any(|other| other.name == own.name) {
                let message = format!("two settings are called `{}`", own.name);
                model.problem(KEY, message, "give each a `name` of its own");
            }
        }
        all
    }

    fn read(t: &Reader) -> Option<Self> {
        let name = t.text("name", "what people call it; the path of its quantity if left out");
        let quantity = t.text("quantity", "quantity, count or word that varies, by its path: cut.feed");
        let from = t.raw("from", "the least that it can be");
        let to = t.raw("to", "the most that it can be");
        let values = t.raws("values", "values that it can have, in the place of `from` and `to`");
        let about = "what is written into the model with it, behind paths: \"workholding.steady_rests\" = [{ … }]";
        let write = t.raw_table("write", about);
        let remove = t.raws("remove", "paths of what is left out of the model with it");
        let time = |key, about| t.quantity(key, TIME, about).chosen().or(0.0);
        let once =
            time("minutes", "what changing it costs once; of processes that know how long cutting takes, beside that");
        let each = time("minutes_per_part", "what it costs for every part");
        let measured = t.raws("measured", "two ends of the range in which the model was held against measurements");
        let varies = match (&quantity, from, to) {
            (None, None, None) if values.is_empty() => None,
            (None, ..) => {
                t.problem(
                    "",
                    "it is not said what varies",
                    "add quantity = \"cut.feed\", the path of a key of the model",
                );
                return None;
            }
            (Some(path), Some(from), Some(to)) if values.is_empty() => Some((path, Reach::Between([from, to]))),
            (Some(path), None, None) if (1..=MOST_VALUES).contains(&values.len()) => Some((path, Reach::OneOf(values))),
            (Some(path), None, None) if !values.is_empty() => {
                t.problem("values", format!("more than {MOST_VALUES} values of `{path}`"), "give `from` and `to`");
                return None;
            }
            (Some(path), ..) => {
                let message = format!("it is not said how far `{path}` can be changed");
                t.problem("quantity", message, "give either `from` and `to`, or `values`");
                return None;
            }
        };
        if write.is_empty() && remove.is_empty() && varies.is_none() {
            t.problem("", "the setting changes nothing", "give `quantity` with `from` and `to`, or `write`");
            return None;
        }
        let Some(name) = name.or_else(|| quantity.clone()) else {
            t.problem("", "the setting has no name", "add name = \"steady rest in the middle\"");
            return None;
        };
        let paths = || write.iter().map(|(path, _)| path.as_str()).chain(quantity.as_deref());
        if paths().any(|path| path == "process" || path.starts_with(KEY)) {
            t.problem("", "a setting changes neither the process nor settings", "name keys of the other tables");
            return None;
        }
        let measured = match <[Raw; 2]>::try_from(measured) {
            Ok(ends) => Some(ends),
            Err(none) if none.is_empty() => None,
            Err(_) => {
                t.problem("measured", "it has two ends", "write measured = [\"0.1 mm/rev\", \"0.2 mm/rev\"]");
                None
            }
        };
        let removed = remove.iter().map(|path| Edit::Erase(path.to_string().into()));
        let written = write.into_iter().map(|(path, value)| Edit::Write { path: path.into(), value });
        let varies = varies.map(|(path, reach)| (ParameterId::from(path.as_str()), reach));
        let edits = removed.chain(written).collect();
        Some(Self { name, varies, edits, once, each, measured, span: t.span() })
    }

    /// Paths of what it changes.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        let edited = self.edits.iter().filter_map(|edit| match edit {
            Edit::Write { path, .. } | Edit::Erase(path) => Some(&**path),
            _ => None,
        });
        edited.chain(self.varies.iter().map(|(path, _)| &**path))
    }
}
