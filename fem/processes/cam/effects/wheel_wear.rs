//! The wheel is smaller than the one that the programme was made for.
//!
//! Every position of the wheel's centre is that of the programmed radius R; a wheel of R − loss leaves
//! `loss` on a profile whose programme is exact, and a little else on one whose blocks are long, for it
//! bridges their waves less. Left out: wear within one cam.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `wheel-wear`.
pub static WHEEL_WEAR: Effect<1> = Effect {
    name: "wheel-wear",
    about: "the wheel is smaller than the one that the programme was made for",
    law: "wheel radius = wheel.radius - loss; deviation of an exact programme += loss",
    source: "geometry of the envelope (seed 003)",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "every wheel wears"),
    parameters: [Parameter::amplitude("loss", MICRO, "of the radius", (1.0, 300.0))],
    look_alikes: &[(
        "grinding-deflection",
        "where the feed of the grinding point differs: arcs against straight flanks, or half the cam speed",
    )],
    needs: nothing,
    act: |[loss], machine| machine.wear = loss,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn what_the_wheel_has_lost_stays_on_the_cam() {
        for deviation in deviations("wheel-wear", &[25.0], &[0.0, 77.0, 180.0, 301.0]) {
            assert!((deviation - 25.0).abs() < 2e-3, "{deviation}");
        }
    }
}
