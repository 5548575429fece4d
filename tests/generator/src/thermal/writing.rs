//! The files of a rod.

use std::fmt::Write as _;

use super::job::{Job, Seen};
use crate::job::NoiseKind;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let segment =
        |(length, diameter): &(f64, f64)| format!("{{ length = \"{length} mm\", diameter = \"{diameter} mm\" }}");
    let segments: Vec<String> = job.segments.iter().map(segment).collect();
    let (at, power, from, to) = job.source;
    format!(
        "[body]\nmaterial = {{ youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\", expansion = \"11.5e-6 /K\", \
         conductivity = \"50 W/m/K\", specific_heat = \"470 J/kg/K\" }}\nsegments = [{}]\n\n\
         [[source]]\nat = \"{at} mm\"\npower = \"{power} W\"\non = [[\"{from} min\", \"{to} min\"]]\n\n\
         [environment]\ntemperature = \"{} degC\"\n\n[time]\nend = \"{} min\"\nstep = \"20 s\"\n",
        segments.join(", "),
        job.ambient,
        job.end,
    )
}

/// The measurement file with the given temperatures (degC) and elongations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has = |elongation: bool| job.rows.iter().any(|r| (r.seen == Seen::Elongation) == elongation);
    let (temperatures, elongations, has_u) = (has(false), has(true), job.noise == NoiseKind::Column);
    let columns = [
        (true, "time [min]"),
        (temperatures, "x [mm]"),
        (temperatures, "temperature [degC]"),
        (elongations, "elongation [um]"),
        (temperatures && has_u, if elongations { "u_temperature [K]" } else { "u [K]" }),
        (elongations && has_u, if temperatures { "u_elongation [um]" } else { "u [um]" }),
    ];
    let cells = |cells: [String; 6]| {
        let shown = cells.into_iter().zip(&columns).filter(|(_, column)| column.0);
        shown.map(|(cell, _)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    let mut text = cells(columns.map(|c| c.1.to_string()));
    for (row, value) in job.rows.iter().zip(observed) {
        let mut line: [String; 6] = Default::default();
        let _ = write!(line[0], "{:.2}", row.time);
        match row.seen {
            Seen::Temperature(sensor) => {
                let _ = write!(line[1], "{}", job.sensors[sensor]);
                let _ = write!(line[2], "{value:.5}");
                let _ = write!(line[4], "{}", sigma * job.kelvin);
            }
            Seen::Elongation => {
                let _ = write!(line[3], "{value:.4}");
                let _ = write!(line[5], "{sigma}");
            }
        }
        text += &cells(line);
    }
    text
}
