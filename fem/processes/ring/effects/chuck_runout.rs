//! The chuck runs out once a turn.
//!
//! The taper of the spindle's nose, or the chuck on it, stands off the spindle's axis: an indicator on what the
//! chuck holds reads `runout` over a turn (m, total), with its crest at `phase` from jaw 1 (rad). The bore is
//! round about the spindle's axis, and off the ring's own by half the reading: deviation −= runout/2·cos(θ −
//! phase). The tool finds the blank's bore off the axis by as much, so that what `copying` leaves of uneven
//! depths is left of it too. The least-squares circle takes out where a centre lies, so that the effect is known of
//! `absolute` deviations only. Left out: runout²/(8·Ri), by which a circle that is aside is no cosine.

use super::super::machine::Effect;
use super::super::setup::Reference;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, MICRO};

/// `chuck-runout`.
pub static CHUCK_RUNOUT: Effect<2> = Effect {
    name: "chuck-runout",
    about: "chuck or spindle taper runs out once a turn, and what is cut is off the ring's axis",
    law: "deviation -= runout/2*cos(theta - phase), absolute reference only",
    source: "geometry of two axes; cf. seed 002, errors of machines, 4",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "as large as the clamping was careless"),
    parameters: [
        Parameter::amplitude("runout", MICRO, "reading of an indicator over a turn", (1.0, 100.0)),
        Parameter::phase("phase", ANGLE, "where its crest stands from jaw 1", 360.0),
    ],
    look_alikes: &[],
    needs: |setup| match setup.reference {
        Reference::Absolute => Ok(()),
        Reference::LeastSquaresCircle => {
            Err("moves the centre of what is cut, and the least-squares circle takes that out".into())
        }
    },
    act: |[runout, phase], machine| {
        machine.eccentricity = [phase.cos(), phase.sin()].map(|part| 0.5 * runout * part);
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_bore_moves_by_half_the_reading_and_stays_with_the_machine() {
        for orientation in [0.0, 30.0] {
            for (angle, expected) in [(50.0, -12.0), (110.0, -6.0), (140.0, 0.0), (230.0, 12.0)] {
                assert!((mark("chuck-runout", &[24.0, 50.0], angle, orientation) - expected).abs() < 1e-9);
            }
        }
    }
}
