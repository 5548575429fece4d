//! Columns that measurements record beside the coordinates of their process, as coordinates of a model: those of the
//! files that it is held against, and those that its table `[recorded]` names.

use super::formula_effect;
use crate::input::{Name, Reader};
use crate::process::{Coordinate, Description, Holds, Observable, Process, System, UnitRole, Variant};

/// The table that says what columns usually are.
pub const TABLE: &str = "recorded";

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
