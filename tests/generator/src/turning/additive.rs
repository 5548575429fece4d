//! The causes that move the nose, each by its formula in the physics page's table: across they add up, and
//! height joins them under the root.

use super::heat::tool_temperature;
use super::job::{Holding, Job};
use crate::law::{Cause, value};

/// Finer cell of the heat grid, mm: a ninth of the kink ahead of the tool, k/(rho c v); the error is then
/// below 4e-4.
fn cell(job: &Job) -> f64 {
    let m = &job.shaft.material;
    let kink = 1e3 * m.conductivity / (m.density * m.specific_heat * job.tool_speed() * 1e-3 / 60.0);
    (kink / 9.0).clamp(0.2, 1.5)
}

/// Sum of the additive causes at every row, um.
pub fn additive_error(job: &Job, causes: &[Cause]) -> Vec<f64> {
    let mut errors = vec![0.0; job.rows.len()];
    for cause in causes {
        let one = std::slice::from_ref(cause);
        let size = |parameter: &str| value(one, cause.effect, parameter).unwrap_or(0.0);
        let law: Box<dyn Fn(usize, f64) -> f64> = match cause.effect {
            "tool-wear" => Box::new(|part, x| {
                // [002 (31)(32)]: run-in that saturates, then a rate; the blunt tool leaves more.
                let path = job.path(part, x);
                2.0 * (size("run_in") * (1.0 - (-path / size("run_in_path")).exp()) + size("rate") * path * 1e-3)
            }),
            "tool-breakdown" => Box::new(|part, x| {
                // The third period: nothing up to its onset, then a power of the path beyond, in km.
                let beyond = 1e-3 * (job.path(part, x) - size("onset"));
                if beyond > 0.0 { 2.0 * size("wear") * (size("exponent") * beyond.ln()).exp() } else { 0.0 }
            }),
            "tool-thermal-growth" => {
                Box::new(|part, x| -2.0 * growth(job, size("elongation"), size("time_constant"), part, x))
            }
            "workpiece-heating" => heating(job, size("power"), size("convection")),
            "spindle-thermal-drift" => Box::new(|part, x| {
                let time = job.start(part) + job.into_cut(x);
                let place = if job.holding == Holding::Chuck { 1.0 } else { 1.0 - x / job.shaft.length() };
                2.0 * size("drift") * (1.0 - (-time / size("time_constant")).exp()) * place
            }),
            "guideway-taper" => Box::new(|_, x| 2.0 * size("slope") * x * 1e-3),
            "guideway-wear" => {
                Box::new(|_, x| 2.0 * size("depth") * (-0.5 * ((x - size("centre")) / size("width")).powi(2)).exp())
            }
            "tailstock-offset" => Box::new(|_, x| 2.0 * size("offset") * x / job.shaft.length()),
            "setting-error" => Box::new(|_, _| 2.0 * size("offset")),
            "wear-land" | "front-guideway-wear" | "bed-twist" => surveyed(job, cause),
            _ => continue,
        };
        errors.iter_mut().zip(&job.rows).for_each(|(e, row)| *e += law(row.part, row.x));
    }
    if let Some(slope) = value(causes, "guideway-height", "slope") {
        // The hyperboloid [002 (2)(3)(7)]: the nose at r across and z up cuts 2 sqrt(r^2 + z^2), mm.
        for (error, row) in errors.iter_mut().zip(&job.rows) {
            let (d, z) = (job.shaft.diameter(row.x) + 1e-3 * *error, slope * row.x * 1e-3);
            *error += 1e3 * 4.0 * z * z / ((d * d + 4.0 * z * z).sqrt() + d);
        }
    }
    errors
}

/// What needs to know the edge or the bed: [002 (31)], and levers by the geometry of a tilting carriage.
fn surveyed<'a>(job: &'a Job, cause: &'a Cause) -> Box<dyn Fn(usize, f64) -> f64 + 'a> {
    let size = |parameter: &str| value(std::slice::from_ref(cause), cause.effect, parameter).unwrap_or(0.0);
    let Some(survey) = &job.survey else { return Box::new(|_, _| 0.0) };
    match cause.effect {
        "wear-land" => Box::new(move |part, x| {
            let drawn_back = 1e3 * survey.width(job.path(part, x)) * survey.clearance.to_radians().tan();
            2.0 * size("share") * drawn_back
        }),
        "front-guideway-wear" => Box::new(move |_, x| {
            let front = size("wear") * (-0.5 * ((x - size("centre")) / size("width")).powi(2)).exp();
            let tilt = (front - front / 5.0) / survey.spacing;
            2.0 * survey.height * tilt
        }),
        _ => Box::new(move |_, x| 2.0 * survey.height * 1e-3 * size("twist") * x * 1e-3),
    }
}

/// xi of tau dxi/dt = elongation [cutting] - xi from xi(0) = 0, through every cut, idle time and pause
/// before.
fn growth(job: &Job, elongation: f64, tau: f64, part: usize, x: f64) -> f64 {
    let toward = |goal: f64, from: f64, minutes: f64| goal + (from - goal) * (-minutes / tau).exp();
    let mut xi = 0.0;
    for earlier in 1..part {
        xi = toward(elongation, xi, job.cutting_time());
        xi = toward(0.0, xi, job.start(earlier + 1) - job.start(earlier) - job.cutting_time());
    }
    toward(elongation, xi, job.into_cut(x))
}

/// -alpha D theta at the tool, the same for every part because each starts cold.
fn heating(job: &Job, power: f64, convection: f64) -> Box<dyn Fn(usize, f64) -> f64> {
    let mut places: Vec<f64> = job.rows.iter().map(|r| r.x).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let rise = tool_temperature(&job.shaft, convection, job.tool_speed(), job.forward, cell(job), &places);
    let shrink =
        |(&x, theta): (&f64, f64)| -1e-3 * job.shaft.material.expansion * job.shaft.diameter(x) * power * theta;
    let errors: Vec<f64> = places.iter().zip(rise).map(shrink).collect();
    Box::new(move |_, x| places.iter().position(|&p| p == x).map_or(0.0, |i| errors[i]))
}
