//! The units in which a model is written change nothing.

use std::f64::consts::{PI, TAU};

use fem::compare::compare;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::Data;
use fem::process::Process;
use fem::processes::ALL;
use fem::progress::Progress;
use fem::units::Unit;
use proptest::prelude::*;

use super::{alike, axis, cam, contour, fixture, plate, ring, rotary, stiffness, thermal, turning};

/// Units with what they are in SI, as standards define them (an inch is 25.4 mm, a pound 0.453 592 37 kg
/// under 9.806 65 m/s²): each text is rewritten where it is of one dimension with them. None is asked of the
/// program, so that a wrong one cannot undo itself.
const UNITS: [(&str, f64); 33] = [
    ("m", 1.0),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("in", 0.0254),
    ("N", 1.0),
    ("kN", 1e3),
    ("lbf", POUND),
    ("s", 1.0),
    ("min", 60.0),
    ("ms", 1e-3),
    ("h", 3600.0),
    ("m/s", 1.0),
    ("mm/min", 1e-3 / 60.0),
    ("N/m", 1.0),
    ("N/mm", 1e3),
    ("N/um", 1e6),
    ("lbf/in", POUND / 0.0254),
    ("rad", 1.0),
    ("deg", PI / 180.0),
    ("rad/s", 1.0),
    ("rpm", TAU / 60.0),
    ("W", 1.0),
    ("kW", 1e3),
    ("W/K", 1.0),
    ("kW/K", 1e3),
    ("W/m^2", 1.0),
    ("kW/m^2", 1e3),
    ("W/m^2/K", 1.0),
    ("um/m", 1e-6),
    ("mm/m", 1e-3),
    ("GPa", 1e9),
    ("N/mm^2", 1e6),
    ("lbf/in^2", POUND / (0.0254 * 0.0254)),
];

/// N.
const POUND: f64 = 0.453_592_37 * 9.806_65;

/// The starting model of a process with all effects that it admits, with usual values.
fn with_all_effects(process: &dyn Process) -> String {
    let start = process.starting_model();
    let (head, tables) = start.split_once("process").unwrap();
    let own = tables.split("# What").next().unwrap().split("# Ways").next().unwrap().split("[effects.").next().unwrap();
    let own = &format!("{head}process{own}");
    let bare = super::model(own);
    let mut text = own.to_string();
    for effect in process.effects().iter().filter(|effect| bare.system.admits(&effect.name).is_ok()) {
        text += &format!("[effects.{}]\n", effect.name);
        for parameter in effect.parameters.iter() {
            let value = parameter.example();
            let unit = parameter.kind.unit;
            text += &match &*unit {
                "1" | "" => format!("{} = {value}\n", parameter.name),
                unit => format!("{} = \"{value} {unit}\"\n", parameter.name),
            };
        }
    }
    text
}

/// The text with every quantity in another unit of its dimension: the one that a number picks.
fn rewritten(text: &str, picks: &[usize]) -> (String, usize) {
    let (mut all, mut count) = (String::new(), 0);
    for (i, part) in text.split('"').enumerate() {
        let quote = if i == 0 { "" } else { "\"" };
        let other = if i % 2 == 1 { in_another_unit(part, picks[i % picks.len()]) } else { None };
        count += usize::from(other.is_some());
        all += quote;
        all += other.as_deref().unwrap_or(part);
    }
    (all, count)
}

fn in_another_unit(quantity: &str, pick: usize) -> Option<String> {
    let (number, unit) = quantity.split_once(' ')?;
    let value = number.parse::<f64>().ok()?;
    let (_, factor) = UNITS.iter().find(|(name, _)| *name == unit)?;
    let dimension = |name: &str| Unit::parse(name).unwrap().dimension;
    let alike: Vec<_> = UNITS.iter().filter(|(name, _)| dimension(name) == dimension(unit)).collect();
    let (name, other) = alike[pick % alike.len()];
    Some(format!("{:e} {name}", value * factor / other))
}

fn predicted(text: &str) -> Vec<f64> {
    super::model(text).forward().predict(&Progress::default()).unwrap()
}

proptest! {
    #![proptest_config(super::random(24))]

    /// Digits of numbers that were rewritten are what differs, and what a cam or a contour finds by search at 1e-12 of
    /// its size.
    #[test]
    fn units_change_nothing(picks in prop::collection::vec(0usize..1000, 97)) {
        for process in ALL {
            let own = with_all_effects(*process);
            let (other, count) = rewritten(&own, &picks);
            prop_assert!(count >= 6, "{}: {count} quantities were rewritten", process.name());
            alike(&predicted(&own), &predicted(&other), 1e-7)?;
        }
    }

    /// The same of random systems of every process. Digits of numbers that were rewritten pass through a
    /// solve, or are those of radii of which a cam's deviations are differences.
    #[test]
    fn units_change_no_random_system(
        lathe in turning::lathe(), ring in ring::ring(), fixture in fixture::fixture(), rod in thermal::rod(),
        plate in plate::plate(), axis in axis::axis(), circle in contour::circle(), cam in cam::cam(), joint in stiffness::joint(),
        table in rotary::table(),
        picks in prop::collection::vec(0usize..1000, 29),
    ) {
        let systems = [
            (lathe.text(true), 1e-9),
            (ring.text(), 1e-9),
            (fixture.text(fixture::SPRINGS), 1e-9),
            (fixture.text(fixture::CONTACTS), 1e-8),
            (rod.text([5.0, 12.0], true), 1e-9),
            (plate.text("sdirk2"), 1e-9),
            (axis.text(true, true), 1e-9),
            (table.text(true), 1e-9),
            (circle.text(), 1e-9),
            (cam.text(), 1e-7),
            (stiffness::text(&joint, "from-zero"), 1e-9),
        ];
        for (own, tolerance) in systems {
            let (other, count) = rewritten(&own, &picks);
            prop_assert!(count >= 2, "{count} quantities were rewritten in\n{own}");
            alike(&predicted(&own), &predicted(&other), tolerance)?;
        }
    }

    /// The units of the columns in which rows are measured.
    #[test]
    fn units_of_columns_change_no_comparison(
        lathe in turning::lathe(), rows in prop::collection::vec((0.05..0.95, 100.0..800.0, -30.0..60.0), 6..20),
    ) {
        let model = super::model(&lathe.text(true));
        let compared = |[x, force, error]: [(&str, f64); 3]| {
            let line = |(part, newtons, microns): &(f64, f64, f64)| {
                let own = [part * lathe.length() * 1e-3 / x.1, newtons / force.1, microns * 1e-6 / error.1];
                format!("{:e},{:e},{:e},{:e}\n", own[0], own[1], own[2], 2e-6 / error.1)
            };
            let head = format!("x [{}],radial_force [{}],diameter_error [{}],u [{}]\n", x.0, force.0, error.0, error.0);
            let text = head + &rows.iter().map(line).collect::<String>();
            let measured = Measurements::parse(Source::new("rows.csv", text), &*model.process).unwrap();
            let comparison = compare(&Data::of(&model, measured).unwrap()).unwrap();
            [comparison.rms * 1e6, comparison.reduced_chi2]
        };
        let own = compared([("mm", 1e-3), ("N", 1.0), ("um", 1e-6)]);
        let other = compared([("in", 0.0254), ("lbf", POUND), ("mm", 1e-3)]);
        for (own, other) in own.iter().zip(other) {
            prop_assert!((own / other - 1.0).abs() < 1e-9, "{own} and {other}");
        }
    }
}
