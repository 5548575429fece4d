//! Validation table of studies: Sobol' indices of functions for which they are known in closed form.

use std::f64::consts::PI;

use crate::budget::Law;
use crate::input::Bounds;
use crate::study::design::{Design, Input, Points, Sampler, Spread};
use crate::study::indices::{Index, Indices};
use crate::units::NUMBER;
use crate::validation::{Case, Tolerance};

/// Groups of independent draws in every row.
const GROUPS: u64 = 4096;

/// A function with its inputs, and its indices, first and total, in closed form.
struct Known {
    name: &'static str,
    source: &'static str,
    law: Law,
    of: fn(&[f64]) -> f64,
    indices: Vec<[f64; 2]>,
}

/// All cases.
pub fn cases() -> Vec<Case> {
    known().iter().flat_map(rows).collect()
}

fn rows(known: &Known) -> Vec<Case> {
    let found = estimated(known, Sampler::Random, GROUPS, 1);
    let row = |(i, [first, total]): (usize, &[f64; 2])| {
        let none = Index { first: f64::NAN, first_error: 0.0, total: f64::NAN, total_error: 0.0 };
        let index = found.get(i).copied().unwrap_or(none);
        let case = |quantity, expected, computed, error: f64| Case {
            name: format!("{}, input {}", known.name, i + 1),
            quantity,
            expected,
            computed,
            unit: "",
            tolerance: Tolerance::Absolute(3.0 * error),
            source: known.source,
        };
        [
            case("first-order index", *first, index.first, index.first_error),
            case("total index", *total, index.total, index.total_error),
        ]
    };
    known.indices.iter().enumerate().flat_map(row).collect()
}

/// Indices as a study estimates them, with inputs of ±1 over their fields.
fn estimated(known: &Known, sampler: Sampler, samples: u64, seed: u64) -> Vec<Index> {
    let spread = Spread::Field { law: known.law, centre: 0.0, half: 1.0 };
    let input = Input { path: "x".into(), kind: NUMBER, bounds: Bounds::Any, spread };
    let design = Design::Drawn { sampler, samples, seed, indices: true };
    let points = Points::new(vec![input; known.indices.len()], design);
    let mut indices = Indices::new(known.indices.len());
    for group in 0..samples {
        let own = group * points.group()..(group + 1) * points.group();
        indices.add(&own.map(|number| (known.of)(&points.at(number))).collect::<Vec<f64>>());
    }
    indices.estimates().unwrap_or_default()
}

fn known() -> Vec<Known> {
    vec![
        Known {
            name: "sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1 over +-pi",
            source: "Ishigami and Homma 1990; three standard errors",
            law: Law::Uniform,
            of: |x| {
                let [a, b, c] = [PI * x[0], PI * x[1], PI * x[2]];
                a.sin() + 7.0 * b.sin().powi(2) + 0.1 * c.powi(4) * a.sin()
            },
            indices: ishigami(7.0, 0.1),
        },
        Known {
            name: "g-function of a = 0, 1, 4.5, 9",
            source: "Saltelli and Sobol' 1995; three standard errors",
            law: Law::Uniform,
            of: |x| x.iter().zip(OF_G).map(|(x, a)| (2.0 * x.abs() + a) / (1.0 + a)).product(),
            indices: g_function(),
        },
        Known {
            name: "x1 + 2 x2 + 3 x3 of normal inputs",
            source: "variances of a sum; three standard errors",
            law: Law::Normal,
            of: |x| x[0] + 2.0 * x[1] + 3.0 * x[2],
            indices: [1.0, 4.0, 9.0].map(|part| [part / 14.0; 2]).to_vec(),
        },
    ]
}

/// V = a²/8 + bπ⁴/5 + b²π⁸/18 + 1/2, V₁ = (1 + bπ⁴/5)²/2, V₂ = a²/8, V₁₃ = 8b²π⁸/225; nothing else.
fn ishigami(a: f64, b: f64) -> Vec<[f64; 2]> {
    let fourth = b * PI.powi(4);
    let all = a * a / 8.0 + fourth / 5.0 + fourth * fourth / 18.0 + 0.5;
    let (one, two, both) = (0.5 * (1.0 + fourth / 5.0).powi(2), a * a / 8.0, 8.0 * fourth * fourth / 225.0);
    vec![[one / all, (one + both) / all], [two / all; 2], [0.0, both / all]]
}

const OF_G: [f64; 4] = [0.0, 1.0, 4.5, 9.0];

/// f = Π(|4u − 2| + a)/(1 + a) with V_i = 1/(3(1 + a_i)²) and V = Π(1 + V_i) − 1. With u = (x + 1)/2 the factor is
/// 2|x| + a.
fn g_function() -> Vec<[f64; 2]> {
    let own = OF_G.map(|a| 1.0 / (3.0 * (1.0 + a) * (1.0 + a)));
    let product: f64 = own.iter().map(|v| 1.0 + v).product();
    own.map(|v| [v / (product - 1.0), v * product / (1.0 + v) / (product - 1.0)]).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Deviations from the closed form over the told standard errors, first and total, over some seeds.
    fn deviations(known: &Known, sampler: Sampler) -> Vec<f64> {
        let seeds = 0..40;
        let of_seed = |seed| {
            let found = estimated(known, sampler, 512, seed);
            let both = |(i, [first, total]): (&Index, &[f64; 2])| {
                [(i.first - first) / i.first_error, (i.total - total) / i.total_error]
            };
            found.iter().zip(&known.indices).flat_map(both).collect::<Vec<f64>>()
        };
        seeds.flat_map(of_seed).collect()
    }

    #[test]
    fn all_cases_pass_and_would_not_if_shifted() {
        for case in cases() {
            assert!(case.passed(), "{} {}: {} for {}", case.name, case.quantity, case.computed, case.expected);
            let shifted = Case { expected: case.expected + 0.1, ..case };
            assert!(!shifted.passed(), "{} {}", shifted.name, shifted.quantity);
        }
    }

    #[test]
    fn standard_errors_are_those_of_independent_draws() {
        for known in known() {
            let all = deviations(&known, Sampler::Random);
            let rms = (all.iter().map(|z| z * z).sum::<f64>() / all.len() as f64).sqrt();
            // 240 or 320 deviations, those of one seed correlated: one to 15 %, and a little for skew laws.
            assert!((0.8..1.25).contains(&rms), "{}: {rms}", known.name);
        }
    }

    #[test]
    fn even_points_err_less_than_is_told() {
        for known in known() {
            let all = deviations(&known, Sampler::Sobol);
            let rms = (all.iter().map(|z| z * z).sum::<f64>() / all.len() as f64).sqrt();
            assert!(rms < 0.8, "{}: {rms}", known.name);
        }
    }

    #[test]
    fn a_group_without_an_answer_changes_nothing() {
        let groups = |hole: bool| {
            let mut indices = Indices::new(1);
            for i in 0..64 {
                let x = f64::from(i) / 10.0;
                indices.add(&[x.sin(), x.cos(), (3.0 * x).sin()]);
                if hole && i == 20 {
                    indices.add(&[1.0, f64::NAN, 3.0]);
                }
            }
            indices.estimates()
        };
        assert!(groups(false).is_some());
        assert_eq!(groups(false), groups(true));
    }
}
