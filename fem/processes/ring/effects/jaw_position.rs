//! Two of three jaws stand out of place.
//!
//! Jaws 2 and 3 stand at 120° + error_2 and 240° + error_3 from jaw 1 (rad, positive counter-clockwise). The
//! ring floats until the three radial forces are in equilibrium: each is as the sine of the angle between
//! the other two (Lamy's theorem), and their mean is kept at the jaw force. All harmonics then occur, above
//! all an oval. Only for three jaws, which statics alone sets in equilibrium. Left out: friction, which lets
//! forces be unequal.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::ANGLE;

/// `jaw-position`.
pub static JAW_POSITION: Effect<2> = Effect {
    name: "jaw-position",
    about: "jaws 2 and 3 stand out of place, and the forces settle in equilibrium",
    law: "jaws at 0, 120 deg + error_2, 240 deg + error_3; F_i ~ sin(angle between the other two), mean F",
    source: "statics (Lamy's theorem)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "jaws are bored in place, but not often"),
    parameters: [
        Parameter::signed("error_2", ANGLE, "of jaw 2 from 120 deg", (-5.0, 5.0)),
        Parameter::signed("error_3", ANGLE, "of jaw 3 from 240 deg", (-5.0, 5.0)),
    ],
    look_alikes: &[
        ("residual-stress", "a second jaw force, or the ring turned in the chuck"),
        ("spindle-error", "a second jaw force"),
    ],
    needs: |setup| match setup.jaw_angles.len() {
        3 => Ok(()),
        jaws => Err(format!("is known of three jaws, which statics alone sets in equilibrium, not of {jaws}")),
    },
    act: |errors, machine| {
        machine.jaw_angles.iter_mut().skip(1).zip(errors).for_each(|(jaw, error)| *jaw += error);
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn forces_are_in_equilibrium_and_keep_their_mean() {
        let jaws = chuck("jaw-position", &[3.0, -2.0]).machine().jaws().unwrap();
        let sum = |part: fn(f64) -> f64| jaws.iter().map(|jaw| jaw.share * part(jaw.angle)).sum::<f64>();
        assert!(sum(f64::cos).abs() < 1e-14 && sum(f64::sin).abs() < 1e-14);
        assert!((sum(|_| 1.0) - 3.0).abs() < 1e-14);
        assert!(
            (jaws[1].angle.to_degrees() - 123.0).abs() < 1e-12 && (jaws[2].angle.to_degrees() - 238.0).abs() < 1e-12
        );
    }

    #[test]
    fn jaws_on_one_side_hold_nothing() {
        assert!(chuck("jaw-position", &[-80.0, -80.0]).machine().jaws().unwrap_err().message.contains("equilibrium"));
    }
}
