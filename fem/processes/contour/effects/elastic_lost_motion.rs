//! Elastic clearance: friction of the slide winds the drive up before anything moves.
//!
//! The slide follows the play operator of width δ + 2F/C(x), in series with the clearance δ of `backlash`:
//! 1/C(x) = 1/stiffness + |x − fixed_at|/(EA), F the friction (N), stiffness that of nut and bearing
//! (N/m), EA the axial rigidity of the screw, x the place of the slide [seed 000, fig. 2b, in series with
//! fig. 2a]. To a contour in one place it is play, but for the screw: the width grows away from the fixed
//! bearing, and the two flats of an axis differ. Left out: friction that depends on the speed, and screws
//! with two fixed bearings.

use super::super::drive::Drive;
use super::super::machine::{Effect, Machine};
use super::super::path::AXES;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter, Winding};
use crate::units::{FORCE, STIFFNESS};

/// Where the spring does not switch the effect: friction does.
const SPRING: (f64, f64) = (20.0, 2000.0);

/// `elastic-lost-motion-x`.
pub static X: Effect<2> = elastic_lost_motion(
    "elastic-lost-motion-x",
    "friction winds up the screw, nut and bearing of x before its slide moves",
    &[("backlash-x", "the two flats of x: play is as wide at both, elastic clearance wider away from the bearing")],
    |setup| a_screw(setup, 0),
    |[friction, stiffness], machine| wind(machine, 0, friction, stiffness),
);
/// `elastic-lost-motion-y`.
pub static Y: Effect<2> = elastic_lost_motion(
    "elastic-lost-motion-y",
    "friction winds up the screw, nut and bearing of y before its slide moves",
    &[("backlash-y", "the two flats of y: play is as wide at both, elastic clearance wider away from the bearing")],
    |setup| a_screw(setup, 1),
    |[friction, stiffness], machine| wind(machine, 1, friction, stiffness),
);

const fn elastic_lost_motion(
    name: &'static str,
    about: &'static str,
    look_alikes: &'static [(&'static str, &'static str)],
    needs: fn(&Setup) -> Result<(), String>,
    act: fn([f64; 2], &mut Machine),
) -> Effect<2> {
    Effect {
        name,
        about,
        law: "play operator of width gap + 2*friction*(1/stiffness + |position - fixed_at|/(E*A))",
        source: "seed 000, fig. 2b, in series with the clearance of fig. 2a",
        belongs: Belongs::Machine,
        odds: Odds::of(0.3, "every drive winds up, a friction compensated one by little"),
        parameters: [
            Parameter::amplitude("friction", FORCE, "of the slide", (10.0, 10_000.0)),
            Parameter::shape(
                "stiffness",
                STIFFNESS,
                "of nut and bearing together; of the bearing beside screw.nut",
                SPRING,
            ),
        ],
        look_alikes,
        needs,
        act,
    }
}

fn wind(machine: &mut Machine, axis: usize, friction: f64, stiffness: f64) {
    let Drive { screw, nut, .. } = &machine.setup.drives[axis];
    machine.plays[axis].winding = screw.clone().map(|screw| Winding::new(friction, stiffness, screw, nut.as_ref()));
}

fn a_screw(setup: &Setup, axis: usize) -> Result<(), String> {
    setup.feedback.sees_screw()?;
    match setup.drives[axis].screw {
        Some(_) => Ok(()),
        None => Err(format!(
            "needs its screw: screw = {{ diameter = \"32 mm\", material = \"steel\", fixed_at = \"-400 mm\" }} in [drives.{}]",
            AXES[axis]
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_far_flat_is_cut_deeper() {
        // 600 N on 200 N/um is 3 um either way; Ø32 of steel adds 600·(0.4 ± 0.15)/(EA).
        let rigidity = 210e9 * std::f64::consts::PI * 0.016f64.powi(2);
        for (angle, length) in [(0.0, 0.55), (180.0, 0.25)] {
            let lost = 3.0 + 600.0 * length / rigidity * 1e6;
            for direction in DIRECTIONS {
                // Just behind the reversal the slide still stands where it was brought to.
                let computed = change("elastic-lost-motion-x", &[600.0, 200.0], direction, angle);
                assert!((computed + lost).abs() < 2.0 * lost / 450.0, "{angle}: {computed} and {lost}");
            }
        }
    }
}
