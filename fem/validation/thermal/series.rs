//! Rods and slabs against the series and closed forms of conduction.

use std::f64::consts::PI;

use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let plain = rod("");
    for minutes in [5.0, 20.0, 60.0] {
        for (x, place) in [(0.0, "rise of the base"), (0.1, "rise half way"), (0.2, "rise of the heated end")] {
            cases.push(row(
                format!("insulated rod, heated end, {minutes} min"),
                place,
                (heated_end(x, 60.0 * minutes), rise(&plain, x, 60.0 * minutes), "K"),
                // Sixty elements of length h leave q·h²/(12·k·L) everywhere, steps of 10 s as little;
                // all is a part of what the heated end has.
                Tolerance::Absolute(2e-4 * heated_end(LENGTH, 60.0 * minutes)),
                "Carslaw and Jaeger, 3.8 (3)",
            ));
        }
    }
    cases.push(row(
        "insulated rod, heated end, 60 min",
        "elongation",
        (1e6 * ALPHA * POWER * 3600.0 / (RHO_C * AREA), 1e6 * elongation(&plain, 3600.0), "um"),
        Tolerance::Relative(1e-9),
        "seed 002 (35)-(37): all heat stays inside",
    ));
    cases.extend(half_space());
    cases.extend(slab());
    cases.extend(block());
    cases
}

/// A rod of length l, insulated, with a power into its end.
fn heated_end(x: f64, time: f64) -> f64 {
    let diffusivity = K / RHO_C;
    let term = |n: i32| {
        let n = f64::from(n);
        let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
        sign / (n * n) * (-diffusivity * (n * PI / LENGTH).powi(2) * time).exp() * (n * PI * x / LENGTH).cos()
    };
    let series: f64 = (1..500).map(term).sum();
    let parabola = (3.0 * x * x - LENGTH * LENGTH) / (6.0 * LENGTH * LENGTH);
    POWER / AREA * (time / (RHO_C * LENGTH) + LENGTH / K * (parabola - 2.0 / (PI * PI) * series))
}

/// A rod of 1 m is half a space for minutes: 2·q·√(αt/π)/k at the surface, and the integral of the
/// error function below it.
fn half_space() -> Vec<Case> {
    let text = ROD.replace("200 mm", "1000 mm").replace("step = \"10 s\"", "step = \"2 s\"");
    let long = body(&format!("{text}\nmesh = {{ element_size = \"1 mm\" }}"), "");
    let rise_at = |depth: f64, time: f64| {
        let spread = 2.0 * (K / RHO_C * time).sqrt();
        let z = depth / spread;
        POWER / AREA / K * spread * ((-z * z).exp() / PI.sqrt() - z * erfc(z))
    };
    let one = |depth: f64, time: f64| {
        row(
            format!("half a space under a flux, {:.0} mm deep after {time:.0} s", 1e3 * depth),
            "rise",
            (rise_at(depth, time), rise(&long, 1.0 - depth, time), "K"),
            // Elements of 1 mm over a spread of 57 mm and more; 30 and more steps after the start.
            Tolerance::Relative(3e-4),
            "Carslaw and Jaeger, 2.9 (7)",
        )
    };
    vec![one(0.0, 60.0), one(0.0, 300.0), one(0.03, 300.0)]
}

/// A slab of 2 m, k = ρc = 1, from 0 to faces of 100.
fn slab() -> Vec<Case> {
    let slab = body(
        r#"
        body = { material = { base = "steel", conductivity = "1 W/m/K", density = "1 kg/m^3", specific_heat = "1 J/kg/K" }, rectangle = { length = "2 m", height = "0.05 m", width = "0.05 m" } }
        boundary = [{ edge = "left", temperature = "100 degC" }, { edge = "right", temperature = "100 degC" }]
        environment = { temperature = "0 degC" }
        time = { end = "0.1 s", step = "0.0005 s" }
        mesh = { element_size = "25 mm" }
        "#,
        "",
    );
    let one = |x: f64, expected: f64| {
        let computed = temperature_at(&slab, [x, 0.025], 0.1);
        let name = format!("slab of 2 m between faces at 100, x = {x} m");
        // Printed to 5e-4; quadratic elements of 25 mm and 200 steps leave as little.
        let tolerance = Tolerance::Absolute(2e-3);
        row(name, "temperature after 0.1 s", (expected, computed, "degC"), tolerance, "Carslaw and Jaeger, 3.4 (10)")
    };
    vec![one(0.2, 65.478), one(0.8, 8.093)]
}

/// A block of 2 × 2 × 2 m like the slab, warmed from all six faces: what its faces lack of 100 is the product of what a
/// square and a slab lack [Carslaw and Jaeger, 1.15], here 0.2, 0.8 and 0.8 m from three of them.
fn block() -> Vec<Case> {
    let heated = |height: &str, faces: &[&str], element: &str| {
        let faces: Vec<String> =
            faces.iter().map(|f| format!("{{ edge = \"{f}\", temperature = \"100 degC\" }}")).collect();
        let text = format!(
            r#"
            body = {{ material = {{ base = "steel", conductivity = "1 W/m/K", density = "1 kg/m^3", specific_heat = "1 J/kg/K" }}, rectangle = {{ length = "2 m", height = "{height}", width = "2 m" }} }}
            boundary = [{}]
            environment = {{ temperature = "0 degC" }}
            time = {{ end = "0.1 s", step = "0.001 s" }}
            mesh = {{ element_size = "{element}" }}
            "#,
            faces.join(", ")
        );
        body(&text, "")
    };
    let square = heated("2 m", &["left", "right", "bottom", "top"], "50 mm");
    let slab = heated("0.1 m", &["left", "right"], "50 mm");
    let lacks = |body: &Heated, at: [f64; 2]| 1.0 - temperature_at(body, at, 0.1) / 100.0;
    // Images of faces 1 m either side of the middle, diffusivity 1 m^2/s.
    let image = |n: i32, x: f64| erfc((f64::from(2 * n + 1) - x) / (2.0 * 0.1f64.sqrt()));
    let lack = |depth: f64| {
        let x = 1.0 - depth;
        1.0 - (0..6).map(|n| f64::from(1 - 2 * (n % 2)) * (image(n, x) + image(n, -x))).sum::<f64>()
    };
    vec![row(
        "block of 2 m between six faces at 100",
        "temperature after 0.1 s",
        (
            100.0 * (1.0 - lack(0.2) * lack(0.8).powi(2)),
            100.0 * (1.0 - lacks(&square, [0.2, 0.8]) * lacks(&slab, [0.8, 0.05])),
            "degC",
        ),
        // As the slab's rows at elements half as large and steps half as long: sixteen times their 2e-3 at most.
        Tolerance::Absolute(1e-2),
        "Carslaw and Jaeger, 1.15 and 3.4 (10)",
    )]
}

/// erfc by its power series and, beyond 2, its continued fraction.
fn erfc(z: f64) -> f64 {
    if z < 2.0 {
        let (mut term, mut sum, mut n) = (z, z, 0.0);
        while term > 1e-17 * sum {
            n += 1.0;
            term *= 2.0 * z * z / (2.0 * n + 1.0);
            sum += term;
        }
        return 1.0 - 2.0 / PI.sqrt() * (-z * z).exp() * sum;
    }
    let tail = (1..=60).rev().fold(z, |tail, n| z + 0.5 * f64::from(n) / tail);
    (-z * z).exp() / (tail * PI.sqrt())
}
