//! The tables of a thermal model.

use std::sync::Arc;

use super::allowed::ALLOWED;
use super::body::{Body, MOST_CELLS};
use super::boundary::{self, Boundary, refuse_impossible};
use super::circles;
use super::source::{self, Source, Strip};
use super::steps::Steps;
use super::surroundings::{self, Surroundings};
use crate::input::{Along, Reader};
use crate::material::{Material, OverTemperature};
use crate::process::{Allowed, estimates};
use crate::solve::conduction::Scheme;
use crate::solve::rod::{History, Known, PointSource};
use crate::units::{LENGTH, TEMPERATURE, TEMPERATURE_RISE, TIME};

/// Most steps of a run.
pub const MOST_STEPS: f64 = 200_000.0;
/// Times at which the model's own programme looks, as a rule and at most.
const USUAL_TIMES: f64 = 100.0;
const MOST_TIMES: f64 = 20_000.0;
/// Places at which it looks where nobody says, evenly from end to end.
const USUAL_PLACES: usize = 5;

/// How time is stepped through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// End of the run, s.
    pub end: f64,
    /// Longest step, s; chosen by `tolerance` where it is not given.
    pub step: Option<f64>,
    /// Largest error of a temperature that a chosen step may leave, K.
    pub tolerance: f64,
    /// Scheme of every step.
    pub scheme: Scheme,
}

/// Everything a thermal model says but its effects. SI units.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Material of the body.
    pub material: Material,
    /// Properties that change with its temperature.
    pub over_temperature: OverTemperature,
    /// Shape of the body.
    pub body: Body,
    /// Sources in the order of the file.
    pub sources: Vec<PointSource>,
    /// Strips of a body of revolution that are heated.
    pub strips: Vec<Strip>,
    /// Conditions on edges in the order of the file; rods have none.
    pub boundaries: Vec<Boundary>,
    /// Temperature of the surroundings over time, K.
    pub ambient: History,
    /// Temperature of what holds the base over time, K, where it is not that of the surroundings.
    pub at_base: Option<History>,
    /// Lengths of a rod or of a body of revolution with surroundings of their own.
    pub sections: Vec<Surroundings>,
    /// Temperature of the body at the start, K.
    pub start: f64,
    /// Time and its steps.
    pub time: Time,
    /// Longest element along the body, m.
    pub element_size: f64,
    /// Places at which the programme looks, m from the base.
    pub places: Vec<f64>,
    /// Circles of a body of revolution whose diameters it looks at: distance from the left end, and radius, m.
    pub circles: Vec<[f64; 2]>,
    /// Times at which it looks, s.
    pub times: Vec<f64>,
    /// What the drawing allows.
    pub allowed: Allowed,
    /// Steps that are chosen by the tolerance.
    pub steps: Arc<Steps>,
    /// Runs of rods that are known, kept by the model.
    pub rods: Arc<Known>,
}

/// The default first.
const SCHEMES: &[(&str, Scheme)] =
    &[("sdirk2", Scheme::Sdirk2), ("crank-nicolson", Scheme::CrankNicolson), ("backward-euler", Scheme::BackwardEuler)];

impl Setup {
    /// Reads every table of a thermal model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let ((material, over_temperature), body, own_start) = model.table("body", "the body that is heated", |t| {
            let (material, body) = (Material::read_over_temperature(t, "material"), Body::read(t));
            refuse_rods(t, &body, material.1.is_constant());
            let start = t.quantity("temperature", TEMPERATURE, "at the start; that of the surroundings if left out");
            let start = start.estimated(estimates::TEMPERATURE).optional();
            refuse_impossible(t, "temperature", start.unwrap_or(0.0));
            (material, body, start.map(|start| (start, t.is_uncertain("temperature"))))
        });
        let length = body.length();
        // Records must reach over the whole run.
        let time = model.table("time", "how long and in which steps", Time::read);
        let run = Along { name: "time", kind: TIME, needed: [0.0, time.end] };
        let about = "a source of heat, spread over the section, or over a strip";
        let (mut sources, mut strips) = (Vec::new(), Vec::new());
        for source in model.list("source", about, |t, _| source::read(t, &body, run)) {
            match source {
                Source::Section(source) => sources.push(source),
                Source::Strip(strip) => strips.push(strip),
            }
        }
        let boundaries =
            model.list("boundary", "what holds on an edge of a body", |t, _| Boundary::read(t, &body, run));
        boundary::refuse_contradictions(model, &boundaries);
        let ambient = model.table("environment", "what is around the body", |t| {
            let about = "of the surroundings, and of a body that has none of its own at the start";
            let ambient = t.quantity("temperature", TEMPERATURE, about).estimated(estimates::TEMPERATURE).varying(run);
            refuse_impossible(t, "temperature", ambient.least());
            let about = "of what holds the base; that of the surroundings if left out";
            let at_base = boundary::temperature(t, "base_temperature", about, run);
            let about = "a length of a round body with surroundings of its own";
            let sections = t.list("section", about, |t, _| Surroundings::read(t, &body, run));
            surroundings::refuse_overlaps(t, &sections);
            (History::from(ambient), t.is_uncertain("temperature"), at_base, sections)
        });
        let (ambient, ambient_is_uncertain, at_base, sections) = ambient;
        surroundings::refuse_taken(model, &sections, &boundaries);
        let start = own_start.map_or(ambient.at(0.0), |(start, _)| start);
        let [usual_size, least_size] = body.sizes();
        let element_size = model.optional_table("mesh", "the body in finite elements", |t| {
            let size =
                t.quantity("element_size", LENGTH, "longest element along the body").chosen().positive().or(usual_size);
            if size < least_size {
                t.problem(
                    "element_size",
                    format!("{:.0} elements along the body are too many", length / size),
                    format!("it must be above {:.3}", LENGTH.shown(least_size)),
                );
            }
            size
        });
        let cells = body.cells(element_size.unwrap_or(usual_size)).unwrap_or(0.0);
        if cells > MOST_CELLS {
            let name = if body.revolved().is_some() { "body" } else { "rectangle" };
            let message = format!("the {name} has {cells:.0} elements; at most {MOST_CELLS:.0} are computed with");
            model.problem("body", message, "check its dimensions, or give a longer [mesh] element_size");
        }
        let looks = model.optional_table("measurement", "where and when a run looks", |t| {
            let circles = circles::read(t, &body);
            let (places, times) = read_measurement(t, length, &time);
            (circles, places, times)
        });
        let (circles, places, times) = looks
            .unwrap_or_else(|| (circles::usual(&body), usual_places(length), evenly(time.end, time.end / USUAL_TIMES)));
        let element_size = element_size.unwrap_or(usual_size);
        let rods = model.kept();
        let allowed = model
            .optional_table("tolerance", "what the growth is held against", |t| Allowed::read(t, &ALLOWED))
            .unwrap_or_default();
        let setup = Self {
            material,
            over_temperature,
            body,
            sources,
            strips,
            boundaries,
            ambient,
            at_base,
            sections,
            start,
            time,
            element_size,
            places,
            circles,
            times,
            allowed,
            steps: Arc::default(),
            rods,
        };
        let by_effect = ["extra-source", "ambient-drift"].iter().any(|effect| model.has_in("effects", effect));
        // A search may come upon values at which they are equal.
        let may_differ = own_start.is_some_and(|(_, is_uncertain)| is_uncertain || ambient_is_uncertain);
        let is_heated =
            !(setup.sources.is_empty() && setup.strips.is_empty() && setup.boundaries.is_empty()) || by_effect;
        if !(is_heated || may_differ || setup.is_out_of_balance() || model.is_described()) {
            model.problem(
                "source",
                "nothing heats or cools the body",
                "add [[source]] with at and power, [[boundary]] of a plane body, or a temperature of its own to [body]",
            );
        }
        setup
    }

    /// Whether the surroundings are at another temperature than the body at the start, then or later.
    pub fn is_out_of_balance(&self) -> bool {
        let others = self.at_base.iter().chain(self.sections.iter().map(|s| &s.temperature));
        let differs = |all: &History| matches!(all, History::Record(_)) || (all.at(0.0) - self.start).abs() > 0.0;
        others.chain([&self.ambient]).any(differs)
    }

    /// Last time (s) up to which all records reach.
    pub fn known_until(&self) -> f64 {
        let strips = self.strips.iter().map(|strip| &strip.power);
        let powers = self.sources.iter().map(|source| &source.power).chain(strips);
        let powers = powers.map(|power| power.level.known_until());
        let edges = self.boundaries.iter().map(Boundary::known_until);
        let others = self.at_base.iter().chain(self.sections.iter().map(|s| &s.temperature));
        powers.chain(edges).chain(others.map(History::known_until)).fold(self.ambient.known_until(), f64::min)
    }

    /// Whether effects on sections can act.
    ///
    /// # Errors
    /// The body has no sections.
    pub fn needs_sections(&self) -> Result<(), String> {
        match self.body.has_sections() {
            true => Ok(()),
            false => Err("is known of bodies with sections, on which it acts, not of meshes from files".into()),
        }
    }
}

impl Time {
    /// Order of the scheme: errors fall as this power of the step.
    pub fn order(&self) -> u32 {
        match self.scheme {
            Scheme::BackwardEuler => 1,
            Scheme::CrankNicolson | Scheme::Sdirk2 => 2,
        }
    }

    /// Name of the scheme in a model file.
    pub fn scheme_name(&self) -> &'static str {
        SCHEMES.iter().find(|(_, scheme)| *scheme == self.scheme).map_or("", |(name, _)| name)
    }

    fn read(t: &Reader) -> Self {
        let end = t.quantity("end", TIME, "when the run ends").chosen().positive().required();
        let step = t
            .quantity("step", TIME, "longest time step; chosen by tolerance if left out")
            .chosen()
            .positive()
            .optional();
        if step.is_some_and(|step| end / step > MOST_STEPS) {
            let message = format!("these are more than {MOST_STEPS} steps");
            t.problem("step", message, "take longer steps, or leave `step` out");
        }
        let tolerance =
            t.quantity("tolerance", TEMPERATURE_RISE, "error of a temperature that chosen steps may leave").chosen();
        Self {
            end,
            step,
            tolerance: tolerance.positive().or(0.01),
            scheme: t.choice("scheme", "how time is stepped through", SCHEMES).or_first(Scheme::Sdirk2),
        }
    }
}

/// Refuses properties over temperature where they are not computed with.
fn refuse_rods(t: &Reader, body: &Body, is_constant: bool) {
    if matches!(body, Body::Rod(_)) && !is_constant {
        let help = "write it as a body of revolution: revolved = [{ length = \"200 mm\", diameter = \"20 mm\" }]";
        t.problem(
            "material",
            "properties over temperature are known of plane bodies and of bodies of revolution",
            help,
        );
    }
}

fn read_measurement(t: &Reader, length: f64, time: &Time) -> (Vec<f64>, Vec<f64>) {
    let places = t.quantities("places", LENGTH, "where temperatures are predicted, from the base");
    let places = places.unwrap_or_else(|| usual_places(length));
    // A length that is still to be fitted reaches anywhere.
    let off = |x: &&f64| !length.is_nan() && !(0.0..=length * (1.0 + 1e-12)).contains(*x);
    if let Some(place) = places.iter().find(off) {
        t.problem(
            "places",
            format!("{} is not on the body", LENGTH.format(*place)),
            format!("it reaches from 0 to {}", LENGTH.format(length)),
        );
    }
    let interval =
        t.quantity("interval", TIME, "from one prediction to the next").chosen().positive().or(time.end / USUAL_TIMES);
    if time.end / interval > MOST_TIMES {
        t.problem("interval", format!("these are more than {MOST_TIMES} times"), "take a longer interval");
        return (places, Vec::new());
    }
    (places, evenly(time.end, interval))
}

fn usual_places(length: f64) -> Vec<f64> {
    (0..USUAL_PLACES).map(|i| length * i as f64 / (USUAL_PLACES - 1) as f64).collect()
}

/// Times from one interval on to the end.
fn evenly(end: f64, interval: f64) -> Vec<f64> {
    if !(end.is_finite() && interval > 0.0) {
        return Vec::new();
    }
    let count = (end / interval + 1e-9).floor() as usize;
    let mut times: Vec<f64> = (1..=count).map(|i| interval * i as f64).collect();
    match times.last_mut() {
        Some(last) if (*last - end).abs() <= 1e-9 * end => *last = end,
        _ => times.push(end),
    }
    times
}
