//! Surfaces that lose by radiation, or by a film that changes.

use std::sync::Arc;

use super::rig::*;
use crate::input::{Record, Varying};
use crate::processes::thermal::boundary::Condition;
use crate::processes::thermal::forward::observe;
use crate::processes::thermal::rows::temperatures;
use crate::solve::conduction::STEFAN_BOLTZMANN;
use crate::validation::bench::bisect;
use crate::validation::{Case, Tolerance};

/// A sheet of 1 mm that is at one temperature across: k = 1e6 W/(m K). Its top loses.
const SHEET: &str = r#"
    body = { material = { base = "steel", conductivity = "1e6 W/m/K" }, temperature = "500 degC", rectangle = { length = "10 mm", height = "1 mm", width = "10 mm" } }
    environment = { temperature = "20 degC" }
"#;
const HEIGHT: f64 = 1e-3;
const START: f64 = 773.15;
const ROOM: f64 = 293.15;
/// What steps of 1 s leave of a body with a time constant of a minute: their square over 12, and more.
const BY_STEPS: f64 = 1e-4 * (START - ROOM);

pub fn cases() -> Vec<Case> {
    [radiating(), blown().into_iter().collect(), held_and_radiating()].concat()
}

/// A lumped body that radiates to a room: its time by temperature in closed form.
fn radiating() -> Vec<Case> {
    let emissivity = 0.8;
    let sheet = body(
        &format!(
            "{SHEET}boundary = [{{ edge = \"top\", emissivity = {emissivity} }}]\ntime = {{ end = \"300 s\", step = \"1 s\" }}"
        ),
        "",
    );
    let rate = 4.0 * emissivity * STEFAN_BOLTZMANN * ROOM.powi(3) / (RHO_C * HEIGHT);
    let place = |t: f64| ((t + ROOM) / (t - ROOM)).ln() + 2.0 * (t / ROOM).atan();
    let at = |time: f64| bisect(ROOM, START, |t| rate * time - (place(t) - place(START)));
    let one = |time: f64| {
        let pair = (at(time), temperature_at(&sheet, [0.005, 0.0005], time) + 273.15, "K");
        let name = format!("sheet at 500 degC radiates, {time:.0} s");
        row(name, "temperature", pair, Tolerance::Absolute(BY_STEPS), "Incropera & DeWitt (5.18)")
    };
    [30.0, 120.0, 300.0].map(one).to_vec()
}

/// A lumped body under a film that rises steadily from nothing: exp(−h't²/2ρch).
fn blown() -> Option<Case> {
    let rate = 10.0;
    let text = format!(
        "{SHEET}boundary = [{{ edge = \"top\", convection = \"1 W/m^2/K\" }}]\ntime = {{ end = \"60 s\", step = \"1 s\" }}"
    );
    let mut machine = body(&text, "")?.machine().clone();
    let mut setup = (*machine.setup).clone();
    let record = Record::new(vec![[0.0, 0.0], [100.0, 100.0 * rate]])?;
    let coefficient = Varying::Record(Arc::new(record));
    setup.boundaries.first_mut()?.condition = Condition::Convection { coefficient, ambient: None };
    machine.setup = Arc::new(setup);
    let time: f64 = 60.0;
    let expected = ROOM + (START - ROOM) * (-0.5 * rate * time * time / (RHO_C * HEIGHT)).exp();
    let found = observe(&machine, &temperatures(&[[0.005, 0.0005]], time)).map_or(f64::NAN, |values| values[0]);
    let pair = (expected, found, "K");
    let source = "a lumped body: exp(-int h dt/(rho*c*t))";
    Some(row(
        "sheet under a film that rises by 10 W/(m2 K) a second",
        "temperature",
        pair,
        Tolerance::Absolute(BY_STEPS),
        source,
    ))
}

/// A bar held at 1000 K whose other end radiates to 300 K, until it is steady.
fn held_and_radiating() -> Vec<Case> {
    let text = r#"
        body = { material = { base = "steel", conductivity = "55.563 W/m/K", specific_heat = "460 J/kg/K", density = "7850 kg/m^3" }, temperature = "26.85 degC", rectangle = { length = "100 mm", height = "10 mm", width = "10 mm" } }
        boundary = [{ edge = "left", temperature = "726.85 degC" }, { edge = "right", emissivity = 0.98 }]
        environment = { temperature = "26.85 degC" }
        time = { end = "120 min", step = "20 s" }
    "#;
    let bar = body(text, "");
    let found = temperature_at(&bar, [0.1, 0.005], 7200.0) + 273.15;
    let lacks = |t: f64| 0.98 * STEFAN_BOLTZMANN * (t.powi(4) - 300f64.powi(4)) - 55.563 * (1000.0 - t) / 0.1;
    let exact = bisect(300.0, 1000.0, lacks);
    let name = "bar held at 1000 K, its other end radiates";
    vec![
        row(name, "temperature of that end", (927.0, found, "K"), Tolerance::Absolute(0.05), "NAFEMS T2 (1990)"),
        row(name, "temperature of that end, steady", (exact, found, "K"), Tolerance::Absolute(1e-6), "heat balance"),
    ]
}
