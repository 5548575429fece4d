//! Further parts that would tell more, each for one new question: another force, a cold machine, a duller edge, another
//! blank, places from end to end. What is combined is turned one part after the other.

use std::collections::BTreeSet;

use super::rows::{ANGLE, BLANK, CHANGE, COORDINATES, FORCE_OF_ROW, PART, PATH_OF_ROW, TIME_OF_ROW, X, part};
use super::setup::Setup;
use crate::process::{CandidateExperiment, Rows, Values};
use crate::units::{FORCE, LENGTH};

/// Places of an experiment on one part, at most.
const PLACES: usize = 12;
/// Parts of an experiment, at most.
const PARTS: usize = 12;
/// Long enough for tool and work to be cold again, s.
const REST: f64 = 4.0 * 3600.0;
/// Forces of that of the model: over a wide range a contact bends off from a spring.
const FORCES: [f64; 3] = [0.25, 0.5, 1.5];
/// Logarithm of the ratio of two forces that are hardly another.
const SAME_FORCE: f64 = 0.15;
/// Parts between the batch and one that shows how wear goes on, as a share of the batch, and at most.
const LATER: (f64, usize) = (0.5, 20);
/// Stock of an uneven blank in depths of the cut.
const STOCKS: [f64; 2] = [0.5, 1.6];

/// The experiments beside these rows.
pub fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
    let next = Next { setup, like: rows, places: measured_places(rows), number: setup.schedule.parts + 1 };
    let mut experiments: Vec<CandidateExperiment> =
        new_forces(setup.nominal_force(0.5 * setup.length()), &levels(setup, rows))
            .into_iter()
            .map(|force| next.at_force(force))
            .collect();
    experiments.push(next.after_a_rest());
    experiments.push(next.later());
    experiments.extend(next.others_of_the_batch());
    experiments.extend(STOCKS.map(|depths| next.of_a_blank(2.0 * depths * setup.cut.depth)));
    experiments.push(next.end_to_end());
    experiments
}

/// Two experiments, the parts of the second turned after those of the first; a machine rests last. `None` where a part
/// would need a blank of which nobody knows how it is left by earlier passes.
pub fn in_sequence(
    setup: &Setup,
    one: &CandidateExperiment,
    other: &CandidateExperiment,
) -> Option<CandidateExperiment> {
    let has = |own: &CandidateExperiment, column: usize| own.rows.columns[column].iter().any(|value| !value.is_nan());
    let (one, mut other) = if has(one, TIME_OF_ROW) { (other, one.clone()) } else { (one, other.clone()) };
    let batch = setup.schedule.parts;
    let last = one.rows.columns[PART].iter().copied().fold(batch as f64, f64::max) as usize;
    let later = setup.schedule.start(last + 1) - setup.schedule.start(batch + 1);
    for row in 0..other.rows.len() {
        let [number, time] = [PART, TIME_OF_ROW].map(|column| other.rows.columns[column][row]);
        if number > batch as f64 {
            other.rows.columns[PART].set(row, number + (last - batch) as f64);
            other.rows.columns[TIME_OF_ROW].set(row, time + later);
        }
    }
    other.raises = other.raises.map(|(path, count)| (path, count + last - batch));
    let is_unknown = has(one, BLANK) != has(&other, BLANK) && !(setup.passes.is_empty() && setup.blank.is_round());
    (!is_unknown).then(|| one.then(&other))
}

/// The part after the batch.
struct Next<'r> {
    setup: &'r Setup,
    like: &'r Rows,
    places: Vec<f64>,
    number: usize,
}

impl Next<'_> {
    fn at_force(&self, force: f64) -> CandidateExperiment {
        let words = format!("turn another part with a radial force of {:.0}", FORCE.shown(force));
        let rows = self.at(&self.places, self.number, &[(FORCE_OF_ROW, force)]);
        self.turned(CandidateExperiment::new(words, &COORDINATES[FORCE_OF_ROW], vec![force], rows), 1)
    }

    fn after_a_rest(&self) -> CandidateExperiment {
        let time = |x: f64| self.setup.schedule.time(self.number, x) + REST;
        let mut rows = self.at(&self.places, self.number, &[]);
        rows.columns[TIME_OF_ROW] = self.places.iter().map(|x| time(*x)).collect();
        let words = "let the machine rest for four hours and turn another part";
        let begun = vec![time(self.setup.schedule.pass.from)];
        let rested = self.turned(CandidateExperiment::new(words, &COORDINATES[TIME_OF_ROW], begun, rows), 1);
        let duration = rested.duration + REST;
        rested.taking(duration)
    }

    fn later(&self) -> CandidateExperiment {
        let more = ((self.setup.schedule.parts as f64 * LATER.0).ceil() as usize).min(LATER.1);
        let rows = self.at(&self.places, self.number + more, &[]);
        let path = self.setup.schedule.path(self.number + more, self.setup.schedule.pass.to);
        let words = format!("turn {} parts more and measure the last", more + 1);
        self.turned(CandidateExperiment::new(words, &COORDINATES[PATH_OF_ROW], vec![path], rows), more + 1)
    }

    fn others_of_the_batch(&self) -> Option<CandidateExperiment> {
        let measured: BTreeSet<usize> = (0..self.like.len()).map(|r| part(self.like, r)).collect();
        let missed: Vec<usize> = (1..self.number).filter(|p| !measured.contains(p)).take(PARTS).collect();
        let rows = missed.iter().map(|p| self.at(&self.places, *p, &[])).reduce(|a, b| a.and(&b))?;
        let numbers: Vec<f64> = missed.iter().map(|p| *p as f64).collect();
        Some(CandidateExperiment::new("measure the other parts of the batch too", &COORDINATES[PART], numbers, rows))
    }

    fn of_a_blank(&self, stock: f64) -> CandidateExperiment {
        let words =
            format!("turn a part from a blank that is {:.2} larger than its finished diameter", LENGTH.shown(stock));
        let mut rows = self.at(&self.places, self.number, &[]);
        rows.columns[BLANK] = self.places.iter().map(|x| self.setup.diameter(*x) + stock).collect();
        self.turned(CandidateExperiment::new(words, &COORDINATES[BLANK], vec![stock], rows), 1)
    }

    fn end_to_end(&self) -> CandidateExperiment {
        let length = self.setup.length();
        let fine: Vec<f64> = (0..PLACES).map(|i| length * (0.01 + 0.98 * i as f64 / (PLACES - 1) as f64)).collect();
        let last = (0..self.like.len()).map(|r| part(self.like, r)).max().unwrap_or(1);
        let rows = self.at(&fine, last, &[]);
        let words = format!("measure a part at {PLACES} places from end to end");
        CandidateExperiment::new(words, &COORDINATES[X], fine, rows)
    }

    /// An experiment for which so many parts are turned after the batch.
    fn turned(&self, experiment: CandidateExperiment, parts: usize) -> CandidateExperiment {
        let raises = Some(("batch.parts", self.number - 1 + parts));
        CandidateExperiment { raises, ..experiment.taking(parts as f64 * self.setup.schedule.cycle_time) }
    }

    /// Rows of one part at places, with some coordinates set.
    fn at(&self, places: &[f64], part: usize, changes: &[(usize, f64)]) -> Rows {
        let mut columns = vec![Values::shared(f64::NAN, places.len()); self.like.columns.len()];
        columns[X] = places.to_vec().into();
        columns[PART].fill(part as f64);
        [ANGLE, CHANGE].into_iter().for_each(|column| columns[column].fill(0.0));
        for &(column, value) in changes {
            columns[column].fill(value);
        }
        let observable = self.like.observable.first().copied().unwrap_or(0);
        Rows { columns, observable: Values::shared(observable, places.len()) }
    }
}

/// The places that are measured, or some of them.
fn measured_places(rows: &Rows) -> Vec<f64> {
    let mut all: Vec<f64> = (0..rows.len()).filter_map(|r| rows.get(X, r)).collect();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    let step = all.len().div_ceil(PLACES).max(1);
    all.into_iter().step_by(step).collect()
}

/// The forces at which parts were turned, rising.
fn levels(setup: &Setup, rows: &Rows) -> Vec<f64> {
    let x = |r| rows.get(X, r).unwrap_or(0.0);
    let force = |r| rows.get(FORCE_OF_ROW, r).unwrap_or_else(|| setup.nominal_force(x(r)));
    let mut all: Vec<f64> = (0..rows.len()).map(force).collect();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    all
}

/// Forces away from those at which parts were turned: of the model's own, and the middle of the widest gap.
fn new_forces(nominal: f64, levels: &[f64]) -> Vec<f64> {
    let is_new = |force: &f64| *force > 0.0 && levels.iter().all(|own| (own / force).ln().abs() > SAME_FORCE);
    let gap = levels.windows(2).max_by(|a, b| (a[1] / a[0]).total_cmp(&(b[1] / b[0])));
    let middle = gap.filter(|g| g[0] > 0.0).map(|g| (g[0] * g[1]).sqrt());
    FORCES.map(|of| of * nominal).into_iter().chain(middle).filter(is_new).collect()
}
