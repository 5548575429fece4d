//! The table of a source of heat: over a section, or on a strip of a body of revolution.

use super::body::{Body, axis_of};
use super::revolved;
use crate::input::{Along, Reader, Varying};
use crate::mesh::{BORE, LEFT, RIGHT};
use crate::process::estimates;
use crate::solve::rod::{Heater, History, PointSource, Power, Pulse};
use crate::units::{CONDUCTANCE, FACTOR, HEAT, HEAT_CAPACITY, LENGTH, POWER, TIME};

/// A source of heat.
pub enum Source {
    /// Over a whole section.
    Section(PointSource),
    /// On a strip of the surface of a body of revolution.
    Strip(Strip),
}

/// A strip around a body of revolution, or a ring on its end, into which heat comes evenly.
#[derive(Clone, Debug)]
pub struct Strip {
    /// Name of the edge that it is on.
    pub edge: String,
    /// Where it begins and ends, m: from the left end along `outside` and `bore`, from the axis on the ends.
    pub ends: [f64; 2],
    /// Power of the whole strip, W.
    pub power: Power,
}

impl Strip {
    /// The coordinate along which it reaches: 0 for x, 1 for y.
    pub fn axis(&self) -> usize {
        axis_of(&self.edge)
    }
}

/// Reads a source; a record of its power must reach over the `run`.
pub fn read(t: &Reader, body: &Body, run: Along) -> Source {
    let strip = read_strip(t, body);
    let place = t.quantity("at", LENGTH, "place along the body, from the base").not_negative();
    let at = if strip.is_some() && !t.is_described() { place.optional() } else { Some(place.required()) };
    if at.is_some_and(|at| at > body.length() * (1.0 + 1e-12)) {
        t.problem(
            "at",
            format!("the source stands at {}, beyond the body", LENGTH.format(at.unwrap_or_default())),
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
    let power = Power { level: read_level(t, power, whole, &on), on };
    let heater = read_heater(t, body);
    match (strip, at) {
        (Some((edge, ends)), None) => Source::Strip(Strip { edge, ends, power }),
        (Some(_), Some(_)) if !t.is_described() => {
            let help = "keep `at` for heat over a whole section, or `edge` with `from` and `to` for a strip";
            t.problem("at", "the place of the source is given twice", help);
            Source::Section(PointSource { at: 0.0, power, heater })
        }
        (_, at) => Source::Section(PointSource { at: at.unwrap_or_default(), power, heater }),
    }
}

/// Reads the strip of a source: its edge, and where it begins and ends (m).
fn read_strip(t: &Reader, body: &Body) -> Option<(String, [f64; 2])> {
    let edge = t.text("edge", "of a body of revolution, which a strip heats: outside, bore, left or right");
    let about = "where the strip begins: from the left end, on an end from the axis; there if left out";
    let from = t.quantity("from", LENGTH, about).not_negative().optional();
    let to = t.quantity("to", LENGTH, "where the strip ends; with the edge if left out").positive().optional();
    let Some(edge) = edge.filter(|_| !t.is_described()) else {
        if let Some(given) = ["from", "to"].into_iter().find(|key| t.has(key)) {
            t.problem(given, "a strip is on an edge, and none is said", "add edge = \"outside\"");
        }
        return None;
    };
    let Some(walls) = body.revolved() else {
        let message = format!("a strip heats a body of revolution, not {}", body.name());
        t.problem("edge", message, "say where the section is that the source heats: at = \"200 mm\"");
        return Some((edge, [0.0; 2]));
    };
    let edges = body.edges();
    if !edges.contains(&edge) {
        let message = format!("`{edge}` is no edge of the body");
        t.problem("edge", message, format!("its edges are {}", edges.join(", ")));
        return Some((edge, [0.0; 2]));
    }
    let length = body.length();
    let reach = match edge.as_str() {
        LEFT => revolved::radii_at(walls, 0.0),
        RIGHT => revolved::radii_at(walls, length),
        BORE => revolved::bored(walls),
        _ => [0.0, length],
    };
    let ends = [from.unwrap_or(reach[0]), to.unwrap_or(reach[1])];
    let slack = 1e-9 * reach[1];
    if ends[1] <= ends[0] {
        t.problem("to", "the strip ends where it begins, or before", "give it a width");
    } else if ends[0] < reach[0] - slack || ends[1] > reach[1] + slack {
        let key = if ends[0] < reach[0] - slack { "from" } else { "to" };
        let message = format!("the strip reaches beyond the edge `{edge}`");
        let help = format!("it lies between {} and {}", LENGTH.from_si(reach[0]), LENGTH.format(reach[1]));
        t.problem(key, message, help);
    } else if edge == BORE
        && let Some(own) = revolved::solid(walls, ends)
    {
        let message = format!("a length of {} under the strip has no bore", LENGTH.format(own));
        t.problem("edge", message, "end the strip where the bore does, or give that length a `bore`");
    }
    Some((edge, ends))
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
            format!("a heater with a heat capacity of its own is known of rods, not of {}", body.kind()),
            "leave `heat_capacity` and `contact` out, or model the body as a rod: segments = [{ length, diameter }]",
        );
    }
    Some(heater)
}
