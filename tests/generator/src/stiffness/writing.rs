//! The files of a joint.

use std::fmt::Write as _;

use super::{Job, Loading};
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let loading = if job.loading == Loading::Reversed { "loading = \"reversed\"\n" } else { "" };
    format!(
        "[joint]\nstiffness = \"{} N/um\"\n\n[test]\nmax_force = \"{} N\"\nsteps = 20\n{loading}",
        job.stiffness, job.max_force
    )
}

/// The measurement file with the given displacements (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_u = job.noise == NoiseKind::Column;
    let mut text = format!("force [N],branch,displacement [um]{}\n", if has_u { ",u [um]" } else { "" });
    for (row, value) in job.rows.iter().zip(observed) {
        let branch = if row.unload { "unload" } else { "load" };
        let _ = write!(text, "{},{branch},{}", row.force, shown(*value, 5, sigma));
        text += &if has_u { format!(",{sigma}\n") } else { "\n".into() };
    }
    text
}
