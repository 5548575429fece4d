//! A screw that is worn where it works most.
//!
//! δ(x) += depth·4·s(1 − s), s = (x − from)/travel, on the way back: the flanks wear in the middle of the
//! travel, and the play there grows by depth (m) over that at the ends, which `backlash` tells. The parabola is
//! the second order of a play that depends on the place, as the reversals B_i of ISO 230-2 show it target by
//! target. Left out: wear in places of its own, where one part is made all the time, and what the worn flank
//! does to the way forwards.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `worn-screw`.
pub static WORN_SCREW: Effect<1> = Effect {
    name: "worn-screw",
    about: "the screw is worn in the middle of the travel, and has more play there than at its ends",
    law: "deviation += depth*4*s*(1 - s), approaching in -, s = (position - from)/travel",
    source: "ISO 230-2, reversal B_i at every target; second order in the position",
    belongs: Belongs::Test,
    odds: Odds::of(0.2, "screws wear where they are used most"),
    parameters: [Parameter::amplitude("depth", MICRO, "play in the middle over that at the ends", (0.5, 100.0))],
    look_alikes: &[
        ("backlash", "targets from end to end of the travel, from both sides"),
        ("abbe-error", "approaches from both sides: a pitching slide errs alike from either"),
    ],
    needs: nothing,
    act: |[depth], machine| {
        let (from, travel) = (machine.setup.from, machine.setup.travel);
        machine.add_play(move |position| {
            let s = (position - from) / travel;
            4.0 * depth * s * (1.0 - s)
        });
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn play_is_largest_in_the_middle_and_on_the_way_back() {
        assert_eq!(both("worn-screw", &[16.0], 250.0), [0.0, 16.0]);
        assert!((both("worn-screw", &[16.0], 125.0)[1] - 12.0).abs() < 1e-12);
        assert_eq!(both("worn-screw", &[16.0], 500.0), [0.0, 0.0]);
    }
}
