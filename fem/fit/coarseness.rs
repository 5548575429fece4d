//! By how much the usual sizes of effects move with a machine that is coarser or finer than most.

use std::sync::Arc;

use crate::input::Bounds;
use crate::noise::MEASUREMENT;
use crate::process::{Description, Neutral, Parameter};
use crate::units::Kind;

/// Factor on the usual size of the effects of each kind; one of kinds that it does not name.
#[derive(Clone, Debug, Default)]
pub struct Coarseness {
    factors: Arc<[(Kind, f64)]>,
}

impl Coarseness {
    /// Of these factors.
    pub fn of(factors: Vec<(Kind, f64)>) -> Self {
        Self { factors: factors.into() }
    }

    /// Whether a parameter is a size that moves with the machine: no ratio, no place, and nothing of the instrument.
    pub fn moves(effect: &Description, entry: &Parameter) -> bool {
        let is_size = match entry.neutral {
            Neutral::Value(value) => value == 0.0 && entry.range.1 > 0.0,
            Neutral::Infinity => true,
            Neutral::Shape | Neutral::Written(..) => false,
        };
        is_size && effect.table != MEASUREMENT && !entry.kind.unit.is_empty() && !matches!(entry.bounds, Bounds::Within(..))
    }

    /// The parameter of an effect, with what is plausible in this machine.
    pub fn plausible(&self, effect: &Description, entry: &Parameter) -> Parameter {
        let own = self.factors.iter().find(|(kind, _)| *kind == entry.kind && Self::moves(effect, entry));
        let Some((_, factor)) = own else { return entry.clone() };
        let factor = if entry.neutral == Neutral::Infinity { 1.0 / factor } else { *factor };
        Parameter { range: (factor * entry.range.0, factor * entry.range.1), ..entry.clone() }
    }
}
