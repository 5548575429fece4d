//! Contributions of models to a budget: figures of their predictions, and the inputs that are not exactly
//! known.

use super::{Kind, Law, Stream};
use crate::input::Bounds;
use crate::model::Model;
use crate::process::{Failure, Rows};

mod inputs;
mod read;

pub(super) use read::read;

/// Most repetitions of a draw that falls where there is no model.
const ATTEMPTS: u32 = 1000;

/// Figure of a model's prediction.
pub struct ModelPart {
    /// Name of its share.
    pub name: String,
    /// The model.
    pub model: Model,
    /// Way in which the figure adds: a systematic one as it is, a random one as the half of a field.
    pub kind: Kind,
    /// Law of a random one.
    pub law: Law,
    /// Factor of the figure.
    pub factor: f64,
    /// The effect whose change alone is the figure, if it is not the whole prediction.
    pub effect: Option<String>,
    /// Rows at which the model is observed.
    pub rows: Rows,
    /// Reduction of the observed rows to one number.
    pub figure: Figure,
}

/// Reduction of observed rows to one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// The first, less the second where there is one.
    Difference,
    /// The largest less the smallest: an error of form.
    Spread,
}

impl Figure {
    /// Words in a budget file.
    pub const WORDS: &[(&'static str, Self)] = &[("value", Self::Difference), ("spread", Self::Spread)];
}

/// Input of models that is not exactly known, or varies from part to part. SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Name in the files.
    pub name: String,
    /// Models, by their positions, and the parameter or coordinate of each for which it stands.
    pub targets: Vec<(usize, Target)>,
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

/// Changes of the result by an input of models at the two ends of its field.
pub(super) type Swing = (String, Law, (f64, f64));

/// The models of a budget, with what varies in them.
#[derive(Default)]
pub struct Models {
    /// In the order of the file.
    pub parts: Vec<ModelPart>,
    /// Inputs that vary; one that several models share varies in all of them at once.
    pub inputs: Vec<Input>,
}

impl Input {
    /// Draws a value; returns it with the number of draws that fell outside before.
    pub fn draw(&self, stream: &Stream, dimension: u32) -> Option<(f64, u32)> {
        let at = |attempt| self.centre + self.half * self.law.draw(stream, dimension, attempt);
        (0..ATTEMPTS).map(|attempt| (at(attempt), attempt)).find(|(value, _)| self.bounds.admits(*value))
    }
}

impl ModelPart {
    /// Computes the figure with values (SI) of parameters and coordinates, m.
    fn result(&self, values: &[(Target, f64)]) -> Result<f64, Failure> {
        let mut parameters: Vec<f64> = self.model.parameters.iter().map(|p| p.quantity.value).collect();
        let mut rows = self.rows.clone();
        for (target, value) in values {
            match target {
                Target::Parameter(i) => parameters[*i] = *value,
                Target::Coordinate(column) => rows.columns[*column].fill(*value),
            }
        }
        let mut observed = self.model.forward_at(&parameters)?.observe(&rows)?;
        if let Some(effect) = &self.effect {
            let without = self.model.forward_without(&parameters, effect)?.observe(&rows)?;
            observed.iter_mut().zip(without).for_each(|(with, without)| *with -= without);
        }
        let figure = match self.figure {
            Figure::Difference => observed[0] - observed.get(1).copied().unwrap_or(0.0),
            Figure::Spread => {
                let end = |choose: fn(f64, f64) -> f64| observed.iter().copied().fold(f64::NAN, choose);
                end(f64::max) - end(f64::min)
            }
        };
        Ok(self.factor * figure)
    }

    /// Whether its sign is known too.
    pub fn has_sign(&self) -> bool {
        self.figure == Figure::Difference
    }
}

impl Models {
    /// Computes every figure with the inputs at these values, m.
    ///
    /// # Errors
    /// A model cannot be computed there; the error says where.
    pub fn results(&self, values: &[f64]) -> Result<Vec<f64>, Failure> {
        let result = |(number, part): (usize, &ModelPart)| {
            let own = |(input, value): (&Input, &f64)| {
                input.targets.iter().find(|(model, _)| *model == number).map(|(_, target)| (*target, *value))
            };
            let own: Vec<(Target, f64)> = self.inputs.iter().zip(values).filter_map(own).collect();
            match part.result(&own) {
                Ok(value) if value.is_finite() => Ok(value),
                Ok(_) => Err(self.failure(part, values, "the prediction is no number")),
                Err(failure) => Err(self.failure(part, values, &failure.message)),
            }
        };
        self.parts.iter().enumerate().map(result).collect()
    }

    fn failure(&self, part: &ModelPart, values: &[f64], message: &str) -> Failure {
        let at: Vec<String> =
            self.inputs.iter().zip(values).map(|(input, value)| format!("{} = {value:.6e}", input.name)).collect();
        Failure {
            message: format!("{} gives no answer at {} (SI): {message}", part.model.source.name, at.join(", ")),
            help: "narrow the fields of its inputs, or take laws that end".into(),
        }
    }

    /// Computes every figure in the middle of the fields, and the changes of the sum of the systematic ones, with
    /// the given signs, by each input alone at the ends of its field; an end where there is no model is
    /// extrapolated from one standard deviation.
    pub(super) fn swings(&self, nominal: &[f64], signs: &[f64]) -> Result<Vec<Swing>, Failure> {
        let centre = self.centre();
        let sum = |figures: &[f64]| -> f64 {
            let systematic = self.parts.iter().zip(figures).zip(signs).filter(|((p, _), _)| p.kind == Kind::Systematic);
            systematic.map(|((_, figure), sign)| sign * figure).sum()
        };
        let middle = sum(nominal);
        let change = |i: usize, by: f64| {
            let mut moved = centre.clone();
            moved[i] += by;
            self.inputs[i].bounds.admits(moved[i]).then(|| self.results(&moved).map(|figures| sum(&figures) - middle))
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
                let message = format!("the field of {} has no model at either end", input.name);
                let first = input.targets.first().map_or(0, |t| t.0);
                return Err(self.failure(&self.parts[first], &centre, &message));
            }
            swings.push((input.name.clone(), input.law, (low, high)));
        }
        Ok(swings)
    }

    /// Inputs in the middle of their fields.
    pub fn centre(&self) -> Vec<f64> {
        self.inputs.iter().map(|i| i.centre).collect()
    }
}
