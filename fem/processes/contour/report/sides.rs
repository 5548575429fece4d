//! Figures of straight sides: their offset and tilt, sizes of a rectangle, corners.

use super::super::forward::Lap;
use super::super::machine::Machine;
use super::super::motion::in_order;
use super::super::path::{AXES, Direction, Path, Side};
use super::super::rows;
use super::super::setup::Setup;
use crate::process::{Datum, Figure};
use crate::units::{ANGLE, LENGTH, MICRO, SLOPE};

/// Waves longer than this part of a side are none on it.
const LONGEST: f64 = 1e3;

/// A side as it comes out.
struct Made {
    /// Offset of its least-squares line half way along, outwards, m. (The stretches left out behind its
    /// corners are longer than those before them.)
    offset: f64,
    /// Slope of its least-squares line, counter-clockwise and outwards.
    tilt: f64,
}

/// The figures of a rectangle or a polygon; `deviations` at the points of `setup`, direction by direction, m.
pub fn figures(machine: &Machine, setup: &Setup, deviations: &[f64]) -> Vec<Figure> {
    let mut rest = deviations;
    let mut sizes = Figure::new("sizes", "errors of sizes").unit("unit", MICRO);
    let mut sides = Figure::new("sides", "offset outwards").unit("unit", MICRO).unit("tilt_unit", SLOPE);
    for direction in &setup.directions {
        let angles = rows::angles(setup, *direction);
        let (own, more) = rest.split_at(angles.len());
        rest = more;
        let made = made(setup, &angles, own);
        let word = direction.word();
        for (side, made) in setup.path.sides().iter().zip(&made) {
            let facing = ANGLE.shown(side.outward[1].atan2(side.outward[0]));
            let (offset, tilt) = (MICRO.shown(made.offset), SLOPE.shown(made.tilt));
            sides = sides.line(format!("{offset:+.3} on the side that faces {facing:.1}, tilted {tilt:+.2}, {word}"));
        }
        let (offsets, tilts) = (made.iter().map(|m| m.offset).collect(), made.iter().map(|m| m.tilt).collect());
        let values = [("offsets", Datum::Quantities(MICRO, offsets)), ("tilts", Datum::Quantities(SLOPE, tilts))];
        sides = sides.entry(word, Datum::record(values));
        let Path::Rectangle { .. } = setup.path else { continue };
        let [width, height] = [made[0].offset + made[2].offset, made[1].offset + made[3].offset];
        let shown = [width, height].map(|size| MICRO.shown(size));
        sizes = sizes
            .line(format!("width {:+.3}, height {:+.3}, {word}", shown[0], shown[1]))
            .entry(word, Datum::record([("width", Datum::of(MICRO, width)), ("height", Datum::of(MICRO, height))]));
    }
    let is_rectangle = matches!(setup.path, Path::Rectangle { .. });
    let sizes = is_rectangle.then_some(sizes);
    sizes.into_iter().chain([sides, corners(machine)]).chain(waves(setup)).collect()
}

/// The least-squares line of the deviations of each side.
fn made(setup: &Setup, angles: &[f64], deviations: &[f64]) -> Vec<Made> {
    let points: Vec<_> = angles.iter().map(|a| setup.path.at(*a)).collect();
    let of = |side: usize| {
        // From half way along.
        let along = |ends: [f64; 2]| 0.5 * (ends[0] - ends[1]);
        let on_side = points.iter().zip(deviations).filter(|(p, _)| p.side == side);
        let own: Vec<(f64, f64)> = on_side.map(|(p, d)| (along(p.from_ends), *d)).collect();
        let count = own.len() as f64;
        let (middle, mean) =
            (own.iter().map(|o| o.0).sum::<f64>() / count, own.iter().map(|o| o.1).sum::<f64>() / count);
        let (mut square, mut product) = (0.0, 0.0);
        for (along, deviation) in &own {
            square += (along - middle).powi(2);
            product += (along - middle) * (deviation - mean);
        }
        let tilt = product / square;
        Made { offset: mean - tilt * middle, tilt }
    };
    (0..setup.path.sides().len()).map(of).collect()
}

/// How near the tool comes to its corners, which it rounds by its lag.
fn corners(machine: &Machine) -> Figure {
    let setup = &machine.setup;
    let mut nearest = Vec::new();
    for direction in &setup.directions {
        nearest.extend(in_order(&setup.path, *direction).iter().map(|side| closest(machine, *direction, side.from)));
    }
    let [low, high] =
        [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| nearest.iter().copied().reduce(pick).unwrap_or(0.0));
    let (before, after) = setup.corner(setup.feed);
    let range = match high - low < 5e-7 {
        true => format!("{:.3}", LENGTH.shown(high)),
        false => format!("{:.3} to {:.3}", LENGTH.from_si(low), LENGTH.shown(high)),
    };
    let [shown_before, shown_after] = [before, after].map(|l| LENGTH.shown(l));
    Figure::new("corners", "corners")
        .line(format!(
            "rounded: the tool passes them at {range}; left out are {shown_before:.3} before and {shown_after:.3} \
             behind each"
        ))
        .quantity("smallest", LENGTH, low)
        .quantity("largest", LENGTH, high)
        .quantity("before", LENGTH, before)
        .quantity("behind", LENGTH, after)
}

/// The smallest distance of the tool from a corner, m.
fn closest(machine: &Machine, direction: Direction, corner: [f64; 2]) -> f64 {
    let setup = &machine.setup;
    let lap = Lap::new(machine, direction, setup.feed);
    let sides = in_order(&setup.path, direction);
    let number = sides.iter().position(|s| s.from == corner).unwrap_or(0);
    let begin = sides[..number].iter().map(|s| s.length).sum::<f64>() / setup.feed;
    let period = lap.axes[0].motion.period();
    let distance = |after: f64| {
        let [x, y] = lap.position((begin + after).rem_euclid(period)).0;
        (x - corner[0]).hypot(y - corner[1])
    };
    // The tool passes a time of some 1/Kv later, and the distance has one least value there.
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut low, mut high) = (0.0, 4.0 / setup.gain);
    for _ in 0..60 {
        let [a, b] = [high - golden * (high - low), low + golden * (high - low)];
        if distance(a) < distance(b) { high = b } else { low = a }
    }
    distance(0.5 * (low + high))
}

/// How long the waves of periodic errors are on the sides: lead/cos φ, φ between axis and side [seed 000].
fn waves(setup: &Setup) -> Option<Figure> {
    let sides = setup.path.sides();
    let named: Vec<(String, &Side)> = match setup.path {
        Path::Rectangle { .. } => vec![("the width".into(), &sides[1]), ("the height".into(), &sides[0])],
        _ => sides.iter().enumerate().map(|(i, side)| (format!("side {}", i + 1), side)).collect(),
    };
    let (mut words, mut list) = (Vec::new(), Vec::new());
    for (name, side) in &named {
        for ((axis, along), drive) in AXES.iter().zip(side.along).zip(&setup.drives) {
            let Some(lead) = drive.lead else { continue };
            let wave = lead / along.abs();
            if wave < LONGEST * side.length {
                words.push(format!("{:.3} of {axis} along {name}", LENGTH.shown(wave)));
                list.push(Datum::record([
                    ("axis", (*axis).into()),
                    ("along", name.trim_start_matches("the ").to_string().into()),
                    ("length", Datum::of(LENGTH, wave)),
                ]));
            }
        }
    }
    if words.is_empty() {
        return None;
    }
    Some(Figure::new("waves", "waves of a lead").line(words.join(", ")).entry("list", Datum::List(list)))
}
