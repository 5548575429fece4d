//! The slide pitches as it goes, and the point that is measured stands away from the scale.
//!
//! 4·height·s(1 − s), s = (x − from)/travel: the parabola that is left when the pitch angle changes quadratically along the guideway; height is its
//! peak (m), at the middle. What is straight in the pitch belongs to `scale-error`.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::MICRO;

/// `abbe-error`.
pub struct AbbeError;

static DESCRIPTION: Description = Description {
    name: "abbe-error",
    about: "the slide pitches on its guideway, away from the scale",
    law: "deviation += 4*height*s*(1 - s), s = position/travel",
    source: "Abbe's principle, with a pitch that changes quadratically",
    parameters: &[Parameter::signed("height", MICRO, "at the middle of the travel", (-100.0, 100.0))],
    look_alikes: &[],
};

impl Effect<Machine> for AbbeError {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let (height, from, travel) = (values["height"], machine.setup.from, machine.setup.travel);
        machine.add(move |at| {
            let s = (at.position - from) / travel;
            4.0 * height * s * (1.0 - s)
        });
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_peaks_in_the_middle() {
        assert!((both("abbe-error", &[-9.0], 250.0)[0] + 9.0).abs() < 1e-12);
        assert!((both("abbe-error", &[-9.0], 125.0)[1] + 6.75).abs() < 1e-12);
        assert_eq!(both("abbe-error", &[-9.0], 500.0), [0.0, 0.0]);
    }
}
