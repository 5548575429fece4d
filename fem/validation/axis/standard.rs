//! ISO 230-2: a published test, and one worked out by hand.

use super::rig::*;
use crate::positioning::Direction::{Backward, Forward};
use crate::positioning::{Evaluation, Quantity};
use crate::validation::{Case, Tolerance};

/// Readings of github.com/paulscherrerinstitute/ecmccfg, examples/test/fat_sat/report.md, commit 072a917e.
const STAGE: &str = include_str!("../../../models/stage/measured.csv");

/// Its report gives um to four decimals.
const PRINTED: Tolerance = Tolerance::Absolute(5e-5);

pub fn cases() -> Vec<Case> {
    [published(), by_hand()].concat()
}

/// The published test. A row of its file is run, position (mm), direction, deviation (um).
fn stage() -> Evaluation {
    let reading = |line: &str| {
        let mut cells = line.split(',').skip(1);
        let position = cells.next()?.parse().ok()?;
        let direction = if cells.next()? == "+" { Forward } else { Backward };
        Some((position, direction, cells.next()?.parse().ok()?))
    };
    test(STAGE.lines().filter_map(reading))
}

fn published() -> Vec<Case> {
    let quantities = stage().quantities();
    let report = "report of the ecmccfg example";
    // Of E and R the report's own figures contradict the standard; these follow from its readings by the
    // standard's formulas.
    let standard = "readings of the ecmccfg example, ISO 230-2 by separate code";
    let rows: [(&str, f64, &str); 7] = [
        ("B", 0.0122, report),
        ("M", 0.0277, report),
        ("A", 0.0888, report),
        ("E", 0.0368, standard),
        ("R", 0.0688, standard),
        ("E+", 0.0246, standard),
        ("R-", 0.0629, standard),
    ];
    let case = |(symbol, expected, source): (&'static str, f64, &'static str)| {
        row("stepper stage, 5 targets, 5 runs", symbol, (expected, um(&quantities, symbol), "um"), PRINTED, source)
    };
    rows.map(case).into()
}

/// Two runs at three targets. Readings ±d about a mean have s = d·√2.
fn by_hand() -> Vec<Case> {
    let r = std::f64::consts::SQRT_2;
    let both = |at: f64, direction, mean: f64, d: f64| [(at, direction, mean - d), (at, direction, mean + d)];
    let all = test(
        [
            both(0.0, Forward, 0.0, 0.5),
            both(0.0, Backward, 3.0, 1.0),
            both(100.0, Forward, 2.0, 0.25),
            both(100.0, Backward, 6.0, 0.25),
            both(250.0, Forward, 5.0, 0.5),
            both(250.0, Backward, 6.0, 2.0),
        ]
        .concat(),
    );
    let quantities = all.quantities();
    let rows: [(&'static str, f64); 12] = [
        ("E", 6.0),
        ("E+", 5.0),
        ("E-", 3.0),
        // Means of both ways: 1.5, 4 and 5.5.
        ("M", 4.0),
        ("B", 4.0),
        ("B_mean", -8.0 / 3.0),
        ("R+", 4.0 * 0.5 * r),
        ("R-", 4.0 * 2.0 * r),
        // At 250 mm: 2s + 2s + 1 = 5r + 1 = 8.07, and 4s = 8r = 11.3 backwards.
        ("R", 8.0 * r),
        ("A+", 5.0 + r + r),
        ("A-", (6.0 + 4.0 * r) - (3.0 - 2.0 * r).min(6.0 - 4.0 * r)),
        // From the top of 250 mm backwards to the bottom of 0 mm forwards.
        ("A", (6.0 + 4.0 * r) - (0.0 - r)),
    ];
    let case = |(symbol, expected): (&'static str, f64)| {
        row(
            "three targets, two runs",
            symbol,
            (expected, um(&quantities, symbol), "um"),
            CANCELLED,
            "ISO 230-2 by hand",
        )
    };
    rows.map(case).into()
}

fn um(quantities: &[Quantity], symbol: &str) -> f64 {
    Quantity::find(quantities, symbol).map_or(f64::NAN, |v| 1e6 * v)
}
