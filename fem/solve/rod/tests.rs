use std::f64::consts::PI;
use std::sync::Arc;

use super::{
    Energy, Film, Heater, History, Joint, Known, PointSource, Power, Pulse, Rod, RodError, RodPiece, RodSystem, Scheme,
    Sensor, Stepping, Swing, Track, lagged,
};
use crate::input::Record;

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
    let energy = system.run(&stepping, std::slice::from_ref(ambient), |time, nodes, switched| {
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
    let pieced = Rod { pieces: [body.pieces, vec![piece]].concat(), base: 0.3, joints, sources, ..Rod::default() };
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

/// Everything that a rod may have, two pieces, a heater, switches between steps.
fn furnished(recorded: bool) -> (Rod, Vec<History>) {
    let pieces = vec![
        RodPiece { length: 0.12, heat_capacity: 4000.0, conductance: 0.06, loss: 1.5 },
        RodPiece { length: 0.08, heat_capacity: 1000.0, conductance: 0.015, loss: 0.7 },
    ];
    let pulse = |from, to, factor| Pulse { from, to, factor };
    let on = vec![pulse(11.3, 1234.5, 1.0), pulse(2000.0, 2000.7, 3.0), pulse(2500.0, 4000.0, 0.8)];
    let heater = Some(Heater { heat_capacity: 40.0, contact: 0.8 });
    let record = |size: f64| {
        let point = |i: u32| [37.0 * f64::from(i), size * (f64::from(i * i) * 0.37).sin()];
        History::Record(Arc::new(Record::new((0..200).map(point).collect()).unwrap()))
    };
    let level = if recorded { record(5.0) } else { History::Constant(8.0) };
    let sources = vec![
        PointSource { at: 0.2, power: Power { level, on }, heater },
        PointSource { at: 0.0623, power: Power::switched(2.0, &[]), heater: None },
    ];
    let swing = Swing { size: 3.0, omega: 2.0 * PI / 5000.0, phase: 0.7 };
    let other = Swing { omega: 2.0 * PI / 900.0, ..swing };
    let mut ambient = vec![History::Constant(-4.0), History::Swing(swing), History::Swing(other)];
    ambient.extend(recorded.then(|| record(2.0)));
    let joints = vec![Joint { at: 0.1, conductance: 0.3 }, Joint { at: 0.12, conductance: 30.0 }];
    let films =
        vec![Film { ends: [0.03, 0.11], loss: 2.2, around: 1 }, Film { ends: [0.05, 0.2], loss: 0.4, around: 2 }];
    let around = vec![History::Sum(ambient), History::Constant(6.0), History::Swing(swing)];
    (Rod { pieces, base: 0.2, base_around: 2, films, joints, sources }, around)
}

/// Summed up on the contour comes what is stepped to, whatever the scheme, the input and the instrument, to
/// the error of the sum: 1e-10 of what the whole input would do to an insulated rod.
#[test]
fn a_sum_on_the_contour_is_what_steps_lead_to() {
    for (scheme, recorded) in SCHEMES.into_iter().flat_map(|scheme| [(scheme, false), (scheme, true)]) {
        let (rod, around) = furnished(recorded);
        let system = RodSystem::new(&rod, 0.004).unwrap();
        let stepping = Stepping { scheme, step: 10.0, end: 6000.0 };
        let instant = |probe| Sensor { probe, lag: 0.0 };
        let mut sensors: Vec<Sensor> = [0.0, 0.0777, 0.1, 0.15, 0.2].map(|x| instant(system.at(x))).into();
        sensors.push(instant(system.integral_to(0.2)));
        sensors.extend([3.0, 70.0, 2500.0].map(|lag| Sensor { probe: system.at(0.19), lag }));
        // On steps, between them, among the halved ones, at switches, at both ends, and in no order.
        let times = [6000.0, 0.0, 0.4, 3.7, 11.3, 12.0, 500.0, 777.7, 1234.5, 1235.0, 1300.0, 2000.3, 2503.0, 5000.0];
        let readings: Vec<(usize, f64)> = times.iter().flat_map(|t| (0..sensors.len()).map(|i| (i, *t))).collect();
        let known = Known::default();
        let stepped = system.stepped(&stepping, &around, &sensors, &readings).unwrap();
        // 9 W for as long as the run, in some 500 J/K.
        let error = 1e-10 * 9.0 * 6000.0 / 500.0;
        // The second time all is known.
        for _ in 0..2 {
            let summed = system.read(&stepping, &around, &sensors, &readings, &known).unwrap();
            for ((a, b), reading) in summed.iter().zip(&stepped).zip(&readings) {
                assert!((a - b).abs() < error, "{scheme:?}, {reading:?}: {a} and {b}");
            }
        }
    }
}

#[test]
fn without_heat_nothing_is_seen() {
    let system = RodSystem::new(&steel(0.0), 0.01).unwrap();
    let stepping = Stepping { scheme: Scheme::Sdirk2, step: 10.0, end: 3600.0 };
    let sensors = [0.0, 0.1].map(|x| Sensor { probe: system.at(x), lag: 0.0 });
    let ambient = History::Constant(5.0);
    let seen = system.read(&stepping, &[ambient], &sensors, &[(0, 60.0), (1, 0.0)], &Known::default());
    assert_eq!(seen.unwrap(), [0.0, 0.0]);
}

/// The same against the series, which knows of no elements and no steps.
#[test]
fn a_sum_on_the_contour_follows_the_series() {
    let rod = Rod { sources: at_end(8.0, vec![]), ..steel(0.0) };
    let system = RodSystem::new(&rod, 0.001).unwrap();
    let stepping = Stepping { scheme: Scheme::Sdirk2, step: 10.0, end: 3600.0 };
    let places = [0.0, 0.04, 0.1234, 0.19, 0.2];
    let sensors = places.map(|x| Sensor { probe: system.at(x), lag: 0.0 });
    for time in [300.0, 617.3, 1800.0, 3600.0] {
        let readings: Vec<(usize, f64)> = (0..places.len()).map(|i| (i, time)).collect();
        let found = system.read(&stepping, &[NONE], &sensors, &readings, &Known::default()).unwrap();
        for (place, found) in places.iter().zip(found) {
            let exact = heated_end(*place, time, 8.0);
            assert!((found - exact).abs() < 5e-4, "x = {place}, t = {time}: {found} and {exact}");
        }
    }
}

/// Every rate of a system is below its bound: the fastest wave of n equal elements with this capacity has
/// 4kA/ℓ² over ⅔ρcA, and at a free end with a heater or a joint more.
#[test]
fn rates_are_below_their_bound() {
    let (size, plain) = (0.01, 0.06 / 4000.0);
    let bound = |rod: &Rod| RodSystem::new(rod, size).unwrap().fastest();
    let own = bound(&steel(0.0));
    assert!((own / (6.0 * plain / (size * size)) - 1.0).abs() < 1e-9, "{own}");
    let heater = Some(Heater { heat_capacity: 0.01, contact: 2.0 });
    let sources = vec![PointSource { heater, ..at_end(8.0, vec![]).remove(0) }];
    assert!(bound(&Rod { sources, ..steel(0.0) }) >= 2.0 / 0.01, "a small heater follows at once");
    assert!(bound(&Rod { joints: vec![Joint { at: 0.1, conductance: 1e6 }], ..steel(0.0) }) > 1e6 / 40.0);
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

/// A fin whose base is held by something at +30 K, in a room that stays, and of which a length stands in another one
/// at −10 K. From theory: θ'' = m²(θ − a) on both lengths, kAθ' = G(θ − 30) at the base, no flow through the end.
#[test]
fn surroundings_by_length_and_of_the_base_settle_to_the_fin() {
    let (l, border, ka, g, h) = (0.2, 0.08, 0.06, 0.5, [1.5, 2.5]);
    let films =
        vec![Film { ends: [border, l], loss: h[1], around: 2 }, Film { ends: [0.0, border], loss: h[0], around: 0 }];
    let rod = Rod { base: g, base_around: 1, films, ..steel(0.0) };
    let system = RodSystem::new(&rod, 5e-4).unwrap();
    let around = [0.0, 30.0, -10.0].map(History::Constant);
    let stepping = Stepping { scheme: Scheme::BackwardEuler, step: 2000.0, end: 200_000.0 };
    let places = [0.0, 0.05, border, 0.15, l];
    let mut track = Track::new(places.len());
    let probes = places.map(|x| system.at(x));
    system.run(&stepping, &around, |time, nodes, s| track.push(time, s, probes.iter().map(|p| p.read(nodes)))).unwrap();
    // θ = A cosh m₁x + B sinh m₁x before the border, −10 + C cosh m₂(l − x) behind it.
    let [m1, m2] = h.map(|h| (h / ka).sqrt());
    let (c1, s1, c2, s2) =
        ((m1 * border).cosh(), (m1 * border).sinh(), (m2 * (l - border)).cosh(), (m2 * (l - border)).sinh());
    // B = G(A − 30)/(kA m₁); equal θ and equal θ' at the border give A.
    let b = |a: f64| g * (a - 30.0) / (ka * m1);
    let off = |a: f64| {
        let c = (a * c1 + b(a) * s1 + 10.0) / c2;
        m1 * (a * s1 + b(a) * c1) + m2 * c * s2
    };
    let a = -off(0.0) / (off(1.0) - off(0.0));
    let c = (a * c1 + b(a) * s1 + 10.0) / c2;
    for (x, values) in places.into_iter().zip(&track.values) {
        let exact = match x <= border {
            true => a * (m1 * x).cosh() + b(a) * (m1 * x).sinh(),
            false => -10.0 + c * (m2 * (l - x)).cosh(),
        };
        let found = track.at(values, 200_000.0);
        // Linear elements: (m·h)²/12 of the rises, and less.
        assert!((found - exact).abs() < 30.0 * (m2 * 5e-4).powi(2) / 12.0, "{x}: {found} and {exact}");
    }
}
