//! Of four or more jaws every other one presses harder.
//!
//! The jaws of an independent chuck are tightened one by one. Of four the ring brings opposite ones into balance, and
//! the two pairs may still differ: this one number is all that statics leaves open. With the mean force F at standstill (N, `jaw_force`)
//! and the difference d, in parts of it,
//!
//! ```text
//!   F₁ = F₃ = F·(1 + d/2),   F₂ = F₄ = F·(1 − d/2)
//! ```
//!
//! so that d = (F₁ − F₂)/F, as two readings of a load cell give it. Of six and more jaws, an even number, the first, third … press with the former and
//! the others with the latter, as where pendulums that carry two jaws each are borne off their middle. The ring then has waves of half the
//! number of jaws: an oval in four, three waves in six. A turning chuck takes the same force from each jaw, F₁ − m·r·ω² and F₂ − m·r·ω²,
//! so that the difference stays as the mean falls, and the weaker jaws let go first. Of inside chucks alike. Left out: other shares of six and more
//! jaws, and friction, which lets opposite forces differ.

use super::super::machine::Effect;
use crate::input::Bounds;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::PERCENT;

/// `jaw-imbalance`.
pub static JAW_IMBALANCE: Effect<1> = Effect {
    name: "jaw-imbalance",
    about: "of four or more jaws every other one presses harder, each pair in balance",
    law: "F_1 = F_3 = F*(1 + difference/2), F_2 = F_4 = F*(1 - difference/2), F = jaw_force, at standstill",
    source: "statics",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "independent jaws are tightened one by one, self-centring ones press alike"),
    parameters: [Parameter::signed(
        "difference",
        PERCENT,
        "force of jaws 1, 3 ... less that of jaws 2, 4 ..., over their mean",
        (-80.0, 80.0),
    )
    .within(Bounds::Within(-2.0, 2.0))],
    look_alikes: &[
        ("residual-stress", "a second jaw force, or the ring turned in the chuck"),
        ("spindle-error", "a second jaw force"),
    ],
    needs: |setup| match setup.jaw_angles.len() {
        jaws if jaws >= 4 && jaws % 2 == 0 => Ok(()),
        3 => Err("is of four jaws or more: three press as statics has it, and alike where they stand evenly".into()),
        jaws => Err(format!(
            "is of an even number of jaws from four on, of which every other one presses harder, not of {jaws}"
        )),
    },
    act: |[difference], machine| machine.difference = difference,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn forces_are_in_equilibrium_and_keep_their_mean() {
        for (jaws, opposite) in [(4, 1.1), (6, 0.9)] {
            let chuck = chuck_of(jaws, "jaw-imbalance", &[20.0]);
            let jaws = chuck.machine().jaws().unwrap();
            let sum = |part: fn(f64) -> f64| jaws.iter().map(|jaw| jaw.share * part(jaw.angle)).sum::<f64>();
            assert!(sum(f64::cos).abs() < 1e-14 && sum(f64::sin).abs() < 1e-14);
            assert!((sum(|_| 1.0) - jaws.len() as f64).abs() < 1e-14);
            let share =
                |degrees: f64| jaws.iter().find(|jaw| (jaw.angle.to_degrees() - degrees).abs() < 1e-9).unwrap().share;
            assert!((share(0.0) - 1.1).abs() < 1e-14 && (share(180.0) - opposite).abs() < 1e-14);
        }
    }

    #[test]
    fn the_turning_chuck_takes_as_much_from_every_jaw() {
        let chuck = chuck_of(4, "jaw-imbalance", &[20.0]);
        let mut machine = super::super::super::Machine::ideal(chuck.machine().setup.clone());
        (machine.difference, machine.jaw_moment) = (0.2, 0.05);
        // 3.3 and 2.7 kN, less 0.05 kg m · (400 rpm)² = 87.73 N.
        let [strong, weak] = machine.cutting_forces();
        assert!((strong - 3212.270).abs() < 1e-3 && (weak - 2612.270).abs() < 1e-3, "{strong} {weak}");
        // √(2700/0.05) rad/s: the weaker jaws let go first.
        assert!((machine.let_go() - 232.379).abs() < 1e-3);
    }
}
