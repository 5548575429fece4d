//! The slide is fed through play.
//!
//! The slide stands anywhere within half of `gap` of its command and moves only when it is pushed: where the
//! radius grows it stays half of it inside, where it falls half of it outside, and where the command dwells
//! it stays where it was brought to. Left out: a grinding force that holds the slide against one side.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `infeed-backlash`.
pub static INFEED_BACKLASH: Effect<1> = Effect {
    name: "infeed-backlash",
    about: "the slide is fed through play, and lags behind by half of it either way",
    law: "play operator of width gap on the slide: -gap/2 where the radius grows, +gap/2 where it falls",
    source: "seed 000 (play in a feed axis)",
    belongs: Belongs::Machine,
    odds: Odds::of(0.5, "compensation is never exact"),
    parameters: [Parameter::amplitude("gap", MICRO, "width of the play", (1.0, 100.0))],
    look_alikes: &[
        ("servo-lag", "another cam speed: a lag grows with it"),
        ("centre-height", "the programme run from its end: a backlash changes its sign"),
    ],
    needs: nothing,
    act: |[gap], machine| machine.gap = gap,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_slide_stays_behind_by_half_the_gap() {
        // On a circle beside the axis the slide rises from 180 to 360 deg. Half of 10 um stands along the
        // slide, which leans by less than 2 deg from the normal.
        let computed = deviations("infeed-backlash", &[10.0], &[90.0, 270.0]);
        assert!((computed[0] - 5.0).abs() < 5.0 * 1e-3 && (computed[1] + 5.0).abs() < 5.0 * 1e-3, "{computed:?}");
    }
}
