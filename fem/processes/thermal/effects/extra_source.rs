//! A source of heat that nobody has counted.
//!
//! A bearing, a seal or a nut gives off heat of its own from the start on, at one place, spread over the
//! section.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::solve::rod::{PointSource, Power};
use crate::units::{LENGTH, POWER};

/// `extra-source`.
pub static EXTRA_SOURCE: Effect<2> = Effect {
    name: "extra-source",
    about: "a further source of heat, such as a bearing's friction, on from the start",
    law: "rho*c*A*dT/dt += power*delta(x - at)",
    source: "seed 002, sources of heat in machine tools",
    belongs: Belongs::Test,
    odds: Odds::of(0.15, "sources are known as a rule"),
    parameters: [
        Parameter::place("at", LENGTH, "from the base", "x", (1.0, 1000.0)),
        Parameter::amplitude("power", POWER, "heat that it gives", (0.1, 100.0)),
    ],
    look_alikes: &[("ambient-drift", "another run, at another time of day")],
    needs: Setup::needs_sections,
    act: |[at, power], machine| {
        machine.sources.push(PointSource { at, power: Power::switched(power, &[]), heater: None });
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// All heat of an insulated rod stays in it, wherever it comes from.
    #[test]
    fn its_heat_adds_to_that_of_the_others() {
        let heated = rod("extra-source = { at = '70 mm', power = '4 W' }");
        let expansion = heated.setup().material.expansion;
        for time in [600.0, 6000.0, 10_800.0] {
            let heat = 15.0 * f64::min(time, 5400.0) + 4.0 * time;
            let exact = expansion * LENGTH * heat / capacity();
            assert!((elongation(&heated, time) / exact - 1.0).abs() < 1e-6);
        }
    }
}
