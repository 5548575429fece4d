//! Slips of the pen: readings far from all that surrounds them which one slip of a typist makes of what should stand there.
//!
//! What should stand there is told by the rows themselves, without any model: along each coordinate a reading lies between
//! its neighbours, whatever law the whole follows, and the coordinate along which rows do so best is taken. A reading that is
//! far off and that no slip explains stays, for it may be what was measured; and beside several of these so does one that a slip
//! happens to explain.

use super::Measurements;
use super::actual::Difference;
use super::header::Column;
use super::vocabulary::Vocabulary;
use crate::process::{Coordinate, Holds};

/// Standard deviations from its neighbours beyond which a reading may be a slip.
const FAR: f64 = 12.0;
/// Standard deviations within which what is meant then lies.
const NEAR: f64 = 3.0;
/// Fewest rows of an observable in which slips are looked for.
const FEWEST: usize = 8;
/// Most rows.
const MOST: usize = 200_000;
/// Rows on either side of a reading by which what is usual there is judged.
const BESIDE: usize = 6;
/// Rows on either side of a slip in which no other reading is far off.
const NEARBY: usize = 3;
/// Most others that are far off without which a reading is looked at.
const MOST_BESIDE: usize = 8;
/// Largest share of the rows that may be slips.
const MOST_SHARE: f64 = 0.05;
/// Ratio of the standard deviation of a normal distribution to its median absolute deviation.
const OF_MEDIAN: f64 = 1.4826;

/// A row that somebody mistyped.
#[derive(Clone, Debug, PartialEq)]
pub struct Slip {
    /// The row.
    pub row: usize,
    /// What was typed.
    pub typed: String,
    /// What was probably meant.
    pub meant: String,
    /// The slip.
    pub what: &'static str,
}

/// A reading and what stands around it in its series: the value that is expected, and the standard deviation of their
/// difference in standard deviations of a row.
#[derive(Clone, Copy)]
struct Around {
    row: usize,
    observed: f64,
    value: f64,
    spread: f64,
}

impl Measurements {
    /// The same without readings that somebody mistyped, each of which a note tells.
    pub(super) fn without_slips(
        mut self,
        vocabulary: Vocabulary,
        columns: &[Column],
        difference: Option<Difference>,
    ) -> Self {
        let mut all = Vec::new();
        for (column, own) in columns.iter().enumerate() {
            let Column::Observed(observable, unit) = own else { continue };
            if vocabulary.observables[*observable].is_traced {
                continue;
            }
            let typed = |row: usize| {
                let cells = self.records.get(self.records_of.get(row)?);
                let of_difference = difference.filter(|own| own.column == column).and_then(|own| own.actual(&cells));
                Some((of_difference.unwrap_or_else(|| cells[column].to_string()), unit.factor))
            };
            let name = &vocabulary.observables[*observable].name;
            let found = slips(&self, vocabulary.coordinates, *observable, &typed);
            all.extend(found.into_iter().map(|slip| (slip, name.clone())));
        }
        if all.is_empty() {
            return self;
        }
        for (Slip { row, typed, meant, what }, name) in &all {
            let line = self.line(*row);
            self.notes.push(format!(
                "line {line} is left out: `{typed}` for {name} is far from all around it, and probably {meant} was meant \
                 ({what}); mend it in the file, or take it as it is with --as-typed"
            ));
        }
        self.keeping(|row| all.iter().all(|(slip, _)| slip.row != row))
    }
}

/// The slips of an observable, by the texts of its readings, each with SI units in one of the text's; the largest first.
pub fn slips(
    measurements: &Measurements,
    coordinates: &[Coordinate],
    observable: usize,
    typed: &dyn Fn(usize) -> Option<(String, f64)>,
) -> Vec<Slip> {
    let rows: Vec<usize> =
        (0..measurements.len()).filter(|row| measurements.rows.observable[*row] == observable).collect();
    if rows.len() < FEWEST || rows.len() > MOST {
        return Vec::new();
    }
    let surroundings = |left: &[usize]| Surroundings::of(measurements, coordinates, left);
    let mut left = rows.clone();
    let mut found: Vec<Slip> = Vec::new();
    // A slip takes the surroundings of its neighbours with it: one at a time, and all are looked at anew.
    'all: while let Some(here) = surroundings(&left) {
        let far = here.far();
        for own in &far {
            let Some((text, factor)) = typed(own.row) else { continue };
            let shift = own.value - own.observed;
            let near = NEAR * here.scale * own.spread;
            let Some((meant, what)) = meant(&text, shift / factor, near / factor) else { continue };
            // What is off because of one beside it is none.
            let follows = |other: &Around| {
                let without: Vec<usize> = left.iter().copied().filter(|row| *row != other.row).collect();
                surroundings(&without).is_some_and(|there| there.has(own.row) && !there.is_far(own.row))
            };
            if far.iter().filter(|other| other.row != own.row).take(MOST_BESIDE).any(|other| follows(other)) {
                continue;
            }
            let others: Vec<usize> = left.iter().copied().filter(|row| *row != own.row).collect();
            // A reading beside which others are as far off is one of them, and no slip.
            let is_nearby = |other: &Around| other.row.abs_diff(own.row) <= NEARBY;
            if surroundings(&others).is_none_or(|there| there.far().into_iter().any(is_nearby)) {
                continue;
            }
            let other_values = others.iter().map(|row| measurements.observed[*row]);
            if shift.abs() < spread(other_values) {
                continue;
            }
            left = others;
            found.push(Slip { row: own.row, typed: text, meant, what });
            if found.len() as f64 > MOST_SHARE * rows.len() as f64 {
                // So many are no slips.
                return Vec::new();
            }
            continue 'all;
        }
        break;
    }
    // Where others are as far off and no slip explains them, what explains these is chance.
    let unexplained = surroundings(&left).map_or(0, |here| here.far().len());
    if unexplained >= found.len() { Vec::new() } else { found }
}

/// Standard deviation of values.
fn spread(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    (values.map(|own| (own - mean).powi(2)).sum::<f64>() / count).sqrt()
}

/// What stands around rows, along the coordinate along which they follow each other best.
struct Surroundings {
    around: Vec<Around>,
    /// Standard deviation of a row, SI.
    scale: f64,
}

impl Surroundings {
    /// `None` where rows follow each other along no coordinate.
    fn of(all: &Measurements, coordinates: &[Coordinate], rows: &[usize]) -> Option<Self> {
        let is_one = |i: &usize| {
            let own = &coordinates[*i];
            all.given.contains(i) && !own.is_recorded && !matches!(own.holds, Holds::Word(_))
        };
        let one = |i: usize| {
            let around = along_one(all, coordinates, rows, i);
            if 2 * around.len() < rows.len().max(2 * FEWEST) {
                return None;
            }
            let errors = around.iter().map(|own| ((own.observed - own.value) / own.spread).abs());
            let mut errors: Vec<f64> = errors.collect();
            errors.sort_unstable_by(f64::total_cmp);
            let told = all.uncertainty.as_ref().map_or(0.0, |u| u[rows[0]]);
            let scale = (OF_MEDIAN * errors[errors.len() / 2]).max(told);
            (scale > 0.0).then_some(Self { around, scale })
        };
        (0..coordinates.len()).filter(is_one).filter_map(one).min_by(|a, b| a.scale.total_cmp(&b.scale))
    }

    /// How far a reading is off, in its standard deviations.
    fn off(&self, own: &Around) -> f64 {
        ((own.observed - own.value) / (self.scale * own.spread)).abs()
    }

    /// How far others beside it are off: where readings jump about, as at a reversal, one that does is nothing unusual.
    fn usual(&self, i: usize) -> f64 {
        let from = i.saturating_sub(BESIDE);
        let others = self.around[from..(i + BESIDE + 1).min(self.around.len())].iter().zip(from..);
        let mut sizes: Vec<f64> = others.filter(|(_, j)| j.abs_diff(i) > 1).map(|(own, _)| self.off(own)).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        sizes.get(sizes.len() / 2).copied().unwrap_or(0.0).max(1.0)
    }

    /// Whether something stands around a row.
    fn has(&self, row: usize) -> bool {
        self.around.iter().any(|own| own.row == row)
    }

    fn is_far(&self, row: usize) -> bool {
        self.far().iter().any(|own| own.row == row)
    }

    /// Readings that are far off, the farthest first.
    fn far(&self) -> Vec<&Around> {
        let is_far = |(i, own): &(usize, &Around)| self.off(own) > FAR * self.usual(*i);
        let mut far: Vec<&Around> = self.around.iter().enumerate().filter(is_far).map(|(_, own)| own).collect();
        far.sort_unstable_by(|a, b| self.off(b).total_cmp(&self.off(a)));
        far
    }
}

/// What stands around rows that differ in one coordinate alone, in its order.
fn along_one(all: &Measurements, coordinates: &[Coordinate], rows: &[usize], coordinate: usize) -> Vec<Around> {
    // What is recorded beside the readings parts no series.
    let is_own = |i: &usize| *i != coordinate && coordinates.get(*i).is_some_and(|own| !own.is_recorded);
    let others: Vec<usize> = all.given.iter().copied().filter(is_own).collect();
    // Times differ in every row and hold no series together.
    let level = |i: &usize| {
        let mut values: Vec<u64> = rows.iter().map(|row| all.rows.columns[*i][*row].to_bits()).collect();
        values.sort_unstable();
        values.dedup();
        values.len()
    };
    let shared: Vec<usize> = others.into_iter().filter(|i| 2 * level(i) < rows.len()).collect();
    let levels = all.levels(&shared);
    let at = |row: usize| all.rows.columns[coordinate][row];
    let mut sorted = rows.to_vec();
    sorted.sort_by(|a, b| levels[*a].cmp(&levels[*b]).then(at(*a).total_cmp(&at(*b))));
    let mut around = Vec::new();
    for series in sorted.chunk_by(|a, b| levels[*a] == levels[*b]) {
        for i in 0..series.len() {
            let neighbours = match i {
                _ if series.len() < 4 => continue,
                0 => [1, 2],
                _ if i + 1 == series.len() => [i - 1, i - 2],
                _ => [i - 1, i + 1],
            };
            let [a, b] = neighbours.map(|j| series[j]);
            let (x, from, to) = (at(series[i]), at(a), at(b));
            // Rows at one place are their mean.
            let weight = if from == to { 0.5 } else { (x - from) / (to - from) };
            let value = (1.0 - weight) * all.observed[a] + weight * all.observed[b];
            let spread = (1.0 + weight.powi(2) + (1.0 - weight).powi(2)).sqrt();
            if value.is_finite() && spread.is_finite() && spread < 4.0 {
                let observed = all.observed[series[i]];
                around.push(Around { row: series[i], observed, value, spread });
            }
        }
    }
    around
}

/// What a typist may have meant that lies by `shift` from what is typed, within `near`: the closest, and of those that are
/// as close the commonest slip. `None` where no slip does.
fn meant(typed: &str, shift: f64, near: f64) -> Option<(String, &'static str)> {
    let value: f64 = typed.parse().ok()?;
    let target = value + shift;
    let all = alternatives(typed, value);
    let off = |(text, what): (String, &'static str)| {
        let own = text.parse::<f64>().ok().filter(|own| *own != value)?;
        Some(((own - target).abs(), text, what)).filter(|(off, ..)| *off <= near)
    };
    // The first of equals.
    let (_, text, what) = all.into_iter().filter_map(off).min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((text, what))
}

/// Numbers that one slip makes into what is typed, the commonest slips first.
fn alternatives(typed: &str, value: f64) -> Vec<(String, &'static str)> {
    let digits: Vec<char> = typed.chars().collect();
    let is_digit = |i: usize| digits.get(i).is_some_and(char::is_ascii_digit);
    let mut all = Vec::new();
    for i in 0..digits.len() {
        if is_digit(i) && is_digit(i + 1) && digits[i] != digits[i + 1] {
            let mut swapped = digits.clone();
            swapped.swap(i, i + 1);
            // Nobody means 01.840.
            if swapped[0] == '0' && swapped.get(1).is_some_and(char::is_ascii_digit) {
                continue;
            }
            all.push((swapped.iter().collect(), "two digits stand in the wrong order"));
        }
    }
    let point = typed.find('.').unwrap_or(digits.len());
    for i in (0..=digits.len()).filter(|i| is_digit(*i) || (*i > 0 && is_digit(i - 1))) {
        let mut longer = digits.clone();
        longer.insert(i, '0');
        // A zero behind the last decimal says nothing.
        if i <= point || i < digits.len() {
            all.push((longer.iter().collect(), "a zero is lost"));
        }
    }
    for i in 0..digits.len() {
        if is_digit(i) && i > 0 && digits[i] == digits[i - 1] {
            let mut shorter = digits.clone();
            shorter.remove(i);
            all.push((shorter.iter().collect(), "a digit was typed twice"));
        }
    }
    let factors = [
        (0.1, "the decimal point is off by one place"),
        (10.0, "the decimal point is off by one place"),
        (0.01, "the decimal point is off by two places"),
        (100.0, "the decimal point is off by two places"),
        (0.001, "it is a thousand times too large, as mm in place of m or um in place of mm"),
        (1000.0, "it is a thousand times too small, as m in place of mm or mm in place of um"),
        (25.4, "it is in inches where the others are in mm"),
        (1.0 / 25.4, "it is in mm where the others are in inches"),
        (-1.0, "its sign is wrong"),
    ];
    all.extend(factors.map(|(factor, what)| (format!("{:.12e}", factor * value), what)));
    if !typed.contains('.') {
        for i in (1..digits.len()).filter(|i| is_digit(*i) && is_digit(i - 1)) {
            let mut parted = digits.clone();
            parted.insert(i, '.');
            all.push((parted.iter().collect(), "the decimal point is missing"));
        }
    }
    let plain = |(text, what): (String, &'static str)| {
        let is_plain = !text.contains('e');
        (if is_plain { text } else { text.parse::<f64>().map_or(text, |own| own.to_string()) }, what)
    };
    all.into_iter().map(plain).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_meant_is_one_slip_away() {
        for (typed, truth, what) in [
            ("36.23", 36.023, "a zero is lost"),
            ("36.203", 36.023, "two digits stand in the wrong order"),
            ("360.23", 36.023, "the decimal point is off by one place"),
            ("36023", 36.023, "it is a thousand times too large, as mm in place of m or um in place of mm"),
            ("1.4182", 36.023, "it is in inches where the others are in mm"),
            ("366.023", 36.023, "a digit was typed twice"),
            ("-5.2", 5.2, "its sign is wrong"),
            ("360230", 36.023, "the decimal point is missing"),
        ] {
            let value: f64 = typed.parse().unwrap();
            let (meant, told) = meant(typed, truth - value, 0.002).unwrap();
            assert_eq!(told, what, "{typed}");
            assert!((meant.parse::<f64>().unwrap() - truth).abs() < 0.002, "{typed}: {meant}");
        }
        assert_eq!(meant("36.41", -0.387, 0.002), None);
    }
}
