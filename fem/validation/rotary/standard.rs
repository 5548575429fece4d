//! ISO 230-2 of a rotary axis, worked out by hand; the numbers of targets that it asks for.

use super::rig::*;
use crate::positioning::Direction::{self, Backward, Forward};
use crate::positioning::{Measures, Quantity, Tolerance as Allowed};
use crate::validation::Case;

pub fn cases() -> Vec<Case> {
    [by_hand(), asked(), allowed()].concat()
}

/// Two runs at eight targets, 45 degrees apart. Readings ±d about a mean have s = d·√2.
fn turn() -> crate::positioning::Evaluation {
    const FORWARDS: [f64; 8] = [0.0, 4.0, 6.0, 5.0, 0.0, -3.0, -5.0, -2.0];
    const LOST: [f64; 8] = [10.0, 12.0, 9.0, 8.0, 10.0, 11.0, 14.0, 10.0];
    let both = |angle: f64, direction, mean: f64, d: f64| [(angle, direction, mean - d), (angle, direction, mean + d)];
    let target = |i: usize| {
        let (angle, mean) = (45.0 * i as f64, FORWARDS[i]);
        let scatter = if i == 6 { 1.0 } else { 0.5 };
        [both(angle, Forward, mean, scatter), both(angle, Backward, mean + LOST[i], 0.5)].concat()
    };
    test((0..8).flat_map(target))
}

fn by_hand() -> Vec<Case> {
    let r = std::f64::consts::SQRT_2;
    let quantities = turn().quantities();
    let rows: [(&'static str, f64); 10] = [
        // Means go from -5 at 270 degrees forwards to 16 at 45 degrees backwards.
        ("E", 21.0),
        ("E+", 11.0),
        // 10, 16, 15, 13, 10, 8, 9, 8.
        ("E-", 8.0),
        // Means of both ways: 5, 10, 10.5, 9, 5, 2.5, 2, 3.
        ("M", 8.5),
        ("B", 14.0),
        ("B_mean", -10.5),
        ("R+", 4.0 * r),
        ("R-", 2.0 * r),
        // At 270 degrees: 2r + r + 14.
        ("R", 3.0 * r + 14.0),
        // From the top of 45 degrees backwards to the bottom of 270 degrees forwards.
        ("A", 16.0 + r - (-5.0 - 2.0 * r)),
    ];
    let case = |(symbol, expected): (&'static str, f64)| {
        let computed = Quantity::find(&quantities, symbol).map_or(f64::NAN, |v| ARCSEC * v);
        row("eight targets of a turn, two runs", symbol, (expected, computed, "arcsec"), ROUND_OFF, "ISO 230-2 by hand")
    };
    rows.map(case).into()
}

/// Fewest targets: three up to 90 degrees, five up to 180, eight beyond.
fn asked() -> Vec<Case> {
    let departs = |count: usize, range: f64| {
        let at = |i: usize| range * i as f64 / (count - 1) as f64;
        let each = |i: usize| Direction::BOTH.map(|direction| [(at(i), direction, 0.0); 5]).concat();
        test((0..count).flat_map(each)).departures(Measures::ROTARY).len() as f64
    };
    let case = |(name, expected, count, range): (&'static str, f64, usize, f64)| {
        row(name, "departures", (expected, departs(count, range), "-"), ROUND_OFF, "ISO 230-2, targets of rotary axes")
    };
    [
        ("three targets on 90 deg", 0.0, 3, 90.0),
        ("four targets on 120 deg", 1.0, 4, 120.0),
        ("five targets on 180 deg", 0.0, 5, 180.0),
        ("seven targets on 360 deg", 1.0, 7, 360.0),
        ("eight targets on 360 deg", 0.0, 8, 360.0),
    ]
    .map(case)
    .into()
}

/// Of a straight error of 0.2 arcsec/deg any 90 degrees have 18 arcsec; of the turn above the three limits.
fn allowed() -> Vec<Case> {
    let tolerance = Allowed::of_rotary_axes();
    let straight = (0..5).flat_map(|i| {
        let angle = 45.0 * f64::from(i);
        Direction::BOTH.map(|direction| [(angle, direction, 0.2 * angle); 2]).concat()
    });
    let checks = tolerance.checks(&test(straight));
    let value = |i: usize| checks[i].value.map_or(f64::NAN, |value| ARCSEC * value);
    let by_hand = "A of ISO 230-2 on a stretch, by hand";
    vec![
        row("0.2 arcsec/deg over 180 deg", "A on 90 deg", (18.0, value(0), "arcsec"), ROUND_OFF, by_hand),
        row("0.2 arcsec/deg over 180 deg", "A", (36.0, value(1), "arcsec"), ROUND_OFF, by_hand),
        row("0.2 arcsec/deg over 180 deg", "R", (0.0, value(2), "arcsec"), ROUND_OFF, by_hand),
    ]
}
