//! The servos of x and y follow with unequal gains.
//!
//! Kvx = Kv(1 + m/2), Kvy = Kv(1 − m/2): each axis lags by v/Kv of its own, and the tool leaves the path
//! by what differs. Counter-clockwise round a circle (v/2)·sin 2α·(1/Kvx − 1/Kvy), clockwise the opposite:
//! an ellipse at 45°. Along a straight side at β it is the offset v(Kvx − Kvy)/(2KvxKvy)·sin 2β outwards,
//! counter-clockwise [seed 000], so that of a rectangle one size grows by twice as much and the other
//! shrinks. Computed through the servos themselves, not by the formula. Gains that follow the feed are
//! effects of their own.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::NUMBER;

/// `servo-mismatch`.
pub static SERVO_MISMATCH: Effect<1> = Effect {
    name: "servo-mismatch",
    about: "the servos of x and y follow with unequal gains, and a circle becomes an ellipse at 45 deg",
    law: "Kvx = Kv*(1 + mismatch/2), Kvy = Kv*(1 - mismatch/2): (v/2)*sin(2*alpha)*(1/Kvx - 1/Kvy) ccw, the opposite cw",
    source: "seed 000, fig. 1 (printed there with the sign of a straight side)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "drives are matched, but not for ever"),
    parameters: [Parameter::signed("mismatch", NUMBER, "difference of the gains over their mean", (-0.3, 0.3))],
    look_alikes: &[
        ("squareness", "the other way round, or another feed: a mismatch changes its sign and grows with the feed"),
        ("gain-with-feed-x", "another feed: a mismatch grows with it, a gain that follows the feed with its square"),
        ("gain-with-feed-y", "another feed: a mismatch grows with it, a gain that follows the feed with its square"),
        ("cutting-deflection", "another feed, or a lap without cutting: a mismatch grows with the feed"),
    ],
    needs: nothing,
    act: |[mismatch], machine| {
        let half = 0.5 * mismatch;
        machine.gains = [1.0 + half, 1.0 - half].map(|part| part * machine.setup.gain);
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_ellipse_turns_over_with_the_direction() {
        // v/Kv = 1/3 mm, m = 0.1: 1/6 mm times (1/1.05 - 1/0.95).
        let expected = 1e3 / 6.0 * (1.0 / 1.05 - 1.0 / 0.95);
        let [ccw, cw] = DIRECTIONS.map(|d| change("servo-mismatch", &[0.1], d, 45.0));
        // The second order in v/(R·Kv) = 1/450 is left out.
        assert!((ccw - expected).abs() < 0.05 && (cw + expected).abs() < 0.05, "{ccw} {cw} {expected}");
    }
}
