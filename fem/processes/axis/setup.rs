//! The tables of an axis model.

use super::allowed::ALLOWED;
use super::drag::Drag;
use crate::element::Round;
use crate::input::{Along, Reader, Varying};
use crate::material::Material;
use crate::positioning::{Measures, Tolerance};
use crate::process::{Allowed, Controller, Nut, estimates};
use crate::solve::Bar;
use crate::units::{LENGTH, TEMPERATURE, TIME};

/// Most rows of a test: more than any test has.
const MOST_ROWS: usize = 500_000;
/// The test where the model does not say.
const USUAL: Test =
    Test { positions: 11, runs: 5, spacing: Spacing::Even, reading: 20.0, pause: 0.0, reading_at_zero: None };

/// How the targets of the model's own test stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// Evenly from end to end.
    Even,
    /// Evenly, and each moved on by another part of the lead, so that errors of the screw's turn show
    /// (ISO 230-2).
    Staggered,
}

/// The positioning test that the model predicts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// Number of targets.
    pub positions: usize,
    /// Number of runs, each forwards and back.
    pub runs: usize,
    /// How the targets stand.
    pub spacing: Spacing,
    /// Time from one reading to the next, s.
    pub reading: f64,
    /// Time between runs, s.
    pub pause: f64,
    /// Reading of the instrument where the axis stands right, m, if the model says it.
    pub reading_at_zero: Option<f64>,
}

/// How warm the screw is over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Warmth {
    /// Temperature of the screw, K over s.
    pub temperature: Varying,
    /// Temperature at which its lead is right, K.
    pub reference: f64,
}

/// Everything an axis model says but its effects. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Where the travel begins, m.
    pub from: f64,
    /// Length of the travel, m.
    pub travel: f64,
    /// How friction goes along it, where that is measured.
    pub drag: Option<Drag>,
    /// Material of the screw.
    pub material: Material,
    /// Diameter of the screw, m.
    pub diameter: f64,
    /// Travel in a turn of the screw, m.
    pub lead: f64,
    /// Position of the fixed bearing, m.
    pub fixed_at: f64,
    /// Position of a second fixed bearing, m.
    pub also_fixed_at: Option<f64>,
    /// Its nut, where that is preloaded.
    pub nut: Option<Nut>,
    /// How warm it is, where that is measured.
    pub warmth: Option<Warmth>,
    /// The test.
    pub test: Test,
    /// Deviations that the axis is allowed.
    pub tolerance: Tolerance,
    /// What the drawing allows.
    pub allowed: Allowed,
    /// The controller's compensation.
    pub controller: Controller,
}

impl Spacing {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("even", Self::Even), ("staggered", Self::Staggered)];
}

impl Setup {
    /// Reads every table of an axis model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let (from, travel, drag) = model.table("axis", "the axis", |t| {
            let travel = t.quantity("travel", LENGTH, "length of the travel").positive().required();
            let from = t.quantity("from", LENGTH, "position at which the travel begins").or(0.0);
            (from, travel, Drag::read(t, [from, from + travel]))
        });
        let test = model.optional_table("test", "the positioning test", read_test).unwrap_or(USUAL);
        let (material, [diameter, lead, fixed_at], also_fixed_at, warmth, nut) =
            model.table("screw", "the ball screw", |t| {
                let material = Material::read(t, "material");
                let diameter = t.quantity("diameter", LENGTH, "diameter of the screw").positive().required();
                let lead = t.quantity("lead", LENGTH, "travel a turn").positive().required();
                let fixed_at = t.quantity("fixed_at", LENGTH, "position of the fixed bearing").or(0.0);
                let about = "position of a second fixed bearing; the far end is free along itself if left out";
                let also = t.quantity("also_fixed_at", LENGTH, about).optional();
                if also == Some(fixed_at) {
                    let help = "leave `also_fixed_at` out, or name the other end of the screw";
                    t.problem("also_fixed_at", "both bearings stand at one place", help);
                }
                let warmth = Warmth::read(t, &test);
                if also.is_some() && warmth.is_some() {
                    let help = "leave `temperature` out: between two fixed bearings it stretches and does not grow";
                    t.problem("temperature", "a screw that is held at either end cannot follow its temperature", help);
                }
                (material, [diameter, lead, fixed_at], also, warmth, Nut::read(t))
            });
        let (tolerance, allowed) = model
            .optional_table("tolerance", "what the axis is allowed", |t| {
                (read_tolerance(t), Allowed::read(t, &ALLOWED))
            })
            .unwrap_or_default();
        let about = "the controller's compensation, for `fem compensate`";
        let controller = model.optional_table("controller", about, |t| Controller::read(t, travel, Measures::LINEAR));
        Self {
            from,
            travel,
            drag,
            material,
            diameter,
            lead,
            fixed_at,
            also_fixed_at,
            nut,
            warmth,
            test,
            tolerance,
            allowed,
            controller: controller.unwrap_or_default(),
        }
    }

    /// The screw as a bar on its bearings.
    pub fn screw(&self) -> Bar {
        let area = Round { diameter: self.diameter, bore: 0.0 }.area();
        let held = std::iter::once(self.fixed_at).chain(self.also_fixed_at);
        Bar { axial_rigidity: self.material.youngs_modulus * area, held: held.collect() }
    }

    /// Friction at a position (m) over its mean along the travel.
    pub fn drag_at(&self, position: f64) -> f64 {
        self.drag.as_ref().map_or(1.0, |drag| drag.at(position))
    }

    /// How far the screw has grown at a position (m) and a time (s), m: expansion·(T − reference)·(position −
    /// fixed_at), nothing where its temperature is not told.
    pub fn growth(&self, position: f64, time: f64) -> f64 {
        let rise = self.warmth.as_ref().map_or(0.0, |w| w.temperature.at(time) - w.reference);
        self.material.expansion * rise * (position - self.fixed_at)
    }

    /// Last time (s) up to which the temperature of the screw is known.
    pub fn known_until(&self) -> f64 {
        self.warmth.as_ref().map_or(f64::INFINITY, |warmth| warmth.temperature.known_until())
    }

    /// The targets of the model's own test, rising, m; a single one stands in the middle.
    pub fn targets(&self) -> Vec<f64> {
        /// The golden ratio's part: the parts of a turn that follow from it lie as evenly as any.
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        if self.test.positions == 1 {
            return vec![self.from + 0.5 * self.travel];
        }
        let last = (self.test.positions - 1) as f64;
        let at = |i: usize| {
            let part = i as f64 / last;
            match self.test.spacing {
                Spacing::Even => self.from + self.travel * part,
                Spacing::Staggered => {
                    let room = self.lead.min(0.5 * self.travel / last);
                    self.from + (self.travel - room) * part + room * (i as f64 * GOLDEN).fract()
                }
            }
        };
        (0..self.test.positions).map(at).collect()
    }
}

impl Warmth {
    /// Reads the temperature of the screw; a record must reach over the test.
    fn read(t: &Reader, test: &Test) -> Option<Self> {
        /// ISO 1.
        const USUAL: f64 = 293.15;
        let run = Along { name: "time", kind: TIME, needed: [0.0, test.lasts()] };
        let about = "of the screw, which grows with it from its fixed bearing; none if left out";
        let temperature =
            t.quantity("temperature", TEMPERATURE, about).estimated(estimates::TEMPERATURE).optional_varying(run);
        let reference =
            t.quantity("reference_temperature", TEMPERATURE, "of the screw at which its lead is right").or(USUAL);
        let temperature = temperature?;
        if temperature.least() < 0.0 {
            t.problem("temperature", "nothing is that cold", "it must be above -273.15 degC");
        }
        Some(Self { temperature, reference })
    }
}

impl Test {
    /// Time of one run there and back, with the pause behind it, s.
    pub fn round(&self) -> f64 {
        (2 * self.positions) as f64 * self.reading + self.pause
    }

    /// Time of the last reading, s.
    pub fn lasts(&self) -> f64 {
        self.runs as f64 * self.round() - self.pause
    }
}

fn read_test(t: &Reader) -> Test {
    let positions = t.count("positions", "targets along the travel").between(1, 10_000).or(USUAL.positions);
    let runs = t.count("runs", "runs, each forwards and back").between(1, 10_000).or(USUAL.runs);
    if 2 * positions * runs > MOST_ROWS {
        let message = format!("{positions} targets in {runs} runs there and back are more than {MOST_ROWS} rows");
        t.problem("positions", message, "take fewer targets or runs");
    }
    Test {
        positions,
        runs,
        spacing: t.choice("spacing", "how the targets stand", Spacing::WORDS).or_first(USUAL.spacing),
        reading: t.quantity("reading", TIME, "from one reading to the next").not_negative().or(USUAL.reading),
        pause: t.quantity("pause", TIME, "between runs").not_negative().or(USUAL.pause),
        reading_at_zero: t
            .quantity("reading_at_zero", LENGTH, "what the instrument shows where the axis stands right; 0 if left out")
            .optional(),
    }
}

fn read_tolerance(t: &Reader) -> Tolerance {
    let usual = Tolerance::default();
    Tolerance {
        per_length: t
            .quantity("per_length", LENGTH, "allowed either way on any `length`")
            .positive()
            .or(usual.per_length),
        length: t.quantity("length", LENGTH, "length on which `per_length` holds").positive().or(usual.length),
        travel: t
            .quantity("travel", LENGTH, "allowed over the whole travel, end to end of the band")
            .positive()
            .or(usual.travel),
        repeatability: t
            .quantity("repeatability", LENGTH, "allowed scatter and reversal, either way")
            .positive()
            .or(usual.repeatability),
        measures: Measures::LINEAR,
    }
}
