//! The report of a run: figures, the profile, and shapes for people.

mod bodies;
mod compliance;
mod conic;
mod edge;
mod events;
mod form;
pub mod roundness;
mod shapes;
mod sketch;
mod structure;

use self::compliance::Compliance;
use self::roundness::Roundness;
use super::elastic::{Deflection, condense};
use super::forward::deflections;
use super::lift_off::LiftOff;
use super::machine::Machine;
use super::refinement::Refinement;
use super::rows::{COORDINATES, OBSERVABLES, PART, PATH_OF_ROW, TIME_OF_ROW, X};
use super::setup::Setup;
use crate::process::{Column, Datum, Failure, Figure, Forward, Plot, Rows, RunReport, Table, first_extreme, range};
use crate::progress::Progress;
use crate::units::{FORCE, LENGTH, MICRO, PATH, TIME};

/// Everything that a run reports.
///
/// # Errors
/// The equilibrium of some position cannot be computed.
pub fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
    let (setup, rows, errors) = (&machine.setup, forward.programme, forward.prediction);
    let positions = &setup.sweep();
    let shaft = condense(machine, positions)?;
    let deflections = &deflections(machine, &shaft, positions, &Progress::default())?;
    let first = &errors[..positions.len()];
    let mut figures = vec![
        extreme(setup, rows, errors, ("largest", "largest diameter error"), f64::gt),
        extreme(setup, rows, errors, ("smallest", "smallest diameter error"), f64::lt),
        form::taper(positions, first),
        form::form(positions, first),
    ];
    figures.extend(conic::figure(machine));
    figures.extend(batch(setup, &part_means(positions.len(), errors)));
    let roundness = Roundness::of(machine, positions)?;
    figures.push(forces(deflections, roundness.as_ref()));
    let compliance = Compliance::of(machine, &shaft, deflections);
    figures.extend(compliance.as_ref().and_then(|c| c.figure(positions)));
    let shares = structure::shares(machine, &shaft, positions, deflections);
    figures.extend(shares.as_ref().and_then(|shares| structure::figure(shares, positions)));
    figures.extend(setup.imported.as_ref().and_then(|own| own.figure(positions)));
    figures.push(schedule(setup));
    let (worn, nearly_worn) = edge::figure(machine).unzip();
    figures.extend(worn);
    let refinement = Refinement::of(machine, positions)?;
    figures.extend(refinement.iter().map(Refinement::figure));
    figures.extend(roundness.iter().map(|r| r.figure(positions)));
    Ok(RunReport {
        profile: profile(setup, rows, errors),
        tables: (refinement.iter().map(|r| ("passes", r.table(positions))))
            .chain(compliance.iter().map(|c| ("compliance", c.table(positions))))
            .chain(shares.iter().map(|shares| ("structure", structure::table(shares, positions))))
            .chain(roundness.iter().map(|r| ("roundness", r.table(positions))))
            .collect(),
        figures,
        plots: plots(positions, errors),
        warnings: [
            warnings(machine, positions, deflections)?,
            roundness.iter().filter_map(Roundness::warning).collect(),
            nearly_worn.flatten().into_iter().collect(),
        ]
        .concat(),
        sketch: Some(sketch::sketch(machine, positions, deflections)?),
        animations: vec![shapes::animation(machine, forward)?],
        ..RunReport::default()
    })
}

fn profile(setup: &Setup, rows: &Rows, errors: &[f64]) -> Table {
    let shown = (COORDINATES, &[PART, X, TIME_OF_ROW, PATH_OF_ROW][..]);
    let mut table = Table::of_rows(shown, rows, &OBSERVABLES[0], errors);
    let finished: Vec<f64> = rows.columns[X].iter().zip(errors).map(|(x, e)| setup.diameter(*x) + e).collect();
    table.columns.push(Column::quantities("finished_diameter", LENGTH, &finished));
    table
}

fn extreme(
    setup: &Setup,
    rows: &Rows,
    errors: &[f64],
    (key, label): (&'static str, &'static str),
    beats: fn(&f64, &f64) -> bool,
) -> Figure {
    let row = first_extreme(errors, beats);
    let (error, x, part) = (errors[row], rows.columns[X][row], rows.columns[PART][row] as usize);
    let on = if setup.schedule.parts > 1 { format!(" on part {part}") } else { String::new() };
    Figure::new(key, label).quantity("value", MICRO, error).quantity("x", LENGTH, x).entry("part", part).line(format!(
        "{:+.3} at x = {:.1}{on}",
        MICRO.shown(error),
        LENGTH.shown(x)
    ))
}

fn batch(setup: &Setup, means: &[f64]) -> Option<Figure> {
    let (first, last) = (MICRO.shown(*means.first()?), MICRO.shown(*means.last()?));
    let figure = Figure::new("batch", "over the batch")
        .line(format!("mean error {first:+.3} on part 1, {last:+.3} on part {}", means.len()))
        .entry("part_means", Datum::Quantities(MICRO, means.to_vec()));
    (setup.schedule.parts > 1).then_some(figure)
}

fn part_means(per_part: usize, errors: &[f64]) -> Vec<f64> {
    errors.chunks(per_part).map(|part| part.iter().sum::<f64>() / part.len() as f64).collect()
}

/// All around the part, where it is not round.
fn forces(deflections: &[Deflection], roundness: Option<&Roundness>) -> Figure {
    let mean = || range(deflections.iter().map(|d| d.force));
    let (low, high) = roundness.map_or_else(mean, Roundness::force_range);
    let shown = FORCE.shown(high);
    let line = match high - low < 1e-9 * high {
        true => format!("{shown:.1}"),
        false => format!("{:.1} to {shown:.1} along the pass", FORCE.from_si(low)),
    };
    let figure = Figure::new("radial_force", "radial force").line(line);
    figure.quantity("smallest", FORCE, low).quantity("largest", FORCE, high)
}

fn schedule(setup: &Setup) -> Figure {
    let schedule = &setup.schedule;
    let (parts, pass) = (schedule.parts, schedule.pass);
    let (cut, end, path) = (pass.duration(), schedule.time(parts, pass.to), schedule.path(parts, pass.to));
    let [cut_shown, end_shown] = [cut, end].map(|time| TIME.shown(time));
    let figure = Figure::new("schedule", "schedule")
        .unit("time_unit", TIME)
        .unit("path_unit", PATH)
        .line(format!(
            "{parts} part(s), {cut_shown:.3} of cutting each, done after {end_shown:.2} and {:.1} of cutting path",
            PATH.shown(path)
        ))
        .entry("parts", parts)
        .quantity("cutting_time", TIME, cut)
        .quantity("end", TIME, end)
        .quantity("path", PATH, path);
    events::told(&schedule.events, figure)
}

fn plots(positions: &[f64], errors: &[f64]) -> Vec<Plot> {
    let of_x = |(number, errors): (usize, &[f64])| Plot {
        title: format!("diameter error [um] over x [mm], part {number}"),
        x_unit: &LENGTH.unit,
        points: positions.iter().zip(errors).map(|(x, e)| (LENGTH.from_si(*x), MICRO.from_si(*e))).collect(),
    };
    let parts: Vec<(usize, &[f64])> = (1..).zip(errors.chunks(positions.len())).collect();
    let mut plots = vec![of_x(parts[0])];
    if let [_, .., last] = parts[..] {
        let means = part_means(positions.len(), errors);
        let points = (1..).zip(&means).map(|(part, m)| (f64::from(part), MICRO.from_si(*m))).collect();
        plots.push(of_x(last));
        plots.push(Plot { title: "mean diameter error [um] over parts".into(), x_unit: "part", points });
    }
    plots
}

fn warnings(machine: &Machine, positions: &[f64], deflections: &[Deflection]) -> Result<Vec<String>, Failure> {
    let setup = &machine.setup;
    let mut warnings = LiftOff::of(machine, positions, deflections)?.warnings("positions");
    let is_told = !setup.passes.is_empty() || !setup.blank.is_true();
    if is_told && !machine.feeds_back() {
        warnings.push(
            "without the effect `force-feedback` nothing is copied: blank and earlier passes change nothing".into(),
        );
    }
    let deepest = deflections.iter().map(|d| d.total).fold(0.0, f64::max);
    if deepest > setup.cut.depth {
        warnings.push(format!(
            "the gap of {:.1} is larger than the depth of cut of {:.1}: the tool would leave the work; the effect \
             `force-feedback` lets the force fall with the depth",
            MICRO.shown(deepest),
            MICRO.shown(setup.cut.depth)
        ));
    }
    Ok(warnings)
}
