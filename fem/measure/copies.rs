//! Copies: readings that stand there twice, and tell nothing twice.
//!
//! Two readings at one place are equal to the last digit where both are rounded to the same step, which happens the more
//! often the coarser the step is beside the noise. Where more of them are equal than chance makes so, they are copies: a
//! file that was given under two names, a block that was pasted twice, rows that were doubled. They are no repeats, for
//! their errors are the same ones.

use std::collections::HashMap;
use std::f64::consts::{PI, SQRT_2};

use statrs::function::erf::erf;

use super::grid::{step_of, written_step};
use super::{Measurements, of_neighbours, parted};
use crate::process::Values;

/// Chance below which equal readings are copies: files are joined in great numbers.
const CHANCE: f64 = 1e-6;
/// Least chance of two readings at one place to be equal: gauges are set to zero there, and scales end.
const LEAST: f64 = 0.01;
/// Fewest rows that follow each other as others did, of a block that was pasted again, and fewest readings that were doubled:
/// fewer are a gauge that does not move.
const FEWEST: usize = 8;
/// Least share of the rows that have a double, where all of them were doubled.
const NEARLY_ALL: f64 = 0.95;
/// Fewest distinct readings that show their scatter.
const LEAST_VALUES: usize = 3;

/// Readings that are equal to earlier ones.
struct Equal {
    rows: Vec<usize>,
    /// How many of them chance would make so.
    by_chance: f64,
}

impl Measurements {
    /// The same with each reading once, where a file repeats itself.
    pub(super) fn without_own_copies(self) -> Self {
        let readings = self.readings();
        if let Some(copies) = self.doubled(&readings) {
            return self.told_once(&copies, &readings);
        }
        let rows = self.pasted(&with_uncertainty(&self, readings));
        if rows.is_empty() {
            return self;
        }
        let note = format!(
            "{} are copies of a block that stands above them, equal to the last digit: they are counted once; give \
             repeats that were measured a run of their own, or take all as they are with --as-typed",
            told(&self, &rows)
        );
        self.but(&rows, note)
    }

    /// The same with each reading once, where files repeat each other.
    pub(super) fn without_copies_of_files(mut self) -> Self {
        let levels = with_uncertainty(&self, self.readings());
        let (places, chances) = (self.places(), self.chances());
        let mut is_copy = vec![false; self.len()];
        let (mut stand, mut at_place) = (none(&levels), none(&places));
        let mut first = 0;
        while first < self.len() {
            let file = self.file_number(first);
            let behind = (first..self.len()).find(|row| self.file_number(*row) != file).unwrap_or(self.len());
            // A row of the files before has one copy.
            let mut take = |row: &usize| stand[levels[*row]].checked_sub(1).map(|left| stand[levels[*row]] = left);
            let rows: Vec<usize> = (first..behind).filter(|row| take(row).is_some()).collect();
            rows.iter().for_each(|row| stand[levels[*row]] += 1);
            let beside = (first..behind).filter(|row| at_place[places[*row]] > 0);
            let expected = beside.map(|row| (at_place[places[row]] as f64 * chances[self.observable(row)]).min(1.0));
            let (count, by_chance) = expected.fold((0, 0.0), |(count, sum), own| (count + 1, sum + own));
            let equal = Equal { rows, by_chance };
            if equal.is_beyond_chance(count) {
                let chance = match equal.by_chance {
                    few if few < 0.5 => "fewer than one".to_string(),
                    several => format!("some {several:.0}"),
                };
                self.notes.push(format!(
                    "{}: {} of {} rows are equal to the last digit to rows of files before it, where {chance} would be by \
                     chance: they are counted once",
                    self.files[file].name,
                    equal.rows.len(),
                    behind - first
                ));
                equal.rows.iter().for_each(|row| is_copy[*row] = true);
            }
            for row in (first..behind).filter(|row| !is_copy[*row]) {
                stand[levels[row]] += 1;
                at_place[places[row]] += 1;
            }
            first = behind;
        }
        let all = if is_copy.contains(&true) { self.keeping(|row| !is_copy[row]) } else { self };
        all.without_empty_files()
    }

    /// Level of each row by its place.
    fn places(&self) -> Vec<usize> {
        let columns: Vec<usize> = (0..self.rows.columns.len()).collect();
        parted(self.levels(&columns), |row| self.rows.observable[row] as u64)
    }

    /// Level of each row by its place and what was read there.
    fn readings(&self) -> Vec<usize> {
        // Zero has two signs.
        parted(self.places(), |row| (self.observed[row] + 0.0).to_bits())
    }

    /// Chance of two readings at one place to be equal, of each of the file's observables.
    fn chances(&self) -> Vec<f64> {
        let all = self.rows_by_observable();
        all.iter().enumerate().map(|(number, rows)| self.chance(number, rows).max(LEAST)).collect()
    }

    fn chance(&self, observable: usize, rows: &[usize]) -> f64 {
        let values: Vec<f64> = rows.iter().map(|row| self.observed[*row]).collect();
        let distinct = parted(vec![0; values.len()], |i| values[i].to_bits()).into_iter().max().map_or(0, |m| m + 1);
        if distinct < LEAST_VALUES {
            // A gauge that does not move.
            return 1.0;
        }
        let step = step_of(self, &self.observed, observable).or_else(|| written_step(self, observable));
        let Some(step) = step else { return 0.0 };
        // Rows that repeat their neighbours are no scatter.
        let mut once = values;
        once.dedup();
        let seen = (once.len() > 2).then(|| of_neighbours(&once));
        let told = self.uncertainty.as_ref().map(|u| {
            let mut own: Vec<f64> = rows.iter().map(|row| u[*row]).collect();
            own.sort_unstable_by(f64::total_cmp);
            own[own.len() / 2]
        });
        seen.into_iter().chain(told).min_by(f64::total_cmp).map_or(1.0, |sigma| of_equal(step, sigma))
    }

    /// Numbers of the rows that are left of a file in which (nearly) all readings stand as many times, and how many times
    /// that is.
    fn doubled(&self, readings: &[usize]) -> Option<(Vec<bool>, usize)> {
        let mut counts = none(readings);
        readings.iter().for_each(|level| counts[*level] += 1);
        let times = *counts.iter().min_by_key(|count| (**count == 1, **count))?;
        let whole: usize = counts.iter().filter(|count| count.is_multiple_of(times)).sum();
        if times < 2 || counts.len() < FEWEST || (whole as f64) < NEARLY_ALL * self.len() as f64 {
            return None;
        }
        let (places, chances) = (self.places(), self.chances());
        let mut at_place = none(&places);
        let (mut seen, mut is_kept) = (none(readings), Vec::with_capacity(self.len()));
        let (mut repeating, mut by_chance) = (0, 0.0);
        for (row, level) in readings.iter().enumerate() {
            let others = &mut at_place[places[row]];
            if *others > 0 {
                repeating += 1;
                by_chance += (*others as f64 * chances[self.observable(row)]).min(1.0);
            }
            *others += 1;
            seen[*level] += 1;
            is_kept.push(!counts[*level].is_multiple_of(times) || seen[*level] <= counts[*level] / times);
        }
        let rows = (0..self.len()).filter(|row| !is_kept[*row]).collect();
        Equal { rows, by_chance }.is_beyond_chance(repeating).then_some((is_kept, times))
    }

    /// The same with readings that stand several times each once: with all that their uncertainties say together, as of a
    /// row that was doubled with u·√2; or with the one that all have, where that is as somebody wrote it and not as it was divided.
    fn told_once(self, (is_kept, times): &(Vec<bool>, usize), readings: &[usize]) -> Self {
        let is_pasted = self.uncertainty.as_ref().is_none_or(|u| is_as_written(u, readings));
        let combined = self.uncertainty.as_ref().filter(|_| !is_pasted).map(|u| {
            let (mut information, mut kept) = (vec![0.0; none(readings).len()], none(readings));
            for (row, level) in readings.iter().enumerate() {
                information[*level] += u[row].powi(-2);
                kept[*level] += usize::from(is_kept[row]);
            }
            let of = |row: usize| (kept[readings[row]] as f64 / information[readings[row]]).sqrt();
            (0..self.len()).filter(|row| is_kept[*row]).map(of).collect::<Values>()
        });
        let all = if *times == 2 { "twice".to_string() } else { format!("{times} times") };
        let how = match &combined {
            Some(_) => format!(
                "and is taken as one of which they tell together, of u/√{times}; where the rows were pasted by mistake, \
                 take them out"
            ),
            None => "and is counted once; give repeats that were measured a run of their own, or take all as they are with --as-typed".into(),
        };
        let note = format!("each reading stands there {all}, equal to the last digit, {how}");
        let once = self.keeping(|row| is_kept[row]);
        let notes = once.notes.into_iter().chain([note]).collect();
        match combined {
            Some(_) => Self { notes, uncertainty: combined, ..once },
            None => Self { notes, ..once },
        }
    }

    /// Rows of blocks that repeat what stands above them, row for row.
    fn pasted(&self, levels: &[usize]) -> Vec<usize> {
        let chances = self.chances();
        let chance = |row: usize| chances[self.observable(row)].ln();
        // Any block may be repeated at any place below it.
        let looked_at = 2.0 * (self.len() as f64).ln();
        let mut first: HashMap<usize, usize> = HashMap::new();
        let (mut rows, mut row) = (Vec::new(), 0);
        while row < levels.len() {
            let from = first.get(&levels[row]).copied();
            let length = from.map_or(0, |from| {
                (0..row - from).take_while(|i| levels.get(row + i) == Some(&levels[from + i])).count()
            });
            let by_chance = looked_at + (row..row + length).map(chance).sum::<f64>();
            if length >= FEWEST && by_chance < CHANCE.ln() {
                rows.extend(row..row + length);
                row += length;
            } else {
                first.entry(levels[row]).or_insert(row);
                row += 1;
            }
        }
        rows
    }

    /// The same without rows, and with a note of them.
    fn but(mut self, rows: &[usize], note: String) -> Self {
        self.notes.push(note);
        self.keeping(|row| rows.binary_search(&row).is_err())
    }

    /// The same without files of which no row is left, which are no groups of rows.
    fn without_empty_files(mut self) -> Self {
        let mut has_rows = vec![false; self.files.len()];
        (0..self.len()).for_each(|row| has_rows[self.file_number(row)] = true);
        let mut own = has_rows.into_iter();
        self.files.retain(|_| own.next() == Some(true));
        self
    }
}

impl Equal {
    /// Whether chance makes as many of `count` rows equal with less than [`CHANCE`] (Chernoff's bound).
    fn is_beyond_chance(&self, count: usize) -> bool {
        let n = count as f64;
        let (share, expected) = (self.rows.len() as f64 / n, self.by_chance / n);
        if count == 0 || share <= expected {
            return false;
        }
        let part = |own: f64, other: f64| if own > 0.0 { own * (own / other).ln() } else { 0.0 };
        -n * (part(share, expected) + part(1.0 - share, 1.0 - expected)) < CHANCE.ln()
    }
}

/// Chance of two readings of standard deviation `sigma` to fall on the same of values a `step` apart: the mean of 1 − |d|/step
/// over their difference d, of standard deviation σ·√2.
fn of_equal(step: f64, sigma: f64) -> f64 {
    let spread = SQRT_2 * sigma;
    let reach = step / (SQRT_2 * spread);
    erf(reach) - (1.0 - (-reach * reach).exp()) / (reach * PI.sqrt())
}

/// Whether copies have one u each, and it is of few digits: √n times another one is of many.
fn is_as_written(u: &Values, readings: &[usize]) -> bool {
    /// Most digits of an uncertainty that somebody writes.
    const MOST: usize = 4;
    let mut of_level = vec![None; none(readings).len()];
    readings.iter().enumerate().all(|(row, level)| {
        let own = u[row];
        let rounded: f64 = format!("{own:.*e}", MOST - 1).parse().unwrap_or(f64::NAN);
        let is_short = (rounded / own - 1.0).abs() < 1e-9;
        is_short && *of_level[*level].get_or_insert(own) == own
    })
}

/// A count of zero for each level.
fn none(levels: &[usize]) -> Vec<usize> {
    vec![0; levels.iter().max().map_or(0, |most| most + 1)]
}

/// Levels of readings, each uncertainty by itself.
fn with_uncertainty(measurements: &Measurements, readings: Vec<usize>) -> Vec<usize> {
    match &measurements.uncertainty {
        Some(u) => parted(readings, |row| u[row].to_bits()),
        None => readings,
    }
}

/// Rows, for people.
fn told(measurements: &Measurements, rows: &[usize]) -> String {
    let (first, last) = (measurements.line(rows[0]), measurements.line(rows[rows.len() - 1]));
    format!("{} rows in lines {first} to {last}", rows.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coarse_readings_are_equal_by_chance() {
        // Far coarser than the noise nearly all are; far finer, step/(2·σ·√π).
        assert!(of_equal(100.0, 1.0) > 0.98);
        assert!((of_equal(0.01, 1.0) / (0.01 / (2.0 * PI.sqrt())) - 1.0).abs() < 1e-3);
        // By a sum over the grid: readings between k and k + 1 of a normal distribution, mean over its place.
        let normal = |x: f64| 0.5 * (1.0 + erf(x / SQRT_2));
        let of = |place: f64| {
            (-20..20).map(move |k| (normal(f64::from(k) + 1.0 - place) - normal(f64::from(k) - place)).powi(2))
        };
        let mean = (0..1000).map(|i| of(f64::from(i) / 1000.0).sum::<f64>()).sum::<f64>() / 1000.0;
        assert!((of_equal(1.0, 1.0) - mean).abs() < 1e-6, "{mean}");
    }
}
