//! The guideway is worn where the slide works most.
//!
//! The slide sinks and tilts there, and the tool nose leaves the axis: ΔD += 2·depth·exp(−((x −
//! centre)/width)²/2) [seed 002, wear of the guideways]. depth is the displacement of the nose, m; centre
//! and width in m along the shaft.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{LENGTH, MICRO};

/// `guideway-wear`.
pub static GUIDEWAY_WEAR: Effect<3> = Effect {
    name: "guideway-wear",
    about: "the guideway is worn at one place, and the tool nose leaves the axis there",
    law: "dD += 2*depth*exp(-((x - centre)/width)^2/2)",
    source: "seed 002, wear of the guideways",
    belongs: Belongs::Machine,
    odds: Odds::of(0.1, "worn beds are old ones"),
    parameters: [
        Parameter::amplitude("depth", MICRO, "displacement of the tool nose at the worst place", (1.0, 100.0)),
        Parameter::place("centre", LENGTH, "the worst place, from the headstock", "x", (0.0, 1000.0)),
        Parameter::shape("width", LENGTH, "standard width of the worn place", (10.0, 300.0)),
    ],
    look_alikes: &[
        ("front-guideway-wear", LEVEL),
        ("tool-breakdown", "another part: wear of the tool stands elsewhere on it, wear of the guideway does not"),
        ("bed-sag", "a level along the guideways: wear stands at one place"),
        ("rest-offset", "a pass without the rest: wear stays"),
    ],
    needs: nothing,
    act: |[depth, centre, width], machine| machine.add_shift(move |at| 2.0 * depth * part(at.x, centre, width)),
};

/// Measurement that separates worn guideways from other causes.
pub const LEVEL: &str = "a level across the carriage along the bed: a tilt shows on it; diameters alone cannot tell";

/// Wear at x (m) over that at its worst place.
pub fn part(x: f64, centre: f64, width: f64) -> f64 {
    (-0.5 * ((x - centre) / width).powi(2)).exp()
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn wear_is_deepest_at_its_centre() {
        let depth = |centre| shift("guideway-wear", &[7.0, centre, 50.0], moment());
        assert!((depth(150.0) - 14.0).abs() < 1e-12);
        assert!((depth(200.0) - 14.0 * (-0.5f64).exp()).abs() < 1e-12);
    }
}
