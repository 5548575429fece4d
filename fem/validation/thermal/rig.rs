//! Bodies and what is seen of them, for the table.

use std::f64::consts::PI;

use crate::process::{Assembled, ForwardModel, Rows, assembled};
use crate::processes::thermal::Thermal;
use crate::processes::thermal::follow::{Followed, Look};
use crate::processes::thermal::forward::follow;
use crate::processes::thermal::rows::{diameters, elongations, temperatures};
use crate::solve::conduction::Run;
pub(super) use crate::validation::bench::row;

/// A body with its effects.
pub type Heated = Option<Assembled<Thermal>>;

/// Ø20 × 200 mm of k = 50 W/(m K), ρc = 7850 · 470 J/(m³ K), with 15 W into the free end.
pub const ROD: &str = r#"
    body = { material = "steel", segments = [{ length = "200 mm", diameter = "20 mm" }] }
    source = [{ at = "200 mm", power = "15 W" }]
    environment = { temperature = "20 degC" }
    time = { end = "180 min", step = "10 s" }
"#;
/// Its length (m), section (m²), conductivity, heat capacity (J/(m³ K)), expansion (1/K), power (W).
pub const LENGTH: f64 = 0.2;
pub const AREA: f64 = PI * 1e-4;
pub const K: f64 = 50.0;
pub const RHO_C: f64 = 7850.0 * 470.0;
pub const ALPHA: f64 = 11.5e-6;
pub const POWER: f64 = 15.0;

/// The body of a model's text with effects given as TOML.
pub fn body(text: &str, effects: &str) -> Heated {
    assembled(text, effects)
}

/// The rod with effects.
pub fn rod(effects: &str) -> Heated {
    body(ROD, effects)
}

/// The value of the first of some rows, SI.
fn observed(body: &Heated, rows: &Rows) -> f64 {
    body.as_ref().and_then(|b| b.observe(rows).ok()).map_or(f64::NAN, |v| v[0])
}

/// Temperature of a plane body, degC.
pub fn temperature_at(body: &Heated, at: [f64; 2], time: f64) -> f64 {
    observed(body, &temperatures(&[at], time)) - 273.15
}

/// Rise of a rod over 20 degC, K.
pub fn rise(body: &Heated, x: f64, time: f64) -> f64 {
    temperature_at(body, [x, f64::NAN], time) - 20.0
}

/// Elongation, m.
pub fn elongation(body: &Heated, time: f64) -> f64 {
    observed(body, &elongations(&[time]))
}

/// Change of the diameter of a circle (x and radius in m) at a time (s), um.
pub fn diameter(body: &Heated, circle: [f64; 2], time: f64) -> f64 {
    1e6 * observed(body, &diameters(&[circle], time))
}

/// A run with steps (s) to its end (s), and what is looked at.
pub fn followed(body: &Heated, looks: &[Look], step: f64, end: f64) -> Option<Followed> {
    let machine = body.as_ref()?.machine();
    follow(machine, looks, &Run { scheme: machine.setup.time.scheme, step, end }, &mut |_, _| ()).ok()
}
