//! Clearance is taken up before anything resists.
//!
//! y += gap as soon as the joint transmits a force, S > 0, on loading and unloading alike; where it transmits none
//! it stands where it stood [seed 000, fig. 2 a and fig. 5 a]. Without friction S is the force F; friction beside it
//! holds the first of the load, and the clearance open while it is let go: it is crossed where S changes its sign. A
//! preload has taken the clearance up before any force acts: there is none left [fig. 5 b]. A force that is reversed
//! runs through it once on either way. gap in m.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, UnitRole, nothing};
use crate::units::MICRO;

/// `gap`.
pub static GAP: Effect<1> = Effect {
    name: "gap",
    about: "clearance is taken up as soon as a force acts",
    law: "y += gap for S > 0, S the force that friction leaves to the joint; none where a preload has taken it up",
    source: "seed 000, fig. 5",
    belongs: Belongs::Tested(UnitRole::Gap),
    odds: Odds::of(0.5, "joints have play unless they are preloaded"),
    parameters: [Parameter::amplitude("gap", MICRO, "clearance of the joint", (0.5, 100.0))],
    look_alikes: &[
        ("contact-joint", "small forces: a contact closes little by little"),
        ("datum-offset", "a reading without force before loading: clearance is not taken up there"),
    ],
    needs: nothing,
    act: |[gap], machine| machine.curve.gap += gap,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn clearance_opens_with_the_force() {
        for branch in [Load, Unload] {
            assert_eq!(displacement("gap", &[5.0], 0.0, branch), 0.0);
            assert!((displacement("gap", &[5.0], 80.0, branch) - 6.0).abs() < 1e-9);
        }
    }
}
