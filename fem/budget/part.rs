//! What a model contributes to a budget: one figure of its prediction, and what of its inputs is not exactly known.

use super::estimate::Swing;
use super::{Law, Stream};
use crate::input::Bounds;
use crate::model::Model;
use crate::process::{Failure, Rows};

mod read;

pub(super) use read::read;

/// A draw that falls where there is no model is drawn again, at most so often.
const ATTEMPTS: u32 = 1000;

/// A figure of a model's prediction.
pub struct ModelPart {
    /// The model.
    pub model: Model,
    /// The row that is observed, and, where a difference is asked, the row that is taken off.
    pub rows: Rows,
    /// What varies.
    pub inputs: Vec<Input>,
}

/// An input that is not exactly known, or varies from part to part. SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// As the files call it.
    pub name: String,
    /// What it is.
    pub target: Target,
    /// Middle of its field.
    pub centre: f64,
    /// Half of its field.
    pub half: f64,
    /// How it scatters over it.
    pub law: Law,
    /// Where it may lie.
    pub bounds: Bounds,
}

/// What an input is.
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

    /// A draw, and how often it fell outside before.
    pub fn draw(&self, stream: &Stream, dimension: u32) -> Option<(f64, u32)> {
        let at = |attempt| self.centre + self.half * self.law.draw(stream, dimension, attempt);
        (0..ATTEMPTS).map(|attempt| (at(attempt), attempt)).find(|(value, _)| self.admits(*value))
    }
}

impl ModelPart {
    /// The figure with inputs at these values, m.
    ///
    /// # Errors
    /// The model cannot be computed there; says where.
    pub fn result(&self, values: &[f64]) -> Result<f64, Failure> {
        let mut parameters: Vec<f64> = self.model.parameters.iter().map(|p| p.quantity.value).collect();
        let mut rows = self.rows.clone();
        for (input, value) in self.inputs.iter().zip(values) {
            match input.target {
                Target::Parameter(i) => parameters[i] = *value,
                Target::Coordinate(column) => rows.columns[column].fill(*value),
            }
        }
        let observed = self.model.job_at(&parameters).and_then(|job| job.observe(&rows));
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

    /// The inputs in the middle of their fields.
    pub fn centre(&self) -> Vec<f64> {
        self.inputs.iter().map(|i| i.centre).collect()
    }

    /// The figure in the middle of the fields, and what each input alone changes it by at the ends of its own; an end where there is no model is
    /// taken as far on as a standard deviation reaches.
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
            // Where one side has no model the other speaks for both.
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
