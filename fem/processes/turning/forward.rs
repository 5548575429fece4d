//! Predicts every row: the shaft in equilibrium under the tool, and the shifts of the tool against the work.

use std::f64::consts::PI;
use std::ops::Range;

use rayon::prelude::*;

use super::cut::Conditions;
use super::elastic::{Cutting, Deflection, Elastic, condense};
use super::history::History;
use super::machine::{Machine, Moment};
use super::rows::{ANGLE, BLANK, DIAMETER, X};
use super::turned::{Histories, Turned};
use crate::process::{Failure, Rows};
use crate::progress::Progress;
use crate::solve::{Condensed, Moved};

/// The equilibrium of the last pass on the first part at each of the positions (m) to which the shaft is condensed.
///
/// # Errors
/// No equilibrium at some position.
pub fn deflections(
    machine: &Machine,
    shaft: &Condensed,
    positions: &[f64],
    progress: &Progress,
) -> Result<Vec<Deflection>, Failure> {
    on_part(machine, &Elastic::new(machine, shaft), positions, 1, progress)
}

fn on_part(
    machine: &Machine,
    elastic: &Elastic,
    positions: &[f64],
    part: usize,
    progress: &Progress,
) -> Result<Vec<Deflection>, Failure> {
    let history = History::on_part(machine, part, None)?;
    let deflect = |(i, x): (usize, &f64)| {
        let deflection = elastic.last((i, *x), None, &Cutting::on_part(machine, part, *x), history.at(*x));
        progress.advance(1);
        deflection
    };
    progress.expect(positions.len() as u64);
    positions.par_iter().enumerate().with_min_len(64).map(deflect).collect()
}

/// The diameter error (m) that is left at a moment where no force acts.
///
/// # Errors
/// As [`condense`] and [`deflections`].
pub fn unloaded(machine: &Machine, moment: &Moment) -> Result<f64, Failure> {
    let shaft = condense(machine, &[moment.x])?;
    let conditions = Conditions { force: 0.0, nominal: 0.0, ..machine.setup.conditions(moment.x, 0.0) };
    Ok(Elastic::new(machine, &shaft).deflect(0, &Cutting::new(machine, moment, conditions))?.error)
}

/// The rows of the programme. Where the gap at a place stays the same, each position is solved once for all parts.
///
/// # Errors
/// As [`condense`] and [`deflections`].
pub fn predict(machine: &Machine, programme: &Rows, progress: &Progress) -> Result<Vec<f64>, Failure> {
    let setup = &machine.setup;
    if !setup.blank.is_round() {
        // The programme's rows are at one angle, and the mean around the part is not that. They name the diameter
        // that was meant; what the blank is off by comes to it.
        let mut rows = programme.clone();
        rows.columns[BLANK].fill(f64::NAN);
        return observe(machine, &rows);
    }
    let positions = setup.sweep();
    let shaft = condense(machine, &positions)?;
    let elastic = Elastic::new(machine, &shaft);
    if machine.gap_changes() {
        let parts = (1..=setup.schedule.parts).map(|part| on_part(machine, &elastic, &positions, part, progress));
        let errors = parts.map(|part| Ok(part?.into_iter().map(|d| d.error).collect::<Vec<f64>>()));
        return Ok(errors.collect::<Result<Vec<_>, Failure>>()?.concat());
    }
    let deflections = on_part(machine, &elastic, &positions, 1, progress)?;
    let mut errors = vec![0.0; programme.len()];
    progress.expect(setup.schedule.parts as u64);
    errors.par_chunks_mut(positions.len()).enumerate().for_each(|(k, errors)| {
        for ((error, &x), deflection) in errors.iter_mut().zip(&positions).zip(&deflections) {
            let moment = machine.moment_on(k + 1, x);
            *error = machine.nose_at(&moment).error(moment.diameter, deflection.total).0;
        }
        progress.advance(1);
    });
    Ok(errors)
}

/// Rows whose positions are condensed together: a position takes a hundred bytes, and files have a million.
const BLOCK: usize = 1 << 14;

/// Predicts the diameter of every row, or its error, m.
///
/// # Errors
/// As [`condense`] and [`deflections`].
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let mut values = Vec::with_capacity(rows.len());
    for first in (0..rows.len()).step_by(BLOCK) {
        values.extend(observe_some(machine, rows, first..rows.len().min(first + BLOCK))?);
    }
    Ok(values)
}

fn observe_some(machine: &Machine, rows: &Rows, some: Range<usize>) -> Result<Vec<f64>, Failure> {
    let setup = &*machine.setup;
    let standing = Standing::of(machine, rows, some.clone())?;
    let elastic = Elastic::new(machine, &standing.shaft);
    let one = |row: usize| {
        let set = if rows.observable[row] == DIAMETER { setup.diameter(standing.at(row)) } else { 0.0 };
        let left = |angle| standing.deflection(&elastic, row, angle).map(|d| d.error);
        let sum = angles(machine, rows, row).map(left).sum::<Result<f64, Failure>>()?;
        Ok(set + sum / angles(machine, rows, row).count() as f64)
    };
    some.into_par_iter().with_min_len(256).map(one).collect()
}

/// Gives `each` block of rows by where the tool stands (m) and the equilibrium of its last pass there.
///
/// # Errors
/// As [`observe`], and of `each`.
pub fn standing(
    machine: &Machine,
    rows: &Rows,
    mut each: impl FnMut(&[f64], &[Deflection]) -> Result<(), Failure>,
) -> Result<(), Failure> {
    for first in (0..rows.len()).step_by(BLOCK) {
        let some = first..rows.len().min(first + BLOCK);
        let standing = Standing::of(machine, rows, some.clone())?;
        let elastic = Elastic::new(machine, &standing.shaft);
        let deflect = |row| standing.deflection(&elastic, row, angles(machine, rows, row).next().flatten());
        let deflections = some.clone().into_par_iter().with_min_len(256).map(deflect).collect::<Result<Vec<_>, _>>()?;
        each(&some.map(|row| standing.at(row)).collect::<Vec<_>>(), &deflections)?;
    }
    Ok(())
}

/// Rows under the tool, with the shaft condensed to where they stand.
struct Standing<'a> {
    machine: &'a Machine,
    rows: &'a Rows,
    /// Sorted, m.
    positions: Vec<f64>,
    shaft: Condensed,
    histories: Histories,
}

impl<'a> Standing<'a> {
    fn of(machine: &'a Machine, rows: &'a Rows, some: Range<usize>) -> Result<Self, Failure> {
        let mut positions: Vec<f64> = some.clone().map(|row| place(machine, rows, row)).collect();
        positions.sort_unstable_by(f64::total_cmp);
        positions.dedup();
        let shaft = condense(machine, &positions)?;
        let turned = some.flat_map(|row| {
            let turned = Turned::of(machine, rows, row, place(machine, rows, row));
            angles(machine, rows, row).map(move |angle| (turned, angle))
        });
        let histories = Histories::of(machine, turned)?;
        Ok(Self { machine, rows, positions, shaft, histories })
    }

    fn at(&self, row: usize) -> f64 {
        place(self.machine, self.rows, row)
    }

    /// The last pass at a row, at an angle (rad) around the part or on the mean.
    fn deflection(&self, elastic: &Elastic, row: usize, angle: Option<f64>) -> Result<Deflection, Failure> {
        let (machine, rows, x) = (self.machine, self.rows, self.at(row));
        let i = self.positions.partition_point(|p| *p < x);
        let turned = Turned::of(machine, rows, row, x);
        let (last, borne) = (turned.cutting(machine), self.histories.at(machine, &turned, angle));
        match rows.get(BLANK, row) {
            Some(_) => elastic.finish(i, 0.0, &last, borne),
            None => elastic.last((i, x), angle, &last, borne),
        }
    }
}

/// The angles (rad) around the part at which the diameter of a row ends: a diameter reaches from one side to the other.
/// Of a round blank it is the mean.
fn angles(machine: &Machine, rows: &Rows, row: usize) -> impl Iterator<Item = Option<f64>> + use<> {
    let angle = rows.get(ANGLE, row).unwrap_or(0.0);
    let is_round = machine.setup.blank.is_round();
    std::iter::once((!is_round).then_some(angle)).chain((!is_round).then_some(Some(angle + PI)))
}

/// Where the tool stands at a row, m.
fn place(machine: &Machine, rows: &Rows, row: usize) -> f64 {
    rows.get(X, row).unwrap_or(0.0).clamp(0.0, machine.setup.length())
}

/// Force of each steady rest at every tool position, N.
///
/// # Errors
/// As [`condense`].
pub fn rest_forces(machine: &Machine, positions: &[f64], deflections: &[Deflection]) -> Result<Vec<Vec<f64>>, Failure> {
    if machine.setup.steady_rests.is_empty() {
        return Ok(Vec::new());
    }
    let tools: Vec<(f64, Moved)> = deflections.iter().map(|d| (d.force, d.moved())).collect();
    Ok(condense(machine, positions)?.rest_forces(&machine.shaft(), &tools))
}
