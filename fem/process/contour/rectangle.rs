//! What a rectangle comes out as: offset and tilt of its sides, its sizes, its corners.

use serde_json::json;

use super::job::Contouring;
use super::machine::Lap;
use super::model::{AXES, Setup};
use super::motion::in_order;
use super::observe;
use super::path::{Direction, Path};
use crate::process::Finding;
use crate::units::SLOPE;

/// Waves longer than this part of a side are none on it.
const LONGEST: f64 = 1e3;

/// A side as it comes out.
struct Made {
    /// Of its least-squares line half way along, outwards, m: what is left out at its corners is longer behind one than before the other.
    offset: f64,
    /// Of its least-squares line, counter-clockwise and outwards.
    tilt: f64,
}

/// The findings of a rectangle; `deviations` direction by direction, m.
pub fn findings(contouring: &Contouring, deviations: &[f64]) -> Vec<Finding> {
    let setup = contouring.setup();
    let mut rest = deviations;
    let (mut sides, mut sizes) = (Vec::new(), Vec::new());
    let (mut json_sides, mut json_sizes) = (serde_json::Map::new(), serde_json::Map::new());
    for direction in &setup.directions {
        let angles = observe::angles(setup, *direction);
        let (own, more) = rest.split_at(angles.len());
        rest = more;
        let made = made(setup, &angles, own);
        let word = direction.word();
        let offsets = made.iter().map(|m| 1e6 * m.offset).collect::<Vec<_>>();
        let tilts = made.iter().map(|m| SLOPE.from_si(m.tilt)).collect::<Vec<_>>();
        for ((side, offset), tilt) in setup.path.sides().iter().zip(&offsets).zip(&tilts) {
            let facing = side.outward[1].atan2(side.outward[0]).to_degrees();
            sides.push(format!(
                "{offset:+.3} um on the side that faces {facing:.1} deg, tilted {tilt:+.2} um/m, {word}"
            ));
        }
        let [width, height] = [offsets[0] + offsets[2], offsets[1] + offsets[3]];
        sizes.push(format!("width {width:+.3} um, height {height:+.3} um, {word}"));
        json_sides.insert(word.into(), json!({ "offsets": offsets, "tilts": tilts }));
        json_sizes.insert(word.into(), json!({ "width": width, "height": height }));
    }
    json_sides.insert("unit".into(), json!("um"));
    json_sides.insert("tilt_unit".into(), json!("um/m"));
    json_sizes.insert("unit".into(), json!("um"));
    let mut findings = vec![
        Finding {
            key: "sizes",
            label: "errors of sizes",
            text: super::findings::stacked(&sizes),
            json: json_sizes.into(),
        },
        Finding {
            key: "sides",
            label: "offset outwards",
            text: super::findings::stacked(&sides),
            json: json_sides.into(),
        },
        corners(contouring),
    ];
    findings.extend(waves(setup));
    findings
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
    (0..4).map(of).collect()
}

/// How near the tool comes to its corners, which it rounds by its lag.
fn corners(contouring: &Contouring) -> Finding {
    let setup = contouring.setup();
    let mut nearest = Vec::new();
    for direction in &setup.directions {
        nearest.extend(in_order(&setup.path, *direction).iter().map(|side| closest(contouring, *direction, side.from)));
    }
    let [low, high] =
        [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| 1e3 * nearest.iter().copied().reduce(pick).unwrap_or(0.0));
    let (before, after) = setup.corner(setup.feed);
    let range = if high - low < 5e-4 { format!("{high:.3} mm") } else { format!("{low:.3} to {high:.3} mm") };
    Finding {
        key: "corners",
        label: "corners",
        text: format!(
            "rounded: the tool passes them at {range}; left out are {:.3} mm before and {:.3} mm behind each",
            1e3 * before,
            1e3 * after
        ),
        json: json!({ "smallest": low, "largest": high, "before": 1e3 * before, "behind": 1e3 * after, "unit": "mm" }),
    }
}

/// The smallest distance of the tool from a corner, m.
pub fn closest(contouring: &Contouring, direction: Direction, corner: [f64; 2]) -> f64 {
    let setup = contouring.setup();
    let lap = Lap::new(&contouring.machine, direction, setup.feed);
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
fn waves(setup: &Setup) -> Option<Finding> {
    let (lead, Path::Rectangle { width, height, .. }) = (setup.lead?, setup.path) else { return None };
    let sides = setup.path.sides();
    let (mut words, mut list) = (Vec::new(), Vec::new());
    for (name, side, length) in [("width", sides[1], width), ("height", sides[0], height)] {
        for (axis, along) in AXES.iter().zip(side.along) {
            let wave = lead / along.abs();
            if wave < LONGEST * length {
                words.push(format!("{:.3} mm of {axis} along the {name}", 1e3 * wave));
                list.push(json!({ "axis": axis, "along": name, "length": 1e3 * wave }));
            }
        }
    }
    Some(Finding {
        key: "waves",
        label: "waves of a lead",
        text: words.join(", "),
        json: json!({ "unit": "mm", "list": list }),
    })
}
