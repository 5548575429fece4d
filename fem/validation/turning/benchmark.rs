//! A stepped shaft on two springs, in agreement with the unit-load method to every printed digit.

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// Ø40|50|40 mm of 180, 240, 180 mm, E 210 GPa, ν 0.3, 500 N.
const STEPPED: &str = r#"
    workpiece = { material = "steel", segments = [
        { length = "180 mm", diameter = "40 mm" }, { length = "240 mm", diameter = "50 mm" }, { length = "180 mm", diameter = "40 mm" } ] }
    workholding = { type = "centres" }
    cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "500 N" }
    mesh = { beam = "BEAM" }
"#;
const SPRINGS: &str =
    "[headstock-compliance]\nstiffness = \"60 N/um\"\n[tailstock-compliance]\nstiffness = \"40 N/um\"";
const CONTACTS: &str =
    "[headstock-contact]\nc = \"0.2 um/N^n\"\nn = 0.5\n[tailstock-contact]\nc = \"0.2 um/N^n\"\nn = 0.5";

/// Deflections in um at L/4, L/2, 3L/4, L as Castigliano's theorem gives them, integrated segment by
/// segment, to the digits printed.
const SLENDER: [f64; 4] = [37.5214415, 51.0045771, 39.6047748, 12.5];
const SHEARED: [f64; 4] = [38.1166809, 51.7181975, 40.2000143, 12.5];
const CLOSING: [f64; 4] = [35.516446, 48.9585214, 35.516446, 4.472136];

pub fn cases() -> Vec<Case> {
    let lathe_of = |beam: &str, effects: &str| lathe(&STEPPED.replace("BEAM", beam), effects);
    [
        table("stepped shaft on springs", &lathe_of("euler-bernoulli", SPRINGS), SLENDER, 5e-8),
        table("stepped shaft on springs, with shear", &lathe_of("timoshenko", SPRINGS), SHEARED, 5e-8),
        table("stepped shaft on contacts Q^0.5", &lathe_of("euler-bernoulli", CONTACTS), CLOSING, 5e-7),
    ]
    .concat()
}

/// `half_digit`: half a unit of the last printed digit, um.
fn table(name: &str, lathe: &Option<Lathe>, expected: [f64; 4], half_digit: f64) -> Vec<Case> {
    let places = [("L/4", 0.15), ("L/2", 0.3), ("3L/4", 0.45), ("L", 0.6)];
    let case = |((place, x), um): ((&str, f64), f64)| {
        let tolerance = Tolerance::Absolute(half_digit);
        row(
            format!("{name}, x = {place}"),
            "deflection",
            (um, 1e6 * gap(lathe, x), "um"),
            tolerance,
            "Castigliano; unit-load method, as printed",
        )
    };
    places.into_iter().zip(expected).map(case).collect()
}
