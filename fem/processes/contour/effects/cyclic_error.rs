//! An axis is wrong by a wave over each turn of its screw or each period of its scale.
//!
//! position += amplitude·sin(2π·position/lead + phase), the position counted from the contour's centre. On
//! a straight side at φ to the axis the wave is lead/cos φ long [seed 000].

use super::super::machine::{Cyclic, Effect, Machine};
use super::super::setup::Setup;
use super::stick_slip::FEED;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, MICRO};

/// `cyclic-error-x`.
pub static X: Effect<2> = cyclic_error(
    "cyclic-error-x",
    "x is wrong by a wave over each turn of its screw",
    &[("stick-slip-x", FEED)],
    |[amplitude, phase], machine| {
        machine.cyclic[0] = Cyclic { amplitude, phase };
    },
    |setup| a_lead(setup, 0),
);
/// `cyclic-error-y`.
pub static Y: Effect<2> = cyclic_error(
    "cyclic-error-y",
    "y is wrong by a wave over each turn of its screw",
    &[("stick-slip-y", FEED)],
    |[amplitude, phase], machine| {
        machine.cyclic[1] = Cyclic { amplitude, phase };
    },
    |setup| a_lead(setup, 1),
);

const fn cyclic_error(
    name: &'static str,
    about: &'static str,
    look_alikes: &'static [(&'static str, &'static str)],
    act: fn([f64; 2], &mut Machine),
    needs: fn(&Setup) -> Result<(), String>,
) -> Effect<2> {
    Effect {
        name,
        about,
        law: "position += amplitude*sin(2*pi*position/lead + phase), lead = drives.lead, or drives.x.lead and drives.y.lead",
        source: "seed 000 (error within the period of the feedback)",
        belongs: Belongs::Test,
        odds: Odds::of(0.3, "every screw and every encoder has one, mostly small"),
        parameters: [
            Parameter::amplitude("amplitude", MICRO, "half of peak to valley", (0.2, 50.0)),
            Parameter::phase("phase", ANGLE, "at the contour's centre", 360.0),
        ],
        look_alikes,
        needs,
        act,
    }
}

fn a_lead(setup: &Setup, axis: usize) -> Result<(), String> {
    match setup.drives[axis].lead {
        Some(_) => Ok(()),
        None => Err("needs its period: lead = \"10 mm\" in [drives]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_wave_counts_from_the_centre() {
        // At 0 deg x is 150 mm less the contraction of 0.37 um: fifteen turns of 10 mm.
        for direction in DIRECTIONS {
            assert!((change("cyclic-error-x", &[2.0, 30.0], direction, 0.0) - 1.0).abs() < 1e-3);
            assert!((change("cyclic-error-y", &[2.0, 90.0], direction, 90.0) - 2.0).abs() < 1e-3);
        }
    }
}
