//! Variables of laws: coordinates of the rows, columns that files record, and what the model predicts.

use std::f64::consts::TAU;

use crate::input::Name;
use crate::model::Data;
use crate::process::Holds;
use crate::units::{ANGLE, Kind, NUMBER};

use super::shape::Shape;

/// Harmonics of the periods that a model knows.
const HARMONICS: u32 = 12;
/// Part of a range within which values are the same.
const SAME: f64 = 1e-3;
/// Most levels in the place of all.
const MOST_LEVELS: usize = 64;
/// Ranges of which a known period may be, and periods that a range may have.
const MOST_RANGES: f64 = 4.0;
const MOST_PERIODS: f64 = 400.0;

/// A variable in every row.
#[derive(Clone)]
pub struct Variable {
    /// Its name in formulas.
    pub name: Name,
    /// Its kind; numbers and words are pure numbers.
    pub kind: Kind,
    /// Whether it is a word, and of how many.
    pub words: usize,
    /// Whether formulas know it as what the model predicts, which follows from the others.
    pub is_prediction: bool,
    /// Numbers of those of which it is a formula; none of one that the rows have.
    pub made_of: Vec<usize>,
    /// Its values, SI; rows of another observable have none.
    pub values: Vec<f64>,
    /// Its distinct values, rising.
    pub levels: Vec<f64>,
    /// Which of them each row has.
    pub level: Vec<usize>,
    /// A few values in the place of all, and which of them each row is near: enough to rank products.
    pub coarse: (Vec<f64>, Vec<usize>),
    /// A round size of it, SI.
    pub scale: f64,
}

/// A shape of a variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// Number of the variable.
    pub variable: usize,
    /// Number of another variable of the same unit from which it is told, where it has one.
    pub other: Option<usize>,
    /// Its shape.
    pub shape: Shape,
    /// The constants of the shape, SI.
    pub constants: Vec<f64>,
    /// Whether the constants are known, and not found.
    pub is_known: bool,
}

impl Variable {
    /// All variables of some rows that vary.
    pub fn all(data: &Data, predicted: &[f64]) -> Vec<Self> {
        let resolved = data.model.system.resolved(&data.rows);
        let coordinates = data.model.process.coordinates();
        let mut all = Vec::new();
        for (i, coordinate) in coordinates.iter().enumerate() {
            let Some(column) = resolved.columns.get(i).filter(|_| data.given.contains(&i)) else { continue };
            // Runs and set-ups that repeat each other are counted, and nothing else.
            let (kind, words) = match &coordinate.holds {
                Holds::Quantity(kind) => (*kind, 0),
                Holds::Number(_) => (NUMBER, 0),
                Holds::Word(words) => (NUMBER, words.len()),
            };
            all.extend(Self::new(coordinate.name.clone(), kind, words, column.to_vec()));
        }
        let angles: Vec<Self> = all.iter().filter(|own| own.is_angle() && own.words == 0).cloned().collect();
        for (i, one) in angles.iter().enumerate() {
            for other in &angles[i + 1..] {
                let name = format!("({} - {})", one.name, other.name);
                let values = one.values.iter().zip(&other.values).map(|(a, b)| a - b).collect();
                all.extend(Self::new(name.into(), one.kind, 0, values));
            }
        }
        for seen in &data.observables {
            let kind = data.model.process.observables()[seen.position].kind;
            let of = |(row, value): (usize, &f64)| {
                if data.rows.observable[row] == seen.position { *value } else { f64::NAN }
            };
            let own = Self::new(Name::new("prediction"), kind, 0, predicted.iter().enumerate().map(of).collect());
            let own = own.filter(|own| all.iter().all(|other: &Self| !own.follows(other)));
            all.extend(own.map(|own| Self { is_prediction: true, ..own }));
        }
        all
    }

    /// A variable of these values; `None` where they are all the same.
    pub fn new(name: Name, kind: Kind, words: usize, values: Vec<f64>) -> Option<Self> {
        let mut levels: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
        if levels.is_empty() {
            return None;
        }
        levels.sort_unstable_by(f64::total_cmp);
        let size = levels[0].abs().max(levels[levels.len() - 1].abs());
        levels.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * size);
        let is_varied = levels.len() > 1 && levels[levels.len() - 1] - levels[0] > 1e-9 * size;
        let scale = round(kind, (levels[levels.len() - 1] - levels[0]).max(1e-300));
        let near = |value: f64| {
            let after = levels.partition_point(|level| *level < value).min(levels.len() - 1);
            let is_before = after > 0 && (value - levels[after - 1]).abs() < (levels[after] - value).abs();
            if is_before { after - 1 } else { after }
        };
        let level: Vec<usize> = values.iter().map(|value| if value.is_finite() { near(*value) } else { 0 }).collect();
        let together = levels.len().div_ceil(MOST_LEVELS);
        let centre = |some: &[f64]| some.iter().sum::<f64>() / some.len() as f64;
        let coarse = (levels.chunks(together).map(centre).collect(), level.iter().map(|own| own / together).collect());
        let own = || Self {
            name,
            kind,
            words,
            is_prediction: false,
            made_of: Vec::new(),
            values,
            levels,
            level,
            coarse,
            scale,
        };
        is_varied.then(own)
    }

    /// Whether every one of these rows has it.
    pub fn is_of(&self, rows: &[usize]) -> bool {
        rows.iter().all(|row| self.values[*row].is_finite())
    }

    /// Whether it is the same in all rows of each level of another, which has few.
    fn follows(&self, other: &Self) -> bool {
        let (low, high) = self.ends();
        let mut ends = vec![(f64::INFINITY, f64::NEG_INFINITY); other.levels.len()];
        for (value, level) in self.values.iter().zip(&other.level).filter(|(value, _)| value.is_finite()) {
            ends[*level] = (ends[*level].0.min(*value), ends[*level].1.max(*value));
        }
        4 * other.levels.len() <= self.values.len()
            && ends.iter().all(|(least, most)| most - least <= SAME * (high - low))
    }

    fn is_angle(&self) -> bool {
        self.kind.canonical().dimension == ANGLE.canonical().dimension
    }

    /// Whether it goes once around a circle, where a whole number of waves runs; a piece of it is a length like any other.
    fn is_circle(&self) -> bool {
        let (low, high) = self.ends();
        self.is_angle() && (0.5 * TAU..=1.01 * TAU).contains(&(high - low))
    }

    /// Its least and its largest value.
    pub fn ends(&self) -> (f64, f64) {
        (self.levels[0], self.levels[self.levels.len() - 1])
    }

    /// The shapes in which it may enter a law, numbered as `variable`; of the scales that the model has, those of waves.
    pub fn factors(&self, variable: usize, scales: &[f64]) -> Vec<Factor> {
        let mut all = Vec::new();
        let mut add = |shape: Shape, constants: &[f64]| {
            let is_known = matches!(shape, Shape::Word);
            all.push(Factor { variable, other: None, shape, constants: constants.to_vec(), is_known });
        };
        if self.words == 2 {
            add(Shape::Sign, &[]);
        }
        if self.words > 0 {
            (0..self.words).for_each(|word| add(Shape::Word, &[word as f64]));
            return all;
        }
        let (low, high) = self.ends();
        let range = high - low;
        let inner = |count: usize| (1..=count).map(move |k| low + range * k as f64 / (count + 1) as f64);
        add(Shape::Line, &[]);
        if self.levels.len() < 3 {
            return all;
        }
        // Where zero is a convention, as of degrees Celsius, nothing goes by ratios.
        if low >= 0.0 && self.kind.canonical().offset == 0.0 {
            add(Shape::Proportional, &[]);
            for p in [0.5, 1.5, 2.0, 2.5, 3.0, 4.0] {
                add(Shape::Power(p), &[]);
            }
            [0.7, 1.25, 1.75, 2.3, 3.5].into_iter().for_each(|p| add(Shape::Exponent, &[p]));
            if low > 0.0 {
                [-2.0, -1.0, -0.5].into_iter().for_each(|p| add(Shape::Power(p), &[]));
                [-1.5, -0.7].into_iter().for_each(|p| add(Shape::Exponent, &[p]));
            }
            for part in [0.02, 0.08, 0.3, 1.0] {
                add(Shape::Logarithm, &[part * high]);
                add(Shape::Saturation, &[part * high]);
            }
            for part in [0.1, 0.2, 0.4, 0.8] {
                add(Shape::Hump, &[part * high]);
            }
            inner(9).filter(|c| *c > 0.0).for_each(|c| add(Shape::Pole, &[c]));
            for part in [1.05, 1.15, 1.3, 1.6, 2.2] {
                add(Shape::Pole, &[part * high]);
                add(Shape::Softening, &[part * high]);
            }
            for part in [0.1, 0.2, 0.35, 0.5] {
                add(Shape::Bell, &[0.0, part * high]);
            }
            for k in 1..=10 {
                let centre = low + range * (f64::from(k) / 8.0);
                [0.03, 0.1, 0.25]
                    .into_iter()
                    .filter(|_| centre > 0.0)
                    .for_each(|w| add(Shape::Resonance, &[centre, w]));
            }
        }
        add(Shape::Parabola, &[]);
        if self.levels.len() < 4 {
            return all;
        }
        inner(5).for_each(|c| add(Shape::Fourth, &[c]));
        for part in [0.06, 0.12, 0.25, 0.5, 1.0, 2.0] {
            add(Shape::Decay, &[part * range]);
            add(Shape::Relaxation, &[part * range]);
        }
        for c in inner(5) {
            for part in [0.08, 0.25] {
                add(Shape::Transition, &[c, part * range]);
                add(Shape::Bowl, &[c, part * range]);
            }
        }
        for c in inner(7) {
            [0.06, 0.12, 0.25].into_iter().for_each(|part| add(Shape::Bell, &[c, part * range]));
            [0.15, 0.3, 0.6].into_iter().for_each(|part| add(Shape::Tent, &[c, part * range]));
        }
        for c in inner(11) {
            add(Shape::Hinge, &[c]);
            add(Shape::Fall, &[c]);
        }
        let borders = self.levels.windows(2).map(|two| 0.5 * (two[0] + two[1]));
        let every = self.levels.len().div_ceil(24);
        borders.step_by(every).for_each(|c| add(Shape::Step, &[c]));
        if self.is_angle() {
            (1..=12).for_each(|k| add(Shape::Harmonic(f64::from(k)), &[]));
            (1..=6).for_each(|k| add(Shape::Lobe(f64::from(k)), &[]));
        }
        // What the model predicts goes up and down by itself.
        if self.is_prediction {
            return all;
        }
        if self.levels.len() >= 8 {
            // Two places a period are the least that show it; a step of a quarter of a period over the range.
            let most = (0.5 * (self.levels.len() - 1) as f64).min(40.0);
            let mut periods = 0.75;
            while periods <= most {
                let period = range / periods;
                periods += 0.25;
                if !self.meets(period) {
                    continue;
                }
                if !self.is_circle() {
                    add(Shape::Wave, &[period]);
                    add(Shape::Arch, &[period]);
                }
                // What rings fades within a few periods, or not at all.
                [1.5, 4.0].into_iter().for_each(|some| add(Shape::Ringing, &[period, some * period]));
            }
        }
        let known =
            |period: f64| Factor { variable, other: None, shape: Shape::Wave, constants: vec![period], is_known: true };
        let is_seen = |period: &f64| *period < MOST_RANGES * range && range < MOST_PERIODS * period;
        let periods = scales.iter().flat_map(|period| (1..=HARMONICS).map(move |h| period / f64::from(h)));
        all.extend(periods.filter(is_seen).filter(|period| self.meets(*period)).map(known));
        all
    }

    /// Whether its values meet a wave of this period at enough of its phases to tell it from a constant, and from whatever
    /// else comes again with every second or third of them.
    fn meets(&self, period: f64) -> bool {
        const FEWEST: usize = 4;
        /// Part of a turn within which two phases are one.
        const ALIKE: f64 = 0.01;
        let mut phases: Vec<f64> = Vec::new();
        for level in &self.levels {
            let phase = (level / period).rem_euclid(1.0);
            let is_other = |other: &f64| (ALIKE..=1.0 - ALIKE).contains(&(phase - other).abs());
            if phases.iter().all(is_other) {
                phases.push(phase);
            }
            if phases.len() == FEWEST {
                return true;
            }
        }
        false
    }

    /// What of it is beyond a part of another.
    pub fn excesses(&self, variable: usize, (number, other): (usize, &Self)) -> Vec<Factor> {
        let (low, high) = other.ends();
        let is_alike = self.kind.canonical().dimension == other.kind.canonical().dimension
            && self.kind.unit == other.kind.unit
            && self.kind.canonical().offset == 0.0
            && !self.kind.unit.is_empty();
        if !is_alike || low <= 0.0 || self.ends().0 < 0.0 || self.is_prediction || other.is_prediction {
            return Vec::new();
        }
        let mut ratios: Vec<f64> = self.values.iter().zip(&other.values).map(|(v, u)| v / u).collect();
        ratios.retain(|ratio| ratio.is_finite());
        ratios.sort_unstable_by(f64::total_cmp);
        if ratios.is_empty() || high <= low {
            return Vec::new();
        }
        let at = |k: usize| ratios[k * (ratios.len() - 1) / 12];
        let of = |m: f64| Factor {
            variable,
            other: Some(number),
            shape: Shape::Excess,
            constants: vec![m],
            is_known: false,
        };
        (1..12).map(at).filter(|m| *m > 0.0).map(of).collect()
    }
}

impl Factor {
    /// Numbers of the variables of which it is made.
    pub fn made_of(&self, variables: &[Variable]) -> Vec<usize> {
        match variables[self.variable].made_of.as_slice() {
            [] => std::iter::once(self.variable).chain(self.other).collect(),
            own => own.to_vec(),
        }
    }

    /// Number of its constants that are found.
    pub fn sought(&self) -> usize {
        if self.is_known { 0 } else { self.constants.len() }
    }

    /// Its functions in every row.
    pub fn columns(&self, variables: &[Variable]) -> Vec<Vec<f64>> {
        let own = &variables[self.variable];
        match self.other {
            Some(other) => {
                let of = |(v, u): (&f64, &f64)| v - self.constants[0] * u;
                let values: Vec<f64> = own.values.iter().zip(&variables[other].values).map(of).collect();
                self.at(&values, own.scale)
            }
            None => self.at(&own.values, own.scale),
        }
    }

    /// Its functions at every level of its variable.
    pub fn at_levels(&self, variables: &[Variable]) -> Vec<Vec<f64>> {
        let own = &variables[self.variable];
        self.at(&own.levels, own.scale)
    }

    /// Its functions at a few values in the place of all.
    pub fn at_some(&self, variables: &[Variable]) -> Vec<Vec<f64>> {
        let own = &variables[self.variable];
        self.at(&own.coarse.0, own.scale)
    }

    fn at(&self, values: &[f64], scale: f64) -> Vec<Vec<f64>> {
        let mut columns = vec![Vec::with_capacity(values.len()); self.shape.functions()];
        for v in values {
            let all = self.shape.at(*v, scale, &self.constants);
            columns.iter_mut().zip(all).for_each(|(column, value)| column.push(value));
        }
        columns
    }
}

/// A size of one digit in the unit of its kind, SI.
fn round(kind: Kind, si: f64) -> f64 {
    let factor = kind.canonical().factor;
    let shown = si / factor;
    let power = 10f64.powf(shown.log10().floor());
    let digits = shown / power;
    let digit = if digits < 1.5 {
        1.0
    } else if digits < 3.5 {
        2.0
    } else if digits < 7.5 {
        5.0
    } else {
        10.0
    };
    digit * power * factor
}

/// The columns of a product of factors: every function of one with every function of another.
pub fn product(factors: &[Vec<Vec<f64>>]) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = Vec::new();
    for own in factors {
        all = match all.is_empty() {
            true => own.clone(),
            false => all
                .iter()
                .flat_map(|a| own.iter().map(move |b| a.iter().zip(b).map(|(a, b)| a * b).collect()))
                .collect(),
        };
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::TIME;

    /// Readings every 40 s: what comes again every 40, 80 or 120 s is the same in all of them, in every second or third.
    #[test]
    fn a_wave_is_sought_where_readings_meet_it_at_several_phases() {
        let every = |step: f64| {
            let times = (0..97).map(|i| step * f64::from(i)).collect();
            Variable::new(Name::new("time"), TIME, 0, times).unwrap()
        };
        let periods = |own: &Variable, scales: &[f64]| -> Vec<f64> {
            let waves = own.factors(0, scales).into_iter().filter(|own| own.is_known && own.shape == Shape::Wave);
            waves.map(|own| own.constants[0]).collect()
        };
        // Of the harmonics the 4th, 8th, 6th and 12th are missing: 120, 60, 80 and 40 s.
        assert_eq!(periods(&every(40.0), &[480.0]), [1.0, 2.0, 3.0, 5.0, 7.0, 9.0, 10.0, 11.0].map(|h| 480.0 / h));
        assert_eq!(periods(&every(7.0), &[480.0]).len(), 12);
    }
}
