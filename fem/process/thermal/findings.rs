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
/// Errors above this part of the largest rise are warned of.
const COARSE: f64 = 0.01;
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
    findings.extend(scene.elongation.iter().flat_map(|values| growth(&scene.times, values)));
    findings.extend(hottest(setup, scene));
    findings.extend(bow(scene));
    findings.push(energy(&scene.energy));
    findings.push(steps(setup, scene));
    let left = left_by_elements(heated, scene, &rows, &observed)?;
    findings.push(Finding {
        key: "discretisation",
        label: "elements and steps",
        text: format!("leave some {:.1e} K, by what twice as long ones change", left),
        json: json!({ "error": left, "unit": "K" }),
    });
    let mut warnings = warnings(heated, scene);
    let warmest = warm.iter().map(|row| (observed[*row] - setup.ambient).abs()).fold(0.0, f64::max);
    if left > setup.time.tolerance.max(COARSE * warmest) {
        warnings.push(format!(
            "elements and steps leave errors of some {left:.2} K: take a smaller element_size in [mesh], and shorter steps"
        ));
    }
    Ok(Outcome {
        profile: profile(setup, &rows, &observed),
        findings,
        plots: plots(&rows, &observed, &growing, &warm),
        drawings: Vec::new(),
        tables: Vec::new(),
        warnings,
        animation: None,
    })
}

/// The error that elements and steps leave in the temperatures of the programme, K: what twice as long ones change, less what their own order leaves.
fn left_by_elements(heated: &Heated, scene: &Scene, rows: &Rows, observed: &[f64]) -> Result<f64, Failure> {
    let setup = heated.setup();
    let coarse = observe::observe(&heated.coarser(2.0 * scene.longest_step()), rows)?;
    let temperatures = (0..rows.len()).filter(|r| rows.observable[*r] == TEMPERATURE_OF_ROW);
    let apart = temperatures.map(|r| (observed[r] - coarse[r]).abs()).fold(0.0, f64::max);
    Ok(apart / f64::from((1 << setup.time.order()) - 1))
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

/// The position of the largest value, the first of those that are equal but for rounding.
fn greatest(values: &[f64]) -> usize {
    let size = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let better = |best: usize, i: usize| if values[i] > values[best] + 1e-9 * size { i } else { best };
    (0..values.len()).reduce(better).unwrap_or(0)
}

/// Of the growth at the end of every step.
fn growth(times: &[f64], values: &[f64]) -> Vec<Finding> {
    let minutes = |i: usize| times[i] / 60.0;
    let most = greatest(values);
    let (value, end) = (1e6 * values[most], 1e6 * values[values.len() - 1]);
    let mut findings = vec![Finding {
        key: "largest",
        label: "largest elongation",
        text: format!("{value:+.3} um after {:.1} min; {end:+.3} um in the end", minutes(most)),
        json: json!({ "value": value, "unit": "um", "at": minutes(most), "at_unit": "min", "end": end }),
    }];
    // Between two steps as on a straight line.
    let share = REACHED * values[most];
    let passed = (1..=most).find(|i| values[*i] >= share);
    if let (true, Some(i)) = (share > 0.0, passed) {
        let part = (share - values[i - 1]) / (values[i] - values[i - 1]);
        let after = minutes(i - 1) + part * (minutes(i) - minutes(i - 1));
        findings.push(Finding {
            key: "reached",
            label: "63 % of it",
            text: format!("reached after {after:.1} min"),
            json: json!({ "value": after, "unit": "min" }),
        });
    }
    findings
}

/// Of all nodes at all steps.
fn hottest(setup: &Setup, scene: &Scene) -> Option<Finding> {
    let (place, temperature, time) = scene.hottest?;
    let (value, after, [x, y]) = (TEMPERATURE.from_si(temperature), time / 60.0, place.map(|p| 1e3 * p));
    let plane = matches!(setup.body, Body::Plane(_));
    let height = if plane { format!(", y = {y:.1} mm") } else { String::new() };
    Some(Finding {
        key: "hottest",
        label: "hottest",
        text: format!("{value:.2} degC at x = {x:.1} mm{height}, after {after:.1} min"),
        json: json!({
            "value": value, "unit": "degC", "x": x, "y": plane.then_some(y), "x_unit": "mm", "at": after, "at_unit": "min",
        }),
    })
}

fn bow(scene: &Scene) -> Option<Finding> {
    let values = scene.bow.as_ref()?;
    let sizes: Vec<f64> = values.iter().map(|v| v.abs()).collect();
    let most = greatest(&sizes);
    let (after, value, end) = (scene.times[most] / 60.0, 1e6 * values[most], 1e6 * values[values.len() - 1]);
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
    let (count, longest) = (scene.times.len() - 1, scene.longest_step());
    let how =
        if setup.time.step.is_some() { "given".to_string() } else { format!("chosen for {} K", setup.time.tolerance) };
    Finding {
        key: "steps",
        label: "time steps",
        text: format!("{count} of {scheme}, up to {longest:.3} s ({how})"),
        json: json!({ "count": count, "longest": longest, "unit": "s", "scheme": scheme }),
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
    let temperatures: Vec<f64> = warm.iter().map(|row| observed[*row]).collect();
    let Some(hottest) = warm.get(greatest(&temperatures)) else { return plots };
    let x = rows.columns[X][*hottest];
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
            && (speed * scene.longest_step()).abs() > 0.5 * width
        {
            warnings.push(format!(
                "the strip on `{}` moves {:.2} of its width in a step: take steps below {:.3} s",
                boundary.edge,
                (speed * scene.longest_step()).abs() / width,
                0.5 * width / speed.abs()
            ));
        }
    }
    warnings
}
