use std::f64::consts::PI;
use std::sync::Arc;

use super::{
    Energy, Heater, History, Joint, PointSource, Power, Rod, RodError, RodPiece, RodSystem, Scheme, Stepping, Track,
    lagged,
};

/// Rounding of flows between elements, kA/ℓ·θ, which are some hundred times what comes in, over some hundred
/// steps.
const ROUNDING: f64 = 1e-12;
const SCHEMES: [Scheme; 3] = [Scheme::CrankNicolson, Scheme::BackwardEuler, Scheme::Sdirk2];

/// ρcA = 4000 J/(m K), kA = 0.06 W m/K over 0.2 m.
fn steel(loss: f64) -> Rod {
    let piece = RodPiece { length: 0.2, heat_capacity: 4000.0, conductance: 0.06, loss };
    Rod { pieces: vec![piece], ..Rod::default() }
}

fn at_end(power: f64, on: Vec<[f64; 2]>) -> Vec<PointSource> {
    vec![PointSource { at: 0.2, power: Power::switched(power, &on), heater: None }]
}

fn followed(rod: &Rod, size: f64, stepping: Stepping, ambient: &History, places: &[f64]) -> (Track, Energy) {
    let system = RodSystem::new(rod, size).unwrap();
    let probes: Vec<_> =
        places.iter().map(|x| system.at(*x)).chain(std::iter::once(system.integral_to(rod.length()))).collect();
    let mut track = Track::new(probes.len());
    let energy = system.run(&stepping, ambient, |time, nodes, switched| {
        track.push(time, switched, probes.iter().map(|p| p.read(nodes)));
    });
    (track, energy.unwrap())
}

const NONE: History = History::Constant(0.0);

/// Rise at x of a rod of length l, insulated but for the flux Q into x = l (Carslaw and Jaeger 1959, 3.8
/// (3)).
fn heated_end(x: f64, time: f64, power: f64) -> f64 {
    let (l, alpha, k) = (0.2, 0.06 / 4000.0, 0.06);
    let series: f64 = (1..400)
        .map(|n| {
            let n = f64::from(n);
            let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
            sign / (n * n) * (-alpha * (n * PI / l).powi(2) * time).exp() * (n * PI * x / l).cos()
        })
        .sum();
    power * time / (4000.0 * l) + power * l / k * ((3.0 * x * x - l * l) / (6.0 * l * l) - 2.0 / (PI * PI) * series)
}

#[test]
fn a_heated_end_follows_the_series() {
    let rod = Rod { sources: at_end(8.0, vec![]), ..steel(0.0) };
    let stepping = Stepping { scheme: Scheme::Sdirk2, step: 10.0, end: 3600.0 };
    let places = [0.0, 0.04, 0.1234, 0.19, 0.2];
    let (track, energy) = followed(&rod, 0.001, stepping, &NONE, &places);
    for time in [300.0, 617.3, 1800.0, 3600.0] {
        for (place, values) in places.iter().zip(&track.values) {
            let (found, exact) = (track.at(values, time), heated_end(*place, time, 8.0));
            assert!((found - exact).abs() < 5e-4, "x = {place}, t = {time}: {found} and {exact}");
        }
        let whole = track.at(&track.values[places.len()], time);
        assert!((whole * 4000.0 / (8.0 * time) - 1.0).abs() < 1e-9, "all heat stays inside");
    }
    assert!(energy.imbalance().abs() < ROUNDING, "{energy:?}");
}

/// Halving elements and steps quarters the error of second-order schemes and halves that of backward Euler.
#[test]
fn errors_fall_with_the_order_of_the_scheme() {
    let rod = Rod { sources: at_end(8.0, vec![]), ..steel(0.0) };
    for (scheme, order) in [(Scheme::CrankNicolson, 2.0), (Scheme::BackwardEuler, 1.0), (Scheme::Sdirk2, 2.0)] {
        let error = |level: i32| {
            let halves = 0.5f64.powi(level);
            let stepping = Stepping { scheme, step: 100.0 * halves, end: 800.0 };
            let (track, _) = followed(&rod, 0.01 * halves, stepping, &NONE, &[0.05]);
            track.at(&track.values[0], 800.0) - heated_end(0.05, 800.0, 8.0)
        };
        let rate = (error(2) / error(3)).abs().log2();
        assert!((rate - order).abs() < 0.25, "{scheme:?}: order {rate}");
    }
}

/// Sinusoidal surroundings of a rod with the same loss everywhere: a lumped body.
#[test]
fn surroundings_swing_a_lumped_body() {
    let loss = 2.0;
    let omega = 2.0 * PI / 7200.0;
    let ambient = History::Function(Arc::new(move |t: f64| 3.0 * (omega * t).sin()));
    let stepping = Stepping { scheme: Scheme::Sdirk2, step: 20.0, end: 9000.0 };
    let (track, energy) = followed(&steel(loss), 0.01, stepping, &ambient, &[0.07]);
    let beta = loss / 4000.0;
    let exact = |t: f64| {
        3.0 * beta / (beta * beta + omega * omega)
            * (beta * (omega * t).sin() - omega * (omega * t).cos() + omega * (-beta * t).exp())
    };
    for time in [1000.0, 4321.0, 9000.0] {
        let found = track.at(&track.values[0], time);
        assert!((found - exact(time)).abs() < 1e-4, "{found} and {}", exact(time));
    }
    assert!(energy.imbalance().abs() < ROUNDING);
}

/// Steady: a base that loses, a joint that holds heat back, a source at the end.
#[test]
fn joint_and_base_resist_in_series() {
    let joint = Joint { at: 0.0777, conductance: 0.5 };
    let rod = Rod { base: 0.25, joints: vec![joint], sources: at_end(2.0, vec![]), ..steel(0.0) };
    let stepping = Stepping { scheme: Scheme::BackwardEuler, step: 1e7, end: 1e9 };
    let (track, energy) = followed(&rod, 0.01, stepping, &NONE, &[0.0, 0.0777, 0.07771, 0.15]);
    let expected = [8.0, 8.0 + 2.0 * 0.0777 / 0.06, 12.0 + 2.0 * 0.07771 / 0.06, 12.0 + 2.0 * 0.15 / 0.06];
    for (values, expected) in track.values.iter().zip(expected) {
        assert!((track.at(values, 1e9) / expected - 1.0).abs() < 1e-9);
    }
    assert!(energy.imbalance().abs() < ROUNDING);
}

#[test]
fn heat_is_balanced_and_switched_exactly() {
    let on = vec![[11.3, 1234.5], [2000.0, 2000.7]];
    let joints = vec![Joint { at: 0.1, conductance: 0.5 }];
    let rod = Rod { base: 0.1, joints, sources: at_end(8.0, on), ..steel(1.5) };
    for scheme in SCHEMES {
        let stepping = Stepping { scheme, step: 60.0, end: 3000.0 };
        let ambient = History::Function(Arc::new(|t: f64| (t / 500.0).sin()));
        let (track, energy) = followed(&rod, 0.003, stepping, &ambient, &[0.1]);
        assert!(energy.imbalance().abs() < ROUNDING, "{scheme:?}: {energy:?}");
        assert!((energy.supplied / (8.0 * (1223.2 + 0.7)) - 1.0).abs() < 1e-12, "{scheme:?}: {energy:?}");
        for time in [11.3, 1234.5, 2000.0, 2000.7, 3000.0] {
            assert!(track.times.contains(&time), "{time}");
        }
    }
}

/// A heater is a short piece that conducts perfectly, behind a joint, and is solved for without one.
#[test]
fn a_heater_is_a_piece_behind_a_joint() {
    let on = vec![[0.0, 400.0], [700.0, 900.0]];
    let (heat_capacity, contact, body) = (40.0, 0.8, steel(1.5));
    let own = PointSource { heater: Some(Heater { heat_capacity, contact }), ..at_end(8.0, on.clone()).remove(0) };
    let heater = Rod { base: 0.3, sources: vec![own], ..body.clone() };
    let piece = RodPiece { length: 1e-3, heat_capacity: heat_capacity / 1e-3, conductance: 1e4, loss: 0.0 };
    let sources = vec![PointSource { at: 0.201, ..at_end(8.0, on).remove(0) }];
    let joints = vec![Joint { at: 0.2, conductance: contact }];
    let pieced = Rod { pieces: [body.pieces, vec![piece]].concat(), base: 0.3, joints, sources };
    let places = [0.0, 0.13, 0.2];
    for scheme in SCHEMES {
        let stepping = Stepping { scheme, step: 20.0, end: 1200.0 };
        let (found, energy) = followed(&heater, 0.004, stepping, &NONE, &places);
        let (expected, same) = followed(&pieced, 0.004, stepping, &NONE, &places);
        for (found, expected) in found.values[..3].iter().zip(&expected.values) {
            let largest = expected.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            // The piece of 1 mm has a resistance of 1e-7 K/W, against the joint's 1.25 K/W.
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6 * largest), "{scheme:?}");
        }
        assert!(energy.imbalance().abs() < ROUNDING, "{scheme:?}: {energy:?}");
        assert!((energy.stored / same.stored - 1.0).abs() < 1e-6, "what the heater keeps is stored");
    }
}

/// A ramp v = s·t seen through a lag: s·(t − τ(1 − e^(−t/τ))).
#[test]
fn a_lag_follows_a_ramp() {
    let times: Vec<f64> = (0..40).map(|i| f64::from(i * i)).collect();
    let values: Vec<f64> = times.iter().map(|t| 0.02 * t).collect();
    for (shown, t) in lagged(&times, &values, 130.0).iter().zip(&times) {
        assert!((shown - 0.02 * (t + 130.0 * (-t / 130.0).exp_m1())).abs() < 1e-12);
    }
}

#[test]
fn what_is_no_rod_is_refused() {
    let refused = [
        (Rod::default(), RodError::Piece(0)),
        (Rod { base: -1.0, ..steel(0.0) }, RodError::Value("the conductance of the base (W/K)", -1.0)),
        (
            Rod { joints: vec![Joint { at: 0.1, conductance: 0.0 }], ..steel(0.0) },
            RodError::Value("the conductance of a joint (W/K)", 0.0),
        ),
        (
            Rod {
                sources: vec![PointSource { at: 0.3, power: Power::switched(1.0, &[]), heater: None }],
                ..steel(0.0)
            },
            RodError::Value("the place of a source (m)", 0.3),
        ),
    ];
    for (rod, error) in refused {
        assert_eq!(RodSystem::new(&rod, 0.01).unwrap_err(), error);
    }
}
