//! The files of a circular test.

use std::fmt::Write as _;

use super::{Job, Screw};
use crate::axis::writing::halves;
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let mut text = format!(
        "[path]\nshape = \"circle\"\nradius = \"{} mm\"\nfeed = \"{} mm/min\"\ndirections = [\"ccw\", \"cw\"]\n\n\
         [drives]\ngain = \"{} /s\"\n",
        job.radius, job.feed, job.gain
    );
    if let Some(lead) = job.lead {
        let _ = writeln!(text, "lead = \"{lead} mm\"");
    }
    if let Some(frequency) = job.frequency {
        let _ = writeln!(text, "frequency = \"{frequency} Hz\"");
    }
    for (axis, Screw { diameter, fixed_at, nut }) in ["x", "y"].iter().zip(job.screws.into_iter().flatten()) {
        let nut = nut.map_or(String::new(), |(side, preload)| format!(", nut = {}", halves(&side, preload)));
        let _ = writeln!(
            text,
            "{axis} = {{ screw = {{ material = {{ base = \"steel\", youngs_modulus = \"210 GPa\" }}, \
             diameter = \"{diameter} mm\", fixed_at = \"{fixed_at} mm\"{nut} }} }}"
        );
    }
    if let Some([normal, tangential]) = job.cut {
        let _ = write!(text, "\n[cut]\nnormal_force = \"{normal} N\"\ntangential_force = \"{tangential} N\"\n");
    }
    text
}

/// The measurement file with the given deviations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_u = job.noise == NoiseKind::Column;
    let mut text =
        format!("direction,feed [mm/min],angle [deg],deviation [um]{}\n", if has_u { ",u [um]" } else { "" });
    for (row, value) in job.rows.iter().zip(observed) {
        let way = if row.clockwise { "cw" } else { "ccw" };
        let _ = write!(text, "{way},{},{},{}", row.feed, row.angle, shown(*value, 6, sigma));
        text += &if has_u { format!(",{sigma}\n") } else { "\n".into() };
    }
    text
}
