//! The tables of a thermal model.

use std::sync::OnceLock;

use super::body::Body;
use crate::input::Reader;
use crate::material::Material;
use crate::process::Failure;
use crate::solve::conduction::Scheme;
use crate::units::{CONVECTION, HEAT_FLUX, LENGTH, POWER, SPEED, TEMPERATURE, TEMPERATURE_RISE, TIME};

/// Steps of a run, at most.
pub const MOST_STEPS: f64 = 200_000.0;
/// Times at which the model's own programme looks, as a rule and at most.
const USUAL_TIMES: f64 = 100.0;
const MOST_TIMES: f64 = 20_000.0;
/// Places at which it looks, evenly from end to end.
const USUAL_PLACES: usize = 5;

/// A source of heat.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// m from the base.
    pub at: f64,
    /// W.
    pub power: f64,
    /// Intervals (s) in which it is on; none means always.
    pub on: Vec<[f64; 2]>,
}

/// What holds on an edge of a plane body.
#[derive(Clone, Debug, PartialEq)]
pub struct Boundary {
    /// Name of the edge.
    pub edge: String,
    /// What.
    pub condition: Condition,
}

/// What holds on an edge.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Heat flows in while it is on.
    Flux {
        /// W/m².
        flux: f64,
        /// Intervals (s); none means always.
        on: Vec<[f64; 2]>,
    },
    /// Loss to surroundings: of the environment, which may drift, or at a temperature of their own (K).
    Convection {
        /// W/(m² K).
        coefficient: f64,
        /// K.
        ambient: Option<f64>,
    },
    /// A temperature that is held, K.
    Temperature(f64),
    /// A strip of flux that moves along the edge.
    Moving {
        /// m/s, toward growing x or y.
        speed: f64,
        /// m.
        width: f64,
        /// W/m² under it.
        flux: f64,
        /// Where its middle is at the start, m.
        from: f64,
    },
}

/// How time is stepped through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// s.
    pub end: f64,
    /// Longest step, s; chosen by `tolerance` where it is not given.
    pub step: Option<f64>,
    /// Largest error of a temperature that a chosen step may leave, K.
    pub tolerance: f64,
    /// Of every step.
    pub scheme: Scheme,
}

/// Everything a thermal model says but its effects. SI units.
#[derive(Clone, Debug)]
pub struct Setup {
    /// What the body is made of.
    pub material: Material,
    /// Its shape.
    pub body: Body,
    /// In the order of the file.
    pub sources: Vec<Source>,
    /// In the order of the file; rods have none.
    pub boundaries: Vec<Boundary>,
    /// Of the surroundings, and of the body at the start, K.
    pub ambient: f64,
    /// Steps.
    pub time: Time,
    /// Longest element along the body, m.
    pub element_size: f64,
    /// Where the programme looks, m from the base.
    pub places: Vec<f64>,
    /// When it looks, s.
    pub times: Vec<f64>,
    /// The step that was chosen by the tolerance, once it has been.
    pub chosen: OnceLock<Result<f64, Failure>>,
}

/// The default first.
const SCHEMES: &[(&str, Scheme)] =
    &[("sdirk2", Scheme::Sdirk2), ("crank-nicolson", Scheme::CrankNicolson), ("backward-euler", Scheme::BackwardEuler)];

impl Setup {
    /// Reads every table of a thermal model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let (material, body) =
            model.table("body", "the body that is heated", |t| (Material::read(t, "material"), Body::read(t)));
        let length = body.length();
        let sources = model.list("source", "a source of heat, spread over the section", |t, _| Source::read(t, &body));
        let boundaries =
            model.list("boundary", "what holds on an edge of a plane body", |t, _| Boundary::read(t, &body));
        let ambient = model.table("environment", "what is around the body", |t| {
            let ambient =
                t.quantity("temperature", TEMPERATURE, "of the surroundings, and of the body at the start").required();
            if ambient < 0.0 {
                t.problem("temperature", "nothing is that cold", "it must be above -273.15 degC");
            }
            ambient
        });
        let time = model.table("time", "how long and in which steps", Time::read);
        let usual_size = length / f64::from(body.usual_elements());
        let element_size = model.optional_table("mesh", "the body in finite elements", |t| {
            let size = t.quantity("element_size", LENGTH, "longest element along the body").positive().or(usual_size);
            if length / size > body.most_elements() {
                t.problem(
                    "element_size",
                    format!("{:.0} elements along the body are too many", length / size),
                    format!("it must be above {:.3} mm", 1e3 * length / body.most_elements()),
                );
            }
            size
        });
        let (places, times) = model
            .optional_table("measurement", "where and when a run looks", |t| read_measurement(t, length, &time))
            .unwrap_or_else(|| (usual_places(length), evenly(time.end, time.end / USUAL_TIMES)));
        let setup = Self {
            material,
            body,
            sources,
            boundaries,
            ambient,
            time,
            element_size: element_size.unwrap_or(usual_size),
            places,
            times,
            chosen: OnceLock::new(),
        };
        setup.check(model);
        setup
    }

    /// The temperature of something over that at the start, K.
    pub fn rise(&self, temperature: f64) -> f64 {
        temperature - self.ambient
    }

    /// Why an effect cannot act on this body, if it cannot.
    ///
    /// # Errors
    /// The reason, as a sentence.
    pub fn admits(&self, effect: &str) -> Result<(), String> {
        match (effect, &self.body) {
            ("contact-resistance", Body::Plane(_)) => {
                Err("`contact-resistance` is known of rods, which it cuts through, not of plane bodies".into())
            }
            ("base-conductance" | "extra-source", Body::Plane(plane)) if plane.size.is_none() => Err(format!(
                "`{effect}` is known of rods and rectangles, whose sections it acts on, not of meshes from files"
            )),
            _ => Ok(()),
        }
    }

    fn check(&self, model: &Reader) {
        let by_effect = ["extra-source", "ambient-drift"].iter().any(|effect| model.has_in("effects", effect));
        if self.sources.is_empty() && self.boundaries.is_empty() && !by_effect && !model.is_described() {
            model.problem(
                "source",
                "nothing heats or cools the body",
                "add [[source]] with at and power, or [[boundary]] of a plane body",
            );
        }
    }
}

impl Source {
    fn read(t: &Reader, body: &Body) -> Self {
        let at = t.quantity("at", LENGTH, "place along the body, from the base").not_negative().required();
        if at > body.length() * (1.0 + 1e-12) {
            t.problem(
                "at",
                format!("the source stands at {} mm, beyond the body", 1e3 * at),
                format!("the body ends at {} mm", 1e3 * body.length()),
            );
        }
        if matches!(body, Body::Plane(plane) if plane.size.is_none()) && !t.is_described() {
            t.problem(
                "at",
                "a source stands over a section, and a mesh from a file has none",
                "let the heat in through an edge: [[boundary]] with flux",
            );
        }
        Self { at, power: t.quantity("power", POWER, "heat that it gives").required(), on: read_on(t) }
    }
}

/// Intervals in which something is on.
fn read_on(t: &Reader) -> Vec<[f64; 2]> {
    let mut on = t.intervals("on", TIME, "when it is on; always if left out").unwrap_or_default();
    on.sort_by(|a, b| a[0].total_cmp(&b[0]));
    if on.windows(2).any(|pair| pair[1][0] < pair[0][1]) {
        t.problem("on", "intervals overlap", "join them: heat is not given twice");
    }
    on
}

impl Boundary {
    fn read(t: &Reader, body: &Body) -> Self {
        let edge = t.text("edge", "left, right, top or bottom, or the name of a physical group").unwrap_or_default();
        let names = body.edges();
        if !t.is_described() && !names.contains(&edge) {
            let help = match names.is_empty() {
                true => "a rod has no edges: heat it with [[source]], cool it with effects".into(),
                false => format!("its edges are {}", names.join(", ")),
            };
            t.problem("edge", format!("`{edge}` is no edge of the body"), help);
        }
        let flux = t.quantity("flux", HEAT_FLUX, "heat that flows in").optional();
        let on = read_on(t);
        let convection = t.quantity("convection", CONVECTION, "film coefficient of a loss").not_negative().optional();
        let ambient =
            t.quantity("ambient", TEMPERATURE, "of what it is lost to; the environment if left out").optional();
        let temperature = t.quantity("temperature", TEMPERATURE, "that the edge is held at").optional();
        let moving = t.optional_table("moving", "a strip of flux that moves along the edge", |t| Condition::Moving {
            speed: t.quantity("speed", SPEED, "of the strip, toward growing x or y").required(),
            width: t.quantity("width", LENGTH, "of the strip").positive().required(),
            flux: t.quantity("flux", HEAT_FLUX, "heat that flows in under it").required(),
            from: t.quantity("from", LENGTH, "where its middle is at the start").or(0.0),
        });
        let given = [flux.is_some(), convection.is_some(), temperature.is_some(), moving.is_some()];
        if given.iter().filter(|g| **g).count() != 1 && !t.is_described() {
            t.problem(
                "",
                "an edge has one condition",
                "give one of flux, convection, temperature and moving; another [[boundary]] adds another",
            );
        }
        let condition = match (flux, convection, temperature, moving) {
            (Some(flux), ..) => Condition::Flux { flux, on },
            (_, Some(coefficient), ..) => Condition::Convection { coefficient, ambient },
            (_, _, Some(temperature), _) => Condition::Temperature(temperature),
            (.., moving) => moving.unwrap_or(Condition::Flux { flux: 0.0, on: Vec::new() }),
        };
        Self { edge, condition }
    }
}

impl Time {
    /// Of the scheme: errors fall as this power of the step.
    pub fn order(&self) -> u32 {
        match self.scheme {
            Scheme::BackwardEuler => 1,
            Scheme::CrankNicolson | Scheme::Sdirk2 => 2,
        }
    }

    fn read(t: &Reader) -> Self {
        let end = t.quantity("end", TIME, "when the run ends").positive().required();
        let step = t.quantity("step", TIME, "longest time step; chosen by tolerance if left out").positive().optional();
        if step.is_some_and(|step| end / step > MOST_STEPS) {
            t.problem(
                "step",
                format!("these are more than {MOST_STEPS} steps"),
                "take longer steps, or leave `step` out",
            );
        }
        let tolerance = t.quantity("tolerance", TEMPERATURE_RISE, "error of a temperature that chosen steps may leave");
        Self {
            end,
            step,
            tolerance: tolerance.positive().or(0.01),
            scheme: t.choice("scheme", "how time is stepped through", SCHEMES).or_first(Scheme::Sdirk2),
        }
    }
}

fn read_measurement(t: &Reader, length: f64, time: &Time) -> (Vec<f64>, Vec<f64>) {
    let places = t.quantities("places", LENGTH, "where temperatures are predicted, from the base");
    let places = places.unwrap_or_else(|| usual_places(length));
    // A length that is still to be fitted reaches anywhere.
    if let Some(place) =
        places.iter().filter(|_| !length.is_nan()).find(|x| !(0.0..=length * (1.0 + 1e-12)).contains(*x))
    {
        t.problem(
            "places",
            format!("{} mm is not on the body", 1e3 * place),
            format!("it reaches from 0 to {} mm", 1e3 * length),
        );
    }
    let interval =
        t.quantity("interval", TIME, "from one prediction to the next").positive().or(time.end / USUAL_TIMES);
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
