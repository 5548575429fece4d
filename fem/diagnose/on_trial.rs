//! Values on trial: what somebody wrote as if it were known is a suspect as an effect is. A value that is held to be true
//! finds causes that defend it.

use crate::input::Parameter;
use crate::model::Model;
use crate::process::{self, Belongs, Description, EFFECTS, ON_TRIAL, Odds};
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
    let of_effect = |quantity: &&Parameter| quantity.path.starts_with(EFFECTS);
    model.quantities.iter().filter(is_known).filter(of_effect).map(value_on_trial).collect()
}

fn value_on_trial(quantity: &Parameter) -> Description {
    let written = quantity.kind.from_si(quantity.quantity.value);
    let name = quantity.path.to_string();
    let key = quantity.path.key().to_string().into();
    Description {
        table: ON_TRIAL,
        name: name.into(),
        observable: None,
        about: "the value that the model has is wrong".into(),
        law: "as the law has it, with another value".into(),
        source: "",
        belongs: Belongs::Test,
        odds: ODDS,
        parameters: vec![process::Parameter::written(key, quantity.kind, quantity.bounds, written, FACTOR)].into(),
        look_alikes: &[],
    }
}
