//! The heated rod: the error follows the tolerance, and what must be the same is the same.

use fem::solve::heat::{HeatError, Pass, RodPiece, ToolTemperature, moving_source};

/// A length of steel shaft with a film of `loss` W/(m² K).
fn piece(length: f64, diameter: f64, loss: f64) -> RodPiece {
    let section = std::f64::consts::PI * diameter * diameter / 4.0;
    RodPiece {
        length,
        heat_capacity: 7850.0 * 470.0 * section,
        conductance: 50.0 * section,
        loss: loss * std::f64::consts::PI * diameter,
    }
}

fn stepped() -> Vec<RodPiece> {
    vec![piece(0.15, 0.04, 15.0), piece(0.3, 0.05, 15.0), piece(0.15, 0.04, 15.0)]
}

const PASS: Pass = Pass { from: 0.6, to: 0.0, speed: 2e-3 };

fn largest_difference(a: &ToolTemperature, b: &ToolTemperature, mirror: Option<f64>) -> f64 {
    let places = (0..=600).map(|i| 1e-3 * f64::from(i));
    places.map(|x| (a.rise_at(x) - b.rise_at(mirror.map_or(x, |length| length - x))).abs()).fold(0.0, f64::max)
}

fn largest(a: &ToolTemperature) -> f64 {
    (0..=600).map(|i| a.rise_at(1e-3 * f64::from(i))).fold(0.0, f64::max)
}

#[test]
fn the_error_keeps_to_the_tolerance_and_falls_with_it() {
    let best = moving_source(&stepped(), &PASS, 1e-7).unwrap();
    let mut before = f64::INFINITY;
    for tolerance in [1e-3, 1e-4, 1e-5] {
        let solution = moving_source(&stepped(), &PASS, tolerance).unwrap();
        let error = largest_difference(&solution, &best, None) / largest(&best);
        assert!(error <= tolerance, "{error:e} at {tolerance:e}");
        assert!(error < before);
        before = error;
    }
}

#[test]
fn a_mirrored_pass_and_a_divided_piece_change_nothing() {
    let tolerance = 1e-5;
    let solution = moving_source(&stepped(), &PASS, tolerance).unwrap();
    let size = largest(&solution);
    let mirrored = moving_source(&stepped(), &Pass { from: 0.0, to: 0.6, ..PASS }, tolerance).unwrap();
    assert!(largest_difference(&solution, &mirrored, Some(0.6)) <= 1e-9 * size);
    let mut divided = stepped();
    divided[1].length = 0.11;
    divided.insert(1, RodPiece { length: 0.19, ..divided[1] });
    let divided = moving_source(&divided, &PASS, tolerance).unwrap();
    assert!(largest_difference(&solution, &divided, None) <= 1e-6 * size);
}

#[test]
fn slow_and_fast_tools_short_and_long_rods() {
    for (length, speed) in [(0.6, 0.05e-3), (0.6, 50e-3), (0.02, 2e-3), (3.0, 1e-3)] {
        let rod = [piece(length, 0.04, 0.0)];
        let solution = moving_source(&rod, &Pass { from: length, to: 0.0, speed }, 1e-4).unwrap();
        // All the heat is still in the rod: at the end its mean rise is t/(ρcA·L), and the tool is where it
        // is hottest.
        let mean = length / speed / (rod[0].heat_capacity * length);
        assert!(solution.rise_at(0.0) >= mean && solution.rise_at(0.0).is_finite(), "{length} m at {speed} m/s");
        assert!(solution.rise_at(length) == 0.0);
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let good = stepped();
    for pieces in [vec![], vec![RodPiece { conductance: 0.0, ..good[0] }], vec![RodPiece { loss: f64::NAN, ..good[0] }]]
    {
        assert_eq!(moving_source(&pieces, &PASS, 1e-4).unwrap_err(), HeatError::Piece(0));
    }
    for pass in [Pass { speed: 0.0, ..PASS }, Pass { from: 0.7, ..PASS }, Pass { to: 0.6, ..PASS }] {
        assert_eq!(moving_source(&good, &pass, 1e-4).unwrap_err(), HeatError::Pass);
    }
}
