//! The files of a plate.

use super::series::Side;
use super::{Condition, Job, Seen};
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let [length, height, width] = job.size;
    let start = job.start.map_or(String::new(), |start| format!("temperature = \"{start} degC\"\n"));
    let edges: String = job.edges.iter().map(|(side, condition)| edge(*side, *condition)).collect();
    let source = job.source.map_or(String::new(), |(at, power, from, to)| {
        format!("[[source]]\nat = \"{at} mm\"\npower = \"{power} W\"\non = [[\"{from} min\", \"{to} min\"]]\n\n")
    });
    let (step, element) = job.fine;
    format!(
        "[body]\nmaterial = {{ youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\", expansion = \"11.5e-6 /K\", \
         conductivity = \"50 W/m/K\", specific_heat = \"470 J/kg/K\" }}\n\
         rectangle = {{ length = \"{length} mm\", height = \"{height} mm\", width = \"{width} mm\" }}\n{start}\n{edges}{source}\
         [environment]\ntemperature = \"{} degC\"\n\n[time]\nend = \"{} min\"\nstep = \"{step} s\"\n\n\
         [mesh]\nelement_size = \"{element} mm\"\n",
        job.ambient, job.end,
    )
}

fn edge(side: Side, condition: Condition) -> String {
    let name = match side {
        Side::Left => "left",
        Side::Right => "right",
        Side::Bottom => "bottom",
        Side::Top => "top",
    };
    let holds = match condition {
        Condition::Flux(flux, from, to, covers) => {
            let covered = if covers { "covered = true\n" } else { "" };
            format!("flux = \"{flux} kW/m^2\"\non = [[\"{from} min\", \"{to} min\"]]\n{covered}")
        }
        Condition::Strip(flux, middle, speed, width) => format!(
            "moving = {{ speed = \"{speed} mm/min\", width = \"{width} mm\", flux = \"{flux} kW/m^2\", from = \"{middle} mm\" }}\n"
        ),
        Condition::Film(coefficient, beyond) => {
            let ambient = beyond.map_or(String::new(), |beyond| format!("ambient = \"{beyond} degC\"\n"));
            format!("convection = \"{coefficient} W/m^2/K\"\n{ambient}")
        }
        Condition::Held(at) => format!("temperature = \"{at} degC\"\n"),
    };
    format!("[[boundary]]\nedge = \"{name}\"\n{holds}\n")
}

/// The measurement file with the given temperatures (degC) and elongations (um).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let stated = job.noise == NoiseKind::Column;
    let with = |text: &str, u: String| if stated { format!("{text},{u}\n") } else { format!("{text}\n") };
    let mut text = with(
        "time [min],x [mm],y [mm],temperature [degC],elongation [um]",
        "u_temperature [K],u_elongation [um]".into(),
    );
    for (row, value) in job.rows.iter().zip(observed) {
        text += &match row.seen {
            Seen::Temperature(sensor) => {
                let (x, y) = job.sensors[sensor];
                with(&format!("{:.2},{x},{y},{},", row.time, shown(*value, 5, sigma)), format!("{},", 0.05 * sigma))
            }
            Seen::Elongation => with(&format!("{:.2},,,,{}", row.time, shown(*value, 4, sigma)), format!(",{sigma}")),
        };
    }
    text
}
