//! Cases of terms that a budget computes itself, by hand, and of laws by their coefficient.

use super::rig::{budget, moments, row};
use crate::validation::{Case, Tolerance};

/// Round-off of a few products of doubles.
const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);
/// Samples in every drawn row.
const SAMPLES: usize = 200_000;

pub fn cases() -> Vec<Case> {
    [sizes(), batch(), laws()].concat()
}

fn error(name: &str, kind: &str, size: &str) -> String {
    format!("[[error]]\nname = \"{name}\"\nkind = \"{kind}\"\n{size}\n")
}

fn total(errors: &[String]) -> f64 {
    budget(&format!("budget = {{ samples = 100 }}\n{}", errors.concat())).map_or(f64::NAN, |e| e.handbook.total)
}

const INHERITANCE: &str =
    "inheritance = { blank = \"520 um\", force_per_depth = \"0.8 N/um\", system_stiffness = \"20 N/um\" }";
const WEAR: &str = "wear = { rate = \"6 um/km\", path = \"1.5 km\" }";
/// 2 kcal/(kg K · 1e-3 m³ · 8 kg/dm³) of a body with c = 0.1 kcal/(kg K) is 2.5 K.
const HEATING: &str = "heating = { heat = \"2 kcal\", volume = \"1000 cm^3\", length = \"160 mm\", material = \
                       { base = \"steel\", specific_heat = \"0.1 kcal/kg/K\", density = \"8000 kg/m^3\" } }";

fn sizes() -> Vec<Case> {
    let alone = |size: &str| total(&[error("term", "systematic", size)]);
    let inheritance = 0.8 * 520.0 / 20.8;
    let machine = |size: &str| alone(&format!("machine = {{ {size} }}"));
    let template = |grade: &str| alone(&format!("template = {{ grade = \"{grade}\" }}"));
    let root = |making: f64, mounting: f64| (3.0 * (making * making + mounting * mounting)).sqrt();
    let of =
        |name: &str, expected: f64, computed: f64, source| row(name, "error", (expected, computed), ROUND_OFF, source);
    let classes = "seed 002, classes of accuracy";
    let ranges = "seed 002, setting by a template: 10 to 20 and 2 to 50 um";
    let clamping = |base: &str| {
        alone(&format!(
            "clamping = {{ c_min = \"0.2 um/N^n\", c_max = \"0.3 um/N^n\", force_min = \"1600 N\", \
             force_max = \"2500 N\", n = 0.5, base = \"{base}\" }}"
        ))
    };
    vec![
        of("clamping, size from the face that moves", 7.0, clamping("moves"), "seed 002 (30)"),
        row(
            "clamping, size from a face that stays",
            "error",
            (0.0, clamping("stays")),
            Tolerance::Absolute(1e-12),
            "seed 002 (30), figure",
        ),
        of("inherited from a blank", inheritance, alone(INHERITANCE), "seed 002 (27)"),
        of("wear over a path", 9.0, alone(WEAR), "seed 002 (32)"),
        of("heated part", 11.5e-6 * 160e3 * 2.5, alone(HEATING), "seed 002 (35), (36)"),
        of("machine of class N", 30.0, machine("class = \"N\", normal = \"30 um\""), classes),
        of("machine of class P", 18.0, machine("class = \"P\", normal = \"30 um\""), classes),
        of("machine of class V", 12.0, machine("class = \"V\", grade = \"medium\""), classes),
        of("machine of class A", 2.4, machine("class = \"A\", grade = \"fine\""), classes),
        of("machine of class S", 8.0, machine("class = \"S\", grade = \"coarse\""), classes),
        of("fine template", root(10.0, 2.0), template("fine"), ranges),
        of("medium template", root(15.0, 26.0), template("medium"), ranges),
        of("coarse template", root(20.0, 50.0), template("coarse"), ranges),
    ]
}

/// (51) with every term from its law: Δ_γ = 20, ε = 5, Δ_и = 9, Δ_т = 4.6, Δ_н = √3·26, ΣΔ_ф = 18 − 2 um.
fn batch() -> Vec<Case> {
    let errors = [
        error("blank", "random", INHERITANCE),
        error("basing", "random", "value = \"5 um\"\ndistribution = \"normal\""),
        error("wear", "random", WEAR),
        error("heat", "random", HEATING),
        error("setting", "systematic", "template = { making = \"10 um\", mounting = \"24 um\" }"),
        error("machine", "systematic", "machine = { class = \"P\", normal = \"30 um\" }"),
        error("clamping", "systematic", "value = \"-2 um\""),
    ];
    let root = (400.0f64 + 25.0 + 3.0 * 81.0 + 3.0 * 4.6 * 4.6).sqrt();
    // Setting and machine, whose signs are unknown, take the side of the clamping.
    let expected = root + 3f64.sqrt() * 26.0 + 18.0 + 2.0;
    vec![row("batch with computed terms", "total", (expected, total(&errors)), ROUND_OFF, "seed 002 (51)")]
}

/// λ = 1/5: Δ = 12 um scatters by √(144/5); κ = 3 − 6λ/(1 + 2λ) of a symmetric beta law.
fn laws() -> Vec<Case> {
    let law = |lambda: f64, half: f64| error("e", "random", &format!("value = \"{half} um\"\nlambda = {lambda}"));
    let root = row(
        "lambda 0.2 of 12 um and 0.4 of 6 um",
        "random sum",
        (3.0 * (0.2f64 * 144.0 + 0.4 * 36.0).sqrt(), total(&[law(0.2, 12.0), law(0.4, 6.0)])),
        ROUND_OFF,
        "seed 002 (42), any lambda",
    );
    let source = "moments of the symmetric beta law; three standard errors";
    let mut cases = vec![root];
    for lambda in [0.15, 0.2, 0.45] {
        let known = (0.0, 12.0 * f64::sqrt(lambda), 3.0 - 6.0 * lambda / (1.0 + 2.0 * lambda));
        let name = format!("200 000 draws of an error of 12 um with lambda {lambda}");
        cases.extend(moments(&name, (&law(lambda, 12.0), SAMPLES), known, source));
    }
    cases
}
