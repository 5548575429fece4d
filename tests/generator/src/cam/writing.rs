//! The files of a ground cam.

use std::fmt::Write as _;

use super::{Before, Job};
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let profile = &job.profile;
    let point = |segment: usize| {
        let [x, y] = profile.on(segment, 0.0).point;
        format!("[\"{x:.12} mm\", \"{y:.12} mm\"]")
    };
    let arc = |at: f64, sweep: f64| {
        format!("{{ arc = {{ centre = [\"{at} mm\", \"0 mm\"], sweep = \"{:.13} deg\" }} }}", sweep.to_degrees())
    };
    let line = |segment| format!("{{ line = {{ to = {} }} }}", point(segment));
    let turn = 2.0 * profile.flank();
    let segments = [arc(0.0, std::f64::consts::TAU - turn), line(2), arc(profile.lift, turn), line(0)];
    let mut text = format!(
        "[profile]\nstart = {}\nsegments = [\n  {},\n]\n\n[wheel]\nradius = \"{} mm\"\n\n\
         [program]\nstep = \"{} mm\"\ncam_speed = \"{} rpm\"\n",
        point(0),
        segments.join(",\n  "),
        job.wheel,
        job.step,
        job.speed
    );
    if let Some((stock, per_rate)) = job.cut {
        let _ = write!(text, "\n[cut]\nstock = \"{stock} um\"\nforce_per_rate = \"{per_rate} N/(mm^2/s)\"\n");
    }
    if let Some(Before { step, wheel, stock }) = job.before {
        let _ =
            write!(text, "\n[before]\nstep = \"{step} mm\"\nwheel_radius = \"{wheel} mm\"\nstock = \"{stock} um\"\n");
    }
    text
}

/// The measurement file with the given deviations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_u = job.noise == NoiseKind::Column;
    let mut text =
        format!("cam_speed [rpm],direction,angle [deg],deviation [um]{}\n", if has_u { ",u [um]" } else { "" });
    for (row, value) in job.rows.iter().zip(observed) {
        let pass = &job.passes[row.pass];
        let way = if pass.reverse { "reverse" } else { "forward" };
        let _ = write!(text, "{},{way},{},{}", pass.speed, row.angle, shown(*value, 6, sigma));
        text += &if has_u { format!(",{sigma}\n") } else { "\n".into() };
    }
    text
}
