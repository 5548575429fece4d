//! The slide is late against the cam.
//!
//! The slide stands where it was commanded `time` ago, when the cam was ω·time behind. At one speed of the
//! cam the whole profile is thereby turned by ω·time against its keyway, the way in which the grinding
//! point goes; the deviation is that of a turned profile, about ω·time·dr/ds·r. A cam axis that is late
//! does the same with the other sign: only the difference of the two lags shows, and `time` is that of the
//! slide less that of the cam (negative where the cam's is longer). Left out: a lag that changes with
//! frequency, and one in blocks that begin and end at rest.

use super::super::course::Course;
use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::SHORT_TIME;

/// `servo-lag`.
pub static SERVO_LAG: Effect<1> = Effect {
    name: "servo-lag",
    about: "the slide is late against the cam (or the cam early: only the difference shows)",
    law: "x(t) = x_commanded(t - time): the cam angle at which the slide acts is late by omega*time",
    source: "seed 003 (interpolation of cam and slide)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every drive lags, some with feed-forward"),
    parameters: [Parameter::signed("time", SHORT_TIME, "of the slide less that of the cam", (-20.0, 20.0))],
    look_alikes: &[
        ("centre-height", "another cam speed: a lag grows with it, a height does not"),
        ("infeed-backlash", "another cam speed; a backlash is the same on steep and gentle flanks"),
    ],
    needs: no_rest,
    act: |[time], machine| machine.lag = time,
};

fn no_rest(setup: &Setup) -> Result<(), String> {
    match setup.program.courses.iter().all(|course| *course == Course::STEADY) {
        true => Ok(()),
        false => Err("acts on blocks that pass without rest: leave out the accelerations in [program]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_profile_is_turned_against_its_keyway() {
        // The circle about (4, 0) lies about (4cos δ, 4sin δ), δ = 20 rpm · 5 ms; along the normal n of a
        // point of the old one s = n·d − r + √(r² − d² + (n·d)²).
        let turned = 20.0 * std::f64::consts::TAU / 60.0 * 5e-3;
        let d = [4e3 * (f64::cos(turned) - 1.0), 4e3 * f64::sin(turned)];
        for angle in [10.0f64, 90.0, 200.0, 315.0] {
            let (sine, cosine) = angle.to_radians().sin_cos();
            let along = 4e3 * cosine + (4e8 - 1.6e7 * sine * sine).sqrt();
            let n = [(along * cosine - 4e3) / 2e4, along * sine / 2e4];
            let nd = n[0] * d[0] + n[1] * d[1];
            let expected = nd - 2e4 + (4e8 - d[0] * d[0] - d[1] * d[1] + nd * nd).sqrt();
            let computed = deviations("servo-lag", &[5.0], &[angle])[0];
            assert!((computed - expected).abs() < 3e-3, "{angle}: {computed} and {expected}");
        }
    }
}
