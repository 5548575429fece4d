//! Play that changes steadily along the travel.
//!
//! δ(x) += change·(s − 1/2), s = (x − from)/travel, on the way back: a nut that is tighter at one end, a screw
//! that tapers, a gib that is set at one end; change (m) is from the beginning of the travel to its end, of
//! either sign. None in the middle, so that what is the same all along stays with `backlash`. It is the first
//! order of a play that depends on the place, as the reversals B_i of ISO 230-2 show it target by target; a
//! play angle of the guideways at a lever arm that grows with the position is the same law. Left out: play
//! that is larger in the middle (`worn-screw`).

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `uneven-backlash`.
pub static UNEVEN_BACKLASH: Effect<1> = Effect {
    name: "uneven-backlash",
    about: "play changes steadily from one end of the travel to the other",
    law: "deviation += change*(s - 1/2), approaching in -, s = (position - from)/travel",
    source: "ISO 230-2, reversal B_i at every target; first order in the position",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "screws wear where they are used most"),
    parameters: [Parameter::signed("change", MICRO, "of the play, from end to end of the travel", (-100.0, 100.0))],
    look_alikes: &[
        ("elastic-lost-motion", "the way forwards: elastic clearance lags there too, play does not"),
        ("backlash", "targets from end to end of the travel, from both sides"),
        ("thermal-growth", "the order of approaches: + always before - lets growth pass for play"),
    ],
    needs: nothing,
    act: |[change], machine| {
        let (from, travel) = (machine.setup.from, machine.setup.travel);
        machine.add_play(move |position| change * ((position - from) / travel - 0.5));
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_is_none_in_the_middle_and_opposite_at_the_ends() {
        let at = |position| both("uneven-backlash", &[-12.0], position);
        assert_eq!([at(0.0), at(250.0), at(500.0)], [[0.0, 6.0], [0.0, 0.0], [0.0, -6.0]]);
        assert!((at(375.0)[1] + 3.0).abs() < 1e-12);
    }
}
