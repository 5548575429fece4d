//! The edge breaks down: the third period of wear.
//!
//! ΔD += 2·U, U = wear·(max(ℓ − onset, 0)/1 km)^exponent, ℓ the cutting path (m). The handbook tells of a third
//! period in which wear is catastrophic, and prints no law for it [seed 002, wear of the tool]; the power of the
//! path beyond its onset is ours. Its exponent is above 1: wear that slows down is running-in, and no breakdown; so it
//! joins the steady wear without a step and without a kink. wear is U after the first kilometre of the period, m. Left out: the
//! breaking of the edge itself.

use super::super::machine::Effect;
use crate::input::Bounds;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{MICRO, NUMBER, PATH};

/// Path in which the third period brings the wear that is its parameter, m.
const KILOMETRE: f64 = 1e3;

/// `tool-breakdown`.
pub static TOOL_BREAKDOWN: Effect<3> = Effect {
    name: "tool-breakdown",
    about: "from some cutting path on the edge breaks down, and wears faster and faster",
    law: "dD += 2*wear*(max(l - onset, 0)/1 km)^exponent",
    source: "seed 002, third period of wear; the power law is ours",
    belongs: Belongs::Test,
    odds: Odds::of(0.1, "edges are changed before"),
    parameters: [
        Parameter::amplitude("wear", MICRO, "wear in the first kilometre of the period", (2.0, 500.0)),
        Parameter::place("onset", PATH, "cutting path at which the period begins", "path", (50.0, 5000.0)),
        Parameter::shape("exponent", NUMBER, "exponent of the path beyond it", (1.2, 3.0))
            .within(Bounds::Within(1.0, 10.0)),
    ],
    look_alikes: &[
        ("tool-wear", "more parts before and after the onset: steady wear grows from the first part on"),
        ("guideway-wear", "another part: wear of the tool stands elsewhere on it, wear of the guideway does not"),
    ],
    needs: nothing,
    act: |[wear, onset, exponent], machine| {
        machine.add_wear(move |path| wear * ((path - onset).max(0.0) / KILOMETRE).powf(exponent));
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_begins_at_its_onset() {
        // 800 m: 2·50·(0.5 km)² um beyond 300 m, and nothing before.
        assert!((shift("tool-breakdown", &[50.0, 300.0, 2.0], moment()) - 25.0).abs() < 1e-9);
        assert_eq!(shift("tool-breakdown", &[50.0, 900.0, 2.0], moment()), 0.0);
    }
}
