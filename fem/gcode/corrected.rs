//! A program that carries a correction, and what it cannot carry.

use std::collections::BTreeMap;

use super::fit::{Holds, changes};
use super::plan::{Finish, Foreign, between};
use super::program::Program;
use super::steps::{Centre, Shape, Step};
use super::surface::{GAUSS, Sample, Surface, samples};
use super::wanted::{SAME, Wanted};
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
    /// Root mean square over the pass, m of radius.
    pub rms: f64,
    /// The worst, m of radius.
    pub worst: f64,
    /// Where that is along the part, m.
    pub x: f64,
    /// The block in which it is, as people find it.
    pub block: String,
}

/// A block that was left as it is, for it cuts at another radius than the part has there.
#[derive(Clone, Debug, PartialEq)]
pub struct Other {
    /// The block, as people find it.
    pub block: String,
    /// Its radius and that of the part where they differ most, m.
    pub radii: [f64; 2],
}

/// A program that carries a correction.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Corrected {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Words that have another number.
    pub words: usize,
    /// Words and blocks that were put in.
    pub added: usize,
    /// Smallest and largest change of the radius that it makes over the finishing pass, m.
    pub changed: [f64; 2],
    /// What it does not carry.
    pub left: Left,
    /// Blocks that were left as they are.
    pub others: Vec<Other>,
    /// Lengths of the pass that no block cuts, m.
    pub unfinished: Vec<[f64; 2]>,
    /// The finishing block whose own radius lies farthest off that of the part, and by how much, m.
    pub off: Option<(String, f64)>,
    /// Whether more is left than the tolerance of straight lines and the increment explain.
    pub is_short: bool,
    /// Whether blocks put between could carry that.
    pub could_add: bool,
    /// The change that it makes at each of the places of the correction, m of radius.
    pub carried: Vec<f64>,
}

/// The program with the words that carry a change of the contour, given at places (rising, m); where `adds` says so, with blocks put
/// between.
///
/// # Errors
/// No block of it finishes the part, or one cannot be changed.
pub fn corrected(
    program: &Program,
    work: &Workpiece,
    (places, wanted): (&[f64], &[f64]),
    adds: bool,
) -> Result<Corrected, InputError> {
    let fail = |problem: Problem| InputError::one(program.source.clone(), problem);
    let steps = &program.steps;
    let wanted = Wanted::new(places, wanted, &work.stretches);
    let samples = samples(steps, work, &wanted);
    let xs: Vec<f64> = samples.iter().map(|sample| sample.x).collect();
    let before = Surface::of(steps, &xs);
    let finish = Finish::of(&samples, &before, work);
    if finish.owned.is_empty() {
        return Err(fail(nothing_finishes(program, work, &finish.foreign)));
    }
    let all = finish.owned.keys().map(|step| (*step, between(&steps[*step], work, &wanted)));
    let possible: BTreeMap<usize, Vec<f64>> = all
        .filter(|(step, places)| !places.is_empty() || (steps[*step].is_plain && steps[*step].word.is_none()))
        .collect();
    let has_more = possible.values().any(|places| !places.is_empty());
    let put = if adds { possible } else { BTreeMap::new() };
    let holds = Holds::of(steps, &put);
    let changes = changes(steps, &holds, &finish, &samples, &wanted);
    still_centres(program, &holds, &changes).map_err(fail)?;
    let written = rewritten(&program.bytes, (&program.blocks, steps), (&holds, &changes), work);
    // What was written is read again: what is told of it holds of the file.
    let again = Program::of(&program.source.name, written.bytes, work)?;
    let after = Surface::of(&again.steps, &xs);
    let kept = kept(program, &samples, (&before, &after), &finish, &wanted);
    let inside = nudged(places, work);
    let [was, is] = [steps, &again.steps].map(|steps| Surface::of(steps, &inside).made);
    let carried = was.iter().zip(&is).map(|(was, is)| match (was, is) {
        (Some((step, was)), Some((_, is))) if finish.owned.contains_key(step) => is - was,
        _ => 0.0,
    });
    let carried: Vec<f64> = carried.collect();
    let finest = steps.iter().map(|step| work.increment(step.unit).size * step.scale).fold(0.0, f64::max);
    let is_short = kept.left.worst > work.chord_tolerance + finest;
    let name = |step: usize| program.blocks[steps[step].block].shown();
    let other = |own: &Foreign| Other { block: name(own.step), radii: own.radii };
    Ok(Corrected {
        words: written.words,
        added: written.added,
        changed: kept.changed,
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
            let (Some((_, was)), Some((_, is))) = (before.made[*at], after.made[*at]) else { continue };
            let sample = samples[*at];
            let left = is - was - wanted.at(sample.x);
            changed = [changed[0].min(is - was), changed[1].max(is - was)];
            squares += sample.weight * left * left;
            length += sample.weight;
            if left.abs() > worst.0 {
                worst = (left.abs(), Some((*step, sample.x)));
            }
        }
    }
    let (step, x) = worst.1.unwrap_or_default();
    let block = program.steps.get(step).map_or(String::new(), |step| program.blocks[step.block].shown());
    let rms = if length > 0.0 { (squares / length).sqrt() } else { 0.0 };
    Kept { changed, left: Left { rms, worst: worst.0, x, block } }
}

/// Places a little inside of the stretch to which each belongs: that toward the end of the part, of the last one itself.
fn nudged(places: &[f64], work: &Workpiece) -> Vec<f64> {
    let end = work.stretches.last().map_or(0.0, |last| last.to);
    let nudge = 1e3 * SAME;
    places.iter().map(|x| if *x > end - nudge { x - nudge } else { x + nudge }).collect()
}

/// Lengths that no block cuts.
fn unfinished(samples: &[Sample], surface: &Surface) -> Vec<[f64; 2]> {
    // Both places of an interval stand so far from its nearer end.
    let margin = |sample: &Sample| 2.0 * GAUSS[0] * sample.weight;
    let mut all: Vec<[f64; 2]> = Vec::new();
    for (at, sample) in samples.iter().enumerate().filter(|(at, _)| surface.made[*at].is_none()) {
        let end = sample.x + margin(sample);
        match all.last_mut().filter(|_| at > 0 && surface.made[at - 1].is_none()) {
            Some(last) => last[1] = end,
            None => all.push([sample.x - margin(sample), end]),
        }
    }
    all.retain(|ends| ends[1] - ends[0] > SHORTEST);
    all
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
    let help = "does [program] of the model say where Z is 0 (zero), and whether X is a diameter (x)? is it the finishing program?";
    let off = |own: &&Foreign| (own.radii[0] - own.radii[1]).abs();
    let Some(nearest) = foreign.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else {
        let [low, high] = [work.ends().0, work.ends().1].map(|x| 1e3 * x);
        return Problem::new(format!("no block cuts along the part, which is finished from x = {low} to {high} mm"))
            .help(help);
    };
    let step: &Step = &program.steps[nearest.step];
    let block = &program.blocks[step.block];
    let [is, part] = nearest.radii.map(|r| 2e3 * r);
    let message = format!(
        "no block finishes the part; nearest, this one cuts at {is:.3} mm of diameter where the part has {part:.3} mm"
    );
    Problem::new(message).help(help).at(Some(block.line.clone()))
}
