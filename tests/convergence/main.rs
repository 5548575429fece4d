//! How errors grow and shrink with the number of elements.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod heat;

use fem::element::BeamPiece;
use fem::solve::{Hold, Shaft};

const LENGTH: f64 = 0.6;
const EI: f64 = 26.4e3;
const GA: f64 = 9e7;

fn shaft(elements: usize, hold: Hold, tailstock: bool) -> Shaft {
    let piece = BeamPiece { length: LENGTH, flexural_rigidity: EI, shear_rigidity: GA };
    Shaft { pieces: piece.divided(elements).collect(), hold, tailstock, rests: Vec::new() }
}

/// Largest relative error of the compliance at `elements` positions against the closed form.
fn error(elements: usize, hold: Hold, tailstock: bool, exact: impl Fn(f64) -> f64) -> f64 {
    // Away from the supports, where the compliance and with it the relative error has no meaning.
    let positions: Vec<f64> = (1..elements).map(|i| LENGTH * i as f64 / elements as f64).collect();
    let condensed = shaft(elements, hold, tailstock).condense(&positions).unwrap();
    positions.iter().zip(&condensed.compliance).map(|(&x, c)| (c / exact(x) - 1.0).abs()).fold(0.0, f64::max)
}

/// Beams are exact at any length, so that only round-off is left; it must not grow faster than the number
/// of elements. The sweep's sums of positive terms promise at most a few roundings (2e-16) per element.
#[test]
fn round_off_stays_small_however_many_elements() {
    let between = |x: f64| {
        let b = LENGTH - x;
        x * x * b * b / (3.0 * EI * LENGTH) + x * b / (LENGTH * GA)
    };
    let cantilever = |x: f64| x.powi(3) / (3.0 * EI) + x / GA;
    let propped = |a: f64| {
        let reach = a * a * (3.0 * LENGTH - a) / (6.0 * EI) + a / GA;
        cantilever(a) - reach * reach / (LENGTH.powi(3) / (3.0 * EI) + LENGTH / GA)
    };
    for (elements, allowed) in [(10, 1e-13), (1000, 1e-12), (100_000, 1e-10)] {
        let centres = error(elements, Hold::Free, true, between);
        let chuck = error(elements, Hold::Compliance(0.0), false, cantilever);
        println!("{elements} elements: {centres:.1e} between centres, {chuck:.1e} in a chuck");
        assert!(centres <= allowed && chuck <= allowed, "{elements}: {centres:e}, {chuck:e}");
    }
    // The closed form itself subtracts near the centre, and is no reference there: 1000 elements, inner half.
    let positions: Vec<f64> = (250..750).map(|i| LENGTH * f64::from(i) / 1000.0).collect();
    let condensed = shaft(1000, Hold::Compliance(0.0), true).condense(&positions).unwrap();
    for (&x, c) in positions.iter().zip(&condensed.compliance) {
        assert!((c / propped(x) - 1.0).abs() < 1e-12, "{x}");
    }
}

/// A position between nodes is as exact as one on a node.
#[test]
fn any_position_is_exact() {
    let coarse = shaft(3, Hold::Free, true);
    let fine = shaft(997, Hold::Free, true);
    let positions: Vec<f64> = (0..=500).map(|i| LENGTH * f64::from(i) / 500.0).collect();
    let (a, b) = (coarse.condense(&positions).unwrap(), fine.condense(&positions).unwrap());
    for (a, b) in a.compliance.iter().zip(&b.compliance) {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} and {b}");
    }
}
