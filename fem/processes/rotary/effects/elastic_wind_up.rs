//! Friction of the table winds up the drive before anything moves.
//!
//! The table stays behind by T/k either way: deviation ∓ T·(1/stiffness + 1/k_drive), T the torque of friction (N·m) in the
//! table's bearing, its seals and its clamp, k_drive the torsional stiffness of [drive] (N·m/rad), and stiffness that of
//! what yields beside it, as the mesh or a coupling; it is left out where [drive] tells all of it [Hooke's law, as seed 000,
//! fig. 2b, with angles]. What yields there yields under every torque, also that of a test. Torques come to friction or are taken off it before play is crossed (`forward`). Left out:
//! friction that depends on the angle, the load or the speed, and stick-slip.

use super::super::machine::Effect;
use super::needs::a_drive_that_shows;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{TORQUE, TORSIONAL_STIFFNESS};

/// Where the spring does not switch the effect: friction does.
const SPRING: (f64, f64) = (0.002, 50.0);

/// `elastic-wind-up`.
pub static ELASTIC_WIND_UP: Effect<2> = Effect {
    name: "elastic-wind-up",
    about: "friction winds up worm, gears and couplings before the table moves",
    law: "deviation += sign*friction*(1/stiffness + 1/drive.stiffness) + torque/stiffness, sign -1 in +, +1 in -",
    source: "Hooke's law; seed 000, fig. 2b, with angles",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "every drive winds up, that of a table on rolling bearings by little"),
    parameters: [
        Parameter::amplitude("friction", TORQUE, "of the table, against the motion", (0.1, 200.0)),
        Parameter::shape("stiffness", TORSIONAL_STIFFNESS, "of what yields beside [drive] stiffness", SPRING)
            .or(f64::INFINITY),
    ],
    look_alikes: &[
        ("backlash", "a torque beyond friction: play shows no more, and the drive gives way as before"),
        ("reference-shift", "approaches from both sides: friction holds the table back either way, an offset does not"),
        ("compliance", "no torque from outside: friction alone winds the drive up, either way"),
    ],
    needs: a_drive_that_shows,
    act: |[friction, stiffness], machine| {
        machine.friction += friction;
        machine.soften(stiffness);
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_table_lags_either_way() {
        // 6 N·m on 2 and on 3 N·m/arcsec in series.
        let [there, back] = both((SPRUNG, "elastic-wind-up", &[6.0, 3.0]), 200.0);
        assert!(near(there, -5.0) && near(back, 5.0), "{there} {back}");
        let [there, back] = both((WORM, "elastic-wind-up", &[6.0, 3.0]), 10.0);
        assert!(near(there, -2.0) && near(back, 2.0));
    }

    #[test]
    fn a_torque_comes_to_friction_or_is_taken_off_it() {
        let [there, back] = turned((WORM, "elastic-wind-up", &[6.0, 3.0]), 10.0, 9.0);
        assert!(near(there, 1.0) && near(back, 5.0));
    }
}
