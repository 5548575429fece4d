//! Dry friction beside the spring.
//!
//! While the force rises it must first overcome f: the spring feels S = F − f, and nothing up to f. When the
//! force turns back at F_max friction turns too, and the spring is let go only after the force has dropped
//! by 2f: S = F + f, at most F_max − f. Of a force that is reversed the rising branch is the falling one turned about,
//! S = F − f and at least f − F_max. The loop between the branches is its work [seed 000, fig. 5]. f in
//! N. In a whole machine it acts between the place that is pushed and the ground. Coulomb's law; left out: a friction that depends on speed, on place, or on the load.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, UnitRole, nothing};
use crate::units::FORCE;

/// `dry-friction`.
pub static DRY_FRICTION: Effect<1> = Effect {
    name: "dry-friction",
    about: "friction holds the joint back, on loading and on unloading",
    law: "load: S = F - f, 0 while F <= f; unload: S = F + f, at most F_max - f",
    source: "seed 000, fig. 5",
    belongs: Belongs::Tested(UnitRole::Friction),
    odds: Odds::of(0.5, "surfaces that slide rub"),
    parameters: [Parameter::amplitude("force", FORCE, "friction f", (1.0, 500.0))],
    look_alikes: &[(
        "settling",
        "the loop near both ends: friction opens it at once, what settles opens it towards no force",
    )],
    needs: nothing,
    act: |[force], machine| machine.curve.friction += force,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_spring_feels_less_going_up_and_more_going_down() {
        let y = |force, branch| displacement("dry-friction", &[80.0], force, branch);
        assert_eq!((y(60.0, Load), y(80.0, Load)), (0.0, 0.0));
        assert!((y(480.0, Load) - 5.0).abs() < 1e-9 && (y(480.0, Unload) - 7.0).abs() < 1e-9);
        // Held until 2f are gone.
        assert_eq!(y(840.0, Unload), y(1000.0, Load));
    }
}
