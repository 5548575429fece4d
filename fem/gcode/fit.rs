//! Values of the words across the part by which the finishing pass comes nearest to what is wanted.

use std::collections::BTreeMap;

use super::plan::Finish;
use super::sample::Sample;
use super::steps::{Centre, Cut, Shape, Step};
use super::surface::Surface;
use super::wanted::Wanted;

/// Weight of places that a block passes and does not finish: it keeps a word whose block finishes little of its way
/// from going astray.
const PASSED: f64 = 1e-4;
/// Places over the way to each word that are weighed so.
const PASSES: usize = 8;

/// Words, by whose values the ends of steps lie where they do: a word holds until the next.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Holds {
    /// Of each step the hold in force at its start, those at the places put between, and that at its end; `None` where
    /// nobody knows the place.
    pub of: Vec<Hold>,
    /// How many there are.
    pub count: usize,
}

/// The holds of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Hold {
    /// At its start.
    pub start: Option<usize>,
    /// At places put between, by their shares of its way, each with its own.
    pub between: Vec<(f64, usize)>,
    /// At its end.
    pub end: Option<usize>,
}

impl Holds {
    /// The holds of a program into which blocks are put; a block before which some are put gets a word of its own.
    pub fn of(steps: &[Step], between: &BTreeMap<usize, Vec<f64>>) -> Self {
        let mut holds = Self::default();
        let mut now = None;
        for (number, step) in steps.iter().enumerate() {
            let start = now;
            let mut new = || {
                holds.count += 1;
                holds.count - 1
            };
            let places = between.get(&number);
            let places: Vec<(f64, usize)> = places.into_iter().flatten().map(|share| (*share, new())).collect();
            now = match (step.r, step.word.is_some() || between.contains_key(&number)) {
                (None, _) => None,
                (Some(_), true) => Some(new()),
                (Some(_), false) => now,
            };
            holds.of.push(Hold { start, between: places, end: now });
        }
        holds
    }
}

/// Change of each hold, m of the level: the least squares of what is left. An arc moves as a whole where its centre is
/// written from its start, where it does not finish the part, and where it lies at one level; holds that end no
/// finishing cut change nothing.
pub fn changes(
    (steps, has_arcs_across): (&[Step], bool),
    holds: &Holds,
    (finish, surface): (&Finish, &Surface),
    samples: &[Sample],
    wanted: &Wanted,
) -> Vec<f64> {
    let classes = classes((steps, has_arcs_across), holds, finish);
    let count = classes.last().map_or(0, |last| last + 1);
    // The holds of a cut follow one another: every equation has one unknown or two neighbours.
    let (mut own, mut next, mut right) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
    for (step, all) in &finish.owned {
        let Some(cut) = steps[*step].cut else { continue };
        let pieces = pieces(&holds.of[*step]);
        let passed = pieces.iter().flat_map(|([from, to], _)| {
            (0..PASSES).map(move |i| {
                let share = from + (to - from) * (i as f64 + 0.5) / PASSES as f64;
                let spot = cut.at(share);
                (share, PASSED * (to - from) * cut.way() / PASSES as f64, wanted.at(spot.x, spot.y))
            })
        });
        let finished = all.iter().filter_map(|at| {
            let sample = samples[*at];
            Some((surface.made[*at]?.share, sample.weight, wanted.at(sample.x, sample.y)))
        });
        for (share, weight, change) in finished.chain(passed) {
            let Some(([a, b], share)) = at(&pieces, share) else { continue };
            let (a, b) = (classes[a], classes[b]);
            if a == b {
                own[a] += weight;
                right[a] += weight * change;
                continue;
            }
            own[a] += weight * (1.0 - share).powi(2);
            own[b] += weight * share.powi(2);
            next[a.min(b)] += weight * share * (1.0 - share);
            right[a] += weight * (1.0 - share) * change;
            right[b] += weight * share * change;
        }
    }
    let solved = tridiagonal(&mut own, &next, &mut right);
    classes.into_iter().map(|class| solved[class]).collect()
}

/// A straight piece of a cut: its ends, as shares of the way, and its holds.
type Piece = ([f64; 2], [usize; 2]);

fn pieces(hold: &Hold) -> Vec<Piece> {
    let (Some(start), Some(end)) = (hold.start, hold.end) else { return Vec::new() };
    let all = std::iter::once((0.0, start)).chain(hold.between.iter().copied()).chain([(1.0, end)]);
    let all: Vec<(f64, usize)> = all.collect();
    all.windows(2).map(|pair| ([pair[0].0, pair[1].0], [pair[0].1, pair[1].1])).collect()
}

/// The holds on either side of a share of the way, and its share of the way from one to the other.
fn at(pieces: &[Piece], share: f64) -> Option<([usize; 2], f64)> {
    let (ends, holds) = pieces.iter().find(|(ends, _)| (ends[0]..=ends[1]).contains(&share))?;
    Some((*holds, if ends[0] == ends[1] { 0.0 } else { (share - ends[0]) / (ends[1] - ends[0]) }))
}

/// Holds that change together have one number.
fn classes((steps, has_arcs_across): (&[Step], bool), holds: &Holds, finish: &Finish) -> Vec<usize> {
    let mut is_tied = vec![false; holds.count];
    for (number, (step, hold)) in steps.iter().zip(&holds.of).enumerate() {
        let Some(Cut { shape: Shape::Arc { written, .. }, .. }) = step.cut else { continue };
        let moves_whole = match written {
            _ if !has_arcs_across => true,
            Centre::FromStart => true,
            Centre::Radius => !finish.owned.contains_key(&number),
            Centre::Absolute => false,
        };
        if let (true, Some(start), Some(end)) = (moves_whole, hold.start, hold.end) {
            is_tied[end] |= end != start;
        }
    }
    let mut class = 0;
    let number = |(hold, is_tied): (usize, &bool)| {
        class += usize::from(hold > 0 && !is_tied);
        class
    };
    is_tied.iter().enumerate().map(number).collect()
}

/// Solves a symmetric system with one neighbour on either side; an unknown in no equation is 0.
fn tridiagonal(own: &mut [f64], next: &[f64], right: &mut [f64]) -> Vec<f64> {
    for i in 1..own.len() {
        if own[i - 1] > 0.0 {
            let share = next[i - 1] / own[i - 1];
            own[i] -= share * next[i - 1];
            right[i] -= share * right[i - 1];
        }
    }
    let mut solved = vec![0.0; own.len()];
    for i in (0..own.len()).rev() {
        let beyond = solved.get(i + 1).map_or(0.0, |value| next[i] * value);
        solved[i] = if own[i] > 0.0 { (right[i] - beyond) / own[i] } else { 0.0 };
    }
    solved
}
