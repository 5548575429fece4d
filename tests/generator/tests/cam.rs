//! Ground cams against formulas: interpolated lines and circles, and effects of the first order where the
//! blocks are short.

use std::f64::consts::TAU;

use generator::cam::motion::{Machine, Motion, programme};
use generator::cam::profile::{Place, Profile};
use generator::cam::{Job, Pass, Row};
use generator::job::{Job as _, NoiseKind};
use generator::law::Cause;

const PROFILE: Profile = Profile { base: 18.0, nose: 9.0, lift: 14.0 };
const WHEEL: f64 = 120.0;
/// rad/s.
const SPEED: f64 = 2.0;
/// Of blocks so short that their own error does not show, mm.
const SHORT: f64 = 0.02;

/// Angles on the base circle, both flanks and the nose, deg.
const ANGLES: [f64; 8] = [100.0, 180.0, 262.0, 315.0, 332.0, 5.0, 27.0, 45.0];

fn turn(step: f64, machine: Machine, reverse: bool) -> Motion {
    Motion::new(&programme(&PROFILE, WHEEL, step), WHEEL, &machine, SPEED, reverse)
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found} against {expected}");
}

/// Outward part of a small way across the line from the axis to the wheel's centre, and of one along it.
fn parts(place: &Place) -> [f64; 2] {
    let [x, y] = place.centre(WHEEL);
    let (sine, cosine) = (place.normal - y.atan2(x)).sin_cos();
    [sine, cosine]
}

#[test]
fn a_place_is_the_same_by_its_angle_and_along_the_profile() {
    for segment in 0..4 {
        for part in [0.1, 0.5, 0.85] {
            let place = PROFILE.on(segment, part * PROFILE.lengths()[segment]);
            let found = PROFILE.at(place.point[1].atan2(place.point[0]).to_degrees());
            close(found.point[0], place.point[0], 1e-12);
            close(found.point[1], place.point[1], 1e-12);
            close((found.normal - place.normal).sin(), 0.0, 1e-12);
            assert_eq!(found.curvature, place.curvature);
        }
    }
}

#[test]
fn circles_about_the_axis_have_no_error_and_short_blocks_little() {
    let (long, short) = (turn(1.5, Machine::default(), false), turn(SHORT, Machine::default(), false));
    for angle in [100.0, 180.0, 262.0] {
        close(long.leaves(&PROFILE.at(angle)), 0.0, 1e-12);
    }
    for angle in ANGLES {
        // The error goes with the square of the block.
        assert!(short.leaves(&PROFILE.at(angle)).abs() < 2e-5, "{angle}");
    }
}

/// On the way of the wheel's centre along a straight flank, x = D/cos ψ, a block of Δψ leaves x''·Δψ²/8 half
/// way, of which cos ψ is square to the flank.
#[test]
fn a_straight_flank_thickens() {
    let motion = turn(1.5, Machine::default(), false);
    let flank = PROFILE.lengths()[1];
    let count = (flank / 1.5).ceil();
    for block in [1.0, 3.0, 6.0] {
        let psi = |k: f64| {
            let centre = PROFILE.on(1, flank * k / count).centre(WHEEL);
            centre[1].atan2(centre[0]) + PROFILE.flank()
        };
        let (from, to) = (psi(block), psi(block + 1.0));
        let middle = 0.5 * (from + to);
        let bend = (PROFILE.base + WHEEL) * (1.0 + middle.sin().powi(2)) / middle.cos().powi(3);
        let left = bend * (to - from).powi(2) / 8.0 * middle.cos();
        let found = motion.leaves(&PROFILE.on(1, flank * (block + 0.5) / count));
        assert!(left > 1e-3);
        close(found / left, 1.0, 0.03);
    }
}

/// A smaller wheel leaves its loss, a late slide turns the cam, a height moves the wheel across and a play
/// along the line to the axis.
#[test]
fn effects_of_the_first_order() {
    let short = turn(SHORT, Machine::default(), false);
    for angle in ANGLES {
        let place = PROFILE.at(angle);
        let [across, along] = parts(&place);
        let change = |machine, reverse| turn(SHORT, machine, reverse).leaves(&place) - short.leaves(&place);
        close(change(Machine { loss: 0.01, ..Machine::default() }, false), 0.01, 1e-5);
        let late = Machine { lag: 1e-3, ..Machine::default() };
        let turned = SPEED * 1e-3;
        let [x, y] = place.point;
        let (sine, cosine) = place.normal.sin_cos();
        let moved = turned * (x * sine - y * cosine);
        close(change(late, false), moved, 1e-4);
        close(change(late, true), -moved, 1e-4);
        for reverse in [false, true] {
            close(change(Machine { height: 0.1, ..Machine::default() }, reverse), 0.1 * across, 1e-4);
        }
        // Above +x the cam falls as it turns counter-clockwise, below it rises.
        let sign = if angle < 60.0 { 1.0 } else { -1.0 };
        // Away from the base circle, where it is still being crossed.
        if [27.0, 332.0].contains(&angle) {
            let played = Machine { gap: 0.02, ..Machine::default() };
            close(change(played, false), sign * 0.01 * along, 1e-4);
            close(change(played, true), -sign * 0.01 * along, 1e-4);
        }
    }
}

/// F = force_per_rate·stock·feed: on the base circle the feed is ω·r, and on a flank that of a contact that
/// runs along a line, r·dψ = D/cos²ψ of the wheel's centre.
#[test]
fn force_of_the_cut() {
    let job = |angle: f64| Job {
        profile: PROFILE,
        wheel: WHEEL,
        step: 1.0,
        speed: 30.0,
        cut: Some((20.0, 10.0)),
        passes: vec![Pass { speed: 30.0, reverse: false }],
        rows: vec![Row { pass: 0, angle }],
        noise: NoiseKind::Neither,
        shown: vec![],
    };
    let gives = Cause { effect: "grinding-deflection", parameters: vec![("stiffness", 20.0)] };
    let change = |angle: f64| job(angle).predict(std::slice::from_ref(&gives))[0] - job(angle).predict(&[])[0];
    let omega = TAU / 2.0;
    close(change(180.0), 10.0 * 0.02 * omega * 18.0 / 20.0, 1e-9);
    let [x, y] = PROFILE.at(40.0).centre(WHEEL);
    let psi = y.atan2(x) - PROFILE.flank();
    close(change(40.0), 10.0 * 0.02 * omega * (18.0 + WHEEL) / psi.cos().powi(2) / 20.0, 1e-9);
}
