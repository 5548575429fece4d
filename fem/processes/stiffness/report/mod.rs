//! The report of a run: displacements as they are predicted, and the mechanics of the joint behind them.

mod largest;
mod structure;

use self::largest::largest;
use super::curve::{Branch, Curve};
use super::forward;
use super::machine::Machine;
use super::rows::{BRANCH, COORDINATES, FORCE_OF_ROW, OBSERVABLES, along, branch};
use super::setup::Loading;
use crate::process::{Column, Datum, Failure, Figure, Forward, Plot, Rows, RunReport, Table};
use crate::units::{FORCE, MICRO, STIFFNESS, WORK};

/// Part of the largest force at which the tangent is told once the joint has begun to move: under no force
/// at all most contacts have none.
const BEGUN: f64 = 0.02;

/// Everything that a run reports.
///
/// # Errors
/// A displacement is not believable.
pub fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
    let (curve, displacements) = (&machine.curve, forward.prediction);
    if let Some(base) = &machine.setup.base {
        return structure::report(machine, base, forward);
    }
    let (up, down) = displacements.split_at(displacements.len() / 2);
    Ok(RunReport {
        profile: profile(forward.programme, displacements),
        tables: vec![("tangent", tangents(machine, forward)?)],
        figures: vec![
            largest(forward),
            stiffness(curve, up[up.len() - 1] - up[0]),
            friction(curve),
            left(curve, up, down),
            work(curve),
            preload(curve, forward),
        ],
        plots: plots(&machine.setup.forces(), up, down),
        warnings: warnings(curve),
        ..RunReport::default()
    })
}

fn profile(rows: &Rows, displacements: &[f64]) -> Table {
    Table::of_rows((COORDINATES, &[FORCE_OF_ROW, BRANCH]), rows, &OBSERVABLES[0], displacements)
}

/// Displacement and tangent stiffness in the middle of every step in which the joint moves, and what they
/// would be without preload.
fn tangents(machine: &Machine, forward: &Forward) -> Result<Table, Failure> {
    let curve = &machine.curve;
    let middles: Vec<f64> = machine.setup.forces().windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
    let [up, down] = [Branch::Load, Branch::Unload].map(|branch| {
        let moving = middles.iter().copied().filter(|f| curve.tangent(*f, branch).is_some());
        moving.collect::<Vec<_>>()
    });
    let rows = along(up, Branch::Load).and(&along(down.into_iter().rev().collect(), Branch::Unload));
    let tangents = |curve: &Curve| -> Vec<f64> {
        let force = &rows.columns[FORCE_OF_ROW];
        (0..rows.len()).map(|row| curve.tangent(force[row], branch(&rows, row)).unwrap_or(0.0)).collect()
    };
    let mut table = profile(&rows, &forward.observe(&rows)?);
    table.columns.push(Column::quantities("tangent_stiffness", STIFFNESS, &tangents(curve)));
    if curve.preload > 0.0 {
        let bare = curve.preloaded(0.0);
        let displacements = observed(&bare, forward, &rows);
        table.columns.push(Column::quantities("displacement_without_preload", MICRO, &displacements));
        table.columns.push(Column::quantities("stiffness_without_preload", STIFFNESS, &tangents(&bare)));
    }
    Ok(table)
}

/// Displacements of another joint in these rows, the effects that are formulas acting on it too, m.
fn observed(curve: &Curve, forward: &Forward, rows: &Rows) -> Vec<f64> {
    let mut displacements = forward::of_joint(curve, rows);
    forward.add_formulas(rows, &mut displacements);
    displacements
}

/// The force at which loading has set the joint moving, N.
fn begun(curve: &Curve) -> f64 {
    (curve.friction + BEGUN * curve.max_force).min(curve.max_force)
}

/// Tangent stiffness where loading has set the joint moving, and at the largest force, N/m.
fn ends(curve: &Curve) -> [Option<f64>; 2] {
    [begun(curve), curve.max_force].map(|force| curve.tangent(force, Branch::Load))
}

/// A stiffness, unknown where friction holds the joint.
fn known(stiffness: Option<f64>) -> Datum {
    Datum::of(STIFFNESS, stiffness.unwrap_or(f64::NAN))
}

/// Tangent stiffness where loading has set the joint moving, at the largest force, and where unloading has;
/// the secant of what is displaced (m) from the least force to the largest. Tangents are mechanics, those of the joint's
/// own curve: a formula effect changes what is seen, not what holds. The secant is a reading.
fn stiffness(curve: &Curve, displaced: f64) -> Figure {
    let most = curve.max_force;
    let [first, last] = ends(curve);
    let (begun, returned) = (begun(curve), (most - 2.0 * curve.friction - BEGUN * most).max(0.0));
    let back = curve.tangent(returned, Branch::Unload);
    let range = if curve.loading == Loading::Reversed { 2.0 * most } else { most };
    let secant = (displaced > 0.0).then(|| range / displaced);
    let told = |value: Option<f64>| {
        value.map_or("none, it is held".to_string(), |stiffness| format!("{:.2}", STIFFNESS.shown(stiffness)))
    };
    let [begun_shown, most_shown, returned_shown] = [begun, most, returned].map(|force| FORCE.shown(force));
    Figure::new("stiffness", "stiffness dF/dy")
        .unit("force_unit", FORCE)
        .entry("first", known(first))
        .quantity("first_at", FORCE, begun)
        .entry("last", known(last))
        .quantity("last_at", FORCE, most)
        .entry("back", known(back))
        .quantity("back_at", FORCE, returned)
        .entry("secant", known(secant))
        .line(format!(
            "{} at {begun_shown:.1}, {} at {most_shown:.1}, {} going back at {returned_shown:.1}; F/y = {}",
            told(first),
            told(last),
            told(back),
            told(secant)
        ))
}

fn friction(curve: &Curve) -> Figure {
    let (f, most) = (curve.friction, curve.max_force);
    let least = if curve.loading == Loading::Reversed { -most } else { 0.0 };
    let text = match f {
        0.0 => "none".into(),
        f => {
            let [f, most, released] = [f, most, (most - 2.0 * f).max(least)].map(|force| FORCE.shown(force));
            match curve.loading {
                Loading::FromZero => format!("{f:.1}: held up to {f:.1}, and from {most:.1} down to {released:.1}"),
                Loading::Reversed => {
                    format!("{f:.1}: held from {most:.1} down to {released:.1}, and on the other side")
                }
            }
        }
    };
    Figure::new("friction", "friction").quantity("force", FORCE, f).line(text)
}

/// Figure of the distance between the two branches under no force, as it would be read; of a force that is reversed
/// without friction with the clearance that lies between its two signs.
fn left(curve: &Curve, up: &[f64], down: &[f64]) -> Figure {
    let (width, label, words) = match curve.loading {
        Loading::FromZero => (down[down.len() - 1] - up[0], "left without force", "after unloading"),
        Loading::Reversed => {
            let middle = up.len() / 2;
            // Friction holds the joint on either flank; without it the joint stands in between.
            let between = if curve.friction > 0.0 { 0.0 } else { curve.clearance() };
            (down[middle] - up[middle] + between, "lost motion", "where the force changes its sign")
        }
    };
    Figure::new("left", label).quantity("value", MICRO, width).line(format!("{:+.3} {words}", MICRO.shown(width)))
}

/// The work that friction and settling take up, of the joint's own curve: mechanics, as an area between readings would
/// not be where a formula effect adds to them.
fn work(curve: &Curve) -> Figure {
    let (area, work) = (curve.loop_area(), curve.work_of_loading());
    let share = if work > 0.0 { area / work } else { 0.0 };
    let [area_shown, work_shown] = [area, work].map(|work| WORK.shown(work));
    let label = if curve.settles > 0.0 { "work of friction and settling" } else { "work of friction" };
    Figure::new("loop", label)
        .quantity("area", WORK, area)
        .quantity("work", WORK, work)
        .entry("share", share)
        .line(format!("{area_shown:.1} between the branches, {:.1} % of the {work_shown:.1} put in", 100.0 * share))
}

/// The joint as it is beside the same joint without its preload, or with one of half the largest force,
/// which no load relaxes: displacements as they would be read, and of the curve itself the tangents and what a reversal
/// loses. A preload brings friction of its own: it is worth that as long as the reversal loses no more than before.
fn preload(curve: &Curve, forward: &Forward) -> Figure {
    let (most, is_present) = (curve.max_force, curve.preload > 0.0);
    let preload = if is_present { curve.preload } else { 0.5 * most };
    let begun = FORCE.shown(begun(curve));
    let [bare, pressed] = [0.0, preload].map(|preload| curve.preloaded(preload));
    let [without, with] = [&bare, &pressed].map(|curve| {
        let displacement = observed(curve, forward, &along(vec![most], Branch::Load))[0];
        let [first, last] = ends(curve);
        let told = |value: Option<f64>| {
            value.map_or("held".to_string(), |stiffness| format!("{:.1}", STIFFNESS.from_si(stiffness)))
        };
        let (displaced, force, unit) = (MICRO.shown(displacement), FORCE.shown(most), STIFFNESS.unit);
        let tangents = format!("from {} {unit} at {begun:.1} to {}", told(first), told(last));
        let lost = curve.lost_motion();
        let line = format!("{displaced:.3} at {force:.1}, {tangents}; a reversal loses {:.3}", MICRO.shown(lost));
        let entries = [
            ("displacement", Datum::of(MICRO, displacement)),
            ("first", known(first)),
            ("last", known(last)),
            ("lost_motion", Datum::of(MICRO, lost)),
        ];
        (line, Datum::record(entries))
    });
    let would = if is_present { "" } else { ", which it does not have" };
    let (relaxed_at, worth) =
        (pressed.pair().relaxed_at() + curve.friction, pressed.friction_that_loses(bare.lost_motion()));
    let [added, relaxed, worth_shown] = [preload, relaxed_at, worth].map(|force| FORCE.shown(force));
    let until = match worth {
        0.0 => "a reversal loses nothing without it".to_string(),
        _ => format!("it loses less on a reversal until friction grows to {worth_shown:.1}"),
    };
    Figure::new("preload", "without preload")
        .unit("force_unit", FORCE)
        .unit("stiffness_unit", STIFFNESS)
        .quantity("force", FORCE, preload)
        .entry("present", is_present)
        .entry("without", without.1)
        .entry("with", with.1)
        .quantity("relaxed_at", FORCE, relaxed_at)
        .quantity("worth_friction", FORCE, worth)
        .line(without.0)
        .line(format!("with {added:.1}: {}{would}", with.0))
        .line(format!("both sides resist up to {relaxed:.1}; {until}"))
}

fn plots(forces: &[f64], up: &[f64], down: &[f64]) -> Vec<Plot> {
    let plot = |title: &str, values: &[f64]| Plot {
        title: title.into(),
        x_unit: &FORCE.unit,
        points: forces.iter().zip(values).map(|(f, y)| (FORCE.from_si(*f), MICRO.from_si(*y))).collect(),
    };
    let back: Vec<f64> = down.iter().rev().copied().collect();
    let width: Vec<f64> = up.iter().zip(&back).map(|(a, b)| b - a).collect();
    let mut plots = vec![plot("displacement [um] over force [N], loading", up)];
    if width.iter().any(|w| w.abs() > 1e-12) {
        plots.push(plot("displacement [um] over force [N], unloading", &back));
        plots.push(plot("width of the loop [um] over force [N]", &width));
    }
    plots
}

fn warnings(curve: &Curve) -> Vec<String> {
    let (most, f) = (curve.max_force, curve.friction);
    let mut warnings = Vec::new();
    if f >= most {
        let [f, most] = [f, most].map(|force| FORCE.shown(force));
        warnings.push(format!("friction of {f:.1} holds the joint still: the test ends at {most:.1}"));
    } else if 2.0 * f > most && curve.loading == Loading::FromZero {
        warnings.push("friction holds the joint while all of the force is taken away: it does not come back".into());
    }
    if curve.gap > 0.0 && curve.preload > 0.0 {
        warnings.push("the preload has taken the clearance up before any force acts: `gap` changes nothing".into());
    }
    warnings
}
