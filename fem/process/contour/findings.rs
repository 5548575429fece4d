//! What a run of a contour finds, in numbers and in words.

use serde_json::json;

use super::job::Contouring;
use super::machine::Lap;
use super::model::AXES;
use super::path::{Direction, Path, rounded};
use super::{circle, observe, rectangle, reversing};
use crate::process::{Column, Failure, Finding, Outcome, Plot, Rows, Table};
use crate::units::FEED_RATE;

/// Where the text of a finding begins on a line.
pub const INDENT: usize = 27;
/// Points along a contour of which the largest and the smallest are told, at least: a spike lasts some milliseconds, a hundredth of a degree.
const FINE: usize = 36_000;
/// Lags above this, in rad, are no small ones: the first-order formulas are then wrong by as much.
const LARGE_LAG: f64 = 0.1;

/// Everything but drawing and animation. `deviations` in m, direction by direction.
///
/// # Errors
/// The contour cannot be computed.
pub fn outcome(contouring: &Contouring, deviations: &[f64]) -> Result<Outcome, Failure> {
    let rows = observe::programme(contouring.setup());
    Ok(Outcome {
        profile: profile(&rows, deviations),
        tables: Vec::new(),
        findings: findings(&contouring.with_points(FINE))?,
        plots: vec![plot(contouring, &rows, deviations)],
        drawings: Vec::new(),
        warnings: warnings(contouring),
        animation: None,
    })
}

/// Of a contour that is seen at so many points that no spike falls between two of them.
fn findings(contouring: &Contouring) -> Result<Vec<Finding>, Failure> {
    let setup = contouring.setup();
    let rows = observe::programme(setup);
    let deviations = &observe::observe(contouring, &rows)?;
    let mut findings = vec![
        extreme("largest", "largest deviation", &rows, deviations, |a, b| a > b),
        extreme("smallest", "smallest deviation", &rows, deviations, |a, b| a < b),
    ];
    match setup.path {
        Path::Circle { .. } => {
            findings.extend(circle::findings(contouring, deviations));
            findings.push(reversing::reversals(contouring));
        }
        Path::Rectangle { .. } => findings.extend(rectangle::findings(contouring, deviations)),
    }
    findings.extend(reversing::advice(contouring));
    findings.push(servo(contouring));
    findings.extend(tolerance(contouring, deviations));
    Ok(findings)
}

/// Lines of a finding, one below the other.
pub fn stacked(lines: &[String]) -> String {
    lines.join(&format!("\n{}", " ".repeat(INDENT)))
}

/// A measurement file of its own: with the conditions written out, it reads back as what was predicted.
fn profile(rows: &Rows, deviations: &[f64]) -> Table {
    // Without the digits that conversion leaves: 1000 mm/min is written as 1000.
    let written = |v: f64| format!("{v:.12e}").parse().unwrap_or(v);
    let of = |column: usize, shown: fn(f64) -> f64| rows.columns[column].iter().map(|v| written(shown(*v))).collect();
    Table {
        columns: vec![
            Column::words("direction", of(observe::DIRECTION, |d| d), Direction::NAMES),
            Column::numbers("feed", Some("mm/min"), of(observe::FEED, |v| FEED_RATE.from_si(v))),
            Column::numbers("angle", Some("deg"), of(observe::ANGLE_OF_ROW, f64::to_degrees)),
            Column::numbers("deviation", Some("um"), deviations.iter().map(|d| 1e6 * d).collect()),
        ],
    }
}

fn extreme(
    key: &'static str,
    label: &'static str,
    rows: &Rows,
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
    let (value, angle) = (1e6 * deviations[i], rows.columns[observe::ANGLE_OF_ROW][i].to_degrees());
    let direction = Direction::at(rows.columns[observe::DIRECTION][i]).word();
    Finding {
        key,
        label,
        text: format!("{value:+.3} um at {angle:.1} deg, {direction}"),
        json: json!({ "value": value, "unit": "um", "angle": angle, "angle_unit": "deg", "direction": direction }),
    }
}

/// What two equal servos do by themselves: they follow at a distance, and a circle shrinks.
fn servo(contouring: &Contouring) -> Finding {
    let setup = contouring.setup();
    let lag = 1e3 * setup.feed / setup.gain;
    let mut json = json!({ "lag": lag, "lag_unit": "mm" });
    let mut text = format!("each axis follows {lag:.3} mm (v/Kv) behind its command");
    if let Path::Circle { radius } = setup.path {
        let [once, twice] = [1.0, 2.0].map(|times| -1e6 * contraction(radius, times * setup.feed, setup.gain));
        text = format!("{text}: of the radius {once:+.3} um, at twice the feed {twice:+.3} um");
        json["contraction"] = json!(-once);
        json["contraction_at_twice_the_feed"] = json!(-twice);
        json["unit"] = json!("um");
    }
    Finding { key: "servo", label: "servos alone", text, json }
}

/// R(1 − 1/√(1 + (v/RKv)²)), m.
pub fn contraction(radius: f64, feed: f64, gain: f64) -> f64 {
    let ratio = feed / (radius * gain);
    // The same without the difference of nearly equal numbers.
    let root = ratio.hypot(1.0);
    radius * ratio * ratio / (root * (1.0 + root))
}

/// What the tolerance allows the servos: seed 000 turned round, ΔKv/Kv = 2δ·Kv/v, and the feed at which the gains as they are would keep it.
fn tolerance(contouring: &Contouring, deviations: &[f64]) -> Option<Finding> {
    let (setup, machine) = (contouring.setup(), &contouring.machine);
    let allowed = setup.tolerance?;
    // How much of δ = (v/2)·(1/Kvy − 1/Kvx)·sin 2α shows: all of it on a circle.
    let shows = match setup.path {
        Path::Circle { .. } => 1.0,
        Path::Rectangle { angle, .. } => (2.0 * angle).sin().abs(),
    };
    let mismatch = 2.0 * allowed * setup.gain / (setup.feed * shows);
    let largest = deviations.iter().fold(0.0f64, |m, d| m.max(d.abs()));
    let [x, y] = machine.gains;
    let present = (x - y) / setup.gain;
    let by_mismatch = 2.0 * allowed / ((1.0 / y - 1.0 / x).abs() * shows);
    let by_contraction = match setup.path {
        Path::Circle { radius } if allowed < radius => {
            let left = 1.0 - allowed / radius;
            radius * setup.gain * (1.0 - left * left).sqrt() / left
        }
        _ => f64::INFINITY,
    };
    let word = if largest <= allowed { "kept" } else { "exceeded" };
    let mut lines =
        vec![format!("{:.3} um is {word}: the largest deviation is {:.3} um", 1e6 * allowed, 1e6 * largest)];
    if mismatch.is_finite() && mismatch < 2.0 {
        lines.push(format!(
            "gains may differ by {:.2} % at this feed (2*deviation*Kv/v); they differ by {:.2} %",
            100.0 * mismatch,
            100.0 * present.abs()
        ));
    }
    for (cause, feed) in [("the gains as they are", by_mismatch), ("the lag of equal servos", by_contraction)] {
        if feed.is_finite() {
            lines.push(format!("{cause} would alone use it up at {} mm/min", rounded(FEED_RATE.from_si(feed))));
        }
    }
    let finite = |v: f64| v.is_finite().then_some(v);
    Some(Finding {
        key: "tolerance",
        label: "tolerance",
        text: stacked(&lines),
        json: json!({
            "deviation": 1e6 * allowed, "unit": "um", "kept": largest <= allowed,
            "mismatch_allowed": finite(mismatch), "mismatch": present,
            "feed_by_mismatch": finite(FEED_RATE.from_si(by_mismatch)),
            "feed_by_contraction": finite(FEED_RATE.from_si(by_contraction)),
            "feed_unit": "mm/min",
        }),
    })
}

fn plot(contouring: &Contouring, rows: &Rows, deviations: &[f64]) -> Plot {
    let direction = contouring.setup().directions[0];
    let own = (0..rows.len()).filter(|i| Direction::at(rows.columns[observe::DIRECTION][*i]) == direction);
    let points = own.map(|i| (rows.columns[observe::ANGLE_OF_ROW][i].to_degrees(), 1e6 * deviations[i])).collect();
    Plot { title: format!("deviation [um] over angle [deg], {}", direction.word()), x_unit: "deg", points }
}

fn warnings(contouring: &Contouring) -> Vec<String> {
    let (setup, machine) = (contouring.setup(), &contouring.machine);
    let mut warnings = Vec::new();
    let lap = Lap::new(machine, setup.directions[0], setup.feed);
    for (axis, name) in AXES.iter().enumerate() {
        if !lap.axes[axis].follows() {
            warnings.push(format!("{name} does not move: its play is wider than its travel"));
        }
        let half = 0.5 * lap.axes[axis].motion.period();
        let spike = machine.spikes[axis];
        if spike.height > 0.0 && 3.0 * spike.time_constant > half {
            warnings.push(format!(
                "the spike of {name} has not faded when it turns round again, {half:.2} s later: what is left of it is not kept"
            ));
        }
    }
    if let Path::Circle { radius } = setup.path {
        let lag = setup.feed / (radius * setup.gain);
        if lag > LARGE_LAG {
            warnings.push(format!("the axes lag by {:.1} deg: check feed, radius and gain", lag.atan().to_degrees()));
        }
    }
    warnings
}
