//! Displacements under the laws, alone and together, and tangents.

use super::rig::*;
use crate::processes::stiffness::curve::Branch;
use crate::validation::{Case, Tolerance};

pub const GAP: &str = "[gap]\ngap = \"5 um\"\n";
pub const CONTACT: &str = "[contact-joint]\nc = \"0.2 um/N^n\"\nn = 0.5\n";
pub const FRICTION: &str = "[dry-friction]\nforce = \"80 N\"\n";
const PLAY: &str = "[gap]\ngap = \"3 um\"\n[dry-friction]\nforce = \"60 N\"\n";
pub const PRELOAD: &str = "[preload]\nforce = \"200 N\"\n";

pub const SETTLING: &str = "[settling]\ndepth = \"4 um\"\n";
pub const OFFSET: &str = "[datum-offset]\noffset = \"-3 um\"\n";

pub fn cases() -> Vec<Case> {
    [alone(), together(), tangents()].concat()
}

/// (effects, on unloading, force N, y um, what it is)
fn displacement(name: &str, effects: &str, unload: bool, force: f64, expected: f64) -> Case {
    let joint = joint(effects);
    let computed = if unload { down(&joint, force) } else { up(&joint, force) };
    let branch = if unload { "unloading" } else { "loading" };
    let tolerance = Tolerance::Absolute(1e-12 * expected.abs().max(1.0));
    row(
        format!("{name}, {force} N, {branch}"),
        "displacement",
        (expected, computed, "um"),
        tolerance,
        "seed 000, fig. 5 and seed 002 (29), by hand",
    )
}

fn alone() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |name: &str, effects: &str, rows: &[(bool, f64, f64)]| {
        cases.extend(rows.iter().map(|(unload, force, y)| displacement(name, effects, *unload, *force, *y)));
    };
    add("spring", "", &[(false, 0.0, 0.0), (false, 1000.0, 12.5), (true, 400.0, 5.0), (true, 0.0, 0.0)]);
    add("gap", GAP, &[(false, 0.0, 0.0), (false, 50.0, 5.625), (true, 50.0, 5.625), (true, 0.0, 0.0)]);
    add("contact", CONTACT, &[(false, 100.0, 3.25), (false, 400.0, 9.0), (true, 900.0, 17.25)]);
    let friction = [
        (false, 50.0, 0.0),
        (false, 80.0, 0.0),
        (false, 480.0, 5.0),
        (false, 1000.0, 11.5),
        (true, 1000.0, 11.5),
        (true, 840.0, 11.5),
        (true, 480.0, 7.0),
        (true, 0.0, 1.0),
    ];
    add("friction", FRICTION, &friction);
    add("preload", PRELOAD, &[(false, 160.0, 1.0), (false, 400.0, 2.5), (false, 1000.0, 10.0), (true, 160.0, 1.0)]);
    add("settling", SETTLING, &[(false, 0.0, 0.0), (false, 500.0, 8.25), (true, 500.0, 10.25), (true, 0.0, 4.0)]);
    add("gauge off zero", OFFSET, &[(false, 0.0, -3.0), (false, 400.0, 2.0), (true, 400.0, 2.0), (true, 0.0, -3.0)]);
    // Friction beyond half of the largest force: nothing comes back. Beyond all of it nothing moves.
    add("friction of 600 N", "[dry-friction]\nforce = \"600 N\"", &[(false, 1000.0, 5.0), (true, 0.0, 5.0)]);
    add("friction of 1200 N", "[dry-friction]\nforce = \"1200 N\"", &[(false, 1000.0, 0.0), (true, 0.0, 0.0)]);
    cases
}

/// Friction comes first: S replaces F in spring, preload, contact and gap, which a preload has taken up.
fn together() -> Vec<Case> {
    let all = [GAP, CONTACT, FRICTION, PRELOAD].concat();
    // 200 N have taken the clearance up, and press both contacts.
    let expected = |s: f64| pressed(0.2, s, 200.0);
    vec![
        // Nothing moves up to 80 N, and 80 N still press on the far flank when the force is gone.
        displacement("gap and friction", &[GAP, FRICTION].concat(), false, 50.0, 0.0),
        displacement("gap and friction", &[GAP, FRICTION].concat(), false, 80.0, 0.0),
        displacement("gap and friction", &[GAP, FRICTION].concat(), false, 160.0, 1.0 + 5.0),
        displacement("gap and friction", &[GAP, FRICTION].concat(), true, 0.0, 1.0 + 5.0),
        displacement("gap of 3 um, friction of 60 N", PLAY, false, 50.0, 0.0),
        displacement("gap of 3 um, friction of 60 N", PLAY, true, 0.0, 0.75 + 3.0),
        displacement("gap, contact and friction", &[GAP, CONTACT, FRICTION].concat(), true, 20.0, 1.25 + 2.0 + 5.0),
        displacement("contact and friction", &[CONTACT, FRICTION].concat(), false, 480.0, 5.0 + 4.0),
        displacement("contact and friction", &[CONTACT, FRICTION].concat(), true, 320.0, 5.0 + 4.0),
        // u(900 N) = 17.25 um is beyond 2·u(200 N): one side alone, less by what the preload has pressed.
        displacement(
            "preload and contact",
            &[PRELOAD, CONTACT].concat(),
            false,
            900.0,
            17.25 - 2.5 - 0.2 * 200f64.sqrt(),
        ),
        // S is 400 N of the 1000 N under which 4 um settle, and 920 N at the most.
        displacement("settling and friction", &[SETTLING, FRICTION].concat(), false, 480.0, 5.0 + 1.6),
        displacement("settling and friction", &[SETTLING, FRICTION].concat(), true, 480.0, 7.0 + 3.68),
        displacement("settling and friction", &[SETTLING, FRICTION].concat(), true, 0.0, 1.0 + 3.68),
        displacement("gauge off zero and gap", &[OFFSET, GAP].concat(), false, 0.0, -3.0),
        displacement("gauge off zero and gap", &[OFFSET, GAP].concat(), true, 80.0, 1.0 + 5.0 - 3.0),
        displacement("all four", &all, false, 480.0, expected(400.0)),
        displacement("all four", &all, false, 1000.0, expected(920.0)),
        displacement("all four", &all, true, 500.0, expected(580.0)),
        displacement("all four", &all, true, 0.0, expected(80.0)),
    ]
}

/// dF/dy by hand, and against the curve's own differences.
fn tangents() -> Vec<Case> {
    let tangent = |effects: &str, force: f64, branch: Branch| {
        joint(effects).and_then(|j| j.machine().curve.tangent(force, branch)).map_or(f64::NAN, |k| 1e-6 * k)
    };
    let by_hand = |name: &str, expected: f64, computed: f64| {
        row(name, "tangent stiffness", (expected, computed, "N/um"), ROUND_OFF, "seed 000: dP/dy")
    };
    let all = [GAP, CONTACT, FRICTION, PRELOAD].concat();
    // A central difference over h leaves h²/6 of the third derivative: what one over 2h differs by is three times that.
    let (h, f) = (0.5, 300.0);
    let curve = joint(&all);
    let over = |h: f64| 2.0 * h / (up(&curve, f + h) - up(&curve, f - h));
    let (difference, left_out) = (over(h), (over(2.0 * h) / over(h) - 1.0).abs() / 3.0);
    vec![
        by_hand("spring", 80.0, tangent("", 300.0, Branch::Load)),
        by_hand("contact under 400 N", 1.0 / (1.0 / 80.0 + 0.1 / 20.0), tangent(CONTACT, 400.0, Branch::Load)),
        by_hand("settling, loading", 1.0 / (1.0 / 80.0 + 4e-3), tangent(SETTLING, 300.0, Branch::Load)),
        by_hand("settling, unloading", 80.0, tangent(SETTLING, 300.0, Branch::Unload)),
        by_hand("preload, both springs", 160.0, tangent(PRELOAD, 300.0, Branch::Load)),
        by_hand("preload, one spring relaxed", 80.0, tangent(PRELOAD, 500.0, Branch::Load)),
        by_hand("friction, unloading", 80.0, tangent(FRICTION, 300.0, Branch::Unload)),
        by_hand(
            "friction and contact, unloading at 320 N",
            1.0 / (1.0 / 80.0 + 0.1 / 20.0),
            tangent(&[CONTACT, FRICTION].concat(), 320.0, Branch::Unload),
        ),
        row(
            "all four under 300 N",
            "tangent stiffness",
            (difference, tangent(&all, f, Branch::Load), "N/um"),
            Tolerance::Relative(2.0 * left_out + 1e-10),
            "seed 000: dP/dy by the central difference over 1 N; tolerance: twice its remainder",
        ),
    ]
}
