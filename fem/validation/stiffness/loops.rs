//! Areas between loading and unloading.

use super::curves::{CONTACT, FRICTION, GAP, OFFSET, PRELOAD, SETTLING};
use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [polygons(), quadrature(), reversals()].concat()
}

/// Work of friction, uJ.
fn area(effects: &str) -> f64 {
    joint(effects).map_or(f64::NAN, |j| 1e6 * j.machine().curve.loop_area())
}

/// ∮F dy over corners (y um, F N), uJ: the shoelace formula, clockwise in the plane of force over
/// displacement.
fn shoelace(corners: &[(f64, f64)]) -> f64 {
    let next = |i: usize| corners[(i + 1) % corners.len()];
    let twice: f64 = (0..corners.len()).map(|i| corners[i].0 * next(i).1 - next(i).0 * corners[i].1).sum();
    -0.5 * twice
}

/// Curves of straight lines enclose polygons.
fn polygons() -> Vec<Case> {
    let case = |name: &str, effects: &str, corners: &[(f64, f64)]| {
        let (expected, computed) = (shoelace(corners), area(effects));
        row(
            name,
            "work of friction",
            (expected, computed, "uJ"),
            ROUND_OFF,
            "seed 000, area between the branches: shoelace formula",
        )
    };
    let soft = [(0.0, 0.0), (0.0, 80.0), (11.5, 1000.0), (11.5, 840.0), (1.0, 0.0)];
    // Friction holds until 80 N, which then cross the clearance; they still press when the force is gone.
    let played = [(0.0, 0.0), (0.0, 80.0), (5.0, 80.0), (16.5, 1000.0), (16.5, 840.0), (6.0, 0.0)];
    // 2k up to S = 400 N.
    let preloaded = [(0.0, 0.0), (0.0, 80.0), (2.5, 480.0), (9.0, 1000.0), (9.0, 840.0), (2.5, 320.0), (0.5, 0.0)];
    let held = [(0.0, 0.0), (0.0, 600.0), (5.0, 1000.0), (5.0, 0.0)];
    let settled = [(0.0, 0.0), (16.5, 1000.0), (4.0, 0.0)];
    let both = [(0.0, 0.0), (0.0, 80.0), (15.18, 1000.0), (15.18, 840.0), (4.68, 0.0)];
    let none = |name: &str, effects: &str| {
        row(
            name,
            "work of friction",
            (0.0, area(effects), "uJ"),
            Tolerance::Absolute(0.0),
            "seed 000, area between the branches: elastic, no work is lost",
        )
    };
    vec![
        case("friction", FRICTION, &soft),
        case("friction and gap", &[FRICTION, GAP].concat(), &played),
        case("friction and preload", &[FRICTION, PRELOAD].concat(), &preloaded),
        case("friction of 600 N, which holds all", "[dry-friction]\nforce = \"600 N\"", &held),
        case("settling, and a gauge off zero", &[SETTLING, OFFSET].concat(), &settled),
        case("settling and friction", &[SETTLING, FRICTION].concat(), &both),
        none("gap, contact and preload without friction", &[GAP, CONTACT, PRELOAD].concat()),
    ]
}

/// Curved branches, ∮F dy by the trapezoidal rule over the predicted displacements.
fn quadrature() -> Vec<Case> {
    let case = |name: &str, effects: &str| {
        let joint = joint(effects);
        let over = |steps: usize| {
            let force = |i: usize| 1000.0 * i as f64 / steps as f64;
            let step =
                |i: usize, y: &dyn Fn(f64) -> f64| 0.5 * (force(i) + force(i + 1)) * (y(force(i + 1)) - y(force(i)));
            (0..steps).map(|i| step(i, &|f| up(&joint, f)) - step(i, &|f| down(&joint, f))).sum::<f64>()
        };
        // Steps that fall on the corners; the error beside the root where S begins falls as the 3/2 power,
        // so that a fourfold refinement leaves an eighth of it, and at most a seventh of the difference
        // remains.
        let (coarse, fine) = (over(2000), over(8000));
        let tolerance = Tolerance::Absolute((fine - coarse).abs());
        let source =
            "seed 000, area between the branches: trapezoidal rule, 8000 steps; tolerance: its change from 2000";
        row(name, "work of friction", (fine, area(effects), "uJ"), tolerance, source)
    };
    vec![
        case("friction and contact", &[FRICTION, CONTACT].concat()),
        case("friction, contact and preload", &[FRICTION, CONTACT, PRELOAD].concat()),
        case(
            "friction of 45 N and contact of n = 0.8",
            "[dry-friction]\nforce = \"45 N\"\n[contact-joint]\nc = \"0.1 um/N^n\"\nn = 0.8",
        ),
    ]
}

/// Forces of both signs: a polygon, and the trapezoidal rule.
fn reversals() -> Vec<Case> {
    let lost = |effects: &str| reversed(effects).map_or(f64::NAN, |j| 1e6 * j.machine().curve.loop_area());
    let put_in = |effects: &str| reversed(effects).map_or(f64::NAN, |j| 1e6 * j.machine().curve.work_of_loading());
    let corners = [(-11.5, -1000.0), (-11.5, -840.0), (11.5, 1000.0), (11.5, 840.0)];
    // Under 80 N of either sign nothing is transmitted, and the clearance is crossed.
    let open = [
        (-11.5, -1000.0),
        (-11.5, -840.0),
        (0.0, 80.0),
        (5.0, 80.0),
        (16.5, 1000.0),
        (16.5, 840.0),
        (5.0, -80.0),
        (0.0, -80.0),
    ];
    let polygon = |name: &str, corners: &[(f64, f64)], effects: &str| {
        let both = (shoelace(corners), lost(effects), "uJ");
        row(name, "work of friction", both, ROUND_OFF, "seed 000, area between the branches: shoelace formula")
    };
    let curved = [FRICTION, CONTACT, PRELOAD].concat();
    let joint = reversed(&curved);
    let over = |steps: i32| {
        let force = |i: i32| 1000.0 * f64::from(i) / f64::from(steps);
        let step = |i: i32, y: fn(&Option<Machine>, f64) -> f64| {
            0.5 * (force(i) + force(i + 1)) * (y(&joint, force(i + 1)) - y(&joint, force(i)))
        };
        (-steps..steps).map(|i| step(i, up) - step(i, down)).sum::<f64>()
    };
    // Beside the root where one side is relaxed the rule's error falls as the 3/2 power, as above.
    let (coarse, fine) = (over(2000), over(8000));
    let curved = row(
        "force reversed, friction, contact and preload",
        "work of friction",
        (fine, lost(&curved), "uJ"),
        Tolerance::Absolute((fine - coarse).abs()),
        "seed 000, area between the branches: trapezoidal rule, 16000 steps; tolerance: its change from 4000",
    );
    // Out from -1 um by the triangle and the rectangle under F = 80 N + 80 N/um·y to 11.5 um, on either side.
    let driven = 2.0 * (80.0 * 12.5 + 0.5 * 80.0 * (11.5 * 11.5 - 1.0));
    vec![
        polygon("force reversed, friction", &corners, FRICTION),
        polygon("force reversed, friction and gap", &open, &[FRICTION, GAP].concat()),
        row(
            "force reversed, friction",
            "work put in",
            (driven, put_in(FRICTION), "uJ"),
            ROUND_OFF,
            "areas under F = f + k*y, by hand",
        ),
        curved,
    ]
}
