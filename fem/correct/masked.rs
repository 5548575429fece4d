//! What a correction only masks: the machine keeps it, and other work, other forces or the next week bring it back.

use crate::model::Model;
use crate::process::{Active, Belongs, Failure, Rows, UnitRole, range};

/// Part of the largest error below which an effect is not worth a repair.
const NOTABLE: f64 = 0.05;

/// An effect that a correction makes up for, and that only a repair takes away.
#[derive(Clone, Debug, PartialEq)]
pub struct Masked {
    /// Its name.
    pub effect: String,
    /// By how much it moves a row at most, m.
    pub largest: f64,
    /// Why, as a sentence.
    pub why: &'static str,
}

/// Those of a model that move its rows notably, which err by `before` without a correction; what moves them most first.
///
/// # Errors
/// The model cannot be computed.
pub fn masked(model: &Model, rows: &Rows, before: &[f64]) -> Result<Vec<Masked>, Failure> {
    let (low, high) = range(before.iter().copied());
    let least = NOTABLE * high.max(-low);
    let mut all = Vec::new();
    for effect in &model.effects {
        let Some(why) = why(model, effect) else { continue };
        let without = model.made_without(effect, rows)?;
        let (low, high) = range(before.iter().zip(&without).map(|(with, without)| with - without));
        let largest = high.max(-low);
        if largest > least {
            all.push(Masked { effect: effect.description.name.to_string(), largest, why });
        }
    }
    all.sort_by(|a, b| b.largest.total_cmp(&a.largest));
    Ok(all)
}

/// Why a correction does not mend an effect; `None` of what it does: force, tool, warmth and setting are of this work.
fn why(model: &Model, effect: &Active) -> Option<&'static str> {
    let is_change = model.effects.iter().any(|other| other.description.is_change_of(&effect.description.name));
    match effect.description.belongs {
        _ if is_change => Some("it came during the batch: what has changed once changes again, so find out why first"),
        Belongs::Machine => Some(
            "it is of the machine: adjusting or repairing it takes it from all work, the correction from this alone",
        ),
        Belongs::Unit(_, UnitRole::Gap) | Belongs::Tested(UnitRole::Gap) => {
            Some("it is play: where the force turns, the part falls to the other side, and no command holds it")
        }
        Belongs::Unit(_, UnitRole::Friction) | Belongs::Tested(UnitRole::Friction) => Some(
            "it is friction: where it holds depends on the way there, and another order of work brings other errors",
        ),
        _ => None,
    }
}
