//! The insert was changed between two parts, and its wear begins anew.
//!
//! U(ℓ) → U(ℓ) + share·(U(ℓ − ℓₙ) − U(ℓ)) on parts beyond `after`: U is the wear of all effects that wear the edge
//! over its cutting path ℓ (m), ℓₙ the path at which the new insert began [seed 002 (31), (32): ℓ is the path of one
//! edge]. share is the part of the wear that goes with the old edge, 1 for a new insert; after is the number of a
//! part, and rounded to a whole one. Where nothing wears it changes nothing. An insert that sits off needs
//! `offset-correction` besides; one that is written down belongs into `[batch]`.

use super::super::machine::{Effect, Renewal};
use super::offset_correction::several_parts;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::FACTOR;

/// `insert-change`.
pub static INSERT_CHANGE: Effect<2> = Effect {
    name: "insert-change",
    about: "the insert was changed between two parts, and its wear begins anew",
    law: "U(l) -> U(l) + share*(U(l - l_n) - U(l)) for part > after, l_n the path up to then",
    source: "seed 002 (31), (32): the path of one edge",
    belongs: Belongs::Test,
    odds: Odds::of(0.2, "an insert is changed in some batches, and mostly written down"),
    parameters: [
        Parameter::after("after", "part after which it was changed", "part", (1.0, 50.0)),
        Parameter::amplitude("share", FACTOR, "part of the wear that goes with the old edge", (0.8, 1.0)).or(1.0),
    ],
    look_alikes: &[("offset-correction", "parts further on: a new edge wears in anew, a correction stays as it is")],
    needs: several_parts,
    act: |[after, share], machine| machine.renewals.push(Renewal { after: after.round(), share }),
};

#[cfg(test)]
mod tests {
    use super::super::super::Turning;
    use super::super::super::machine::Moment;
    use super::super::bench::*;
    use crate::process::assembled;

    #[test]
    fn wear_begins_anew() {
        // A pass is π·50 mm·600 mm/(0.2 mm) = 471.24 m, and the edge wears 10 um in a kilometre.
        let on = |part: usize, path: f64, share: f64| {
            let effects =
                format!("tool-wear = {{ rate = \"10 um/km\" }}\ninsert-change = {{ after = 1, share = {share:?} }}");
            let changed = assembled::<Turning>(&model("centres"), &effects).unwrap();
            1e6 * unloaded(changed.machine(), &Moment { part, path, ..moment() }).unwrap()
        };
        let pass = std::f64::consts::PI * 0.05 * 0.6 / 0.2e-3;
        assert!((on(1, 400.0, 1.0) - 8.0).abs() < 1e-9);
        assert!((on(2, 800.0, 1.0) - 0.02 * (800.0 - pass)).abs() < 1e-9);
        assert!((on(2, 800.0, 0.5) - 0.02 * (800.0 - 0.5 * pass)).abs() < 1e-9);
    }
}
