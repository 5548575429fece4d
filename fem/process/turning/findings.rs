//! What a run of a lathe finds, in numbers and in words.

use serde_json::json;

use super::elastic::Deflection;
use super::lathe::Lathe;
use super::model::{Setup, Workholding};
use crate::process::{Column, Failure, Finding, Outcome, Plot, Table};

/// A profile that varies by less than a nanometre is a cylinder.
const STRAIGHT: f64 = 1e-9;

/// Everything but the animation. `errors` holds ΔD in m, part by part, x rising.
pub fn outcome(
    lathe: &Lathe,
    positions: &[f64],
    deflections: &[Deflection],
    errors: Vec<f64>,
) -> Result<Outcome, Failure> {
    let setup = &lathe.machine.setup;
    let mut findings = extremes(setup, positions, &errors);
    let first = &errors[..positions.len()];
    findings.push(taper(positions, first));
    findings.push(form(positions, first));
    findings.extend(batch(setup, positions.len(), &errors));
    findings.push(forces(deflections));
    findings.push(schedule(setup));
    let plots = plots(positions, &errors);
    let warnings = warnings(lathe, positions, deflections)?;
    let profile = profile(setup, positions, &errors);
    Ok(Outcome { profile, tables: Vec::new(), findings, plots, drawings: Vec::new(), warnings, animation: None })
}

fn profile(setup: &Setup, positions: &[f64], errors: &[f64]) -> Table {
    let schedule = &setup.schedule;
    let points = || (1..=schedule.parts).flat_map(|part| positions.iter().map(move |&x| (part, x)));
    let column = Column::numbers;
    let diameters = points().zip(errors).map(|((_, x), e)| 1e3 * (setup.diameter(x) + e)).collect();
    Table {
        columns: vec![
            column("part", None, points().map(|p| p.0 as f64).collect()),
            column("x", Some("mm"), points().map(|p| 1e3 * p.1).collect()),
            column("time", Some("min"), points().map(|(k, x)| schedule.time(k, x) / 60.0).collect()),
            column("path", Some("m"), points().map(|(k, x)| schedule.path(k, x)).collect()),
            column("diameter_error", Some("um"), errors.iter().map(|e| 1e6 * e).collect()),
            column("finished_diameter", Some("mm"), diameters),
        ],
    }
}

fn extremes(setup: &Setup, positions: &[f64], errors: &[f64]) -> Vec<Finding> {
    let place = |i: usize| (1 + i / positions.len(), 1e3 * positions[i % positions.len()]);
    let finding = |key, label, i: usize| {
        let (part, x) = place(i);
        let on = if setup.schedule.parts > 1 { format!(" on part {part}") } else { String::new() };
        Finding {
            key,
            label,
            text: format!("{:+.3} um at x = {x:.1} mm{on}", 1e6 * errors[i]),
            json: json!({ "value": 1e6 * errors[i], "unit": "um", "x": x, "x_unit": "mm", "part": part }),
        }
    };
    let largest = first_extreme(errors, f64::gt);
    let smallest = first_extreme(errors, f64::lt);
    vec![
        finding("largest", "largest diameter error", largest),
        finding("smallest", "smallest diameter error", smallest),
    ]
}

/// Position of the first value that none exceeds by `beats`.
fn first_extreme(values: &[f64], beats: fn(&f64, &f64) -> bool) -> usize {
    (0..values.len()).reduce(|best, i| if beats(&values[i], &values[best]) { i } else { best }).unwrap_or(0)
}

/// Difference between the ends of the least-squares line through a profile (x rising), m.
fn line(positions: &[f64], errors: &[f64]) -> (f64, f64) {
    let n = errors.len() as f64;
    let (x_mean, e_mean) = (positions.iter().sum::<f64>() / n, errors.iter().sum::<f64>() / n);
    let (mut sxx, mut sxe) = (0.0, 0.0);
    for (x, e) in positions.iter().zip(errors) {
        sxx += (x - x_mean).powi(2);
        sxe += (x - x_mean) * (e - e_mean);
    }
    let slope = sxe / sxx;
    (slope, e_mean - slope * x_mean)
}

fn taper(positions: &[f64], errors: &[f64]) -> Finding {
    let (slope, _) = line(positions, errors);
    let length = positions[positions.len() - 1] - positions[0];
    let thick = if slope > 0.0 { "tailstock end" } else { "headstock end" };
    let size = 1e6 * (slope * length).abs();
    let text = match size {
        s if s < 5e-4 => format!("none over {:.1} mm", 1e3 * length),
        s => format!("{s:.3} um over {:.1} mm by the least-squares line, larger at the {thick}", 1e3 * length),
    };
    Finding {
        key: "taper",
        label: "taper, part 1",
        text,
        json: json!({ "value": 1e6 * slope * length, "unit": "um", "over": 1e3 * length, "over_unit": "mm" }),
    }
}

/// The form of a profile (x rising), by how often and which way it turns.
fn form(positions: &[f64], errors: &[f64]) -> Finding {
    let (slope, at_zero) = line(positions, errors);
    let taper = (slope * (positions[positions.len() - 1] - positions[0])).abs();
    let bow: Vec<f64> = positions.iter().zip(errors).map(|(x, e)| e - at_zero - slope * x).collect();
    let height = bow[first_extreme(&bow, f64::gt)] - bow[first_extreme(&bow, f64::lt)];
    let (top, bottom) = (first_extreme(errors, f64::gt), first_extreme(errors, f64::lt));
    let range = errors[top] - errors[bottom];
    let ends = [errors[0], errors[errors.len() - 1]];
    let turns = extrema(errors, 0.05 * range);
    let at = |i: usize| format!("at x = {:.1} mm", 1e3 * positions[i]);
    let (word, place, text) = if range < STRAIGHT {
        ("cylinder", None, "cylinder: the error is the same all along".to_string())
    } else if turns == 0 {
        let curved = if height > 0.2 * taper { ", along a curve" } else { "" };
        ("cone", None, format!("cone: the error runs from one end to the other{curved}"))
    } else if turns == 1 && errors[top] - ends[0].max(ends[1]) > 0.05 * range {
        let above = 1e6 * (errors[top] - 0.5 * (ends[0] + ends[1]));
        ("barrel", Some(top), format!("barrel: thickest {}, {above:.3} um above the mean of its ends", at(top)))
    } else if turns == 1 {
        let below = 1e6 * (0.5 * (ends[0] + ends[1]) - errors[bottom]);
        // A symmetric saddle is what shops call a corset.
        let word = if (ends[0] - ends[1]).abs() < 0.1 * range { "corset" } else { "saddle" };
        (word, Some(bottom), format!("{word}: thinnest {}, {below:.3} um below the mean of its ends", at(bottom)))
    } else {
        ("wavy", None, format!("wavy: it turns {turns} times within {:.3} um", 1e6 * range))
    };
    let x = place.map(|i| 1e3 * positions[i]);
    let json = json!({ "form": word, "range": 1e6 * range, "unit": "um", "at": x, "at_unit": "mm" });
    Finding { key: "form", label: "form, part 1", text, json }
}

/// How often a curve turns back by more than `least` between its ends.
fn extrema(curve: &[f64], least: f64) -> usize {
    let (mut turns, mut rising) = (0, None);
    let (mut low, mut high) = (curve[0], curve[0]);
    for &value in curve {
        (low, high) = (low.min(value), high.max(value));
        let turned = match rising {
            Some(true) => high - value > least,
            Some(false) => value - low > least,
            None => false,
        };
        if turned {
            turns += 1;
        }
        if turned {
            rising = rising.map(|r: bool| !r);
            (low, high) = (value, value);
        } else if rising.is_none() && high - low > least {
            rising = Some(value == high);
        }
    }
    turns
}

fn batch(setup: &Setup, per_part: usize, errors: &[f64]) -> Option<Finding> {
    if setup.schedule.parts < 2 {
        return None;
    }
    let means = part_means(per_part, errors);
    let (first, last) = (1e6 * means[0], 1e6 * means[means.len() - 1]);
    Some(Finding {
        key: "batch",
        label: "over the batch",
        text: format!("mean error {first:+.3} um on part 1, {last:+.3} um on part {}", means.len()),
        json: json!({ "part_means": means.iter().map(|m| 1e6 * m).collect::<Vec<_>>(), "unit": "um" }),
    })
}

fn part_means(per_part: usize, errors: &[f64]) -> Vec<f64> {
    errors.chunks(per_part).map(|part| part.iter().sum::<f64>() / part.len() as f64).collect()
}

fn forces(deflections: &[Deflection]) -> Finding {
    let of = |d: &Deflection| d.force;
    let low = deflections.iter().map(of).fold(f64::INFINITY, f64::min);
    let high = deflections.iter().map(of).fold(0.0, f64::max);
    let text = if high - low < 1e-9 * high {
        format!("{high:.1} N")
    } else {
        format!("{low:.1} to {high:.1} N along the pass")
    };
    Finding {
        key: "radial_force",
        label: "radial force",
        text,
        json: json!({ "smallest": low, "largest": high, "unit": "N" }),
    }
}

fn schedule(setup: &Setup) -> Finding {
    let schedule = &setup.schedule;
    let (cut, end) = (schedule.pass.duration() / 60.0, schedule.time(schedule.parts, schedule.pass.to) / 60.0);
    let path = schedule.path(schedule.parts, schedule.pass.to);
    Finding {
        key: "schedule",
        label: "schedule",
        text: format!(
            "{} part(s), {cut:.3} min of cutting each, done after {end:.2} min and {path:.1} m of cutting path",
            schedule.parts
        ),
        json: json!({ "parts": schedule.parts, "cutting_time": cut, "end": end, "time_unit": "min", "path": path, "path_unit": "m" }),
    }
}

fn plots(positions: &[f64], errors: &[f64]) -> Vec<Plot> {
    let per_part = positions.len();
    let curve = |errors: &[f64]| positions.iter().zip(errors).map(|(x, e)| (1e3 * x, 1e6 * e)).collect();
    let parts = errors.len() / per_part;
    let of_x = |part: usize| Plot {
        title: format!("diameter error [um] over x [mm], part {part}"),
        x_unit: "mm",
        points: curve(&errors[(part - 1) * per_part..part * per_part]),
    };
    let mut plots = vec![of_x(1)];
    if parts > 1 {
        let means = part_means(per_part, errors);
        let points = means.iter().enumerate().map(|(k, m)| ((k + 1) as f64, 1e6 * m)).collect();
        plots.push(of_x(parts));
        plots.push(Plot { title: "mean diameter error [um] over parts".into(), x_unit: "part", points });
    }
    plots
}

fn warnings(lathe: &Lathe, positions: &[f64], deflections: &[Deflection]) -> Result<Vec<String>, Failure> {
    let machine = &lathe.machine;
    let setup = &machine.setup;
    let mut warnings = Vec::new();
    let mut pulls = |who: &str, forces: &mut dyn Iterator<Item = f64>| {
        let worst = positions.iter().zip(forces).min_by(|a, b| a.1.total_cmp(&b.1));
        let load = deflections.iter().map(|d| d.force).fold(0.0, f64::max);
        if let Some((x, force)) = worst.filter(|w| w.1 < -1e-4 * load) {
            warnings.push(format!(
                "{who} would have to pull with {:.1} N while the tool is at x = {:.1} mm; it can only press, and the shaft would lift off there",
                -force,
                1e3 * x
            ));
        }
    };
    // A chuck can pull, unless its joint is a contact.
    if setup.workholding == Workholding::Centres || !machine.headstock.contacts.is_empty() {
        pulls("the headstock", &mut deflections.iter().map(|d| d.supports.forces[0]));
    }
    if setup.workholding.has_tailstock() {
        pulls("the tailstock", &mut deflections.iter().map(|d| d.supports.forces[1]));
    }
    for (rest, forces) in setup.steady_rests.iter().zip(rest_forces(lathe, positions, deflections)?) {
        pulls(&format!("the steady rest at {:.1} mm", 1e3 * rest.at), &mut forces.into_iter());
    }
    let idle = deflections.iter().filter(|d| d.force <= 0.0).count();
    if idle > 0 && setup.nominal_force() > 0.0 {
        warnings.push(format!("the tool does not touch the work at {idle} of {} positions", deflections.len()));
    }
    let is_told = !setup.passes.is_empty() || !setup.blank.is_true();
    if is_told && machine.feedback.is_none_or(|e| e == 0.0) {
        warnings.push(
            "without the effect `force-feedback` nothing is copied: blank and earlier passes change nothing".into(),
        );
    }
    let deepest = deflections.iter().map(|d| d.total).fold(0.0, f64::max);
    if deepest > setup.cut.depth {
        warnings.push(format!(
            "the gap of {:.1} um is larger than the depth of cut of {:.1} um: the tool would leave the work; the effect `force-feedback` lets the force fall with the depth",
            1e6 * deepest,
            1e6 * setup.cut.depth
        ));
    }
    Ok(warnings)
}

/// Force of each steady rest at every tool position, N. By reciprocity the deflection at a rest while the tool is at x is that
/// at x while a force stands at the rest.
pub fn rest_forces(lathe: &Lathe, positions: &[f64], deflections: &[Deflection]) -> Result<Vec<Vec<f64>>, Failure> {
    let rests = &lathe.machine.setup.steady_rests;
    if rests.is_empty() {
        return Ok(Vec::new());
    }
    let all: Vec<f64> = positions.iter().copied().chain(rests.iter().map(|r| r.at)).collect();
    let shaft = lathe.condense(&all)?;
    let force = |i: usize, stiffness: f64| {
        let influence = shaft.influence[i];
        let shape = shaft.shape(i);
        deflections
            .iter()
            .zip(shape)
            .map(|(d, unit)| {
                let y = d.supports.displacements;
                stiffness * (unit * d.force + influence[0] * y[0] + influence[1] * y[1])
            })
            .collect()
    };
    Ok(rests.iter().enumerate().map(|(r, rest)| force(positions.len() + r, rest.stiffness)).collect())
}
