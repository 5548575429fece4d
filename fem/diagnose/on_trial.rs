//! Values on trial: what somebody wrote as if it were known is a suspect as an effect is. A value that is held to be true
//! finds causes that defend it.

use crate::input::{Grows, Parameter};
use crate::model::Model;
use crate::process::{self, Belongs, Description, ON_TRIAL, Odds};
use crate::units::Knowledge;

/// Factor by which a value of an effect that nobody measured is usually off, at most.
const FACTOR: f64 = 3.0;
/// Odds against one that such a value is wrong by so much that it shows.
const ODDS: Odds = Odds::of(0.3, "templates and tables of others write values that nobody measured here");

/// The values of a model that stand as if they were known, each as an effect that moves it away from what is
/// written: those of its effects, and of the other tables what people estimate
/// ([`process::estimates`]). Of tests of one machine those that they draw alike; the others they say together.
pub fn values_on_trial(model: &Model) -> Vec<Description> {
    let is_known =
        |quantity: &&Parameter| quantity.quantity.knowledge == Knowledge::Known && quantity.quantity.value.is_finite();
    model.quantities.iter().filter(is_known).filter_map(|quantity| value_on_trial(model, quantity)).collect()
}

/// A value on trial, if it is one that may be wrong.
fn value_on_trial(model: &Model, quantity: &Parameter) -> Option<Description> {
    let (odds, parameter) = match model.catalogue(&quantity.path) {
        Some(entry) => (ODDS, of_effect(entry, quantity)?),
        None => of_table(quantity)?,
    };
    Some(Description {
        table: ON_TRIAL,
        name: quantity.path.to_string().into(),
        observable: None,
        about: "the value that the model has is wrong".into(),
        law: "as the law has it, with another value".into(),
        source: "",
        belongs: Belongs::Test,
        odds,
        parameters: vec![parameter].into(),
        look_alikes: &[],
        changes: None,
    })
}

/// A value of an effect of the catalogue.
fn of_effect(entry: &process::Parameter, quantity: &Parameter) -> Option<process::Parameter> {
    let value = quantity.quantity.value;
    // A part and a phase have no ratio to another, nor has nothing.
    let has_ratio = !entry.is_step && entry.period.is_none() && value != 0.0;
    has_ratio.then(|| entry.on_trial(quantity.kind.from_si(value), FACTOR))
}

/// A quantity of another table that people estimate.
fn of_table(quantity: &Parameter) -> Option<(Odds, process::Parameter)> {
    let doubt = quantity.doubt?;
    let value = quantity.quantity.value;
    let name = quantity.path.key().to_string().into();
    let parameter = || process::Parameter::doubted(name, (quantity.kind, quantity.bounds), value, doubt);
    (value != 0.0 || doubt.grows == Grows::Evenly).then(|| (Odds::of(doubt.odds, doubt.because), parameter()))
}
