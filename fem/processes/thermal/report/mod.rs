//! The report of a run: figures, the profile, plots, and the body in space.

mod bodies;
mod discretisation;
pub mod ground;
mod scene;

use self::discretisation::Left;
use self::scene::Scene;
use super::body::Body;
use super::boundary::Condition;
use super::machine::Machine;
use super::recording::Hottest;
use super::rows::{COORDINATES, DIAMETER, ELONGATION, OBSERVABLES, TEMPERATURE_OF_ROW, TIME_OF_ROW, X, Y, own};
use super::setup::Setup;
use super::surroundings::Surroundings;
use crate::process::{Column, Failure, Figure, Forward, Plot, Rows, RunReport, Table, first_extreme};
use crate::solve::conduction::Energy;
use crate::units::{ENERGY, HEAT, LENGTH, MICRO, SECONDS, TEMPERATURE, TEMPERATURE_RISE, TIME};

/// 1 − 1/e: part that a first-order body has reached after its time constant.
const REACHED: f64 = 1.0 - 1.0 / std::f64::consts::E;
/// Above this Biot number a section is not at one temperature, and a rod no longer one-dimensional
/// (Incropera, lumped capacitance).
const LARGEST_BIOT: f64 = 0.1;

/// Everything that a run reports.
///
/// # Errors
/// The body cannot be computed.
pub fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
    let (setup, rows, observed) = (&machine.setup, forward.programme, forward.prediction);
    let scene = Scene::new(machine, forward)?;
    let left = Left::by_elements_and_steps(machine, forward, scene.longest_step())?;
    let mut figures = Vec::new();
    figures.extend(scene.elongation.iter().flat_map(|values| growth(scene.times(), values)));
    figures.extend(diameters(setup, &scene));
    figures.extend(hottest(setup, &scene));
    figures.extend(bow(&scene));
    figures.extend(ground::figure(&setup.body, &setup.boundaries, &scene));
    figures.push(energy(scene.energy()));
    figures.push(steps(setup, &scene));
    figures.push(left.figure());
    let mut warnings = warnings(machine, &scene);
    warnings.extend(left.warning(setup, rows, observed));
    Ok(RunReport {
        profile: profile(setup, rows, observed),
        figures,
        plots: plots(rows, observed),
        warnings,
        animations: vec![scene.animation()],
        ..RunReport::default()
    })
}

/// A measurement file of its own: a record observes the elongation, a temperature or a diameter, other cells are empty.
fn profile(setup: &Setup, rows: &Rows, observed: &[f64]) -> Table {
    let coordinates = [TIME_OF_ROW, X].into_iter().chain(setup.body.plane().map(|_| Y));
    let mut columns: Vec<Column> = coordinates.map(|i| Column::coordinate(&COORDINATES[i], &rows.columns[i])).collect();
    let grows = [ELONGATION, DIAMETER].into_iter().filter(|observable| rows.observable.contains(observable));
    columns.extend([TEMPERATURE_OF_ROW].into_iter().chain(grows).map(|observable| {
        let mut values = vec![f64::NAN; rows.len()];
        own(rows, observable).for_each(|row| values[row] = observed[row]);
        Column::quantities(OBSERVABLES[observable].name.clone(), OBSERVABLES[observable].kind, &values)
    }));
    Table { columns }
}

/// Largest growth at the end of a step, and the time at which 63 % of it were reached.
fn growth(times: &[f64], values: &[f64]) -> Vec<Figure> {
    // A formula may give no number at the start.
    let finite = times.iter().zip(values).filter(|(_, value)| value.is_finite());
    let (times, values): (Vec<f64>, Vec<f64>) = finite.unzip();
    let most = first_extreme(&values, f64::gt);
    let Some(&end) = values.last() else { return Vec::new() };
    let value = values[most];
    let [shown, at_end] = [value, end].map(|growth| MICRO.shown(growth));
    let mut figures = vec![
        Figure::new("largest", "largest elongation")
            .line(format!("{shown:+.3} after {:.1}; {at_end:+.3} in the end", TIME.shown(times[most])))
            .quantity("value", MICRO, value)
            .quantity("at", TIME, times[most])
            .quantity("end", MICRO, end),
    ];
    // Between two steps as on a straight line.
    let share = REACHED * value;
    let passed = (1..=most).find(|i| values[*i] >= share);
    if let (true, Some(i)) = (share > 0.0, passed) {
        let part = (share - values[i - 1]) / (values[i] - values[i - 1]);
        let after = times[i - 1] + part * (times[i] - times[i - 1]);
        let text = format!("reached after {:.1}", TIME.shown(after));
        figures.push(Figure::new("reached", "63 % of it").line(text).quantity("value", TIME, after));
    }
    figures
}

/// Outside and in the bore the change of each diameter that is largest, when, and what is left in the end; the numbers
/// are those of the diameter that changes most.
fn diameters(setup: &Setup, scene: &Scene) -> Vec<Figure> {
    let is_bore = |[x, radius]: [f64; 2]| setup.body.plane().is_some_and(|plane| radius < plane.usual_y(x));
    let figure = |(key, label, inside): (&'static str, &'static str, bool)| {
        let mut most: Option<([f64; 2], f64, f64, f64)> = None;
        let mut lines = Vec::new();
        for (circle, values) in scene.diameters.iter().filter(|(circle, _)| is_bore(*circle) == inside) {
            let sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
            let place = first_extreme(&sizes, f64::gt);
            let (value, at, end) = (*values.get(place)?, scene.times()[place], *values.last()?);
            let [shown, at_end] = [value, end].map(|change| MICRO.shown(change));
            let (x, after) = (LENGTH.shown(circle[0]), TIME.shown(at));
            lines.push(format!("{shown:+.3} at x = {x:.1} after {after:.1}; {at_end:+.3} in the end"));
            if most.is_none_or(|(_, known, ..)| value.abs() > known.abs()) {
                most = Some((*circle, value, at, end));
            }
        }
        let ([x, radius], value, at, end) = most?;
        let figure = lines.into_iter().fold(Figure::new(key, label), Figure::line);
        let figure = figure.quantity("value", MICRO, value).quantity("at", TIME, at).quantity("end", MICRO, end);
        Some(figure.quantity("x", LENGTH, x).quantity("diameter", LENGTH, 2.0 * radius))
    };
    let both = [("diameter", "change of diameter", false), ("bore", "change of bore", true)];
    both.into_iter().filter_map(figure).collect()
}

/// The hottest of all nodes at all steps.
fn hottest(setup: &Setup, scene: &Scene) -> Option<Figure> {
    let ([x, y], Hottest { rise, time, .. }) = scene.hottest?;
    let temperature = setup.start + rise;
    let height = if y.is_nan() { String::new() } else { format!(", y = {:.1}", LENGTH.shown(y)) };
    let (shown, after) = (TEMPERATURE.shown(temperature), TIME.shown(time));
    Some(
        Figure::new("hottest", "hottest")
            .line(format!("{shown:.2} at x = {:.1}{height}, after {after:.1}", LENGTH.shown(x)))
            .quantity("value", TEMPERATURE, temperature)
            .quantity("x", LENGTH, x)
            .quantity("y", LENGTH, y)
            .quantity("at", TIME, time),
    )
}

fn bow(scene: &Scene) -> Option<Figure> {
    let values = scene.bow.as_ref()?;
    let sizes: Vec<f64> = values.iter().map(|v| v.abs()).collect();
    let most = first_extreme(&sizes, f64::gt);
    let (value, at, end) = (values[most], scene.times()[most], values[values.len() - 1]);
    let [shown, at_end] = [value, end].map(|bow| MICRO.shown(bow));
    Some(
        Figure::new("bow", "bow, middle over ends")
            .line(format!("{shown:+.3} at most, after {:.1}; {at_end:+.3} in the end", TIME.shown(at)))
            .quantity("largest", MICRO, value)
            .quantity("at", TIME, at)
            .quantity("end", MICRO, end),
    )
}

fn energy(energy: &Energy) -> Figure {
    let held = match energy.prescribed == 0.0 {
        true => String::new(),
        false => format!(", {:.3} where the temperature is held", HEAT.shown(energy.prescribed)),
    };
    let [supplied, lost, stored] = [energy.supplied, energy.convected, energy.stored].map(|heat| HEAT.shown(heat));
    let balance = energy.imbalance();
    Figure::new("energy", "heat")
        .line(format!("{supplied:.3} in{held}, {lost:.3} lost, {stored:.3} stored; balance to {:.0e}", balance.abs()))
        .quantity("supplied", ENERGY, energy.supplied)
        .quantity("prescribed", ENERGY, energy.prescribed)
        .quantity("lost", ENERGY, energy.convected)
        .quantity("stored", ENERGY, energy.stored)
        .entry("imbalance", balance)
}

fn steps(setup: &Setup, scene: &Scene) -> Figure {
    let (count, longest, scheme) = (scene.times().len() - 1, scene.longest_step(), setup.time.scheme_name());
    let how = match setup.time.step {
        Some(_) => "given".to_string(),
        None => format!("chosen for {}", TEMPERATURE_RISE.format(setup.time.tolerance)),
    };
    Figure::new("steps", "time steps")
        .line(format!("{count} of {scheme}, up to {:.3} ({how})", SECONDS.shown(longest)))
        .entry("count", count)
        .quantity("longest", SECONDS, longest)
        .entry("scheme", scheme)
}

fn plots(rows: &Rows, observed: &[f64]) -> Vec<Plot> {
    let plot = |title: String, observable: usize, is_shown: &dyn Fn(&usize) -> bool| {
        let kind = OBSERVABLES[observable].kind;
        let point = |row: usize| (TIME.from_si(rows.columns[TIME_OF_ROW][row]), kind.from_si(observed[row]));
        let points = own(rows, observable).filter(is_shown).map(point).collect();
        Plot { title, x_unit: &TIME.unit, points }
    };
    let mut plots = Vec::new();
    if rows.observable.contains(&ELONGATION) {
        plots.push(plot("elongation [um] over time [min]".into(), ELONGATION, &|_| true));
    }
    // Of each circle a plot of its own.
    let mut circles: Vec<[f64; 2]> =
        own(rows, DIAMETER).map(|row| [rows.columns[X][row], rows.columns[Y][row]]).collect();
    circles.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    circles.dedup();
    for [x, y] in circles {
        let title = format!(
            "diameter {:.1} at x = {:.1}, its change [um] over time [min]",
            LENGTH.shown(2.0 * y),
            LENGTH.shown(x)
        );
        plots.push(plot(title, DIAMETER, &|row| [rows.columns[X][*row], rows.columns[Y][*row]] == [x, y]));
    }
    let warm: Vec<usize> = own(rows, TEMPERATURE_OF_ROW).collect();
    let temperatures: Vec<f64> = warm.iter().map(|row| observed[*row]).collect();
    if let Some(hottest) = warm.get(first_extreme(&temperatures, f64::gt)) {
        let x = rows.columns[X][*hottest];
        let title = format!("temperature [degC] at x = {:.1} over time [min]", LENGTH.shown(x));
        plots.push(plot(title, TEMPERATURE_OF_ROW, &|row| rows.columns[X][*row] == x));
    }
    plots
}

fn warnings(machine: &Machine, scene: &Scene) -> Vec<String> {
    let setup = &machine.setup;
    let mut warnings = Vec::new();
    if let Body::Rod(segments) = &setup.body {
        let thickest = segments.iter().fold(0.0f64, |m, s| m.max(s.section.diameter));
        let biot = machine.convection * thickest / (4.0 * setup.material.conductivity);
        if biot > LARGEST_BIOT {
            warnings.push(format!(
                "the Biot number is {biot:.2}: the rod is colder at its surface than inside, which one dimension does \
                 not show"
            ));
        }
    }
    if !machine.is_open() {
        if !machine.drifts.is_empty() {
            warnings.push("nothing loses heat to the surroundings: their drift is not felt".into());
        }
        if setup.is_out_of_balance() {
            warnings.push("nothing loses heat to the surroundings: their temperature is not felt".into());
        }
    }
    let is_felt = |s: &Surroundings| s.coefficient.unwrap_or(machine.convection) > 0.0;
    if machine.is_open() && !setup.sections.iter().all(is_felt) {
        warnings.push(
            "an [[environment.section]] without a film has no effect: give it a coefficient, or the body its `convection`"
                .into(),
        );
    }
    for boundary in &setup.boundaries {
        let Condition::Moving { speed, width, .. } = boundary.condition else { continue };
        let part = (speed * scene.longest_step()).abs() / width;
        if part > 0.5 {
            warnings.push(format!(
                "the strip on `{}` moves {part:.2} of its width in a step: take steps below {:.3}",
                boundary.edge,
                SECONDS.shown(0.5 * width / speed.abs())
            ));
        }
    }
    warnings
}
