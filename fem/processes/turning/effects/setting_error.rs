//! The tool is set off its size.
//!
//! ΔD += 2·offset, the same on every point of every part of one setting [seed 002 (33), (34)]. offset in m,
//! away from the axis.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `setting-error`.
pub static SETTING_ERROR: Effect<1> = Effect {
    name: "setting-error",
    about: "the tool is set off its size",
    law: "dD += 2*offset",
    source: "seed 002 (33), (34)",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "every tool is set by hand or by a probe"),
    parameters: [Parameter::signed("offset", MICRO, "offset of the setting away from the axis", (-100.0, 100.0))],
    look_alikes: &[
        ("carriage-compliance", "a second force: a setting error does not change with it"),
        ("carriage-contact", "a second force: a setting error does not change with it"),
        ("cross-slide-play", "a diameter in the section where the pass begins: play leaves it on size"),
    ],
    needs: nothing,
    act: |[offset], machine| machine.add_shift(move |_| 2.0 * offset),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_offset_counts_twice() {
        assert!((shift("setting-error", &[-7.0], moment()) + 14.0).abs() < 1e-12);
    }
}
