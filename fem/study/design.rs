//! The points at which a study looks: drawn, spread evenly, on a grid, or from a table.

use super::shuffle::Shuffle;
use super::sobol::Sobol;
use crate::budget::{Law, Stream};
use crate::input::{Bounds, ParameterId};
use crate::units::Kind;

/// Significant digits with which a value is written and computed.
const DIGITS: usize = 14;

/// A quantity of the model that varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Path of its key in the model file.
    pub path: ParameterId,
    /// Kind, in whose unit its values are told.
    pub kind: Kind,
    /// Bounds within which it may lie, SI.
    pub bounds: Bounds,
    /// Values that it takes.
    pub spread: Spread,
}

/// Values of a quantity that varies.
#[derive(Clone, Debug, PartialEq)]
pub enum Spread {
    /// Distributed over a field, cut off at the bounds. SI.
    Field {
        /// Distribution.
        law: Law,
        /// Middle of the field.
        centre: f64,
        /// Half of the field.
        half: f64,
    },
    /// Any of a list, each as often. SI.
    List(Vec<f64>),
    /// As a table says.
    Table,
}

/// Way in which points are chosen.
#[derive(Clone, Debug, PartialEq)]
pub enum Design {
    /// From the laws of the inputs.
    Drawn {
        /// How.
        sampler: Sampler,
        /// Number of points; with indices, of pairs of points.
        samples: u64,
        /// Seed of the random numbers.
        seed: u64,
        /// Whether Sobol' indices are asked for.
        indices: bool,
    },
    /// All combinations of the listed values; the last input changes from point to point.
    Grid,
    /// Rows of a table.
    Table {
        /// Values of the inputs, row by row, as they are told.
        values: Vec<f64>,
        /// Number of rows.
        rows: u64,
    },
}

/// Way of drawing from the cube of probabilities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampler {
    /// Independent points.
    Random,
    /// One point in each of as many strata of every input.
    LatinHypercube,
    /// A Sobol' sequence with a random digital shift.
    Sobol,
}

impl Sampler {
    /// Word in a plan.
    pub fn word(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::LatinHypercube => "latin-hypercube",
            Self::Sobol => "sobol",
        }
    }
}

impl Design {
    /// Word in a plan.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Drawn { sampler, .. } => sampler.word(),
            Self::Grid => "grid",
            Self::Table { .. } => "table",
        }
    }
}

impl Input {
    /// The part of the law below the bounds, and up to their upper end.
    pub fn cut(&self) -> (f64, f64) {
        match &self.spread {
            Spread::Field { law, centre, half } if *half > 0.0 => {
                let (low, high) = self.bounds.ends();
                (law.below((low - centre) / half), law.below((high - centre) / half))
            }
            _ => (0.0, 1.0),
        }
    }

    /// The value at a probability, in the unit of the kind.
    fn at(&self, p: f64, (low, high): (f64, f64)) -> f64 {
        let si = match &self.spread {
            Spread::Field { law, centre, half } => centre + half * law.quantile(low + p * (high - low)),
            Spread::List(values) => values[((p * values.len() as f64) as usize).min(values.len() - 1)],
            Spread::Table => f64::NAN,
        };
        self.rounded(si)
    }

    /// A value (SI) in the unit of the kind, rounded to the digits that are written: rows of results then say exactly
    /// with which values they were computed.
    pub fn rounded(&self, si: f64) -> f64 {
        let value = self.kind.from_si(si);
        format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
    }

    /// The middle of what it takes, in the unit of its kind; `None` where a table says it.
    pub fn middle(&self) -> Option<f64> {
        match &self.spread {
            Spread::Field { centre, .. } => Some(self.rounded(*centre)),
            Spread::List(values) => values.get(values.len() / 2).map(|si| self.rounded(*si)),
            Spread::Table => None,
        }
    }
}

/// The points of a study, each from its number alone.
pub struct Points {
    inputs: Vec<Input>,
    cuts: Vec<(f64, f64)>,
    design: Design,
    /// Orders of a Latin hypercube.
    shuffles: Vec<Shuffle>,
    sobol: Option<Sobol>,
}

impl Points {
    /// Prepares the points.
    pub fn new(inputs: Vec<Input>, design: Design) -> Self {
        let cuts = inputs.iter().map(Input::cut).collect();
        let mut points = Self { inputs, cuts, design, shuffles: Vec::new(), sobol: None };
        if let Design::Drawn { sampler, samples, seed, indices } = points.design {
            let dimensions = points.inputs.len() * if indices { 2 } else { 1 };
            match sampler {
                Sampler::Random => {}
                Sampler::LatinHypercube => {
                    points.shuffles = (0..dimensions as u32).map(|d| Shuffle::new(samples, seed, d)).collect();
                }
                Sampler::Sobol => points.sobol = Some(Sobol::new(dimensions, seed)),
            }
        }
        points
    }

    /// Number of points.
    pub fn count(&self) -> u64 {
        let listed = |input: &Input| match &input.spread {
            Spread::List(values) => values.len() as u64,
            _ => 1,
        };
        match &self.design {
            Design::Drawn { samples, .. } => samples.saturating_mul(self.group()),
            Design::Grid => self.inputs.iter().map(listed).fold(1, u64::saturating_mul),
            Design::Table { rows, .. } => *rows,
        }
    }

    /// Points that belong together: with indices A, B and, for each input, A with that input of B; else one.
    pub fn group(&self) -> u64 {
        match self.design {
            Design::Drawn { indices: true, .. } => self.inputs.len() as u64 + 2,
            _ => 1,
        }
    }

    /// Values of the inputs at point number `number`, in the units of their kinds.
    pub fn at(&self, number: u64) -> Vec<f64> {
        let count = self.inputs.len();
        match &self.design {
            Design::Drawn { sampler, samples, seed, indices } => {
                let (sample, member) = (number / self.group(), number % self.group());
                // Which inputs are those of B: none of A, all of B, one of the others.
                let dimension = |input: usize| match (*indices, member) {
                    (true, 1) => input + count,
                    (true, 2..) if member - 2 == input as u64 => input + count,
                    _ => input,
                };
                let p = |dimension: usize| {
                    let uniform = || Stream::new(*seed, sample).uniform(dimension as u32, 0)[0];
                    match (sampler, &self.sobol) {
                        (Sampler::Sobol, Some(sobol)) => sobol.coordinate(sample as u32, dimension),
                        (Sampler::LatinHypercube, _) => {
                            (self.shuffles[dimension].at(sample) as f64 + uniform()) / *samples as f64
                        }
                        _ => uniform(),
                    }
                };
                (0..count).map(|i| self.inputs[i].at(p(dimension(i)), self.cuts[i])).collect()
            }
            Design::Grid => {
                let mut rest = number;
                let mut values = vec![f64::NAN; count];
                for (input, value) in self.inputs.iter().zip(&mut values).rev() {
                    if let Spread::List(all) = &input.spread {
                        *value = input.rounded(all[(rest % all.len() as u64) as usize]);
                        rest /= all.len() as u64;
                    }
                }
                values
            }
            Design::Table { values, .. } => values[number as usize * count..][..count].to_vec(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{FORCE, LENGTH};

    fn normal(centre: f64, half: f64, bounds: Bounds) -> Input {
        let spread = Spread::Field { law: Law::Normal, centre, half };
        Input { path: "a".into(), kind: FORCE, bounds, spread }
    }

    fn drawn(sampler: Sampler, indices: bool) -> Design {
        Design::Drawn { sampler, samples: 4096, seed: 3, indices }
    }

    #[test]
    fn every_design_has_the_moments_of_the_law() {
        for sampler in [Sampler::Random, Sampler::LatinHypercube, Sampler::Sobol] {
            let points = Points::new(vec![normal(450.0, 60.0, Bounds::Any); 2], drawn(sampler, false));
            assert_eq!(points.count(), 4096);
            let all: Vec<Vec<f64>> = (0..points.count()).map(|i| points.at(i)).collect();
            for input in 0..2 {
                let mean = all.iter().map(|p| p[input]).sum::<f64>() / 4096.0;
                let variance = all.iter().map(|p| (p[input] - 450.0).powi(2)).sum::<f64>() / 4096.0;
                // Four standard errors of independent draws of a standard deviation of 20.
                assert!((mean - 450.0).abs() < 4.0 * 20.0 / 64.0, "{sampler:?}: {mean}");
                assert!((variance - 400.0).abs() < 4.0 * 400.0 * (2.0f64 / 4096.0).sqrt(), "{sampler:?}: {variance}");
            }
        }
    }

    #[test]
    fn a_law_is_cut_off_where_the_quantity_ends() {
        let points = Points::new(vec![normal(10.0, 60.0, Bounds::Positive)], drawn(Sampler::LatinHypercube, false));
        let all: Vec<f64> = (0..points.count()).map(|i| points.at(i)[0]).collect();
        assert!(all.iter().all(|v| *v > 0.0));
        // The part of the uncut law that lies between 0 and its middle, over what is left of it.
        let below = Law::Normal.below(-1.0 / 6.0);
        let expected = (0.5 - below) / (1.0 - below);
        let found = all.iter().filter(|v| **v < 10.0).count() as f64 / 4096.0;
        assert!((found - expected).abs() < 1.5 / 4096.0, "{found} for {expected}");
    }

    #[test]
    fn a_group_mixes_two_points() {
        for sampler in [Sampler::Random, Sampler::LatinHypercube, Sampler::Sobol] {
            let points = Points::new(vec![normal(450.0, 60.0, Bounds::Any); 3], drawn(sampler, true));
            assert_eq!((points.count(), points.group()), (5 * 4096, 5));
            let group: Vec<Vec<f64>> = (35..40).map(|i| points.at(i)).collect();
            let (a, b) = (&group[0], &group[1]);
            for input in 0..3 {
                assert_ne!(a[input], b[input]);
                for (other, value) in group[2 + input].iter().enumerate() {
                    assert_eq!(*value, if other == input { b[other] } else { a[other] }, "{sampler:?}");
                }
            }
        }
    }

    #[test]
    fn a_grid_counts_with_its_last_input() {
        let list = |path: &str, values: &[f64]| Input {
            path: path.into(),
            kind: LENGTH,
            bounds: Bounds::Any,
            spread: Spread::List(values.to_vec()),
        };
        let points = Points::new(vec![list("a", &[0.1, 0.2]), list("b", &[0.001, 0.002, 0.0003])], Design::Grid);
        let all: Vec<Vec<f64>> = (0..points.count()).map(|i| points.at(i)).collect();
        let expected = [[100.0, 1.0], [100.0, 2.0], [100.0, 0.3], [200.0, 1.0], [200.0, 2.0], [200.0, 0.3]];
        assert_eq!(all, expected);
    }
}
