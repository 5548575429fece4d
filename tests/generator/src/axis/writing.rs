//! The files of an axis.

use std::fmt::Write as _;

use super::{Job, SetUp};
use crate::job::NoiseKind;
use crate::preload::Side;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let SetUp { also_fixed_at, drag, nut, temperature } = &job.set_up;
    let mut text = format!("[axis]\ntravel = \"{} mm\"\nfrom = \"{} mm\"\n", job.travel, job.from);
    let point = |(at, drag): &(f64, f64)| format!("  {{ at = \"{at} mm\", drag = \"{drag} N\" }},\n");
    if !drag.is_empty() {
        let _ = writeln!(text, "drag_points = [\n{}]", drag.iter().map(point).collect::<String>());
    }
    let _ = write!(
        text,
        "\n[screw]\nmaterial = {{ base = \"steel\", youngs_modulus = \"210 GPa\" }}\ndiameter = \"{} mm\"\nlead = \"{} mm\"\n\
         fixed_at = \"{} mm\"\n",
        job.diameter, job.lead, job.fixed_at
    );
    text += &also_fixed_at.map_or(String::new(), |at| format!("also_fixed_at = \"{at} mm\"\n"));
    text += &temperature.map_or(String::new(), |t| format!("temperature = \"{t} degC\"\n"));
    text + &nut.map_or(String::new(), |(side, preload)| format!("nut = {}\n", halves(&side, preload)))
}

/// A nut of two halves, as screws of axes and of contours have it.
pub fn halves(side: &Side, preload: f64) -> String {
    let stiffness = side.stiffness.map_or(String::new(), |k| format!(", stiffness = \"{k} N/um\""));
    let contact = side.contact.map_or(String::new(), |(c, n)| format!(", c = \"{c} um/N^n\", n = {n:?}"));
    format!("{{ preload = \"{preload} N\"{stiffness}{contact} }}")
}

/// The measurement file with the given deviations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_u = job.noise == NoiseKind::Column;
    let columns = [
        (true, "run"),
        (job.own_clock, "time [min]"),
        (true, "position [mm]"),
        (true, "direction"),
        (job.rows.iter().any(|row| row.pull > 0.0), "pull [N]"),
        (true, "deviation [um]"),
        (has_u, "u [um]"),
    ];
    let line = |cells: [String; 7]| {
        let present = cells.into_iter().zip(&columns).filter(|(_, column)| column.0);
        present.map(|(cell, _)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    let mut text = line(columns.map(|c| c.1.to_string()));
    for (row, value) in job.rows.iter().zip(observed) {
        let sign = if row.backward { "-" } else { "+" };
        let deviation = shown(*value, 5, sigma);
        let (run, time, x) = (row.run.to_string(), row.time.to_string(), row.x.to_string());
        text += &line([run, time, x, sign.into(), row.pull.to_string(), deviation, sigma.to_string()]);
    }
    text
}
