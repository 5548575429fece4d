//! Evidence for effects of the measurement: residuals of a model, and the groups and curves to seek in them.

use std::sync::OnceLock;

use nalgebra::DMatrix;

use super::Noise;
use super::scan::Scan;
use super::term::{Acts, Along, Term};
use crate::measure::{FILE, Measurements, Repeats};
use crate::process::{Absent, Holds, Process};
use crate::units::{ANGLE, LENGTH, TIME};

/// Fall of −2 ln L, beyond its price, from which a term is suspected, and worth a search.
pub const PROMISING: f64 = 6.0;
/// Most groups whose zeros are sought.
const LEVELS: usize = 200;
/// Fewest places that make a curve.
const LEAST_PLACES: usize = 4;
/// Most sensors at places of their own.
const MOST_SENSORS: usize = 16;

/// Residuals of a model with the noise by which they are judged.
pub struct Evidence<'a> {
    /// The process.
    pub process: &'a dyn Process,
    /// Rows.
    pub measurements: &'a Measurements,
    /// Values of the rows as they were read, SI.
    pub as_read: &'a [f64],
    /// Noise, with the terms that are known to be at work.
    pub noise: &'a Noise,
    /// Repeats of the rows, whatever the terms.
    pub repeats: &'a Repeats,
    /// Residuals of all rows, SI.
    pub residuals: &'a [f64],
    /// Derivatives of the prediction by what was fitted, and datum directions.
    pub mean: &'a DMatrix<f64>,
    /// Made where it is first asked for.
    pub scan: OnceLock<Scan<'a>>,
}

impl<'a> Evidence<'a> {
    /// The residuals, whitened, for columns to be tried on.
    pub fn scan(&self) -> &Scan<'a> {
        self.scan.get_or_init(|| Scan::new(self.measurements, self.noise, self.residuals, self.mean))
    }

    /// The terms at work and one more.
    pub fn and(&self, term: Term) -> Vec<Term> {
        self.and_all(vec![term])
    }

    /// The terms at work and others.
    pub fn and_all(&self, terms: Vec<Term>) -> Vec<Term> {
        self.noise.terms.iter().cloned().chain(terms).collect()
    }

    /// A term on each observable by itself where there are several.
    pub fn each(&self, term: Term) -> impl Iterator<Item = Term> + use<> {
        own_observables(self.measurements).into_iter().map(move |observable| Term { observable, ..term.clone() })
    }

    /// The terms at work with a further one, on each observable on which it is not at work already.
    pub fn each_new(&self, term: Term) -> impl Iterator<Item = Vec<Term>> {
        self.each(term).filter(|term| !term.is_among(&self.noise.terms)).map(|term| self.and(term))
    }

    /// Whether a term that acts so is at work.
    pub fn has(&self, acts: impl Fn(Acts) -> bool) -> bool {
        self.noise.terms.iter().any(|term| acts(term.effect.acts))
    }

    /// Number of levels of some coordinates together.
    pub fn count(&self, by: &[usize]) -> usize {
        self.measurements.levels(by).into_iter().max().map_or(0, |most| most + 1)
    }

    /// Whether a coordinate tells rows apart by a name or a number, or is [`FILE`].
    pub fn is_label(&self, coordinate: usize) -> bool {
        let own = self.process.coordinates().get(coordinate);
        own.is_none_or(|c| c.repeats || (!c.is_recorded && matches!(c.holds, Holds::Number(_) | Holds::Word(_))))
    }

    /// Whether a coordinate is a time.
    pub fn is_time(&self, coordinate: usize) -> bool {
        self.process.coordinates()[coordinate].holds.kind() == Some(TIME)
    }

    /// Coordinates of the file that are quantities.
    pub fn quantities(&self) -> impl Iterator<Item = usize> {
        self.given(|holds| matches!(holds, Holds::Quantity(_)))
    }

    /// Coordinates of the file that are words.
    pub fn words(&self) -> impl Iterator<Item = usize> {
        self.given(|holds| matches!(holds, Holds::Word(_)))
    }

    fn given(&self, is: fn(&Holds) -> bool) -> impl Iterator<Item = usize> {
        let coordinates = self.process.coordinates();
        self.measurements
            .given
            .iter()
            .copied()
            .filter(move |i| !coordinates[*i].is_recorded && is(&coordinates[*i].holds))
    }

    /// Coordinates that are places, angles or times, along which things change.
    pub fn places(&self) -> impl Iterator<Item = Along> + use<'a> {
        let (measurements, coordinates) = (self.measurements, self.process.coordinates());
        measurements.given.iter().filter(|i| !coordinates[**i].is_recorded).filter_map(|i| {
            match coordinates[*i].holds {
                Holds::Quantity(kind) if [LENGTH, ANGLE, TIME].contains(&kind) => {
                    Some(Along { coordinate: *i, is_angle: kind == ANGLE })
                }
                _ => None,
            }
        })
    }

    /// Levels of what comes again: approaches, branches and places that were measured more than once, or the words alone.
    /// What differs from one to the next is no course of time, however they alternate.
    pub fn returning(&self) -> Vec<usize> {
        let places = self.quantities().filter(|i| !self.is_time(*i));
        let all: Vec<usize> = self.words().chain(places).collect();
        let is_again = self.count(&all) <= LEVELS.min(self.measurements.len() / 2);
        self.measurements.levels(&if is_again { all } else { self.words().collect() })
    }

    /// Whether a coordinate has places enough for something to change along it.
    pub fn has_places(&self, coordinate: usize) -> bool {
        self.count(&[coordinate]) >= LEAST_PLACES
    }

    /// Whether the levels of some coordinates are as many as make a curve, and few enough to be measured more than once.
    pub fn is_curve(&self, by: &[usize]) -> bool {
        (LEAST_PLACES..=LEVELS.min(self.measurements.len() / 2)).contains(&self.count(by))
    }

    /// Coordinates whose levels may each have a zero of their own: parts, runs and directions, alone and two together,
    /// and with conditions of few levels, which make a pass. What is off by the same whenever a condition comes again is
    /// the machine's: conditions alone group nothing.
    pub fn groupings(&self) -> Vec<Vec<usize>> {
        let (data, coordinates) = (self.measurements, self.process.coordinates());
        let counts = |by: &[usize]| self.count(by);
        let groups = |by: &[usize]| (2..=LEVELS.min(data.len() / 2)).contains(&counts(by));
        // What a file records beside is a condition, which is no instrument.
        let given = || data.given.iter().copied().filter(|i| !coordinates[*i].is_recorded);
        let time = given().find(|i| coordinates[*i].holds.kind() == Some(TIME));
        let is_sensor = |i: &usize| {
            // Few places at many times: a sensor stands at each.
            let few = counts(&[*i]) <= MOST_SENSORS && coordinates[*i].holds.kind() == Some(LENGTH);
            few && coordinates.iter().all(|c| !c.repeats) && time.is_some_and(|t| counts(&[t]) > counts(&[*i]))
        };
        let is_number = |i: &usize| matches!(coordinates[*i].holds, Holds::Number(_) | Holds::Word(_));
        let is_condition = |i: &usize| {
            let of_model = coordinates[*i].absent == Absent::Model && !is_number(i);
            of_model && (2..=MOST_SENSORS.min(data.len() / 8)).contains(&counts(&[*i]))
        };
        let several_files = (data.files.len() > 1).then_some(FILE);
        let numbers = given().filter(|i| is_number(i) && counts(&[*i]) > 1);
        let numbers: Vec<usize> = numbers.chain(several_files).collect();
        let conditions: Vec<usize> = given().filter(is_condition).collect();
        let pairs = numbers.iter().enumerate().flat_map(|(k, i)| numbers[k + 1..].iter().map(|j| vec![*i, *j]));
        let pass: Vec<usize> = numbers.iter().chain(&conditions).copied().collect();
        let is_pass = !conditions.is_empty() && counts(&pass) > counts(&conditions);
        // What is off by the same whenever an approach or a branch comes again is not set anew: it is the machine's.
        let returns = |i: &usize| {
            let stretches = 1 + data.levels(&[*i]).windows(2).filter(|two| two[0] != two[1]).count();
            matches!(coordinates.get(*i).map(|c| &c.holds), Some(Holds::Word(_))) && stretches > counts(&[*i])
        };
        let several = numbers.iter().filter(|i| !returns(i)).map(|i| vec![*i]).chain(pairs);
        let mut all: Vec<Vec<usize>> = given().filter(is_sensor).map(|i| vec![i]).collect();
        for by in several.chain(is_pass.then_some(pass)) {
            // What groups the rows as another does is not told twice.
            let levels = data.levels(&by);
            if groups(&by) && all.iter().all(|other| data.levels(other) != levels) {
                all.push(by);
            }
        }
        if numbers.is_empty() && all.is_empty() && time.is_some() {
            // One series has one zero.
            all.push(Vec::new());
        }
        all
    }
}

/// Observables on which a term may act: each by itself where there are several.
pub fn own_observables(measurements: &Measurements) -> Vec<Option<usize>> {
    match &measurements.observables[..] {
        [_] => vec![None],
        several => several.iter().map(|s| Some(s.position)).collect(),
    }
}
