//! Contribution of a model to a budget: one figure of its prediction, and the inputs that are not exactly
//! known.

use super::estimate::Swing;
use super::{Law, Stream};
use crate::input::Bounds;
use crate::model::Model;
use crate::process::{Failure, Rows};

mod read;

pub(super) use read::read;

/// Most repetitions of a draw that falls where there is no model.
const ATTEMPTS: u32 = 1000;

/// Figure of a model's prediction, with inputs that vary.
pub struct ModelPart {
    /// The model.
    pub model: Model,
    /// Row that is observed, and, where a difference is asked, the row that is subtracted.
    pub rows: Rows,
    /// Inputs that vary.
    pub inputs: Vec<Input>,
}

/// Input that is not exactly known, or varies from part to part. SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Name in the files.
    pub name: String,
    /// Parameter or coordinate that it stands for.
    pub target: Target,
    /// Middle of its field.
    pub centre: f64,
    /// Half of its field.
    pub half: f64,
    /// Distribution over its field.
    pub law: Law,
    /// Bounds within which it may lie.
    pub bounds: Bounds,
}

/// Quantity that an input stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A quantity that the model marks `+-`, by its position.
    Parameter(usize),
    /// A coordinate of the observed rows, by its position.
    Coordinate(usize),
}

impl Input {
    fn admits(&self, value: f64) -> bool {
        match self.bounds {
            Bounds::Any => true,
            Bounds::Positive => value > 0.0,
            Bounds::NotNegative => value >= 0.0,
            Bounds::Within(low, high) => value > low && value <= high,
        }
    }

    /// Draws a value; returns it with the number of draws that fell outside before.
    pub fn draw(&self, stream: &Stream, dimension: u32) -> Option<(f64, u32)> {
        let at = |attempt| self.centre + self.half * self.law.draw(stream, dimension, attempt);
        (0..ATTEMPTS).map(|attempt| (at(attempt), attempt)).find(|(value, _)| self.admits(*value))
    }
}

impl ModelPart {
    /// Computes the figure with inputs at these values, m.
    ///
    /// # Errors
    /// The model cannot be computed there; the error says where.
    pub fn result(&self, values: &[f64]) -> Result<f64, Failure> {
        let mut parameters: Vec<f64> = self.model.parameters.iter().map(|p| p.quantity.value).collect();
        let mut rows = self.rows.clone();
        for (input, value) in self.inputs.iter().zip(values) {
            match input.target {
                Target::Parameter(i) => parameters[i] = *value,
                Target::Coordinate(column) => rows.columns[column].fill(*value),
            }
        }
        let observed = self.model.forward_at(&parameters).and_then(|job| job.observe(&rows));
        let result = observed.map(|o| o[0] - o.get(1).copied().unwrap_or(0.0));
        match result {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => Err(self.failure(values, "the prediction is no number")),
            Err(failure) => Err(self.failure(values, &failure.message)),
        }
    }

    fn failure(&self, values: &[f64], message: &str) -> Failure {
        let at: Vec<String> =
            self.inputs.iter().zip(values).map(|(input, value)| format!("{} = {value:.6e}", input.name)).collect();
        Failure {
            message: format!("{} gives no answer at {} (SI): {message}", self.model.source.name, at.join(", ")),
            help: "narrow the fields of its inputs, or take laws that end".into(),
        }
    }

    /// Inputs in the middle of their fields.
    pub fn centre(&self) -> Vec<f64> {
        self.inputs.iter().map(|i| i.centre).collect()
    }

    /// Computes the figure in the middle of the fields, and its changes by each input alone at the ends of
    /// its field; an end where there is no model is extrapolated from one standard deviation.
    pub(super) fn linearised(&self) -> Result<(f64, Vec<Swing>), Failure> {
        let centre = self.centre();
        let nominal = self.result(&centre)?;
        let change = |i: usize, by: f64| {
            let mut moved = centre.clone();
            moved[i] += by;
            self.inputs[i].admits(moved[i]).then(|| self.result(&moved).map(|r| r - nominal))
        };
        let mut swings = Vec::new();
        for (i, input) in self.inputs.iter().enumerate() {
            let std = input.half * input.law.lambda().sqrt();
            let end = |sign: f64| match change(i, sign * input.half) {
                Some(change) => change,
                None => match change(i, sign * std) {
                    Some(change) => change.map(|c| c * input.half / std),
                    None => Ok(f64::NAN),
                },
            };
            let (low, high) = (end(-1.0)?, end(1.0)?);
            // Where one side has no model, the other stands for both.
            let low = if low.is_nan() { -high } else { low };
            let high = if high.is_nan() { -low } else { high };
            if low.is_nan() {
                return Err(self.failure(&centre, &format!("the field of {} has no model at either end", input.name)));
            }
            swings.push((input.name.clone(), input.law, (low, high)));
        }
        Ok((nominal, swings))
    }
}
