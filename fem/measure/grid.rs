//! The grid on which the values of a file lie: the step of the instrument.

use super::Measurements;
use crate::units::Unit;

/// Most decimals that are looked at.
const DECIMALS: i32 = 9;
/// Fewest rows and fewest distinct values that show a grid.
const LEAST_ROWS: usize = 8;
const LEAST_VALUES: usize = 3;
/// Ratio to the last digit that is written from which a step can be told from chance.
const COARSER: f64 = 5.0;

/// Step (SI) on whose multiples the values of an observable lie, by the observable's number among the file's:
/// that of the instrument, or else of the last digit that is written. `None` where the values are too few to
/// tell, or have more digits than anybody writes.
pub fn step_of(measurements: &Measurements, observed: &[f64], observable: usize) -> Option<f64> {
    let (mut values, unit) = as_written(measurements, observed, observable)?;
    let (rows, written) = (values.len(), written(&values)?);
    values.sort_unstable_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() < 0.5 * written);
    if rows < LEAST_ROWS || values.len() < LEAST_VALUES {
        return None;
    }
    let coarse = coarse_step(&values, written).filter(|step| *step >= COARSER * written);
    Some(coarse.unwrap_or(written) * unit.factor)
}

/// Place (SI) of the last digit in which an observable is written; `None` where the values have more digits than anybody
/// writes.
pub fn written_step(measurements: &Measurements, observable: usize) -> Option<f64> {
    let (values, unit) = as_written(measurements, &measurements.observed, observable)?;
    written(&values).map(|place| place * unit.factor)
}

/// Values of an observable in the unit in which the file writes them.
fn as_written(measurements: &Measurements, observed: &[f64], observable: usize) -> Option<(Vec<f64>, Unit)> {
    let unit = Unit::parse(&measurements.observables.get(observable)?.unit).ok()?;
    let own = (0..observed.len()).filter(|row| measurements.observable(*row) == observable);
    Some((own.map(|row| (observed[row] - unit.offset) / unit.factor).collect(), unit))
}

/// Largest step that all of these rising values share, but for the rounding of the digits that are written.
fn coarse_step(values: &[f64], written: f64) -> Option<f64> {
    let first = values[0];
    let mut step = values.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    // Farther values tell it better.
    for value in &values[1..] {
        let distance = value - first;
        let count = (distance / step).round();
        if (distance - count * step).abs() > 1.01 * written + 0.02 * step {
            return None;
        }
        step = distance / count;
    }
    let is_on = |value: &f64| ((value - first) / step - ((value - first) / step).round()).abs() * step < 1.01 * written;
    values.iter().all(is_on).then_some(step)
}

/// Place of the last decimal that any of the values has.
fn written(values: &[f64]) -> Option<f64> {
    let has = |place: f64| values.iter().all(|v| (v / place - (v / place).round()).abs() < 1e-4);
    (0..=DECIMALS).map(|decimals| 10f64.powi(-decimals)).find(|place| has(*place))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::{Rows, Values};

    /// Values (mm) of rows of turning's first observable.
    fn step(values: &[f64]) -> Option<f64> {
        let (process, count) = (crate::processes::ALL[0], values.len());
        let columns = vec![Values::shared(0.0, count); process.coordinates().len()];
        let rows = Measurements::planned(process, "rows", Rows { columns, observable: Values::shared(0, count) });
        let unit = Unit::parse(&rows.observables[0].unit).unwrap();
        let observed: Vec<f64> = values.iter().map(|v| v * unit.factor + unit.offset).collect();
        step_of(&rows, &observed, 0).map(|step| step / unit.factor)
    }

    #[test]
    fn a_grid_is_seen_through_rounded_digits() {
        // Multiples of 1.3025 written with three decimals, as 2.605 and 3.908.
        let rounded = [0.0, 1.302, 1.302, 2.605, 3.908, 0.0, -1.302, 2.605, 2.605, 6.512];
        assert!((step(&rounded).unwrap() - 1.3025).abs() < 3e-4);
        let tens = [10.0, 20.0, 20.0, 40.0, 10.0, 70.0, 40.0, 10.0];
        assert!((step(&tens).unwrap() - 10.0).abs() < 1e-9);
    }

    #[test]
    fn without_a_coarser_one_the_last_digit_is_the_step() {
        let near = |step: Option<f64>, expected: f64| (step.unwrap() / expected - 1.0).abs() < 1e-6;
        assert!(near(step(&[0.011, 0.023, 0.031, 0.057, 0.062, 0.078, 0.091, 0.104]), 0.001));
        assert!(near(step(&[1.0, 1.0, 1.0, 2.1, 2.1, 2.1, 3.7, 3.7, 1.0, 2.1]), 0.1));
        // Too few values, and digits that nobody wrote.
        assert_eq!(step(&[1.0, 1.0, 2.0, 2.0, 1.0, 1.0, 2.0, 2.0]), None);
        assert_eq!(step(&(1..10).map(|i| f64::from(i).sqrt()).collect::<Vec<_>>()), None);
    }
}
