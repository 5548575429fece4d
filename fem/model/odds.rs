//! The table `[odds]`: how likely an effect was before anything was measured, by those who know their machine better than the
//! catalogue does.

use std::collections::BTreeMap;

use crate::input::{Bounds, Name, Reader};
use crate::noise::effects;
use crate::process::{Description, ON_TRIAL, Odds, Process};
use crate::units::NUMBER;

/// Key of the odds of every value that is written as known.
pub const VALUES: &str = "values";
/// Odds that are as good as certainty, for or against. Beyond them nothing could be learnt from data.
const LIMITS: (f64, f64) = (1e-6, 1e6);
/// Why odds are what they are that the model says.
const BECAUSE: &str = "the model says so";

/// Odds against one that a model gives, by the names of effects, and of values that it has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OwnOdds(BTreeMap<Name, f64>);

impl OwnOdds {
    /// Reads the table, which may hold any effect of the process, a scale or a clock, and all values together.
    pub fn read(model: &Reader, process: &dyn Process) -> Self {
        let about = "odds to one of effects before anything is measured, where you know better than the catalogue";
        let read = |t: &Reader| {
            let of_machine = process.effects().into_iter().map(|effect| effect.name);
            let readings =
                effects::all().filter(|effect| effect.acts.is_reading()).map(|effect| Name::new(effect.name));
            let names = of_machine.chain(readings).chain([Name::new(VALUES)]);
            let own = |name: Name| {
                let about =
                    if name == VALUES { "that a value which is written as known is wrong" } else { "of this effect" };
                let field = t.quantity(name.clone(), NUMBER, about).chosen();
                let odds = field.bounds(Bounds::Within(LIMITS.0, LIMITS.1)).optional()?;
                Some((name, odds))
            };
            Self(names.filter_map(own).collect())
        };
        model.optional_table("odds", about, read).unwrap_or_default()
    }

    /// Odds of these names.
    pub fn new(all: BTreeMap<Name, f64>) -> Self {
        Self(all)
    }

    /// Odds of a name.
    pub fn of(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }

    /// The effect with the odds that the model gives it.
    pub fn put_on(&self, effect: Description) -> Description {
        let name = if effect.table == ON_TRIAL { VALUES } else { &*effect.name };
        match self.of(name) {
            Some(odds) => Description { odds: Odds::of(odds, BECAUSE), ..effect },
            None => effect,
        }
    }

    /// Names with their odds, in alphabetical order.
    pub fn iter(&self) -> impl Iterator<Item = (&Name, f64)> {
        self.0.iter().map(|(name, odds)| (name, *odds))
    }
}
