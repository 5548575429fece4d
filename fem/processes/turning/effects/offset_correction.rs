//! The tool's offset was corrected between two parts.
//!
//! ΔD += diameter·\[part > after\]: the operator enters a correction, and the nose stands elsewhere by half of it on
//! every later part [geometry; a step (intervention) in a series, Box and Tiao 1975]. diameter in m, of either sign;
//! after is the number of a part, and rounded to a whole one. In a machine that yields the depth of cut changes by it
//! too, and with force-feedback the gap. A correction that is written down belongs into `[batch]`. Left out:
//! corrections of another axis, and such as hold for some sections of the shaft only.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `offset-correction`.
pub static OFFSET_CORRECTION: Effect<2> = Effect {
    name: "offset-correction",
    about: "the tool's offset was corrected between two parts",
    law: "dD += diameter*[part > after]",
    source: "a step (intervention): Box & Tiao, J. Am. Stat. Assoc. 70, 1975",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "offsets are corrected in many batches, and mostly written down"),
    parameters: [
        Parameter::after("after", "part after which it was corrected", "part", (1.0, 50.0)),
        Parameter::signed("diameter", MICRO, "change of the diameter of all later parts", (-100.0, 100.0)),
    ],
    look_alikes: &[("insert-change", "parts further on: a new edge wears in anew, a correction stays as it is")],
    needs: several_parts,
    act: |[after, diameter], machine| {
        machine.add_shift(move |at| if at.part as f64 > after.round() { diameter } else { 0.0 });
    },
};

/// Something between parts happens in a batch only.
pub(super) fn several_parts(setup: &Setup) -> Result<(), String> {
    match setup.schedule.parts > 1 {
        true => Ok(()),
        false => Err("needs a batch of several parts: `parts` in [batch]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::machine::Moment;
    use super::super::bench::*;

    #[test]
    fn later_parts_are_smaller_by_the_correction() {
        let on = |part: usize, after: f64| {
            let corrected = lathe("centres", "offset-correction", &[after, -10.0]);
            1e6 * unloaded(corrected.machine(), &Moment { part, ..moment() }).unwrap()
        };
        assert_eq!([1, 2, 3].map(|part| on(part, 1.0)), [0.0, -10.0, -10.0]);
        // The law is that of the whole number.
        assert_eq!([1, 2, 3].map(|part| on(part, 1.6)), [0.0, 0.0, -10.0]);
    }
}
