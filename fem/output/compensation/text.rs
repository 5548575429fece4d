//! Writes a compensation for people.

use std::fmt::Write;

use super::Supplied;
use crate::compensate::{Compensation, Feasibility, Kinematic, LostMotion, Rules, Step};
use crate::model::Data;
use crate::output::measurement;
use crate::output::number::{fixed, signed};
use crate::positioning::{Check, EDITION, Evaluation, Measures, Quantity};

/// Most targets that are listed; all are in the files.
const LISTED: usize = 24;

/// Writes verdict, evaluation and tables. Writing to a String does not fail, here and below.
pub fn text(data: &Data, c: &Compensation, supplied: &[Supplied]) -> String {
    let (targets, runs) = (c.evaluation.targets.len(), c.evaluation.runs());
    let times = if runs == 1 { "once".into() } else { format!("{runs} times") };
    let mut text = format!(
        "{} against {}: {} observations, {targets} targets, from each side {times} at least\n\n{}\n",
        data.model.source.name,
        data.name,
        data.len(),
        verdict(c)
    );
    for cause in &c.causes {
        let _ = writeln!(text, "  {}\n    {}", cause.finding, cause.remedy);
    }
    let own = measurement::at_work(&data.model.source.name, &data.terms, &*data.model.process, Some(data));
    if !own.is_empty() {
        let _ = write!(text, "\n{own}");
    }
    for caution in &c.cautions {
        let _ = writeln!(text, "\ncaution: {caution}");
    }
    wrong_readings(&mut text, c);
    standard(&mut text, c);
    let _ = writeln!(
        text,
        "  after is by the same readings: a new test adds what they leave of the means, s/sqrt(n) = {:.4} where most",
        c.measures.deviation.shown(c.evaluation.uncertainty())
    );
    targets_of(&mut text, &c.evaluation, c.measures);
    reversal(&mut text, c);
    tolerances(&mut text, c);
    modelled(&mut text, c);
    entries(&mut text, c);
    controls(&mut text, supplied, c.measures);
    text
}

/// Lists the readings that are left out of means and tables.
fn wrong_readings(text: &mut String, c: &Compensation) {
    if c.wrong_readings.is_empty() {
        return;
    }
    let _ = writeln!(text, "\nleft out of means and tables, as wrong");
    for wrong in &c.wrong_readings {
        let (x, sign) = (place(c.measures, wrong.approach.position), wrong.approach.direction.sign());
        let why = match (wrong.is_stated, wrong.others) {
            (true, _) => "the model weighs it down".to_string(),
            (false, Some(mean)) => format!("the other approaches have {} in the mean", small(c.measures, mean)),
            (false, None) => "it contradicts the other approaches".to_string(),
        };
        let value = small(c.measures, wrong.value);
        let [off, at] = [c.measures.deviation_unit(), c.measures.position_unit()];
        let _ = writeln!(text, "  line {:<5} {value} {off} at {x} {at}, {sign}: {why}", wrong.line);
    }
}

fn verdict(c: &Compensation) -> &'static str {
    match c.feasibility {
        Feasibility::Within => "within tolerance as it is: compensation can only improve it",
        Feasibility::Compensation => {
            "compensation suffices: a pitch table and one backlash value bring the axis within tolerance"
        }
        Feasibility::BothDirections => {
            "one backlash value does not suffice: only a table for each direction brings the axis within tolerance"
        }
        Feasibility::Resolution => {
            "compensation would reach the tolerance, but the controller's entries are too coarse for it"
        }
        Feasibility::Repair => "compensation cannot reach the tolerance: the mechanics must be repaired first",
        Feasibility::BetweenTargets => {
            "tables bring the targets within tolerance; whether they do so between them is not known: measure more targets"
        }
        Feasibility::Unknown => {
            "whether compensation suffices is not known: approach every target at least twice from each side"
        }
    }
}

/// A deviation in its unit as it is printed, if it is known.
fn known(measures: Measures, off: Option<f64>) -> String {
    off.map_or("-".into(), |off| small(measures, off))
}

/// A deviation in its unit as it is printed.
fn small(measures: Measures, off: f64) -> String {
    fixed(measures.off(off), 4)
}

/// A position in its unit as it is printed.
fn place(measures: Measures, at: f64) -> String {
    fixed(measures.place(at), 3)
}

fn standard(text: &mut String, c: &Compensation) {
    let [points, _, both] = &c.schemes;
    let unit = c.measures.deviation_unit();
    let _ = writeln!(text, "\n{EDITION:<43} {:>10} {:>10} {:>10}   {unit}", "measured", "one value", "each way");
    let (one, both) = (points.after.quantities(), both.after.quantities());
    for q in c.evaluation.quantities() {
        let after = |all: &[Quantity]| known(c.measures, Quantity::find(all, q.symbol));
        let name = if q.symbol == "B_mean" { "" } else { q.symbol };
        let _ = writeln!(
            text,
            "  {name:<2} {:<38} {:>10} {:>10} {:>10}   {}",
            q.name,
            known(c.measures, q.value),
            after(&one),
            after(&both),
            q.formula
        );
    }
}

fn targets_of(text: &mut String, evaluation: &Evaluation, measures: Measures) {
    let printed = |off: Option<f64>| known(measures, off);
    let _ = writeln!(
        text,
        "\n  {:>10}  {:>10} {:>8}  {:>10} {:>8}  {:>10} {:>10}",
        if measures.is_rotary() { "angle" } else { "position" },
        "mean+",
        "s+",
        "mean-",
        "s-",
        "B",
        "R"
    );
    for t in evaluation.targets.iter().take(LISTED) {
        let side =
            |s: Option<crate::positioning::Side>| (printed(s.map(|s| s.mean)), printed(s.and_then(|s| s.scatter)));
        let ((forward, sf), (backward, sb)) = (side(t.forward), side(t.backward));
        let (reversal, repeatability) = (printed(t.reversal()), printed(t.repeatability()));
        let _ = writeln!(
            text,
            "  {:>10}  {forward:>10} {sf:>8}  {backward:>10} {sb:>8}  {reversal:>10} {repeatability:>10}",
            place(measures, t.position)
        );
    }
    let more = evaluation.targets.len().saturating_sub(LISTED);
    if more > 0 {
        let _ = writeln!(text, "  and {more} more (--json has them all)");
    }
    let _ = writeln!(text, "  in {} and {}", measures.position_unit(), measures.deviation_unit());
}

fn reversal(text: &mut String, c: &Compensation) {
    let Some(reversal) = &c.reversal else {
        let _ = writeln!(text, "\nno target was approached from both sides: the reversal is not known");
        return;
    };
    let unit = c.measures.deviation_unit();
    let _ = writeln!(
        text,
        "\nbacklash value   {} {unit}, (b_max + b_min)/2 of the lost motion b = mean- less mean+\nnot removable    {} {unit} either way by any single value, (b_max - b_min)/2",
        small(c.measures, reversal.value),
        small(c.measures, reversal.rest)
    );
    if let Some(lost) = &c.lost_motion {
        let _ = writeln!(text, "lost motion      {}", lost_motion(lost));
        if let Some(found) = &lost.step {
            let _ = writeln!(text, "                 {}", step(found));
        }
    }
    if c.active.is_some() {
        let _ = writeln!(text, "                 without what the controller compensated during the test");
    }
    if let Some(told) = &c.modelled_lost_motion {
        let _ = writeln!(text, "                 the model, which agrees with the test, has it {told}");
    }
}

/// Parts of the lost motion, which only screws have: in um.
fn lost_motion(l: &LostMotion) -> String {
    let micrometres = |m: f64| small(Measures::LINEAR, m);
    let none = match l.kinematic() {
        Kinematic::BelowNone => {
            ", below zero as no play is: more is compensated already, or it is no sum of these parts"
        }
        Kinematic::CompatibleWithNone if l.constant < 0.0 => " (below zero, and compatible with none)",
        Kinematic::CompatibleWithNone => " (compatible with none)",
        Kinematic::Seen => "",
    };
    let [constant, std, misfit] = [l.constant, l.constant_std, l.misfit].map(micrometres);
    let constant = format!("{constant} +- {std} um of it are the same all along{none}");
    let is_play = "play, or the give of nut and bearing";
    let rules = match l.rules() {
        Rules::Constant => format!("what is the same all along rules: {is_play}"),
        Rules::Elastic => "the elastic part rules, as in heavy machines".to_string(),
        Rules::Both => "neither rules".to_string(),
        Rules::Unclear => format!("no part can be named, for together they miss the targets by up to {misfit} um"),
    };
    if !l.grows() {
        let what = match (l.rules(), l.kinematic()) {
            (Rules::Unclear, _) => format!(": {rules}"),
            (_, Kinematic::Seen) => format!(": {is_play}"),
            _ => String::new(),
        };
        return format!("{constant}; no part is seen that grows along the screw{what}");
    }
    let [low, high] = [l.screw.0, l.screw.1].map(micrometres);
    let [friction, std] = [l.friction, l.friction_std].map(|force| fixed(force, 0));
    format!("{constant}, {low} to {high} um the stretch of the screw under {friction} +- {std} N of friction: {rules}")
}

/// The step that comes nearer to the targets than the parts do.
fn step(s: &Step) -> String {
    let [misfit, constant] = [s.misfit, s.constant].map(|m| small(Measures::LINEAR, m));
    let [from, to] = [s.from, s.to].map(|m| place(Measures::LINEAR, m));
    let (height, friction) = (signed(1e6 * s.height, 4), fixed(s.friction, 0));
    let harder = if s.height > 0.0 { "beyond" } else { "before" };
    format!(
        "a step of {height} um between {from} and {to} mm comes within {misfit} um, beside {constant} um that are the \
         same all along and {friction} N: {harder} it the slide goes harder, or the screw has more play"
    )
}

fn tolerances(text: &mut String, c: &Compensation) {
    let width = c.before.iter().map(|check| check.name.len()).max().unwrap_or(0);
    let _ = writeln!(
        text,
        "\n{:<width$}  {:>10} {:>12} {:>12} {:>12}   {}",
        "tolerances",
        "allowed",
        "measured",
        "one value",
        "each way",
        c.measures.deviation_unit(),
        width = width + 2
    );
    let cell = |check: &Check| format!("{}{}", known(c.measures, check.value), if check.passed() { " " } else { "!" });
    let [points, _, both] = &c.schemes;
    for ((before, one), both) in c.before.iter().zip(&points.checks).zip(&both.checks) {
        let cells = format!("{:>12} {:>12} {:>12}", cell(before), cell(one), cell(both));
        let _ =
            writeln!(text, "  {:<width$}  {:>10.4} {}", before.name, c.measures.off(before.limit), cells.trim_end());
    }
    if c.before.iter().chain(c.schemes.iter().flat_map(|s| &s.checks)).any(|c| !c.passed()) {
        let _ = writeln!(text, "  ! out of tolerance or not known");
    }
}

fn modelled(text: &mut String, c: &Compensation) {
    let (rms, small) = (c.measures.deviation.shown(c.model.rms), c.measures.deviation);
    let fitted = if c.model.fitted { "fitted to the test, " } else { "" };
    let _ = writeln!(
        text,
        "\nby the model, along the whole {} ({fitted}it misses the readings by {rms:.4} rms)",
        if c.measures.is_rotary() { "range" } else { "travel" }
    );
    for scheme in &c.schemes {
        let _ = writeln!(text, "  {:<30} leaves a range of {:.4}", scheme.name, small.shown(scheme.modelled.spread()));
    }
}

fn entries(text: &mut String, c: &Compensation) {
    let [points, _, _] = &c.schemes;
    let [unit_of_place, off] = [c.measures.position_unit(), c.measures.deviation_unit()];
    let mut before = None;
    let _ = writeln!(
        text,
        "\nto enter: backlash {} {off}, and at each point (linear between)",
        small(c.measures, points.entered.backlash())
    );
    let _ = writeln!(
        text,
        "  {:>10}  {:>10} {:>10}",
        if c.measures.is_rotary() { "angle" } else { "position" },
        "added",
        "increment"
    );
    for node in points.entered.nodes.iter().take(LISTED) {
        let step = before.map_or("-".into(), |b: f64| signed(c.measures.off(node.forward - b), 4));
        let (at, added) = (place(c.measures, node.position), signed(c.measures.off(node.forward), 4));
        let _ = writeln!(text, "  {at:>10}  {added:>10} {step:>10}");
        before = Some(node.forward);
    }
    let onto = match c.active {
        Some(_) => "with what the controller had during the test, and in its place",
        None => "onto what the controller had during the test",
    };
    let _ = writeln!(
        text,
        "  in {unit_of_place} and {off}, {onto}; then measure again, until the axis keeps its tolerance"
    );
}

/// Describes the files for the controls that were asked for: the range left at the targets, and notes.
fn controls(text: &mut String, supplied: &[Supplied], measures: Measures) {
    for s in supplied.iter().filter(|s| s.is_asked) {
        let (left, unit) = (small(measures, s.left), measures.deviation_unit());
        let _ = writeln!(
            text,
            "\nfor {}, {}\n  leaves a range of {left} {unit} at the targets",
            s.control.name, s.control.about
        );
        for note in &s.notes {
            let _ = writeln!(text, "  {note}");
        }
    }
}
