//! Surfaces lose heat to the surroundings.
//!
//! Everything that is free loses h·(T − T_a) per area, h the coefficient (W/(m² K)): the round surface
//! of a rod, π·D per length, but not its ends; both faces of a plane body, and its edges; all faces of a body of
//! revolution; those to which a flux brings heat as well, but not such as have a film or a temperature of their own or
//! are `covered`. Still air takes some 5 to 15 W/(m² K), a stream or oil more. There is one
//! coefficient everywhere and always; radiation is in it as far as it is linear.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units;

/// `convection`.
pub static CONVECTION: Effect<1> = Effect {
    name: "convection",
    about: "free surfaces lose heat to the surroundings",
    law: "-h*p*(T - T_a) per length, h = coefficient, p = pi*D",
    source: "Newton's law of cooling; seed 002 (35)-(39)",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "no body stands in a vacuum"),
    parameters: [Parameter::amplitude(
        "coefficient",
        units::CONVECTION,
        "heat transfer to the surroundings",
        (2.0, 100.0),
    )],
    look_alikes: &[
        ("base-conductance", "the temperature of the base and of the free end"),
        ("contact-resistance", "temperatures on both sides of the joint"),
    ],
    needs: nothing,
    act: |[coefficient], machine| machine.convection += coefficient,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// Until the heat is off, what is lost goes as the mean rise: d(mean)/dt = P/C − (hπDL/C)·mean,
    /// exactly.
    #[test]
    fn the_mean_rise_is_that_of_a_lumped_body() {
        let heated = rod("convection = { coefficient = '25 W/m^2/K' }");
        let expansion = heated.setup().material.expansion;
        let loss = 25.0 * std::f64::consts::PI * 0.02 * LENGTH;
        for time in [600.0, 2400.0, 5400.0] {
            let mean = elongation(&heated, time) / (expansion * LENGTH);
            let exact = 15.0 / loss * -(-loss * time / capacity()).exp_m1();
            // Second-order steps of 30 s.
            assert!((mean / exact - 1.0).abs() < (30.0 * loss / capacity()).powi(2), "{mean} and {exact}");
        }
    }
}
