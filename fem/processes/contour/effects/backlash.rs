//! Play between the drive of an axis and its slide.
//!
//! The slide follows the play operator of width gap: it stays where it is until the drive has crossed the
//! gap, and is then carried along, half a gap behind. Round a circle the tool draws four arcs of the
//! programmed radius about the corners of a square (of side gap where both axes have the same), joined by
//! flats; diameters along the axis are short by gap, those at 45° true [seed 000, figs. 2 and 3]. The play
//! is outside the servo's loop: a scale on the slide takes it out. Elastic play, friction over stiffness,
//! adds to its width; it alone grows along the screw.

use super::super::machine::{Effect, Machine};
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `backlash-x`.
pub static X: Effect<1> = backlash(
    "backlash-x",
    "x loses its play whenever it turns round, and flats stay on the circle",
    &[("elastic-lost-motion-x", FLATS)],
    |[gap], machine| machine.plays[0].gap = gap,
);
/// `backlash-y`.
pub static Y: Effect<1> = backlash(
    "backlash-y",
    "y loses its play whenever it turns round, and flats stay on the circle",
    &[("elastic-lost-motion-y", FLATS)],
    |[gap], machine| machine.plays[1].gap = gap,
);

/// Measurement that separates play from elastic clearance.
const FLATS: &str = "the two flats of the axis: play is as wide at both, elastic clearance wider away from the bearing";

const fn backlash(
    name: &'static str,
    about: &'static str,
    look_alikes: &'static [(&'static str, &'static str)],
    act: fn([f64; 1], &mut Machine),
) -> Effect<1> {
    Effect {
        name,
        about,
        law: "play operator of width gap: the slide lies gap/2 behind its drive, and rests while the drive crosses the gap",
        source: "seed 000, figs. 2 and 3",
        belongs: Belongs::Machine,
        odds: Odds::of(1.0, "compensation is never exact"),
        parameters: [Parameter::amplitude("gap", MICRO, "play of the axis", (0.5, 100.0))],
        look_alikes,
        needs: |setup| setup.feedback.sees_screw(),
        act,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn each_axis_loses_its_own_diameter() {
        for direction in DIRECTIONS {
            let diameter =
                |name, angle| change(name, &[8.0], direction, angle) + change(name, &[8.0], direction, angle + 180.0);
            // The lag of 1/450 rad turns that part of the play inwards or outwards, and its square is left
            // out.
            let near = |diameter: f64, expected: f64| (diameter - expected).abs() <= 8.0 / 450.0 * 1.01;
            assert!(near(diameter("backlash-x", 0.0), -8.0) && near(diameter("backlash-x", 90.0), 0.0));
            assert!(near(diameter("backlash-y", 90.0), -8.0) && near(diameter("backlash-y", 0.0), 0.0));
        }
    }
}
