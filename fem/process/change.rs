//! An effect whose values changed between two parts, runs or set-ups: a screw that came loose, a spring that was
//! preloaded anew, a reference that was homed anew.
//!
//! Rows up to a border are of a machine with the values that the effect has, rows beyond it of one with others. That
//! holds of effects without memory. What the machine carries over from row to row, as warmth and wear, does not begin
//! anew at a border, and a process tells of which effects that is so ([`Definition::CARRIED_OVER`]).
//!
//! [`Definition::CARRIED_OVER`]: super::Definition::CARRIED_OVER

use super::{Active, Belongs, Description, Neutral, Odds, Parameter};
use crate::input::{Bounds, Name};

/// Table within that of an effect: `[effects.NAME.changed]`.
pub const CHANGED: &str = "changed";

/// Key of the number after which values are others.
const AFTER: &str = "after";

/// Odds that one effect changed within a series.
const ODDS: Odds = Odds::of(0.05, "machines mostly stay as they are while they are measured");

/// The change of an effect in rows that a coordinate numbers: `after`, and those of its parameters that are `chosen`.
pub fn change_of(effect: &Description, along: &'static str, chosen: impl Fn(&Parameter) -> bool) -> Description {
    let about = "number after which the values are others";
    let after = Parameter::after(AFTER, about, along, (1.0, 50.0)).within(Bounds::NotNegative);
    let values = effect.parameters.iter().filter(|p| !p.is_step && chosen(p));
    let value = |p: &Parameter| Parameter { default: None, needed_with: None, ..p.clone() };
    Description {
        name: name_of_change(&effect.name),
        observable: None,
        about: format!("{} is another one after a certain {along}", effect.name).into(),
        law: format!("as {}, with these values where {along} > after", effect.name).into(),
        source: "a step (intervention): Box & Tiao, J. Am. Stat. Assoc. 70, 1975",
        belongs: Belongs::Test,
        odds: ODDS,
        parameters: std::iter::once(after).chain(values.map(value)).collect(),
        look_alikes: &[],
        changes: Some(effect.name.clone()),
        ..effect.clone()
    }
}

/// Whether a change of this parameter is sought where nobody wrote it down: it says how much there is of an effect.
pub fn is_size(parameter: &Parameter) -> bool {
    parameter.neutral != Neutral::Shape
}

/// Name of the change of an effect: that of its table within `[effects]`.
pub fn name_of_change(effect: &str) -> Name {
    format!("{effect}.{CHANGED}").into()
}

impl Description {
    /// Whether it is the change of the effect of this name.
    pub fn is_change_of(&self, effect: &str) -> bool {
        self.changes.as_ref().is_some_and(|own| *own == *effect)
    }
}

impl Active {
    /// The number after which it changes another effect; `None` where it is no change.
    pub(super) fn border(&self) -> Option<f64> {
        self.description.changes.as_ref()?;
        let after = self.description.parameters.iter().position(|p| p.is_step)?;
        self.values.get(after).map(|value| value.round())
    }

    /// The effect with the values that a change of it gives; as it is where the change is of another effect.
    #[must_use]
    pub(super) fn changed_by(&self, change: &Self) -> Self {
        let mut changed = self.clone();
        if !change.description.is_change_of(&self.description.name) {
            return changed;
        }
        for (value, parameter) in changed.values.iter_mut().zip(&*self.description.parameters) {
            let place = change.description.parameters.iter().position(|p| p.name == parameter.name);
            if let Some(new) = place.and_then(|place| change.values.get(place)) {
                *value = *new;
            }
        }
        changed
    }
}
