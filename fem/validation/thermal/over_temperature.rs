//! Properties that change with the temperature: against Kirchhoff's transformation and balances of heat.

use std::f64::consts::PI;
use std::sync::Arc;

use super::rig::*;
use crate::input::Record;
use crate::material::OverTemperature;
use crate::process::Rows;
use crate::processes::thermal::boundary::Condition;
use crate::processes::thermal::follow::Look;
use crate::processes::thermal::forward::{follow, observe};
use crate::processes::thermal::machine::Machine;
use crate::processes::thermal::rows::{diameters, elongations, temperatures};
use crate::processes::thermal::setup::Setup;
use crate::solve::conduction::Run;
use crate::solve::rod::History;
use crate::validation::bench::bisect;
use crate::validation::{Case, Tolerance};

/// What Newton's method leaves, K: it stops where temperatures change by 1e-9 K.
const REST: Tolerance = Tolerance::Absolute(1e-6);
const ROOM: f64 = 293.15;

pub fn cases() -> Vec<Case> {
    [between_two_temperatures(), heated_wall(), warmed_through(), strip().into_iter().collect()].concat()
}

/// A property that changes by `slope` (1/K) of its value at 20 degC, which is `value`, from there to 820 degC.
fn straight(value: f64, slope: f64) -> Option<Arc<Record>> {
    let points = [0.0, 800.0].map(|rise| [ROOM + rise, value * (1.0 + slope * rise)]);
    Record::new(points.to_vec()).map(Arc::new)
}

/// A body whose properties change.
fn changing(text: &str, over_temperature: OverTemperature) -> Option<Machine> {
    let mut machine = body(text, "")?.machine().clone();
    machine.setup = Arc::new(Setup { over_temperature, ..(*machine.setup).clone() });
    Some(machine)
}

fn seen(machine: &Option<Machine>, rows: &Rows) -> f64 {
    machine.as_ref().and_then(|m| observe(m, rows).ok()).map_or(f64::NAN, |v| v[0])
}

/// A wall between 20 and 320 degC, long after: ∫ k dT is straight from face to face, or over ln r in a tube.
fn between_two_temperatures() -> Vec<Case> {
    let slope = -0.8e-3;
    let over = OverTemperature { conductivity: straight(K, slope), ..OverTemperature::default() };
    let transformed = |rise: f64| rise * (1.0 + 0.5 * slope * rise);
    let time = "time = { end = \"900 s\", step = \"10 s\" }\nenvironment = { temperature = \"20 degC\" }";
    let held = |one: &str, other: &str| {
        format!(
            "boundary = [{{ edge = \"{one}\", temperature = \"20 degC\" }}, {{ edge = \"{other}\", temperature = \"320 degC\" }}]\n{time}"
        )
    };
    let wall =
        "body = { material = \"steel\", rectangle = { length = \"50 mm\", height = \"5 mm\", width = \"5 mm\" } }";
    let wall = changing(&format!("{wall}\n{}", held("left", "right")), over.clone());
    let tube = "body = { material = \"steel\", revolved = [{ length = \"20 mm\", diameter = \"80 mm\", bore = \"40 mm\" }] }\nmesh = { element_size = \"1 mm\" }";
    let tube = changing(&format!("{tube}\n{}", held("bore", "outside")), over);
    let rise = |share: f64| bisect(0.0, 300.0, |rise| transformed(rise) - share * transformed(300.0));
    let source = "Kirchhoff's transformation, Carslaw & Jaeger 1.6";
    let in_wall = |x: f64| {
        let pair = (rise(x / 0.05), seen(&wall, &temperatures(&[[x, 0.0025]], 900.0)) - ROOM, "K");
        row(format!("wall, k falls by 0.08 % a kelvin, x = {:.0} mm", 1e3 * x), "rise", pair, REST, source)
    };
    let in_tube = |r: f64| {
        let share = (r / 0.02).ln() / 2.0_f64.ln();
        let pair = (rise(share), seen(&tube, &temperatures(&[[0.01, r]], 900.0)) - ROOM, "K");
        // Parabolas of 1 mm for a logarithm from 20 mm on: (h/r)⁴ of the rise.
        let tolerance = Tolerance::Absolute(300.0 * 0.05_f64.powi(4));
        row(format!("tube, k falls by 0.08 % a kelvin, r = {:.0} mm", 1e3 * r), "rise", pair, tolerance, source)
    };
    [0.0125, 0.025, 0.04].map(in_wall).into_iter().chain([0.025, 0.03].map(in_tube)).collect()
}

/// A thick wall under an even flux whose k and c grow alike: their ratio stays, so that ∫ k dT follows the law of a wall whose
/// properties are constant.
fn heated_wall() -> Vec<Case> {
    let (slope, flux): (f64, f64) = (1e-3, 4e5);
    let over = OverTemperature {
        conductivity: straight(K, slope),
        specific_heat: straight(470.0, slope),
        ..OverTemperature::default()
    };
    let wall = changing(
        "body = { material = \"steel\", rectangle = { length = \"100 mm\", height = \"4 mm\", width = \"5 mm\" } }
         mesh = { element_size = \"1 mm\" }
         boundary = [{ edge = \"left\", flux = \"400 kW/m^2\" }]
         time = { end = \"20 s\", step = \"0.1 s\" }
         environment = { temperature = \"20 degC\" }",
        over,
    );
    let one = |time: f64| {
        let transformed = 2.0 * flux / K * (K / RHO_C * time / PI).sqrt();
        let rise = ((1.0 + 2.0 * slope * transformed).sqrt() - 1.0) / slope;
        let pair = (rise, seen(&wall, &temperatures(&[[0.0, 0.002]], time)) - ROOM, "K");
        // 200 steps of second order from a flux that begins at once: its root at the start costs half an order.
        let name = format!("wall under 400 kW/m2, k and c grow by 0.1 % a kelvin, {time:.0} s");
        row(name, "rise", pair, Tolerance::Relative(1e-4), "Carslaw & Jaeger 2.9 (8), of the transformed temperature")
    };
    [5.0, 20.0].map(one).to_vec()
}

/// Heat that stays in a block, once it is everywhere: ∫ c dT, and what the block has grown, ∫ α dT, α as means from 0 degC.
fn warmed_through() -> Vec<Case> {
    let (slope, mean_slope) = (6e-4, 5e-4);
    let mean = |celsius: f64| 11e-6 * (1.0 + mean_slope * celsius);
    let means = [0.0, 400.0, 800.0].map(|celsius: f64| [273.15 + celsius, mean(celsius)]);
    let over = OverTemperature {
        specific_heat: straight(470.0, slope),
        expansion: Record::new(means.to_vec()).map(Arc::new),
        expansion_from: Some(273.15),
        ..OverTemperature::default()
    };
    let heat = "boundary = [{ edge = \"left\", flux = \"400 kW/m^2\", on = [[\"0 s\", \"20 s\"]] }]
        environment = { temperature = \"20 degC\" }
        time = { end = \"900 s\", step = \"5 s\" }";
    let block = changing(
        &format!(
            "body = {{ material = \"steel\", rectangle = {{ length = \"30 mm\", height = \"5 mm\", width = \"5 mm\" }} }}\n{heat}"
        ),
        over.clone(),
    );
    let ring = changing(
        &format!(
            "body = {{ material = \"steel\", revolved = [{{ length = \"30 mm\", diameter = \"60 mm\", bore = \"40 mm\" }}] }}\n{heat}"
        ),
        over,
    );
    let enthalpy = 4e5 * 20.0 / (RHO_C * 0.03);
    let rise = ((1.0 + 2.0 * slope * enthalpy).sqrt() - 1.0) / slope;
    let growth = mean(20.0 + rise) * (20.0 + rise) - mean(20.0) * 20.0;
    let source = "all heat stays inside: int c dT, int alpha dT";
    let exact = Tolerance::Relative(1e-8);
    vec![
        row(
            "block warmed through, c grows by 0.06 % a kelvin",
            "rise",
            (rise, seen(&block, &temperatures(&[[0.02, 0.0025]], 900.0)) - ROOM, "K"),
            exact,
            source,
        ),
        row(
            "block warmed through, expansion as means from 0 degC",
            "elongation",
            (1e6 * 0.03 * growth, 1e6 * seen(&block, &elongations(&[900.0])), "um"),
            exact,
            source,
        ),
        row(
            "ring warmed through, expansion as means from 0 degC",
            "diameter",
            (1e6 * 0.06 * growth, 1e6 * seen(&ring, &diameters(&[[0.015, 0.03]], 900.0)), "um"),
            exact,
            source,
        ),
    ]
}

/// A strip that moves, and whose flux rises from nothing.
fn strip() -> Option<Case> {
    let mut machine = body(
        "body = { material = \"steel\", rectangle = { length = \"100 mm\", height = \"20 mm\", width = \"8 mm\" } }
         boundary = [{ edge = \"top\", moving = { speed = \"1 mm/s\", width = \"10 mm\", flux = \"0 W/m^2\", from = \"20 mm\" } }]
         time = { end = \"60 s\", step = \"0.7 s\" }
         environment = { temperature = \"20 degC\" }",
        "",
    )?
    .machine()
    .clone();
    let mut setup = (*machine.setup).clone();
    let rising = Record::new(vec![[0.0, 0.0], [60.0, 1e6]])?;
    if let Condition::Moving { flux, .. } = &mut setup.boundaries.first_mut()?.condition {
        flux.level = History::Record(Arc::new(rising));
    }
    machine.setup = Arc::new(setup);
    let run = Run { scheme: machine.setup.time.scheme, step: 0.7, end: 60.0 };
    let supplied = follow(&machine, &[Look::Elongation], &run, &mut |_, _| ()).map_or(f64::NAN, |f| f.energy.supplied);
    let pair = (0.5 * 1e6 * 60.0 * 0.01 * 0.008, supplied, "J");
    Some(row(
        "strip that moves, its flux from 0 to 1 MW/m2",
        "heat",
        pair,
        Tolerance::Relative(1e-9),
        "int q dt times its area",
    ))
}
