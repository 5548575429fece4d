//! Replicates: rows that repeat each other tell the noise (pure error).

use std::sync::Arc;

use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::Measurements;
use super::neighbours::of_neighbours_alike;
use super::ordinals::Ordinals;
use crate::process::{Coordinate, Holds};
use crate::units::TIME;

/// Fewest degrees of freedom from which a variance is estimated.
pub const LEAST_FREEDOM: usize = 5;

/// Fewest rows whose neighbours tell a variance.
pub const LEAST_NEIGHBOURS: usize = NEIGHBOURS * LEAST_FREEDOM;

/// Groups of replicates and their scatter.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeats {
    /// Group of each row, from 0; rows of a group differ in nothing that is compared.
    pub group: Arc<Ordinals>,
    /// Number of groups.
    pub groups: usize,
    /// Scatter of each of the file's observables, in their order.
    pub scatter: Vec<Scatter>,
    /// Whether rows of a group were taken at times of their own: they repeat each other in all but what drifts,
    /// and the scatter is that of neighbours about the means of their groups.
    pub drifting: bool,
    /// Pass of each row: by its run, direction and other labels, and its observable; where rows drift.
    pass: Option<Arc<Vec<usize>>>,
    /// The coordinate that is a time, where rows drift: a file may stand in another order.
    time: Option<usize>,
    /// Recorded conditions in which rows of a group differ, and which show in them: within each group the scatter is that
    /// about what is in proportion to each.
    conditions: Vec<Arc<Vec<f64>>>,
}

/// Scatter of the replicates of one observable (pure error).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scatter {
    /// Number of groups.
    pub groups: usize,
    /// Sum of squares about the groups' means, SI².
    pub sum_of_squares: f64,
    /// Degrees of freedom: rows − groups, and less what was taken out besides.
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

    /// Group of each row.
    pub fn groups_of_rows(&self) -> Vec<usize> {
        self.group.iter().collect()
    }

    /// Number of each group among those of several rows, or [`ALONE`].
    fn repeated(&self) -> Vec<u32> {
        let mut members = vec![0_u32; self.groups];
        self.group.iter().for_each(|group| members[group] += 1);
        let mut next = 0..;
        for members in &mut members {
            *members = if *members > 1 { next.next().unwrap_or(ALONE) } else { ALONE };
        }
        members
    }

    /// Groups of rows that agree in some coordinates and the observable.
    fn of(measurements: &Measurements, coordinates: &[Coordinate], compared: &[usize], drifting: bool) -> Self {
        let group = measurements.levels_of_observables(compared);
        let is_label = |i: &usize| matches!(coordinates[*i].holds, Holds::Number(_) | Holds::Word(_));
        let pass = || {
            let labels: Vec<usize> = (0..coordinates.len()).filter(is_label).collect();
            Arc::new(measurements.levels_of_observables(&labels))
        };
        let bare = Self {
            groups: group.iter().max().map_or(0, |most| most + 1),
            scatter: vec![Scatter::default(); measurements.observables.len()],
            pass: drifting.then(pass),
            time: coordinates.iter().position(|own| own.holds.kind() == Some(TIME)),
            drifting,
            conditions: Vec::new(),
            group: Arc::new(group.into_iter().collect()),
        };
        bare.within(measurements, &[], &|_| false)
    }

    /// The same groups with the scatter that is left when levels that cross them, each with a shift of its
    /// own, are taken out (pure error within runs), and rows that `is_out` are not counted.
    #[must_use]
    pub fn within(&self, measurements: &Measurements, levels: &[Vec<usize>], is_out: &dyn Fn(usize) -> bool) -> Self {
        /// Most rounds of taking means out in turn; balanced designs need two.
        const ROUNDS: usize = 30;
        // Nothing is left of a row that no other repeats, and most of a million are such; levels and neighbours need
        // all rows.
        let repeated = (levels.is_empty() && self.pass.is_none()).then(|| self.repeated());
        let number = |group: usize| match &repeated {
            Some(numbers) => numbers[group] as usize,
            None => group,
        };
        let (mut rows, mut of_group, mut aside) = (Vec::new(), Vec::new(), vec![0; self.scatter.len()]);
        for (row, group) in self.group.iter().enumerate().filter(|(row, _)| !is_out(*row)) {
            if number(group) == ALONE as usize {
                aside[measurements.observable(row)] += 1;
            } else {
                rows.push(row);
                of_group.push(number(group));
            }
        }
        drop(repeated);
        let mut left: Vec<f64> = rows.iter().map(|row| measurements.observed[*row]).collect();
        let of_levels = levels.iter().map(|of_rows| rows.iter().map(|row| of_rows[*row]).collect::<Vec<usize>>());
        let of_levels: Vec<Vec<usize>> = of_levels.collect();
        for _ in 0..if levels.is_empty() { 1 } else { ROUNDS } {
            std::iter::once(&of_group).chain(&of_levels).for_each(|part| take_means_out(part, &mut left));
        }
        let shifts: usize = of_levels.into_iter().map(|part| distinct(part).saturating_sub(1)).sum();
        let taken = take_slopes_out(&rows, &of_group, &self.conditions, &mut left);
        let scatter = |(number, own): (usize, &Scatter)| {
            let mut of: Vec<usize> = (0..rows.len()).filter(|i| measurements.observable(rows[*i]) == number).collect();
            if let (Some(_), Some(times)) = (&self.pass, self.time.and_then(|time| measurements.rows.columns.get(time)))
            {
                of.sort_by(|a, b| times[rows[*a]].total_cmp(&times[rows[*b]]));
            }
            let count = of.len() + aside[number];
            // Groups are those of all rows: one that has lost its only row to `is_out` has no scatter either.
            let groups = own.groups.max(aside[number] + distinct(of.iter().map(|i| of_group[*i]).collect()));
            let slopes: usize = of.iter().map(|i| taken[*i]).sum();
            let freedom = count.saturating_sub(groups + shifts + slopes);
            let left: Vec<f64> = of.iter().map(|i| left[*i]).collect();
            let Some(pass) = &self.pass else {
                return Scatter { groups, freedom, sum_of_squares: left.iter().map(|d| d * d).sum() };
            };
            let is_one_pass = |a: usize, b: usize| pass[rows[of[a]]] == pass[rows[of[b]]];
            let enlarged = count as f64 / freedom.max(1) as f64;
            let freedom = freedom / NEIGHBOURS;
            let variance = enlarged * of_neighbours_alike(&left, is_one_pass).powi(2);
            Scatter { groups, freedom, sum_of_squares: variance * freedom as f64 }
        };
        let scatter = self.scatter.iter().enumerate().map(scatter).collect();
        Self { scatter, ..self.clone() }
    }
}

impl Repeats {
    /// The same groups with the scatter beside recorded conditions that show in them (F test), as long as enough is left.
    fn beside_conditions(self, measurements: &Measurements, coordinates: &[Coordinate]) -> Self {
        /// Most conditions, and chance of one that shows nothing.
        const MOST: usize = 3;
        const CHANCE: f64 = 1e-3;
        let is_quantity = |i: &usize| coordinates[*i].is_recorded && coordinates[*i].holds.kind().is_some();
        let mut left: Vec<Arc<Vec<f64>>> = (0..coordinates.len().min(measurements.rows.columns.len()))
            .filter(is_quantity)
            .map(|i| Arc::new(measurements.rows.columns[i].to_vec()))
            .collect();
        let mut best = self;
        while best.conditions.len() < MOST {
            let with = |own: &Arc<Vec<f64>>| {
                let conditions = best.conditions.iter().chain([own]).cloned().collect();
                let bare = Self { conditions, ..best.clone() };
                bare.within(measurements, &[], &|_| false)
            };
            let tried: Vec<(f64, Self)> = left.iter().map(with).map(|own| (best.chance_of(&own), own)).collect();
            let is_shown =
                |(_, (chance, own)): &(usize, (f64, Self))| *chance < CHANCE && own.freedom() >= LEAST_FREEDOM;
            let shown = tried.into_iter().enumerate().filter(is_shown).min_by(|a, b| a.1.0.total_cmp(&b.1.0));
            let Some((number, (_, own))) = shown else { break };
            left.remove(number);
            best = own;
        }
        best
    }

    /// Chance of a scatter as much smaller, of the observable that shows it best.
    fn chance_of(&self, other: &Self) -> f64 {
        let chance = |(own, other): (&Scatter, &Scatter)| {
            let slopes = own.freedom.checked_sub(other.freedom).filter(|slopes| *slopes > 0)? as f64;
            let variance = other.sum_of_squares / other.freedom as f64;
            let ratio = (own.sum_of_squares - other.sum_of_squares) / slopes / variance;
            let chance = FisherSnedecor::new(slopes, other.freedom as f64).ok()?.sf(ratio.max(0.0));
            Some(if ratio.is_finite() { chance } else { 1.0 })
        };
        self.scatter.iter().zip(&other.scatter).filter_map(chance).fold(1.0, f64::min)
    }
}

/// Takes out of the values of each group what is in proportion to each condition there; how many slopes that takes, each
/// counted at the first row of its group.
fn take_slopes_out(rows: &[usize], of_group: &[usize], conditions: &[Arc<Vec<f64>>], values: &mut [f64]) -> Vec<usize> {
    /// Part of the square of a condition that is left beside others where it is another.
    const ROUND_OFF: f64 = 1e-9;
    let mut taken = vec![0; rows.len()];
    if conditions.is_empty() {
        return taken;
    }
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); of_group.iter().max().map_or(0, |most| most + 1)];
    of_group.iter().enumerate().for_each(|(i, group)| members[*group].push(i));
    for own in members.iter().filter(|own| own.len() > 1) {
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for condition in conditions {
            let mut column: Vec<f64> = own.iter().map(|i| condition[rows[*i]]).collect();
            let mean = column.iter().sum::<f64>() / column.len() as f64;
            column.iter_mut().for_each(|value| *value -= mean);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let whole = dot(&column, &column);
            for other in &basis {
                let along = dot(other, &column);
                column.iter_mut().zip(other).for_each(|(value, other)| *value -= along * other);
            }
            let length = dot(&column, &column);
            // Round-off of a mean is no condition.
            if !(length > ROUND_OFF * whole && whole > ROUND_OFF * mean * mean * 1e-9) {
                continue;
            }
            column.iter_mut().for_each(|value| *value /= length.sqrt());
            let along: f64 = own.iter().zip(&column).map(|(i, c)| values[*i] * c).sum();
            own.iter().zip(&column).for_each(|(i, c)| values[*i] -= along * c);
            taken[own[0]] += 1;
            basis.push(column);
        }
    }
    taken
}

/// In the place of the number of a group of one row.
const ALONE: u32 = u32::MAX;

/// Rows whose differences tell of a variance as much as one independent row does: second differences that
/// overlap, by their median.
const NEIGHBOURS: usize = 4;

/// Takes the mean of each level out of its values.
fn take_means_out(levels: &[usize], values: &mut [f64]) {
    let most = levels.iter().max().map_or(0, |m| m + 1);
    let (mut sum, mut members) = (vec![0.0; most], vec![0.0; most]);
    for (level, value) in levels.iter().zip(&*values) {
        sum[*level] += value;
        members[*level] += 1.0;
    }
    values.iter_mut().zip(levels).for_each(|(value, level)| *value -= sum[*level] / members[*level]);
}

/// Number of distinct levels.
fn distinct(mut levels: Vec<usize>) -> usize {
    levels.sort_unstable();
    levels.dedup();
    levels.len()
}

/// Groups the rows that repeat each other. Where runs repeat each other and each row has a time of its own,
/// rows that agree in all but the time do, in all but what drifts.
pub fn repeats(measurements: &Measurements, coordinates: &[Coordinate]) -> Repeats {
    let compared = |is_left_out: &dyn Fn(&Coordinate) -> bool| -> Vec<usize> {
        (0..coordinates.len()).filter(|i| !is_left_out(&coordinates[*i])).collect()
    };
    let alike = Repeats::of(measurements, coordinates, &compared(&|c| c.repeats), false);
    if alike.freedom() >= LEAST_FREEDOM {
        return alike;
    }
    // Nobody repeats the weather; what it does to the rows is no scatter.
    let exact = match coordinates.iter().any(|c| c.is_recorded) {
        true => Repeats::of(measurements, coordinates, &compared(&|c| c.repeats || c.is_recorded), false)
            .beside_conditions(measurements, coordinates),
        false => alike,
    };
    if exact.freedom() >= LEAST_FREEDOM || coordinates.iter().all(|c| !c.repeats) {
        return exact;
    }
    let at_other_times = compared(&|c| c.repeats || c.is_recorded || c.holds.kind() == Some(TIME));
    let drifting = Repeats::of(measurements, coordinates, &at_other_times, true);
    if drifting.freedom() >= LEAST_FREEDOM { drifting } else { exact }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::{Process, Rows};

    /// Nine runs over eleven targets to and fro, with an error of each target and a drift of 30 um over the test;
    /// each reading at a time of its own, and off by ±2 um in turn.
    fn test(with_time: bool) -> (&'static dyn Process, Measurements) {
        let process = *crate::processes::ALL.iter().find(|p| p.coordinates().iter().any(|c| c.repeats)).unwrap();
        let position = |name: &str| process.coordinates().iter().position(|c| c.name == name).unwrap();
        let mut columns = vec![vec![0.0; 198]; process.coordinates().len()];
        let mut observed = Vec::new();
        for row in 0..198 {
            let (run, place) = (row / 22, row % 22);
            let target = if place < 11 { place } else { 21 - place };
            columns[position("run")][row] = (run + 1) as f64;
            columns[position("direction")][row] = (place / 11) as f64;
            columns[position("position")][row] = 0.1 * target as f64;
            columns[position("time")][row] = if with_time { 20.0 * row as f64 } else { 0.0 };
            // A pattern whose second differences have the variance of white noise of 2 um.
            let noise = 2e-6 * [1.2, -0.7, -1.1, 0.4, 1.3, -0.2, -1.4, 0.9, -0.5][(row * 5 + run) % 9];
            observed.push(1e-5 * (target as f64).sin() + 30e-6 * (1.0 - (-(row as f64) / 60.0).exp()) + noise);
        }
        let planned = Measurements::planned(process, "test", Rows::new(columns, vec![0; 198]));
        (process, Measurements { observed, ..planned })
    }

    fn sigma(repeats: &Repeats) -> f64 {
        (repeats.scatter[0].sum_of_squares / repeats.scatter[0].freedom as f64).sqrt()
    }

    #[test]
    fn times_of_their_own_leave_rows_repeats_in_all_but_drift() {
        let (process, with_time) = test(true);
        let found = repeats(&with_time, process.coordinates());
        assert!(found.drifting && found.groups == 22, "{} groups", found.groups);
        assert!((1e-6..3.5e-6).contains(&sigma(&found)), "{}", sigma(&found));
        // Without times the runs are repeats, drift and all.
        let (_, without) = test(false);
        assert!(sigma(&repeats(&without, process.coordinates())) > 6e-6);
    }
}
