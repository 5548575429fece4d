//! The files of an axis.

use std::fmt::Write as _;

use super::Job;
use crate::job::NoiseKind;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    format!(
        "[axis]\ntravel = \"{} mm\"\nfrom = \"{} mm\"\n\n\
         [screw]\nmaterial = {{ base = \"steel\", youngs_modulus = \"210 GPa\" }}\ndiameter = \"{} mm\"\nlead = \"{} mm\"\n\
         fixed_at = \"{} mm\"\n",
        job.travel, job.from, job.diameter, job.lead, job.fixed_at
    )
}

/// The measurement file with the given deviations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_u = job.noise == NoiseKind::Column;
    let columns = [
        (true, "run"),
        (job.own_clock, "time [min]"),
        (true, "position [mm]"),
        (true, "direction"),
        (true, "deviation [um]"),
        (has_u, "u [um]"),
    ];
    let line = |cells: [String; 6]| {
        let shown = cells.into_iter().zip(&columns).filter(|(_, column)| column.0);
        shown.map(|(cell, _)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    let mut text = line(columns.map(|c| c.1.to_string()));
    for (row, value) in job.rows.iter().zip(observed) {
        let sign = if row.backward { "-" } else { "+" };
        let mut deviation = String::new();
        let _ = write!(deviation, "{value:.5}");
        let (run, time, x) = (row.run.to_string(), row.time.to_string(), row.x.to_string());
        text += &line([run, time, x, sign.into(), deviation, sigma.to_string()]);
    }
    text
}
