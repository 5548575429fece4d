//! Where laws meet: supports out of line under a shaft that bends, the depth that is left of a nose that has moved,
//! across and up under one root.

use super::rig::*;
use crate::processes::turning::rows::{PART, TIME_OF_ROW};
use crate::validation::Case;

pub fn cases() -> Vec<Case> {
    [supports(), rests(), depth(), roots()].concat()
}

/// Diameter error left at x (m) under hardly any force, m.
fn unpressed(held: &str, effects: &str, x: f64, given: &[(usize, f64)]) -> f64 {
    let text = UNIFORM.replace("HELD", held).replace("400 N", "0 N");
    lathe(&text, effects).map_or(f64::NAN, |l| observed(&l, x, given))
}

/// The same of a shaft that stands on a rest.
fn on_rest(held: &str, rest: &str, effects: &str, x: f64, given: &[(usize, f64)]) -> f64 {
    let text = UNIFORM.replace("HELD\"", &format!("{held}\", steady_rests = [{{ {rest} }}]")).replace("400 N", "0 N");
    lathe(&text, effects).map_or(f64::NAN, |l| observed(&l, x, given))
}

/// A centre and a headstock that stand off: beams whose ends are displaced.
fn supports() -> Vec<Case> {
    let offset = "[tailstock-offset]\noffset = \"30 um\"";
    let drift = "[spindle-thermal-drift]\ndrift = \"20 um\"\ntime_constant = \"30 min\"";
    let bent = |xi: f64| 1.5 * xi * xi - 0.5 * xi * xi * xi;
    let hour = [(TIME_OF_ROW, 3600.0)];
    let d = 20e-6 * (1.0 - (-2f64).exp());
    let mut cases = Vec::new();
    for (xi, place) in [(0.2, "x = 0.2 L"), (0.5, "mid-span"), (0.9, "x = 0.9 L")] {
        let x = 0.5 * xi;
        let mut add = |name: &str, expected: f64, computed: f64, source| {
            cases.push(diameter_error(format!("{name}, {place}"), (expected, computed), source));
        };
        let (clamped, free) = ("clamped and pinned: w = offset*(3*xi^2 - xi^3)/2", "statics");
        add("centre 30 um off, chuck", 60e-6 * bent(xi), unpressed("chuck-and-centre", offset, x, &[]), clamped);
        add("centre 30 um off, centres", 60e-6 * xi, unpressed("centres", offset, x, &[]), free);
        add("headstock drifts, centres", 2.0 * d * (1.0 - xi), unpressed("centres", drift, x, &hour), free);
        add("headstock drifts, chuck", 2.0 * d, unpressed("chuck", drift, x, &hour), free);
        let left = 2.0 * d * (1.0 - bent(xi));
        add("headstock drifts, chuck and centre", left, unpressed("chuck-and-centre", drift, x, &hour), clamped);
    }
    // A centre on a spring: the bent shaft pushes it back, R = δ/(L³/3EI + 1/k).
    let s = shaft40();
    let (l3, k) = (s.length.powi(3) / (3.0 * s.ei), 40e6);
    let soft = format!("{offset}\n[tailstock-compliance]\nstiffness = \"40 N/um\"");
    cases.push(diameter_error(
        "centre 30 um off on 40 N/um, chuck, x = L",
        (60e-6 * l3 / (l3 + 1.0 / k), unpressed("chuck-and-centre", &soft, 0.5, &[])),
        "force method: R = offset/(L^3/3EI + 1/k)",
    ));
    cases
}

/// A rest that stands out of line, and one in the way of a headstock that drifts.
fn rests() -> Vec<Case> {
    let s = shaft40();
    let (k, l) = (30e6, s.length);
    let source = "force method: R = k*(offset - w)";
    let middle = l.powi(3) / (48.0 * s.ei);
    let pushed = 25e-6 * k / (1.0 + k * middle);
    let rest = "at = \"250 mm\", stiffness = \"30 N/um\", offset = \"25 um\"";
    // The chucked shaft is taken along, but for what the rest holds back.
    let (a, drift) = (0.25f64, "[spindle-thermal-drift]\ndrift = \"20 um\"\ntime_constant = \"30 min\"");
    let d = 20e-6 * (1.0 - (-2f64).exp());
    let held = k * d / (1.0 + k * a.powi(3) / (3.0 * s.ei));
    let straight = "at = \"250 mm\", stiffness = \"30 N/um\"";
    let at_end = d - held * a * a * (3.0 * l - a) / (6.0 * s.ei);
    vec![
        diameter_error(
            "rest of 30 N/um, 25 um out of line, centres, mid-span",
            (2.0 * pushed * middle, on_rest("centres", rest, "", 0.25, &[])),
            source,
        ),
        diameter_error(
            "the same, x = L/4",
            (2.0 * pushed * 11.0 / 768.0 * l.powi(3) / s.ei, on_rest("centres", rest, "", 0.125, &[])),
            source,
        ),
        diameter_error(
            "headstock drifts, chuck and a rest in line, x = L",
            (2.0 * at_end, on_rest("chuck", straight, drift, 0.5, &[(TIME_OF_ROW, 3600.0)])),
            source,
        ),
    ]
}

/// Movements of the nose take depth off the cut. At a rigid centre only the carriage yields.
fn depth() -> Vec<Case> {
    // C = 0.8 N/um; j so that C/(C + j) = 0.107.
    let (k, t) = (0.107, 0.5e-3);
    let carriage = format!("[carriage-compliance]\nstiffness = \"{} N/um\"\n", 0.8 / k - 0.8);
    let fed = |effects: &str| {
        let all = format!("{carriage}[force-feedback]\nexponent = 1.0\n{effects}");
        uniform("centres", &all).map_or(f64::NAN, |l| observed(&l, 0.5, &[(PART, 1.0)]))
    };
    let left = |nose: f64| 2.0 * (nose + k * (t - nose));
    let source = "t_d = t - s - y, y = C*t_d/j: seed 002 (17)-(23)";
    let back = "[setting-error]\noffset = \"48 um\"";
    let tapered = "[guideway-taper]\nslope = \"-60 um/m\"";
    let two = format!("{back}\n{tapered}");
    let out = "[setting-error]\noffset = \"600 um\"";
    // Raised by 1.5 mm the nose cuts as if it stood back: bisected, R = √((D/2 + y)² + z²).
    let z = 3e-3f64 * 0.5;
    let gap = super::rig::bisect(0.0, t, |y| y - k / (1.0 - k) * (t - (0.02 + y).hypot(z) + 0.02));
    vec![
        diameter_error("nose 48 um back, C/(C + j) = 0.107", (left(48e-6), fed(back)), source),
        diameter_error("taper of -30 um, C/(C + j) = 0.107", (left(-30e-6), fed(tapered)), source),
        diameter_error("both", (left(18e-6), fed(&two)), source),
        diameter_error("nose back by more than the depth: the blank is left", (2.0 * t, fed(out)), "nothing is cut"),
        diameter_error(
            "nose 1.5 mm above the axis, C/(C + j) = 0.107",
            (2.0 * (0.02 + gap).hypot(z) - 0.04, fed("[guideway-height]\nslope = \"3 mm/m\"")),
            "t_d = t - (R - D/2), bisected",
        ),
    ]
}

/// Yielding stands under the root with the height.
fn roots() -> Vec<Case> {
    let s = shaft40();
    let high = uniform("chuck", "[guideway-height]\nslope = \"5 mm/m\"\n[setting-error]\noffset = \"100 um\"");
    let at = |x: f64| {
        let across = 0.02 + s.force * x.powi(3) / (3.0 * s.ei) + 100e-6;
        let expected = 2.0 * across.hypot(5e-3 * x) - 0.04;
        let computed = high.as_ref().map_or(f64::NAN, |l| observed(l, x, &[]));
        diameter_error(
            format!("chuck, rises 5 mm/m, set 100 um back, x = {x} m"),
            (expected, computed),
            "seed 002 (3), (14): R^2 = (D/2 + P*x^3/3EI + s)^2 + z^2",
        )
    };
    vec![at(0.2), at(0.5)]
}
