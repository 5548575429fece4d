//! What a test of a joint finds, in numbers and in words.

use serde_json::json;

use super::curve::{Branch, Curve};
use super::job::Pushed;
use super::observe::{BRANCHES, UNLOAD};
use crate::process::{Column, Finding, Outcome, Plot, Table};

/// Everything of a run. `displacements` are those of loading and then of unloading, m.
pub fn outcome(joint: &Pushed, displacements: Vec<f64>) -> Outcome {
    let curve = &joint.curve;
    let forces = joint.setup.forces();
    let (up, down) = displacements.split_at(forces.len());
    let mut findings = vec![largest(&forces, up, down), stiffness(&joint.curve), friction(curve), after(down)];
    findings.push(area(curve));
    findings.push(with_and_without_preload(joint));
    Outcome {
        profile: profile(&forces, &displacements),
        tables: vec![("tangent", tangents(joint))],
        findings,
        plots: plots(&forces, up, down),
        drawings: Vec::new(),
        warnings: warnings(curve),
        animation: None,
    }
}

fn um(si: f64) -> f64 {
    1e6 * si
}

/// A stiffness in N/um.
fn shown(si: f64) -> f64 {
    1e-6 * si
}

fn profile(forces: &[f64], displacements: &[f64]) -> Table {
    let down = forces.iter().rev();
    let branch = [vec![0.0; forces.len()], vec![UNLOAD; forces.len()]].concat();
    Table {
        columns: vec![
            Column::numbers("force", Some("N"), forces.iter().chain(down).copied().collect()),
            Column::words("branch", branch, BRANCHES),
            Column::numbers("displacement", Some("um"), displacements.iter().map(|y| um(*y)).collect()),
        ],
    }
}

/// Tangent stiffness in the middle of every step in which the joint moves, and what it would be without preload.
fn tangents(joint: &Pushed) -> Table {
    let curve = &joint.curve;
    let bare = curve.preloaded(0.0);
    let forces = joint.setup.forces();
    let middles: Vec<f64> = forces.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
    let up = middles.iter().map(|f| (*f, Branch::Load));
    let down = middles.iter().rev().map(|f| (*f, Branch::Unload));
    let moving: Vec<(f64, Branch)> = up.chain(down).filter(|(f, b)| curve.tangent(*f, *b).is_some()).collect();
    let of = |figure: &dyn Fn(f64, Branch) -> f64| moving.iter().map(|(f, b)| figure(*f, *b)).collect::<Vec<_>>();
    let tangent = |curve: &Curve, f: f64, b: Branch| shown(curve.tangent(f, b).unwrap_or(0.0));
    let mut columns = vec![
        Column::numbers("force", Some("N"), of(&|f, _| f)),
        Column::words("branch", of(&|_, b| if b == Branch::Unload { UNLOAD } else { 0.0 }), BRANCHES),
        Column::numbers("displacement", Some("um"), of(&|f, b| um(curve.displacement(f, b)))),
        Column::numbers("tangent_stiffness", Some("N/um"), of(&|f, b| tangent(curve, f, b))),
    ];
    if curve.preload > 0.0 {
        columns.push(Column::numbers(
            "displacement_without_preload",
            Some("um"),
            of(&|f, b| um(bare.displacement(f, b))),
        ));
        columns.push(Column::numbers("stiffness_without_preload", Some("N/um"), of(&|f, b| tangent(&bare, f, b))));
    }
    Table { columns }
}

fn largest(forces: &[f64], up: &[f64], down: &[f64]) -> Finding {
    let at = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let value = um(at(up).max(at(down)));
    let force = forces[forces.len() - 1];
    Finding {
        key: "largest",
        label: "largest displacement",
        text: format!("{value:+.3} um at {force:.1} N"),
        json: json!({ "value": value, "unit": "um", "force": force, "force_unit": "N" }),
    }
}

/// Where the joint has begun to move its tangent is told at this part of the largest force: under no force at all most contacts have none.
const BEGUN: f64 = 0.02;

/// N.
fn begun(curve: &Curve) -> f64 {
    (curve.friction + BEGUN * curve.max_force).min(curve.max_force)
}

/// Tangent stiffness where loading has set the joint moving, and at the largest force, N/um.
fn ends(curve: &Curve) -> [Option<f64>; 2] {
    [begun(curve), curve.max_force].map(|force| curve.tangent(force, Branch::Load).map(shown))
}

/// Tangent stiffness where loading has set the joint moving, at the largest force, and where unloading has; the secant.
fn stiffness(curve: &Curve) -> Finding {
    let most = curve.max_force;
    let [first, last] = ends(curve);
    let (begun, returned) = (begun(curve), (most - 2.0 * curve.friction - BEGUN * most).max(0.0));
    let back = curve.tangent(returned, Branch::Unload).map(shown);
    let displacement = curve.displacement(most, Branch::Load);
    let secant = (displacement > 0.0).then(|| shown(most / displacement));
    let told = |value: Option<f64>| value.map_or("none, it is held".to_string(), |v| format!("{v:.2} N/um"));
    Finding {
        key: "stiffness",
        label: "stiffness dF/dy",
        text: format!(
            "{} at {begun:.1} N, {} at {most:.1} N, {} going back at {returned:.1} N; F/y = {}",
            told(first),
            told(last),
            told(back),
            told(secant)
        ),
        json: json!({
            "first": first, "first_at": begun, "last": last, "last_at": most, "back": back, "back_at": returned,
            "secant": secant, "unit": "N/um", "force_unit": "N",
        }),
    }
}

fn friction(curve: &Curve) -> Finding {
    let f = curve.friction;
    let text = match f {
        0.0 => "none".into(),
        f => format!(
            "{f:.1} N: held up to {f:.1} N, and from {:.1} N down to {:.1} N",
            curve.max_force,
            (curve.max_force - 2.0 * f).max(0.0)
        ),
    };
    Finding { key: "friction", label: "friction", text, json: json!({ "force": f, "unit": "N" }) }
}

fn after(down: &[f64]) -> Finding {
    let left = um(down[down.len() - 1]);
    Finding {
        key: "left",
        label: "left without force",
        text: format!("{left:+.3} um after unloading"),
        json: json!({ "value": left, "unit": "um" }),
    }
}

fn area(curve: &Curve) -> Finding {
    let (area, work) = (1e6 * curve.loop_area(), 1e6 * curve.work_of_loading());
    let share = if work > 0.0 { area / work } else { 0.0 };
    Finding {
        key: "loop",
        label: "work of friction",
        text: format!("{area:.1} uJ between the branches, {:.1} % of the {work:.1} uJ put in", 100.0 * share),
        json: json!({ "area": area, "work": work, "unit": "uJ", "share": share }),
    }
}

/// The joint as it is beside the same joint without its preload, or with one of half the largest force, which no load relaxes.
fn with_and_without_preload(joint: &Pushed) -> Finding {
    let curve = &joint.curve;
    let most = curve.max_force;
    let preload = if curve.preload > 0.0 { curve.preload } else { 0.5 * most };
    let of = |preload: f64| {
        let curve = curve.preloaded(preload);
        (um(curve.displacement(most, Branch::Load)), ends(&curve))
    };
    let (without, with, begun) = (of(0.0), of(preload), begun(curve));
    let line = |(y, [first, last]): &(f64, [Option<f64>; 2])| {
        let told = |value: &Option<f64>| value.map_or("held".to_string(), |v| format!("{v:.1}"));
        format!("{y:.3} um at {most:.1} N, from {} N/um at {begun:.1} N to {}", told(first), told(last))
    };
    let would = if curve.preload > 0.0 { "" } else { ", which it does not have" };
    let entry =
        |(y, [first, last]): &(f64, [Option<f64>; 2])| json!({ "displacement": y, "first": first, "last": last });
    Finding {
        key: "preload",
        label: "without preload",
        text: format!(
            "{}\n  {:<24} {}{would}; both springs resist up to {:.1} N",
            line(&without),
            format!("with {preload:.1} N"),
            line(&with),
            2.0 * preload + curve.friction
        ),
        json: json!({
            "force": preload, "force_unit": "N", "present": curve.preload > 0.0,
            "without": entry(&without), "with": entry(&with), "unit": "um", "stiffness_unit": "N/um",
        }),
    }
}

fn plots(forces: &[f64], up: &[f64], down: &[f64]) -> Vec<Plot> {
    let plot = |title: &str, values: Vec<f64>| Plot {
        title: title.into(),
        x_unit: "N",
        points: forces.iter().copied().zip(values.into_iter().map(um)).collect(),
    };
    let back: Vec<f64> = down.iter().rev().copied().collect();
    let mut plots = vec![plot("displacement [um] over force [N], loading", up.to_vec())];
    if up.iter().zip(&back).any(|(a, b)| (a - b).abs() > 1e-12) {
        let width = up.iter().zip(&back).map(|(a, b)| b - a).collect();
        plots.push(plot("displacement [um] over force [N], unloading", back));
        plots.push(plot("width of the loop [um] over force [N]", width));
    }
    plots
}

fn warnings(curve: &Curve) -> Vec<String> {
    let (most, f) = (curve.max_force, curve.friction);
    let mut warnings = Vec::new();
    if f >= most {
        warnings.push(format!("friction of {f:.1} N holds the joint still: the test ends at {most:.1} N"));
    } else if 2.0 * f > most {
        warnings.push("friction holds the joint while all of the force is taken away: it does not come back".into());
    }
    if curve.gap > 0.0 && curve.preload > 0.0 {
        warnings.push("the model has a gap and a preload, which add up; a real preload takes the clearance up".into());
    }
    warnings
}
