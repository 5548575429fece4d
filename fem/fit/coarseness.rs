//! By how much the usual sizes of effects move with a machine that is coarser or finer than most.

use std::sync::Arc;

use crate::noise::MEASUREMENT;
use crate::process::{Description, Neutral, Parameter};
use crate::units::{
    ANGLE_SLOPE, CONTACT_COEFFICIENT, FORCE, JAW_MOMENT, Kind, MICRO, POWER, ROTATIONAL_STIFFNESS, SLOPE, SMALL_ANGLE,
    STEEP_SLOPE, STIFFNESS, TEMPERATURE_RISE, TORQUE, TORSIONAL_STIFFNESS, TWIST, WEAR_PER_PART, WEAR_RATE,
};

/// Kinds of sizes that grow together where a machine is coarser. What places, angles of place, times, ratios and heat transfer are
/// does not: a clamp that stands a hundred times as far away stands beside the part.
const TOGETHER: &[&[Kind]] = &[
    &[MICRO, SLOPE, STEEP_SLOPE, TWIST, WEAR_RATE, WEAR_PER_PART, SMALL_ANGLE, ANGLE_SLOPE],
    &[STIFFNESS, ROTATIONAL_STIFFNESS, TORSIONAL_STIFFNESS],
    &[CONTACT_COEFFICIENT],
    &[FORCE, JAW_MOMENT, TORQUE],
    &[POWER, TEMPERATURE_RISE],
];

/// Factor on the usual size of the effects of each sort; one of the sorts beyond the end.
#[derive(Clone, Debug, Default)]
pub struct Coarseness {
    factors: Arc<[f64]>,
}

impl Coarseness {
    /// That of each sort by what the logarithms of its sizes are beyond the usual.
    pub fn of(beyond: impl Fn(usize) -> f64) -> Self {
        Self { factors: (0..TOGETHER.len()).map(|sort| beyond(sort).exp()).collect() }
    }

    /// Number of the sort of a parameter, if it is a size that grows with the machine.
    pub fn sort(effect: &Description, entry: &Parameter) -> Option<usize> {
        let is_size = matches!(entry.neutral, Neutral::Value(0.0) | Neutral::Infinity) && effect.table != MEASUREMENT;
        TOGETHER.iter().position(|kinds| is_size && kinds.contains(&entry.kind))
    }

    /// The parameter of an effect, with what is plausible in this machine.
    pub fn plausible(&self, effect: &Description, entry: &Parameter) -> Parameter {
        let own = Self::sort(effect, entry).and_then(|sort| self.factors.get(sort));
        let factor = own.map_or(1.0, |factor| if entry.neutral == Neutral::Infinity { 1.0 / factor } else { *factor });
        Parameter { range: (factor * entry.range.0, factor * entry.range.1), ..entry.clone() }
    }
}
