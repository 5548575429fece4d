//! Lengths with surroundings of their own, and a base that is held by something else than the room.

use std::f64::consts::PI;

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// A steel rod of Ø20 × 200 mm at 20 degC that nothing heats but what is around it.
const ROD: &str = r#"
    body = { material = "steel", segments = [{ length = "200 mm", diameter = "20 mm" }], temperature = "20 degC" }
    environment = { temperature = "20 degC"AROUND }
    time = { end = "20 h", step = "5 min" }
"#;
/// When all has settled, s: the slowest wave has died by more than e⁻⁵⁰.
const SETTLED: f64 = 72_000.0;

fn around(sections: &str, effects: &str) -> Heated {
    body(&ROD.replace("AROUND", sections), effects)
}

fn at(body: &Heated, x: f64) -> f64 {
    20.0 + rise(body, x, SETTLED)
}

pub fn cases() -> Vec<Case> {
    [bore(), halves(), base()].concat()
}

/// Steam through the bore and air around: a tube that conducts along itself what it will is at one temperature.
fn bore() -> Vec<Case> {
    let text = ROD.replace("diameter = \"20 mm\"", "diameter = \"20 mm\", bore = \"8 mm\"");
    let section = ", section = [{ side = \"bore\", temperature = \"105 degC\", coefficient = \"800 W/m^2/K\" }]";
    let tube = body(&text.replace("AROUND", section), "convection = { coefficient = '12 W/m^2/K' }");
    let [inside, outside] = [800.0 * 0.008, 12.0 * 0.02];
    let settled = (inside * 105.0 + outside * 20.0) / (inside + outside);
    let source = "balance of both films: (h_i d_i T_i + h_o d_o T_o)/(h_i d_i + h_o d_o)";
    // Settled to round-off.
    let tolerance = Tolerance::Relative(1e-9);
    let growth = 1e6 * ALPHA * LENGTH * (settled - 20.0);
    vec![
        row("steam in the bore, air around", "temperature", (settled, at(&tube, 0.07), "degC"), tolerance, source),
        row(
            "steam in the bore, air around",
            "elongation",
            (growth, 1e6 * elongation(&tube, SETTLED), "um"),
            tolerance,
            source,
        ),
    ]
}

/// Two rooms, each around one half of an insulated-ended rod.
fn halves() -> Vec<Case> {
    let section = ", section = [{ to = \"100 mm\", temperature = \"10 degC\" }]";
    let rod = around(section, "convection = { coefficient = '25 W/m^2/K' }");
    let m = (25.0 * PI * 0.02 / (K * AREA)).sqrt();
    let end = 5.0 * (1.0 - 1.0 / (m * 0.1).cosh());
    let source = "fins back to back: 15 -+ 5*(1 - cosh(m x)/cosh(m l)), m^2 = h p/(k A)";
    // Elements of 3.3 mm: (m·h)²/12 of five kelvins.
    let tolerance = Tolerance::Absolute(5.0 * (m * 0.2 / 60.0).powi(2) / 12.0);
    [("at the cold end", 0.0, 15.0 - end), ("in the middle", 0.1, 15.0), ("at the warm end", 0.2, 15.0 + end)]
        .map(|(place, x, expected)| {
            row("rooms at 10 and 20 degC", place, (expected, at(&rod, x), "degC"), tolerance, source)
        })
        .into()
}

/// A base that is held by something at 12 degC, in a room at 20 degC.
fn base() -> Vec<Case> {
    let effects = "base-conductance = { conductance = '0.5 W/K' }\nconvection = { coefficient = '8 W/m^2/K' }";
    let rod = around(", base_temperature = \"12 degC\"", effects);
    let alone = around(", base_temperature = \"12 degC\"", "base-conductance = { conductance = '0.5 W/K' }");
    let m = (8.0 * PI * 0.02 / (K * AREA)).sqrt();
    // kAm·tanh(mL) is what the fin takes per kelvin at its base.
    let fin = K * AREA * m * (m * LENGTH).tanh();
    let at_base = -8.0 * 0.5 / (0.5 + fin);
    let source = "fin, G(T_b - T_0) = k A m tanh(m L) (T_0 - T_a)";
    let tolerance = Tolerance::Absolute(8.0 * (m * 0.2 / 60.0).powi(2) / 12.0);
    let far = 20.0 + at_base / (m * LENGTH).cosh();
    vec![
        row("base at 12 degC, room at 20 degC", "base", (20.0 + at_base, at(&rod, 0.0), "degC"), tolerance, source),
        row("base at 12 degC, room at 20 degC", "free end", (far, at(&rod, LENGTH), "degC"), tolerance, source),
        row(
            "base at 12 degC, nothing else",
            "free end",
            (12.0, at(&alone, LENGTH), "degC"),
            Tolerance::Relative(1e-9),
            "the only way for heat",
        ),
    ]
}
