//! Bodies that start at a temperature of their own: lumped, and by the cosine series of a slab.

use std::f64::consts::PI;

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// The rod of the rig without a source, at 80 degC in a room at 20.
const WARM: &str = r#"
    body = { material = "steel", temperature = "80 degC", segments = [{ length = "200 mm", diameter = "20 mm" }] }
    environment = { temperature = "20 degC" }
    time = { end = "180 min", step = "10 s" }
"#;
/// Initial excess of the rod over the room, K.
const WARMER: f64 = 60.0;

pub fn cases() -> Vec<Case> {
    [lumped(), vec![bar()], slab(), rod_on_its_base(), vec![held_faces()]].concat()
}

/// A rod that loses the same everywhere is at one temperature.
fn lumped() -> Vec<Case> {
    let tau = RHO_C * AREA / (25.0 * PI * 0.02);
    let rod = body(WARM, "[convection]\ncoefficient = \"25 W/m^2/K\"");
    // Steps of 10 s, of second order.
    let steps = Tolerance::Relative((10.0 / tau).powi(2));
    let mut cases = Vec::new();
    for minutes in [10.0, 40.0] {
        let (name, time) = (format!("rod at 80 in a room at 20, 25 W/m^2/K, {minutes} min"), 60.0 * minutes);
        let left = WARMER * (-time / tau).exp();
        let shrunk = (1e6 * ALPHA * LENGTH * (left - WARMER), 1e6 * elongation(&rod, time), "um");
        let law = "lumped body, exp(-t/tau)";
        cases.push(row(&name, "rise over the room", (left, rise(&rod, 0.05, time), "K"), steps, law));
        cases.push(row(&name, "elongation", shrunk, steps, law));
    }
    cases
}

/// A square bar that loses from its edges and faces is nearly at one temperature at a small Biot number.
fn bar() -> Case {
    let bar = body(
        r#"
        body = { material = "steel", temperature = "80 degC", rectangle = { length = "100 mm", height = "20 mm", width = "20 mm" } }
        environment = { temperature = "20 degC" }
        time = { end = "60 min", step = "10 s" }
        "#,
        "[convection]\ncoefficient = \"10 W/m^2/K\"",
    );
    let area = 4.0 * 0.1 * 0.02 + 2.0 * 0.02 * 0.02;
    let tau = RHO_C * 0.1 * 0.02 * 0.02 / (10.0 * area);
    // Half the length over k. Along either way the loss is slower by a third of its Biot number, which after
    // τ is as much of what is left, and the middle is warmer by a sixth.
    let biot = 10.0 * 0.05 / K;
    row(
        "bar at 80 in a room at 20, Biot number 0.01, after tau",
        "rise of its middle",
        (WARMER / 1f64.exp(), temperature_at(&bar, [0.05, 0.01], tau) - 20.0, "K"),
        Tolerance::Relative(biot),
        "lumped body, exp(-t/tau)",
    )
}

/// Part of the rise that is left, at a time Fo·ℓ²/a and ξ·ℓ from its middle, of a slab of half thickness ℓ
/// that loses from both faces at a Biot number: Σ 4 sin ζ/(2ζ + sin 2ζ)·e^(−ζ²Fo)·cos ζξ over the roots of
/// ζ tan ζ = Bi.
fn left_of_slab(biot: f64, fourier: f64, xi: f64) -> f64 {
    let term = |n: i32| {
        // The root between nπ and nπ + π/2, where (ζ sin ζ − Bi cos ζ)·cos nπ rises through zero.
        let (mut low, mut high) = (f64::from(n) * PI, (f64::from(n) + 0.5) * PI);
        let sign = (f64::from(n) * PI).cos();
        for _ in 0..60 {
            let zeta = 0.5 * (low + high);
            let is_below = (zeta * zeta.sin() - biot * zeta.cos()) * sign < 0.0;
            if is_below { low = zeta } else { high = zeta }
        }
        let zeta = 0.5 * (low + high);
        4.0 * zeta.sin() / (2.0 * zeta + (2.0 * zeta).sin()) * (-zeta * zeta * fourier).exp() * (zeta * xi).cos()
    };
    (0..40).map(term).sum()
}

/// A slab of 200 mm that loses 500 W/(m² K) from both faces: its Biot number is 1.
fn slab() -> Vec<Case> {
    let slab = body(
        r#"
        body = { material = "steel", temperature = "80 degC", rectangle = { length = "200 mm", height = "20 mm", width = "20 mm" } }
        boundary = [{ edge = "left", convection = "500 W/m^2/K" }, { edge = "right", convection = "500 W/m^2/K" }]
        environment = { temperature = "20 degC" }
        time = { end = "20 min", step = "2 s" }
        "#,
        "",
    );
    let one = |time: f64, x: f64, place: &'static str| {
        let left = WARMER * left_of_slab(500.0 * 0.1 / K, K / RHO_C * time / 0.01, x / 0.1 - 1.0);
        let found = temperature_at(&slab, [x, 0.01], time) - 20.0;
        // Steps of 2 s in a slab whose slowest wave takes 1000 s, quadratic elements of 5 mm.
        let tolerance = Tolerance::Absolute(1e-4 * WARMER);
        let name = format!("slab at 80 in a room at 20, Biot number 1, {time:.0} s");
        row(name, place, (left, found, "K"), tolerance, "cosine series, by separation of variables")
    };
    let places = [(0.1, "rise of its middle"), (0.2, "rise of a face")];
    [120.0, 600.0, 1200.0].iter().flat_map(|time| places.map(|(x, place)| one(*time, x, place))).collect()
}

/// The rod that loses through its base alone is half of such a slab.
fn rod_on_its_base() -> Vec<Case> {
    let rod = body(WARM, "[base-conductance]\nconductance = \"0.5 W/K\"");
    let one = |time: f64, x: f64, place: &'static str| {
        let biot = 0.5 * LENGTH / (K * AREA);
        let left = WARMER * left_of_slab(biot, K / RHO_C * time / (LENGTH * LENGTH), 1.0 - x / LENGTH);
        // Sixty linear elements and steps of 10 s, as of the heated rod.
        let tolerance = Tolerance::Absolute(2e-4 * WARMER);
        let name = format!("rod at 80 on a base at 20, 0.5 W/K, {:.0} min", time / 60.0);
        row(name, place, (left, rise(&rod, x, time), "K"), tolerance, "cosine series, by separation of variables")
    };
    let places = [(0.0, "rise of the base"), (0.1, "rise half way"), (0.2, "rise of the free end")];
    [600.0, 3600.0].iter().flat_map(|time| places.map(|(x, place)| one(*time, x, place))).collect()
}

/// Both faces held at the room's temperature from the start on: the roots are odd multiples of π/2.
fn held_faces() -> Case {
    let slab = body(
        r#"
        body = { material = "steel", temperature = "80 degC", rectangle = { length = "200 mm", height = "20 mm", width = "20 mm" } }
        boundary = [{ edge = "left", temperature = "20 degC" }, { edge = "right", temperature = "20 degC" }]
        environment = { temperature = "20 degC" }
        time = { end = "10 min", step = "2 s" }
        "#,
        "",
    );
    let (time, x) = (600.0, 0.07);
    let term = |n: i32| {
        let zeta = (f64::from(n) + 0.5) * PI;
        let wave = 2.0 * zeta.sin() / zeta * (zeta * (x / 0.1 - 1.0)).cos();
        wave * (-zeta * zeta * K / RHO_C * time / 0.01).exp()
    };
    let left = WARMER * (0..40).map(term).sum::<f64>();
    // As of the slab that loses; the jump at the faces has spread over a third of the slab.
    let tolerance = Tolerance::Absolute(1e-4 * WARMER);
    let found = temperature_at(&slab, [x, 0.01], time) - 20.0;
    let law = "cosine series, by separation of variables";
    row("slab at 80 with faces held at 20, 10 min", "rise 30 mm off its middle", (left, found, "K"), tolerance, law)
}
