//! The files of a ring.

use std::fmt::Write as _;

use super::job::Job;
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let reference = if job.absolute { "absolute" } else { "least-squares-circle" };
    format!(
        "[workpiece]\nmaterial = {{ base = \"steel\", youngs_modulus = \"{} GPa\", poisson_ratio = {}, expansion = \"{}e-6 /K\" }}\n\
         outer_diameter = \"{:.1} mm\"\ninner_diameter = \"{:.1} mm\"\nwidth = \"{} mm\"\n\n\
         [chuck]\njaws = {}\njaw_force = \"{} N\"\n\n\
         [cut]\nspindle_speed = \"{} rpm\"\nforce_per_depth = \"{} kN/mm\"\n\n\
         [measurement]\nreference = \"{reference}\"\n",
        job.modulus,
        job.poisson,
        job.expansion,
        2.0 * job.outer,
        2.0 * job.inner,
        job.width,
        job.jaws,
        job.force,
        job.speed,
        job.force_per_depth,
    )
}

/// The measurement file with the given deviations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_clamped = job.set_ups.iter().any(|s| s.clamped);
    let is_turned = job.set_ups.iter().any(|s| s.orientation != 0.0);
    let has_blank = job.rows.iter().any(|r| r.blank != 0.0);
    let has_u = job.noise == NoiseKind::Column;
    let mut text = String::from("run,angle [deg],jaw_force [N],spindle_speed [rpm]");
    let columns = [(has_clamped, ",state"), (is_turned, ",orientation [deg]"), (has_blank, ",blank [um]")];
    columns.iter().filter(|c| c.0).for_each(|c| text += c.1);
    text += if has_u { ",deviation [um],u [um]\n" } else { ",deviation [um]\n" };
    for (row, deviation) in job.rows.iter().zip(observed) {
        let set_up = &job.set_ups[row.set_up];
        let _ = write!(text, "{},{:.1},{},{}", row.set_up + 1, row.angle, set_up.force, set_up.speed);
        if has_clamped {
            text += if set_up.clamped { ",clamped" } else { ",released" };
        }
        if is_turned {
            let _ = write!(text, ",{}", set_up.orientation);
        }
        if has_blank {
            let _ = write!(text, ",{:.3}", row.blank);
        }
        text += &format!(",{}", shown(*deviation, 5, sigma));
        if has_u {
            let _ = write!(text, ",{sigma}");
        }
        text.push('\n');
    }
    text
}
