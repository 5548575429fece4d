//! Values on trial: what somebody wrote as if it were known is a suspect as an effect is. A value that is held to be true
//! finds causes that defend it.

use crate::input::Parameter;
use crate::model::Model;
use crate::process::{Belongs, Description, ON_TRIAL, Odds};
use crate::units::Knowledge;

/// Factor by which a value that nobody measured is usually off, at most.
const FACTOR: f64 = 3.0;
/// Odds against one that such a value is wrong by so much that it shows.
const ODDS: Odds = Odds::of(0.3, "templates and tables of others write values that nobody measured here");

/// The values of a model's effects that stand as if they were known, each as an effect that moves it away from what is
/// written. Tests of one machine say theirs together.
pub fn values_on_trial(model: &Model) -> Vec<Description> {
    if model.campaign().is_some() {
        return Vec::new();
    }
    let is_known = |quantity: &&Parameter| {
        let value = quantity.quantity.value;
        quantity.quantity.knowledge == Knowledge::Known && value.is_finite() && value != 0.0
    };
    model.quantities.iter().filter(is_known).filter_map(|quantity| value_on_trial(model, quantity)).collect()
}

/// A value of an effect of the catalogue on trial.
fn value_on_trial(model: &Model, quantity: &Parameter) -> Option<Description> {
    // A part and a phase have no ratio to another.
    let entry = model.catalogue(&quantity.path).filter(|entry| !entry.is_step && entry.period.is_none())?;
    Some(Description {
        table: ON_TRIAL,
        name: quantity.path.to_string().into(),
        observable: None,
        about: "the value that the model has is wrong".into(),
        law: "as the law has it, with another value".into(),
        source: "",
        belongs: Belongs::Test,
        odds: ODDS,
        parameters: vec![entry.on_trial(quantity.kind.from_si(quantity.quantity.value), FACTOR)].into(),
        look_alikes: &[],
        changes: None,
    })
}
