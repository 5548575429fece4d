//! The report of a run: figures by ISO 230-2, lost motion, the profile, and the screw in space.

mod shapes;
mod sketch;

use super::machine::Machine;
use super::rows::{COORDINATES, DIRECTION, OBSERVABLES, POSITION, RUN, TIME_OF_ROW, approach};
use super::setup::Setup;
use crate::positioning::{Direction, EDITION, Evaluation, Quantity, Target};
use crate::process::{Datum, Figure, Forward, Nut, Plot, Positioning, RunReport, Table, first_extreme, range};
use crate::units::{LENGTH, MICRO, STIFFNESS};

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
    let evaluation = Evaluation::of(&setup.approaches(rows), &deviations);
    let quantities = evaluation.quantities();
    let mut figures = vec![
        extreme("largest", "largest deviation", f64::gt, forward),
        extreme("smallest", "smallest deviation", f64::lt, forward),
        standard(&quantities),
    ];
    figures.extend(LETTERS.iter().filter_map(|letter| quantity(&quantities, *letter)));
    figures.extend([lost_motion(machine), screw(setup)]);
    figures.extend(setup.nut.as_ref().map(Nut::figure));
    let told = (COORDINATES, &[RUN, POSITION, DIRECTION, TIME_OF_ROW][..]);
    RunReport {
        profile: Table::of_rows(told, rows, &OBSERVABLES[0], readings),
        figures,
        plots: Direction::BOTH.map(|direction| plot(&evaluation, direction)).into(),
        warnings: warnings(setup),
        sketch: Some(sketch::sketch(machine)),
        animation: Some(shapes::animation(machine, forward)),
        ..RunReport::default()
    }
}

fn extreme(key: &'static str, label: &'static str, beats: fn(&f64, &f64) -> bool, forward: &Forward) -> Figure {
    let row = first_extreme(forward.prediction, beats);
    let (value, at) = (forward.prediction[row], approach(forward.programme, row));
    let (shown, position, sign) = (MICRO.shown(value), LENGTH.shown(at.position), at.direction.sign());
    Figure::new(key, label)
        .quantity("value", MICRO, value)
        .quantity("position", LENGTH, at.position)
        .entry("direction", sign)
        .entry("run", at.run as usize)
        .line(format!("{shown:+.3} at {position:.1} approached in {sign}, run {}", at.run))
}

/// All quantities of ISO 230-2.
fn standard(quantities: &[Quantity]) -> Figure {
    let record = |q: &Quantity| {
        let [symbol, name, formula] = [q.symbol, q.name, q.formula].map(Datum::from);
        Datum::record([("symbol", symbol), ("name", name), ("formula", formula), ("value", known(q.value))])
    };
    Figure::new("iso230", EDITION)
        .line("of this prediction, which has no scatter: s is what drifts from run to run")
        .entry("edition", EDITION)
        .entry("quantities", Datum::List(quantities.iter().map(record).collect()))
}

/// Datum of a quantity of ISO 230-2, NaN where the test does not give it.
fn known(value: Option<f64>) -> Datum {
    Datum::of(MICRO, value.unwrap_or(f64::NAN))
}

/// Quantities with a figure of their own: letter, key and label.
const LETTERS: [(&str, &str, &str); 5] = [
    ("A", "accuracy", "  A accuracy"),
    ("E", "systematic", "  E systematic error"),
    ("M", "mean_bidirectional", "  M mean of both ways"),
    ("R", "repeatability", "  R repeatability"),
    ("B", "reversal", "  B reversal error"),
];

fn quantity(all: &[Quantity], (letter, key, label): (&str, &'static str, &'static str)) -> Option<Figure> {
    let found = all.iter().find(|q| q.symbol == letter)?;
    let place = found.at.map_or(String::new(), |at| format!(" at {:.1}", LENGTH.shown(at)));
    let text = found.value.map_or("needs two runs".into(), |v| format!("{:.3}{place}", MICRO.shown(v)));
    Some(Figure::new(key, label).entry("value", known(found.value)).line(text))
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

/// The mean deviation of a direction.
fn plot(evaluation: &Evaluation, direction: Direction) -> Plot {
    let point = |t: &Target| Some((LENGTH.from_si(t.position), MICRO.from_si(t.side(direction)?.mean)));
    Plot {
        title: format!("mean deviation [um] over position [mm], approached in {}", direction.sign()),
        x_unit: &LENGTH.unit,
        points: evaluation.targets.iter().filter_map(point).collect(),
    }
}

fn warnings(setup: &Setup) -> Vec<String> {
    let is_multiple = |x: &f64| (x / setup.lead - (x / setup.lead).round()).abs() < 1e-6;
    let warning = "all targets are multiples of the lead: errors that repeat with each turn cannot be seen; \
                   spacing = \"staggered\" in [test] moves them";
    if setup.targets().iter().all(is_multiple) { vec![warning.into()] } else { Vec::new() }
}
