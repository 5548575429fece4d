//! Replicates: rows that repeat each other tell the noise (pure error).

use std::collections::HashMap;

use super::Measurements;
use crate::process::Coordinate;

/// Groups of replicates and their scatter.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeats {
    /// Group of each row, from 0; rows of a group differ in nothing that is compared.
    pub group: Vec<usize>,
    /// Number of groups.
    pub groups: usize,
    /// Scatter of each of the file's observables, in their order.
    pub scatter: Vec<Scatter>,
}

/// Scatter of the replicates of one observable (pure error).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scatter {
    /// Number of groups.
    pub groups: usize,
    /// Sum of squares about the groups' means, SI².
    pub sum_of_squares: f64,
    /// Degrees of freedom: rows − groups.
    pub freedom: usize,
}

impl Repeats {
    /// Degrees of freedom of the pure error of all observables.
    pub fn freedom(&self) -> usize {
        self.scatter.iter().map(|s| s.freedom).sum()
    }

    /// Effective degrees of freedom (Satterthwaite 1946) of the variance when each observable is measured by
    /// its own scatter: the relative variance of a mean square from ν degrees of freedom is 2/ν, and each
    /// observable counts by its number of groups.
    pub fn effective_freedom(&self) -> f64 {
        let uncertain: f64 = self.scatter.iter().map(|s| s.groups as f64 / s.freedom as f64).sum();
        self.groups as f64 / uncertain
    }
}

/// Groups the rows that repeat each other.
pub fn repeats(measurements: &Measurements, coordinates: &[Coordinate]) -> Repeats {
    let compared: Vec<usize> = (0..coordinates.len()).filter(|i| !coordinates[*i].repeats).collect();
    let mut numbers: HashMap<Vec<u64>, usize> = HashMap::new();
    let mut group = Vec::with_capacity(measurements.len());
    let mut observable = Vec::new();
    for row in 0..measurements.len() {
        let mut key: Vec<u64> = compared.iter().map(|&i| measurements.rows.columns[i][row].to_bits()).collect();
        key.push(measurements.rows.observable[row] as u64);
        let next = numbers.len();
        let own = *numbers.entry(key).or_insert(next);
        if own == next {
            observable.push(measurements.observable(row));
        }
        group.push(own);
    }
    let groups = numbers.len();
    let (mut sum, mut count) = (vec![0.0; groups], vec![0usize; groups]);
    for (&g, y) in group.iter().zip(&measurements.observed) {
        sum[g] += y;
        count[g] += 1;
    }
    let mut scatter = vec![Scatter::default(); measurements.observables.len()];
    for (&g, y) in group.iter().zip(&measurements.observed) {
        scatter[observable[g]].sum_of_squares += (y - sum[g] / count[g] as f64).powi(2);
    }
    for (observable, count) in observable.iter().zip(&count) {
        scatter[*observable].groups += 1;
        scatter[*observable].freedom += count - 1;
    }
    Repeats { group, groups, scatter }
}
