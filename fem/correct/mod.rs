//! What to command so that the part comes out as the drawing asks: solved through the model, so that force feedback, copying
//! and contacts answer to the correction as they answer to the cut.

mod knowledge;
mod solve;

use std::sync::Arc;

use rayon::prelude::*;

use crate::model::Model;
use crate::process::{Command, Commanded, Failure, Rows, Standing, Values};
use crate::progress::Progress;
pub(crate) use knowledge::Knowledge;

/// Fewest places of a contour.
const LEAST_PLACES: usize = 51;
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
    /// The rows for which it is told: places of every part.
    pub rows: Rows,
    /// The places and numbers, and the change of the command at each row.
    pub command: Arc<Command>,
    /// What the machine makes of each row as it is, as an error.
    pub before: Vec<f64>,
    /// What it makes with the correction.
    pub left: Vec<f64>,
    /// The interval that holds that with 95 %, from what is known of the values of the model.
    pub interval: Vec<[f64; 2]>,
    /// Rows that no change of the command brings to where they should be.
    pub unreached: usize,
    /// The offset that comes nearest to the change, for each number, and what is left with offsets alone.
    pub offsets: Vec<(usize, f64)>,
    pub left_by_offsets: Vec<f64>,
    /// How parts stand against the drawing before and with the correction.
    pub standings: [Vec<Standing>; 2],
    /// Probability that each part is within all that is asked, and that all are, with the correction; none where nothing is.
    pub probability: Option<Probability>,
    /// Values of the model that are known roughly.
    pub uncertain: usize,
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
    let (rows, nothing) = contour(model, &commanded);
    let aims = model.system.aims(&rows);
    let knowledge = Knowledge::of(model);
    let made = |command: &Arc<Command>| model.commanded_at(&knowledge.values, command)?.observe(&rows);
    let before = made(&Arc::new(nothing.clone()))?;
    let solved = progress.stretch("correction", || solve::solve(&nothing, (&before, &aims), commanded.gain, made))?;
    let of = |left: &[f64]| Standing::all(&*model.system, &rows, left);
    let standings = [of(&before), of(&solved.left)];
    let (interval, probability) = progress.stretch("what is known of it", || {
        let command = &solved.command;
        let draw = |values: &[f64]| model.commanded_at(values, command)?.observe(&rows);
        spread(&knowledge, (&rows, &solved.left), draw, of)
    })?;
    let offsets = offsets(&solved.command);
    let places = solved.command.places.len();
    let changes = offsets.iter().flat_map(|(_, change)| std::iter::repeat_n(*change, places)).collect();
    let left_by_offsets = made(&Arc::new(Command { changes, ..(*solved.command).clone() }))?;
    Ok(Some(Correction {
        commanded,
        command: solved.command,
        before,
        left: solved.left,
        interval,
        unreached: solved.unreached,
        offsets,
        left_by_offsets,
        standings,
        probability,
        uncertain: knowledge.uncertain(),
        rows,
    }))
}

/// The rows of a contour: every place of every number, and the command that changes none of them.
pub(crate) fn contour(model: &Model, commanded: &Commanded) -> (Rows, Command) {
    let programme = model.system.programme();
    let own = |column: usize| programme.columns[column].iter().copied().filter(|value| value.is_finite());
    let mut places: Vec<f64> = own(commanded.along).collect();
    places.sort_unstable_by(f64::total_cmp);
    places.dedup();
    if let ([low, .., high], true) = (&places[..], places.len() < LEAST_PLACES) {
        let (low, high, last) = (*low, *high, (LEAST_PLACES - 1) as f64);
        places = (0..LEAST_PLACES).map(|i| low + (high - low) * i as f64 / last).collect();
    }
    let mut numbers: Vec<usize> = own(commanded.number).map(|number| number as usize).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let count = places.len() * numbers.len();
    let mut columns = vec![Values::shared(f64::NAN, count); programme.columns.len()];
    columns[commanded.along] = numbers.iter().flat_map(|_| places.iter().copied()).collect();
    columns[commanded.number] = numbers.iter().flat_map(|number| places.iter().map(|_| *number as f64)).collect();
    let rows = Rows { columns, observable: Values::shared(commanded.observable, count) };
    (rows, Command { changes: vec![0.0; count], places, numbers })
}

/// The mean change of each number: what an offset alone can do.
fn offsets(command: &Command) -> Vec<(usize, f64)> {
    let own = command.changes.chunks(command.places.len().max(1));
    let mean = |changes: &[f64]| changes.iter().sum::<f64>() / changes.len().max(1) as f64;
    command.numbers.iter().copied().zip(own.map(mean)).collect()
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
