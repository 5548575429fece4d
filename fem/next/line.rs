//! A history as a straight line of steps, each with what the model expected of every reading.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};

use super::history::{History, Part};
use super::visit::Visit;
use crate::knowledge::Knowledge;
use crate::process::Failure;

/// Nodes of the profile that no law of the model makes, along the work.
pub const NODES: usize = 7;
/// Length over which that is alike, as a part of the work.
const ALIKE: f64 = 0.3;
/// What is added to a variance of one, so that a matrix stays positive definite.
const ROUND_OFF: f64 = 1e-8;

/// Position in the state of the machine of its zero, of that's rate, and of the scatter of a part; the values follow.
pub const ZERO: usize = 0;
pub const RATE: usize = 1;
pub const SCATTER: usize = 2;
const VALUES: usize = 3;

/// What can change between two parts, beside what the model knows of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Events {
    /// Another insert.
    pub insert: bool,
    /// Another set-up, or another job.
    pub set_up: bool,
    /// A rest of the machine.
    pub pause: bool,
}

/// A reading: what was found, what the model expected at the values about which it is linear, and how it depends on the state.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Error, SI.
    pub error: f64,
    /// Where the drawing has it, SI.
    pub aim: f64,
    /// Standard uncertainty, SI; NaN where nobody says.
    pub sigma: f64,
    /// Expected error in the state zero, SI.
    pub expected: f64,
    /// Derivatives.
    pub slopes: DVector<f64>,
    /// Place, m.
    pub place: f64,
}

/// A part of the line.
#[derive(Clone, Debug)]
pub struct Step {
    /// How it was made.
    pub part: Part,
    /// How many parts further on than the step before.
    pub further: usize,
    /// What happened since.
    pub events: Events,
    /// What was measured.
    pub readings: Vec<Reading>,
}

/// The line.
pub struct Line {
    /// The steps, by rising numbers.
    pub steps: Vec<Step>,
    /// Layout of the state.
    pub state: Layout,
    /// Values about which it is linear, job by job, in their standard uncertainties.
    pub about: DVector<f64>,
}

/// What stands where in the state.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Of each job, where its values that are known roughly stand.
    values: Vec<Vec<usize>>,
    /// How many values there are.
    count: usize,
    /// Correlations of the values.
    pub correlation: DMatrix<f64>,
    /// Of each job, the ends of its contour, m.
    ends: Vec<(f64, f64)>,
    /// Correlations of the nodes of a profile.
    pub profile: DMatrix<f64>,
}

impl Layout {
    /// The layout of a history. A value of which several jobs say the same is one of the machine.
    pub fn of(history: &History) -> Self {
        let mut known: BTreeMap<(String, u64, u64), usize> = BTreeMap::new();
        let mut values = Vec::new();
        let mut correlations = Vec::new();
        for job in &history.jobs {
            let knowledge = Knowledge::of(&job.model);
            let rough: Vec<usize> = knowledge.are_rough().enumerate().filter(|(_, is)| *is).map(|(i, _)| i).collect();
            let mut place = |i: &usize| {
                let own = &job.model.parameters[*i];
                let spread = knowledge.away(&vec![1.0; knowledge.values.len()])[*i];
                let next = known.len();
                *known.entry((own.path.to_string(), knowledge.values[*i].to_bits(), spread.to_bits())).or_insert(next)
            };
            values.push(rough.iter().map(&mut place).collect::<Vec<_>>());
            correlations.push((rough, knowledge.correlation()));
        }
        let count = known.len();
        let mut correlation = DMatrix::identity(count, count);
        for (own, (rough, all)) in values.iter().zip(&correlations) {
            for (a, i) in own.iter().zip(rough) {
                own.iter().zip(rough).for_each(|(b, j)| correlation[(*a, *b)] = all[(*i, *j)]);
            }
        }
        if (&correlation + DMatrix::identity(count, count) * ROUND_OFF).cholesky().is_none() {
            correlation = DMatrix::identity(count, count);
        }
        let ends = history.jobs.iter().map(|job| {
            let along = &job.model.system.programme().columns[job.commanded.along];
            along.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)))
        });
        let node = |i: usize| i as f64 / (NODES - 1) as f64;
        let alike = |i: usize, j: usize| {
            let own = (-0.5 * ((node(i) - node(j)) / ALIKE).powi(2)).exp();
            own + if i == j { ROUND_OFF.sqrt() } else { 0.0 }
        };
        Self { values, count, correlation, ends: ends.collect(), profile: DMatrix::from_fn(NODES, NODES, alike) }
    }

    /// Length of the state.
    pub fn len(&self) -> usize {
        self.nodes(self.values.len())
    }

    /// Where the values stand.
    pub fn values(&self) -> std::ops::Range<usize> {
        VALUES..VALUES + self.count
    }

    /// The part of a state, or of what depends on it, that belongs to the values.
    pub fn of_values(&self, of: &DVector<f64>) -> DVector<f64> {
        of.rows(VALUES, self.count).into_owned()
    }

    /// How many jobs there are.
    pub fn jobs(&self) -> usize {
        self.values.len()
    }

    /// Where the nodes of the profile of a job begin.
    pub fn nodes(&self, job: usize) -> usize {
        VALUES + self.count + NODES * job
    }

    /// Ends of the contour of a job, m.
    pub fn ends(&self, job: usize) -> (f64, f64) {
        self.ends[job]
    }

    /// How a reading of a job at a place (m) depends on the state, given its slopes with the values of the job.
    pub fn slopes(&self, job: usize, place: f64, of_values: impl Iterator<Item = f64>) -> DVector<f64> {
        let mut all = DVector::zeros(self.len());
        (all[ZERO], all[SCATTER]) = (1.0, 1.0);
        self.values[job].iter().zip(of_values).for_each(|(i, slope)| all[VALUES + i] = slope);
        let (low, high) = self.ends[job];
        let at = ((place - low) / (high - low)).clamp(0.0, 1.0) * (NODES - 1) as f64;
        let at = if at.is_finite() { at } else { 0.0 };
        let node = (at as usize).min(NODES - 2);
        all[self.nodes(job) + node] = 1.0 - (at - node as f64);
        all[self.nodes(job) + node + 1] = at - node as f64;
        all
    }

    /// Values of a job in their standard uncertainties, those that are known exactly among them, from those of the machine.
    pub fn away(&self, history: &History, job: usize, about: &DVector<f64>) -> Vec<f64> {
        let mut own = self.values[job].iter();
        let knowledge = Knowledge::of(&history.jobs[job].model);
        let mut next = || own.next().map_or(0.0, |i| about[*i]);
        knowledge.are_rough().map(|is| if is { next() } else { 0.0 }).collect()
    }
}

impl Line {
    /// The line of a history, linear about values of the machine in their standard uncertainties.
    ///
    /// # Errors
    /// A model cannot be computed.
    pub fn new(history: &History, state: Layout, about: DVector<f64>) -> Result<Self, Failure> {
        let mut steps = steps(history);
        let readings: BTreeMap<usize, Vec<(usize, usize)>> = history.numbers().collect();
        let mut begun = 0;
        while begun < steps.len() {
            let job = steps[begun].part.job;
            let length = steps[begun..].iter().take_while(|step| step.part.job == job).count();
            let own = &mut steps[begun..begun + length];
            let (first, last) = (own[0].part.clone(), own[length - 1].part.number);
            let visit = Visit::new(history, &first, last, last, &first)?;
            expect(history, (&visit, &state, &about), &readings, own)?;
            begun += length;
        }
        Ok(Self { steps, state, about })
    }

    /// The first step of the visit with which the line ends.
    pub fn last_visit(&self) -> Option<&Step> {
        let job = self.steps.last()?.part.job;
        self.steps.iter().rev().take_while(|step| step.part.job == job).last()
    }
}

/// The steps without their readings.
fn steps(history: &History) -> Vec<Step> {
    let mut numbers: Vec<usize> = history.parts.iter().map(|part| part.number).collect();
    numbers.extend(history.numbers().map(|(number, _)| number));
    numbers.sort_unstable();
    numbers.dedup();
    let mut before: Option<Part> = None;
    let step = |number: usize| {
        let part = history.part(number);
        let was = before.replace(part.clone());
        let further = was.as_ref().map_or(0, |was| number - was.number);
        Step { events: Events::between(was.as_ref(), &part), part, further, readings: Vec::new() }
    };
    numbers.into_iter().map(step).collect()
}

impl Events {
    /// What happened between two parts; the first of all is a set-up.
    pub fn between(was: Option<&Part>, part: &Part) -> Self {
        let Some(was) = was else { return Self { set_up: true, ..Self::default() } };
        Self {
            insert: was.insert != part.insert,
            set_up: was.set_up != part.set_up || was.job != part.job,
            pause: part.pause > 0.0,
        }
    }
}

/// Fills in the readings of the steps of a visit.
fn expect(
    history: &History,
    (visit, state, about): (&Visit, &Layout, &DVector<f64>),
    readings: &BTreeMap<usize, Vec<(usize, usize)>>,
    steps: &mut [Step],
) -> Result<(), Failure> {
    let own = |step: &Step| readings.get(&step.part.number).cloned().unwrap_or_default();
    let all: Vec<(usize, usize)> = steps.iter().flat_map(own).collect();
    let Some((first, _)) = all.first() else { return Ok(()) };
    let mut rows = history.measured[*first].rows.some(&[]);
    for (entry, row) in &all {
        rows = rows.and(&history.measured[*entry].rows.some(&[*row]));
    }
    let shown = visit.shown(&rows, &state.away(history, visit.job, about), None)?;
    let aims = visit.model().system.aims(&visit.local(&rows));
    let along = history.jobs[visit.job].commanded.along;
    let mut row = 0;
    for step in steps {
        for (entry, own) in readings.get(&step.part.number).into_iter().flatten() {
            let measured = &history.measured[*entry];
            let place = rows.columns[along][row];
            let slopes = state.slopes(visit.job, place, shown.slopes.iter().map(|own| own[row]));
            step.readings.push(Reading {
                error: measured.errors[*own],
                aim: aims[row],
                sigma: measured.uncertainty[*own],
                expected: shown.values[row] - state.of_values(&slopes).dot(about),
                slopes,
                place,
            });
            row += 1;
        }
    }
    Ok(())
}
