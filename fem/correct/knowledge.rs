//! What is known of the values of a model, and draws from that.

use nalgebra::{DMatrix, DVector};

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
    deviations: Vec<f64>,
    /// What makes of independent numbers such that are correlated as the values are.
    root: DMatrix<f64>,
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
            root: model.together.root(&model.parameters),
            is_positive: model.parameters.iter().map(|own| own.bounds == Bounds::Positive).collect(),
        }
    }

    /// How many values are not exactly known.
    pub fn uncertain(&self) -> usize {
        self.deviations.iter().filter(|deviation| **deviation > 0.0).count()
    }

    /// Values as they may be: draw of a number, always the same.
    pub fn drawn(&self, number: usize) -> Vec<f64> {
        let stream = Stream::new(SEED, number as u64);
        self.with(|i| FIELD * Law::Normal.draw(&stream, i as u32, 0))
    }

    /// The values one standard deviation away in each of the directions in which they are independent of each other; nothing
    /// of those in which they are known.
    pub fn shifted(&self) -> impl Iterator<Item = Vec<f64>> {
        let all = (0..self.values.len()).map(|own| self.with(|i| f64::from(u8::from(i == own))));
        all.filter(|shifted| *shifted != self.values)
    }

    /// The values with independent numbers of their spread, in standard deviations.
    fn with(&self, independent: impl Fn(usize) -> f64) -> Vec<f64> {
        let count = self.values.len();
        let together = &self.root * DVector::from_iterator(count, (0..count).map(independent));
        let all = self.values.iter().zip(&self.deviations).zip(&self.is_positive).zip(together.iter());
        all.map(|(((value, deviation), is_positive), drawn)| {
            let by = deviation * drawn;
            // Without the round-off of a logarithm and back.
            if *is_positive && by != 0.0 { value * (by / value).exp() } else { value + by }
        })
        .collect()
    }
}
