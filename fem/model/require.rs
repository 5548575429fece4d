//! Parameters that must have values before a model predicts.

use super::{Model, Place};
use crate::input::{InputError, Parameter, Problem};
use crate::units::Knowledge;

impl Model {
    /// Refuses a model with parameters that are still unknown (`?`).
    ///
    /// # Errors
    /// Parameters are unknown; the error names each of them.
    pub fn require_values(&self) -> Result<(), InputError> {
        self.require(|_| true)
    }

    /// Refuses a model that cannot predict the part itself, whatever its instrument shows of it.
    ///
    /// # Errors
    /// Parameters are unknown; the error names each of them.
    pub fn require_part(&self) -> Result<(), InputError> {
        self.require(|place| !matches!(place, Place::Size(_)))
    }

    /// Paths of the parameters that are unknown.
    pub fn unknown(&self) -> Vec<String> {
        let free = self.parameters.iter().filter(|p| p.quantity.knowledge == Knowledge::Free);
        free.map(|p| p.path.to_string()).collect()
    }

    fn require(&self, is_needed: impl Fn(&Place) -> bool) -> Result<(), InputError> {
        let all = self.parameters.iter().zip(&self.places);
        let free = all.filter(|(p, place)| p.quantity.knowledge == Knowledge::Free && is_needed(place));
        let problem = |(p, _): (&Parameter, &Place)| {
            let example = p.kind.example();
            Problem::new(format!("`{}` is unknown (`?`)", p.path))
                .help(format!("give it a value such as \"{example}\", or let `fem fit` find it from measurements"))
                .at(p.span.clone())
        };
        let problems: Vec<Problem> = free.map(problem).collect();
        if problems.is_empty() { Ok(()) } else { Err(InputError::new(self.source.clone(), problems)) }
    }
}
