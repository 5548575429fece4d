//! A heater warms itself before it warms the body.
//!
//! The power of a source goes into a heater of heat capacity C (J/K) at one temperature T_h, which passes it on
//! through its contact G (W/K): C·T_h′ = P − G·(T_h − T), T the body's temperature where the source stands. Heat comes
//! late by some C/G, and goes on coming when the power is off. It loses heat to the body alone. Every source of the
//! model that has no heater of its own gets such a one.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::solve::rod::Heater;
use crate::units::{CONDUCTANCE, HEAT_CAPACITY};

/// `heater-capacity`.
pub static HEATER_CAPACITY: Effect<2> = Effect {
    name: "heater-capacity",
    about: "the heaters of the sources in the model store heat of their own, and pass it on late",
    law: "heat_capacity*dT_h/dt = P - contact*(T_h - T), contact*(T_h - T) comes into the body",
    source: "lumped heat balance of the heater",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every heater has mass"),
    parameters: [
        Parameter::amplitude("heat_capacity", HEAT_CAPACITY, "of the heater of each source", (1.0, 1000.0)),
        Parameter::shape("contact", CONDUCTANCE, "from each heater to the body", (0.05, 20.0)),
    ],
    look_alikes: &[("contact-resistance", "temperatures close to the heater"), ("sensor-lag", "the elongation")],
    needs: a_bare_source,
    act: |[heat_capacity, contact], machine| {
        let own = machine.setup.sources.len();
        // Without a capacity the power comes in at once.
        for source in machine.sources.iter_mut().take(own).filter(|s| s.heater.is_none() && heat_capacity > 0.0) {
            source.heater = Some(Heater { heat_capacity, contact });
        }
    },
};

fn a_bare_source(setup: &Setup) -> Result<(), String> {
    if setup.body.plane().is_some() {
        return Err(format!("is known of rods, not of {}", setup.body.kind()));
    }
    match setup.sources.iter().any(|s| s.heater.is_none()) {
        true => Ok(()),
        false => Err("needs a [[source]] without a heater of its own".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// Of a body that is warmed evenly, P/(C + C_b), the heater keeps its share and the excess that drives its heat
    /// into the body; when it is off, all of its heat has come.
    #[test]
    fn the_heater_keeps_its_share_until_it_is_off() {
        let heated = rod("heater-capacity = { heat_capacity = '40 J/K', contact = '2 W/K' }");
        let expansion = heated.setup().material.expansion;
        let stored = |time: f64| elongation(&heated, time) / (expansion * LENGTH) * capacity();
        // Both warm at the same rate once waves have settled.
        let rate = (stored(5000.0) - stored(4000.0)) / 1000.0;
        let share = 15.0 * capacity() / (capacity() + 40.0);
        assert!((rate / share - 1.0).abs() < 1e-3, "{rate} {share}");
        // In the end the heater is at the temperature of the rod, and has kept as much of the whole heat.
        let whole = 15.0 * 5400.0 * capacity() / (capacity() + 40.0);
        assert!((stored(10_800.0) / whole - 1.0).abs() < 1e-4);
    }

    /// However small it is and however well it touches: a search comes by such values.
    #[test]
    fn a_heater_that_holds_nothing_is_none() {
        let bare = rise(&rod(""), 0.19, 600.0);
        for (held, contact) in [("1e-12", "1e4"), ("1e-3", "1e12"), ("1e-9", "1e9")] {
            let heater = format!("heater-capacity = {{ heat_capacity = '{held} J/K', contact = '{contact} W/K' }}");
            assert!((rise(&rod(&heater), 0.19, 600.0) / bare - 1.0).abs() < 1e-4, "{held} {contact}");
        }
    }
}
