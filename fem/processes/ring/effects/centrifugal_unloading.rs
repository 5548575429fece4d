//! The turning chuck throws its jaws outwards.
//!
//! While boring the force of each jaw is F = max(0, F₀ − m·r·ω²): F₀ at standstill (N), m·r the `jaw_moment`
//! of a jaw about the spindle's axis (kg·m), ω the spindle speed (rad/s). Above ω = √(F₀/(m·r)) the ring is
//! let go, and a run says at how many rpm. The clamped ring is measured at standstill. Jaws of which one presses harder than the next
//! lose the same force each, and those of a membrane that part of it which the ring does not spring after. Left out: hysteresis
//! of the chuck's drive, the ring's own widening under its inertia, counterweights.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::JAW_MOMENT;

/// `centrifugal-unloading`.
pub static CENTRIFUGAL_UNLOADING: Effect<1> = Effect {
    name: "centrifugal-unloading",
    about: "turning throws the jaws outwards, and they clamp less; from inside more",
    law: "F = max(0, F0 - jaw_moment*omega^2) while it is cut, F0 + jaw_moment*omega^2 from inside",
    source: "mechanics of rotation",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "jaws fly out, but at most speeds by little"),
    parameters: [Parameter::amplitude("jaw_moment", JAW_MOMENT, "mass of a jaw times its radius", (2.0, 300.0))],
    look_alikes: &[("jaw-contact-arc", "a second spindle speed, or the ring clamped and standing still")],
    needs: |setup| match setup.spindle_speed {
        Some(_) => Ok(()),
        None => Err("needs the spindle speed: spindle_speed = \"400 rpm\" in [cut]".into()),
    },
    act: |[moment], machine| machine.jaw_moment = moment,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::units::SPINDLE_SPEED;

    #[test]
    fn force_falls_with_the_square_of_the_speed_down_to_nothing() {
        let chuck = chuck("centrifugal-unloading", &[50.0]);
        let machine = chuck.machine();
        // 0.05 kg m · (100 rad/s)² = 500 N.
        assert!((machine.force_at(3000.0, 100.0) - 2500.0).abs() < 1e-9);
        assert_eq!(machine.force_at(3000.0, 1000.0), 0.0);
        // √(3000/0.05) rad/s = 244.949 rad/s = 2339.1 rpm.
        assert!((SPINDLE_SPEED.from_si(machine.let_go()) - 2339.09).abs() < 0.01);
    }
}
