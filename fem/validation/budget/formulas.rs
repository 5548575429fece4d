//! Cases of the formulas (33)–(52) of the handbook.

use super::rig::{budget, row};
use crate::budget::{Drill, Estimate};
use crate::validation::{Case, Tolerance};

/// Round-off of sums of doubles.
const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

pub fn cases() -> Vec<Case> {
    [sums(), setting(), setup(), batch(), drill(), risks()].concat()
}

/// Few samples, for the handbook's rules alone are tested.
const FEW: &str = "samples = 100";

fn error(name: &str, kind: &str, size: &str) -> String {
    format!("[[error]]\nname = \"{name}\"\nkind = \"{kind}\"\n{size}\n")
}

fn random(half: f64, law: &str) -> String {
    error("e", "random", &format!("value = \"{half} um\"\ndistribution = \"{law}\""))
}

fn of(rules: &str, errors: &[String], figure: fn(&Estimate) -> f64) -> f64 {
    let text = format!("[budget]\n{FEW}\n{rules}\n{}", errors.concat());
    budget(&text).map_or(f64::NAN, |e| figure(&e))
}

fn total(rules: &str, errors: &[String]) -> f64 {
    of(rules, errors, |e| e.handbook.total)
}

fn sums() -> Vec<Case> {
    let fixed = |value: f64| error("e", "systematic", &format!("value = \"{value} um\""));
    let systematic = [fixed(12.0), fixed(-5.0), fixed(2.5)];
    let all = [random(9.0, "normal"), random(6.0, "triangular"), random(3.0, "uniform"), random(3.0, "unknown")];
    // λΔ²: 9 + 6 + 3 + 3.
    let root = 21f64.sqrt();
    let both = [&systematic[..2], &all[..]].concat();
    vec![
        row(
            "+12, -5 and +2.5 um",
            "systematic sum",
            (9.5, of("", &systematic, |e| e.handbook.systematic)),
            ROUND_OFF,
            "seed 002 (40)",
        ),
        row("four laws, t = 1", "random sum", (root, total("t = 1.0", &all)), ROUND_OFF, "seed 002 (42)"),
        row("four laws, t = 2", "random sum", (2.0 * root, total("t = 2.0", &all)), ROUND_OFF, "seed 002 (42)"),
        row("four laws, t = 3", "random sum", (3.0 * root, total("", &all)), ROUND_OFF, "seed 002 (42)"),
        row(
            "variances of two laws",
            "random sum",
            (50f64.sqrt(), total("t = 1.0", &[random(3.0, "normal"), random(147f64.sqrt(), "uniform")])),
            ROUND_OFF,
            "seed 002 (43)",
        ),
        row("systematic and random", "total", (7.0 + 3.0 * root, total("", &both)), ROUND_OFF, "seed 002, third rule"),
        row(
            "systematic below zero and random",
            "total",
            (5.0 + 3.0 * root, total("", &[&systematic[1..2], &all[..]].concat())),
            ROUND_OFF,
            "seed 002, third rule",
        ),
    ]
}

fn setting() -> Vec<Case> {
    // T = 72 um over 6 and √9 parts is 4 um.
    let parts = "trial_parts = { measuring = \"3 um\", adjusting = \"12 um\", field = \"72 um\", parts = 9 }";
    let trial = |law: &str| [error("setting", "systematic", &format!("{parts}\n{law}"))];
    let template = [error("setting", "systematic", "template = { making = \"5 um\", mounting = \"12 um\" }")];
    let components = [3e-6, 12e-6, 4e-6];
    vec![
        row(
            "calculated from nine parts",
            "error",
            (4.0, crate::budget::rules::calculation(72e-6, 9)),
            ROUND_OFF,
            "seed 002 (33), (34)",
        ),
        row(
            "setting, t = 2",
            "error",
            (2.0 / 3f64.sqrt() * 13.0, crate::budget::rules::setting(2.0, &components)),
            ROUND_OFF,
            "seed 002 (44)",
        ),
        row("setting, normal", "error", (3f64.sqrt() * 13.0, total("", &trial(""))), ROUND_OFF, "seed 002 (45)"),
        row(
            "setting, uniform",
            "error",
            (13.0, total("", &trial("distribution = \"uniform\""))),
            ROUND_OFF,
            "seed 002 (46)",
        ),
        row(
            "setting of unknown sign beside a form of -8 um",
            "total",
            (
                13.0 + 8.0,
                total(
                    "",
                    &[trial("distribution = \"uniform\"")[0].clone(), error("form", "systematic", "value = \"-8 um\"")],
                ),
            ),
            ROUND_OFF,
            "seed 002 (50): the two add",
        ),
        row(
            "setting by a template",
            "error",
            (3f64.sqrt() * 13.0, total("", &template)),
            ROUND_OFF,
            "seed 002 (42), lambda 1/3",
        ),
    ]
}

const CLAMPING: &str = "clamping = { c_min = \"0.2 um/N^n\", c_max = \"0.3 um/N^n\", force_min = \"1600 N\", force_max = \"2500 N\", n = 0.5 }";
const LOCATING: &str = "locating = { locators = \"6 um\", wear = \"2 um\", mounting = \"1 um\" }";

fn setup() -> Vec<Case> {
    // √2500 − √1600 = 10: y₁ = 2 um, y₂ = 3 um.
    let clamping = error("clamping", "random", CLAMPING);
    let locating = error("locating", "random", LOCATING);
    let basing = random(12.0, "normal");
    let same = error("locating", "systematic", LOCATING);
    vec![
        row(
            "clamping, Q and c vary",
            "error",
            (13f64.sqrt(), total("", std::slice::from_ref(&clamping))),
            ROUND_OFF,
            "seed 002 (47), less the misprinted Q_max^n",
        ),
        row(
            "locating in a fixture",
            "error",
            (7.0, total("", std::slice::from_ref(&locating))),
            ROUND_OFF,
            "seed 002 (48)",
        ),
        row(
            "basing, clamping and fixtures",
            "setup error",
            ((144.0 + 13.0 + 49f64).sqrt(), total("", &[basing.clone(), clamping.clone(), locating])),
            ROUND_OFF,
            "seed 002 (49)",
        ),
        row(
            "basing and clamping in one fixture",
            "setup error",
            (7.0 + 157f64.sqrt(), total("", &[basing, clamping, same])),
            ROUND_OFF,
            "seed 002 (52)",
        ),
    ]
}

/// A batch in one fixture on one machine at one setting.
fn batch() -> Vec<Case> {
    let in_setup = |e: String| format!("{e}group = \"setup\"\n");
    let errors = |grouped: bool| {
        let member = |e: String| if grouped { in_setup(e) } else { e };
        [
            if grouped { "[[group]]\nname = \"setup\"\n".to_string() } else { String::new() },
            random(9.0, "normal"),
            member(error("basing", "random", "value = \"12 um\"\ndistribution = \"normal\"")),
            member(error("clamping", "random", CLAMPING)),
            member(error("locating", "systematic", LOCATING)),
            random(4.0, "uniform"),
            random(2.0, "uniform"),
            error("setting", "systematic", "value = \"11 um\""),
            error("form", "systematic", "value = \"8 um\""),
        ]
    };
    let setup = 7.0 + 157f64.sqrt();
    let printed = (81.0 + setup * setup + 3.0 * 16.0 + 3.0 * 4.0).sqrt() + 19.0;
    let by_rule = (81.0 + 157.0 + 3.0 * 16.0 + 3.0 * 4.0f64).sqrt() + 26.0;
    let grouped = errors(true);
    let one_by_one = of("", &grouped, |e| e.handbook.one_by_one.unwrap_or(f64::NAN));
    let rules = crate::budget::rules::batch(9e-6, 1e-6 * setup, 4e-6, 2e-6, 11e-6, 8e-6);
    vec![
        row(
            "batch in one fixture, as printed",
            "total",
            (printed, total("", &grouped)),
            ROUND_OFF,
            "seed 002 (50)-(52)",
        ),
        row("batch in one fixture, closed form", "total", (printed, rules), ROUND_OFF, "seed 002 (51)"),
        row(
            "batch in one fixture, fixture added arithmetically",
            "total",
            (by_rule, one_by_one),
            ROUND_OFF,
            "seed 002, third rule, against (51)",
        ),
        row(
            "batch in one fixture, without groups",
            "total",
            (by_rule, total("", &errors(false))),
            ROUND_OFF,
            "seed 002, third rule, against (51)",
        ),
    ]
}

/// T = a_max + T_i + Δ_и − a_min with 30 + 18 + 12 − 10 um.
fn drill() -> Vec<Case> {
    let of = |drill, wear, tolerance| Drill::new((30e-6, 10e-6), drill, wear, tolerance);
    let figure = |found: Option<Drill>, figure: fn(&Drill) -> f64| found.as_ref().map_or(f64::NAN, figure);
    let source = "seed 002 (41)";
    vec![
        row(
            "drilled hole",
            "tolerance",
            (50.0, figure(of(Some(18e-6), Some(12e-6), None), |d| d.tolerance)),
            ROUND_OFF,
            source,
        ),
        row(
            "drilled hole of 50 um",
            "tolerance of the drill",
            (18.0, figure(of(None, Some(12e-6), Some(50e-6)), |d| d.drill_tolerance)),
            ROUND_OFF,
            source,
        ),
        row(
            "drilled hole of 50 um",
            "allowed wear",
            (12.0, figure(of(Some(18e-6), None, Some(50e-6)), |d| d.wear)),
            ROUND_OFF,
            source,
        ),
        row(
            "drilled hole of 40 um",
            "lacking",
            (-10.0, figure(of(Some(18e-6), Some(12e-6), Some(40e-6)), Drill::left)),
            ROUND_OFF,
            source,
        ),
    ]
}

/// The handbook prints 32, 4.5 and 0.27 %.
fn risks() -> Vec<Case> {
    let case = |(t, printed, precision): (f64, f64, f64)| {
        let text = format!("budget = {{ t = {t:?} }}\n[[error]]\nname = \"e\"\nkind = \"random\"\nvalue = \"1 um\"");
        let read = crate::budget::Budget::parse(crate::input::Source::new("budget.toml", text)).ok();
        Case {
            name: format!("t = {t}"),
            quantity: "risk",
            expected: printed,
            computed: read.map_or(f64::NAN, |b| 100.0 * b.risk()),
            unit: "%",
            tolerance: Tolerance::Absolute(precision),
            source: "seed 002 (42); tolerance: one in the last digit printed",
        }
    };
    [(1.0, 32.0, 1.0), (2.0, 4.5, 0.1), (3.0, 0.27, 0.01)].map(case).to_vec()
}
