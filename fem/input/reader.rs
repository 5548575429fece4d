//! The reader of a table: one function per table reads it, checks it and describes it.
//!
//! A table's reading function asks a [`Reader`] for each of its keys. On a user's file the reader answers
//! with the values and notes every problem, so that all of them are reported together; on no file at all it
//! records what was asked, and the record is the JSON Schema. What is read and what is documented can thus
//! never differ.

mod elsewhere;
mod tables;

pub use tables::{Names, is_one_of, numbered};

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Map, Value as Json, json};
use toml_edit::{Item, TableLike};

use super::written::text_of;
use super::{Bounds, Doubt, Kept, Name, Parameter, ParameterId, Problem, nearest};
use crate::units::{Kind, Knowledge, Quantity};

/// Most problems that are kept while a file is read.
const MOST_PROBLEMS: usize = 1000;

/// The key by which a model names a file.
#[derive(Clone, Debug, PartialEq)]
pub struct FileKey {
    /// The path as the model writes it.
    pub written: PathBuf,
    /// The key.
    pub path: ParameterId,
}

/// Findings of one reading beside the values.
#[derive(Debug, Default)]
pub struct Found {
    /// The mistakes, in no order.
    pub problems: Vec<Problem>,
    /// The quantities that are not exactly known.
    pub parameters: Vec<Parameter>,
    /// All quantities, where every value is that of the file.
    pub quantities: Vec<Parameter>,
    /// The files that are named.
    pub files: Vec<FileKey>,
}

/// Values (SI) to take in place of those of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Instead {
    /// Of quantities that are not exactly known, and stay so: a search tries them.
    pub tried: HashMap<ParameterId, f64>,
    /// Of any quantities, which are known with them.
    pub entered: HashMap<ParameterId, f64>,
}

impl Instead {
    /// Whether every value is that of the file.
    pub fn is_nothing(&self) -> bool {
        self.tried.is_empty() && self.entered.is_empty()
    }

    /// Whether one of the values is that of the table of this path, or of a table or list in it.
    fn is_within(&self, path: &str) -> bool {
        let is_of = |own: &ParameterId| own.strip_prefix(path).is_some_and(|rest| rest.starts_with(['.', '[']));
        self.tried.keys().chain(self.entered.keys()).any(is_of)
    }
}

/// The state that all readers of a document share.
#[derive(Default)]
struct Findings {
    found: RefCell<Found>,
    /// The folder that paths are relative to.
    folder: PathBuf,
    /// Values to take in place of those of the file.
    instead: Instead,
    /// Results that stay from one reading to the next.
    kept: Kept,
    /// Paths of tables whose tables are read by somebody else.
    parted: RefCell<Vec<String>>,
}

/// The source from which a reader answers.
enum Ground<'a> {
    /// A table of the user's file.
    Given(&'a dyn TableLike, Option<Range<usize>>),
    /// A table that is not there: every key is absent, and nothing is said again.
    Absent,
    /// No file: what is asked is recorded.
    Described,
}

/// A JSON Schema in the making: properties and the names of those that are required.
#[derive(Default)]
pub struct Shape {
    properties: Map<String, Json>,
    required: Vec<Json>,
    /// What may stand behind names of the user's choice, if any may.
    further: Option<Json>,
}

impl Shape {
    /// The schema of an object with these properties and no others.
    pub fn into_schema(self, about: &str) -> Json {
        let further = self.further.unwrap_or_else(|| json!(false));
        json!({ "type": "object", "description": about, "properties": self.properties, "required": self.required, "additionalProperties": further })
    }
}

/// Reads one table.
pub struct Reader<'a> {
    ground: Ground<'a>,
    path: String,
    findings: std::rc::Rc<Findings>,
    asked: RefCell<Vec<Name>>,
    /// Keys that should be there, until it is known whether one of them is only misspelt.
    absent: RefCell<Vec<(String, Problem)>>,
    shape: RefCell<Shape>,
    /// Whether keys that nobody asks for are let pass.
    is_open: Cell<bool>,
}

impl<'a> Reader<'a> {
    /// Reads the top of a document that is in no file with `read`; the last part holds the problems found, in
    /// no order.
    pub fn document<T>(
        table: &'a dyn TableLike,
        read: impl FnOnce(&Reader<'a>) -> T,
    ) -> (T, Vec<Parameter>, Vec<Problem>) {
        let (value, found) = Self::of_file(table, Path::new(""), &Kept::default(), Instead::default(), read);
        (value, found.parameters, found.problems)
    }

    /// Reads the top of a document whose paths are relative to `folder`, with what was kept from readings
    /// before and other values for some of the quantities.
    pub fn of_file<T>(
        table: &'a dyn TableLike,
        folder: &Path,
        kept: &Kept,
        instead: Instead,
        read: impl FnOnce(&Reader<'a>) -> T,
    ) -> (T, Found) {
        let findings = Findings {
            found: RefCell::default(),
            folder: folder.to_path_buf(),
            instead,
            kept: kept.clone(),
            parted: RefCell::default(),
        };
        let reader = Self::on(Ground::Given(table, None), String::new(), findings.into());
        let value = read(&reader);
        reader.finish();
        (value, reader.findings.found.take())
    }

    /// The schema of what `read` asks for.
    pub fn schema<T>(about: &str, read: impl FnOnce(&Reader<'a>) -> T) -> Json {
        let reader = Self::on(Ground::Described, String::new(), Default::default());
        read(&reader);
        reader.shape.take().into_schema(about)
    }

    fn on(ground: Ground<'a>, path: String, findings: std::rc::Rc<Findings>) -> Self {
        Self {
            ground,
            path,
            findings,
            asked: RefCell::default(),
            absent: RefCell::default(),
            shape: RefCell::default(),
            is_open: Cell::default(),
        }
    }

    fn child(&self, ground: Ground<'a>, key: &str) -> Self {
        let path = self.path_of(key);
        Self::on(ground, path, self.findings.clone())
    }

    /// A key with any text.
    pub fn text(&self, key: impl Into<Name>, about: &'static str) -> Option<String> {
        let key = key.into();
        self.describe(&key, || json!({ "type": "string", "description": about }), false);
        let item = self.item(key.clone())?;
        if item.as_str().is_none() {
            self.refuse(
                Problem::new(format!("`{key}`: expected a text, found {}", item.type_name()))
                    .help(format!("write {key} = \"…\""))
                    .at(item.span()),
            );
        }
        item.as_str().map(str::to_string)
    }

    /// A key with a text or a bare number, as text.
    pub fn text_or_number(&self, key: impl Into<Name>, about: &'static str) -> Option<String> {
        let key = key.into();
        self.describe(&key, || json!({ "type": ["string", "number"], "description": about }), false);
        let item = self.item(key.clone())?;
        let text = text_of(item);
        if text.is_none() {
            let found = item.type_name();
            let problem = Problem::new(format!("`{key}`: expected a text or a number, found {found}"));
            self.refuse(problem.help(format!("write {key} = \"…\"")).at(item.span()));
        }
        text
    }

    /// A key with yes or no.
    pub fn flag(&self, key: &'static str, about: &'static str) -> Option<bool> {
        self.describe(key, || json!({ "type": "boolean", "description": about }), false);
        let item = self.item(key)?;
        if item.as_bool().is_none() {
            let problem = Problem::new(format!("`{key}`: expected true or false, found {}", item.type_name()));
            self.refuse(problem.help(format!("write {key} = true")).at(item.span()));
        }
        item.as_bool()
    }

    /// The keys of this table, in the order of the file.
    pub fn keys(&self) -> Vec<String> {
        match &self.ground {
            Ground::Given(table, _) => table.iter().map(|(key, _)| key.to_string()).collect(),
            Ground::Absent | Ground::Described => Vec::new(),
        }
    }

    /// The text that stands behind a key, if it is one.
    pub fn written(&self, key: &str) -> Option<&'a str> {
        match &self.ground {
            Ground::Given(table, _) => table.get(key).and_then(Item::as_str),
            Ground::Absent | Ground::Described => None,
        }
    }

    /// Notes a problem with a part of the text behind a key, by its bytes in the text.
    pub fn problem_within(&self, key: &str, part: Range<usize>, message: impl Into<String>, help: impl Into<String>) {
        let Ground::Given(table, _) = &self.ground else { return };
        let whole = table.get(key).and_then(Item::span);
        // The text begins behind the opening quote. With escapes the places are others, but stay inside it.
        let span = whole.map(|w| {
            let start = (w.start + 1 + part.start).min(w.end - 1);
            start..(w.start + 1 + part.end).clamp(start + 1, w.end)
        });
        self.refuse(Problem::new(message).help(help).at(span));
    }

    /// Notes a problem with a key of this table, or with the table where the key is absent.
    pub fn problem(&self, key: &str, message: impl Into<String>, help: impl Into<String>) {
        let span = match &self.ground {
            Ground::Given(table, span) => table.get(key).and_then(Item::span).or_else(|| span.clone()),
            _ => return,
        };
        self.refuse(Problem::new(message).help(help).at(span));
    }

    /// Notes a problem with a key of a table of this one, or with that table, or with the key of it.
    pub fn problem_in(&self, table: &str, key: &str, message: impl Into<String>, help: impl Into<String>) {
        let Ground::Given(own, _) = &self.ground else { return };
        let Some(item) = own.get(table) else { return self.problem(table, message, help) };
        let within = item.as_table_like().and_then(|table| table.get(key)).and_then(Item::span);
        self.problem_at(within.or_else(|| item.span()), message, help);
    }

    /// Notes a problem with these bytes of the file.
    pub fn problem_at(&self, span: Option<Range<usize>>, message: impl Into<String>, help: impl Into<String>) {
        self.refuse(Problem::new(message).help(help).at(span));
    }

    /// Takes every key of the table for known: what it should hold cannot be told, for what it depends on is
    /// wrong.
    pub fn accept_any(&self) {
        self.is_open.set(true);
    }

    /// Bytes of this table in the file.
    pub fn span(&self) -> Option<Range<usize>> {
        match &self.ground {
            Ground::Given(_, span) => span.clone(),
            Ground::Absent | Ground::Described => None,
        }
    }

    /// Whether there is no file, and what is asked is only recorded.
    pub fn is_described(&self) -> bool {
        matches!(self.ground, Ground::Described)
    }

    /// Whether nothing wrong has been found in the file so far.
    pub fn is_sound(&self) -> bool {
        self.findings.found.borrow().problems.is_empty()
    }

    /// Whether a key of this table that was read is not exactly known.
    pub fn is_uncertain(&self, key: &str) -> bool {
        let path = self.path_of(key);
        self.findings.found.borrow().parameters.iter().any(|p| *p.path == path)
    }

    /// Whether the file has this key.
    pub fn has(&self, key: &'static str) -> bool {
        matches!(&self.ground, Ground::Given(table, _) if table.contains_key(key))
    }

    /// Says of a key that was read that it may be left out.
    pub fn may_be_left_out(&self, key: &str) {
        self.shape.borrow_mut().required.retain(|required| required != key);
    }

    /// Whether the file has a table behind this key.
    pub fn has_table(&self, key: &'static str) -> bool {
        matches!(&self.ground, Ground::Given(table, _) if table.get(key).is_some_and(Item::is_table_like))
    }

    /// Whether the file has this key in this table of it.
    pub fn has_in(&self, table: &str, key: &str) -> bool {
        let Ground::Given(own, _) = &self.ground else { return false };
        own.get(table).and_then(Item::as_table_like).is_some_and(|table| table.contains_key(key))
    }

    /// Leaves the tables within the table `key` to [`Reader::named_tables`]; its other keys are read as
    /// usual.
    pub fn part(&self, key: &str) {
        self.findings.parted.borrow_mut().push(key.to_string());
    }

    pub(super) fn item(&self, key: impl Into<Name>) -> Option<&'a Item> {
        let key = key.into();
        let item = match &self.ground {
            Ground::Given(table, _) => table.get(&key).filter(|item| !item.is_none()),
            _ => None,
        };
        self.asked.borrow_mut().push(key);
        item
    }

    pub(super) fn refuse(&self, problem: Problem) {
        let problems = &mut self.findings.found.borrow_mut().problems;
        // What is told is less; a list of a million wrong entries need not be kept.
        if problems.len() < MOST_PROBLEMS {
            problems.push(problem);
        }
    }

    /// The model's cache of this type, which stays from one reading to the next.
    pub fn kept<T: Any + Default + Send + Sync>(&self) -> Arc<T> {
        self.findings.kept.get()
    }

    /// What `read` makes of this table, which is what it made before where no value of the table is on trial. It must depend
    /// on nothing else that may be.
    pub fn once<T: Clone + Any + Send + Sync>(&self, read: impl FnOnce(&Self) -> T) -> T {
        let kept = &self.findings.kept;
        if self.is_as_written() {
            let value = read(self);
            kept.keep_table(&self.path, value.clone());
            return value;
        }
        match kept.table::<T>(&self.path).filter(|_| !self.findings.instead.is_within(&self.path)) {
            Some(known) => {
                self.accept_any();
                (*known).clone()
            }
            None => read(self),
        }
    }

    /// Whether a value of a table of this one is on trial.
    pub fn is_on_trial(&self, key: &str) -> bool {
        self.findings.instead.is_within(&self.path_of(key))
    }

    pub(super) fn folder(&self) -> &Path {
        &self.findings.folder
    }

    pub(super) fn keep_file(&self, file: FileKey) {
        self.findings.found.borrow_mut().files.push(file);
    }

    pub(super) fn missing(&self, key: &str, example: &str, about: &str) {
        if let Ground::Given(_, span) = &self.ground {
            let place = if self.path.is_empty() { String::new() } else { format!(" in `{}`", self.path) };
            let problem = Problem::new(format!("`{key}` is missing{place}: {about}")).help(format!("add {example}"));
            let problem = problem.at(Some(span.clone().map_or(0..0, |s| s.start..s.start + 1)));
            self.absent.borrow_mut().push((key.to_string(), problem));
        }
    }

    /// Path of a key of this table.
    pub(super) fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) }
    }

    /// Keeps a quantity that is not exactly known, and gives its value.
    pub(super) fn note(
        &self,
        key: &str,
        (kind, bounds, doubt): (Kind, Bounds, Option<Doubt>),
        quantity: Quantity,
        span: Option<Range<usize>>,
    ) -> f64 {
        let (is_known, instead) = (quantity.knowledge == Knowledge::Known, &self.findings.instead);
        if is_known && !self.is_as_written() && instead.entered.is_empty() {
            return quantity.value;
        }
        let path = self.path_of(key);
        if let Some(entered) = instead.entered.get(path.as_str()) {
            return *entered;
        }
        let value = instead.tried.get(path.as_str()).copied().unwrap_or(quantity.value);
        let parameter = Parameter { path: path.into(), kind, quantity, bounds, span, doubt };
        let found = &mut self.findings.found.borrow_mut();
        if self.is_as_written() {
            found.quantities.push(parameter.clone());
        }
        if !is_known {
            found.parameters.push(parameter);
        }
        value
    }

    /// Whether every quantity has the value of the file, none that of a search.
    pub fn is_as_written(&self) -> bool {
        self.findings.instead.is_nothing()
    }

    pub(super) fn describe(&self, key: &str, schema: impl FnOnce() -> Json, required: bool) {
        if matches!(self.ground, Ground::Described) {
            let schema = schema();
            let mut shape = self.shape.borrow_mut();
            shape.properties.insert(key.to_string(), schema);
            if required {
                shape.required.push(json!(key));
            }
        }
    }

    /// The keys of this table that nobody has asked for, in the order of the file: names of the user's choice.
    pub(super) fn further(&self) -> Vec<Name> {
        let asked = self.asked.borrow();
        let asked: HashSet<&str> = asked.iter().map(Name::as_str).collect();
        self.keys().into_iter().filter(|key| !asked.contains(key.as_str())).map(Name::from).collect()
    }

    /// Refuses the keys that nobody asked for, and tells of those that are not there; a misspelt key is told
    /// of once.
    fn finish(&self) {
        let Ground::Given(table, _) = &self.ground else { return };
        let mut absent = self.absent.take();
        let asked = self.asked.borrow();
        let known: HashSet<&str> = asked.iter().map(Name::as_str).collect();
        for (key, item) in table.iter() {
            if known.contains(key) || self.is_open.get() {
                continue;
            }
            if item.is_table_like() && self.findings.parted.borrow().contains(&self.path) {
                continue;
            }
            let place = if self.path.is_empty() { "this file".to_string() } else { format!("`{}`", self.path) };
            let near = nearest(key, asked.iter().map(Name::as_str).filter(|a| !table.contains_key(a)));
            let help = match near {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("its keys are {}", asked.join(", ")),
            };
            absent.retain(|(missing, _)| Some(missing.as_str()) != near);
            let span = table.key(key).and_then(|k| k.span()).or_else(|| item.span());
            self.refuse(Problem::new(format!("`{key}` is no key of {place}")).help(help).at(span));
        }
        absent.into_iter().for_each(|(_, problem)| self.refuse(problem));
    }
}
