//! The joint beds in under its first load.
//!
//! The tips of rough surfaces flatten for good under what presses on them, and do not rise again: y +=
//! depth·S/F_max while the force rises, and what has settled by then, depth·S₁/F_max with S₁ the largest S,
//! all the way back. depth (m) is what settles under F_max; S is the force that friction leaves. The amount
//! is the embedding f_Z of bolted joints [VDI 2230-1]; that it grows in proportion to the force is its first
//! order. Left out: a second loading, which settles no further, and creep while the force stays. The loop of a force
//! that is reversed is one of many, in which nothing settles any more.

use super::super::machine::Effect;
use super::super::setup::Loading;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `settling`.
pub static SETTLING: Effect<1> = Effect {
    name: "settling",
    about: "surfaces bed in under the first load, and what has settled does not come back",
    law: "load: y += depth*S/F_max; unload: y += depth*S_1/F_max, S the force that friction leaves, S_1 its largest",
    source: "VDI 2230-1, embedding f_Z; first order in the force",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "joints settle when they are loaded first"),
    parameters: [Parameter::amplitude("depth", MICRO, "that settles under the largest force", (0.2, 100.0))],
    look_alikes: &[
        ("dry-friction", "the loop near both ends: friction opens it at once, what settles opens it towards no force"),
        ("contact-joint", "both branches: what settles stays, a contact comes back"),
    ],
    needs: |setup| match setup.loading {
        Loading::FromZero => Ok(()),
        Loading::Reversed => Err("needs a first loading, and a `reversed` test tells the loop after many".into()),
    },
    act: |[depth], machine| machine.curve.settles += depth,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn what_has_settled_stays() {
        let y = |force, branch| displacement("settling", &[4.0], force, branch);
        assert!((y(500.0, Load) - (6.25 + 2.0)).abs() < 1e-9 && (y(500.0, Unload) - (6.25 + 4.0)).abs() < 1e-9);
        assert_eq!((y(0.0, Load), y(1000.0, Load)), (0.0, y(1000.0, Unload)));
    }
}
