//! The units in which a model is written change nothing.

use fem::input::Source;
use fem::model::Model;
use fem::process::{ALL, Process};
use fem::progress::Progress;
use fem::units::Unit;
use proptest::prelude::*;

use super::alike;

/// Units that may stand for each other; each text is rewritten where it is of one dimension with them.
const UNITS: [&str; 27] = [
    "m", "mm", "um", "N", "kN", "s", "min", "ms", "m/s", "mm/min", "N/m", "N/um", "rad", "deg", "rad/s", "rpm", "W",
    "kW", "W/K", "W/m^2/K", "N/mm", "um/m", "mm/m", "m/rad", "in", "lbf", "lbf/in",
];

/// The starting model of a process with all effects that it admits, with usual values.
fn with_all_effects(process: &dyn Process) -> String {
    let start = process.starting_model();
    let own = start.split("# What").next().unwrap().split("# Ways").next().unwrap().split("[effects.").next().unwrap();
    let bare = super::model(own);
    let mut text = own.to_string();
    for effect in process.effects().iter().filter(|effect| bare.system.admits(effect.name).is_ok()) {
        text += &format!("[effects.{}]\n", effect.name);
        for parameter in effect.parameters.iter() {
            let value = parameter.example();
            let unit = parameter.kind.unit;
            text += &match unit {
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
    let (value, unit) = (number.parse::<f64>().ok()?, Unit::parse(unit).ok()?);
    let parsed = UNITS.iter().map(|name| (name, Unit::parse(name).unwrap()));
    let alike: Vec<_> = parsed
        .filter(|(_, other)| other.dimension == unit.dimension && unit.offset == 0.0 && other.offset == 0.0)
        .collect();
    let (name, other) = alike.get(pick.checked_rem(alike.len())?)?;
    Some(format!("{:e} {name}", value * unit.factor / other.factor))
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
            let parsed = |text: &str| {
                Model::parse(Source::new("model.toml", text)).unwrap_or_else(|error| panic!("{error:?}\n{text}"))
            };
            let predicted = |text: &str| parsed(text).forward().predict(&Progress::default()).unwrap();
            alike(&predicted(&own), &predicted(&other), 1e-7)?;
        }
    }
}
