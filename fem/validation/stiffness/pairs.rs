//! Two joints that press on each other: numbers by hand and in closed form, forces of both signs, and what a preload
//! is worth.
//!
//! With n = 1/2 and q = √Q the law u = q²/k + c·q is a parabola, and u(Q₁) + u(Q₂) = 2·u(P) says that (q₁ + a)² +
//! (q₂ + a)² = 2·(p + a)² with a = c·k/2. Squares that are sums of squares (7² + 1² = 2·5², 17² + 7² = 2·13²) give
//! pairs in whole numbers.

use super::curves::{CONTACT, FRICTION, GAP, PRELOAD};
use super::rig::*;
use crate::processes::stiffness::curve::Branch;
use crate::validation::{Case, Tolerance};

/// Where the numbers come from.
const BY_HAND: &str = "statics: Q1 - Q2 = S, u(Q1) + u(Q2) = 2u(P), y = u(Q1) - u(P), by hand";
const WHOLE: &str = "statics of two opposed joints with n = 1/2: (q1 + a)^2 + (q2 + a)^2 = 2(p + a)^2, whole numbers";

pub fn cases() -> Vec<Case> {
    [by_hand(), whole_numbers(), both_signs(), worth()].concat()
}

fn preload(force: f64) -> String {
    format!("[preload]\nforce = \"{force} N\"\n")
}

fn contact(c: f64) -> String {
    format!("[contact-joint]\nc = \"{c} um/N^n\"\nn = 0.5\n")
}

/// Within some roundings of displacements of 10 um.
const DIGITS: Tolerance = Tolerance::Absolute(1e-12);

fn y(name: &str, effects: &str, force: f64, expected: f64, source: &'static str) -> Case {
    let computed = up(&under("4000 N", "from-zero", effects), force);
    row(format!("{name}, {force} N"), "displacement", (expected, computed, "um"), DIGITS, source)
}

fn by_hand() -> Vec<Case> {
    let gap = "[gap]\ngap = \"3 um\"\n".to_string();
    let closed = gap.clone() + &preload(400.0);
    // √Q = q solves q²/80 + q/4 = 20, twice u(400 N) = 10 um.
    let relaxed = (((0.0625f64 + 1.0).sqrt() - 0.25) * 40.0).powi(2);
    let pair = contact(0.25) + &preload(400.0);
    vec![
        y("a gap of 3 um", &gap, 1000.0, 15.5, "seed 000, fig. 5 a: y1 = y + y0"),
        y("a gap that 400 N take up, one side relaxed", &closed, 1000.0, 7.5, "seed 000, fig. 5 b: y2 = y - u(P)"),
        y("a gap that 400 N take up, both sides", &closed, 400.0, 2.5, BY_HAND),
        y(
            "400 N on contacts, both sides",
            &pair,
            900.0,
            pressed(0.25, 900.0, 400.0),
            "the same, the second force by bisection",
        ),
        y("400 N on contacts, one side relaxed", &pair, 1600.0, 30.0 - 10.0, BY_HAND),
        row(
            "400 N on contacts",
            "force that relaxes one side",
            (relaxed, figure_of(&joint(&pair), "preload", "relaxed_at"), "N"),
            ROUND_OFF,
            "u(S) = 2u(P), a quadratic in the root of S",
        ),
    ]
}

/// (c um/N^½, roots of P, Q₁ and Q₂, y um)
fn whole_numbers() -> Vec<Case> {
    let rows = [
        (0.05, [13.0, 19.0, 1.0], 2.7),
        (0.05, [18.0, 26.0, 2.0], 4.8),
        (0.05, [24.0, 32.0, 12.0], 6.0),
        (0.2, [18.0, 26.0, 6.0], 6.0),
        (0.2, [17.0, 23.0, 9.0], 4.2),
    ];
    let case = |(c, [p, first, second], expected): (f64, [f64; 3], f64)| {
        let effects = contact(c) + &preload(p * p);
        let name = format!("contacts of {c} um/N^0.5 under {} N", p * p);
        let force = first * first - second * second;
        let slope = |root: f64| 1.0 / 80.0 + 0.5 * c / root;
        let [a, b] = [slope(first), slope(second)];
        let machine = under("4000 N", "from-zero", &effects);
        let tangent = machine.and_then(|j| j.machine().curve.tangent(force, Branch::Load)).map(|k| 1e-6 * k);
        let stiffness = (1.0 / a + 1.0 / b, tangent.unwrap_or(f64::NAN), "N/um");
        [
            y(&name, &effects, force, expected, WHOLE),
            row(format!("{name}, {force} N"), "tangent stiffness", stiffness, ROUND_OFF, "1/u1' + 1/u2', by hand"),
        ]
    };
    rows.into_iter().flat_map(case).collect()
}

/// Forces from −1000 N to 1000 N and back.
fn both_signs() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |name: &str, effects: &str, rows: &[(bool, f64, f64)]| {
        let joint = reversed(effects);
        cases.extend(rows.iter().map(|(unload, force, expected)| {
            let computed = if *unload { down(&joint, *force) } else { up(&joint, *force) };
            let way = if *unload { "falling" } else { "rising" };
            let name = format!("force reversed, {name}, {force} N, {way}");
            row(name, "displacement", (*expected, computed, "um"), DIGITS, "seed 000, fig. 5, by hand")
        }));
    };
    let friction =
        [(false, -840.0, -11.5), (false, 0.0, -1.0), (false, 1000.0, 11.5), (true, 0.0, 1.0), (true, -1000.0, -11.5)];
    add("friction", FRICTION, &friction);
    add("gap", GAP, &[(false, -400.0, -5.0), (false, 400.0, 10.0), (true, -1000.0, -12.5)]);
    add("preload", PRELOAD, &[(false, -1000.0, -10.0), (true, -160.0, -1.0), (true, 1000.0, 10.0)]);
    add("contact", CONTACT, &[(false, -400.0, -9.0), (true, 400.0, 9.0)]);
    let all = [GAP, CONTACT, FRICTION, PRELOAD].concat();
    add("all four", &all, &[(false, -500.0, -pressed(0.2, 580.0, 200.0)), (true, -500.0, -pressed(0.2, 420.0, 200.0))]);
    cases
}

/// Lost motion at a reversal, and the friction at which a preload loses as much as the play that it takes up.
fn worth() -> Vec<Case> {
    let gap = "[gap]\ngap = \"3 um\"\n";
    let told = |path: &str, effects: &str| figure_of(&joint(effects), "preload", path);
    let closed = gap.to_string() + &preload(400.0);
    let rubbing = closed.clone() + FRICTION;
    let lost = |name: &str, expected: f64, computed: f64| {
        row(
            name,
            "lost motion",
            (expected, computed, "um"),
            ROUND_OFF,
            "seed 000, fig. 2: gap + 2f/k, and 2f/2k under preload",
        )
    };
    let worth = |name: &str, expected: f64, computed: f64| {
        row(name, "friction it is worth", (expected, computed, "N"), ROUND_OFF, "2f'/2k = gap + 2f/k, by hand")
    };
    vec![
        lost("gap of 3 um and 80 N of friction", 5.0, told("without/lost_motion", &rubbing)),
        lost("the same under 400 N", 1.0, told("with/lost_motion", &rubbing)),
        worth("400 N that take up 3 um", 240.0, told("worth_friction", &closed)),
        worth("400 N that take up 3 um beside 80 N of friction", 400.0, told("worth_friction", &rubbing)),
    ]
}
