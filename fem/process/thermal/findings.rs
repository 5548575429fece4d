//! What a run of a heated body finds, in numbers and in words.

use serde_json::json;

use super::body::Body;
use super::job::Heated;
use super::model::{Condition, Setup};
use super::observe::{self, ELONGATION, TEMPERATURE_OF_ROW, TIME_OF_ROW, X, Y};
use super::shapes::Scene;
use crate::process::{Column, Failure, Finding, Outcome, Plot, Rows, Table};
use crate::solve::conduction::{Energy, Scheme};
use crate::units::TEMPERATURE;

/// 1 − 1/e, what a first-order body has reached after its time constant.
const REACHED: f64 = 1.0 - 1.0 / std::f64::consts::E;
/// Above this Biot number a section is not at one temperature, and a rod no longer one-dimensional (Incropera, lumped capacitance).
const LARGEST_BIOT: f64 = 0.1;

/// Everything but the animation.
///
/// # Errors
/// The body cannot be computed.
pub fn outcome(heated: &Heated, scene: &Scene, observed: Vec<f64>) -> Result<Outcome, Failure> {
    let setup = heated.setup();
    let rows = observe::programme(setup);
    let mut findings = Vec::new();
    let of = |observable: usize| (0..rows.len()).filter(|r| rows.observable[*r] == observable).collect::<Vec<usize>>();
    let (growing, warm) = (of(ELONGATION), of(TEMPERATURE_OF_ROW));
    if !growing.is_empty() {
        findings.extend(growth(&rows, &observed, &growing));
    }
    findings.push(hottest(&rows, &observed, &warm));
    findings.extend(bow(scene));
    findings.push(energy(&scene.energy));
    findings.push(steps(setup, scene));
    Ok(Outcome {
        profile: profile(setup, &rows, &observed),
        findings,
        plots: plots(&rows, &observed, &growing, &warm),
        drawings: Vec::new(),
        tables: Vec::new(),
        warnings: warnings(heated, scene),
        animation: None,
    })
}

/// A measurement file of its own: a record observes the elongation or a temperature, and the other cell is empty.
fn profile(setup: &Setup, rows: &Rows, observed: &[f64]) -> Table {
    let of = |observable: usize, shown: &dyn Fn(f64) -> f64| {
        let cell = |(value, own): (&f64, &usize)| if *own == observable { shown(*value) } else { f64::NAN };
        observed.iter().zip(&rows.observable).map(cell).collect::<Vec<f64>>()
    };
    let coordinate = |column: usize, factor: f64| rows.columns[column].iter().map(|v| factor * v).collect::<Vec<f64>>();
    let mut columns = vec![
        Column::numbers("time", Some("min"), coordinate(TIME_OF_ROW, 1.0 / 60.0)),
        Column::numbers("x", Some("mm"), coordinate(X, 1e3)),
    ];
    if matches!(setup.body, Body::Plane(_)) {
        columns.push(Column::numbers("y", Some("mm"), coordinate(Y, 1e3)));
    }
    columns.push(Column::numbers("temperature", Some("degC"), of(TEMPERATURE_OF_ROW, &|v| TEMPERATURE.from_si(v))));
    if rows.observable.contains(&ELONGATION) {
        columns.push(Column::numbers("elongation", Some("um"), of(ELONGATION, &|v| 1e6 * v)));
    }
    Table { columns }
}

/// The row with the largest value, the first of those that are equal but for rounding.
fn largest(observed: &[f64], rows: &[usize]) -> usize {
    let size = rows.iter().fold(0.0f64, |m, r| m.max(observed[*r].abs()));
    let better = |best: usize, row: usize| if observed[row] > observed[best] + 1e-9 * size { row } else { best };
    rows.iter().copied().reduce(better).unwrap_or(0)
}

fn growth(rows: &Rows, observed: &[f64], growing: &[usize]) -> Vec<Finding> {
    let minutes = |row: usize| rows.columns[TIME_OF_ROW][row] / 60.0;
    let (most, last) = (largest(observed, growing), growing[growing.len() - 1]);
    let (value, end) = (1e6 * observed[most], 1e6 * observed[last]);
    let mut findings = vec![Finding {
        key: "largest",
        label: "largest elongation",
        text: format!("{value:+.3} um after {:.1} min; {end:+.3} um in the end", minutes(most)),
        json: json!({ "value": value, "unit": "um", "at": minutes(most), "at_unit": "min", "end": end }),
    }];
    // Between two times of the programme as on a straight line.
    let share = REACHED * observed[most];
    let passed = growing.windows(2).find(|w| observed[w[1]] >= share && w[1] <= most);
    if let (true, Some(w)) = (observed[most] > 0.0, passed) {
        let part = (share - observed[w[0]]) / (observed[w[1]] - observed[w[0]]);
        let after = minutes(w[0]) + part * (minutes(w[1]) - minutes(w[0]));
        findings.push(Finding {
            key: "reached",
            label: "63 % of it",
            text: format!("reached after {after:.1} min"),
            json: json!({ "value": after, "unit": "min" }),
        });
    }
    findings
}

fn hottest(rows: &Rows, observed: &[f64], warm: &[usize]) -> Finding {
    let most = largest(observed, warm);
    let (value, x) = (TEMPERATURE.from_si(observed[most]), 1e3 * rows.columns[X][most]);
    let after = rows.columns[TIME_OF_ROW][most] / 60.0;
    Finding {
        key: "hottest",
        label: "hottest",
        text: format!("{value:.2} degC at x = {x:.1} mm, after {after:.1} min"),
        json: json!({ "value": value, "unit": "degC", "x": x, "x_unit": "mm", "at": after, "at_unit": "min" }),
    }
}

fn bow(scene: &Scene) -> Option<Finding> {
    let values = scene.bow.as_ref()?;
    let most = (0..values.len()).max_by(|a, b| values[*a].1.abs().total_cmp(&values[*b].1.abs()))?;
    let (after, value) = (values[most].0 / 60.0, 1e6 * values[most].1);
    let end = 1e6 * values[values.len() - 1].1;
    Some(Finding {
        key: "bow",
        label: "bow, middle over ends",
        text: format!("{value:+.3} um at most, after {after:.1} min; {end:+.3} um in the end"),
        json: json!({ "largest": value, "at": after, "end": end, "unit": "um", "at_unit": "min" }),
    })
}

fn energy(energy: &Energy) -> Finding {
    let kj = |joules: f64| 1e-3 * joules;
    let held = if energy.prescribed == 0.0 {
        String::new()
    } else {
        format!(", {:.3} kJ where the temperature is held", kj(energy.prescribed))
    };
    Finding {
        key: "energy",
        label: "heat",
        text: format!(
            "{:.3} kJ in{held}, {:.3} kJ lost, {:.3} kJ stored; balance to {:.0e}",
            kj(energy.supplied),
            kj(energy.convected),
            kj(energy.stored),
            energy.imbalance().abs()
        ),
        json: json!({
            "supplied": energy.supplied, "prescribed": energy.prescribed, "lost": energy.convected,
            "stored": energy.stored, "unit": "J", "imbalance": energy.imbalance(),
        }),
    }
}

fn steps(setup: &Setup, scene: &Scene) -> Finding {
    let scheme = match setup.time.scheme {
        Scheme::CrankNicolson => "crank-nicolson",
        Scheme::BackwardEuler => "backward-euler",
        Scheme::Sdirk2 => "sdirk2",
    };
    let how =
        if setup.time.step.is_some() { "given".to_string() } else { format!("chosen for {} K", setup.time.tolerance) };
    Finding {
        key: "steps",
        label: "time steps",
        text: format!("{} of {scheme}, up to {:.3} s ({how})", scene.steps, scene.step),
        json: json!({ "count": scene.steps, "longest": scene.step, "unit": "s", "scheme": scheme }),
    }
}

fn plots(rows: &Rows, observed: &[f64], growing: &[usize], warm: &[usize]) -> Vec<Plot> {
    let plot = |title: String, own: &mut dyn Iterator<Item = usize>, shown: &dyn Fn(f64) -> f64| Plot {
        title,
        x_unit: "min",
        points: own.map(|row| (rows.columns[TIME_OF_ROW][row] / 60.0, shown(observed[row]))).collect(),
    };
    let mut plots = Vec::new();
    if !growing.is_empty() {
        plots.push(plot("elongation [um] over time [min]".into(), &mut growing.iter().copied(), &|v| 1e6 * v));
    }
    let x = rows.columns[X][largest(observed, warm)];
    let title = format!("temperature [degC] at x = {:.1} mm over time [min]", 1e3 * x);
    plots.push(plot(title, &mut warm.iter().copied().filter(|row| rows.columns[X][*row] == x), &|v| {
        TEMPERATURE.from_si(v)
    }));
    plots
}

fn warnings(heated: &Heated, scene: &Scene) -> Vec<String> {
    let (setup, machine) = (heated.setup(), &heated.machine);
    let mut warnings = Vec::new();
    if let Body::Rod(segments) = &setup.body {
        let thickest = segments.iter().fold(0.0f64, |m, s| m.max(s.section.diameter));
        let biot = machine.convection * thickest / (4.0 * setup.material.conductivity);
        if biot > LARGEST_BIOT {
            warnings.push(format!(
                "the Biot number is {biot:.2}: the rod is colder at its surface than inside, which one dimension does not show"
            ));
        }
    }
    let loses = machine.convection > 0.0 || machine.base > 0.0;
    let edge_loses = |b: &super::Boundary| matches!(b.condition, Condition::Convection { ambient: None, .. });
    if !machine.drifts.is_empty() && !loses && !setup.boundaries.iter().any(edge_loses) {
        warnings.push("nothing loses heat to the surroundings: their drift is not felt".into());
    }
    for boundary in &setup.boundaries {
        if let Condition::Moving { speed, width, .. } = boundary.condition
            && (speed * scene.step).abs() > 0.5 * width
        {
            warnings.push(format!(
                "the strip on `{}` moves {:.2} of its width in a step: take steps below {:.3} s",
                boundary.edge,
                (speed * scene.step).abs() / width,
                0.5 * width / speed.abs()
            ));
        }
    }
    warnings
}
