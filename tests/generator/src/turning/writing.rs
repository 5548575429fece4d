//! The files of a case: the model as the user believes it, and the measured rows.

use crate::catalogue::{Cause, unit};
use crate::job::{Holding, Job, NoiseKind};
use std::fmt::Write as _;

/// The model file; `values` (one per shown parameter) replaces the `+-` by known values, and `more` are further effects.
/// The user's file is `model(job, None, &[])`.
pub fn model(job: &Job, values: Option<&[f64]>, more: &[Cause]) -> String {
    let mut text = String::from("title = \"case\"\nprocess = \"turning\"\n\n");
    text += &workpiece(job);
    text += &cut(job);
    for (i, s) in job.shown.iter().enumerate() {
        let known = values.map_or(format!("{} +- {}", s.written, s.std), |v| format!("{:.15e}", v[i]));
        let _ =
            write!(text, "\n[effects.{}]\n{} = \"{known} {}\"\n", s.effect, s.parameter, unit(s.effect, s.parameter));
    }
    for cause in more {
        let _ = write!(text, "\n[effects.{}]\n", cause.effect);
        for &(parameter, value) in &cause.parameters {
            let _ = match unit(cause.effect, parameter) {
                "" => writeln!(text, "{parameter} = {value:?}"),
                unit => writeln!(text, "{parameter} = \"{value} {unit}\""),
            };
        }
    }
    text
}

fn workpiece(job: &Job) -> String {
    let m = &job.shaft.material;
    let mut text = format!(
        "[workpiece]\nmaterial = {{ youngs_modulus = \"{} GPa\", poisson_ratio = {}, density = \"{} kg/m^3\", \
         expansion = \"{}e-6 /K\", conductivity = \"{} W/m/K\", specific_heat = \"{} J/kg/K\" }}\nsegments = [\n",
        m.modulus, m.poisson, m.density, m.expansion, m.conductivity, m.specific_heat
    );
    for s in &job.shaft.segments {
        let _ = writeln!(text, "  {{ length = \"{} mm\", diameter = \"{} mm\" }},", s.length, s.diameter);
    }
    let holding = match job.holding {
        Holding::Centres => "centres",
        Holding::Chuck => "chuck",
        Holding::ChuckAndCentre => "chuck-and-centre",
    };
    let _ = write!(text, "]\n\n[workholding]\ntype = \"{holding}\"\n\n");
    text
}

fn cut(job: &Job) -> String {
    let mut text = format!(
        "[cut]\ndepth = \"{} mm\"\nfeed = \"{} mm/rev\"\nspindle_speed = \"{} rpm\"\nradial_force = \"{} N\"\n",
        job.depth, job.feed, job.speed, job.force
    );
    if job.forward {
        let _ = writeln!(text, "from = \"0 mm\"\nto = \"{:.1} mm\"", job.shaft.length());
    }
    let _ = write!(text, "\n[batch]\nparts = {}\ncycle_time = \"{} min\"\n", job.parts, job.cycle);
    let pauses: Vec<String> = job
        .pauses
        .iter()
        .map(|(after, minutes)| format!("{{ after = {after}, duration = \"{minutes} min\" }}"))
        .collect();
    if !pauses.is_empty() {
        let _ = writeln!(text, "pauses = [{}]", pauses.join(", "));
    }
    let beam = if job.shaft.shear { "timoshenko" } else { "euler-bernoulli" };
    let _ = write!(text, "\n[mesh]\nelement_size = \"4 mm\"\nbeam = \"{beam}\"\n");
    text
}

/// The measurement file with the given observed errors (um). `sigma` is written as column `u` only where the design has one.
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let blank_column = job.rows.iter().all(|r| r.blank.is_some());
    let mut text = String::from("part,x [mm]");
    text += if job.force_column { ",radial_force [N]" } else { "" };
    text += if blank_column { ",blank [mm]" } else { "" };
    text += ",diameter_error [um]";
    text += if job.noise == NoiseKind::Column { ",u [um]\n" } else { "\n" };
    for (row, error) in job.rows.iter().zip(observed) {
        let _ = write!(text, "{},{:.1}", row.part, row.x);
        if job.force_column {
            let _ = write!(text, ",{:.1}", row.force);
        }
        if let (true, Some(blank)) = (blank_column, row.blank) {
            let _ = write!(text, ",{blank:.4}");
        }
        let _ = if sigma < 0.2 { write!(text, ",{error:.4}") } else { write!(text, ",{error:.3}") };
        if job.noise == NoiseKind::Column {
            let _ = write!(text, ",{sigma}");
        }
        text.push('\n');
    }
    text
}
