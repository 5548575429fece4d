//! What every row would show: the shaft in equilibrium under the tool, and what shifts the tool against the
//! work.

use std::f64::consts::PI;
use std::ops::Range;

use rayon::prelude::*;

use super::elastic::{Deflection, Elastic};
use super::machine::{Machine, Moment};
use super::rows::{self, ANGLE, BLANK, DIAMETER, X};
use crate::process::{Failure, Rows};
use crate::progress::Progress;
use crate::solve::{Condensed, JointsError, ShaftError};

/// The shaft as the machine holds it, condensed to tool positions in m.
///
/// # Errors
/// An effect cannot be computed, the shaft is loose, or a position is off it.
pub fn condense(machine: &Machine, positions: &[f64]) -> Result<Condensed, Failure> {
    if let Some(failure) = &machine.failure {
        return Err(failure.clone());
    }
    machine.setup.shaft(machine.hold).condense(positions).map_err(Failure::from)
}

/// The equilibrium of the last pass at each of the positions (m) to which the shaft is condensed.
///
/// # Errors
/// No equilibrium at some position.
pub fn deflections(
    machine: &Machine,
    shaft: &Condensed,
    positions: &[f64],
    progress: &Progress,
) -> Result<Vec<Deflection>, Failure> {
    let elastic = Elastic::new(machine, shaft);
    let deflect = |(i, x): (usize, &f64)| {
        let before = elastic.before(i, *x, None);
        let deflection = before.and_then(|before| elastic.deflect(i, machine.setup.conditions(*x, before)));
        progress.advance(1);
        deflection.map_err(Failure::from)
    };
    progress.expect(positions.len() as u64);
    positions.par_iter().enumerate().with_min_len(64).map(deflect).collect()
}

/// The rows of the programme: each position is solved once for all parts.
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
    let deflections = deflections(machine, &condense(machine, &positions)?, &positions, progress)?;
    let mut errors = vec![0.0; programme.len()];
    progress.expect(setup.schedule.parts as u64);
    errors.par_chunks_mut(positions.len()).enumerate().for_each(|(k, errors)| {
        for ((error, &x), deflection) in errors.iter_mut().zip(&positions).zip(&deflections) {
            *error = deflection.error(machine.shift_on(k + 1, x));
        }
        progress.advance(1);
    });
    Ok(errors)
}

/// Rows whose positions are condensed together: a position takes a hundred bytes, and files have a million.
const BLOCK: usize = 1 << 14;

/// What every row would show, m.
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
    let length = setup.length();
    let at = |row: usize| rows.get(X, row).unwrap_or(0.0).clamp(0.0, length);
    let mut positions: Vec<f64> = some.clone().map(at).collect();
    positions.sort_unstable_by(f64::total_cmp);
    positions.dedup();
    let shaft = condense(machine, &positions)?;
    let elastic = Elastic::new(machine, &shaft);
    let one = |row: usize| {
        let x = at(row);
        let diameter = setup.diameter(x);
        let i = positions.partition_point(|p| *p < x);
        let conditions = rows::conditions(setup, rows, row, diameter);
        let deflection = |angle: Option<f64>| -> Result<Deflection, Failure> {
            let mut at = conditions;
            if rows.get(BLANK, row).is_none() {
                at.set_depth += 0.5 * elastic.before(i, x, angle)?;
            }
            Ok(elastic.deflect(i, at)?)
        };
        let (time, path) = rows::moment(setup, rows, row, rows::part(rows, row), x);
        let set = if rows.observable[row] == DIAMETER { diameter } else { 0.0 };
        let shift = machine.shift_at(&Moment { x, diameter, time, path });
        // A diameter reaches from one side to the other.
        let angle = rows.get(ANGLE, row).unwrap_or(0.0);
        let error = match setup.blank.is_round() {
            true => deflection(None)?.error(shift),
            false => 0.5 * (deflection(Some(angle))?.error(shift) + deflection(Some(angle + PI))?.error(shift)),
        };
        Ok(set + error)
    };
    some.into_par_iter().with_min_len(256).map(one).collect()
}

/// Force of each steady rest at every tool position, N. By reciprocity the deflection at a rest while the
/// tool is at x is that at x while a force stands at the rest.
///
/// # Errors
/// As [`condense`].
pub fn rest_forces(machine: &Machine, positions: &[f64], deflections: &[Deflection]) -> Result<Vec<Vec<f64>>, Failure> {
    let rests = &machine.setup.steady_rests;
    if rests.is_empty() {
        return Ok(Vec::new());
    }
    let all: Vec<f64> = positions.iter().copied().chain(rests.iter().map(|r| r.at)).collect();
    let shaft = condense(machine, &all)?;
    let forces = |(rest, stiffness): (usize, f64)| {
        let ([head, tail], shape) = (shaft.influence[rest], shaft.shape(rest));
        let force = |(d, unit): (&Deflection, f64)| {
            let y = d.supports.displacements;
            stiffness * (unit * d.force + head * y[0] + tail * y[1])
        };
        deflections.iter().zip(shape).map(force).collect()
    };
    Ok((positions.len()..).zip(rests.iter().map(|r| r.stiffness)).map(forces).collect())
}

impl From<ShaftError> for Failure {
    fn from(error: ShaftError) -> Self {
        let help = match error {
            ShaftError::Loose { .. } => "give the shaft a stiffer support, or check its dimensions and stiffnesses",
            ShaftError::OffTheShaft { .. } => "keep every position between the ends of the shaft",
        };
        Self { message: error.to_string(), help: help.into() }
    }
}

impl From<JointsError> for Failure {
    fn from(error: JointsError) -> Self {
        let help = "check force, stiffnesses and contact parameters: values far from physical ones do not converge";
        Self { message: error.to_string(), help: help.into() }
    }
}
