//! The effects of two axes on a contour. One file and one line each; effects of either axis share a file.

mod backlash;
mod centre_offset;
mod cutting_deflection;
mod cyclic_error;
mod elastic_lost_motion;
mod gain_with_feed;
mod reversal_spike;
mod scale_mismatch;
mod servo_mismatch;
mod squareness;
mod stick_slip;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &servo_mismatch::SERVO_MISMATCH,
    &gain_with_feed::X,
    &gain_with_feed::Y,
    &backlash::X,
    &backlash::Y,
    &elastic_lost_motion::X,
    &elastic_lost_motion::Y,
    &reversal_spike::X,
    &reversal_spike::Y,
    &squareness::SQUARENESS,
    &scale_mismatch::SCALE_MISMATCH,
    &cyclic_error::X,
    &cyclic_error::Y,
    &stick_slip::X,
    &stick_slip::Y,
    &cutting_deflection::CUTTING_DEFLECTION,
    &centre_offset::CENTRE_OFFSET,
];

#[cfg(test)]
mod bench {
    //! A machine to try effects on.

    use super::super::Contour;
    use super::super::forward::Lap;
    use super::super::path::Direction;
    use crate::process::with_effect;

    pub const DIRECTIONS: [Direction; 2] = [Direction::CounterClockwise, Direction::Clockwise];

    /// R = 150 mm at 1000 mm/min, 50/s, screws of 10 mm: v/Kv = 1/3 mm, v/(R·Kv) = 1/450.
    const MODEL: &str = r#"
        path = { shape = "circle", radius = "150 mm", feed = "1000 mm/min" }
        drives = { gain = "50 /s", lead = "10 mm", frequency = "0.5 Hz", x = { screw = { material = "steel", diameter = "32 mm", fixed_at = "-400 mm" } } }
        cut = { normal_force = "200 N", tangential_force = "120 N" }
    "#;

    /// Change that an effect of these canonical values makes at an angle (deg), um.
    pub fn change(name: &str, canonical: &[f64], direction: Direction, angle: f64) -> f64 {
        let real = with_effect::<Contour>(MODEL, name, canonical);
        let ideal = super::Machine::ideal(real.machine().setup.clone());
        let deviation = |machine| {
            let setup = &real.machine().setup;
            Lap::new(machine, direction, setup.feed).deviation(&setup.path.at(angle.to_radians()))
        };
        1e6 * (deviation(real.machine()) - deviation(&ideal))
    }
}
