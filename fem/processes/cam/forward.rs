//! The deviation that every row would show: what the motion of the wheel leaves, and what gives way.

use rayon::prelude::*;

use super::machine::{Machine, Run};
use super::motion::{Ray, Reach};
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
    let mut runs: Vec<Run> = Vec::new();
    let one = |row: usize| {
        let pass = rows::pass(setup, rows, row);
        let known = runs.iter().position(|run| run.pass == pass).unwrap_or_else(|| {
            runs.push(machine.run(pass));
            runs.len() - 1
        });
        deviation(machine, &runs[known], rows::place(setup, rows, row))
    };
    (0..rows.len()).map(one).collect()
}

/// The same for the model's own points, block by block.
///
/// # Errors
/// The wheel does not come to a point.
pub fn predict(machine: &Machine, progress: &Progress) -> Result<Vec<f64>, Failure> {
    progress.expect(1);
    let run = machine.run(machine.setup.program.usual());
    let deviations = machine.setup.places().par_iter().map(|s| deviation(machine, &run, *s)).collect();
    progress.advance(1);
    deviations
}

fn deviation(machine: &Machine, run: &Run, s: f64) -> Result<f64, Failure> {
    left(machine, run, s).ok_or_else(|| Failure {
        message: format!("the wheel does not come to the cam at {:.2}", ANGLE.shown(machine.setup.profile.angle(s))),
        help: "check the wheel, the profile and the sizes of the effects: a unit may be wrong".into(),
    })
}

/// The deviation at the place s of the profile in a pass, m; `None` where the wheel does not come.
///
/// Wheel and cam yield in proportion to the layer that is there. After a pass by another programme the layer is the
/// surface above the wheel, less the part that stays by yielding: y = part·(above − y).
pub fn left(machine: &Machine, run: &Run, s: f64) -> Option<f64> {
    let own = reach(machine, run, s)?.left;
    Some(with_yielding(machine, run, s, (own, surface(machine, run, s))))
}

/// The same where the motion alone leaves `own`, and the pass before has left a surface at another height, m.
pub fn with_yielding(machine: &Machine, run: &Run, s: f64, (own, surface): (f64, Option<f64>)) -> f64 {
    let part = machine.yielding(s, run.pass);
    match surface {
        Some(before) if before <= own => before,
        Some(before) => own + part / (1.0 + part) * (before - own),
        None => own + part * machine.setup.stock.unwrap_or(0.0),
    }
}

/// Height above the profile at s of what the pass before has left, m; `None` where its programme was the
/// same.
pub fn surface(machine: &Machine, run: &Run, s: f64) -> Option<f64> {
    let setup = &machine.setup;
    let (before, motion) = (setup.before.as_ref()?, run.before.as_ref()?);
    let guess = motion.first_leg(before.program.block_at(s));
    let left = motion.left_along(&Ray::from(setup.profile.at(s)), guess)?.left;
    Some(setup.stock.unwrap_or(0.0) + left + machine.left_before(before, s))
}

/// The position of the wheel that cuts the place s of the profile last, and what it leaves if nothing gives
/// way.
pub fn reach(machine: &Machine, run: &Run, s: f64) -> Option<Reach> {
    let (profile, program) = (&machine.setup.profile, &machine.setup.program);
    let block = program.block_at(s);
    let executed = if run.pass.is_reversed { program.blocks() - 1 - block } else { block };
    run.motion.left_along(&Ray::from(profile.at(s)), run.motion.first_leg(executed))
}
