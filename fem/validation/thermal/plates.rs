//! Plates: growth and bow under a gradient, a passing strip, and a bar that is both rod and plate.

use super::rig::*;
use crate::processes::thermal::follow::Look;
use crate::processes::thermal::report::ground::{Wheel, hollow};
use crate::validation::{Case, Tolerance};

/// 400 × 40 × 100 mm of steel.
const PLATE: &str = r#"
    body = { material = "steel", rectangle = { length = "400 mm", height = "40 mm", width = "100 mm" } }
    environment = { temperature = "20 degC" }
    mesh = { element_size = "10 mm" }
"#;

pub fn cases() -> Vec<Case> {
    let mut cases = gradient();
    cases.extend(through());
    cases.push(strip());
    cases.push(bar());
    cases.extend(ground());
    cases
}

/// A wheel at 10 mm/s over 400 mm: a bow that stays leaves its own depth in the middle; one that grows as b = k·t
/// leaves most where ξ²(1 − ξ) is largest, 16/27·k·L/v at ξ = 2/3.
fn ground() -> Vec<Case> {
    let wheel = Wheel { speed: 10e-3, from: 0.0, length: 0.4 };
    let times: Vec<f64> = (0..=6000).map(|i| 0.01 * f64::from(i)).collect();
    let depth = |bow: fn(f64) -> f64| {
        let bows: Vec<f64> = times.iter().map(|t| bow(*t)).collect();
        hollow(wheel, &times, &bows).map_or([f64::NAN; 2], |(x, depth)| [1e3 * x, 1e6 * depth])
    };
    let ([middle, stays], [place, grows]) = (depth(|_| 20e-6), depth(|t| 1e-6 * t));
    // Steps of 0.1 mm of the wheel: half of one, and the parabola at the top over it.
    let (step, top) = (Tolerance::Absolute(0.05), Tolerance::Relative(1e-6));
    vec![
        row(
            "ground while bowed by 20 um",
            "hollow",
            (20.0, stays, "um"),
            top,
            "seed 002, ground prism: parabola of the bow",
        ),
        row(
            "ground while bowed by 20 um",
            "place",
            (200.0, middle, "mm"),
            step,
            "seed 002, ground prism: parabola of the bow",
        ),
        row(
            "ground while the bow grows by 1 um/s",
            "hollow",
            (40.0 * 16.0 / 27.0, grows, "um"),
            top,
            "seed 002, ground prism: xi^2(1 - xi) at 2/3",
        ),
        row(
            "ground while the bow grows by 1 um/s",
            "place",
            (800.0 / 3.0, place, "mm"),
            step,
            "seed 002, ground prism: xi^2(1 - xi) at 2/3",
        ),
    ]
}

/// Below at 20, above at 32: without stress, whatever the shape of the ends.
fn gradient() -> Vec<Case> {
    let held = r#"
        boundary = [{ edge = "bottom", temperature = "20 degC" }, { edge = "top", temperature = "32 degC" }]
        time = { end = "1e5 min", step = "1e4 min", scheme = "backward-euler" }
    "#;
    let plate = body(&format!("{PLATE}{held}"), "");
    let seen = followed(&plate, &[Look::Elongation, Look::Bow], 6e5, 6e6);
    let last = |look: usize| seen.as_ref().and_then(|f| f.track.values[look].last().copied()).unwrap_or(f64::NAN);
    let one = |quantity, expected: f64, look: usize| {
        let name = "plate of 400 x 40 mm, 12 K warmer above";
        // Quadratic elements hold the gradient and the parabola exactly.
        let tolerance = Tolerance::Relative(1e-8);
        row(name, quantity, (1e6 * expected, 1e6 * last(look), "um"), tolerance, "beam theory, linear gradient")
    };
    vec![one("elongation", ALPHA * 6.0 * 0.4, 0), one("bow", ALPHA * 12.0 * 0.16 / (8.0 * 0.04), 1)]
}

/// 10 kW/m² in above, held at 20 below; and 15 W over the right end into a base of 0.5 W/K.
fn through() -> Vec<Case> {
    let heated = r#"
        boundary = [{ edge = "bottom", temperature = "20 degC" }, { edge = "top", flux = "10 kW/m^2" }]
        time = { end = "1e5 min", step = "1e4 min", scheme = "backward-euler" }
    "#;
    let plate = body(&format!("{PLATE}{heated}"), "");
    let bow = followed(&plate, &[Look::Bow], 6e5, 6e6).and_then(|f| f.track.values[0].last().copied());
    let ended = r#"
        source = [{ at = "400 mm", power = "15 W" }]
        time = { end = "1e7 min", step = "2e5 min", scheme = "backward-euler" }
    "#;
    let held = body(&format!("{PLATE}{ended}"), "[base-conductance]\nconductance = \"0.5 W/K\"");
    let exact = Tolerance::Relative(1e-8);
    vec![
        row(
            "plate of 40 mm, 10 kW/m^2 through it, steady",
            "rise of the top",
            (1e4 * 0.04 / K, temperature_at(&plate, [0.2, 0.04], 6e6) - 20.0, "K"),
            exact,
            "q*H/k",
        ),
        row(
            "plate of 40 mm, 10 kW/m^2 through it, steady",
            "bow",
            (1e6 * ALPHA * 1e4 / K * 0.16 / 8.0, 1e6 * bow.unwrap_or(f64::NAN), "um"),
            exact,
            "alpha*q/k*L^2/8",
        ),
        row(
            "plate on a base of 0.5 W/K, 15 W over its end, steady",
            "rise of the end",
            (30.0 + 15.0 * 0.4 / (K * 0.004), temperature_at(&held, [0.4, 0.02], 6e8) - 20.0, "K"),
            Tolerance::Relative(1e-6),
            "resistances in series",
        ),
    ]
}

/// A strip of 20 mm and 400 kW/m² passes the whole plate at 0.4 m/min.
fn strip() -> Case {
    let passing = r#"
        boundary = [{ edge = "top", moving = { speed = "0.4 m/min", width = "20 mm", flux = "400 kW/m^2", from = "-10 mm" } }]
        time = { end = "2 min", step = "0.5 s" }
    "#;
    let heat = followed(&body(&format!("{PLATE}{passing}"), ""), &[], 0.5, 120.0).map(|f| f.energy.supplied);
    let exact = 4e5 * 0.02 * 0.1 * 0.4 / (0.4 / 60.0);
    // At the ends of the plate the strip enters and leaves in steps of a sixth of its width.
    let tolerance = Tolerance::Relative(1e-3);
    let source = "flux*width*breadth*length/speed";
    row("strip that passes a plate", "heat", (exact, heat.unwrap_or(f64::NAN), "J"), tolerance, source)
}

/// A square bar heated over its end section: one dimension and two must agree.
fn bar() -> Case {
    let (time, x) = (1200.0, 0.13);
    let plate = body(
        r#"
        body = { material = "steel", rectangle = { length = "200 mm", height = "20 mm", width = "15.70796326794897 mm" } }
        source = [{ at = "200 mm", power = "15 W" }]
        environment = { temperature = "20 degC" }
        time = { end = "20 min", step = "10 s" }
        "#,
        "",
    );
    // Sections of 100π mm² both; sixty linear elements along the rod.
    row(
        "bar heated over its end, 20 min, rod against plate",
        "rise at 130 mm",
        (temperature_at(&plate, [x, 0.01], time) - 20.0, rise(&rod(""), x, time), "K"),
        Tolerance::Relative(2e-4),
        "the plane body",
    )
}
