//! The guideway rises or falls: a hyperboloid.
//!
//! Δz = slope·x lifts the tool nose off the axis plane; the diameter becomes √((D + ΔD)² + 4Δz²), with the sum
//! ΔD of all that moves the nose across: a hyperboloid of revolution [seed 002 (2), (3)]; the handbook's
//! 2Δz²/D [seed 002 (7)] is its first term. slope in m per m along the axis, of either sign, with the same
//! effect.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::STEEP_SLOPE;

/// `guideway-height`.
pub static GUIDEWAY_HEIGHT: Effect<1> = Effect {
    name: "guideway-height",
    about: "the guideway rises or falls against the spindle axis; the shaft becomes a hyperboloid",
    law: "dD = sqrt((D + dD)^2 + 4*dz^2) - D, dz = slope*x",
    source: "seed 002 (2), (3), (7)",
    belongs: Belongs::Machine,
    odds: Odds::of(0.05, "a height error enters by its square"),
    parameters: [Parameter::signed("slope", STEEP_SLOPE, "rise of the guideway", (-5.0, 5.0))],
    look_alikes: &[("tailstock-compliance", "a second force: both grow with x squared, only one with the force")],
    needs: nothing,
    act: |[slope], machine| machine.add_lift(move |at| slope * at.x),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_height_adds_the_hyperboloid() {
        // Δz = 0.3 mm on Ø50 mm.
        let expected = 1e6 * ((0.05f64.powi(2) + 4.0 * 0.0003f64.powi(2)).sqrt() - 0.05);
        assert!((shift("guideway-height", &[2.0], moment()) - expected).abs() < 1e-9);
    }
}
