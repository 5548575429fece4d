//! The files of a case: the model as the user believes it, and the measured rows.

use super::design::STEEL;
use super::job::{Holding, Job};
use super::set_up::{Holder, Lobe, Pass, Rest, SetUp, Wave};
use super::shaft::Material;
use crate::job::NoiseKind;
use crate::writing::observed as shown;
use std::fmt::Write as _;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    workpiece(job) + &holder(job) + &cut(job) + &edge(job)
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
        let bore = if s.bore > 0.0 { format!(", bore = \"{} mm\"", s.bore) } else { String::new() };
        let _ = writeln!(text, "  {{ length = \"{} mm\", diameter = \"{} mm\"{bore} }},", s.length, s.diameter);
    }
    text += "]\n";
    text += &blank(job);
    let holding = match job.holding {
        Holding::Centres => "centres",
        Holding::Chuck => "chuck",
        Holding::ChuckAndCentre => "chuck-and-centre",
    };
    let _ = write!(text, "\n[workholding]\ntype = \"{holding}\"\n");
    if let Some(survey) = &job.survey {
        let (height, spacing) = (survey.height, survey.spacing);
        let _ = writeln!(text, "centre_height = \"{height} mm\"\nguideway_spacing = \"{spacing} mm\"");
    }
    let rest = |rest: &Rest| {
        let offset = if rest.offset == 0.0 { String::new() } else { format!(", offset = \"{} um\"", rest.offset) };
        format!("  {{ at = \"{} mm\", stiffness = \"{} N/um\"{offset} }},\n", rest.at, rest.stiffness)
    };
    if !job.set_up.rests.is_empty() {
        let _ = writeln!(text, "steady_rests = [\n{}]", job.set_up.rests.iter().map(rest).collect::<String>());
    }
    text.push('\n');
    text
}

/// What is known of an uneven blank.
fn blank(job: &Job) -> String {
    let SetUp { waves, points, lobes, .. } = &job.set_up;
    let list = |key: &str, rows: Vec<String>| match rows.is_empty() {
        true => String::new(),
        false => format!("{key} = [\n  {},\n]\n", rows.join(",\n  ")),
    };
    let wave = |w: &Wave| {
        format!("{{ waves = {:?}, amplitude = \"{} mm\", phase = \"{} deg\" }}", w.waves, w.amplitude, w.phase)
    };
    let point = |(at, error): &(f64, f64)| format!("{{ at = \"{at} mm\", error = \"{error} mm\" }}");
    let lobe = |l: &Lobe| {
        format!("{{ lobes = {}, amplitude = \"{} mm\", phase = \"{} deg\" }}", l.lobes, l.amplitude, l.phase)
    };
    list("blank", waves.iter().map(wave).collect())
        + &list("blank_points", points.iter().map(point).collect())
        + &list("lobes", lobes.iter().map(lobe).collect())
}

fn holder(job: &Job) -> String {
    let Some(Holder { overhang, width, height }) = job.set_up.holder else { return String::new() };
    let Material { modulus, poisson, .. } = STEEL;
    format!(
        "[tool]\noverhang = \"{overhang} mm\"\nwidth = \"{width} mm\"\nheight = \"{height} mm\"\n\
         material = {{ base = \"steel\", youngs_modulus = \"{modulus} GPa\", poisson_ratio = {poisson} }}\n\n"
    )
}

fn cut(job: &Job) -> String {
    let pass = |p: &Pass| format!("[[pass]]\ndepth = \"{} mm\"\nradial_force = \"{} N\"\n\n", p.depth, p.force);
    let mut text: String = job.set_up.passes.iter().map(pass).collect();
    let _ = write!(
        text,
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
    let depth_column = job.rows.iter().all(|r| r.depth.is_some());
    let angle_column = !job.set_up.lobes.is_empty();
    text += if depth_column { ",depth [mm]" } else { "" };
    text += if angle_column { ",angle [deg]" } else { "" };
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
        if let (true, Some(depth)) = (depth_column, row.depth) {
            let _ = write!(text, ",{depth}");
        }
        if angle_column {
            let _ = write!(text, ",{}", row.angle);
        }
        let _ = write!(text, ",{}", shown(*error, if sigma < 0.2 { 4 } else { 3 }, sigma));
        if job.noise == NoiseKind::Column {
            let _ = write!(text, ",{sigma}");
        }
        text.push('\n');
    }
    text
}
