//! Slips of the pen: readings far from all that surrounds them which one slip of a typist makes of what should stand there.
//!
//! What should stand there is told by the rows themselves, without any model: along each coordinate a reading lies between
//! its neighbours, whatever law the whole follows, and the coordinate along which rows do so best is taken. A reading that is
//! far off and that no slip explains stays: it may be what was measured.

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

/// What stands around a row of one series: its expected value, and the standard deviation of that in standard deviations of
/// a row.
#[derive(Clone, Copy)]
struct Around {
    row: usize,
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
        let records = std::mem::take(&mut self.records);
        let rest = self.some(|row| all.iter().all(|(slip, _)| slip.row != row));
        Self { records, ..rest }
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
    let mut left = rows.clone();
    let mut found: Vec<Slip> = Vec::new();
    loop {
        let Some((around, scale)) = surroundings(measurements, coordinates, &left) else { return found };
        let off = |own: &Around| (measurements.observed[own.row] - own.value) / (scale * own.spread);
        let mut far: Vec<&Around> = around.iter().filter(|own| off(own).abs() > FAR).collect();
        far.sort_unstable_by(|a, b| off(b).abs().total_cmp(&off(a).abs()));
        // A slip takes its neighbours' surroundings with it: one at a time, and all are looked at anew.
        let slip = far.iter().find_map(|own| {
            let (text, factor) = typed(own.row)?;
            let shift = own.value - measurements.observed[own.row];
            let near = NEAR * scale * own.spread;
            let (meant, what) = meant(&text, shift / factor, near / factor)?;
            Some(Slip { row: own.row, typed: text, meant, what })
        });
        let Some(slip) = slip else { return found };
        left.retain(|row| *row != slip.row);
        found.push(slip);
        if found.len() as f64 > MOST_SHARE * rows.len() as f64 {
            // So many are no slips.
            return Vec::new();
        }
    }
}

/// What stands around each row along the coordinate along which rows follow each other best, and the standard deviation of
/// a row there; `None` where they follow each other along none.
fn surroundings(all: &Measurements, coordinates: &[Coordinate], rows: &[usize]) -> Option<(Vec<Around>, f64)> {
    let along = (0..coordinates.len()).filter(|i| all.given.contains(i)).filter(|i| match coordinates[*i].holds {
        Holds::Quantity(_) | Holds::Number(_) => true,
        Holds::Word(_) => false,
    });
    let one = |i: usize| {
        let around = along_one(all, rows, i);
        if 2 * around.len() < rows.len().max(2 * FEWEST) {
            return None;
        }
        let errors = around.iter().map(|own| ((all.observed[own.row] - own.value) / own.spread).abs());
        let mut errors: Vec<f64> = errors.collect();
        errors.sort_unstable_by(f64::total_cmp);
        let scale = OF_MEDIAN * errors[errors.len() / 2];
        let told = all.uncertainty.as_ref().map_or(0.0, |u| u[rows[0]]);
        let scale = scale.max(told);
        (scale > 0.0).then_some((around, scale))
    };
    along.filter_map(one).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// What stands around rows that differ in one coordinate alone, in its order.
fn along_one(all: &Measurements, rows: &[usize], coordinate: usize) -> Vec<Around> {
    let others: Vec<usize> = all.given.iter().copied().filter(|i| *i != coordinate).collect();
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
                around.push(Around { row: series[i], value, spread });
            }
        }
    }
    around
}

/// What a typist may have meant that lies by `shift` from what is typed, within `near`; `None` where no slip does, or two
/// do that mean different numbers.
fn meant(typed: &str, shift: f64, near: f64) -> Option<(String, &'static str)> {
    let value: f64 = typed.parse().ok()?;
    let target = value + shift;
    let all = alternatives(typed, value);
    let close = |(text, _): &&(String, &'static str)| {
        text.parse::<f64>().is_ok_and(|own| own != value && (own - target).abs() <= near)
    };
    let mut fitting: Vec<&(String, &'static str)> = all.iter().filter(close).collect();
    fitting.dedup_by(|a, b| a.0.parse::<f64>() == b.0.parse::<f64>());
    // The first is the commonest slip.
    fitting.first().map(|(text, what)| (text.clone(), *what))
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
        ] {
            let value: f64 = typed.parse().unwrap();
            let (meant, told) = meant(typed, truth - value, 0.002).unwrap();
            assert_eq!(told, what, "{typed}");
            assert!((meant.parse::<f64>().unwrap() - truth).abs() < 0.002, "{typed}: {meant}");
        }
        assert_eq!(meant("36.41", -0.387, 0.002), None);
    }
}
