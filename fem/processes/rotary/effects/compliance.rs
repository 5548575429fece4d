//! A drive that the model takes as rigid gives way under a torque.
//!
//! deviation += T/stiffness, T the torque about the axis (N·m, positive towards +), stiffness the torsional stiffness of worm
//! or gears, shafts and couplings at the table (N·m/rad) [Hooke's law]. It is the spring that friction winds up too, and
//! play stands in series with it (`forward`). Where [drive] tells a stiffness this is it already, and a wrong one is a wrong
//! value. Left out: a stiffness that rises with the torque, as that of harmonic drives does.

use super::super::machine::Effect;
use super::super::setup::Setup;
use super::needs::a_drive_that_shows;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::TORSIONAL_STIFFNESS;

/// `compliance`.
pub static COMPLIANCE: Effect<1> = Effect {
    name: "compliance",
    about: "a drive that is taken as rigid gives way under a torque",
    law: "deviation += torque/stiffness",
    source: "Hooke's law",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "no drive is rigid, and few torques are large"),
    parameters: [Parameter::stiffness(TORSIONAL_STIFFNESS, "of the whole drive at the table", (0.002, 50.0))],
    look_alikes: &[("elastic-wind-up", "no torque from outside: friction alone winds the drive up, either way")],
    needs: a_rigid_drive,
    act: |[stiffness], machine| machine.soften(stiffness),
};

fn a_rigid_drive(setup: &Setup) -> Result<(), String> {
    match setup.drive.is_rigid() {
        true => a_drive_that_shows(setup),
        false => Err("needs a drive that is taken as rigid, and this one has a `stiffness` in [drive]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_torque_turns_the_table_its_own_way() {
        let at = |torque| turned((WORM, "compliance", &[4.0]), 10.0, torque);
        assert!(at(20.0).iter().all(|value| near(*value, 5.0)) && at(-2.0).iter().all(|value| near(*value, -0.5)));
        assert_eq!(at(0.0), [0.0, 0.0]);
    }
}
