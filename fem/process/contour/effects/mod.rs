//! The effects of two axes on a contour. One file and one line each; effects of either axis share a file.

mod backlash;
mod centre_offset;
mod cyclic_error;
mod reversal_spike;
mod scale_mismatch;
mod servo_mismatch;
mod squareness;

use super::Machine;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Machine>] = &[
    &servo_mismatch::ServoMismatch,
    &backlash::X,
    &backlash::Y,
    &reversal_spike::X,
    &reversal_spike::Y,
    &squareness::Squareness,
    &scale_mismatch::ScaleMismatch,
    &cyclic_error::X,
    &cyclic_error::Y,
    &centre_offset::CentreOffset,
];

#[cfg(test)]
mod bench {
    //! A machine to try effects on.

    use std::sync::Arc;

    use super::super::machine::Lap;
    use super::super::path::Direction;
    use super::super::{Contouring, Setup, effect};
    use crate::input::Reader;
    use crate::process::Active;

    pub const DIRECTIONS: [Direction; 2] = [Direction::CounterClockwise, Direction::Clockwise];

    /// R = 150 mm at 1000 mm/min, 50/s, screws of 10 mm: v/Kv = 1/3 mm, v/(R·Kv) = 1/450.
    const MODEL: &str = r#"
        path = { shape = "circle", radius = "150 mm", feed = "1000 mm/min" }
        drives = { gain = "50 /s", lead = "10 mm" }
    "#;

    /// What an effect of these canonical values changes at an angle (deg), um.
    pub fn change(name: &str, canonical: &[f64], direction: Direction, angle: f64) -> f64 {
        let model = toml_edit::Document::parse(MODEL).unwrap();
        let (setup, _, problems) = Reader::document(model.as_table(), Setup::read);
        assert_eq!(problems, []);
        let setup = Arc::new(setup);
        let description = effect(name).unwrap().description();
        let values = description.parameters.iter().zip(canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
        let [ideal, real] = [&[][..], &[Active { description, values, written: None }]].map(|active| {
            let job = Contouring::equip(setup.clone(), active);
            Lap::new(&job.machine, direction, setup.feed).deviation(&setup.path.at(angle.to_radians()))
        });
        1e6 * (real - ideal)
    }
}
