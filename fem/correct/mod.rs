//! What to command so that the part comes out as the drawing asks: solved through the model, so that force feedback, copying
//! and contacts answer to the correction as they answer to the cut.

mod contour;
mod course;
mod knowledge;
mod solve;

pub use knowledge::Knowledge;

use std::sync::Arc;

use rayon::prelude::*;

use crate::model::Model;
use crate::process::{Advice, Command, Commanded, Failure, Rows, Standing};
use crate::progress::Progress;
pub use contour::{OneContour, Programmed};
pub use course::Offset;
use course::Programme;
use solve::Solved;
pub use solve::{NONE, Secants};

/// Fewest places of a contour, and the most to which it is divided further.
const LEAST_PLACES: usize = 51;
const MOST_PLACES: usize = 801;
/// What may be left between places, as a part of the largest error there was, and whatever that is, m.
const CLOSE: f64 = 0.02;
const NEGLIGIBLE: f64 = 1e-8;
/// Rows that draws of the values may cost together, and the fewest and the most draws.
const MOST_DRAWN: usize = 2_000_000;
const DRAWS: (usize, usize) = (100, 400);
/// Part of the draws below and above an interval that holds 95 % of them.
const BEYOND: f64 = 0.025;

/// A correction, and what is left with it. SI.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Correction {
    /// What is commanded.
    pub commanded: Commanded,
    /// The rows for which it is told: places of every contour.
    pub rows: Rows,
    /// The change of the command at each row.
    pub command: Arc<Command>,
    /// What the machine makes of each row as it is, as an error.
    pub before: Vec<f64>,
    /// What it makes with the correction.
    pub left: Vec<f64>,
    /// The interval that holds that with 95 %, from what is known of the values of the model.
    pub interval: Vec<[f64; 2]>,
    /// Rows that no change of the command brings to where they should be.
    pub unreached: usize,
    /// The largest distance from where it should be half way between two places.
    pub between: f64,
    /// The offset that comes nearest to the change, for each number, and what is left with offsets alone.
    pub offsets: Vec<Offset>,
    pub left_by_offsets: Vec<f64>,
    /// One contour for all numbers, with an offset for each; none where nothing is numbered.
    pub common: Option<OneContour>,
    /// How parts stand against the drawing before and with the correction.
    pub standings: [Vec<Standing>; 2],
    /// Probability that each part is within all that is asked, and that all are, with the correction; none where nothing is.
    pub probability: Option<Probability>,
    /// Values of the model that are known roughly.
    pub uncertain: usize,
    /// What to do beside the command.
    pub advice: Vec<Advice>,
}

/// Probabilities of being within what is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct Probability {
    /// Of each part, by its number.
    pub of_parts: Vec<(Option<usize>, f64)>,
    /// Of all together.
    pub of_all: f64,
}

/// Solves for the correction of a model whose values are known; `None` where its process has no command that is corrected.
///
/// # Errors
/// The model cannot be computed.
pub fn correct(model: &Model, progress: &Progress) -> Result<Option<Correction>, Failure> {
    let Some(commanded) = model.system.commanded() else { return Ok(None) };
    let knowledge = Knowledge::of(model);
    let Course { rows, before, solved, between } =
        progress.stretch("correction", || course(model, &commanded, &knowledge.values))?;
    let made = |command: &Arc<Command>| model.commanded_at(&knowledge.values, command)?.observe(&rows);
    let told = model.system.resolved(&rows);
    let of = |left: &[f64]| Standing::all(&*model.system, &told, left);
    let standings = [of(&before), of(&solved.left)];
    let (interval, probability) = progress.stretch("what is known of it", || {
        let command = &solved.command;
        let draw = |values: &[f64]| model.commanded_at(values, command)?.observe(&rows);
        spread(&knowledge, (&rows, &solved.left), draw, of)
    })?;
    let advice = model.commanded_at(&knowledge.values, &Arc::default())?.advice(&told, &before)?;
    let offsets = course::offsets(&solved.command, &commanded);
    let left_by_offsets = made(&course::of_offsets(&solved.command, &commanded, &offsets))?;
    let common = match commanded.number {
        Some(_) => OneContour::common(&solved.command, made)?,
        None => None,
    };
    Ok(Some(Correction {
        commanded,
        command: solved.command,
        before,
        left: solved.left,
        interval,
        unreached: solved.unreached,
        between,
        offsets,
        left_by_offsets,
        common,
        standings,
        probability,
        uncertain: knowledge.uncertain(),
        advice,
        rows: told,
    }))
}

/// The rows of every contour of a model's programme, and a command that changes none of them.
pub fn contours(model: &Model, commanded: &Commanded) -> (Rows, Command) {
    let programme = Programme::of(model, commanded);
    let nothing = programme.command(commanded, LEAST_PLACES);
    (programme.rows(model, commanded, &course::places(&nothing)), nothing)
}

/// A correction along its course.
struct Course {
    rows: Rows,
    before: Vec<f64>,
    solved: Solved,
    between: f64,
}

/// Solves at places so close that what is between them is corrected too, as far as that can be.
fn course(model: &Model, commanded: &Commanded, values: &[f64]) -> Result<Course, Failure> {
    let programme = Programme::of(model, commanded);
    let mut least = LEAST_PLACES;
    loop {
        let nothing = programme.command(commanded, least);
        let rows = programme.rows(model, commanded, &course::places(&nothing));
        let aims = model.system.aims(&rows);
        let made = |command: &Arc<Command>| model.commanded_at(values, command)?.observe(&rows);
        let before = made(&Arc::new(nothing.clone()))?;
        let solved = solve::solve(&nothing, (&before, &aims), commanded, made)?;
        let middles = programme.rows(model, commanded, &course::middles(&nothing));
        let aimed = model.system.aims(&middles);
        let made = model.commanded_at(values, &solved.command)?.observe(&middles)?;
        let worst = |made: &[f64], aims: &[f64]| {
            made.iter().zip(aims).map(|(made, aim)| (made - aim).abs()).fold(0.0f64, f64::max)
        };
        let between = worst(&made, &aimed);
        let is_fine = between <= (CLOSE * worst(&before, &aims)).max(NEGLIGIBLE);
        if is_fine || 2 * least > MOST_PLACES {
            return Ok(Course { rows, before, solved, between });
        }
        least = 2 * least - 1;
    }
}

/// What is left at every row with 95 %, and the probability that parts are within what is asked.
type Spread = (Vec<[f64; 2]>, Option<Probability>);

/// How far what is left may be off, by drawing the values; those that make no model are none.
fn spread(
    knowledge: &Knowledge,
    (rows, left): (&Rows, &[f64]),
    draw: impl Fn(&[f64]) -> Result<Vec<f64>, Failure> + Sync,
    of: impl Fn(&[f64]) -> Vec<Standing>,
) -> Result<Spread, Failure> {
    let parts: Vec<Option<usize>> = {
        let mut all: Vec<_> = of(left).iter().flat_map(|own| own.parts.iter().map(|(part, _)| *part)).collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    let draws = match knowledge.uncertain() {
        0 => 1,
        _ => (MOST_DRAWN / rows.len().max(1)).clamp(DRAWS.0, DRAWS.1),
    };
    // The first is what is known best.
    let further: Vec<Vec<f64>> =
        (1..draws).into_par_iter().filter_map(|number| draw(&knowledge.drawn(number)).ok()).collect();
    if 2 * further.len() + 1 < draws {
        return Err(Failure {
            message: "the values of the model are known so roughly that most of what they may be makes no model".into(),
            help: "fit them to measurements first: `fem fit MODEL --with DATA --add-to BETTER`".into(),
        });
    }
    let all: Vec<&[f64]> = std::iter::once(left).chain(further.iter().map(Vec::as_slice)).collect();
    let interval = (0..rows.len()).map(|row| interval(all.iter().map(|made| made[row]).collect())).collect();
    let (mut within, mut all_within) = (vec![0usize; parts.len()], 0usize);
    for made in &all {
        let out: Vec<Option<usize>> = of(made).iter().flat_map(|own| own.out().collect::<Vec<_>>()).collect();
        parts.iter().zip(&mut within).for_each(|(part, count)| *count += usize::from(!out.contains(part)));
        all_within += usize::from(out.is_empty());
    }
    let share = |count: usize| count as f64 / all.len() as f64;
    let of_parts: Vec<_> = parts.into_iter().zip(within.into_iter().map(share)).collect();
    let probability = (!of_parts.is_empty()).then(|| Probability { of_parts, of_all: share(all_within) });
    Ok((interval, probability))
}

/// The interval that holds 95 % of some values.
fn interval(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_unstable_by(f64::total_cmp);
    let last = (values.len() - 1) as f64;
    [BEYOND, 1.0 - BEYOND].map(|part| {
        let at = part * last;
        let (below, share) = (at as usize, at.fract());
        let above = values[(below + 1).min(values.len() - 1)];
        values[below] + share * (above - values[below])
    })
}
