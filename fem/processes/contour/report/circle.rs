//! Figures of a circle: deviations by ISO 230-4, and diameters.

use std::f64::consts::TAU;

use super::super::path::Direction;
use super::super::rows;
use super::super::setup::Setup;
use crate::process::{Datum, Failure, Figure, Forward};
use crate::units::{ANGLE, MICRO};

/// The least-squares circle of evenly spaced deviations, m.
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

/// The figures of a circle; `deviations` direction by direction, m.
pub fn figures(setup: &Setup, forward: &Forward, deviations: &[f64]) -> Result<Vec<Figure>, Failure> {
    let angles = rows::angles(setup, setup.directions[0]);
    let paths: Vec<(&[f64], &[f64])> = deviations.chunks(angles.len()).map(|d| (&*angles, d)).collect();
    let mut figures = iso_230_4(&setup.directions, &paths);
    figures.push(diameters(setup, forward)?);
    Ok(figures)
}

/// Circular deviation G, radial deviation F and mean bidirectional radial deviation D by ISO 230-4; G about
/// the least-squares circle, F and D from the programmed circle about the programmed centre.
fn iso_230_4(directions: &[Direction], paths: &[(&[f64], &[f64])]) -> Vec<Figure> {
    let both = LeastSquares::of(paths);
    let mut circular = Figure::new("circular_deviation", "circular deviation");
    let mut radial = Figure::new("radial_deviation", "radial deviation");
    let (mut g, mut f) = (Vec::new(), Vec::new());
    for (direction, path) in directions.iter().zip(paths) {
        let word = direction.word();
        let (range, high, low) = (LeastSquares::of(&[*path]).range(), highest(path.1), lowest(path.1));
        g.push(format!("G {:.3} {word}", MICRO.shown(range)));
        f.push(format!("F {:+.3} to {:+.3} {word}", MICRO.from_si(low), MICRO.shown(high)));
        circular = circular.quantity(format!("G_{word}"), MICRO, range);
        radial = radial.quantity(format!("F_max_{word}"), MICRO, high).quantity(format!("F_min_{word}"), MICRO, low);
    }
    if paths.len() > 1 {
        g.push(format!("G(b) {:.3} both ways", MICRO.shown(both.range())));
        circular = circular.quantity("G_b", MICRO, both.range());
    }
    let (name, key) = if paths.len() > 1 { ("D", "D") } else { ("one way only", "mean") };
    let mean = Figure::new("mean_radial_deviation", "mean radial deviation")
        .line(format!("{:+.3} ({name})", MICRO.shown(both.mean)))
        .quantity(key, MICRO, both.mean);
    vec![circular.line(g.join(", ")), radial.line(f.join(", ")), mean]
}

/// Errors of the diameters along the axes and at 45° between them.
fn diameters(setup: &Setup, forward: &Forward) -> Result<Figure, Failure> {
    const DEGREES: [f64; 8] = [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0];
    let mut figure = Figure::new("diameters", "errors of diameters").unit("unit", MICRO).unit("angle_unit", ANGLE);
    for direction in &setup.directions {
        let angles = DEGREES.map(|a| a.to_radians().rem_euclid(TAU)).to_vec();
        let radial = forward.observe(&rows::lap(setup, *direction, angles))?;
        let errors = [0, 1, 2, 3].map(|i| radial[i] + radial[i + 4]);
        let [x, up, y, down] = errors.map(|e| MICRO.from_si(e));
        let word = direction.word();
        figure = figure
            .line(format!("{x:+.3} um at 0, {up:+.3} at 45, {y:+.3} at 90, {down:+.3} at 135 deg, {word}"))
            .entry(word, Datum::Quantities(MICRO, errors.to_vec()));
    }
    Ok(figure.entry("angles", Datum::Quantities(ANGLE, DEGREES[..4].iter().map(|a| ANGLE.to_si(*a)).collect())))
}
