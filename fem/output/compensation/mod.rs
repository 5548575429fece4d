//! A compensation: for people, for programs, and for controllers.

mod control;
mod controller;
mod json;
mod text;

pub use control::{ALL as CONTROLS, Control, LINUXCNC, Supplied, supplied};

use serde_json::Value;

use super::answer::Answer;
use super::block::Block;
use super::json::json as document;
use super::staged::Staged;
use super::{OutputError, csv};
use crate::compensate::Compensation;
use crate::model::Data;

/// The compensation of an axis by its test and its model, with files for controls (none: `&[]`).
pub struct CompensationAnswer<'a>(pub &'a Data<'a>, pub &'a Compensation, pub &'a [Supplied]);

impl Answer for CompensationAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        vec![Block::Lines(text::text(self.0, self.1, self.2))]
    }

    fn json(&self) -> Value {
        json::json(self.0, self.1, self.2)
    }

    /// The tables in general form and what is left along the travel, and the files for controls; what is entered only
    /// where the controller had something already, and increments only where it is told at which points.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        let Self(_, found, supplied) = *self;
        let [points, segments, both] = &found.schemes;
        let measures = found.measures;
        if found.active.is_some() {
            files.text("entered.csv", &csv::table(&controller::points(&points.entered, measures)))?;
        }
        if let Some(steps) = found.steps {
            files.text("increments.csv", &csv::table(&controller::increments(&points.entered, steps, measures)))?;
        }
        files.text("points.csv", &csv::table(&controller::points(&points.table, measures)))?;
        files.text("segments.csv", &csv::table(&controller::segments(&segments.table, measures)))?;
        files.text("both-directions.csv", &csv::table(&controller::both_directions(&both.table, measures)))?;
        for (name, text) in supplied.iter().flat_map(|s| &s.files) {
            files.text(*name, text)?;
        }
        files.text("predicted.csv", &csv::table(&controller::predicted(found)))?;
        files.text("compensation.json", &document(self))
    }
}
