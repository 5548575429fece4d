//! The deflection takes depth off the cut, and the force with it.
//!
//! P = P₀·(t_d/t₀)^e with t_d = t_set − y ≥ 0 [seed 002 (17)-(23)]; t₀ the model's depth, t_set the depth
//! set at the point, half of blank minus finished diameter where the blank is known, and y the force's own
//! deflection. So the blank's error is copied, smaller by the refinement [seed 002 (24)-(27)]. e in (0, 1],
//! near 1 for most metals. At t_d = 0 the tool does not touch. Where the model has a force law P = C·s^y·t^x, e is its x.

use super::super::cut::{Force, ForceLaw};
use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::input::Bounds;
use crate::process::{Active, Belongs, Contradiction, Odds, Parameter, nothing};
use crate::units::NUMBER;

/// Difference within which two exponents were meant to be one.
const SAME: f64 = 1e-9;

/// `force-feedback`.
pub static FORCE_FEEDBACK: Effect<1> = Effect {
    name: "force-feedback",
    about: "the deflection takes depth off the cut and lowers the force; the blank's error is copied",
    law: "P = P0*(t_d/t_0)^exponent, t_d = t_set - y >= 0",
    source: "seed 002 (17)-(27)",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "the force follows the depth, but shows only where the depth varies"),
    parameters: [Parameter::amplitude("exponent", NUMBER, "exponent of the depth in the force law", (0.5, 1.0))
        .within(Bounds::Within(0.0, 1.0))],
    look_alikes: &[("carriage-compliance", "a measured blank: a spring does not copy it")],
    needs: nothing,
    act: |[exponent], machine| machine.feedback = Some(exponent),
};

/// A force law says how the force follows the depth; what feeds it back cannot say otherwise.
pub fn contradiction(setup: &Setup, effect: &Active) -> Option<Contradiction> {
    let Force::Law(ForceLaw { depth_exponent: x, .. }) = &setup.cut.force else { return None };
    let exponent = *effect.values.first().filter(|_| effect.description.name == FORCE_FEEDBACK.name)?;
    ((exponent - x).abs() > SAME).then(|| Contradiction {
        parameter: &FORCE_FEEDBACK.parameters[0].name,
        message: format!(
            "`exponent` is {exponent}, and x is {x} in the force law: a cut has one exponent of the depth"
        ),
        help: format!("write exponent = {x}, or in place of the law the force at the set depth, radial_force"),
    })
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn with_exponent_one_the_root_is_the_handbooks() {
        // (23): y = C·t/(j + C), C = P₀/t₀ = 1 N/um, at x = L where only the carriage would yield: none
        // does.
        let fed_back = lathe("centres", "force-feedback", &[1.0]);
        assert!(gap(&fed_back, 0.6).abs() < 1e-9);
        let stiff = gap(&lathe("centres", "setting-error", &[0.0]), 0.3);
        let j = 500.0 / stiff;
        assert!((gap(&fed_back, 0.3) - 500.0 / (j + 1.0)).abs() < 1e-9);
    }
}
