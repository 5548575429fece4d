//! The heated rod against closed forms.

use std::f64::consts::PI;

use generator::thermal::rod::{Heater, Rod, histories};

/// A steel rod of 200 mm and Ø20, heated by 5 W at its end.
fn rod() -> Rod {
    Rod {
        segments: vec![(0.2, 0.02)],
        conductivity: 50.0,
        capacity: 7850.0 * 470.0,
        convection: 0.0,
        base: 0.0,
        joint: None,
        sources: vec![(0.2, 5.0, 0.0, 3000.0)],
        heater: None,
        friction: Vec::new(),
        surroundings: (0.0, 1.0, 0.0),
        apart: 0.0,
    }
}

const AREA: f64 = PI * 1e-4;

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() < tolerance, "{a} against {b}");
}

/// Carslaw and Jaeger: an insulated bar with a constant flux F at one end, T = F/(kL)[κt + (3x²−L²)/6 −
/// (2L²/π²) Σ (−1)ⁿ/n² e^(−κn²π²t/L²) cos(nπx/L)].
#[test]
fn flux_into_an_insulated_bar() {
    let (l, k, kappa, flux) = (0.2, 50.0, 50.0 / (7850.0 * 470.0), 5.0 / AREA);
    let exact = |x: f64, t: f64| {
        let term = |n: f64| {
            (-1f64).powi(n as i32) / (n * n) * (-kappa * (n * PI / l).powi(2) * t).exp() * (n * PI * x / l).cos()
        };
        let series: f64 = (1..400).map(|n| term(f64::from(n))).sum();
        flux / (k * l) * (kappa * t + (3.0 * x * x - l * l) / 6.0 - 2.0 * l * l / (PI * PI) * series)
    };
    let (at, times) = ([0.04, 0.12, 0.19], [300.0, 600.0, 1800.0]);
    for ((places, integral), t) in histories(&rod(), &at, &times).iter().zip(times) {
        at.iter().zip(places).for_each(|(x, found)| close(*found, exact(*x, t), 2e-3));
        // All heat is in the rod.
        close(integral * 7850.0 * 470.0 * AREA, 5.0 * t, 1e-9 * 5.0 * t);
    }
    // The source is switched off.
    let after = &histories(&rod(), &at, &[20_000.0])[0];
    close(after.0[0], 15_000.0 / (7850.0 * 470.0 * AREA * 0.2), 1e-3);
}

/// A short stout rod is a lump: two lumps that a contact joins, one of which is heated, differ by P C_b/(G (C + C_b))
/// once 1 − e^(−G(1/C + 1/C_b)t) has settled, and hold all of the heat.
#[test]
fn a_heater_at_an_end_and_between() {
    let (power, held, contact) = (5.0, 40.0, 0.5);
    for at in [0.02, 0.0113] {
        let rod = Rod {
            segments: vec![(0.02, 0.03)],
            conductivity: 5e4,
            sources: vec![(at, power, 0.0, f64::INFINITY)],
            heater: Some(Heater { capacity: held, contact }),
            ..rod()
        };
        let lump = rod.capacity * 0.25 * PI * 0.03 * 0.03 * 0.02;
        let rate = contact * (1.0 / held + 1.0 / lump);
        for time in [30.0f64, 200.0, 2000.0] {
            let behind = power / held / rate * (1.0 - (-rate * time).exp());
            let exact = (power * time - held * behind) / (held + lump);
            let found = &histories(&rod, &[0.01], &[time])[0].0;
            // A method of second order in steps of up to 12 s.
            close(found[0], exact, (12.0 * rate).powi(2) / 12.0 * held * behind / (held + lump));
        }
    }
}

/// A fin: T = Q cosh(mx)/(kAm sinh(mL)), m² = hp/(kA), long after.
#[test]
fn a_fin_in_the_steady_state() {
    let mut rod = rod();
    (rod.convection, rod.sources[0].3) = (20.0, f64::INFINITY);
    let m = (20.0 * PI * 0.02 / (50.0 * AREA)).sqrt();
    for (found, x) in histories(&rod, &[0.05, 0.15], &[60_000.0])[0].0.iter().zip([0.05, 0.15]) {
        close(*found, 5.0 * (m * x).cosh() / (50.0 * AREA * m * (m * 0.2).sinh()), 2e-3);
    }
}

/// Long after, all the heat goes through joint and base: steps of Q/(hA) and Q/G, and a slope of Q/(kA).
#[test]
fn a_joint_and_a_base() {
    let mut rod = rod();
    (rod.base, rod.joint, rod.sources[0].3) = (0.2, Some((0.1, 3000.0)), f64::INFINITY);
    let found = &histories(&rod, &[0.03, 0.17], &[200_000.0])[0].0;
    let slope = 5.0 / (50.0 * AREA);
    close(found[0], 5.0 / 0.2 + 0.03 * slope, 1e-3);
    close(found[1], 5.0 / 0.2 + 0.17 * slope + 5.0 / (3000.0 * AREA), 1e-3);
}

/// A short stout rod is a lump: C T' = G (T_a − T), T_a = A [sin(ωt + φ) − sin φ], solved by variation of
/// constants.
#[test]
fn surroundings_that_drift() {
    let mut rod = rod();
    rod.segments = vec![(0.02, 0.05)];
    (rod.convection, rod.sources) = (10.0, Vec::new());
    rod.surroundings = (3.0, 1e-3, 0.7);
    let tau = 7850.0 * 470.0 * 0.05 / 4.0 / 10.0;
    let (omega, phase) = (1e-3, 0.7f64);
    let steady = |t: f64| {
        3.0 * ((omega * t + phase).sin() - omega * tau * (omega * t + phase).cos()) / (1.0 + (omega * tau).powi(2))
    };
    let exact = |t: f64| {
        let settled = 3.0 * phase.sin();
        steady(t) - settled + (settled - steady(0.0)) * (-t / tau).exp()
    };
    let times = [600.0, 3000.0, 9000.0];
    for ((places, _), t) in histories(&rod, &[0.01], &times).iter().zip(times) {
        close(places[0], exact(t), 2e-3);
    }
}

/// Heat that comes in on either side of a joint, close to it, and a reading close to it: the joint parts them, and
/// long after all heat goes through the base. Two heaters pass on all that they get.
#[test]
fn sources_on_either_side_of_a_joint() {
    let mut rod = rod();
    (rod.base, rod.joint, rod.sources[0].3) = (0.4, Some((0.1, 2000.0)), f64::INFINITY);
    rod.sources.push((0.0999, 2.0, 0.0, f64::INFINITY));
    rod.friction = vec![(0.1001, 1.0)];
    rod.heater = Some(Heater { capacity: 30.0, contact: 0.7 });
    rod.apart = -6.0;
    let at = [0.05, 0.0999, 0.1001, 0.15];
    let found = &histories(&rod, &at, &[150_000.0])[0].0;
    let (base, slope) = (-6.0 + 8.0 / 0.4, 1.0 / (50.0 * AREA));
    close(found[0], base + 0.05 * 8.0 * slope, 2e-3);
    close(found[1], base + 0.0999 * 8.0 * slope, 2e-3);
    let beyond = base + (0.0999 * 8.0 + 0.0002 * 6.0) * slope + 6.0 / (2000.0 * AREA);
    close(found[2], beyond, 2e-3);
    close(found[3], beyond + 0.0499 * 5.0 * slope, 2e-3);
}

/// A lump that cools in a room that drifts: C T' = G (T_a − T) from T_a − T = −30.
#[test]
fn a_warm_body_in_a_drifting_room() {
    let mut rod = rod();
    rod.segments = vec![(0.02, 0.05)];
    (rod.convection, rod.sources, rod.apart) = (10.0, Vec::new(), -30.0);
    let tau = 7850.0 * 470.0 * 0.05 / 4.0 / 10.0;
    for t in [900.0f64, 4000.0, 9000.0] {
        let found = &histories(&rod, &[0.01], &[t])[0].0;
        close(found[0], -30.0 * (1.0 - (-t / tau).exp()), 3e-3);
    }
}
