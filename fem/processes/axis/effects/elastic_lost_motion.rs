//! Elastic clearance: friction of the slide winds the drive up before anything moves.
//!
//! The slide stays behind by F/C either way: deviation ∓ F/C(x), 1/C = 1/stiffness + |x − fixed_at|/(EA), F
//! the friction (N), stiffness that of nut and bearing (N/m), EA the screw's axial rigidity [seed 000, fig.
//! 2b: y = x − F/C]. It grows along the screw, away from the bearing. With a second fixed bearing
//! (`also_fixed_at`) both lengths of screw carry. A preloaded nut (`[screw.nut]`) adds what its halves yield under F,
//! and `stiffness` is that of the bearing then [fig. 5]. Where the model says how friction goes along the travel
//! (`[axis] drag`), F is its mean, and at x it is F·drag(x)/mean [seed 001: more drag, more wind-up]. In light machines the kinematic gap rules, in heavy ones
//! this one. Left out: friction that depends on the speed, and stick-slip.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, Winding, nothing};
use crate::units::{FORCE, STIFFNESS};

/// Where the spring does not switch the effect: friction does.
const SPRING: (f64, f64) = (20.0, 2000.0);

/// `elastic-lost-motion`.
pub static ELASTIC_LOST_MOTION: Effect<2> = Effect {
    name: "elastic-lost-motion",
    about: "friction winds up screw, nut and bearing before the slide moves",
    law: "deviation += sign*friction*(1/stiffness + a/(E*A)), a = |position - fixed_at|, or a*b/(a + b) with b = |position - also_fixed_at|; sign -1 in +, +1 in -; friction goes as axis.drag",
    source: "seed 000, fig. 2b",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "every drive winds up, a friction compensated one by little"),
    parameters: [
        Parameter::amplitude("friction", FORCE, "of the slide, its mean along the travel", (10.0, 10_000.0)),
        Parameter::shape(
            "stiffness",
            STIFFNESS,
            "of nut and bearing together; of the bearing beside [screw.nut]",
            SPRING,
        ),
    ],
    look_alikes: &[
        ("backlash", "targets from end to end of the screw: play is the same all along"),
        ("uneven-backlash", "the way forwards: elastic clearance lags there too, play does not"),
    ],
    needs: nothing,
    act: |[friction, stiffness], machine| {
        let (screw, nut) = (machine.setup.screw(), machine.setup.nut.as_ref());
        machine.winding = Some(Winding::new(friction, stiffness, screw, nut));
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_pull_comes_to_friction_forwards_and_is_taken_off_it_backwards() {
        // Per newton 1/200 um of nut and bearing and 400 mm of the screw; 600 N of friction.
        let give = 1.0 / 200.0 + 1e6 * 0.4 / (210e9 * std::f64::consts::PI * 0.016 * 0.016);
        for (pull, [there, back]) in [(1000.0, [-1600.0, -400.0]), (400.0, [-1000.0, 200.0])] {
            let [forward, backward] = pulled("elastic-lost-motion", &[600.0, 200.0], 500.0, pull);
            assert!((forward - there * give).abs() < 1e-9 && (backward - back * give).abs() < 1e-9);
        }
    }

    #[test]
    fn it_grows_away_from_the_bearing_and_lags_either_way() {
        // 600 N on 200 N/um is 3 um; 400 mm of Ø32 steel add 600·0.4/(210e9·π·0.016²) = 1.42103 um.
        let [forward, backward] = both("elastic-lost-motion", &[600.0, 200.0], 500.0);
        let bar = 600.0 * 0.4 / (210e9 * std::f64::consts::PI * 0.016f64.powi(2)) * 1e6;
        assert!((forward + 3.0 + bar).abs() < 1e-9 && (backward - 3.0 - bar).abs() < 1e-9);
        assert!((both("elastic-lost-motion", &[600.0, 200.0], 100.0)[1] - 3.0).abs() < 1e-12);
    }
}
