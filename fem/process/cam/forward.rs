//! The deviation that every row would show: what the motion of the wheel leaves, and what gives way.

use rayon::prelude::*;

use super::machine::Machine;
use super::motion::{Motion, Ray, Reach};
use super::program::Pass;
use super::rows;
use crate::process::{Failure, Rows};
use crate::progress::Progress;
use crate::units::ANGLE;

/// The deviation of every row, m.
///
/// # Errors
/// The wheel does not come to a point.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = &machine.setup;
    let mut motions: Vec<(Pass, Motion)> = Vec::new();
    let one = |row: usize| {
        let pass = rows::pass(setup, rows, row);
        let known = motions.iter().position(|m| m.0 == pass).unwrap_or_else(|| {
            motions.push((pass, machine.motion(pass)));
            motions.len() - 1
        });
        deviation(machine, &motions[known].1, rows::place(setup, rows, row), pass)
    };
    (0..rows.len()).map(one).collect()
}

/// The same for the model's own points, block by block.
///
/// # Errors
/// The wheel does not come to a point.
pub fn predict(machine: &Machine, progress: &Progress) -> Result<Vec<f64>, Failure> {
    progress.expect(1);
    let pass = machine.setup.program.usual();
    let motion = machine.motion(pass);
    let deviations = machine.setup.places().par_iter().map(|s| deviation(machine, &motion, *s, pass)).collect();
    progress.advance(1);
    deviations
}

fn deviation(machine: &Machine, motion: &Motion, s: f64, pass: Pass) -> Result<f64, Failure> {
    left(machine, motion, s, pass).ok_or_else(|| Failure {
        message: format!("the wheel does not come to the cam at {:.2}", ANGLE.shown(machine.setup.profile.angle(s))),
        help: "check the wheel, the profile and the sizes of the effects: a unit may be wrong".into(),
    })
}

/// The deviation at the place s of the profile in a pass with its motion, m; `None` where the wheel does not
/// come.
pub fn left(machine: &Machine, motion: &Motion, s: f64, pass: Pass) -> Option<f64> {
    Some(reach(machine, motion, s, pass)?.left + machine.given_way(s, pass))
}

/// The position of the wheel that cuts the place s of the profile last, and what it leaves if nothing gives
/// way.
pub fn reach(machine: &Machine, motion: &Motion, s: f64, pass: Pass) -> Option<Reach> {
    let (profile, program) = (&machine.setup.profile, &machine.setup.program);
    let block = program.block_at(s);
    let executed = if pass.is_reversed { program.blocks() - 1 - block } else { block };
    motion.left_along(&Ray::from(profile.at(s)), motion.first_leg(executed))
}
