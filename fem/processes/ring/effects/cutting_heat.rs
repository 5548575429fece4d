//! The ring is warm while it is bored.
//!
//! Bored to size while it is warmer than when it is measured by ΔT (K), the bore shrinks alike all around:
//! deviation −= α·Ri·ΔT. The least-squares circle takes that out, so that the effect is known of `absolute`
//! deviations only. Left out: heat that is not even around the ring.

use super::super::machine::Effect;
use super::super::setup::Reference;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::TEMPERATURE_RISE;

/// `cutting-heat`.
pub static CUTTING_HEAT: Effect<1> = Effect {
    name: "cutting-heat",
    about: "cut warm, the ring shrinks as it cools",
    law: "deviation -= expansion*R*temperature_rise, R that is cut, absolute reference only",
    source: "seed 002 (36)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "all work warms, much of it under coolant by little"),
    parameters: [Parameter::amplitude(
        "temperature_rise",
        TEMPERATURE_RISE,
        "of the ring while it is cut, over when it is measured",
        (1.0, 60.0),
    )],
    look_alikes: &[],
    needs: |setup| match setup.reference {
        Reference::Absolute => Ok(()),
        Reference::LeastSquaresCircle => {
            Err("changes the radius alike all around, and the least-squares circle takes that out".into())
        }
    },
    act: |[rise], machine| {
        machine.warmth += machine.setup.material.expansion * machine.setup.cut_radius() * rise;
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_warm_ring_shrinks() {
        // 11.5e-6 · 42 mm · 10 K = 4.83 um.
        assert!((mark("cutting-heat", &[10.0], 40.0, 0.0) + 4.83).abs() < 1e-12);
    }
}
