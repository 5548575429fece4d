//! Play between the drive of an axis and its slide.
//!
//! The slide follows the play operator of width gap: it stays where it is until the drive has crossed the gap, and is then carried along,
//! half a gap behind. Round a circle the tool draws four arcs of the programmed radius about the corners of a square (of side gap where both axes have
//! the same), joined by flats; diameters along the axis are short by gap, those at 45° true [seed 000, figs. 2 and 3]. The play is outside the servo's loop. Elastic
//! play, friction over stiffness, looks the same.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::MICRO;

/// `backlash-x`, `backlash-y`.
pub struct Backlash {
    axis: usize,
    description: &'static Description,
}

/// Of the x axis.
pub static X: Backlash = Backlash { axis: 0, description: &DESCRIPTION_X };
/// Of the y axis.
pub static Y: Backlash = Backlash { axis: 1, description: &DESCRIPTION_Y };

static DESCRIPTION_X: Description =
    describe("backlash-x", "x loses its play whenever it turns round, and flats stay on the circle");
static DESCRIPTION_Y: Description =
    describe("backlash-y", "y loses its play whenever it turns round, and flats stay on the circle");
const PARAMETERS: &[Parameter] = &[Parameter::amplitude("gap", MICRO, "play of the axis", (0.5, 100.0))];

const fn describe(name: &'static str, about: &'static str) -> Description {
    Description {
        name,
        about,
        law: "play operator of width gap: the slide lies gap/2 behind its drive, and rests while the drive crosses the gap",
        source: "seed 000, figs. 2 and 3",
        parameters: PARAMETERS,
        look_alikes: &[],
    }
}

impl Effect<Machine> for Backlash {
    fn description(&self) -> &'static Description {
        self.description
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.gaps[self.axis] = values["gap"];
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
            // The lag of 1/450 rad turns that part of the play inwards or outwards, and its square is left out.
            let near = |diameter: f64, expected: f64| (diameter - expected).abs() <= 8.0 / 450.0 * 1.01;
            assert!(near(diameter("backlash-x", 0.0), -8.0) && near(diameter("backlash-x", 90.0), 0.0));
            assert!(near(diameter("backlash-y", 90.0), -8.0) && near(diameter("backlash-y", 0.0), 0.0));
        }
    }
}
