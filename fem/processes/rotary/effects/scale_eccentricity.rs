//! The scale on the table runs out.
//!
//! (e/r)·sin(θ + phase): a ring of lines of radius r (m) that is mounted by e (m) off the axis passes its one reading head
//! too fast and too slow once a turn [geometry of an eccentric circle; HEIDENHAIN, Position Encoders for Servo Drives,
//! Δφ = ±412·e/D in arcsec with e in um and D in mm]. Of a loop that the scale closes the table stands off by as much with the other sign, which is another phase.
//! Readings of this one head cannot tell it from a wheel that runs out; the mean of two heads that stand opposite each other
//! has none. Left out: a ring that is oval (`scale-second-harmonic`), the run-out of the bearing, which adds to e.

use super::super::machine::Effect;
use super::super::setup::Setup;
use super::needs::a_scale_on_the_table;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, MICRO};

/// `scale-eccentricity`.
pub static SCALE_ECCENTRICITY: Effect<2> = Effect {
    name: "scale-eccentricity",
    about: "the ring of the scale on the table is mounted off its axis",
    law: "deviation += eccentricity/scale.radius*sin(angle + phase)",
    source: "HEIDENHAIN, Position Encoders for Servo Drives, error of an eccentric graduation: 412*e/D",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "rings are centred to some micrometres, which are arc seconds"),
    parameters: [
        Parameter::amplitude("eccentricity", MICRO, "of the ring from the axis", (0.5, 200.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        (
            "wheel-eccentricity",
            "a second reading head opposite the first, or a polygon and an autocollimator; readings of one head cannot tell",
        ),
        ("scale-second-harmonic", "targets all round: on a part of a turn one wave passes for another"),
        ("unbalance", "another load or a counterweight: only what is out of balance changes with it"),
        ("ratio-error", "more of a turn: a part of a sine is nearly straight"),
    ],
    needs: a_ring,
    act: |[eccentricity, phase], machine| {
        let radius = machine.setup.scale.and_then(|scale| scale.radius).unwrap_or(f64::INFINITY);
        machine.add(move |angle, _| eccentricity / radius * (angle + phase).sin());
    },
};

fn a_ring(setup: &Setup) -> Result<(), String> {
    a_scale_on_the_table(setup)?;
    match setup.scale.and_then(|scale| scale.radius) {
        Some(_) => Ok(()),
        None => Err("needs the ring of the scale: `radius` in [scale]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_goes_once_a_turn_by_e_over_r() {
        // A micrometre on a ring of 100 mm across: 4.12 arcsec by the maker's rule, 1/50000 rad.
        let at = |angle| both((WORM, "scale-eccentricity", &[1.0, 0.0]), angle);
        assert!((at(90.0)[0] - 4.12).abs() < 0.01 && near(at(90.0)[0], 648_000.0 / std::f64::consts::PI / 50_000.0));
        assert!(near(at(180.0)[1], 0.0) && near(at(270.0)[0], -at(90.0)[0]));
    }
}
