//! The files of a case: the model as the user believes it, and the measured rows.

use super::job::{Holding, Job};
use crate::job::NoiseKind;
use std::fmt::Write as _;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    workpiece(job) + &cut(job) + &edge(job)
}

fn edge(job: &Job) -> String {
    let Some(survey) = &job.survey else { return String::new() };
    let point = |(path, width): &(f64, f64)| format!("  {{ path = \"{path} m\", width = \"{width} mm\" }},\n");
    let land: String = survey.land.iter().map(point).collect();
    format!("\n[edge]\nclearance_angle = \"{} deg\"\nland = [\n{land}]\n", survey.clearance)
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
    let _ = write!(text, "]\n\n[workholding]\ntype = \"{holding}\"\n");
    if let Some(survey) = &job.survey {
        let (height, spacing) = (survey.height, survey.spacing);
        let _ = writeln!(text, "centre_height = \"{height} mm\"\nguideway_spacing = \"{spacing} mm\"");
    }
    text.push('\n');
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

/// The measurement file with the given observed errors (um). `sigma` is written as column `u` only where
/// the design has one.
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
