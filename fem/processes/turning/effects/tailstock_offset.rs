//! The tailstock stands off the spindle axis.
//!
//! The centre stands off by `offset` (m), away from the tool, in the equilibrium of shaft and supports. Between centres
//! the work turns about a tilted line, ΔD += 2·offset·x/L, and diameters alone cannot tell it from a taper of the
//! guideway. A chuck holds the slope, and the shaft bends: with ξ = x/L an even one in a stiff chuck by ΔD +=
//! offset·(3ξ² − ξ³) [elastica of a beam that is clamped and pinned]. Left out: a chuck that lets the work slip.

use super::super::machine::{Effect, Support};
use super::support_compliance::a_tailstock;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `tailstock-offset`.
pub static TAILSTOCK_OFFSET: Effect<1> = Effect {
    name: "tailstock-offset",
    about: "the tailstock stands off the spindle axis, and tilts the work or bends it",
    law: "between centres dD += 2*offset*x/L; in a stiff chuck an even shaft dD += offset*(3*xi^2 - xi^3), xi = x/L",
    source: "statics; cf. seed 002 (6)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "a tailstock is set by hand"),
    parameters: [Parameter::signed("offset", MICRO, "offset of the tailstock away from the tool", (-100.0, 100.0))],
    look_alikes: &[
        ("guideway-taper", "an indicator on an unloaded sweep along the guideway; diameters alone cannot tell"),
        ("bed-twist", "a level that the carriage carries along the bed; diameters alone cannot tell"),
        ("tailstock-compliance", "a second force"),
        ("tailstock-friction", "a pass from the other end, or a second force"),
    ],
    needs: a_tailstock,
    act: |[offset], machine| machine.displace(Support::Tailstock, move |_| offset),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_offset_tilts_the_axis() {
        assert!((shift("tailstock-offset", &[20.0], moment()) - 10.0).abs() < 1e-12);
    }

    #[test]
    fn a_chuck_holds_the_slope() {
        // 30·(3/4 − 1/8) um at the middle.
        for (x, expected) in [(0.0, 0.0), (0.3, 18.75), (0.6, 60.0)] {
            let bent = shift_in("chuck-and-centre", "tailstock-offset", &[30.0], x);
            assert!((bent - expected).abs() < 1e-9, "{x}: {bent}");
        }
    }
}
