//! The force law, and the force that the deflection feeds back.

use super::rig::*;
use crate::processes::turning::cut::Conditions;
use crate::validation::{Case, Tolerance};

const CARRIAGE: &str = "[carriage-compliance]\nstiffness = \"20 N/um\"";
const BISECTED: &str = "seed 002 (22), by bisection";

pub fn cases() -> Vec<Case> {
    // At a rigid centre only the carriage yields: j = 20 N/um, C = P₀/t₀ = 400 N / 0.5 mm = 0.8 N/um.
    let (j, c, t) = (20e6, 0.8e6, 0.5e-3);
    let feedback = |e: f64| uniform("centres", &format!("{CARRIAGE}\n[force-feedback]\nexponent = {e}"));
    let root = |j: f64, e: f64| bisect(0.0, t, |y| y - 400.0 * ((t - y) / t).max(0.0).powf(e) / j);
    let conditions = |set_depth| Some(Conditions { force: 400.0, nominal: 400.0, nominal_depth: t, set_depth });
    let linear = feedback(1.0);
    let copied = gap_under(&linear, 0.5, conditions(0.7e-3)) - gap_under(&linear, 0.5, conditions(0.4e-3));
    let left = |name: String, expected, computed, source| {
        row(name, "residual depth", (expected, computed, "m"), ROUND_OFF, source)
    };
    let copy = (c * 0.3e-3 / (j + c), copied, "m");
    let idle = (0.0, gap_under(&linear, 0.5, conditions(-0.1e-3)), "m");
    let mut cases = vec![
        left("force fed back, exponent 1".into(), c * t / (j * (1.0 + c / j)), gap(&linear, 0.5), "seed 002 (23)"),
        row("blank's error of 0.3 mm copied", "error", copy, ROUND_OFF, "seed 002 (25)-(27)"),
        row("refinement", "q", ((j + c) / c, 0.3e-3 / copied, "-"), ROUND_OFF, "seed 002 (27), (28)"),
        row(
            "blank smaller than the set diameter",
            "deflection",
            idle,
            Tolerance::Absolute(0.0),
            "the tool does not touch",
        ),
    ];
    for e in [0.6, 0.75, 0.9] {
        cases.push(left(format!("force fed back, exponent {e}"), root(j, e), gap(&feedback(e), 0.5), BISECTED));
    }
    // At mid-span the shaft yields too.
    let s = shaft40();
    let middle = root(1.0 / (1.0 / j + s.length.powi(3) / (48.0 * s.ei)), 0.9);
    cases.push(left("force fed back, exponent 0.9, mid-span".into(), middle, gap(&feedback(0.9), 0.25), BISECTED));
    let series = 1.0 / (1.0 / j + s.length.powi(3) / (48.0 * s.ei));
    let both = c * t / (series * (1.0 + c / series));
    cases.push(left("force fed back, work and tool in series".into(), both, gap(&linear, 0.25), "seed 002 (17)-(23)"));
    // So soft that the blank's error goes over nearly whole: C/(j + C) of it.
    let soft = uniform("centres", "[carriage-compliance]\nstiffness = \"0.01 N/um\"\n[force-feedback]\nexponent = 1.0");
    let inherited = gap_under(&soft, 0.5, conditions(0.7e-3)) - gap_under(&soft, 0.5, conditions(0.4e-3));
    let part = (0.8 / 0.81, inherited / 0.3e-3, "-");
    cases.push(row("carriage of 0.01 N/um", "part inherited", part, ROUND_OFF, "seed 002 (27): j far below C"));
    cases.extend(hardly_cutting());
    cases.push(force_law());
    cases.extend(kienzle());
    cases
}

/// So soft that hardly any of the depth is cut: a chucked Ø10 × 1000 mm shaft under 200 N per 0.1 mm.
fn hardly_cutting() -> Vec<Case> {
    let text = UNIFORM
        .replace("HELD", "chuck")
        .replace("500 mm", "1 m")
        .replace("40 mm", "10 mm")
        .replace("0.5 mm", "0.1 mm")
        .replace("400 N", "200 N");
    let ei = 210e9 * std::f64::consts::PI * 0.01f64.powi(4) / 64.0;
    let (j, t) = (3.0 * ei, 0.1e-3f64);
    let computed = |e: f64| gap(&lathe(&text, &format!("[force-feedback]\nexponent = {e}")), 1.0);
    // The depth cut is a root over many powers of ten: bisected in its logarithm.
    let expected = |e: f64| {
        let cut = bisect(-700.0, 0.0, |log| log.exp() * t + 200.0 / j * (e * log).exp() - t);
        t - t * cut.exp()
    };
    let case = |e: f64| {
        let name = format!("hardly any depth cut, exponent {e}");
        row(name, "residual depth", (expected(e), computed(e), "m"), ROUND_OFF, BISECTED)
    };
    vec![case(0.1), case(0.3), case(0.5)]
}

fn force_law() -> Case {
    let text = UNIFORM
        .replace("HELD", "centres")
        .replace("radial_force = \"400 N\"", "force = { C = 243.0, x = 0.9, y = 0.6, n = 0.3, HB = 200.0 }");
    // 0.2^0.6·0.5^0.9·200^0.3 = (0.2²·0.5³·200)^0.3 = 1, so that P = C.
    let computed = lathe(&text, "").map_or(f64::NAN, |l| l.setup().conditions(0.0, 0.0).force);
    row("force law, s = 0.2 mm/rev, t = 0.5 mm", "radial force", (243.0, computed, "N"), ROUND_OFF, "seed 002 (16)")
}

/// Specific cutting forces kc(h) as a table prints them, rounded to 5 N/mm², against the law of their kc1.1 and mc; and a chip
/// that is thinner and wider by the approach angle, worked out by hand.
fn kienzle() -> Vec<Case> {
    const PRINTED: &[(&str, f64, f64, [f64; 4])] = &[
        ("E295", 1500.0, 0.30, [2995.0, 2600.0, 1845.0, 1605.0]),
        ("C35E", 1450.0, 0.27, [2700.0, 2380.0, 1750.0, 1540.0]),
        ("9SMn28", 1310.0, 0.18, [1985.0, 1820.0, 1485.0, 1365.0]),
        ("16MnCr5", 1400.0, 0.30, [2795.0, 2425.0, 1725.0, 1495.0]),
    ];
    let force = |law: &str, depth: &str, feed: f64| {
        let text = UNIFORM.replace("HELD", "centres").replace("0.5 mm", depth);
        let text = text.replace("0.2 mm/rev", &format!("{feed} mm/rev"));
        let text = text.replace("radial_force = \"400 N\"", &format!("force = {{ {law} }}"));
        lathe(&text, "").map_or(f64::NAN, |l| l.setup().conditions(0.0, 0.0).force)
    };
    let mut cases = Vec::new();
    for (name, kc, mc, printed) in PRINTED {
        for (thickness, expected) in [0.1, 0.16, 0.5, 0.8].into_iter().zip(printed) {
            let law = format!("kc = \"{kc} MPa\", mc = {mc}, radial_share = 1.0");
            // All of the cutting force on a chip 1 mm wide.
            let computed = force(&law, "1 mm", thickness) / thickness;
            let name = format!("Kienzle, {name}, h = {thickness} mm");
            let source = "Fachkunde Metall (Europa-Lehrmittel), specific cutting force in turning";
            cases.push(row(name, "kc", (*expected, computed, "N/mm^2"), Tolerance::Absolute(2.5), source));
        }
    }
    // h = 0.2·sin 75°, b = 2/sin 75°, kc = 1600·h^-0.25 = 2413.4 N/mm².
    let computed = force("material = \"C45\", approach_angle = \"75 deg\", radial_share = 1.0", "2 mm", 0.2);
    let (h, b) = (0.2 * 75f64.to_radians().sin(), 2.0 / 75f64.to_radians().sin());
    let expected = 1600.0 * b * h.powf(0.75);
    let name = "Kienzle, C45 by name, edge at 75 deg";
    cases.push(row(name, "cutting force", (expected, computed, "N"), ROUND_OFF, "Kienzle (1952), by hand"));
    cases
}
