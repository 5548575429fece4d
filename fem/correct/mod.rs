//! What to command so that the part comes out as the drawing asks: solved through the model, so that force feedback, copying
//! and contacts answer to the correction as they answer to the cut.

mod action;
mod advised;
mod contour;
mod course;
mod masked;
mod solve;

use std::sync::Arc;

use crate::knowledge::{Band, Knowledge};
use crate::model::Model;
use crate::process::{Advice, Command, Commanded, Failure, Rows, Standing};
use crate::progress::Progress;
pub use action::Action;
pub use advised::{Advised, advise};
pub use contour::{OneContour, Programmed};
pub use course::Offset;
use course::Programme;
pub use masked::Masked;
use solve::Solved;
pub use solve::{NONE, Secants};

/// Fewest places of a contour, and the most to which it is divided further.
const LEAST_PLACES: usize = 51;
const MOST_PLACES: usize = 801;
/// What may be left between places, as a part of the largest error there was, and whatever that is, m.
const CLOSE: f64 = 0.02;
const NEGLIGIBLE: f64 = 1e-8;

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
    /// How far that may be off, and the probability that parts are within what is asked.
    pub band: Band,
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
    /// What it only masks.
    pub masked: Vec<Masked>,
    /// What to do beside the command.
    pub advice: Vec<Advice>,
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
    let band = progress.stretch("what is known of it", || {
        let made = |model: &Model, values: &[f64]| model.commanded_at(values, &solved.command)?.observe(&rows);
        Band::of((model, &knowledge), (&told, &solved.left), made)
    })?;
    let advice = model.commanded_at(&knowledge.values, &Arc::default())?.advice(&told, &before)?;
    let masked = masked::masked(model, &rows, &before)?;
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
        band,
        unreached: solved.unreached,
        between,
        offsets,
        left_by_offsets,
        common,
        standings,
        masked,
        advice,
        rows: told,
    }))
}

/// The rows of every contour of a model's programme, and a command that changes none of them.
pub fn contours(model: &Model, commanded: &Commanded) -> (Rows, Command) {
    let programme = Programme::of(model, commanded);
    let nothing = programme.command(model, commanded, LEAST_PLACES);
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
        let nothing = programme.command(model, commanded, least);
        let rows = programme.rows(model, commanded, &course::places(&nothing));
        let aims = model.system.aims(&rows);
        let made = |command: &Arc<Command>| model.commanded_at(values, command)?.observe(&rows);
        let before = made(&Arc::new(nothing.clone()))?;
        let solved = solve::solve(&nothing, (&before, &aims), commanded, made)?;
        let middles = programme.reached(model, commanded, &course::middles(&nothing));
        let middles = programme.rows(model, commanded, &middles);
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
