//! What circular tests tell of a circle: deviations by ISO 230-4, and diameters.

use std::f64::consts::TAU;

use serde_json::json;

use super::job::Contouring;
use super::machine::Lap;
use super::observe;
use super::path::Direction;
use crate::process::Finding;

/// What the least-squares circle of evenly spaced deviations says. m.
struct LeastSquares {
    /// Its radius less the programmed one.
    mean: f64,
    /// The deviations less the circle.
    left: Vec<f64>,
}

impl LeastSquares {
    /// Of paths (angle, deviation) all around, each evenly spaced, taken together.
    fn of(paths: &[(&[f64], &[f64])]) -> Self {
        let count = paths.iter().map(|p| p.0.len()).sum::<usize>() as f64;
        let sum = |shape: fn(f64) -> f64| {
            let of = |(angles, deviations): &(&[f64], &[f64])| {
                angles.iter().zip(*deviations).map(|(a, d)| d * shape(*a)).sum::<f64>()
            };
            paths.iter().map(of).sum::<f64>() / count
        };
        let (mean, x, y) = (sum(|_| 1.0), 2.0 * sum(f64::cos), 2.0 * sum(f64::sin));
        let of = |(angles, deviations): &(&[f64], &[f64])| -> Vec<f64> {
            angles.iter().zip(*deviations).map(|(a, d)| d - mean - x * a.cos() - y * a.sin()).collect()
        };
        Self { mean, left: paths.iter().flat_map(of).collect() }
    }

    fn range(&self) -> f64 {
        highest(&self.left) - lowest(&self.left)
    }
}

fn highest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

fn lowest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The findings of a circle; `deviations` direction by direction, m.
pub fn findings(contouring: &Contouring, deviations: &[f64]) -> Vec<Finding> {
    let setup = contouring.setup();
    let angles = observe::angles(setup, setup.directions[0]);
    let paths: Vec<(&[f64], &[f64])> = deviations.chunks(angles.len()).map(|d| (&*angles, d)).collect();
    let mut findings = iso_230_4(&setup.directions, &paths);
    findings.push(diameters(contouring));
    findings
}

/// Circular deviation G, radial deviation F and mean bidirectional radial deviation D by ISO 230-4; G about the least-squares circle, F and D from the
/// programmed circle about the programmed centre.
fn iso_230_4(directions: &[Direction], paths: &[(&[f64], &[f64])]) -> Vec<Finding> {
    let both = LeastSquares::of(paths);
    let (mut circular, mut radial) = (Vec::new(), Vec::new());
    let (mut g, mut f) = (serde_json::Map::new(), serde_json::Map::new());
    for (direction, path) in directions.iter().zip(paths) {
        let range = 1e6 * LeastSquares::of(&[*path]).range();
        let [high, low] = [highest(path.1), lowest(path.1)].map(|d| 1e6 * d);
        circular.push(format!("G {range:.3} um {}", direction.word()));
        radial.push(format!("F {low:+.3} to {high:+.3} um {}", direction.word()));
        g.insert(format!("G_{}", direction.word()), json!(range));
        f.insert(format!("F_max_{}", direction.word()), json!(high));
        f.insert(format!("F_min_{}", direction.word()), json!(low));
    }
    if paths.len() > 1 {
        let range = 1e6 * both.range();
        circular.push(format!("G(b) {range:.3} um both ways"));
        g.insert("G_b".into(), json!(range));
    }
    let mean = 1e6 * both.mean;
    let (name, key) = if paths.len() > 1 { ("D", "D") } else { ("one way only", "mean") };
    g.insert("unit".into(), json!("um"));
    f.insert("unit".into(), json!("um"));
    vec![
        Finding { key: "circular_deviation", label: "circular deviation", text: circular.join(", "), json: g.into() },
        Finding { key: "radial_deviation", label: "radial deviation", text: radial.join(", "), json: f.into() },
        Finding {
            key: "mean_radial_deviation",
            label: "mean radial deviation",
            text: format!("{mean:+.3} um ({name})"),
            json: json!({ key: mean, "unit": "um" }),
        },
    ]
}

/// Diameters along the axes and at 45° between them.
fn diameters(contouring: &Contouring) -> Finding {
    let setup = contouring.setup();
    let (mut lines, mut json) = (Vec::new(), serde_json::Map::new());
    for direction in &setup.directions {
        let lap = Lap::new(&contouring.machine, *direction, setup.feed);
        let at = |degrees: f64| lap.deviation(&setup.path.at(degrees.to_radians().rem_euclid(TAU)));
        let errors = [0.0, 45.0, 90.0, 135.0].map(|a| 1e6 * (at(a) + at(a + 180.0)));
        let [x, up, y, down] = errors;
        lines.push(format!(
            "{x:+.3} um at 0, {up:+.3} at 45, {y:+.3} at 90, {down:+.3} at 135 deg, {}",
            direction.word()
        ));
        json.insert(direction.word().into(), json!(errors));
    }
    json.insert("angles".into(), json!([0, 45, 90, 135]));
    json.insert("angle_unit".into(), json!("deg"));
    json.insert("unit".into(), json!("um"));
    Finding {
        key: "diameters",
        label: "errors of diameters",
        text: super::findings::stacked(&lines),
        json: json.into(),
    }
}
