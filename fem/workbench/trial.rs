//! Values on trial: what a model would predict with them, at once. They are no estimates, and stay nowhere.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::Value as Json;

use super::bench::Compared;
use super::refusal::Refusal;
use super::session::Session;
use super::told;
use crate::compare::rms;
use crate::measure::Measurements;
use crate::model::{Data, Model};
use crate::process::Failure;

/// Values on trial with what they are tried on.
pub struct Trial {
    model: Result<Model, Failure>,
    measured: Arc<Measurements>,
    counted: Measurements,
    struck: std::collections::BTreeSet<usize>,
    compared: Option<Arc<Compared>>,
    references: Option<Arc<Vec<f64>>>,
}

impl Session {
    /// Values to be tried, by their paths, in the units in which they are written.
    ///
    /// # Errors
    /// There is no such value, it is beyond what may be, or nothing was measured.
    pub fn on_trial(&self, values: &BTreeMap<String, f64>) -> Result<Trial, Refusal> {
        let model = self.model()?;
        let (Some(measured), Some(counted)) = (self.now.measured.clone(), self.now.counted()) else {
            return Err(Refusal::new("nothing was measured", "open a file of measurements"));
        };
        let si = |(path, value): (&String, &f64)| {
            let own = model.quantity(path);
            let own =
                own.ok_or_else(|| Refusal::new(format!("the model has no `{path}`"), "name one of its values"))?;
            let (unit, symbol) = told::unit_of(model, own);
            let si = value * unit.factor + unit.offset;
            match own.bounds.admits(si) && si.is_finite() {
                true => Ok((&*own.path, si)),
                false => Err(Refusal::new(format!("{value} {symbol} is beyond what may be"), "go back").at(path)),
            }
        };
        let values = values.iter().map(si).collect::<Result<Vec<(&str, f64)>, Refusal>>()?;
        Ok(Trial {
            model: model.with_values(&values),
            measured,
            counted,
            struck: self.now.struck.clone(),
            compared: self.now.compared.clone().and_then(Result::ok),
            // Those of what is measured: another set diameter is an error of the prediction.
            references: self.now.references.clone(),
        })
    }
}

impl Trial {
    /// What the model predicts with them of the rows that count, and what is left, on the scale of the comparison.
    ///
    /// # Errors
    /// They make no model.
    pub fn predict(self) -> Result<Json, Refusal> {
        let model = self.model?;
        model.require_values()?;
        let data = Data::of(&model, self.counted)?;
        let predicted = model.forward().observe(&data.rows)?;
        let before = self.compared.as_ref().map(|found| &found.predicted);
        let moves = before.is_none_or(|before| *before != predicted);
        // The noise is that by which the model is judged as it stands.
        let left = self.compared.map(|found| rms(&data.together(&data.residuals(&predicted), &found.sigma)));
        let left = left.map(|left| data.kind().from_si(left));
        let references = self.references.as_ref().map(|all| all.as_slice());
        Ok(told::trial((&self.measured, &self.struck), (&predicted, references), (left, moves)))
    }
}
