//! Properties that change with the temperature of the body, by its rise over the start.

use std::sync::Arc;

use super::setup::Setup;
use crate::input::Record;
use crate::solve::conduction::{Potential, Properties};

/// What a body's heat and its growth follow.
#[derive(Clone, Debug)]
pub struct Laws {
    /// ∫ k dT, by k at the start.
    pub conductivity: Potential,
    /// ∫ c dT, by c at the start.
    pub specific_heat: Potential,
    /// ∫ α dT, by α at the start.
    pub expansion: Potential,
}

impl Laws {
    /// Those of a model.
    pub fn of(setup: &Setup) -> Self {
        let (material, over) = (&setup.material, &setup.over_temperature);
        let points =
            |record: &Record| record.points().iter().map(|[t, value]| [t - setup.start, *value]).collect::<Vec<_>>();
        let potential = |record: &Option<Arc<Record>>, value: f64| match record {
            Some(record) => Potential::of(&points(record)),
            None => Potential::constant(value),
        };
        let expansion = match (&over.expansion, over.expansion_from) {
            (Some(means), Some(from)) => Potential::of_means(&points(means), from - setup.start),
            (own, _) => potential(own, material.expansion),
        };
        Self {
            conductivity: potential(&over.conductivity, material.conductivity),
            specific_heat: potential(&over.specific_heat, material.specific_heat),
            expansion,
        }
    }

    /// What the heat follows where anything changes with the temperature.
    pub fn properties(&self, setup: &Setup) -> Option<Properties> {
        if setup.over_temperature.is_constant() {
            return None;
        }
        let spans = [&self.conductivity, &self.specific_heat, &self.expansion].map(Potential::span);
        let known = spans
            .iter()
            .fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], own| [low.max(own[0]), high.min(own[1])]);
        Some(Properties { conductivity: self.conductivity.clone(), heat_capacity: self.specific_heat.clone(), known })
    }

    /// The rise (K) by which a body that always expands as at the start would have grown as much.
    pub fn grown(&self, rise: f64) -> f64 {
        self.expansion.at(rise).0
    }
}
