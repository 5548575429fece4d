//! The scale on the table is oval.
//!
//! A·sin(2θ + phase), A in rad: a ring that is clamped out of round by its fit or its screws, or two heads that stand
//! opposite each other, in whose mean eccentricity is gone and this is left.

use super::super::machine::Effect;
use super::needs::a_scale_on_the_table;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `scale-second-harmonic`.
pub static SCALE_SECOND_HARMONIC: Effect<2> = Effect {
    name: "scale-second-harmonic",
    about: "the ring of the scale on the table is oval: an error twice a turn",
    law: "deviation += amplitude*sin(2*angle + phase)",
    source: "geometry of an oval ring, first order",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "rings follow the seat on which they are clamped"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley", (0.1, 60.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[("scale-eccentricity", "targets all round: on a part of a turn one wave passes for another")],
    needs: a_scale_on_the_table,
    act: |[amplitude, phase], machine| machine.add(move |angle, _| amplitude * (2.0 * angle + phase).sin()),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_goes_twice_a_turn() {
        let at = |angle| both((WORM, "scale-second-harmonic", &[3.0, 0.0]), angle);
        assert!(near(at(45.0)[0], 3.0) && near(at(135.0)[1], -3.0) && near(at(225.0)[0], 3.0));
    }
}
