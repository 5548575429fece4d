//! Cams for the table.

use crate::process::{Assembled, ForwardModel, assembled};
use crate::processes::cam::CamGrinding;
use crate::processes::cam::program::Pass;
use crate::processes::cam::report::blocks::{Blocks, look};
use crate::processes::cam::rows;
pub(super) use crate::validation::bench::row;
use crate::validation::{Case, Tolerance};

/// A grinder with its effects.
pub type Cam = Assembled<CamGrinding>;

/// Round-off of positions of some decimetres, in um.
pub const ROUND_OFF: Tolerance = Tolerance::Absolute(1e-8);

/// A deviation in um: expected, computed.
pub fn micro(
    name: impl Into<String>,
    (expected, computed): (f64, f64),
    tolerance: Tolerance,
    source: &'static str,
) -> Case {
    row(name, "deviation", (expected, computed, "um"), tolerance, source)
}

/// A circle of `radius` about (`beside`, 0), both in mm, from its point on the x axis where it is farthest
/// from the cam's axis, or nearest.
pub fn circle(radius: f64, beside: f64, from_farthest: bool) -> String {
    let start = if from_farthest { beside + radius } else { beside - radius };
    format!(
        "start = [\"{start} mm\", \"0 mm\"]\n\
         segments = [{{ arc = {{ centre = [\"{beside} mm\", \"0 mm\"], sweep = \"360 deg\" }} }}]"
    )
}

/// Two flanks at 14 mm from the axis and from −20 to 20 mm along it, and two arcs of 14 mm,
/// counter-clockwise from the right end of the upper flank; `flank` is what the model says of the flanks
/// besides.
pub fn stadium(flank: &str) -> String {
    format!(
        r#"
    start = ["20 mm", "14 mm"]
    segments = [
        {{ line = {{ to = ["-20 mm", "14 mm"] }} {flank} }},
        {{ arc = {{ centre = ["-20 mm", "0 mm"], sweep = "180 deg" }} }},
        {{ line = {{ to = ["20 mm", "-14 mm"] }} {flank} }},
        {{ arc = {{ centre = ["20 mm", "0 mm"], sweep = "180 deg" }} }},
    ]
"#
    )
}

/// A grinder of a profile with a wheel (mm), a programme and effects given as TOML. A mistake in a text shows
/// as NaN in every row that uses it, so no row can pass by it.
pub fn cam(profile: &str, wheel: f64, program: &str, effects: &str) -> Option<Cam> {
    let text = format!(
        "[profile]\n{profile}\n[wheel]\nradius = \"{wheel} mm\"\n\
         [cut]\nstock = \"20 um\"\nforce_per_rate = \"10 N/(mm^2/s)\"\n[program]\n{program}\n"
    );
    assembled(&text, effects)
}

/// The grinder of the model that comes with the program, the cam of seed 003, with some words of it replaced.
pub fn seed(replaced: &[(&str, &str)], effects: &str) -> Option<Cam> {
    let (_, tables) = include_str!("../../../models/cam.toml").split_once("process = \"cam\"")?;
    assembled(&replaced.iter().fold(tables.to_string(), |text, (old, new)| text.replace(old, new)), effects)
}

/// Deviation at a polar angle (deg), um, in a pass with this part of the programme's speed.
pub fn deviation(cam: &Option<Cam>, degrees: f64, speed: f64, is_reversed: bool) -> f64 {
    let of = |cam: &Cam| {
        let pass = Pass { speed: speed * cam.setup().program.mean_speed, is_reversed };
        cam.observe(&rows::around(vec![degrees.to_radians()], pass)).ok()
    };
    cam.as_ref().and_then(of).map_or(f64::NAN, |deviations| 1e6 * deviations[0])
}

/// The same as the programme runs.
pub fn usual(cam: &Option<Cam>, degrees: f64) -> f64 {
    deviation(cam, degrees, 1.0, false)
}

/// Every block.
pub fn blocks(cam: &Option<Cam>) -> Option<Blocks> {
    let machine = cam.as_ref()?.machine();
    Some(look(machine, &machine.run(machine.setup.program.usual()), None))
}
