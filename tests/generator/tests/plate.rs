//! The heated plate against closed forms, benchmarks and balances.

use std::f64::consts::PI;

use generator::thermal::plate::course::Piece;
use generator::thermal::plate::series::{HOLDS, Place, Plate, Reading, Side, rises};
use generator::thermal::plate::strip::Strip;

const CAPACITY: f64 = 7850.0 * 470.0;

/// A steel plate of 80 by 30 mm, insulated.
fn plate() -> Plate {
    Plate { size: [0.08, 0.03], conductivity: 50.0, capacity: CAPACITY, films: [0.0; 4], faces: 0.0, heat: Vec::new() }
}

fn always(constant: f64) -> Piece {
    Piece::constant(constant, 0.0, f64::INFINITY)
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() < tolerance, "{a} against {b}");
}

/// Carslaw and Jaeger: T = F/(kH)[κt + (3y²−H²)/6 − (2H²/π²) Σ (−1)ⁿ/n² e^(−κn²π²t/H²) cos(nπy/H)] under a flux
/// F on top, also on what is heated, and after it is switched off the difference of two.
#[test]
fn flux_into_an_insulated_plate() {
    let (height, kappa, flux) = (0.03, 50.0 / CAPACITY, 20e3);
    let exact = |y: f64, t: f64| {
        let term = |n: f64| {
            (-1f64).powi(n as i32) / (n * n)
                * (-kappa * (n * PI / height).powi(2) * t).exp()
                * (n * PI * y / height).cos()
        };
        let series: f64 = (1..400).map(|n| term(f64::from(n))).sum();
        let shape = (3.0 * y * y - height * height) / 6.0 - 2.0 * height * height / (PI * PI) * series;
        flux / (50.0 * height) * (kappa * t + shape)
    };
    let mut plate = plate();
    plate.heat = vec![(Place::Edge(Side::Top), Piece::constant(flux, 0.0, 60.0))];
    for y in [0.0, 0.011, 0.03] {
        let found = rises(&plate, &[Reading::Point(0.02, y), Reading::Mean], &[20.0, 60.0, 90.0], 0.0);
        close(found[0][0], exact(y, 20.0), 1e-6);
        close(found[1][0], exact(y, 60.0), 1e-6);
        close(found[2][0], exact(y, 90.0) - exact(y, 30.0), 1e-6);
        close(found[2][1], flux * 60.0 / (CAPACITY * height), 1e-9);
    }
}

/// NAFEMS T4: 0.6 by 1.0 m, k = 52, 100 degC held below, a film of 750 to 0 degC on the right and above: 18.25 degC
/// at (0.6, 0.2).
#[test]
fn nafems_t4() {
    let mut plate = plate();
    (plate.size, plate.conductivity, plate.films) = ([0.6, 1.0], 52.0, [0.0, 750.0, HOLDS, 750.0]);
    plate.heat = vec![(Place::Edge(Side::Bottom), always(100.0 * HOLDS))];
    let found = &rises(&plate, &[Reading::Point(0.6, 0.2)], &[1e6], 0.0)[0];
    close(found[0], 18.25, 0.01);
}

/// NAFEMS T3: a bar of 0.1 m at zero at one end and 100 sin(πt/40) at the other: 36.60 degC 20 mm from that after
/// 32 s.
#[test]
fn nafems_t3() {
    let mut plate = plate();
    (plate.size, plate.conductivity, plate.capacity) = ([0.1, 0.02], 35.0, 7200.0 * 440.5);
    plate.films = [HOLDS, HOLDS, 0.0, 0.0];
    let course = Piece { sine: 100.0 * HOLDS, frequency: PI / 40.0, ..always(0.0) };
    plate.heat = vec![(Place::Edge(Side::Right), course)];
    close(rises(&plate, &[Reading::Point(0.08, 0.01)], &[32.0], 0.0)[0][0], 36.60, 0.01);
}

/// A lump that is heated in a drifting room and read through a lag, followed in small steps by the classical method
/// of Runge and Kutta.
#[test]
fn a_lump_in_a_drifting_room_read_late() {
    let mut plate = plate();
    (plate.conductivity, plate.films, plate.faces) = (5e6, [20.0; 4], 2.0 * 20.0 / 0.012);
    let room = Piece { constant: -2.0, cosine: 2.0, sine: 1.0, frequency: 2e-3, ..always(0.0) };
    let sides = [Side::Left, Side::Right, Side::Bottom, Side::Top];
    plate.heat = sides.map(|side| (Place::Edge(side), room.times(20.0))).to_vec();
    plate.heat.push((Place::Faces, room.times(plate.faces)));
    let [length, height] = plate.size;
    plate.heat.push((Place::Section(0.03), Piece::constant(9e3, 100.0, 900.0)));
    let loss = (plate.faces * length * height + 20.0 * 2.0 * (length + height)) / (CAPACITY * length * height);
    let source = |t: f64| if (100.0..900.0).contains(&t) { 9e3 / (CAPACITY * length) } else { 0.0 };
    let lag = 150.0;
    let slope = |t: f64, on: f64, [body, shown]: [f64; 2]| {
        let around = -2.0 + 2.0 * (2e-3 * t).cos() + (2e-3 * t).sin();
        [loss * (around - body) + source(on), (body - shown) / lag]
    };
    let (mut now, step) = ([0.0, 0.0], 1.0);
    for k in 0..1500 {
        let time = f64::from(k) * step;
        let ahead = |by: f64, slope: [f64; 2]| [now[0] + by * slope[0], now[1] + by * slope[1]];
        let on = time + 0.5 * step;
        let a = slope(time, on, now);
        let b = slope(time + 0.5 * step, on, ahead(0.5 * step, a));
        let c = slope(time + 0.5 * step, on, ahead(0.5 * step, b));
        let d = slope(time + step, on, ahead(step, c));
        now = [0, 1].map(|i| now[i] + step / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    let read = |lag: f64| rises(&plate, &[Reading::Point(0.05, 0.01)], &[1500.0], lag)[0][0];
    // The lump is not quite one.
    close(read(0.0), now[0], 1e-4);
    close(read(lag), now[1], 1e-4);
}

/// All heat of a strip that enters, passes and leaves is in the plate, and it comes where the strip is; one that
/// covers the edge is a flux on all of it.
#[test]
fn a_strip_that_moves() {
    let mut strip = Strip { middle: -0.01, speed: 1e-3, width: 0.02 };
    let mut plate = plate();
    plate.heat = vec![(Place::Strip(Side::Top, strip), always(50e3))];
    let [length, height] = plate.size;
    let read = [Reading::Mean, Reading::Point(0.01, 0.025), Reading::Point(0.07, 0.025)];
    let found = rises(&plate, &read, &[10.0, 50.0, 300.0], 0.0);
    // Under the edge 1, 20 and 20 mm, for so long as it took: 10²/2, 20²/2 + 30·20 and 80·20 mm s, told in m s.
    for (found, share) in found.iter().zip([0.05, 0.8, 1.6]) {
        close(found[0], 50e3 * share / (CAPACITY * length * height), 1e-9);
    }
    assert!(found[0][1] > found[0][2] && found[1][1] > found[1][2]);
    (strip.speed, strip.middle, strip.width) = (0.0, 0.5 * length, 2.0 * length);
    plate.heat = vec![(Place::Strip(Side::Top, strip), always(3e3))];
    let standing = rises(&plate, &read, &[200.0], 0.0);
    plate.heat = vec![(Place::Edge(Side::Top), always(3e3))];
    let whole = rises(&plate, &read, &[200.0], 0.0);
    standing[0].iter().zip(&whole[0]).for_each(|(a, b)| close(*a, *b, 1e-9));
}

/// Mirrored plates, and those that lie on their side, are the same plate.
#[test]
fn every_edge_alike() {
    let mut plate = plate();
    (plate.size, plate.films, plate.faces) = ([0.08, 0.03], [30.0, 90.0, 200.0, 10.0], 2000.0);
    let strip = Strip { middle: 0.01, speed: 2e-4, width: 0.015 };
    plate.heat = vec![(Place::Strip(Side::Top, strip), always(8e3)), (Place::Edge(Side::Left), always(900.0))];
    let upright = rises(&plate, &[Reading::Point(0.03, 0.02), Reading::Mean], &[120.0], 40.0);
    (plate.size, plate.films) = ([0.03, 0.08], [200.0, 10.0, 30.0, 90.0]);
    plate.heat = vec![(Place::Strip(Side::Right, strip), always(8e3)), (Place::Edge(Side::Bottom), always(900.0))];
    let lying = rises(&plate, &[Reading::Point(0.02, 0.03), Reading::Mean], &[120.0], 40.0);
    upright[0].iter().zip(&lying[0]).for_each(|(a, b)| close(*a, *b, 1e-12));
}

/// Heat in a section at an end is a flux there, and a plate that loses as much as it gets stays so.
#[test]
fn sections_and_balances() {
    let mut plate = plate();
    (plate.films, plate.faces) = ([30.0, 90.0, 200.0, 10.0], 2000.0);
    let read = [Reading::Point(0.03, 0.02), Reading::Mean];
    plate.heat = vec![(Place::Section(0.08), always(700.0))];
    let section = rises(&plate, &read, &[150.0], 0.0);
    plate.heat = vec![(Place::Edge(Side::Right), always(700.0))];
    let edge = rises(&plate, &read, &[150.0], 0.0);
    section[0].iter().zip(&edge[0]).for_each(|(a, b)| close(*a, *b, 1e-12));
    let sides = [Side::Left, Side::Right, Side::Bottom, Side::Top];
    plate.heat = sides.iter().zip(plate.films).map(|(side, film)| (Place::Edge(*side), always(5.0 * film))).collect();
    plate.heat.push((Place::Faces, always(5.0 * plate.faces)));
    rises(&plate, &read, &[1e5], 0.0)[0].iter().for_each(|found| close(*found, 5.0, 1e-6));
}
