//! The contour at points that miss no peak.

use std::f64::consts::TAU;

use super::super::path::Direction;
use super::super::rows::{self, ANGLE_OF_ROW, DIRECTION};
use super::super::setup::Setup;
use crate::process::{Failure, Forward, Rows, Values};

/// Least excess of a point over the line between its neighbours in the programme that is worth a row, as a part of the
/// span of all deviations.
const PEAK: f64 = 0.02;

/// Points of all laps with what they show.
pub struct Sampled {
    /// Lap by lap, in rising angles.
    pub rows: Rows,
    /// m.
    pub deviations: Vec<f64>,
}

impl Sampled {
    /// The laps of a setup as they are predicted.
    ///
    /// # Errors
    /// The contour cannot be computed.
    pub fn of(setup: &Setup, forward: &Forward) -> Result<Self, Failure> {
        let rows = rows::programme(setup);
        Ok(Self { deviations: forward.observe(&rows)?, rows })
    }

    /// The programme, and between its rows those of `fine` where the deviation peaks: a reversal is over within a
    /// degree, and a profile without it would lack the largest deviation.
    pub fn with_peaks(setup: &Setup, forward: &Forward, fine: &Self) -> Self {
        let programme = Self { rows: forward.programme.clone(), deviations: forward.prediction.to_vec() };
        let all = || programme.deviations.iter().chain(&fine.deviations).copied();
        let span = all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min);
        let columns = vec![Values::default(); programme.rows.columns.len()];
        let mut sampled = Self { rows: Rows { columns, observable: Values::default() }, deviations: Vec::new() };
        for direction in &setup.directions {
            let (own, mut dense) = (programme.lap(*direction), fine.lap(*direction));
            // Angles are those that the machine reaches, which need not follow each other as the programme's do.
            dense.sort_by(|a, b| fine.angle(*a).total_cmp(&fine.angle(*b)));
            for (k, row) in own.iter().enumerate() {
                sampled.push(&programme, *row);
                let next = own[(k + 1) % own.len()];
                let (from, to) = (programme.angle(*row), programme.angle(next));
                let to = if to > from { to } else { to + TAU };
                let line = |angle: f64| {
                    let share = (angle - from) / (to - from);
                    (1.0 - share) * programme.deviations[*row] + share * programme.deviations[next]
                };
                let [first, behind] =
                    [dense.partition_point(|j| fine.angle(*j) <= from), dense.partition_point(|j| fine.angle(*j) < to)];
                let between = dense.get(first..behind).unwrap_or_default();
                let off = |j: &&usize| fine.deviations[**j] - line(fine.angle(**j));
                let highest = between.iter().max_by(|a, b| off(a).total_cmp(&off(b)));
                let lowest = between.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
                let mut peaks: Vec<usize> =
                    [highest, lowest].into_iter().flatten().filter(|j| off(j).abs() > PEAK * span).copied().collect();
                peaks.sort_unstable();
                peaks.dedup();
                peaks.into_iter().for_each(|j| sampled.push(fine, j));
            }
        }
        sampled
    }

    fn angle(&self, row: usize) -> f64 {
        self.rows.columns[ANGLE_OF_ROW][row]
    }

    /// The rows of a lap.
    fn lap(&self, direction: Direction) -> Vec<usize> {
        (0..self.rows.len()).filter(|row| Direction::at(self.rows.columns[DIRECTION][*row]) == direction).collect()
    }

    fn push(&mut self, from: &Self, row: usize) {
        for (own, other) in self.rows.columns.iter_mut().zip(&from.rows.columns) {
            own.push(other[row]);
        }
        self.rows.observable.push(from.rows.observable[row]);
        self.deviations.push(from.deviations[row]);
    }
}
