//! The files of a rotary axis.

use std::fmt::Write as _;

use super::Job;
use crate::job::NoiseKind;
use crate::writing::observed as shown;

/// The tables of the model file but `[effects]`.
pub fn tables(job: &Job) -> String {
    let stands = if job.lies { "horizontal" } else { "vertical" };
    let mut text =
        format!("[axis]\nrange = \"{} deg\"\nfrom = \"{} deg\"\norientation = \"{stands}\"\n", job.range, job.from);
    let kind = match (job.worm, &job.pairs[..]) {
        (Some(_), _) => "worm",
        (None, []) => "direct",
        (None, _) => "gears",
    };
    let _ = writeln!(text, "\n[drive]\ntype = \"{kind}\"");
    if let Some([starts, teeth]) = job.worm {
        let _ = writeln!(text, "teeth = {teeth}\nstarts = {starts}");
    }
    if !job.pairs.is_empty() {
        let pair = |[small, large]: &[u32; 2]| format!("{{ driving = {small}, driven = {large} }}");
        let _ = writeln!(text, "stages = [{}]", job.pairs.iter().map(pair).collect::<Vec<_>>().join(", "));
    }
    text += &job.wheel.map_or(String::new(), |radius| format!("pitch_radius = \"{radius} mm\"\n"));
    text += &job.stiffness.map_or(String::new(), |k| format!("stiffness = \"{k} N*m/arcsec\"\n"));
    if let Some(ring) = job.ring {
        let at = if ring.on_motor { "motor" } else { "table" };
        let position_loop = if ring.closed { "closed" } else { "open" };
        let (radius, lines) = (ring.radius, ring.lines);
        let _ = write!(
            text,
            "\n[scale]\nat = \"{at}\"\nloop = \"{position_loop}\"\nradius = \"{radius} mm\"\nlines = {lines}\n"
        );
    }
    if job.torque == 0.0 { text } else { text + &format!("\n[test]\ntorque = \"{} N*m\"\n", job.torque) }
}

/// The measurement file with the given deviations (arcsec).
pub fn data(job: &Job, observed: &[f64], sigma: f64) -> String {
    let has_u = job.noise == NoiseKind::Column;
    let columns = [
        (true, "run"),
        (job.own_clock, "time [min]"),
        (true, "angle [deg]"),
        (true, "direction"),
        (job.rows.iter().any(|row| row.torque.is_some()), "torque [N*m]"),
        (true, "deviation [arcsec]"),
        (has_u, "u [arcsec]"),
    ];
    let line = |cells: [String; 7]| {
        let present = cells.into_iter().zip(&columns).filter(|(_, column)| column.0);
        present.map(|(cell, _)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    let mut text = line(columns.map(|c| c.1.to_string()));
    for (row, value) in job.rows.iter().zip(observed) {
        let sign = if row.backward { "-" } else { "+" };
        let deviation = shown(*value, 5, sigma);
        let torque = row.torque.unwrap_or(job.torque).to_string();
        let (run, time, angle) = (row.run.to_string(), row.time.to_string(), row.angle.to_string());
        text += &line([run, time, angle, sign.into(), torque, deviation, sigma.to_string()]);
    }
    text
}
