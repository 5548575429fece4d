//! Marks on the contour where an axis turns round, and how to turn round off the work [seed 000, fig. 4].

use std::f64::consts::PI;

use super::super::forward::Lap;
use super::super::machine::Machine;
use super::super::path::{AXES, Path};
use crate::process::{Datum, Figure};
use crate::units::{ANGLE, LENGTH, MICRO};

/// Time constants after which a lag or a spike has faded.
const LAG_FADES: f64 = 10.0;
const SPIKE_FADES: f64 = 5.0;

/// Where the axes turn round on a circle, and what step and spike they leave there.
pub fn reversals(machine: &Machine) -> Figure {
    let setup = &machine.setup;
    let mut figure = Figure::new("reversals", "reversals").unit("unit", MICRO).unit("angle_unit", ANGLE);
    let mut list = Vec::new();
    for direction in &setup.directions {
        let (lap, word) = (Lap::new(machine, *direction, setup.feed), direction.word());
        for (axis, name) in AXES.iter().enumerate() {
            let (is_lost, height) = (machine.plays[axis].is_any(), machine.spikes[axis].height);
            let mut angles = Vec::new();
            for turn in lap.axes[axis].reversals() {
                let (time, rest) = (turn.time, lap.axes[axis].rest(turn));
                let point = setup.path.at(lap.angle(time));
                let behind = setup.path.at(lap.angle(time + rest));
                let step = if is_lost { lap.offset(&behind) - lap.offset(&point) } else { 0.0 };
                let flat = lap.angle(rest).min(2.0 * PI - lap.angle(rest));
                let spike = height * point.outward[axis].abs();
                let angle = lap.angle(time);
                angles.push(format!("{:.2}", ANGLE.from_si(angle)));
                list.push(Datum::record([
                    ("axis", (*name).into()),
                    ("direction", word.into()),
                    ("angle", Datum::of(ANGLE, angle)),
                    ("step", Datum::of(MICRO, step)),
                    ("flat", Datum::of(ANGLE, flat)),
                    ("spike", Datum::of(MICRO, spike)),
                ]));
                let mut left = Vec::new();
                if is_lost {
                    left.push(format!("a step of {:+.3} over a flat of {:.2}", MICRO.shown(step), ANGLE.shown(flat)));
                }
                if height > 0.0 {
                    left.push(format!("a spike of {:+.3}", MICRO.shown(spike)));
                }
                if !left.is_empty() {
                    let line = format!("{name} at {:>6.2}: {}, {word}", ANGLE.shown(angle), left.join(", "));
                    figure = figure.line(line);
                }
            }
            if !is_lost && height == 0.0 {
                figure = figure.line(format!("{name} at {} deg: nothing stays, {word}", angles.join(" and ")));
            }
        }
    }
    figure.entry("list", Datum::List(list))
}

/// Where to turn round instead of on the work, if anything would stay there.
pub fn advice(machine: &Machine) -> Option<Figure> {
    let setup = &machine.setup;
    let marks = |axis: &usize| machine.plays[*axis].is_any() || machine.spikes[*axis].height > 0.0;
    let axes: Vec<usize> = (0..2).filter(marks).collect();
    let names: Vec<&'static str> = axes.iter().map(|axis| AXES[*axis]).collect();
    let turning = names.join(" and ");
    let fading = machine.spikes.iter().filter(|s| s.height > 0.0).map(|s| SPIKE_FADES * s.time_constant);
    let run_in = setup.feed * (LAG_FADES / setup.gain + fading.fold(0.0, f64::max));
    let lap = Lap::new(machine, setup.directions[0], setup.feed);
    let gap = lap.axes.iter().flat_map(|axis| axis.widths()).map(|(width, _)| width).fold(0.0, f64::max);
    let way_in = LENGTH.shown(run_in);
    let lines = match setup.path {
        _ if axes.is_empty() => return None,
        Path::Circle { .. } => {
            let at = match axes[..] {
                [_, _] => "0, 90, 180 and 270 deg",
                [0] => "0 and 180 deg",
                _ => "90 and 270 deg",
            };
            let play = match gap > 0.0 {
                true => format!(", of which {:.1} take up the play", MICRO.shown(gap)),
                false => String::new(),
            };
            vec![
                format!("leave the circle along its tangent at {at} and turn {turning} round off the work;"),
                format!("come back from outside on an arc, {turning} already heading inwards for {way_in:.3}{play}"),
            ]
        }
        Path::Rectangle { .. } => vec![format!(
            "overrun each corner along its side, turn {turning} round off the work, and run into the next side over \
             at least {way_in:.3}"
        )],
        Path::Polygon { .. } => at_corners(&setup.path, &axes, run_in),
    };
    Some(
        Figure::new("reversing", "to reverse off the work")
            .unit("run_in_unit", LENGTH)
            .unit("gap_unit", MICRO)
            .lines(lines)
            .entry("axes", Datum::List(names.into_iter().map(Datum::from).collect()))
            .quantity("run_in", LENGTH, run_in)
            .quantity("gap", MICRO, gap),
    )
}

/// The corners of a polygon at which axes turn round, and the way off the work there: over the corner along its side,
/// and onto the line of the next side ahead of the corner, which both lie on one side of an acute corner, the angle of
/// the corner apart. Other corners need none.
fn at_corners(path: &Path, axes: &[usize], run_in: f64) -> Vec<String> {
    let sides = path.sides();
    let count = sides.len();
    let (mut lines, mut smooth) = (Vec::new(), Vec::new());
    for (i, side) in sides.iter().enumerate() {
        let before = &sides[(i + count - 1) % count];
        // An axis that stands still on a side still has what it did before.
        let heading = |axis: usize| (1..count).map(|k| sides[(i + count - k) % count].along[axis]).find(|c| *c != 0.0);
        let turns = |axis: &&usize| heading(**axis).is_some_and(|before| before * side.along[**axis] < 0.0);
        let turning: Vec<&str> = axes.iter().filter(turns).map(|axis| AXES[*axis]).collect();
        if turning.is_empty() {
            smooth.push((i + 1).to_string());
            continue;
        }
        let angle = PI - before.turn(side);
        let across = 2.0 * run_in * (0.5 * angle).sin();
        let [x, y] = side.from.map(|c| LENGTH.from_si(c));
        let [angle, over, across] = [ANGLE.shown(angle), LENGTH.shown(run_in), LENGTH.shown(across)];
        lines.push(format!(
            "corner {} at ({x:.3}, {y:.3}), of {angle:.1}: overrun it by {over:.3} along its side, turn {} round in going \
             {across:.3} across, and run {over:.3} into the next side",
            i + 1,
            turning.join(" and ")
        ));
    }
    if !smooth.is_empty() {
        lines.push(format!("at corner {} none of them turns round", smooth.join(", ")));
    }
    lines
}

/// Clearance beside what friction winds up where each axis turns round, and which of them rules: in light
/// machines mostly the kinematic, in heavy ones the elastic [seed 000].
pub fn lost_motion(machine: &Machine) -> Option<Figure> {
    let setup = &machine.setup;
    let lap = Lap::new(machine, setup.directions[0], setup.feed);
    let mut figure = Figure::new("lost_motion", "lost motion").unit("unit", MICRO);
    let mut is_any = false;
    for (axis, name) in AXES.iter().enumerate() {
        let elastic: Vec<f64> = lap.axes[axis].widths().map(|(_, elastic)| elastic).collect();
        let [least, greatest] =
            [f64::min as fn(f64, f64) -> f64, f64::max].map(|pick| elastic.iter().copied().reduce(pick).unwrap_or(0.0));
        if greatest == 0.0 {
            continue;
        }
        is_any = true;
        let gap = machine.plays[axis].gap;
        let rules = match gap > 0.5 * (least + greatest) {
            true => "kinematic",
            false => "elastic",
        };
        let [shown, low, high] = [gap, least, greatest].map(|width| MICRO.shown(width));
        figure = figure
            .line(format!("{name}: {shown:.3} kinematic, {low:.3} to {high:.3} elastic (2F/C): the {rules} rules"))
            .entry(
                *name,
                Datum::record([
                    ("kinematic", Datum::of(MICRO, gap)),
                    ("least_elastic", Datum::of(MICRO, least)),
                    ("greatest_elastic", Datum::of(MICRO, greatest)),
                    ("rules", rules.into()),
                ]),
            );
    }
    is_any.then_some(figure)
}
