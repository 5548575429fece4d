//! What a run of a cam finds, in numbers and in words.

use serde_json::json;

use super::job::Cam;
use super::model::{By, Setup};
use super::observe;
use super::report::{Block, Report};
use super::{shapes, tables, warnings};
use crate::process::{Column, Curve, Drawing, Finding, Outcome, Plot, Table};
use crate::units::SPINDLE_SPEED;

/// Jumps and back-sweeps below this are none, m.
const STILL: f64 = 1e-9;
/// Lines of findings stand under each other.
const INDENT: usize = 27;

/// Everything but the animation. `deviations` are those of the model's own points, m.
pub fn outcome(cam: &Cam, report: &Report, deviations: &[f64]) -> Outcome {
    let setup = cam.setup();
    let mut findings = vec![
        extreme(setup, report, ("largest", "largest deviation"), |b| b.thickest, |a, b| a > b),
        extreme(setup, report, ("smallest", "smallest deviation"), |b| b.thinnest, |a, b| a < b),
        programme(setup),
        segments(setup, report),
        grinding_point(report),
        feed(report),
    ];
    findings.extend(removal(setup, report));
    let nominal = shapes::spots(setup, |_| 0.0);
    let predicted = shapes::spots(setup, |i| deviations[i]);
    let curve = Curve { label: "predicted".into(), family: 0, is_measured: false, pieces: vec![predicted] };
    let title = "deviation of the cam, magnified".into();
    Outcome {
        profile: profile(setup, deviations),
        tables: vec![("program", tables::program(setup)), ("blocks", tables::blocks(setup, report))],
        findings,
        plots: vec![plot(setup, deviations)],
        drawings: vec![Drawing { name: "cam", title, nominal: vec![nominal], curves: vec![curve] }],
        warnings: warnings::warnings(cam, report),
        animation: None,
    }
}

/// A measurement file of its own.
fn profile(setup: &Setup, deviations: &[f64]) -> Table {
    let rows = observe::programme(setup);
    let speed = SPINDLE_SPEED.from_si(setup.program.mean_speed);
    let degrees = rows.columns[observe::ANGLE_OF_ROW].iter().map(|a| a.to_degrees()).collect();
    Table {
        columns: vec![
            Column::numbers("angle", Some("deg"), degrees),
            Column::numbers("cam_speed", Some("rpm"), vec![speed; deviations.len()]),
            Column::numbers("deviation", Some("um"), deviations.iter().map(|d| 1e6 * d).collect()),
        ],
    }
}

fn plot(setup: &Setup, deviations: &[f64]) -> Plot {
    let degrees = setup.places().into_iter().map(|s| setup.profile.angle(s).to_degrees());
    let mut points: Vec<(f64, f64)> = degrees.zip(deviations.iter().map(|d| 1e6 * d)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    Plot { title: "deviation [um] over polar angle [deg]".into(), x_unit: "deg", points }
}

fn extreme(
    setup: &Setup,
    report: &Report,
    (key, label): (&'static str, &'static str),
    of: fn(&Block) -> (f64, f64),
    beats: fn(f64, f64) -> bool,
) -> Finding {
    // By more than round-off, so that of equal ones the first is told.
    let better = |best: usize, i: usize| {
        let (value, other) = (of(&report.blocks[i]).0, of(&report.blocks[best]).0);
        if beats(value, other) && (value - other).abs() > 1e-13 { i } else { best }
    };
    let block = (0..report.blocks.len()).fold(0, better);
    let (value, s) = of(&report.blocks[block]);
    let (value, angle) = (1e6 * value, setup.profile.angle(s).to_degrees());
    Finding {
        key,
        label,
        text: format!("{value:+.3} um at {angle:.2} deg, block {}", block + 1),
        json: json!({ "value": value, "unit": "um", "angle": angle, "angle_unit": "deg", "block": block + 1 }),
    }
}

/// From the least to the greatest of some values.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

fn programme(setup: &Setup) -> Finding {
    let program = &setup.program;
    let count = program.blocks();
    let steps = range(program.places.windows(2).map(|w| 1e3 * (w[1] - w[0])));
    let turns = range(program.axes.turns.windows(2).map(|w| (w[1] - w[0]).abs().to_degrees()));
    let times = range(program.axes.times.windows(2).map(|w| 1e3 * (w[1] - w[0])));
    let time = program.axes.times[count];
    let division = &setup.division;
    let by = match division.by {
        By::Step => format!("of {:.4} mm of profile at most", 1e3 * division.size),
        By::Angle => format!("of {:.4} deg of the cam at most", division.size.to_degrees()),
        By::Blocks => "of equal turn of the cam".into(),
        By::Tolerance => format!("as few as keep {:.3} um", 1e6 * division.size),
    };
    Finding {
        key: "program",
        label: "programme",
        text: format!(
            "{count} block(s) {by}: {:.4} to {:.4} mm, {:.4} to {:.4} deg, {:.2} to {:.2} ms; a turn in {time:.3} s",
            steps.0, steps.1, turns.0, turns.1, times.0, times.1
        ),
        json: json!({
            "blocks": count, "shortest_step": steps.0, "longest_step": steps.1, "step_unit": "mm",
            "smallest_turn": turns.0, "largest_turn": turns.1, "turn_unit": "deg", "time": time, "time_unit": "s",
        }),
    }
}

fn segments(setup: &Setup, report: &Report) -> Finding {
    let mut lines = Vec::new();
    let mut list = Vec::new();
    for (i, segment) in setup.segments.iter().enumerate() {
        let own = |b: &&Block| setup.profile.segment(0.5 * (b.places.0 + b.places.1)) == i;
        let count = report.blocks.iter().filter(own).count();
        let thick = 1e6 * report.blocks.iter().filter(own).map(|b| b.thickest.0).fold(f64::NEG_INFINITY, f64::max);
        let thin = 1e6 * report.blocks.iter().filter(own).map(|b| b.thinnest.0).fold(f64::INFINITY, f64::min);
        // Round-off has no sign to show.
        let [thin, thick] = [thin, thick].map(|v| if v.abs() < 5e-4 { 0.0 } else { v });
        let numbers = match count {
            0 => "in no block of its own".into(),
            _ => format!("{count:>5} block(s) {thin:>+10.3} to {thick:>+10.3} um"),
        };
        lines.push(format!("{:>2} {:<26} {numbers}", i + 1, segment.name));
        let known = |v: f64| v.is_finite().then_some(v);
        list.push(json!({ "segment": i + 1, "name": segment.name, "blocks": count, "smallest": known(thin), "largest": known(thick) }));
    }
    Finding {
        key: "segments",
        label: "along the profile",
        text: lines.join(&format!("\n{}", " ".repeat(INDENT))),
        json: json!({ "unit": "um", "list": list }),
    }
}

fn grinding_point(report: &Report) -> Finding {
    let jumps: Vec<f64> = report.blocks.iter().map(|b| b.jump).filter(|j| *j > STILL).map(|j| 1e3 * j).collect();
    let sweeps: Vec<f64> = report.blocks.iter().map(|b| b.jump).filter(|j| *j < -STILL).map(|j| -1e3 * j).collect();
    let imprint: f64 = 1e3 * report.blocks.iter().map(|b| b.imprint).sum::<f64>();
    let shaped: f64 = 1e3 * report.blocks.iter().map(|b| b.shaped).sum::<f64>();
    let told = |values: &[f64], what: &str| match values.len() {
        0 => format!("no {what}"),
        n => format!("{n} {what}(s) up to {:.3} mm", range(values.iter().copied()).1),
    };
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    Finding {
        key: "grinding_point",
        label: "grinding point",
        text: format!(
            "{}, {}; {:.1} % of the profile is imprint of the standing wheel",
            told(&jumps, "jump"),
            told(&sweeps, "back-sweep"),
            100.0 * imprint / (imprint + shaped)
        ),
        json: json!({
            "jumps": jumps.len(), "largest_jump": largest(&jumps), "back_sweeps": sweeps.len(), "largest_back_sweep": largest(&sweeps),
            "imprint": imprint, "envelope": shaped, "unit": "mm",
        }),
    }
}

fn feed(report: &Report) -> Finding {
    let mean = range(report.blocks.iter().map(|b| 6e4 * (b.places.1 - b.places.0) / b.time));
    let least = 6e4 * report.blocks.iter().map(|b| b.feed.0).fold(f64::INFINITY, f64::min);
    let greatest = 6e4 * report.blocks.iter().map(|b| b.feed.1).fold(f64::NEG_INFINITY, f64::max);
    Finding {
        key: "feed",
        label: "feed along the cam",
        text: format!(
            "{:.1} to {:.1} mm/min by block; {least:.1} to {greatest:.1} mm/min of the grinding point within blocks",
            mean.0, mean.1
        ),
        json: json!({ "least_mean": mean.0, "greatest_mean": mean.1, "least": least, "greatest": greatest, "unit": "mm/min" }),
    }
}

fn removal(setup: &Setup, report: &Report) -> Option<Finding> {
    let stock = 1e6 * setup.stock?;
    let removals: Vec<_> = report.blocks.iter().filter_map(|b| b.removal.as_ref().map(|r| (r, b.time))).collect();
    let rates = range(removals.iter().map(|(r, time)| 1e6 * r.area / time));
    let tenths =
        removals.iter().flat_map(|(r, time)| r.tenths.iter().map(move |a| 1e7 * a / time)).fold(rates.1, f64::max);
    let by_tenths = removals.iter().any(|(r, _)| !r.tenths.is_empty());
    let at_most = if by_tenths { format!(", {tenths:.4} at most in a tenth of one") } else { String::new() };
    let lifted = |r: &super::contact::Removal| !r.tenths.is_empty() && r.cutting().len() < r.tenths.len();
    let partly = removals.iter().filter(|(r, _)| lifted(r)).count();
    let contact = match by_tenths {
        true => format!("; lifted off for part of {partly} block(s)"),
        false => {
            format!("; by tenths, and where it is lifted off, only of {} blocks or fewer", super::contact::MOST_BLOCKS)
        }
    };
    Some(Finding {
        key: "removal",
        label: "removal rate",
        text: format!(
            "{:.4} to {:.4} mm^2/s by block{at_most}, of a layer of {stock:.1} um{contact}",
            rates.0, rates.1
        ),
        json: json!({
            "stock": stock, "stock_unit": "um", "least": rates.0, "greatest": rates.1, "greatest_of_a_tenth": by_tenths.then_some(tenths), "unit": "mm^2/s",
            "blocks_partly_lifted": by_tenths.then_some(partly),
        }),
    })
}
