//! The report of a run: figures by ISO 230-2, lost motion, the profile, and the screw in space.

mod shapes;
mod sketch;

use super::machine::Machine;
use super::rows::{COORDINATES, DIRECTION, OBSERVABLES, POSITION, RUN, TIME_OF_ROW};
use super::setup::Setup;
use crate::positioning::{Direction, Evaluation, Measures, stand_apart_by};
use crate::process::{Datum, Figure, Forward, Nut, Positioning, RunReport, Table, Tested, range};
use crate::units::{MICRO, STIFFNESS};

/// One of two clearances rules when it is this many times the other.
const RULES: f64 = 2.0;
/// A lost motion below this (m) is none.
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
    let tested = Tested { approaches: &approaches, deviations: &deviations, measures: Measures::LINEAR };
    let mut figures = tested.figures(&evaluation);
    figures.extend([lost_motion(machine), screw(setup)]);
    figures.extend(setup.nut.as_ref().map(Nut::figure));
    let told = (COORDINATES, &[RUN, POSITION, DIRECTION, TIME_OF_ROW][..]);
    RunReport {
        profile: Table::of_rows(told, rows, &OBSERVABLES[0], readings),
        figures,
        plots: Direction::BOTH.map(|direction| tested.plot(&evaluation, direction)).into(),
        warnings: warnings(setup),
        sketch: Some(sketch::sketch(machine)),
        animations: vec![shapes::animation(machine, forward)],
        ..RunReport::default()
    }
}

/// Figure of the clearance that rules in the drive [seed 000]: the kinematic one of light machines, or the elastic one
/// of heavy machines. Mechanics: what a formula effect adds to the deviation is neither.
fn lost_motion(machine: &Machine) -> Figure {
    let targets = || machine.setup.targets().into_iter();
    let (low, high) = range(targets().map(|x| 2.0 * machine.wind_up(x)));
    let (tight, loose) = range(targets().map(|x| machine.play(x)));
    let [kinematic, typical] = [0.5 * (tight + loose), 0.5 * (low + high)];
    let (rules, verdict) = match (tight.abs().max(loose.abs()), typical) {
        (k, e) if k.max(e) < NONE => ("none", ""),
        (k, e) if k >= RULES * e => ("kinematic", "the kinematic gap rules, as in light machines"),
        (k, e) if e >= RULES * k => ("elastic", "the elastic gap rules, as in heavy machines"),
        _ => ("both", "neither rules"),
    };
    let (gap, least, most) = (MICRO.shown(kinematic), MICRO.from_si(low), MICRO.shown(high));
    let [from, to] = [MICRO.from_si(tight), MICRO.from_si(loose)];
    let gap = if loose - tight < NONE { format!("{gap:.3}") } else { format!("{from:.3} to {to:.3}") };
    let ahead = if kinematic < -NONE { "; more play is compensated than there is" } else { "" };
    let text = match rules {
        "none" => "none".into(),
        _ => format!("kinematic {gap}, elastic {least:.3} to {most:.3}: {verdict}{ahead}"),
    };
    Figure::new("lost_motion", "lost motion")
        .quantity("kinematic", MICRO, kinematic)
        .entry("kinematic_range", Datum::Quantities(MICRO, vec![tight, loose]))
        .entry("elastic", Datum::Quantities(MICRO, vec![low, high]))
        .entry("rules", rules)
        .line(text)
}

fn screw(setup: &Setup) -> Figure {
    let screw = setup.screw();
    let stiffness = 1.0 / setup.targets().into_iter().map(|x| screw.compliance(x)).fold(0.0, f64::max);
    let text = if stiffness.is_finite() {
        format!("{:.1} along itself where it is softest", STIFFNESS.shown(stiffness))
    } else {
        "rigid at every target".into()
    };
    Figure::new("screw_stiffness", "screw").quantity("value", STIFFNESS, stiffness).line(text)
}

fn warnings(setup: &Setup) -> Vec<String> {
    let warning = "all targets stand apart by multiples of the lead: errors that repeat with each turn cannot be seen; \
                   spacing = \"staggered\" in [test] moves them";
    if stand_apart_by(setup.lead, &setup.targets()) { vec![warning.into()] } else { Vec::new() }
}
