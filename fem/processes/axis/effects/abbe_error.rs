//! The slide pitches as it goes, and the point that is measured stands away from the scale.
//!
//! 4·height·s(1 − s), s = (x − from)/travel: the parabola that is left when the pitch angle changes
//! quadratically along the guideway; height is its peak (m), at the middle. What is straight in the pitch
//! belongs to `scale-error`.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `abbe-error`.
pub static ABBE_ERROR: Effect<1> = Effect {
    name: "abbe-error",
    about: "the slide pitches on its guideway, away from the scale",
    law: "deviation += 4*height*s*(1 - s), s = (position - from)/travel",
    source: "Abbe's principle, with a pitch that changes quadratically",
    belongs: Belongs::Test,
    odds: Odds::of(0.2, "the line of measurement is put near the axis"),
    parameters: [Parameter::signed("height", MICRO, "at the middle of the travel", (-100.0, 100.0))],
    look_alikes: &[("worn-screw", "approaches from both sides: play errs from one of them")],
    needs: nothing,
    act: |[height], machine| {
        let (from, travel) = (machine.setup.from, machine.setup.travel);
        machine.add(move |position, _| {
            let s = (position - from) / travel;
            4.0 * height * s * (1.0 - s)
        });
    },
};

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
