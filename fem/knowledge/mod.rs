//! What is known of the values of a model, draws from that, and how far they take a prediction to be off.

mod band;

pub use band::{Band, Probability};

use nalgebra::{DMatrix, DVector};

use crate::budget::{Law, Stream};
use crate::model::{Model, Spread};
use crate::noise::MEASUREMENT;
use crate::units::Kind;

/// Seed of the draws: the same model has the same answer.
const SEED: u64 = 1;
/// Half-field of a normal law in standard deviations.
const FIELD: f64 = 3.0;

/// Says of a model that it failed against its measurements, where something stays unexplained (SI, told in `kind`).
pub fn failed(unexplained: f64, kind: &Kind) -> Option<String> {
    let left = kind.shown(unexplained);
    let told = || format!("failed against the measurements that it was fitted to: {left:.2} stay unexplained");
    (unexplained > 0.0).then(told)
}

/// The values of a model with their uncertainties.
pub struct Knowledge {
    /// The values, SI, in the order of the model's parameters.
    pub values: Vec<f64>,
    /// Standard uncertainties, SI.
    deviations: Vec<f64>,
    /// What makes of independent numbers such that are correlated as the values are.
    root: DMatrix<f64>,
    /// In which terms each is spread.
    spreads: Vec<Spread>,
    /// What stays unexplained of the measurements that the values were fitted to, SI.
    unexplained: f64,
    /// Other sets of effects that explain these measurements as well.
    others: usize,
}

impl Knowledge {
    /// That of a model without unknown values.
    pub fn of(model: &Model) -> Self {
        let mut deviations = model.together.deviations(&model.parameters);
        // What an instrument shows is no part of what is made.
        let of_instruments = |path: &str| path.strip_prefix(MEASUREMENT).is_some_and(|rest| rest.starts_with('.'));
        let all = model.parameters.iter().zip(&mut deviations);
        all.filter(|(own, _)| of_instruments(&own.path)).for_each(|(_, deviation)| *deviation = 0.0);
        Self {
            values: model.parameters.iter().map(|own| own.quantity.value).collect(),
            deviations,
            root: model.together.root(&model.parameters),
            spreads: model.together.spreads(&model.parameters),
            unexplained: model.together.unexplained(),
            others: model.together.instead().len(),
        }
    }

    /// How many values are not exactly known.
    pub fn uncertain(&self) -> usize {
        self.deviations.iter().filter(|deviation| **deviation > 0.0).count()
    }

    /// Whether nothing of a prediction is open.
    pub fn is_exact(&self) -> bool {
        self.uncertain() == 0 && self.unexplained == 0.0 && self.others == 0
    }

    /// Whether each value is known roughly.
    pub fn are_rough(&self) -> impl Iterator<Item = bool> {
        self.deviations.iter().map(|deviation| *deviation > 0.0)
    }

    /// Covariance of the values in their standard uncertainties: their correlations.
    pub fn correlation(&self) -> DMatrix<f64> {
        &self.root * self.root.transpose()
    }

    /// The values so many of their standard uncertainties away from what is known best.
    pub fn away<'a>(&self, by: impl IntoIterator<Item = &'a f64>) -> Vec<f64> {
        let all = self.values.iter().zip(&self.deviations).zip(&self.spreads).zip(by);
        all.map(|(((value, deviation), spread), away)| spread.away(*value, deviation * away)).collect()
    }

    /// Values as they may be: draw of a number, always the same.
    pub fn drawn(&self, number: usize) -> Vec<f64> {
        self.away(&(&self.root * self.independent(number)))
    }

    /// What that draw is made of: how far it lies in each of the directions in which the values are independent of each other, in
    /// standard deviations.
    pub fn independent(&self, number: usize) -> DVector<f64> {
        let stream = Stream::new(SEED, number as u64);
        let all = (0..self.values.len()).map(|i| FIELD * Law::Normal.draw(&stream, i as u32, 0));
        DVector::from_iterator(self.values.len(), all)
    }

    /// Each of these directions by its number; not those in which the values are known.
    pub fn ways(&self) -> impl Iterator<Item = usize> {
        (0..self.values.len()).filter(|way| self.both_ways(*way, 1.0)[0] != self.values)
    }

    /// The values so many standard deviations away in a direction, to both sides.
    pub fn both_ways(&self, way: usize, by: f64) -> [Vec<f64>; 2] {
        [by, -by].map(|by| self.away((by * self.root.column(way)).iter()))
    }
}
