use std::f64::consts::PI;

use super::rod::Rod;
use super::{AnyLoss, HeatError, Pass, RodPiece, ToolTemperature, cooled, difference, moving_source, wave};

/// A length of a steel shaft with a film coefficient `h` (W/(m^2 K)).
fn steel(length: f64, diameter: f64, h: f64) -> RodPiece {
    let area = 0.25 * PI * diameter * diameter;
    RodPiece { length, heat_capacity: 7850.0 * 470.0 * area, conductance: 50.0 * area, loss: h * PI * diameter }
}

fn stepped() -> Vec<RodPiece> {
    let steps = [(0.08, 0.04), (0.15, 0.045), (0.12, 0.05), (0.005, 0.042), (0.145, 0.045), (0.1, 0.04)];
    steps.map(|(length, diameter)| steel(length, diameter, 30.0)).to_vec()
}

fn solved(pieces: &[RodPiece], from: f64, to: f64, speed: f64, tolerance: f64) -> ToolTemperature {
    moving_source(pieces, &Pass { from, to, speed }, tolerance).unwrap()
}

/// Places in a pass, crowded at both ends of every part between `breaks`.
fn places(breaks: &[f64]) -> Vec<f64> {
    let part = |ends: &[f64]| {
        let (a, b) = (ends[0], ends[1]);
        (0..=60).map(move |i| {
            a + (b - a)
                * 0.5
                * (1.0 - (f64::from(i) / 60.0 * PI).cos().abs().powf(0.2) * (0.5 - f64::from(i) / 60.0).signum())
        })
    };
    breaks.windows(2).flat_map(part).collect()
}

/// Largest rise and largest difference from `exact`.
fn worst(found: &ToolTemperature, breaks: &[f64], exact: impl Fn(f64) -> f64) -> (f64, f64) {
    places(breaks).into_iter().fold((0.0, 0.0), |(largest, error): (f64, f64), x| {
        let rise = exact(x);
        (largest.max(rise), error.max((found.rise_at(x) - rise).abs()))
    })
}

/// exp(x^2) erfc(x) for x >= 0: power series and continued fraction.
fn erfcx(x: f64) -> f64 {
    if x < 1.0 {
        let (mut term, mut sum, mut n) = (x, x, 0.0);
        while term > 1e-18 * sum {
            n += 1.0;
            term *= 2.0 * x * x / (2.0 * n + 1.0);
            sum += term;
        }
        return (x * x).exp() - 2.0 / PI.sqrt() * sum;
    }
    let tail = (1..=200).rev().fold(x, |tail, n| x + 0.5 * f64::from(n) / tail);
    1.0 / (tail * PI.sqrt())
}

/// Integral from 0 to `r` of exp(-beta s^2 - (a + b s^2)^2 / (4 s^2)) ds.
fn image(a: f64, b: f64, beta: f64, r: f64) -> f64 {
    let q = (beta + 0.25 * b * b).sqrt();
    if r <= 0.0 {
        return 0.0;
    }
    let (near, far) = (0.5 * a.abs() / r - q * r, 0.5 * a.abs() / r + q * r);
    let common = (-beta * r * r - (0.5 * (a + b * r * r) / r).powi(2)).exp();
    let first = if near >= 0.0 {
        common * erfcx(near)
    } else {
        2.0 * (-0.5 * a * b - a.abs() * q).exp() - common * erfcx(-near)
    };
    PI.sqrt() / (4.0 * q) * (first - common * erfcx(far))
}

/// Rise (K/W) at the tool at `x` in a uniform rod with insulated ends, cold when the tool left `from`: all
/// images.
fn uniform(rod: &RodPiece, from: f64, x: f64, speed: f64) -> f64 {
    let root = (rod.conductance / rod.heat_capacity).sqrt();
    let (length, z, v) = (rod.length / root, x / root, speed * (x - from).signum() / root);
    let (beta, r) = (rod.loss / rod.heat_capacity, ((x - from).abs() / speed).sqrt());
    let reach = (12.0 * r / length).ceil() as i32 + 2;
    let pair = |m: i32| {
        let shift = 2.0 * f64::from(m) * length;
        image(-shift, v, beta, r) + image(2.0 * z - shift, -v, beta, r)
    };
    (-reach..=reach).map(pair).sum::<f64>() / (PI * rod.conductance * rod.heat_capacity).sqrt()
}

/// The same by `terms` cosines and the mean of the others.
fn cosines(rod: &RodPiece, from: f64, x: f64, speed: f64, terms: u32) -> f64 {
    let (alpha, beta) = (rod.conductance / rod.heat_capacity, rod.loss / rod.heat_capacity);
    let (t, v) = ((x - from).abs() / speed, speed * (x - from).signum());
    let mut sum = if beta > 0.0 { -(-beta * t).exp_m1() / beta } else { t };
    for n in 1..=terms {
        let w = f64::from(n) * PI / rod.length;
        // exp(i w x) times the integral from 0 to t of exp(-(re + i im) s) ds
        let (re, im) = (alpha * w * w + beta, w * v);
        let decay = (-re * t).exp();
        let (top_re, top_im) = (1.0 - decay * (im * t).cos(), decay * (im * t).sin());
        let size = re * re + im * im;
        let (real, imaginary) = ((top_re * re + top_im * im) / size, (top_im * re - top_re * im) / size);
        let (sin, cos) = (w * x).sin_cos();
        sum += 2.0 * cos * (cos * real - sin * imaginary);
    }
    let next = (f64::from(terms) + 0.5) * PI / rod.length;
    let others = (speed / (alpha * next)).atan() / speed * rod.length / PI;
    (sum + others) / (rod.heat_capacity * rod.length)
}

/// Rise (K/W) at the tool at `x` in two half-infinite rods of equal loss / heat capacity that meet at 0; the
/// tool goes right from `from` < 0.
fn two_rods(rods: &[RodPiece; 2], from: f64, x: f64, speed: f64) -> f64 {
    let effusivity = rods.map(|rod| (rod.conductance * rod.heat_capacity).sqrt());
    let root = rods.map(|rod| (rod.conductance / rod.heat_capacity).sqrt());
    let (beta, r) = (rods[0].loss / rods[0].heat_capacity, ((x - from) / speed).sqrt());
    let both = effusivity[0] + effusivity[1];
    let reflected = (effusivity[0] - effusivity[1]) / both;
    if x <= 0.0 {
        let (z, v) = (x / root[0], speed / root[0]);
        let sum = image(0.0, v, beta, r) + reflected * image(2.0 * z, -v, beta, r);
        return sum / (PI.sqrt() * effusivity[0]);
    }
    let crossed = (x / speed).sqrt();
    let (z, v) = (x / root[1], speed / root[1]);
    let own = image(0.0, v, beta, crossed) - reflected * image(2.0 * z, -v, beta, crossed);
    let (a, b) = (x / root[1] - x / root[0], speed / root[0]);
    let passed = image(a, b, beta, r) - image(a, b, beta, crossed);
    own / (PI.sqrt() * effusivity[1]) + 2.0 * passed / (PI.sqrt() * both)
}

#[test]
fn erfcx_is_that_of_series_and_continued_fraction() {
    for i in 0..600 {
        let x = 0.02 * f64::from(i);
        assert!((wave::erfcx(x) / erfcx(x) - 1.0).abs() < 3e-15, "{x}: {:e}, {:e}", wave::erfcx(x), erfcx(x));
    }
}

#[test]
fn references_agree() {
    let cases = [(0.6, 20.0, 0.0, 0.4, 2e-3), (0.6, 50.0, 0.55, 0.07, 5e-5), (0.05, 10.0, 0.01, 0.033, 2e-3)];
    for (length, h, from, x, speed) in cases {
        let rod = steel(length, 0.045, h);
        let (a, b) = (uniform(&rod, from, x, speed), cosines(&rod, from, x, speed, 100_000));
        assert!((a / b - 1.0).abs() < 1e-8, "{a:.12e} {b:.12e}");
    }
}

#[test]
fn uniform_rod_is_exact_to_the_tolerance() {
    let cases = [
        ("typical", 0.6, 20.0, 0.0, 0.6, 2e-3),
        ("back", 0.6, 20.0, 0.6, 0.0, 2e-3),
        ("part", 0.6, 50.0, 0.1, 0.4, 2e-3),
        ("slow", 0.6, 50.0, 0.0, 0.6, 5e-5),
        ("slow, no loss", 0.6, 0.0, 0.05, 0.5, 5e-5),
        ("nearly standing", 0.6, 20.0, 0.5, 0.05, 1e-6),
        ("nearly standing, no loss", 0.6, 0.0, 0.05, 0.5, 1e-7),
        ("fast", 0.6, 20.0, 0.0, 0.6, 0.05),
        ("short shaft", 0.02, 10.0, 0.0, 0.02, 2e-3),
        ("short pass", 0.6, 20.0, 0.3, 0.301, 2e-3),
        ("short pass at the end", 0.6, 20.0, 0.001, 0.01, 2e-3),
    ];
    for (name, length, h, from, to, speed) in cases {
        let rod = steel(length, 0.045, h);
        for tolerance in [1e-3, 1e-4, 1e-5] {
            let found = solved(&[rod], from, to, speed, tolerance);
            let (largest, error) = worst(&found, &[from, to], |x| uniform(&rod, from, x, speed));
            assert!(error <= tolerance * largest, "{name}, {tolerance}: {:e}", error / largest);
            assert!(error <= found.error(), "{name}, {tolerance}: {error:e} estimated as {:e}", found.error());
        }
    }
}

#[test]
fn far_from_the_ends_the_rise_becomes_steady() {
    for (speed, h) in [(2e-3, 0.0), (2e-3, 50.0), (1e-3, 200.0), (2e-2, 20.0)] {
        let rod = steel(1.2, 0.045, h);
        let (alpha, beta) = (rod.conductance / rod.heat_capacity, rod.loss / rod.heat_capacity);
        let steady = 1.0 / (rod.heat_capacity * (speed * speed + 4.0 * alpha * beta).sqrt());
        let found = solved(&[rod], 0.0, 1.2, speed, 1e-5).rise_at(0.9);
        assert!((found / steady - 1.0).abs() < 1e-5, "{speed}, {h}: {found} {steady}");
    }
}

#[test]
fn two_materials_are_exact_to_the_tolerance() {
    let cases = [
        (0.6, 0.8, 0.1, 2e-3),
        (1.5, 0.3, 0.1, 2e-3),
        (0.6, 0.8, 0.1, 2e-4),
        (3.0, 2.0, 1e-5, 2e-3),
        (0.6, 0.8, 0.1, 0.02),
    ];
    for (capacity, conductance, before, speed) in cases {
        let left = steel(2.0, 0.045, 20.0);
        let right = RodPiece {
            length: 2.0,
            heat_capacity: capacity * left.heat_capacity,
            conductance: conductance * left.conductance,
            loss: capacity * left.loss,
        };
        let found = solved(&[left, right], 2.0 - before, 2.1, speed, 1e-4);
        let exact = |x: f64| two_rods(&[left, right], -before, x - 2.0, speed);
        let (largest, error) = worst(&found, &[2.0 - before, 2.0, 2.1], exact);
        assert!(error <= 1e-4 * largest, "{capacity}, {conductance}, {speed}: {:e}", error / largest);
        assert!(error <= found.error(), "{capacity}, {conductance}, {speed}: {error:e} {:e}", found.error());
    }
}

#[test]
fn stepped_shaft_agrees_with_a_finer_solution() {
    for (from, to, speed) in [(0.6, 0.02, 5e-5), (0.6, 0.0, 2e-3), (0.02, 0.58, 2e-3), (0.6, 0.02, 5e-2)] {
        let fine = solved(&stepped(), from, to, speed, 3e-6);
        let found = solved(&stepped(), from, to, speed, 1e-4);
        let (largest, error) = worst(&found, &[from, 0.5, 0.355, 0.35, 0.23, 0.08, to], |x| fine.rise_at(x));
        assert!(error <= 1e-4 * largest, "{speed}: {:e}", error / largest);
        assert!(error <= found.error() + fine.error(), "{speed}: {error:e} estimated as {:e}", found.error());
    }
}

#[test]
fn the_order_is_two() {
    let uniform = vec![steel(0.6, 0.045, 20.0)];
    for (pieces, speed) in [(uniform, 2e-3), (stepped(), 2e-3), (stepped(), 5e-5), (stepped(), 5e-2)] {
        let run = |level| Rod::new(&pieces, 0.6, speed, 1e-4, level).pass(0.0, 0.6);
        let runs = [run(1), run(2), run(3)];
        let order = (difference(&runs[0], &runs[1]) / difference(&runs[1], &runs[2])).log2();
        assert!((order - 2.0).abs() < 0.15, "{speed}: {order}");
    }
}

#[test]
fn without_loss_all_heat_stays() {
    let pieces = [steel(0.1, 0.04, 0.0), steel(0.2, 0.05, 0.0)];
    let heat = |level| {
        let mut rod = Rod::new(&pieces, 0.27, 1e-4, 1e-4, level);
        rod.pass(0.03, 0.3);
        rod.heat() * 1e-4 / 0.27
    };
    let (coarse, fine) = (heat(3), heat(4));
    let limit = fine + (fine - coarse) / 3.0;
    assert!((fine - 1.0).abs() < 1e-4 && (limit - 1.0).abs() < 1e-6, "{coarse:.9} {fine:.9} {limit:.9}");
}

#[test]
fn a_mirrored_pass_gives_the_mirrored_rise() {
    let mut mirrored = stepped();
    mirrored.reverse();
    let (there, back) = (solved(&stepped(), 0.02, 0.5, 2e-3, 1e-4), solved(&mirrored, 0.58, 0.1, 2e-3, 1e-4));
    let (largest, error) = worst(&there, &[0.02, 0.23, 0.5], |x| back.rise_at(0.6 - x));
    assert!(error < 1e-8 * largest, "{:e}", error / largest);
}

#[test]
fn a_piece_in_two_parts_is_one_piece() {
    let part = |length: f64, h: f64| steel(length, 0.045, h);
    let whole = solved(&[part(0.6, 20.0)], 0.05, 0.55, 2e-3, 1e-4);
    for (h, tolerance) in [(20.0, 1e-8), (20.0 + 1e-6, 1e-4)] {
        let parts = solved(&[part(0.25, 20.0), part(0.35, h)], 0.05, 0.55, 2e-3, 1e-4);
        let (largest, error) = worst(&parts, &[0.05, 0.25, 0.55], |x| whole.rise_at(x));
        assert!(error < tolerance * largest, "{h}: {:e}", error / largest);
    }
}

#[test]
fn outside_the_pass_the_rise_is_the_first_or_last() {
    let found = solved(&stepped(), 0.5, 0.1, 2e-3, 1e-4);
    assert_eq!([found.rise_at(0.5), found.rise_at(0.55), found.rise_at(7.0)], [0.0; 3]);
    assert!(found.rise_at(0.1) > 0.0);
    assert_eq!(found.rise_at(0.05), found.rise_at(-1.0));
    assert!((found.rise_at(0.05) / found.rise_at(0.1) - 1.0).abs() < 1e-12);
}

#[test]
fn input_out_of_range_is_refused() {
    let rod = steel(0.6, 0.045, 20.0);
    let pass = Pass { from: 0.0, to: 0.6, speed: 2e-3 };
    let refused = |pieces: &[RodPiece], pass: Pass, tolerance| moving_source(pieces, &pass, tolerance).err();
    assert_eq!(refused(&[], pass, 1e-4), Some(HeatError::Piece(0)));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let pieces = [rod, RodPiece { length: bad, ..rod }];
        assert_eq!(refused(&pieces, pass, 1e-4), Some(HeatError::Piece(1)));
        assert_eq!(refused(&[RodPiece { heat_capacity: bad, ..rod }], pass, 1e-4), Some(HeatError::Piece(0)));
        assert_eq!(refused(&[RodPiece { conductance: bad, ..rod }], pass, 1e-4), Some(HeatError::Piece(0)));
        assert_eq!(refused(&[rod], Pass { speed: bad, ..pass }, 1e-4), Some(HeatError::Pass));
    }
    assert_eq!(refused(&[RodPiece { loss: -1.0, ..rod }], pass, 1e-4), Some(HeatError::Piece(0)));
    assert_eq!(refused(&[rod], Pass { to: 0.0, ..pass }, 1e-4), Some(HeatError::Pass));
    assert_eq!(refused(&[rod], Pass { to: 0.7, ..pass }, 1e-4), Some(HeatError::Pass));
    assert_eq!(refused(&[rod], Pass { from: f64::NAN, ..pass }, 1e-4), Some(HeatError::Pass));
    assert_eq!(refused(&[rod], pass, 0.0), Some(HeatError::Pass));
    assert!(matches!(refused(&[rod], pass, 1e-13), Some(HeatError::Tolerance(_))));
}

#[test]
fn absurd_values_do_not_panic() {
    let rod = steel(0.6, 0.045, 20.0);
    for size in [1e-300, 1e-9, 1e9, 1e300] {
        let pass = |speed: f64| Pass { from: 0.1, to: 0.5, speed };
        let _ = moving_source(&[rod], &pass(size), 1e-2);
        let _ = moving_source(&[rod, RodPiece { heat_capacity: size, ..rod }], &pass(2e-3), 1e-2);
        let _ = moving_source(&[rod, RodPiece { conductance: size, ..rod }], &pass(2e-3), 1e-2);
        let _ = moving_source(&[RodPiece { loss: size, ..rod }, rod], &pass(2e-3), 1e-2);
        let _ = moving_source(&[RodPiece { length: size, ..rod }, rod], &pass(2e-3), 1e-2);
        let all = RodPiece { length: 1.0, heat_capacity: size, conductance: 1.0 / size, loss: 0.0 };
        let _ = moving_source(&[all], &pass(size), 1e-2);
    }
}

#[test]
fn any_loss_agrees_with_the_solution_of_each() {
    // Two pieces, a pass of 250 s. What the interpolation may add is a tenth of what a solution is allowed.
    let piece = |length, diameter: f64| {
        let area = std::f64::consts::PI * diameter * diameter / 4.0;
        RodPiece {
            length,
            heat_capacity: 7850.0 * 470.0 * area,
            conductance: 50.0 * area,
            loss: std::f64::consts::PI * diameter,
        }
    };
    let pieces = [piece(0.2, 0.05), piece(0.3, 0.03)];
    let pass = Pass { from: 0.5, to: 0.0, speed: 2e-3 };
    let any = AnyLoss::solve(&pieces, &pass, 1e-6).unwrap();
    for coefficient in [0.0, 0.3, 7.0, 25.0, 110.0, 800.0, 0.99 * any.largest()] {
        let exact = moving_source(&cooled(&pieces, coefficient), &pass, 1e-6).unwrap();
        let between = any.at(coefficient);
        let places = || (0..=50).map(|i| 0.01 * f64::from(i));
        let largest = places().map(|x| exact.rise_at(x).abs()).fold(0.0, f64::max);
        let error = places().map(|x| (between.rise_at(x) - exact.rise_at(x)).abs()).fold(0.0, f64::max);
        assert!(error <= 1e-5 * largest, "{coefficient}: {:.1e}", error / largest);
    }
}
