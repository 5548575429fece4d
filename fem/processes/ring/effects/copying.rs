//! The bore copies the error of the blank.
//!
//! Where the blank's bore stands out by `blank`(θ) the depth of cut changes by as much, the force of the cut
//! by C times that, and the tool of stiffness j gives way: of the error the part C/(C + j) is left
//! [seed 002 (27)]. C is `force_per_depth` (N/m), j the stiffness of tool and spindle (N/m). Positive
//! outwards: where the blank is wide, less is cut and the bore stays wide. The tool finds the blank as the jaws
//! squeeze it, warm, and about the spindle's axis, and what moves the nose itself changes the depth as well: with k =
//! C/(C + j) and the squeeze u the released ring shows k·blank − (1 − k)·u, and of an oval of the spindle 1 − k.
//! A machine that is drawn gives way beside it.
//! Left out: several passes, which copy a copy.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::STIFFNESS;

/// `copying`.
pub static COPYING: Effect<1> = Effect {
    name: "copying",
    about: "the tool yields to the uneven depth of cut, and what is cut copies the blank",
    law: "k = C/(C + stiffness), C = cut.force_per_depth: of the blank as it is squeezed k is left, of all that moves the nose 1 - k",
    source: "seed 002 (27)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every blank is out of round, and every tool gives way"),
    parameters: [Parameter::stiffness(STIFFNESS, "stiffness of tool and spindle", (2.0, 500.0))],
    look_alikes: &[("residual-stress", "another blank: a copy follows it"), ("spindle-error", "another blank")],
    needs: |setup| match setup.force_per_depth {
        Some(_) => Ok(()),
        None => Err("needs the force of the cut: force_per_depth = \"1 kN/mm\" in [cut]".into()),
    },
    act: |[stiffness], machine| {
        machine.yielding += stiffness.recip();
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_softer_the_tool_the_more_is_copied() {
        // C = 1 N/um: of 50 um a tool of 4 N/um leaves a fifth.
        assert!((mark("copying", &[4.0], 0.0, 0.0) - 10.0).abs() < 1e-12);
        assert_eq!(mark("copying", &[f64::INFINITY], 0.0, 0.0), 0.0);
    }
}
