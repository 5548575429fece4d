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

impl Repeats {
    /// The same groups with the scatter that is left when levels that cross them, each with a shift of its
    /// own, are taken out (pure error within runs), and rows that `is_out` are not counted.
    #[must_use]
    pub fn within(&self, measurements: &Measurements, levels: &[Vec<usize>], is_out: &dyn Fn(usize) -> bool) -> Self {
        /// Most rounds of taking means out in turn; balanced designs need two.
        const ROUNDS: usize = 30;
        let rows: Vec<usize> = (0..measurements.len()).filter(|row| !is_out(*row)).collect();
        let mut left: Vec<f64> = rows.iter().map(|row| measurements.observed[*row]).collect();
        let own = |of_rows: &[usize]| rows.iter().map(|row| of_rows[*row]).collect::<Vec<usize>>();
        let parts: Vec<Vec<usize>> = std::iter::once(&self.group).chain(levels).map(|l| own(l)).collect();
        let count = |part: &Vec<usize>| {
            let mut distinct = part.clone();
            distinct.sort_unstable();
            distinct.dedup();
            distinct.len()
        };
        for _ in 0..if levels.is_empty() { 1 } else { ROUNDS } {
            for part in &parts {
                let most = part.iter().max().map_or(0, |m| m + 1);
                let (mut sum, mut members) = (vec![0.0; most], vec![0.0; most]);
                for (level, value) in part.iter().zip(&left) {
                    sum[*level] += value;
                    members[*level] += 1.0;
                }
                left.iter_mut().zip(part).for_each(|(value, level)| *value -= sum[*level] / members[*level]);
            }
        }
        let shifts: usize = parts[1..].iter().map(|part| count(part).saturating_sub(1)).sum();
        let mut scatter = vec![Scatter::default(); measurements.observables.len()];
        for (row, value) in rows.iter().zip(&left) {
            let own = &mut scatter[measurements.observable(*row)];
            own.sum_of_squares += value * value;
            own.freedom += 1;
        }
        for (number, own) in scatter.iter_mut().enumerate() {
            own.groups = self.scatter[number].groups;
            own.freedom = own.freedom.saturating_sub(own.groups + shifts);
        }
        Self { group: self.group.clone(), groups: self.groups, scatter }
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
