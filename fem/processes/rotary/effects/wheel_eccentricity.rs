//! The wheel on the table runs out.
//!
//! (e/r)·sin(θ + phase): a wheel whose pitch circle of radius r (m) is mounted by e (m) off the axis meets the worm, or the
//! last pinion, at a lever arm that goes by e·cos, and the table runs ahead and behind once a turn by e/r [geometry of an
//! eccentric circle; first order in e/r]. To one reading it is exactly a scale that runs out (`scale-eccentricity`). Left
//! out: the pressure angle α of the teeth, by which one flank has e/(r·cos α)·sin(θ + phase ∓ α), 6 % more at 20 deg; and the
//! play that comes and goes with it (`uneven-backlash`).

use super::super::machine::Effect;
use super::super::setup::Setup;
use super::needs::a_drive_that_shows;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, MICRO};

/// `wheel-eccentricity`.
pub static WHEEL_ECCENTRICITY: Effect<2> = Effect {
    name: "wheel-eccentricity",
    about: "the wheel on the table is mounted off its axis",
    law: "deviation += eccentricity/drive.pitch_radius*sin(angle + phase)",
    source: "geometry of an eccentric circle, first order in e/r",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "wheels are centred to some micrometres, which are arc seconds"),
    parameters: [
        Parameter::amplitude("eccentricity", MICRO, "of the pitch circle from the axis", (1.0, 200.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        (
            "scale-eccentricity",
            "a second reading head opposite the first, or a polygon and an autocollimator; readings of one head cannot tell",
        ),
        ("unbalance", "another load or a counterweight: only what is out of balance changes with it"),
        ("ratio-error", "more of a turn: a part of a sine is nearly straight"),
    ],
    needs: a_wheel,
    act: |[eccentricity, phase], machine| {
        let radius = machine.setup.drive.pitch_radius.unwrap_or(f64::INFINITY);
        machine.add(move |angle, _| eccentricity / radius * (angle + phase).sin());
    },
};

fn a_wheel(setup: &Setup) -> Result<(), String> {
    match setup.drive.pitch_radius {
        Some(_) => a_drive_that_shows(setup),
        None => Err("needs a wheel on the table: `pitch_radius` in [drive]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_goes_once_a_turn_by_e_over_r() {
        // 10 um on 100 mm are 1e-4 rad, 20.6265 arcsec.
        let at = |angle| both((WORM, "wheel-eccentricity", &[10.0, 30.0]), angle);
        let peak = 1e-4 * 648_000.0 / std::f64::consts::PI;
        assert!(near(at(60.0)[0], peak) && near(at(240.0)[1], -peak) && near(at(0.0)[0], 0.5 * peak));
    }
}
