//! The noise of a file from the best source that it has: a column, repeats, neighbours.

use super::{Noise, NoiseSource};
use crate::measure::{LEAST_FREEDOM, MeasuredObservable, Measurements, Repeats, Scatter, of_neighbours, step_of};
use crate::process::Values;

impl Noise {
    /// Takes the best source there is. Observables that stand side by side each have their own noise.
    pub fn of(measurements: &Measurements, repeats: &Repeats, residuals: &[f64]) -> Self {
        if let Some(sigma) = &measurements.uncertainty {
            return Self::independent(sigma.clone(), NoiseSource::Column);
        }
        let (all, least) = (measurements.rows_by_observable(), least(measurements));
        // Copies of a row, and readings that all fall on one step of the gauge, scatter by round-off alone.
        let own = |(s, round_off): (&Scatter, &[f64; 2])| {
            let sigma = (s.sum_of_squares / s.freedom as f64).sqrt();
            (s.freedom >= LEAST_FREEDOM && sigma > round_off[0]).then(|| sigma.max(round_off[1]))
        };
        if let Some(sigma) = repeats.scatter.iter().zip(&least).map(own).collect::<Option<Vec<f64>>>() {
            return Self::alike(measurements, &sigma, NoiseSource::Repeats);
        }
        let of_rows = |(rows, [round_off, rounding]): (Vec<usize>, &[f64; 2])| {
            let residuals: Vec<f64> = in_line(measurements, rows).into_iter().map(|r| residuals[r]).collect();
            of_neighbours(&residuals).max(*round_off).max(*rounding)
        };
        let sigma: Vec<f64> = all.into_iter().zip(&least).map(of_rows).collect();
        Self::alike(measurements, &sigma, NoiseSource::Estimated)
    }

    /// Whether it is no more than the round-off of the values: neighbouring rows do not scatter, and no residual can be
    /// held against that.
    pub fn is_round_off(&self, measurements: &Measurements) -> bool {
        let is_least = |(seen, [round_off, _]): (&MeasuredObservable, [f64; 2])| {
            self.usual(measurements, seen.position) <= (1.0 + ROUND_OFF) * round_off
        };
        self.source == NoiseSource::Estimated && measurements.observables.iter().zip(least(measurements)).all(is_least)
    }
}

/// Part of the values that is round-off, and what is round-off however small they are, SI: the size of a proton.
const ROUND_OFF: f64 = 1e-9;
const SMALLEST: f64 = 1e-15;

/// Standard uncertainties (SI) below which the noise of an observable cannot lie, in the order of the file's:
/// the round-off of its values, and what rounding to the gauge's step adds (step/√12, JCGM 100:2008, F.2.2.1).
fn least(measurements: &Measurements) -> Vec<[f64; 2]> {
    let of = |(number, rows): (usize, Vec<usize>)| {
        let scale = rows.iter().fold(0.0f64, |m, r| m.max(measurements.observed[*r].abs()));
        let step = step_of(measurements, &measurements.observed, number).unwrap_or(0.0);
        [(ROUND_OFF * scale).max(SMALLEST), step / 12f64.sqrt()]
    };
    measurements.rows_by_observable().into_iter().enumerate().map(of).collect()
}

/// Orders the rows of an observable with neighbours side by side, however the file orders them: the coordinate with the most
/// values runs fastest.
fn in_line(measurements: &Measurements, mut rows: Vec<usize>) -> Vec<usize> {
    let columns = &measurements.rows.columns;
    let levels = |column: &Values| {
        let mut values: Vec<f64> = rows.iter().map(|r| column[*r]).filter(|v| !v.is_nan()).collect();
        values.sort_unstable_by(f64::total_cmp);
        values.dedup();
        values.len()
    };
    let mut order: Vec<(usize, &Values)> = columns.iter().map(|c| (levels(c), c)).collect();
    order.sort_by_key(|(levels, _)| *levels);
    rows.sort_by(|a, b| {
        let differ = |(_, c): &(usize, &Values)| Some(c[*a].total_cmp(&c[*b])).filter(|o| o.is_ne());
        order.iter().find_map(differ).unwrap_or(std::cmp::Ordering::Equal)
    });
    rows
}
