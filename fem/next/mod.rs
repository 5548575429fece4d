//! The next part of a machine, from its own history: which offset to set and what to expect of it, what to measure next, when to
//! change the insert.
//!
//! What the model of the job knows of a part (wear, warmth, pauses, a new insert, force that feeds back) is the mean of a filter
//! that learns from every reading what the model does not know: values that are known roughly, the zero of the set-up and how it
//! wanders, a profile that no law makes. What shops do instead stands beside it, tuned on the same history in hindsight.

mod ahead;
mod entry;
mod filter;
mod history;
mod line;
mod read;
mod record;
mod rivals;
mod sizes;
mod tuning;
mod visit;
mod when;

use nalgebra::DVector;

pub use entry::Entries;
pub use filter::Suspect;
pub use history::{History, Job, Measured, Part};
pub use rivals::Rival;
pub use when::{Insert, Measure};

use crate::compare::rms;
use crate::process::Failure;
use crate::progress::Progress;
use ahead::{Ahead, LEAST};
use filter::{State, run};
use line::{Layout, Line};
use sizes::Sizes;
use when::HALF;

/// A commented log to start from.
pub const STARTING: &str = include_str!("new.toml");

/// How far values may move, in their standard uncertainties, before the model is asked anew.
const MOVED: f64 = 0.5;
/// Fewest parts on which the model is held against what shops do, and how sure a difference must be, in standard deviations.
const FEWEST: usize = 8;
const SURE: f64 = 2.0;

/// What is known of the next part. SI.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Next {
    /// The part, with the offset that is advised.
    pub part: Part,
    /// The offset of the part before.
    pub before: f64,
    /// Places over which means are taken, m: those that are measured; some of the whole contour, where none is yet.
    pub places: Vec<f64>,
    /// Expected mean error of the part there, and the interval that holds it with 95 %.
    pub expected: f64,
    pub interval: [f64; 2],
    /// Where the drawing has it.
    pub aim: f64,
    /// Probability that the part is within all that the drawing asks.
    pub probability: Option<f64>,
    /// What to measure next.
    pub measure: Measure,
    /// When to change the insert.
    pub insert: Insert,
    /// Standard uncertainty of a reading, as it was stated or found.
    pub noise: f64,
    /// Parts that were measured.
    pub measured: usize,
    /// Their numbers.
    pub numbers: Vec<usize>,
    /// Parts that stand far off: the number, by how much, and whether something changed there.
    pub suspects: Vec<(usize, Suspect)>,
    /// Mean error that would have been left of each measured part, from the second on, one part ahead.
    pub left: Vec<f64>,
    /// The same of what shops do instead.
    pub rivals: Vec<Rival>,
    /// Which of these was better beyond chance, and whose offset is advised.
    pub better: Option<usize>,
}

/// What is known of the next part, which is planned so; its offset is found, unless it is fixed.
///
/// # Errors
/// A model cannot be computed.
pub fn next(history: &History, plan: &Part, progress: &Progress) -> Result<Next, Failure> {
    let layout = Layout::of(history);
    let none = DVector::zeros(layout.values().len());
    let first = progress.stretch("history", || Line::new(history, layout.clone(), none))?;
    let told = progress.stretch("one part ahead", || record::told(&first));
    let numbers = first.steps.iter().filter(|step| !step.readings.is_empty()).map(|step| step.part.number).collect();
    let (line, sizes, state, suspects) = progress.stretch("state of the machine", || known(history, first))?;
    let mut ahead = Ahead::new(history, plan, &line, (&state, &sizes), None)?;
    let rivals = rivals::of(&line, (history.jobs[plan.job].commanded.gain, ahead.answer()));
    let left: Vec<f64> = told.iter().skip(1).map(filter::Told::left).collect();
    let better = better(&left, &rivals);
    if let Some(own) = better {
        let offset = (rivals[own].next / LEAST).round() * LEAST;
        ahead = Ahead::new(history, plan, &line, (&state, &sizes), Some(offset))?;
    }
    let coming = &ahead.parts[0];
    let half = HALF * coming.deviation();
    let half = better.map_or(half, |own| half.max(HALF * rms(&rivals[own].left[1..])));
    let expected = coming.mean();
    Ok(Next {
        part: Part { offset: ahead.offset, ..plan.clone() },
        before: ahead.before,
        places: ahead.mean_over.clone(),
        expected,
        interval: [expected - half, expected + half],
        aim: coming.aim(),
        probability: ahead.probability(coming, coming, 0.0),
        measure: when::measure(&ahead, &sizes),
        insert: when::insert(&ahead),
        noise: noise(&line, &sizes),
        measured: told.len(),
        numbers,
        suspects: suspects.iter().map(|own| (line.steps[own.step].part.number, *own)).collect(),
        left,
        rivals,
        better,
    })
}

/// The line about the values that the history tells, sizes, and the state with which it ends.
fn known(history: &History, first: Line) -> Result<(Line, Sizes, State, Vec<Suspect>), Failure> {
    let all = first.steps.len();
    let sizes = tuning::tuned(Sizes::usual(&first), &first, all);
    let found = run(&first, &sizes, all);
    let values = first.state.of_values(&found.state.mean);
    if values.amax() < MOVED {
        return Ok((first, sizes, found.state, found.suspects));
    }
    // Where the values moved far, the model is not straight from where it was asked; where it has none there, it stays.
    match Line::new(history, first.state.clone(), values) {
        Ok(line) => {
            let found = run(&line, &sizes, all);
            Ok((line, sizes, found.state, found.suspects))
        }
        Err(_) => Ok((first, sizes, found.state, found.suspects)),
    }
}

/// Standard uncertainty of a reading.
fn noise(line: &Line, sizes: &Sizes) -> f64 {
    let all: Vec<f64> =
        line.steps.iter().flat_map(|step| &step.readings).map(|own| own.variance(sizes).sqrt()).collect();
    if all.is_empty() { sizes.of(sizes::NOISE) } else { rms(&all) }
}

/// The rival that would have left less, beyond chance: it is tuned in hindsight, and a small difference means nothing.
fn better(left: &[f64], rivals: &[Rival]) -> Option<usize> {
    let is_better = |rival: &Rival| {
        let gained: Vec<f64> =
            left.iter().zip(&rival.left[1..]).map(|(own, other)| own * own - other * other).collect();
        let count = gained.len() as f64;
        let mean = gained.iter().sum::<f64>() / count;
        let spread = gained.iter().map(|own| (own - mean).powi(2)).sum::<f64>() / (count - 1.0);
        gained.len() >= FEWEST && mean > SURE * (spread / count).sqrt()
    };
    let cost = |rival: &Rival| rms(&rival.left[1..]);
    let all = rivals.iter().enumerate().filter(|(_, rival)| is_better(rival));
    all.min_by(|a, b| cost(a.1).total_cmp(&cost(b.1))).map(|(number, _)| number)
}
