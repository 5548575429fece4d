//! A program that carries a correction, and what it cannot carry.

use std::collections::BTreeMap;

use super::axes::{Axes, Level};
use super::codes::ASIDE;
use super::fit::{Holds, changes};
use super::plan::{Finish, Foreign, between};
use super::program::Program;
use super::sample::Sample;
use super::steps::{Centre, Shape, Step};
use super::surface::{Makers, Surface, samples};
use super::wanted::{Course, SAME, Wanted};
use super::workpiece::Workpiece;
use super::write::rewritten;
use crate::input::{InputError, Problem};

/// Shorter lengths that nothing cuts come from rounded words, m.
const SHORTEST: f64 = 0.05e-3;
/// Changes below this are none, m.
const NONE: f64 = 1e-9;

/// What a corrected program leaves of what is wanted, where it is worst.
#[derive(Clone, Debug, PartialEq)]
pub struct Left {
    /// Root mean square over the pass, m of the level.
    pub rms: f64,
    /// The worst, m of the level.
    pub worst: f64,
    /// Where that is along the part, m.
    pub x: f64,
    /// Where beside the middle of its breadth, m.
    pub y: f64,
    /// The block in which it is, as people find it.
    pub block: String,
}

/// A block that was left as it is, for it cuts at another level than the part has there.
#[derive(Clone, Debug, PartialEq)]
pub struct Other {
    /// The block, as people find it.
    pub block: String,
    /// Its level and that of the part where they differ most, m.
    pub levels: [f64; 2],
}

/// By how much a flat cutter takes more than its middle leaves, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deeper {
    /// How far the cutter reaches about its middle.
    pub reach: f64,
    /// Root mean square over the top.
    pub rms: f64,
    /// At the worst place.
    pub worst: f64,
}

/// A program that carries a correction.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Corrected {
    /// The axes of its machine.
    pub axes: Axes,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Words that have another number.
    pub words: usize,
    /// Words and blocks that were put in.
    pub added: usize,
    /// Smallest and largest change of the level that it makes over the finishing pass, m.
    pub changed: [f64; 2],
    /// What it does not carry.
    pub left: Left,
    /// Blocks that were left as they are.
    pub others: Vec<Other>,
    /// Lengths of the pass that no block cuts, or not over the whole breadth, m.
    pub unfinished: Vec<[f64; 2]>,
    /// The finishing block whose own level lies farthest off that of the part, and by how much, m.
    pub off: Option<(String, f64)>,
    /// Of a flat cutter that follows the contour up and down: by how much it takes more, m, for it stands lower while
    /// it is still or already over a place than when its middle passes it.
    pub deeper: Option<Deeper>,
    /// Whether more is left than the tolerance of straight lines and the increment explain.
    pub is_short: bool,
    /// Whether blocks put between could carry that.
    pub could_add: bool,
    /// The change that it makes at each of the places of the correction, course by course, m of the level.
    pub carried: Vec<f64>,
}

/// The program with the words that carry a change of the contour; where `adds` says so, with blocks put between.
///
/// # Errors
/// No block of it finishes the part, or one cannot be changed.
pub fn corrected(program: &Program, work: &Workpiece, courses: &[Course], adds: bool) -> Result<Corrected, InputError> {
    let fail = |problem: Problem| InputError::one(program.source.clone(), problem);
    let steps = &program.steps;
    let wanted = Wanted::new(courses, &work.stretches);
    let samples = samples(steps, work, &wanted);
    let places: Vec<[f64; 2]> = samples.iter().map(|sample| [sample.x, sample.y]).collect();
    let makers = Makers::of(steps, &places, work);
    let before = Surface::of(steps, &places, &makers);
    let finish = Finish::of(&samples, &before, work);
    if finish.owned.is_empty() {
        return Err(fail(nothing_finishes(program, work, &finish.foreign)));
    }
    not_aside(program, &finish).map_err(fail)?;
    let possible = possible(steps, &finish, work, &wanted);
    let has_more = possible.values().any(|places| !places.is_empty());
    let put = if adds { possible } else { BTreeMap::new() };
    let holds = Holds::of(steps, &put);
    let arcs = work.axes.has_arcs_across();
    let changes = changes((steps, arcs), &holds, (&finish, &before), &samples, &wanted);
    if arcs {
        still_centres(program, &holds, &changes).map_err(fail)?;
    }
    let written = rewritten(&program.bytes, (&program.blocks, steps), (&holds, &changes), work);
    // What was written is read again: what is told of it holds of the file.
    let again = Program::of(&program.source.name, written.bytes, work)?;
    let later = makers.of_written(&written.origins);
    let after = Surface::of(&again.steps, &places, &later);
    let deeper = later.deeper(&again.steps, &places, &after).zip(work.breadth);
    let deeper = deeper.map(|(all, breadth)| Deeper::of(&samples, &all, breadth.reach));
    let kept = kept(program, &samples, (&before, &after), &finish, &wanted);
    let inside: Vec<[f64; 2]> = courses.iter().flat_map(|course| nudged(course, work)).collect();
    let was = Surface::of(steps, &inside, &makers).made;
    let is = Surface::of(&again.steps, &inside, &later).made;
    let carried = was.iter().zip(&is).map(|(was, is)| match (was, is) {
        (Some(was), Some(is)) if finish.owned.contains_key(&was.step) => is.r - was.r,
        _ => 0.0,
    });
    let carried: Vec<f64> = carried.collect();
    let finest = steps.iter().map(|step| work.increment(step.unit).size * step.scale).fold(0.0, f64::max);
    let is_short = kept.left.worst > work.fineness.chord_tolerance + finest;
    let name = |step: usize| program.blocks[steps[step].block].shown();
    let other = |own: &Foreign| Other { block: name(own.step), levels: own.levels };
    Ok(Corrected {
        axes: work.axes,
        words: written.words,
        added: written.added,
        changed: kept.changed,
        deeper,
        is_short,
        could_add: is_short && !adds && has_more,
        left: kept.left,
        others: finish.foreign.iter().map(other).collect(),
        unfinished: unfinished(&samples, &before),
        off: finish.off.map(|(step, off)| (name(step), off)),
        carried,
        bytes: again.bytes,
    })
}

impl Deeper {
    fn of(samples: &[Sample], all: &[f64], reach: f64) -> Self {
        let length: f64 = samples.iter().map(|sample| sample.weight).sum();
        let squares: f64 = samples.iter().zip(all).map(|(sample, own)| sample.weight * own * own).sum();
        let rms = if length > 0.0 { (squares / length).sqrt() } else { 0.0 };
        Self { reach, rms, worst: all.iter().copied().fold(0.0, f64::max) }
    }
}

/// Steps before which blocks can be put, with the shares of their way, and those that can have a word across of their
/// own: what finishes the part, and on a mill what leads from one track to the next.
fn possible(steps: &[Step], finish: &Finish, work: &Workpiece, wanted: &Wanted) -> BTreeMap<usize, Vec<f64>> {
    let is_bare = |step: &Step| step.is_plain && step.word.is_none();
    let finishing = finish.owned.keys().map(|step| (*step, between(&steps[*step], work, wanted)));
    let mut all: BTreeMap<usize, Vec<f64>> =
        finishing.filter(|(step, places)| !places.is_empty() || is_bare(&steps[*step])).collect();
    if work.breadth.is_some() {
        let before = finish.owned.keys().filter_map(|step| step.checked_sub(1));
        for step in before.filter(|step| steps[*step].cut.is_some() && is_bare(&steps[*step])) {
            all.entry(step).or_default();
        }
    }
    all
}

/// What is kept of what is wanted.
struct Kept {
    changed: [f64; 2],
    left: Left,
}

fn kept(
    program: &Program,
    samples: &[Sample],
    (before, after): (&Surface, &Surface),
    finish: &Finish,
    wanted: &Wanted,
) -> Kept {
    let mut changed = [f64::INFINITY, f64::NEG_INFINITY];
    let (mut squares, mut length) = (0.0, 0.0);
    let mut worst = (0.0f64, None);
    for (step, own) in &finish.owned {
        for at in own {
            let (Some(was), Some(is)) = (before.made[*at], after.made[*at]) else { continue };
            let (sample, change) = (samples[*at], is.r - was.r);
            let left = change - wanted.at(sample.x, sample.y);
            changed = [changed[0].min(change), changed[1].max(change)];
            squares += sample.weight * left * left;
            length += sample.weight;
            if left.abs() > worst.0 {
                worst = (left.abs(), Some((*step, [sample.x, sample.y])));
            }
        }
    }
    let (step, [x, y]) = worst.1.unwrap_or_default();
    let block = program.steps.get(step).map_or(String::new(), |step| program.blocks[step.block].shown());
    let rms = if length > 0.0 { (squares / length).sqrt() } else { 0.0 };
    Kept { changed, left: Left { rms, worst: worst.0, x, y, block } }
}

/// Places of a course a little inside of the stretch to which each belongs: that toward the end of the part, of the
/// last one itself.
fn nudged(course: &Course, work: &Workpiece) -> Vec<[f64; 2]> {
    let end = work.stretches.last().map_or(0.0, |last| last.to);
    let nudge = 1e3 * SAME;
    let inside = |x: &f64| if *x > end - nudge { x - nudge } else { x + nudge };
    course.places.iter().map(|x| [inside(x), course.y]).collect()
}

/// Lengths that no block cuts.
fn unfinished(samples: &[Sample], surface: &Surface) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = Vec::new();
    for (sample, _) in samples.iter().zip(&surface.made).filter(|(_, made)| made.is_none()) {
        match all.last_mut().filter(|last| sample.interval[0] <= last[1] + SAME) {
            Some(last) => last[1] = sample.interval[1],
            None => all.push(sample.interval),
        }
    }
    all.retain(|ends| ends[1] - ends[0] > SHORTEST);
    all
}

/// A path that the control moves aside cuts nobody knows which places.
fn not_aside(program: &Program, finish: &Finish) -> Result<(), Problem> {
    let is_aside = |step: &&usize| program.steps[**step].cut.is_some_and(|cut| cut.is_aside);
    match finish.owned.keys().find(is_aside) {
        None => Ok(()),
        Some(step) => {
            let block = &program.blocks[program.steps[*step].block];
            let message =
                "this cut finishes the top beside its path (G41 or G42), by a radius that stands in the control";
            Err(Problem::new(message).help(ASIDE).at(Some(block.line.clone())))
        }
    }
}

/// An arc whose centre is written from the zero cannot follow its ends.
fn still_centres(program: &Program, holds: &Holds, changes: &[f64]) -> Result<(), Problem> {
    for (step, hold) in program.steps.iter().zip(&holds.of) {
        let is_still = step.cut.is_some_and(|cut| matches!(cut.shape, Shape::Arc { written: Centre::Absolute, .. }));
        let moves = [hold.start, hold.end].into_iter().flatten().any(|hold| changes[hold].abs() > NONE);
        if is_still && moves {
            let help =
                "write R, or I and K from the start of the arc (G91.1): the centre would have to move with the ends";
            let problem =
                program.blocks[step.block].words[0].problem("the centre of this arc stands in absolute words", help);
            return Err(problem);
        }
    }
    Ok(())
}

/// The problem of a program that finishes nothing: the cut that comes nearest.
fn nothing_finishes(program: &Program, work: &Workpiece, foreign: &[Foreign]) -> Problem {
    let help = match work.axes.level {
        Level::Radius => {
            "does [program] of the model say where Z is 0 (zero), and whether X is a diameter (x)? is it the finishing program?"
        }
        Level::Height => "does [program] of the model say where X, Y and Z are 0 (zero)? is it the finishing program?",
    };
    let off = |own: &&Foreign| (own.levels[0] - own.levels[1]).abs();
    let Some(nearest) = foreign.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else {
        let [low, high] = [work.ends().0, work.ends().1].map(|x| 1e3 * x);
        return Problem::new(format!("no block cuts along the part, which is finished from x = {low} to {high} mm"))
            .help(help);
    };
    let step: &Step = &program.steps[nearest.step];
    let block = &program.blocks[step.block];
    let (word, times) = work.axes.level.measured();
    let [is, part] = nearest.levels.map(|level| 1e3 * times * level);
    let message = format!(
        "no block finishes the part; nearest, this one cuts at {is:.3} mm of {word} where the part has {part:.3} mm"
    );
    Problem::new(message).help(help).at(Some(block.line.clone()))
}
