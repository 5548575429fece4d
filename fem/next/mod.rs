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
mod visit;

use nalgebra::DVector;

pub use entry::Entries;
pub use filter::Suspect;
pub use history::{History, Job, Measured, Part};
pub use rivals::Rival;

use crate::compare::rms;
use crate::process::Failure;
use crate::progress::Progress;
use ahead::{Ahead, Coming, LEAST};
use filter::{State, run};
use line::{Layout, Line};
use sizes::Sizes;

/// A commented log to start from.
pub const STARTING: &str = include_str!("new.toml");

/// Half of an interval that holds 95 %, in standard deviations.
const HALF: f64 = 1.96;
/// Probability of being in tolerance that is asked for.
const WANTED: f64 = 0.95;
/// How much wider than that of the next part the interval of a later one may be.
const WIDER: f64 = 1.5;
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
    /// Expected mean error along the part, and the interval that holds it with 95 %.
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
    /// Parts that stand far off: the number, by how much, and whether something changed there.
    pub suspects: Vec<(usize, Suspect)>,
    /// Mean error that would have been left of each measured part, from the second on, one part ahead.
    pub left: Vec<f64>,
    /// The same of what shops do instead.
    pub rivals: Vec<Rival>,
    /// Which of these was better beyond chance, and whose offset is advised.
    pub better: Option<usize>,
}

/// What to measure next.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// On which part.
    pub part: usize,
    /// Where, m.
    pub place: f64,
    /// Half of the interval of the mean of the part after it: if nothing is measured, if that is, and if it is measured at the
    /// place that tells the least.
    pub halves: [f64; 3],
    /// Why not later: the probability of being in tolerance falls below what is wanted; else the interval has grown too wide.
    pub is_for_tolerance: bool,
}

/// When to change the insert.
#[derive(Clone, Debug, PartialEq)]
pub struct Insert {
    /// After which part, if the model lets expect that parts come out of tolerance later on whatever the offset.
    pub after: Option<usize>,
    /// The last part that was looked at.
    pub looked: usize,
    /// By how much the diameter has grown by then since the insert was new, SI.
    pub growth: f64,
    /// Whether the drawing asks for anything.
    pub is_asked: bool,
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
    let (line, sizes, state, suspects) = progress.stretch("state of the machine", || known(history, first))?;
    let ahead = Ahead::new(history, plan, &line, (&state, &sizes), None)?;
    let parts = rivals::uncorrected(&line, ahead.answer());
    let gain = history.jobs[plan.job].commanded.gain;
    let begun = line.steps.first().map_or(0.0, |step| step.part.offset);
    let rivals = match parts.is_empty() {
        true => Vec::new(),
        false => rivals::rivals(&parts, begun, (gain, ahead.answer())),
    };
    let left: Vec<f64> = told.iter().skip(1).map(filter::Told::left).collect();
    let better = better(&left, &rivals);
    let ahead = match better {
        Some(own) => {
            let offset = (rivals[own].next / LEAST).round() * LEAST;
            Ahead::new(history, plan, &line, (&state, &sizes), Some(offset))?
        }
        None => ahead,
    };
    let coming = &ahead.parts[0];
    let half = HALF * coming.deviation();
    let half = better.map_or(half, |own| half.max(HALF * rms(&rivals[own].left[1..])));
    let expected = coming.mean();
    Ok(Next {
        part: Part { offset: ahead.offset, ..plan.clone() },
        before: ahead.before,
        expected,
        interval: [expected - half, expected + half],
        aim: coming.aim(),
        probability: ahead.probability(coming, coming, 0.0),
        measure: measure(&ahead, &sizes),
        insert: insert(&ahead),
        noise: noise(&line, &sizes),
        measured: told.len(),
        suspects: suspects.iter().map(|own| (line.steps[own.step].part.number, *own)).collect(),
        left,
        rivals,
        better,
    })
}

/// The line about the values that the history tells, sizes, and the state with which it ends.
fn known(history: &History, first: Line) -> Result<(Line, Sizes, State, Vec<Suspect>), Failure> {
    let all = first.steps.len();
    let sizes = Sizes::usual(&first).tuned(&first, all);
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
        let gained: Vec<f64> = left.iter().zip(&rival.left[1..]).map(|(own, other)| own * own - other * other).collect();
        let count = gained.len() as f64;
        let mean = gained.iter().sum::<f64>() / count;
        let spread = gained.iter().map(|own| (own - mean).powi(2)).sum::<f64>() / (count - 1.0);
        gained.len() >= FEWEST && mean > SURE * (spread / count).sqrt()
    };
    let cost = |rival: &Rival| rms(&rival.left[1..]);
    let all = rivals.iter().enumerate().filter(|(_, rival)| is_better(rival));
    all.min_by(|a, b| cost(a.1).total_cmp(&cost(b.1))).map(|(number, _)| number)
}

/// Which part to measure next at the latest, and where.
fn measure(ahead: &Ahead, sizes: &Sizes) -> Measure {
    let wide = WIDER * ahead.parts[0].deviation();
    let is_doubtful = |part: &Coming| ahead.probability(part, part, 0.0).is_some_and(|p| p < WANTED);
    let first = ahead.parts.iter().position(|part| part.deviation() > wide || is_doubtful(part));
    let first = first.unwrap_or(ahead.parts.len() - 1);
    let part = &ahead.parts[first.saturating_sub(1)];
    let noise = sizes.of(sizes::NOISE).powi(2);
    // The part after it is told by what is known of this one, but for its own scatter.
    let half = |covariance| {
        let mut own = State { mean: part.state.mean.clone(), covariance };
        own.advance(1, line::Events::default(), sizes);
        HALF * own.variance(&part.of_mean()).sqrt()
    };
    let halves: Vec<f64> =
        (0..ahead.places.len()).map(|place| half(part.state.after(&part.of_place(place), noise))).collect();
    let (mut best, mut worst) = (0, 0);
    for place in 0..halves.len() {
        if halves[place] < halves[best] {
            best = place;
        }
        if halves[place] > halves[worst] {
            worst = place;
        }
    }
    Measure {
        part: part.number,
        place: ahead.places[best],
        halves: [half(part.state.covariance.clone()), halves[best], halves[worst]],
        is_for_tolerance: is_doubtful(&ahead.parts[first]),
    }
}

/// The part after which no offset keeps parts in tolerance any more, if it does so now. Parts to come will be known as well as the
/// next one is, for they are measured too.
fn insert(ahead: &Ahead) -> Insert {
    let next = &ahead.parts[0];
    let is_kept = |part: &Coming| {
        let middle = -part.off() / ahead.answer();
        ahead.probability(part, next, middle).is_some_and(|p| p >= WANTED)
    };
    let last = &ahead.parts[ahead.parts.len() - 1];
    let after = match is_kept(next) {
        true => ahead.parts.iter().position(|part| !is_kept(part)).map(|out| &ahead.parts[out - 1]),
        false => None,
    };
    Insert {
        after: after.map(|part| part.number),
        looked: last.number,
        growth: after.unwrap_or(last).mean() - ahead.sharp.mean(),
        is_asked: !ahead.system().requirements().is_empty(),
    }
}
