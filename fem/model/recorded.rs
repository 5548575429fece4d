//! Columns that measurements record beside the coordinates of their process, as coordinates of a model: those of the
//! files that it is held against, and those that its table `[recorded]` names.

use super::{Edit, Model, formula_effect};
use crate::input::{Name, Raw, Reader};
use crate::process::{Coordinate, Description, Holds, Observable, Process, System, UnitRole, Variant};
use crate::units::Kind;

/// The table that says what columns usually are.
const TABLE: &str = "recorded";

/// A process of the catalogue whose rows have further columns.
pub struct Recorded {
    process: &'static dyn Process,
    coordinates: Vec<Coordinate>,
    /// Number of those that files have.
    of_files: usize,
}

impl Recorded {
    /// A process with the columns of files, and those of which a model says what they usually are; `None` where there are
    /// none.
    pub fn new(process: &'static dyn Process, of_files: &[Coordinate], said: Vec<Coordinate>) -> Option<Self> {
        let mut coordinates = process.coordinates().to_vec();
        for own in of_files {
            let usual = said.iter().find(|other| other.name == own.name).map_or(own.absent, |other| other.absent);
            coordinates.push(Coordinate { absent: usual, ..own.clone() });
        }
        coordinates.extend(said.into_iter().filter(|own| of_files.iter().all(|other| other.name != own.name)));
        let is_more = coordinates.len() > process.coordinates().len();
        is_more.then_some(Self { process, coordinates, of_files: of_files.len() })
    }

    /// The columns that files have.
    pub fn of_files(&self) -> &[Coordinate] {
        let own = self.process.coordinates().len();
        &self.coordinates[own..own + self.of_files]
    }
}

/// Reads `[recorded]`: what the columns that a formula names usually are, where rows do not have them.
pub fn read(model: &Reader, process: &dyn Process, of_files: &[Coordinate]) -> Vec<Coordinate> {
    let about = "columns that files have beside those of the process, with what they usually are, for formulas";
    let read = |t: &Reader| {
        let mut said = Vec::new();
        for key in t.keys() {
            let key = Name::from(key);
            if process.coordinates().iter().any(|own| own.name == key && !own.is_recorded) {
                t.problem(&key, format!("`{key}` is a coordinate of {}", process.name()), "leave it out");
            }
            let Some(kind) = formula_effect::kind(t.written(&key)) else {
                t.problem(&key, "its unit is longer than any", "write it with fewer factors");
                t.accept_any();
                return said;
            };
            let usual = t.quantity(key.clone(), kind, "its usual value").chosen().required();
            let dimension = |holds: &Holds| holds.kind().map(|kind| kind.canonical().dimension);
            let own = Holds::Quantity(kind);
            let of_file = of_files.iter().find(|other| other.name == key);
            if let Some(other) = of_file.filter(|other| dimension(&other.holds) != dimension(&own)) {
                let has = other.holds.kind().map_or("words".into(), |kind| kind.unit.to_string());
                t.problem(&key, format!("the file has `{key}` in {has}"), "write a unit of the same dimension");
            }
            said.push(Coordinate::recorded(key, own, usual));
        }
        said
    };
    model.optional_table(TABLE, about, read).unwrap_or_default()
}

impl Model {
    /// Edits that say what the columns of files usually are which formulas name, where the model does not: without them it
    /// could be held against such files, but not run. Words have no usual value.
    pub(crate) fn saying_usual(&self) -> Vec<Edit> {
        let coordinates = self.process.coordinates();
        let mut named: Vec<(usize, f64)> =
            self.effects.iter().filter_map(|effect| effect.formula.as_ref()).flat_map(|law| law.recorded()).collect();
        named.sort_unstable_by_key(|(column, _)| *column);
        named.dedup_by_key(|(column, _)| *column);
        let said = named.into_iter().filter_map(|(column, usual)| {
            let Coordinate { name, holds, .. } = &coordinates[column];
            let is_said = self.raw(&format!("{TABLE}.{name}")).is_some();
            let Holds::Quantity(kind) = holds else { return None };
            (!is_said).then(|| (name.to_string(), usual_text(usual, kind)))
        });
        let said: Vec<(String, String)> = said.collect();
        if said.is_empty() {
            return Vec::new();
        }
        let keys = said.iter().map(|(name, text)| (name.as_str(), text.as_str()));
        vec![Edit::Write { path: TABLE.into(), value: Raw::of_keys(keys) }]
    }

    /// What it says of columns that files have and `before` says nothing of: `room = "21.3 degC"`.
    pub(crate) fn usual_beside(&self, before: &Self) -> Vec<String> {
        let told = |own: &Coordinate| {
            let path = format!("{TABLE}.{}", own.name);
            let now = self.raw(&path).filter(|_| before.raw(&path).is_none())?;
            Some(format!("{} = {}", own.name, now.on_one_line()))
        };
        self.recorded().iter().filter_map(told).collect()
    }
}

/// A value (SI) as a model has it: five digits, in the unit of its kind.
fn usual_text(usual: f64, kind: &Kind) -> String {
    let value = kind.from_si(usual);
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    format!("{rounded} {}", kind.unit).trim_end().to_string()
}

impl Process for Recorded {
    fn name(&self) -> &'static str {
        self.process.name()
    }

    fn about(&self) -> &'static str {
        self.process.about()
    }

    fn observables(&self) -> &[Observable] {
        self.process.observables()
    }

    fn coordinates(&self) -> &[Coordinate] {
        &self.coordinates
    }

    fn starting_model(&self) -> &'static str {
        self.process.starting_model()
    }

    fn starting_variant(&self, variant: Variant) -> Option<&'static str> {
        self.process.starting_variant(variant)
    }

    fn effects(&self) -> Vec<Description> {
        self.process.effects()
    }

    fn in_order(&self) -> Option<&'static str> {
        self.process.in_order()
    }

    fn carried_over(&self, effect: &str) -> Option<&'static str> {
        self.process.carried_over(effect)
    }

    fn of_unit(&self) -> &'static [(&'static str, UnitRole)] {
        self.process.of_unit()
    }

    fn read(&self, model: &Reader) -> Option<Box<dyn System>> {
        self.process.read(model)
    }
}
