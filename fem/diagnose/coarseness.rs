//! How coarse a machine is: by how much the sizes of its effects are beyond the usual, all together.
//!
//! The catalogue knows what is usual of machines that err by micrometres. A press errs by millimetres and a diamond lathe
//! by nanometres, and what is missing in them is told by the same shapes. So the usual sizes of effects move with the
//! data: effects of one sort (errors, stiffnesses, forces) by one factor, which keeps what is known of them beside each
//! other. It follows from the residual of the model alone, beside what the effects of the sort would make of the rows at
//! their usual sizes.

use nalgebra::DVector;
use rayon::prelude::*;

use crate::fit::{Coarseness, Objective, Solution};
use crate::process::{Description, Parameter};

/// Ratio of what is measured for to the uncertainty of the instrument, as instruments are chosen.
const INSTRUMENT: f64 = 10.0;
/// Logarithm of what one machine leaves beside the usual, up to which it says nothing of its coarseness: a factor of thirty.
const ONE_MACHINE: f64 = 1.5 * std::f64::consts::LN_10;

/// How coarse a machine is, by the residual of a fitted model without the effects.
pub fn coarseness(objective: &Objective, base: &Solution, effects: &[Description]) -> Coarseness {
    let left = robust_scale(objective, base);
    let sizes = |effect: &Description| {
        let trial = objective.with(effect);
        let first = objective.variables.len();
        let mut neutral: Vec<f64> = base.position.iter().copied().collect();
        neutral.extend(trial.variables[first..].iter().map(|v| v.middle()));
        let of = |(i, entry): (usize, &Parameter)| {
            let sort = Coarseness::sort(effect, entry)?;
            let mut there = DVector::from_vec(neutral.clone());
            there[first + i] = trial.variables[first + i].typical_size()?;
            let predicted = trial.predict(&there)?;
            let change = predicted.iter().zip(&base.predicted).map(|(p, q)| p - q);
            let made = trial.whiten(change).norm() / (base.predicted.len() as f64).sqrt();
            let beyond = (left / made).ln();
            beyond.is_finite().then_some((sort, beyond))
        };
        effect.parameters.iter().enumerate().filter_map(of).collect::<Vec<_>>()
    };
    let all: Vec<(usize, f64)> = effects.par_iter().flat_map_iter(sizes).collect();
    let of_sort = |sort: usize| all.iter().filter(move |own| own.0 == sort).map(|own| own.1).collect::<Vec<f64>>();
    Coarseness::of(|sort| believed(median(&mut of_sort(sort))))
}

/// What of a logarithm is believed to be the machine's own, and not that of what happens to be missing in it (the shrinkage of
/// James and Stein 1961, positive part).
fn believed(beyond: f64) -> f64 {
    if beyond.abs() > ONE_MACHINE { beyond - ONE_MACHINE.powi(2) / beyond } else { 0.0 }
}

/// Scale of the residual in standard uncertainties, of which neither a constant nor a few rows are the most; no less than what
/// an instrument is chosen for, where its noise is known.
fn robust_scale(objective: &Objective, base: &Solution) -> f64 {
    /// Standard deviation of a normal distribution over its median absolute deviation.
    const NORMAL: f64 = 1.4826;
    let data = objective.data;
    let residuals = objective.residuals(&base.position, &base.predicted);
    let mut deviations = Vec::with_capacity(data.len());
    for rows in data.rows_by_observable() {
        let own: Vec<f64> = rows.iter().map(|row| residuals[*row]).collect();
        let middle = median(&mut own.clone());
        deviations.extend(own.iter().map(|z| (z - middle).abs()));
    }
    let left = NORMAL * median(&mut deviations);
    if objective.noise.source.is_known() { left.max(INSTRUMENT) } else { left }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let (low, high) = (values.get(values.len().saturating_sub(1) / 2), values.get(values.len() / 2));
    low.zip(high).map_or(0.0, |(low, high)| 0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::LN_10;

    use super::{believed, median};

    /// In decades: what one machine's residual may be off by moves nothing, a factor of a thousand nearly all of it, and
    /// too fine as too coarse.
    #[test]
    fn a_little_is_the_residuals_and_much_is_the_machines() {
        for (asked, moved) in [(0.0, 0.0), (1.0, 0.0), (1.5, 0.0), (2.0, 0.875), (3.0, 2.25), (6.0, 5.625)] {
            for sign in [1.0, -1.0] {
                assert!((believed(sign * asked * LN_10) - sign * moved * LN_10).abs() < 1e-12, "{asked}");
            }
        }
    }

    #[test]
    fn the_median_of_nothing_moves_nothing() {
        assert_eq!([median(&mut []), median(&mut [3.0]), median(&mut [4.0, 1.0, 2.0, 9.0])], [0.0, 3.0, 3.0]);
    }
}
