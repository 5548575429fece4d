//! Rows that repeat each other tell the noise.

use std::collections::HashMap;

use super::Measurements;
use crate::process::Coordinate;

/// The scatter of repeated observations.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeats {
    /// The group of each row, from 0; rows of a group differ in nothing that is compared.
    pub group: Vec<usize>,
    /// Number of groups.
    pub groups: usize,
    /// Sum of squares about the groups' means, SI².
    pub sum_of_squares: f64,
    /// Degrees of freedom in it: rows − groups.
    pub freedom: usize,
}

/// Groups the rows that repeat each other.
pub fn repeats(measurements: &Measurements, coordinates: &[Coordinate]) -> Repeats {
    let compared: Vec<usize> = (0..coordinates.len()).filter(|i| !coordinates[*i].repeats).collect();
    let mut numbers: HashMap<Vec<u64>, usize> = HashMap::new();
    let mut group = Vec::with_capacity(measurements.len());
    for row in 0..measurements.len() {
        let mut key: Vec<u64> = compared.iter().map(|&i| measurements.rows.columns[i][row].to_bits()).collect();
        key.push(measurements.rows.observable[row] as u64);
        let next = numbers.len();
        group.push(*numbers.entry(key).or_insert(next));
    }
    let groups = numbers.len();
    let (mut sum, mut count) = (vec![0.0; groups], vec![0usize; groups]);
    for (&g, y) in group.iter().zip(&measurements.observed) {
        sum[g] += y;
        count[g] += 1;
    }
    let about_mean = |(g, y): (&usize, &f64)| (y - sum[*g] / count[*g] as f64).powi(2);
    let sum_of_squares = group.iter().zip(&measurements.observed).map(about_mean).sum();
    Repeats { freedom: group.len() - groups, group, groups, sum_of_squares }
}
