//! The wheel's centre runs above or below the cam's axis.
//!
//! The slide brings the wheel's centre to (x, h) instead of (x, 0): its distance from the axis is √(x² +
//! h²), and it stands at another angle of the cam, by atan(h/x), counter-clockwise positive. Mostly the
//! profile is turned thereby, a little more where the cam is small. Left out: a height that changes along the
//! slide.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `centre-height`.
pub static CENTRE_HEIGHT: Effect<1> = Effect {
    name: "centre-height",
    about: "the wheel's centre runs above (+, counter-clockwise) or below the cam's axis",
    law: "wheel centre at (x, height): radius sqrt(x^2 + height^2), angle atan(height/x)",
    source: "geometry of the slide",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "heads are set by hand"),
    parameters: [Parameter::signed("height", MICRO, "of the wheel's centre above the cam's axis", (-500.0, 500.0))],
    look_alikes: &[
        ("servo-lag", "another cam speed: a lag grows with it, a height does not"),
        ("infeed-backlash", "the programme run from its end: a backlash changes its sign, a height does not"),
    ],
    needs: nothing,
    act: |[height], machine| machine.height = height,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_wheel_above_the_axis_turns_the_profile_forward() {
        // At 90 and 270 deg of a circle about (4, 0) mm: turned by h/x, and farther out by h²/2x; x =
        // √(195² − 4²) there.
        let x = (195.0f64 * 195.0 - 16.0).sqrt();
        let computed = deviations("centre-height", &[300.0], &[90.0, 270.0]);
        // The normal there leans so that of the way sideways 384^½/20 stands along it.
        let (turned, out) = (300.0 / x * 4.0 * 384f64.sqrt() / 20.0, 0.3 * 300.0 / (2.0 * x));
        assert!((0.5 * (computed[0] - computed[1]) - turned).abs() < 0.01 * turned, "{computed:?} {turned}");
        assert!((0.5 * (computed[0] + computed[1]) - out).abs() < 0.05, "{computed:?} {out}");
    }
}
