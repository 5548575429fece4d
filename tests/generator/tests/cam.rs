//! Ground cams against formulas: interpolated lines and circles, and effects of the first order where the
//! blocks are short.

use std::f64::consts::TAU;

use generator::cam::motion::{Machine, Motion, programme};
use generator::cam::profile::{Place, Profile};
use generator::cam::{Before, Job, Pass, Row};
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

/// Late slide, play, a centre that is too high and a worn wheel in one motion, followed in short steps of time: a
/// slide behind its play does late what was commanded, and of all positions of the wheel the deepest counts.
#[test]
fn all_of_it_in_one_motion() {
    let machine = Machine { lag: 4e-3, gap: 0.03, height: 0.4, loss: 0.05 };
    let ends = programme(&PROFILE, WHEEL, 1.5);
    let (first, last) = (ends[0][0], ends[ends.len() - 1][0]);
    let command = |time: f64| {
        // The programme once more and once more again.
        let turn = (first + SPEED * time - first).rem_euclid(last - first) + first;
        let above = ends.partition_point(|end| end[0] <= turn).clamp(1, ends.len() - 1);
        let ([from, low], [to, high]) = (ends[above - 1], ends[above]);
        low + (high - low) * (turn - from) / (to - from)
    };
    let (steps, whole) = (400_000, TAU / SPEED);
    let mut slide = command(0.0);
    let mut places = Vec::new();
    for step in 0..2 * steps {
        let time = whole * f64::from(step) / f64::from(steps);
        slide = slide.clamp(command(time) - 0.5 * machine.gap, command(time) + 0.5 * machine.gap);
        if step >= steps {
            let (sine, cosine) = (first + SPEED * (time + machine.lag)).sin_cos();
            places.push([slide * cosine - machine.height * sine, slide * sine + machine.height * cosine]);
        }
    }
    let motion = turn(1.5, machine, false);
    for angle in ANGLES {
        let place = PROFILE.at(angle + 1.3);
        let (sine, cosine) = place.normal.sin_cos();
        let left = |[x, y]: &[f64; 2]| {
            let [dx, dy] = [x - place.point[0], y - place.point[1]];
            let (along, beside) = (dx * cosine + dy * sine, dy * cosine - dx * sine);
            let inside = (WHEEL - machine.loss).powi(2) - beside * beside;
            if inside > 0.0 && along > 0.0 { along - inside.sqrt() } else { f64::INFINITY }
        };
        let deepest = places.iter().map(left).fold(f64::INFINITY, f64::min);
        // The deepest may stand at a bend between two steps, half a step of a slope of a millimetre a radian off.
        close(motion.leaves(&place), deepest, 2e-5);
        assert!(motion.leaves(&place) < deepest + 1e-9, "{angle}");
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
        before: None,
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

/// After a pass of other blocks the layer is stock + what that left − what this one leaves; where it is below zero
/// the old surface stays.
#[test]
fn the_layer_that_a_pass_before_has_left() {
    let job = |stock: f64, before: Option<Before>, angle: f64| Job {
        profile: PROFILE,
        wheel: WHEEL,
        step: 1.0,
        speed: 30.0,
        cut: Some((stock, 10.0)),
        before,
        passes: vec![Pass { speed: 30.0, reverse: false }],
        rows: vec![Row { pass: 0, angle }],
        noise: NoiseKind::Neither,
        shown: vec![],
    };
    let gives = [Cause { effect: "grinding-deflection", parameters: vec![("stiffness", 8.0)] }];
    let before = Some(Before { step: 4.0, wheel: WHEEL, stock: 60.0 });
    for angle in [27.0, 180.0, 332.0] {
        let at = |stock, before| job(stock, before, angle).predict(&gives)[0];
        // N/um of the layer over N/um.
        let part = (at(20.0, None) - at(0.0, None)) / 20.0;
        let bare = at(0.0, None);
        let mut coarse = job(60.0, None, angle);
        coarse.step = 4.0;
        let found = coarse.predict(&gives)[0];
        let layer = (20.0 + found - bare) / (1.0 + part);
        close(at(20.0, before), bare + part * layer.max(0.0), 1e-9);
    }
    // A worn wheel that does not reach the old surface.
    let worn = [Cause { effect: "wheel-wear", parameters: vec![("loss", 15.0)] }];
    let fresh = Some(Before { step: 1.0, wheel: WHEEL, stock: 60.0 });
    close(job(20.0, fresh, 180.0).predict(&worn)[0], 15.0, 1e-9);
    let deep = Some(Before { step: 8.0, wheel: 20.0, stock: 60.0 });
    let old = Job { wheel: 20.0, step: 8.0, ..job(20.0, None, 30.0) }.predict(&[])[0];
    let bare = job(20.0, None, 30.0).predict(&[])[0];
    close(job(5.0, deep, 30.0).predict(&[])[0], bare.min(old + 5.0), 1e-9);
}
