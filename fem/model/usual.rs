//! What recorded columns usually are, which a model says that was written of a search: a run has no rows to take them from.

use super::recorded::TABLE;
use super::{Edit, Model};
use crate::input::Raw;
use crate::process::{Coordinate, Holds};
use crate::units::Kind;

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
