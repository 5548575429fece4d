//! The machine gives way to the force of the cut.
//!
//! The force on the tool has a part across the path (positive outwards) and one that holds the tool back
//! along it; each axis gives way by its share over its own stiffness: d_i = (F_n·n_i − F_t·t_i)/k_i. On a
//! circle outwards F_n(cos²α/kx + sin²α/ky) ± F_t·sin α·cos α·(1/kx − 1/ky), + counter-clockwise: an
//! offset and an ellipse along the axes, and one at 45° that turns over with the direction [statics]. The
//! force is the same all round. Left out: forces that follow the depth of the cut, and twist.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::STIFFNESS;

/// `cutting-deflection`.
pub static CUTTING_DEFLECTION: Effect<2> = Effect {
    name: "cutting-deflection",
    about: "the machine gives way to the force of the cut, by its stiffness along x and along y",
    law: "d_i = (cut.normal_force*n_i - cut.tangential_force*t_i)/stiffness_i, n outwards, t along the travel",
    source: "seed 000 (compliance of the system); statics",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "only while the machine cuts"),
    parameters: [
        Parameter::conductance("stiffness_x", STIFFNESS, "between tool and work along x", (2.0, 500.0)),
        Parameter::conductance("stiffness_y", STIFFNESS, "between tool and work along y", (2.0, 500.0)),
    ],
    look_alikes: &[
        ("scale-mismatch", "a lap without cutting: unequal scales stay"),
        ("servo-mismatch", "another feed, or a lap without cutting: a mismatch grows with the feed"),
    ],
    needs: a_force,
    act: |stiffnesses, machine| machine.compliances = stiffnesses.map(|k| 1.0 / k),
};

fn a_force(setup: &Setup) -> Result<(), String> {
    match setup.force.iter().any(|f| *f != 0.0) {
        true => Ok(()),
        false => Err("needs the force of the cut: normal_force = \"200 N\" or tangential_force in [cut]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn each_axis_gives_way_by_its_own_stiffness() {
        // 200 N outwards and 120 N against the travel, on 50 and 25 N/um.
        let sides = [(0.0, 4.0, 0.0), (90.0, 8.0, 0.0), (45.0, 6.0, -1.2), (135.0, 6.0, 1.2)];
        for (angle, across, along) in sides {
            for (direction, sign) in DIRECTIONS.into_iter().zip([1.0, -1.0]) {
                let computed = change("cutting-deflection", &[50.0, 25.0], direction, angle);
                // What leans by the lag of 1/450 rad, and its square.
                assert!((computed - across - sign * along).abs() < 10.0 / 450.0, "{angle}: {computed}");
            }
        }
    }
}
