//! What a run of a ring finds, in numbers and in words.

use std::f64::consts::TAU;

use serde_json::json;

use super::circle;
use super::job::Ring;
use super::model::{Reference, Setup};
use super::observe;
use super::shapes::Scene;
use crate::process::{Column, Curve, Drawing, Failure, Finding, Outcome, Plot, Spot, Table};
use crate::units::SPINDLE_SPEED;

/// A bore that varies by less than a tenth of a nanometre is round.
const ROUND: f64 = 1e-10;
/// Harmonics are listed down to this part of the largest, and no more than so many.
const LISTED: f64 = 1e-3;
const MOST_LISTED: usize = 8;

/// Elements that are stiffer by more than this part are warned of.
const STIFFENED: f64 = 0.01;

/// Everything but the animation. `deviations` are those of the released bore, m, all around.
///
/// # Errors
/// The ring cannot be computed.
pub fn outcome(ring: &Ring, scene: &Scene, deviations: Vec<f64>) -> Result<Outcome, Failure> {
    let setup = ring.setup();
    let angles = setup.angles();
    let bore = ring.bore()?;
    let clamped: Vec<f64> = angles.iter().map(|angle| setup.jaw_force * bore.radial(*angle)).collect();
    let form = from_circle(setup, &deviations);
    let mut findings = vec![
        extreme("largest", "largest deviation", &angles, &deviations, |a, b| a > b),
        extreme("smallest", "smallest deviation", &angles, &deviations, |a, b| a < b),
        size(setup.reference, &deviations),
        roundness(&form),
        harmonics(&angles, &form),
        clamping(setup, &clamped),
    ];
    findings.push(force(ring));
    findings.push(stress(scene));
    let points = angles.iter().zip(&deviations).map(|(a, d)| (a.to_degrees(), 1e6 * d)).collect();
    let plots =
        vec![Plot { title: "deviation [um] of the released bore over angle [deg]".into(), x_unit: "deg", points }];
    let warnings = warnings(ring);
    Ok(Outcome {
        profile: profile(setup, &angles, &deviations),
        findings,
        plots,
        tables: Vec::new(),
        drawings: vec![drawing(setup, &angles, &deviations)],
        warnings,
        animation: None,
    })
}

/// The bore, deviations magnified.
fn drawing(setup: &Setup, angles: &[f64], deviations: &[f64]) -> Drawing {
    let spot = |(angle, deviation): (&f64, &f64)| {
        let outward = [angle.cos(), angle.sin()];
        Spot { at: outward.map(|c| setup.inner_radius * c), outward, deviation: *deviation }
    };
    let mut bore: Vec<Spot> = angles.iter().zip(deviations).map(spot).collect();
    bore.extend(bore.first().copied());
    Drawing {
        name: "bore",
        title: format!("bore of {:.3} mm, released", 2e3 * setup.inner_radius),
        nominal: vec![Spot::circle(setup.inner_radius)],
        curves: vec![Curve { label: "predicted".into(), family: 0, is_measured: false, pieces: vec![bore] }],
    }
}

/// A measurement file of its own: with the conditions written out, it reads back as what was predicted.
fn profile(setup: &Setup, angles: &[f64], deviations: &[f64]) -> Table {
    let column = Column::numbers;
    let all = |value: f64| vec![value; angles.len()];
    let mut columns = vec![
        column("run", None, all(1.0)),
        column("angle", Some("deg"), angles.iter().map(|a| a.to_degrees()).collect()),
        column("jaw_force", Some("N"), all(setup.jaw_force)),
    ];
    if let Some(speed) = setup.spindle_speed {
        columns.push(column("spindle_speed", Some("rpm"), all(SPINDLE_SPEED.from_si(speed))));
    }
    if !setup.blank.is_empty() {
        columns.push(column("blank", Some("um"), angles.iter().map(|a| 1e6 * setup.blank_at(*a)).collect()));
    }
    columns.push(column("deviation", Some("um"), deviations.iter().map(|d| 1e6 * d).collect()));
    Table { columns }
}

/// The deviations from their least-squares circle, m.
fn from_circle(setup: &Setup, deviations: &[f64]) -> Vec<f64> {
    let mut form = deviations.to_vec();
    circle::directions(&observe::programme(setup)).iter().for_each(|direction| direction.take_out(&mut form));
    form
}

fn extreme(
    key: &'static str,
    label: &'static str,
    angles: &[f64],
    deviations: &[f64],
    beats: fn(f64, f64) -> bool,
) -> Finding {
    // By more than round-off, so that of equal ones the first is told.
    let scale = deviations.iter().fold(0.0f64, |size, d| size.max(d.abs()));
    let better = |best: usize, i: usize| {
        let apart = (deviations[i] - deviations[best]).abs() > 1e-9 * scale;
        if apart && beats(deviations[i], deviations[best]) { i } else { best }
    };
    let i = (0..deviations.len()).fold(0, better);
    let (value, angle) = (1e6 * deviations[i], angles[i].to_degrees());
    Finding {
        key,
        label,
        text: format!("{value:+.3} um at {angle:.1} deg"),
        json: json!({ "value": value, "unit": "um", "angle": angle, "angle_unit": "deg" }),
    }
}

fn size(reference: Reference, deviations: &[f64]) -> Finding {
    let mean = 1e6 * deviations.iter().sum::<f64>() / deviations.len() as f64;
    let text = match reference {
        Reference::LeastSquaresCircle => "taken out with the least-squares circle".into(),
        Reference::Absolute => format!("{mean:+.3} um of the radius, {:+.3} um of the diameter", 2.0 * mean),
    };
    Finding { key: "mean", label: "mean deviation", text, json: json!({ "value": mean, "unit": "um" }) }
}

fn roundness(form: &[f64]) -> Finding {
    let peak = 1e6 * form.iter().fold(0.0f64, |m, d| m.max(*d));
    let valley = -1e6 * form.iter().fold(0.0f64, |m, d| m.min(*d));
    let rms = 1e6 * (form.iter().map(|d| d * d).sum::<f64>() / form.len() as f64).sqrt();
    Finding {
        key: "roundness",
        label: "roundness (LSC)",
        text: format!(
            "RONt {:.3} um peak to valley, RONp {peak:.3}, RONv {valley:.3}, RONq {rms:.3} um",
            peak + valley
        ),
        json: json!({ "RONt": peak + valley, "RONp": peak, "RONv": valley, "RONq": rms, "unit": "um" }),
    }
}

/// Waves around (undulations per revolution) with amplitude and the angle of the first crest.
fn harmonics(angles: &[f64], form: &[f64]) -> Finding {
    let count = form.len();
    let of = |m: usize| {
        let (mut cosine, mut sine) = (0.0, 0.0);
        for (angle, d) in angles.iter().zip(form) {
            cosine += d * (m as f64 * angle).cos();
            sine += d * (m as f64 * angle).sin();
        }
        let factor = 2.0 / count as f64;
        let amplitude = factor * cosine.hypot(sine);
        let step = TAU / m as f64;
        let mut crest = (sine.atan2(cosine) / m as f64).rem_euclid(step);
        if step - crest < 1e-9 * step {
            crest = 0.0;
        }
        (m, amplitude, crest)
    };
    // Up to a wave over four points, and not more than instruments show.
    let mut all: Vec<(usize, f64, f64)> = (2..=(count / 4).min(500)).map(of).collect();
    let largest = all.iter().fold(0.0f64, |size, h| size.max(h.1));
    all.retain(|h| h.1 > ROUND.max(LISTED * largest));
    let mut listed = all.clone();
    listed.sort_by(|a, b| b.1.total_cmp(&a.1));
    listed.truncate(MOST_LISTED);
    listed.sort_by_key(|h| h.0);
    let line = |(m, amplitude, crest): &(usize, f64, f64)| {
        format!("{m:>3} a turn: {:>9.4} um, crest at {:>6.1} deg", 1e6 * amplitude, crest.to_degrees())
    };
    let text = match listed.len() {
        0 => "none: the bore is round".into(),
        _ => listed.iter().map(line).collect::<Vec<_>>().join(&format!("\n{}", " ".repeat(27))),
    };
    let entry = |(m, amplitude, crest): &(usize, f64, f64)| json!({ "undulations": m, "amplitude": 1e6 * amplitude, "crest": crest.to_degrees() });
    let list: Vec<_> = all.iter().map(entry).collect();
    Finding {
        key: "harmonics",
        label: "waves, amplitude",
        text,
        json: json!({ "unit": "um", "crest_unit": "deg", "list": list }),
    }
}

fn clamping(setup: &Setup, clamped: &[f64]) -> Finding {
    let mean = 1e6 * clamped.iter().sum::<f64>() / clamped.len() as f64;
    let form = from_circle(setup, clamped);
    let range =
        |d: &[f64]| d.iter().fold(f64::NEG_INFINITY, |m, d| m.max(*d)) - d.iter().fold(f64::INFINITY, |m, d| m.min(*d));
    let form = 1e6 * range(&form);
    Finding {
        key: "clamped",
        label: "clamped, not yet bored",
        text: format!("{form:.3} um peak to valley, {mean:+.3} um of the radius"),
        json: json!({ "RONt": form, "mean": mean, "unit": "um" }),
    }
}

fn force(ring: &Ring) -> Finding {
    let (setup, machine) = (ring.setup(), &ring.machine);
    let standing = setup.jaw_force;
    let turning = machine.force_at(standing, setup.spindle_speed.unwrap_or(0.0));
    let let_go = machine.let_go();
    let text = match let_go.is_finite() {
        false => format!("{standing:.1} N each"),
        true => format!(
            "{standing:.1} N each at standstill, {turning:.1} N while boring; let go above {:.0} rpm",
            SPINDLE_SPEED.from_si(let_go)
        ),
    };
    let rpm = let_go.is_finite().then(|| SPINDLE_SPEED.from_si(let_go));
    Finding {
        key: "jaw_force",
        label: "jaw force",
        text,
        json: json!({ "standstill": standing, "boring": turning, "unit": "N", "let_go": rpm, "let_go_unit": "rpm" }),
    }
}

fn stress(scene: &Scene) -> Finding {
    let (stress, angle) = scene.largest_stress();
    let (mpa, angle) = (1e-6 * stress, angle.to_degrees());
    Finding {
        key: "stress",
        label: "stress on the bore",
        text: format!("up to {mpa:.2} MPa (von Mises) at {angle:.1} deg, clamped at standstill"),
        json: json!({ "value": mpa, "unit": "MPa", "angle": angle, "angle_unit": "deg" }),
    }
}

fn warnings(ring: &Ring) -> Vec<String> {
    let (setup, machine) = (ring.setup(), &ring.machine);
    let mut warnings = Vec::new();
    let speed = setup.spindle_speed.unwrap_or(0.0);
    if setup.jaw_force > 0.0 && machine.force_at(setup.jaw_force, speed) == 0.0 {
        warnings.push(format!(
            "at {:.0} rpm the jaws no longer press: above {:.0} rpm the ring is let go",
            SPINDLE_SPEED.from_si(speed),
            SPINDLE_SPEED.from_si(machine.let_go())
        ));
    }
    warnings.extend(setup.stiffened().filter(|by| *by > STIFFENED).map(|by| {
        format!(
            "elements of order 1 are some {:.0} % too stiff in bending here: take order = 2, or shorter ones",
            100.0 * by
        )
    }));
    warnings
}
