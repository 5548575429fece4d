//! The base loses heat into what holds it.
//!
//! At x = 0 flows G·(T(0) − T_a) to the surroundings, G the conductance (W/K): a chuck, a table, a flange
//! that stays as cold as the room. On a rectangle or a body of revolution it is spread evenly over the left edge. A holder that
//! warms up itself is left out.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::CONDUCTANCE;

/// `base-conductance`.
pub static BASE_CONDUCTANCE: Effect<1> = Effect {
    name: "base-conductance",
    about: "heat flows through the base into what holds the body",
    law: "k*A*dT/dx = conductance*(T - T_a) at x = 0",
    source: "third boundary condition (Carslaw and Jaeger)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every body stands on something"),
    parameters: [Parameter::amplitude("conductance", CONDUCTANCE, "from the base to the surroundings", (0.01, 10.0))],
    look_alikes: &[("convection", "the temperature of the base and of the free end")],
    needs: Setup::needs_sections,
    act: |[conductance], machine| machine.base += conductance,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// Long after: P through the base and along the rod. The slowest wave has died to e⁻¹⁰ (its rate is
    /// above G/(C + …)).
    #[test]
    fn the_base_takes_all_heat_in_the_end() {
        let heated = rod("base-conductance = { conductance = '5 W/K' }");
        let time = 5390.0;
        let along = 15.0 * LENGTH / conductance();
        let (base, end) = (rise(&heated, 0.0, time), rise(&heated, LENGTH, time));
        assert!((base / 3.0 - 1.0).abs() < 0.02, "{base}");
        assert!((end / (3.0 + along) - 1.0).abs() < 0.02, "{end}");
    }
}
