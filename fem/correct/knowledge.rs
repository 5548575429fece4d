//! What is known of the values of a model, and draws from that.

use crate::budget::{Law, Stream};
use crate::input::Bounds;
use crate::model::Model;
use crate::units;

/// Seed of the draws: the same model has the same answer.
const SEED: u64 = 1;
/// Half-field of a normal law in standard deviations.
const FIELD: f64 = 3.0;

/// The values of a model with their uncertainties.
pub struct Knowledge {
    /// The values, SI, in the order of the model's parameters.
    pub values: Vec<f64>,
    /// Standard uncertainties, SI.
    pub deviations: Vec<f64>,
    /// Whether each is a positive quantity, whose logarithm is spread.
    is_positive: Vec<bool>,
}

impl Knowledge {
    /// That of a model without unknown values.
    pub fn of(model: &Model) -> Self {
        let deviation = |knowledge: units::Knowledge| match knowledge {
            units::Knowledge::Rough(deviation) => deviation,
            units::Knowledge::Known | units::Knowledge::Free => 0.0,
        };
        Self {
            values: model.parameters.iter().map(|own| own.quantity.value).collect(),
            deviations: model.parameters.iter().map(|own| deviation(own.quantity.knowledge)).collect(),
            is_positive: model.parameters.iter().map(|own| own.bounds == Bounds::Positive).collect(),
        }
    }

    /// Whether every value is known.
    pub fn is_certain(&self) -> bool {
        self.deviations.iter().all(|deviation| *deviation == 0.0)
    }

    /// Values as they may be: draw of a number, always the same.
    pub fn drawn(&self, number: usize) -> Vec<f64> {
        let stream = Stream::new(SEED, number as u64);
        let all = self.values.iter().zip(&self.deviations).zip(&self.is_positive).zip(0..);
        all.map(|(((value, deviation), is_positive), i)| {
            let by = deviation * FIELD * Law::Normal.draw(&stream, i, 0);
            if *is_positive { value * (by / value).exp() } else { value + by }
        })
        .collect()
    }
}
