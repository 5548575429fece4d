//! The ring is warm while it is bored.
//!
//! Bored to size while it is warmer than when it is measured by ΔT (K), the bore shrinks: deviation −= α·Ri·ΔT, alike all around. The
//! least-squares circle takes that out, so that the effect is known of `absolute` deviations only. Left out: heat that is not even around the ring.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::TEMPERATURE_RISE;

/// `cutting-heat`.
pub struct CuttingHeat;

static DESCRIPTION: Description = Description {
    name: "cutting-heat",
    about: "bored warm, the ring shrinks as it cools",
    law: "deviation -= expansion*Ri*temperature_rise, absolute reference only",
    source: "seed 002 (36)",
    parameters: &[Parameter::amplitude(
        "temperature_rise",
        TEMPERATURE_RISE,
        "of the ring while it is bored, over when it is measured",
        (1.0, 60.0),
    )],
    look_alikes: &[],
};

impl Effect<Machine> for CuttingHeat {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let shrinkage = machine.setup.material.expansion * machine.setup.inner_radius * values["temperature_rise"];
        machine.mark(move |_| -shrinkage);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_warm_ring_shrinks() {
        // 11.5e-6 · 42 mm · 10 K = 4.83 um.
        assert!((mark("cutting-heat", &[10.0], 40.0, 0.0) + 4.83).abs() < 1e-12);
    }
}
