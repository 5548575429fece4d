//! What a run of an axis finds, in numbers and in words.

use serde_json::json;

use super::job::Axis;
use super::model::Setup;
use super::observe;
use crate::positioning::{Direction, EDITION, Evaluation, Quantity};
use crate::process::{Column, Finding, Outcome, Plot, Positioning, Rows, Table};

/// Of two clearances one rules when it is this many times the other.
const RULES: f64 = 2.0;
/// A lost motion below this (m) is none.
const NONE: f64 = 1e-10;

/// Everything but the animation. `deviations` are those of the model's own test, m.
pub fn outcome(axis: &Axis, deviations: &[f64]) -> Outcome {
    let setup = &axis.machine.setup;
    let programme = observe::programme(setup);
    let evaluation = Evaluation::of(&setup.approaches(&programme), deviations);
    let quantities = evaluation.quantities();
    let mut findings = vec![
        extreme("largest", "largest deviation", (&programme, deviations), |a, b| a > b),
        extreme("smallest", "smallest deviation", (&programme, deviations), |a, b| a < b),
        standard(&quantities),
    ];
    findings.extend(["A", "E", "M", "R", "B"].iter().filter_map(|symbol| quantity(&quantities, symbol)));
    findings.push(lost_motion(axis));
    findings.push(screw(setup));
    let warnings = warnings(axis);
    let (profile, plots) = (profile(&programme, deviations), plots(&evaluation));
    Outcome { profile, findings, plots, warnings, animation: None, drawings: Vec::new(), tables: Vec::new() }
}

/// A measurement file of its own: it reads back as what was predicted.
fn profile(rows: &Rows, deviations: &[f64]) -> Table {
    let column = Column::numbers;
    let of = |coordinate: usize, scale: f64| rows.columns[coordinate].iter().map(|v| scale * v).collect::<Vec<f64>>();
    Table {
        columns: vec![
            column("run", None, of(observe::RUN, 1.0)),
            column("position", Some("mm"), of(observe::POSITION, 1e3)),
            Column::words("direction", of(observe::DIRECTION, 1.0), observe::DIRECTIONS),
            column("time", Some("min"), of(observe::TIME_OF_ROW, 1.0 / 60.0)),
            column("deviation", Some("um"), deviations.iter().map(|d| 1e6 * d).collect()),
        ],
    }
}

fn extreme(
    key: &'static str,
    label: &'static str,
    (rows, deviations): (&Rows, &[f64]),
    beats: fn(f64, f64) -> bool,
) -> Finding {
    let i = (0..deviations.len()).fold(0, |best, i| if beats(deviations[i], deviations[best]) { i } else { best });
    let at = observe::moment(rows, i);
    let (value, position, run) = (1e6 * deviations[i], 1e3 * at.position, rows.columns[observe::RUN][i]);
    let sign = at.direction.sign();
    Finding {
        key,
        label,
        text: format!("{value:+.3} um at {position:.1} mm approached in {sign}, run {run}"),
        json: json!({ "value": value, "unit": "um", "position": position, "position_unit": "mm", "direction": sign, "run": run }),
    }
}

fn standard(quantities: &[Quantity]) -> Finding {
    let entry = |q: &Quantity| json!({ "symbol": q.symbol, "name": q.name, "formula": q.formula, "value": q.value.map(|v| 1e6 * v) });
    Finding {
        key: "iso230",
        label: EDITION,
        text: "of this prediction, which has no scatter: s is what drifts from run to run".into(),
        json: json!({ "edition": EDITION, "unit": "um", "quantities": quantities.iter().map(entry).collect::<Vec<_>>() }),
    }
}

fn quantity(all: &[Quantity], symbol: &str) -> Option<Finding> {
    let (key, label) = match symbol {
        "A" => ("accuracy", "  A accuracy"),
        "E" => ("systematic", "  E systematic error"),
        "M" => ("mean_bidirectional", "  M mean of both ways"),
        "R" => ("repeatability", "  R repeatability"),
        _ => ("reversal", "  B reversal error"),
    };
    let found = all.iter().find(|q| q.symbol == symbol)?;
    let value = found.value.map(|v| 1e6 * v);
    let place = found.at.map_or(String::new(), |at| format!(" at {:.1} mm", 1e3 * at));
    let text = value.map_or("needs two runs".into(), |v| format!("{v:.3} um{place}"));
    Some(Finding { key, label, text, json: json!({ "value": value, "unit": "um" }) })
}

/// Which clearance rules [seed 000]: the kinematic one of light machines, or the elastic one of heavy machines.
fn lost_motion(axis: &Axis) -> Finding {
    let setup = &axis.machine.setup;
    let elastic: Vec<f64> = setup.targets().iter().map(|x| axis.machine.lost_motion(*x).1).collect();
    let low = elastic.iter().copied().fold(f64::INFINITY, f64::min);
    let high = elastic.iter().copied().fold(0.0, f64::max);
    let kinematic = axis.machine.gap;
    let typical = 0.5 * (low + high);
    let rules = match (kinematic, typical) {
        (k, e) if k.max(e) < NONE => "none",
        (k, e) if k >= RULES * e => "kinematic",
        (k, e) if e >= RULES * k => "elastic",
        _ => "both",
    };
    let sizes = format!("kinematic {:.3} um, elastic {:.3} to {:.3} um", 1e6 * kinematic, 1e6 * low, 1e6 * high);
    let text = match rules {
        "none" => "none".into(),
        "kinematic" => format!("{sizes}: the kinematic gap rules, as in light machines"),
        "elastic" => format!("{sizes}: the elastic gap rules, as in heavy machines"),
        _ => format!("{sizes}: neither rules"),
    };
    Finding {
        key: "lost_motion",
        label: "lost motion",
        text,
        json: json!({ "kinematic": 1e6 * kinematic, "elastic": [1e6 * low, 1e6 * high], "unit": "um", "rules": rules }),
    }
}

fn screw(setup: &Setup) -> Finding {
    let screw = setup.screw();
    let softest = setup.targets().iter().map(|x| screw.compliance(*x)).fold(0.0, f64::max);
    let stiffness = (softest > 0.0).then(|| 1e-6 / softest);
    let text = match stiffness {
        Some(k) => format!("{k:.1} N/um along itself where it is softest"),
        None => "rigid at every target".into(),
    };
    Finding { key: "screw_stiffness", label: "screw", text, json: json!({ "value": stiffness, "unit": "N/um" }) }
}

/// The mean deviation of each direction.
fn plots(evaluation: &Evaluation) -> Vec<Plot> {
    let curve = |direction: Direction| {
        let point = |t: &crate::positioning::Target| Some((1e3 * t.position, 1e6 * t.side(direction)?.mean));
        let points = evaluation.targets.iter().filter_map(point).collect();
        Plot {
            title: format!("mean deviation [um] over position [mm], approached in {}", direction.sign()),
            x_unit: "mm",
            points,
        }
    };
    Direction::BOTH.map(curve).into()
}

fn warnings(axis: &Axis) -> Vec<String> {
    let setup = &axis.machine.setup;
    let parts = setup.targets().iter().map(|x| x / setup.lead - (x / setup.lead).round()).collect::<Vec<_>>();
    let mut warnings = Vec::new();
    if parts.iter().all(|part| part.abs() < 1e-6) {
        warnings.push(
            "all targets are multiples of the lead: errors that repeat with each turn cannot be seen; spacing = \"staggered\" in [test] moves them".into(),
        );
    }
    warnings
}
