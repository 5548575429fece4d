//! The table of what holds on an edge of a plane body or of a body of revolution.

use std::ops::Range;

use super::body::{Body, axis_of};
use super::source;
use crate::input::{Along, Reader, Varying};
use crate::process::estimates;
use crate::solve::rod::{History, Power};
use crate::units::{CONVECTION, HEAT_FLUX, LENGTH, NUMBER, SPEED, TEMPERATURE};

/// An edge of a plane body with its condition.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// Name of the edge.
    pub edge: String,
    /// Its condition.
    pub condition: Condition,
    /// Whether what brings the heat covers the edge, so that it loses none to the surroundings.
    pub is_covered: bool,
    /// Its bytes in the file.
    span: Option<Range<usize>>,
}

/// A condition on an edge.
#[derive(Clone, Debug)]
pub enum Condition {
    /// Heat flux that flows in, W/m².
    Flux(Power),
    /// Loss by a film coefficient (W/(m² K)) over time to the environment, which may drift, or to surroundings at a
    /// temperature of their own (K).
    Convection { coefficient: Varying, ambient: Option<History> },
    /// Loss by radiation to the same, beside the film of the surroundings.
    Radiation { emissivity: f64, ambient: Option<History> },
    /// A temperature that is held, K.
    Temperature(History),
    /// A strip of heat flux (W/m²) that moves along the edge toward growing x or y: speed (m/s), width (m),
    /// and the place of its middle at the start (m).
    Moving { speed: f64, width: f64, flux: Power, from: f64 },
}

impl Boundary {
    /// Reads an edge and its condition; records of flux and temperatures must reach over the `run`.
    pub fn read(t: &Reader, body: &Body, run: Along) -> Self {
        let edge = t
            .text(
                "edge",
                "left, right, top or bottom, of a body of revolution outside or bore, or the name of a physical group",
            )
            .unwrap_or_default();
        let names = body.edges();
        if !t.is_described() && !names.contains(&edge) {
            let help = match names.is_empty() {
                true => "a rod has no edges: heat it with [[source]], cool it with effects, or write it as `revolved`, which has \
                         edges that radiate too"
                    .into(),
                false => format!("its edges are {}", names.join(", ")),
            };
            t.problem("edge", format!("`{edge}` is no edge of the body"), help);
        }
        let condition = Condition::read(t, run);
        let is_covered = t.flag("covered", "whether what brings the heat keeps the air off; false").unwrap_or(false);
        if is_covered && !matches!(condition, Condition::Flux(_) | Condition::Moving { .. }) {
            let help = "leave it out: an edge with a film or a temperature of its own loses by that alone";
            t.problem("covered", "no heat is brought to this edge by a flux", help);
        }
        condition.check_reach(t, body, &edge, run);
        Self { edge, condition, is_covered, span: t.span() }
    }

    /// Whether the film of the surroundings acts on the edge: not where it has a film or a temperature of its own, nor
    /// where it is covered. Heat that is brought to it keeps no air off.
    pub fn is_open(&self) -> bool {
        let brings_none = matches!(self.condition, Condition::Convection { .. } | Condition::Temperature(_));
        !self.is_covered && !brings_none
    }

    /// Last time (s) up to which a record of it reaches; infinite without one.
    pub fn known_until(&self) -> f64 {
        let of = |ambient: &Option<History>| ambient.as_ref().map_or(f64::INFINITY, History::known_until);
        match &self.condition {
            Condition::Flux(Power { level: history, .. })
            | Condition::Moving { flux: Power { level: history, .. }, .. }
            | Condition::Temperature(history) => history.known_until(),
            Condition::Convection { coefficient, ambient } => {
                History::from(coefficient.clone()).known_until().min(of(ambient))
            }
            Condition::Radiation { ambient, .. } => of(ambient),
        }
    }
}

impl Condition {
    fn read(t: &Reader, run: Along) -> Self {
        let flux = t
            .quantity("flux", HEAT_FLUX, "heat that flows in")
            .estimated(estimates::POWER)
            .optional_varying(run)
            .map(History::from);
        let on = source::read_on(t, &[]);
        let coefficient = t.quantity("convection", CONVECTION, "film coefficient of a loss").estimated(estimates::FILM);
        let coefficient = coefficient.not_negative().optional_varying(run);
        let emissivity = t.quantity("emissivity", NUMBER, "of a loss by radiation").estimated(estimates::EMISSIVITY);
        let emissivity = emissivity.within(0.0, 1.0).optional();
        let ambient = temperature(t, "ambient", "of what it is lost to; the environment if left out", run);
        let held = temperature(t, "temperature", "that the edge is held at", run);
        let moving = t.optional_table("moving", "a strip of flux that moves along the edge", |t| Self::Moving {
            speed: t.quantity("speed", SPEED, "of the strip, toward growing x or y").required(),
            width: t.quantity("width", LENGTH, "of the strip").positive().required(),
            flux: Power {
                level: History::from(
                    t.quantity("flux", HEAT_FLUX, "heat that flows in under it")
                        .estimated(estimates::POWER)
                        .varying(run),
                ),
                on: on.clone(),
            },
            from: t.quantity("from", LENGTH, "where its middle is at the start").or(0.0),
        });
        let given = [flux.is_some(), coefficient.is_some(), emissivity.is_some(), held.is_some(), moving.is_some()];
        if given.iter().filter(|g| **g).count() != 1 && !t.is_described() {
            t.problem(
                "",
                "an edge has one condition",
                "give one of flux, convection, emissivity, temperature and moving; another [[boundary]] adds another",
            );
        }
        if t.has("on") && flux.is_none() && moving.is_none() {
            let help =
                "leave it out, or let a flux be on and off; a film that changes is a record: convection = { file }";
            t.problem("on", "only a flux is switched on and off", help);
        }
        match (flux, coefficient, emissivity, held, moving) {
            (Some(level), ..) => Self::Flux(Power { level, on }),
            (_, Some(coefficient), ..) => Self::Convection { coefficient, ambient },
            (_, _, Some(emissivity), ..) => Self::Radiation { emissivity, ambient },
            (.., Some(held), _) => Self::Temperature(held),
            (.., moving) => moving.unwrap_or(Self::Flux(Power::switched(0.0, &[]))),
        }
    }
}

impl Condition {
    /// Refuses a strip of flux that is beside the body all along the `run`.
    fn check_reach(&self, t: &Reader, body: &Body, edge: &str, run: Along) {
        let (Self::Moving { speed, width, from, .. }, Some(plane)) = (self, body.plane()) else { return };
        // Edges of meshes from files go anywhere.
        let is_straight = body.has_sections() && body.edges().iter().any(|own| own == edge);
        let axes = if is_straight { vec![axis_of(edge)] } else { vec![0, 1] };
        let places = run.needed.map(|time| from + speed * time);
        let (first, last) = (places[0].min(places[1]) - 0.5 * width, places[0].max(places[1]) + 0.5 * width);
        let misses = |axis: &usize| {
            let [low, high] = plane.extent(*axis);
            last <= low || first >= high
        };
        if t.is_as_written() && axes.iter().all(misses) {
            let [low, high] = plane.extent(axes[0]).map(|place| LENGTH.format(place));
            let [first, last] = [first, last].map(|place| LENGTH.format(place));
            let message = format!("the strip goes from {first} to {last} in this run, and never comes to the edge");
            t.problem(
                "moving",
                message,
                format!("the edge goes from {low} to {high}: look at `from`, `speed` and `[time] end`"),
            );
        }
    }
}

/// Refuses conditions that cannot hold on one edge together: two temperatures, and a film where it is covered.
pub fn refuse_contradictions(model: &Reader, boundaries: &[Boundary]) {
    for (i, own) in boundaries.iter().enumerate() {
        let others = || boundaries[..i].iter().chain(&boundaries[i + 1..]).filter(|other| other.edge == own.edge);
        let is_held = |b: &Boundary| matches!(b.condition, Condition::Temperature(_));
        let loses = |b: &Boundary| matches!(b.condition, Condition::Convection { .. });
        let edge = &own.edge;
        if is_held(own) && boundaries[..i].iter().any(|other| other.edge == *edge && is_held(other)) {
            let message = format!("edge `{edge}` is held at two temperatures");
            let help = "keep one of them, or part the edge in a mesh of your own";
            model.problem_at(own.span.clone(), message, help);
        }
        if own.is_covered && others().any(loses) {
            let message = format!("edge `{edge}` is covered, and loses heat by a film of its own");
            model.problem_at(own.span.clone(), message, "leave out `covered`, or the film");
        }
    }
}

/// A temperature (K) of an edge or beside it, constant or recorded.
pub fn temperature(t: &Reader, key: &'static str, about: &'static str, run: Along) -> Option<History> {
    let given = t.quantity(key, TEMPERATURE, about).estimated(estimates::TEMPERATURE).optional_varying(run)?;
    refuse_impossible(t, key, given.least());
    Some(History::from(given))
}

/// Nothing is below the absolute zero; a temperature (K) that is still unknown passes.
pub fn refuse_impossible(t: &Reader, key: &'static str, temperature: f64) {
    if temperature < 0.0 {
        t.problem(key, "nothing is that cold", "it must be above -273.15 degC");
    }
}
