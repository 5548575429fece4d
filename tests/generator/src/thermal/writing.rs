//! The files of a rod.

use std::fmt::Write as _;

use super::job::{Job, Seen};
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let segment =
        |(length, diameter): &(f64, f64)| format!("{{ length = \"{length} mm\", diameter = \"{diameter} mm\" }}");
    let segments: Vec<String> = job.segments.iter().map(segment).collect();
    let source = |(at, power, from, to): &(f64, f64, f64, f64)| {
        format!("[[source]]\nat = \"{at} mm\"\npower = \"{power} W\"\non = [[\"{from} min\", \"{to} min\"]]\n\n")
    };
    let sources: String = std::iter::once(&job.source).chain(&job.set_up.sources).map(source).collect();
    let start = job.set_up.start.map_or(String::new(), |start| format!("temperature = \"{start} degC\"\n"));
    let (step, element) = job.set_up.fine.map_or((20.0, String::new()), |(step, element)| {
        (step, format!("\n[mesh]\nelement_size = \"{element} mm\"\n"))
    });
    format!(
        "[body]\nmaterial = {{ youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\", expansion = \"11.5e-6 /K\", \
         conductivity = \"50 W/m/K\", specific_heat = \"470 J/kg/K\" }}\nsegments = [{}]\n{start}\n{sources}\
         [environment]\ntemperature = \"{} degC\"\n\n[time]\nend = \"{} min\"\nstep = \"{step} s\"\n{element}",
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
        let present = cells.into_iter().zip(&columns).filter(|(_, column)| column.0);
        present.map(|(cell, _)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    let mut text = cells(columns.map(|c| c.1.to_string()));
    for (row, value) in job.rows.iter().zip(observed) {
        let mut line: [String; 6] = Default::default();
        let _ = write!(line[0], "{:.2}", row.time);
        match row.seen {
            Seen::Temperature(sensor) => {
                let _ = write!(line[1], "{}", job.sensors[sensor]);
                line[2] = shown(*value, 5, sigma);
                let _ = write!(line[4], "{}", sigma * job.kelvin);
            }
            Seen::Elongation => {
                line[3] = shown(*value, 4, sigma);
                let _ = write!(line[5], "{sigma}");
            }
        }
        text += &cells(line);
    }
    text
}
