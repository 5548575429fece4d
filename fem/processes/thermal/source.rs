//! The table of a source of heat.

use super::body::Body;
use crate::input::{Along, Reader, Varying};
use crate::process::estimates;
use crate::solve::rod::{Heater, History, PointSource, Power, Pulse};
use crate::units::{CONDUCTANCE, FACTOR, HEAT, HEAT_CAPACITY, LENGTH, POWER, TIME};

/// Reads a source; a record of its power must reach over the `run`.
pub fn read(t: &Reader, body: &Body, run: Along) -> PointSource {
    let at = t.quantity("at", LENGTH, "place along the body, from the base").not_negative().required();
    if at > body.length() * (1.0 + 1e-12) {
        t.problem(
            "at",
            format!("the source stands at {}, beyond the body", LENGTH.format(at)),
            format!("the body ends at {}", LENGTH.format(body.length())),
        );
    }
    if !body.has_sections() && !t.is_described() {
        t.problem(
            "at",
            "a source stands over a section, and a mesh from a file has none",
            "let the heat in through an edge: [[boundary]] with flux",
        );
    }
    let power = t.quantity("power", POWER, "heat that it gives").estimated(estimates::POWER).optional_varying(run);
    let whole = t.quantity("heat", HEAT, "all the heat that it gives while it is on, instead of a power");
    let whole = whole.estimated(estimates::POWER).optional();
    let factors = t.quantities("pulses", FACTOR, "part of the power that each interval of `on` has; 1 if left out");
    let on = read_on(t, factors.as_deref().unwrap_or_default());
    if let Some(factors) = factors
        && factors.len() != on.len()
        && t.is_sound()
    {
        let message = format!("`pulses` has {} factors, and `on` {} intervals", factors.len(), on.len());
        t.problem("pulses", message, "give one factor for each interval, in the order of `on`");
    }
    let level = read_level(t, power, whole, &on);
    PointSource { at, power: Power { level, on }, heater: read_heater(t, body) }
}

/// The power of a source: its own, or what gives all its heat (J) evenly while it is on.
fn read_level(t: &Reader, power: Option<Varying>, whole: Option<f64>, on: &[Pulse]) -> History {
    let duration: f64 = on.iter().map(|pulse| pulse.factor * (pulse.to - pulse.from)).sum();
    match (power, whole) {
        (Some(_), Some(_)) => {
            t.problem("heat", "the heat is given twice", "keep either `power` or `heat`");
            History::Constant(0.0)
        }
        (Some(power), None) => History::from(power),
        (None, Some(heat)) => {
            if duration <= 0.0 {
                let help = "add on = [[\"0 min\", \"5 min\"]]";
                t.problem("heat", "it is not said in what time the heat is given", help);
            }
            History::Constant(heat / duration)
        }
        (None, None) => {
            if !t.has("power") && !t.has("heat") {
                let help = "add power = \"80 W\", or heat = \"12 kcal\" with `on`";
                t.problem("", "the heat of the source is missing", help);
            }
            History::Constant(0.0)
        }
    }
}

/// Intervals in which something is on, in their order in time, with the factors of their power in the order
/// of the file.
pub fn read_on(t: &Reader, factors: &[f64]) -> Vec<Pulse> {
    let on = t.intervals("on", TIME, "when it is on; always if left out").unwrap_or_default();
    let pulse = |(i, [from, to]): (usize, [f64; 2])| Pulse { from, to, factor: factors.get(i).copied().unwrap_or(1.0) };
    let mut on: Vec<Pulse> = on.into_iter().enumerate().map(pulse).collect();
    on.sort_by(|a, b| a.from.total_cmp(&b.from));
    if on.windows(2).any(|pair| pair[1].from < pair[0].to) {
        t.problem("on", "intervals overlap", "join them: heat is not given twice");
    }
    on
}

/// The heater that a source warms first.
fn read_heater(t: &Reader, body: &Body) -> Option<Heater> {
    let about = "of a heater that the power warms first; none if left out";
    let heat_capacity = t.quantity("heat_capacity", HEAT_CAPACITY, about).estimated(estimates::HEATER);
    let heat_capacity = heat_capacity.positive().optional();
    let contact = t.quantity("contact", CONDUCTANCE, "from that heater to the body").estimated(estimates::CONDUCTANCE);
    let contact = contact.positive().optional();
    if heat_capacity.is_some() != contact.is_some() {
        let given = if heat_capacity.is_some() { "heat_capacity" } else { "contact" };
        let message = "a heater has a heat capacity and a contact with the body";
        t.problem(given, message, "give both of heat_capacity = \"10 J/K\" and contact = \"0.5 W/K\", or none");
    }
    let heater = Heater { heat_capacity: heat_capacity?, contact: contact? };
    if body.plane().is_some() {
        t.problem(
            "heat_capacity",
            "a heater with a heat capacity of its own is known of rods, not of plane bodies",
            "leave `heat_capacity` and `contact` out, or model the body as a rod: segments = [{ length, diameter }]",
        );
    }
    Some(heater)
}
