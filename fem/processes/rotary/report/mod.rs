//! The report of a run: figures by ISO 230-2, lost motion, the drive, the profile, and the table in space.

mod shapes;
mod sketch;

use std::f64::consts::TAU;

use super::machine::Machine;
use super::rows::{ANGLE_OF_ROW, COORDINATES, DIRECTION, OBSERVABLES, RUN, TIME_OF_ROW, TORQUE_OF_ROW};
use super::setup::Setup;
use crate::positioning::{Direction, Evaluation, Measures, stand_apart_by};
use crate::process::{Datum, Figure, Forward, Positioning, RunReport, Table, Tested, range};
use crate::units::{NUMBER, SMALL_ANGLE, TORSIONAL_STIFFNESS};

/// One of two clearances rules when it is this many times the other.
const RULES: f64 = 2.0;
/// A lost motion below this (rad) is none.
const NONE: f64 = 1e-10;

/// Everything that a run reports.
pub fn report(machine: &Machine, forward: &Forward) -> RunReport {
    let (setup, rows, readings) = (&machine.setup, forward.programme, forward.prediction);
    // Figures are of deviations, the profile of what the instrument shows.
    let zero = setup.test.reading_at_zero.unwrap_or(0.0);
    let deviations: Vec<f64> = readings.iter().map(|reading| reading - zero).collect();
    let forward = &forward.showing(&deviations);
    let approaches = setup.approaches(rows);
    let evaluation = Evaluation::of(&approaches, &deviations);
    let tested = Tested { approaches: &approaches, deviations: &deviations, measures: Measures::ROTARY };
    let mut figures = tested.figures(&evaluation);
    figures.extend([lost_motion(machine), drive(machine)]);
    let torque = (setup.test.torque != 0.0).then_some(TORQUE_OF_ROW);
    let shown: Vec<usize> = [RUN, ANGLE_OF_ROW, DIRECTION, TIME_OF_ROW].into_iter().chain(torque).collect();
    RunReport {
        profile: Table::of_rows((COORDINATES, &shown), rows, &OBSERVABLES[0], readings),
        figures,
        plots: Direction::BOTH.map(|direction| tested.plot(&evaluation, direction)).into(),
        warnings: warnings(setup),
        sketch: Some(sketch::sketch(machine)),
        animations: vec![shapes::animation(machine, forward)],
        ..RunReport::default()
    }
}

/// Figure of the lost motion that rules: play, or what friction winds up either way. Mechanics: what a formula effect adds
/// to the deviation is neither.
fn lost_motion(machine: &Machine) -> Figure {
    let elastic = 2.0 * machine.friction * machine.compliance;
    let (tight, loose) = range(machine.setup.targets().into_iter().map(|angle| machine.play(angle)));
    let kinematic = 0.5 * (tight + loose);
    let (rules, verdict) = match (tight.abs().max(loose.abs()), elastic) {
        (k, e) if k.max(e) < NONE => ("none", ""),
        (k, e) if k >= RULES * e => ("kinematic", "play rules"),
        (k, e) if e >= RULES * k => ("elastic", "wind-up by friction rules"),
        _ => ("both", "neither rules"),
    };
    let [gap, wound] = [kinematic, elastic].map(|own| SMALL_ANGLE.shown(own));
    let [from, to] = [SMALL_ANGLE.from_si(tight), SMALL_ANGLE.from_si(loose)];
    let unit = SMALL_ANGLE.unit;
    let gap = if loose - tight < NONE { format!("{gap:.3}") } else { format!("{from:.3} to {to:.3} {unit}") };
    let ahead = if kinematic < -NONE { "; more play is compensated than there is" } else { "" };
    let text = match rules {
        "none" => "none".into(),
        _ => format!("kinematic {gap}, elastic {wound:.3}: {verdict}{ahead}"),
    };
    Figure::new("lost_motion", "lost motion")
        .quantity("kinematic", SMALL_ANGLE, kinematic)
        .entry("kinematic_range", Datum::Quantities(SMALL_ANGLE, vec![tight, loose]))
        .quantity("elastic", SMALL_ANGLE, elastic)
        .entry("rules", rules)
        .line(text)
}

/// Figure of the ratio and the stiffness of the drive.
fn drive(machine: &Machine) -> Figure {
    let (drive, stiffness) = (&machine.setup.drive, 1.0 / machine.compliance);
    let pairs: Vec<String> = drive.stages.iter().map(|s| format!("{}:{}", s.driving, s.driven)).collect();
    let gears = (!pairs.is_empty()).then(|| format!("gears {}", pairs.join(", ")));
    let worm = drive.worm.map(|worm| format!("worm {}:{}", worm.starts, worm.teeth));
    let parts: Vec<String> = gears.into_iter().chain(worm).collect();
    let what = match &parts[..] {
        [] => "direct".to_string(),
        parts => format!("{}, {} to one", parts.join(", "), (drive.ratio() * 1e4).round() / 1e4),
    };
    let yields = match () {
        () if machine.setup.is_closed() => "the scale on the table takes its errors out".into(),
        () if stiffness.is_finite() => format!("{:.3} at the table", TORSIONAL_STIFFNESS.shown(stiffness)),
        () => "rigid".into(),
    };
    Figure::new("drive", "drive")
        .quantity("ratio", NUMBER, drive.ratio())
        .quantity("stiffness", TORSIONAL_STIFFNESS, stiffness)
        .line(format!("{what}, {yields}"))
}

fn warnings(setup: &Setup) -> Vec<String> {
    let line = setup.scale.and_then(|scale| scale.lines_a_turn(&setup.drive)).map(|lines| TAU / lines);
    let gearing = if setup.is_closed() { Vec::new() } else { setup.drive.periods() };
    let targets = setup.targets();
    let all_on = |period: f64| stand_apart_by(period, &targets);
    // What comes back with a longer period comes back with its parts.
    let first = gearing.into_iter().find(|(period, _)| all_on(*period));
    let line = line.filter(|period| all_on(*period)).map(|period| (period, "a line of the scale"));
    let seen = |(_, what): (f64, &str)| {
        format!(
            "all targets stand apart by multiples of {what}: errors that repeat with it cannot be seen; spacing = \"staggered\" \
             in [test] moves them, or other numbers of positions"
        )
    };
    first.into_iter().chain(line).map(seen).collect()
}
