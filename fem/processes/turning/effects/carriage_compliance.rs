//! Tool, slide and carriage yield like a spring.
//!
//! y += P/k [seed 002 (8), (18)], k in N/m. In series with the tool holder of the model. Left out: the
//! slide's tilt, which changes with the overhang of the slide.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, UnitRole, nothing};
use crate::units::STIFFNESS;

/// `carriage-compliance`.
pub static CARRIAGE_COMPLIANCE: Effect<1> = Effect {
    name: "carriage-compliance",
    about: "tool, slide and carriage give way under the cutting force like a spring",
    law: "y += P/k",
    source: "seed 002 (8), (18)",
    belongs: Belongs::Unit("carriage", UnitRole::Spring),
    odds: Odds::of(1.0, "every unit gives way"),
    parameters: [Parameter::stiffness(STIFFNESS, "stiffness of tool, slide and carriage", (5.0, 1000.0))],
    look_alikes: &[
        (
            "headstock-compliance",
            "in a chuck, where both add P/k everywhere, a push against the headstock alone (a test of its joint, `fem new \
             stiffness`); elsewhere x: the headstock's share fades",
        ),
        ("setting-error", "a second force: a setting error does not change with it"),
        ("carriage-contact", "a third force level"),
        ("force-feedback", "a measured blank: only feedback copies it"),
    ],
    needs: nothing,
    act: |[stiffness], machine| machine.carriage.soften(stiffness),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_adds_the_same_everywhere() {
        let rigid = lathe("centres", "carriage-compliance", &[f64::INFINITY]);
        let springy = lathe("centres", "carriage-compliance", &[50.0]);
        for x in [0.0, 0.15, 0.6] {
            assert!((gap(&springy, x) - gap(&rigid, x) - 10.0).abs() < 1e-9);
        }
    }
}
