//! The gain of a servo follows the speed of its axis.
//!
//! Kv(v) = Kv·(1 + change·|v|/feed), v the speed of the axis itself, feed that of the model, so that
//! `change` is what the gain differs by when the axis goes at that feed alone. The axis lags by v/Kv(v)
//! instead of v/Kv. On a straight side at β each gain stands at its own speed, v·|cos β| or v·|sin β|: the
//! offset is v·(Kvx − Kvy)/(2KvxKvy)·sin 2β with these gains [seed 000: gains that change with the feed].
//! Round a circle the further lag follows the speed from point to point; two axes that change alike leave
//! four lobes. To the first order in ω/Kv, that is in the lag of the axis as an angle of the circle: what
//! the change itself leaves behind is left out, and so are corners. The drive is late, and the slide goes by it through
//! its play.

use super::super::machine::{Effect, Machine};
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::NUMBER;

/// `gain-with-feed-x`.
pub static X: Effect<1> =
    gain_with_feed("gain-with-feed-x", "the gain of x changes with the speed of x", |[change], machine| {
        machine.gain_changes[0] = change
    });
/// `gain-with-feed-y`.
pub static Y: Effect<1> =
    gain_with_feed("gain-with-feed-y", "the gain of y changes with the speed of y", |[change], machine| {
        machine.gain_changes[1] = change
    });

const fn gain_with_feed(name: &'static str, about: &'static str, act: fn([f64; 1], &mut Machine)) -> Effect<1> {
    Effect {
        name,
        about,
        law: "Kv(v) = Kv*(1 + change*|v|/path.feed), v the axis' own speed; position -= v*(1/Kv(v) - 1/Kv)",
        source: "seed 000 (gains that change with the feed), the line by hand",
        belongs: Belongs::Test,
        odds: Odds::of(0.3, "friction lowers the gain of slow drives"),
        parameters: [Parameter::signed(
            "change",
            NUMBER,
            "of the gain at the feed of the model, over the gain",
            (-0.5, 0.5),
        )],
        look_alikes: &[(
            "servo-mismatch",
            "another feed: a mismatch grows with the feed, a gain that follows it with its square",
        )],
        needs: nothing,
        act,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_lag_follows_the_speed_of_its_axis() {
        // v/Kv = 1/3 mm; at 30 deg x goes at half the feed: 1/6 mm·(1/1.1 − 1), of which cos 30 shows
        // outwards.
        let outwards = 1e3 / 6.0 * (1.0 - 1.0 / 1.1) * 30f64.to_radians().cos();
        for (direction, sign) in DIRECTIONS.into_iter().zip([-1.0, 1.0]) {
            let computed = change("gain-with-feed-x", &[0.2], direction, 30.0);
            // The speed is that of the axis behind its lag of 1/450 rad.
            assert!((computed - sign * outwards).abs() < 3.0 / 450.0 * outwards, "{computed} {outwards}");
            assert!(change("gain-with-feed-y", &[0.2], direction, 0.0).abs() < 0.5);
        }
    }
}
