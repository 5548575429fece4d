//! The parts to come, as the model and the state of the machine let expect them.

use nalgebra::{DMatrix, DVector};

use super::filter::State;
use super::history::{History, Part};
use super::line::{Events, Line};
use super::sizes::Sizes;
use super::visit::Visit;
use crate::budget::{Law, Stream};
use crate::process::{Failure, Rows, Standing, System};

/// Places of a part at which it is looked at.
const PLACES: usize = 25;
/// How far ahead it is looked, in parts behind the next.
pub const AHEAD: [usize; 20] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20, 24, 28, 33, 39, 46, 54];
/// Change of the offset by which the answer of the machine is found, m, and the least one that is advised.
const TRIED: f64 = 2e-6;
pub const LEAST: f64 = 1e-7;
/// Draws of a part, and their seed.
const DRAWS: usize = 400;
const SEED: u64 = 1;
/// Half-field of a normal law in standard deviations.
const FIELD: f64 = 3.0;

/// Parts to come.
pub struct Ahead<'h> {
    visit: Visit<'h>,
    /// Places that are looked at, m, those that are measured last.
    pub places: Vec<f64>,
    /// Places over which means are taken, m: those that are measured, or all.
    pub mean_over: Vec<f64>,
    /// Each of the parts, in the order of [`AHEAD`].
    pub parts: Vec<Coming>,
    /// The first part that the insert cut in this visit, as if it were made in the state of the next.
    pub sharp: Coming,
    /// The offset of all of them, m, and that before.
    pub offset: f64,
    pub before: f64,
}

/// A part to come.
pub struct Coming {
    /// Its number.
    pub number: usize,
    /// Expected errors at the places in the state zero, SI.
    expected: DVector<f64>,
    /// How these depend on the state, a row a place.
    slopes: DMatrix<f64>,
    /// How much of a change of the offset each shows.
    answers: DVector<f64>,
    /// Where the drawing has them.
    aims: DVector<f64>,
    /// First of the places over which means are taken.
    over: usize,
    rows: Rows,
    /// The state of the machine if nothing is measured until then.
    pub state: State,
}

impl<'h> Ahead<'h> {
    /// The parts from a planned one on, after a line has left the machine in a state, with the offset by which the next part is
    /// to come out in the middle.
    ///
    /// # Errors
    /// The model cannot be computed.
    pub fn new(
        history: &'h History,
        plan: &Part,
        line: &Line,
        (state, sizes): (&State, &Sizes),
        fixed: Option<f64>,
    ) -> Result<Self, Failure> {
        let last = line.steps.last().map(|step| &step.part);
        let numbers: Vec<usize> = AHEAD.iter().map(|further| plan.number + further).collect();
        let (visit, sharp) = visit(history, plan, line, numbers[numbers.len() - 1])?;
        let mut places = places(line.state.ends(plan.job));
        let measured = measured(line, plan.job);
        let over = if measured.is_empty() { 0 } else { places.len() };
        places.extend(measured);
        let mean_over = places[over..].to_vec();
        let rows = visit.rows(&[&numbers[..], &[sharp]].concat(), &places);
        let away = line.state.away(history, plan.job, &line.about);
        let before = last.map_or(0.0, |own| own.offset);
        let shown = visit.shown(&rows, &away, Some(before))?;
        let tried = visit.values(&rows, &away, |_| before + TRIED)?;
        let aims = visit.model().system.aims(&visit.local(&rows));
        let count = places.len();
        let coming = |own: usize, number: usize, state: State| {
            let own: Vec<usize> = (own * count..(own + 1) * count).collect();
            let of = |row: &usize| {
                line.state.slopes(plan.job, places[row % count], shown.slopes.iter().map(|all| all[*row]))
            };
            let slopes: Vec<DVector<f64>> = own.iter().map(of).collect();
            let all = |value: &dyn Fn(usize) -> f64| DVector::from_iterator(count, own.iter().map(|row| value(*row)));
            let about = |row: usize| line.state.of_values(&slopes[row % count]).dot(&line.about);
            Coming {
                number,
                expected: all(&|row| shown.values[row] - about(row)),
                answers: all(&|row| (tried[row] - shown.values[row]) / TRIED),
                aims: all(&|row| aims[row]),
                slopes: DMatrix::from_fn(count, line.state.len(), |i, j| slopes[i][j]),
                over,
                rows: rows.some(&own),
                state,
            }
        };
        let mut now = state.clone();
        let (mut parts, mut from) = (Vec::new(), last.map_or(plan.number, |own| own.number));
        for (own, number) in numbers.iter().enumerate() {
            let events = if own == 0 { Events::between(last, plan) } else { Events::default() };
            now.advance(number - from, events, sizes);
            from = *number;
            parts.push(coming(own, *number, now.clone()));
        }
        let sharp = coming(numbers.len(), sharp, parts[0].state.clone());
        let mut ahead = Self { visit, places, mean_over, parts, sharp, offset: before, before };
        let needed =
            fixed.unwrap_or_else(|| ((before - ahead.parts[0].off() / ahead.answer()) / LEAST).round() * LEAST);
        ahead.shift(needed, &rows, (&shown.values, &away))?;
        Ok(ahead)
    }

    /// Sets another offset, which the model answers.
    fn shift(&mut self, offset: f64, rows: &Rows, (was, away): (&[f64], &[f64])) -> Result<(), Failure> {
        let now = self.visit.values(rows, away, |_| offset)?;
        let all = self.parts.iter_mut().chain([&mut self.sharp]).flat_map(|part| part.expected.iter_mut());
        all.zip(now.iter().zip(was)).for_each(|(value, (now, was))| *value += now - was);
        self.offset = offset;
        Ok(())
    }

    /// How much of a change of the offset the mean of the next part shows.
    pub fn answer(&self) -> f64 {
        let next = &self.parts[0];
        next.mean_of(&next.answers)
    }

    /// The system that makes them.
    pub fn system(&self) -> &dyn System {
        &*self.visit.model().system
    }

    /// Probability that a part is within all that the drawing asks if it is known as well as another one, with the offset shifted
    /// by so much; `None` where the drawing asks nothing.
    pub fn probability(&self, part: &Coming, known: &Coming, shifted: f64) -> Option<f64> {
        if self.system().requirements().is_empty() {
            return None;
        }
        let rows = self.visit.local(&part.rows);
        let mean = &part.expected + &part.slopes * &part.state.mean + &part.answers * shifted;
        let mut covariance = &known.slopes * &known.state.covariance * known.slopes.transpose();
        let small = 1e-9 * covariance.diagonal().max();
        (0..covariance.nrows()).for_each(|i| covariance[(i, i)] += small);
        let root = covariance.cholesky()?.unpack();
        let is_within = |number: &usize| {
            let stream = Stream::new(SEED, *number as u64);
            let drawn = DVector::from_fn(mean.len(), |i, _| FIELD * Law::Normal.draw(&stream, i as u32, 0));
            let made: Vec<f64> = (&mean + &root * drawn).iter().copied().collect();
            Standing::all(self.system(), &rows, &made).iter().all(|own| own.out().next().is_none())
        };
        let within = (0..DRAWS).filter(is_within).count();
        Some(within as f64 / DRAWS as f64)
    }
}

impl Coming {
    fn mean_of(&self, values: &DVector<f64>) -> f64 {
        values.rows_range(self.over..).mean()
    }

    /// How the mean of its errors depends on the state.
    pub fn of_mean(&self) -> DVector<f64> {
        self.slopes.rows_range(self.over..).row_mean().transpose()
    }

    /// How its error at a place, by its position, depends on the state.
    pub fn of_place(&self, place: usize) -> DVector<f64> {
        self.slopes.row(place).transpose()
    }

    /// The mean of its errors, SI.
    pub fn mean(&self) -> f64 {
        self.mean_of(&self.expected) + self.of_mean().dot(&self.state.mean)
    }

    /// The mean of where the drawing has them, SI.
    pub fn aim(&self) -> f64 {
        self.mean_of(&self.aims)
    }

    /// By how much the mean is off.
    pub fn off(&self) -> f64 {
        self.mean() - self.aim()
    }

    /// Standard deviation of the mean, SI.
    pub fn deviation(&self) -> f64 {
        self.state.variance(&self.of_mean()).sqrt()
    }
}

/// The visit to which a planned part belongs, up to the part numbered `end`, and the first part in it that its insert cuts.
fn visit<'h>(history: &'h History, plan: &Part, line: &Line, end: usize) -> Result<(Visit<'h>, usize), Failure> {
    let visited = line.last_visit().map(|step| &step.part).filter(|first| first.job == plan.job);
    let first = visited.unwrap_or(plan);
    let last = line.steps.last().map_or(0, |step| step.part.number);
    let own = line.steps.iter().map(|step| &step.part);
    let own = own.filter(|part| part.number >= first.number && part.insert == plan.insert);
    let sharp = own.map(|part| part.number).min().unwrap_or(plan.number);
    Ok((Visit::new(history, first, last, end, plan)?, sharp))
}

/// Places that were measured on parts of a job, at most as many as are looked at anyway.
fn measured(line: &Line, job: usize) -> Vec<f64> {
    let own = line.steps.iter().filter(|step| step.part.job == job);
    let mut all: Vec<f64> = own.flat_map(|step| step.readings.iter().map(|own| own.place)).collect();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    let each = all.len().div_ceil(PLACES).max(1);
    all.into_iter().step_by(each).collect()
}

/// Places that are looked at.
fn places((low, high): (f64, f64)) -> Vec<f64> {
    let last = (PLACES - 1) as f64;
    (0..PLACES).map(|i| low + (high - low) * i as f64 / last).collect()
}
