//! Cams for the table.

use std::sync::Arc;

use super::super::machine::Pass;
use super::super::report::{Report, report};
use super::super::{Cam, Setup, effect};
use crate::input::Reader;
pub(super) use crate::process::row;
use crate::process::{Tolerance, set_up};

/// Round-off of positions of some decimetres, in um.
pub const ROUND_OFF: Tolerance = Tolerance::Absolute(1e-8);

/// A circle of `radius` about (`beside`, 0), both in mm, from its point on the x axis where it is farthest from the cam's axis, or nearest.
pub fn circle(radius: f64, beside: f64, from_farthest: bool) -> String {
    let start = if from_farthest { beside + radius } else { beside - radius };
    format!(
        "start = [\"{start} mm\", \"0 mm\"]\nsegments = [{{ arc = {{ centre = [\"{beside} mm\", \"0 mm\"], sweep = \"360 deg\" }} }}]"
    )
}

/// Two flanks at 14 mm from the axis and from −20 to 20 mm along it, and two arcs of 14 mm, counter-clockwise from the right end of the upper flank; `flank` is
/// what the model says of the flanks besides.
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

/// The model that comes with the program: the cam of seed 003.
pub const SEED: &str = include_str!("../../../../models/cam.toml");

/// A grinder of a profile with a wheel (mm), a programme and effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can
/// pass by it.
pub fn cam(profile: &str, wheel: f64, program: &str, effects: &str) -> Option<Cam> {
    let text = format!(
        "[profile]\n{profile}\n[wheel]\nradius = \"{wheel} mm\"\n[cut]\nstock = \"20 um\"\nforce_per_rate = \"10 N/(mm^2/s)\"\n[program]\n{program}\n"
    );
    of_text(&text, effects)
}

/// The same of a whole model.
pub fn of_text(text: &str, effects: &str) -> Option<Cam> {
    let read = |model: &Reader| {
        for key in ["title", "process"] {
            model.text(key, "");
        }
        Setup::read(model)
    };
    let (setup, active) = set_up(text, effects, read, |name| effect(name).map(|e| e.description()))?;
    Some(Cam::equip(Arc::new(setup?), &active))
}

/// Deviation at a polar angle (deg), um, in a pass with this part of the programme's speed.
pub fn deviation(cam: &Option<Cam>, degrees: f64, speed: f64, is_reversed: bool) -> f64 {
    let of = |cam: &Cam| {
        let pass = Pass { speed: speed * cam.setup().program.mean_speed, is_reversed };
        cam.deviation(&cam.machine.motion(pass), cam.setup().profile.at_angle(degrees.to_radians()), pass).ok()
    };
    1e6 * cam.as_ref().and_then(of).unwrap_or(f64::NAN)
}

/// The same as the programme runs.
pub fn usual(cam: &Option<Cam>, degrees: f64) -> f64 {
    deviation(cam, degrees, 1.0, false)
}

/// What each block does.
pub fn blocks(cam: &Option<Cam>) -> Option<Report> {
    cam.as_ref().map(|cam| report(&cam.machine, &cam.machine.motion(cam.machine.usual())))
}
