//! The tables of a cam model.

use super::allowed::ALLOWED;
use super::before::Before;
use super::division::{Division, Speed};
use super::guide::wheel_rate;
use super::profile::{self, Drawn, Profile, Segment, turn};
use super::program::Program;
use crate::input::Reader;
use crate::process::estimates::CUTTING_FORCE;
use crate::process::{Allowed, Spot};
use crate::units::{FORCE_PER_RATE, LENGTH, MICRO};

/// Everything a cam model says but its effects. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// The cam as it is to be.
    pub profile: Profile,
    /// The lines and arcs of which it is drawn.
    pub segments: Vec<Segment>,
    /// Radius of the wheel as it is programmed, m.
    pub wheel_radius: f64,
    /// Thickness of the layer that a turn takes off, m.
    pub stock: Option<f64>,
    /// Normal force per removal rate and unit width, N/(m²/s).
    pub force_per_rate: Option<f64>,
    /// The way in which blocks are chosen.
    pub division: Division,
    /// The programme.
    pub program: Program,
    /// The pass before, where its programme was another.
    pub before: Option<Before>,
    /// What the drawing allows.
    pub allowed: Allowed,
    /// Points of the prediction in each block.
    pub points: usize,
}

impl Setup {
    /// Reads every table of a cam model but `[effects]`; `None`, with the problems noted, where there is no
    /// profile or no programme.
    pub fn read(model: &Reader) -> Option<Self> {
        let setup = Self::read_tables(model);
        if setup.is_none() && model.is_sound() && !model.is_described() {
            let help = "give it a value, `+-` how well it is known; what a wheel has lost is the effect wheel-wear";
            model.problem("", "a profile, a wheel or a programme that is unknown (`?`) makes no cam", help);
        }
        setup
    }

    fn read_tables(model: &Reader) -> Option<Self> {
        let drawn = model.table("profile", "what the cam is to be, about its axis at (0, 0)", |t| {
            let table = profile::read_table(t);
            if t.is_described() || table.is_none() {
                return profile::read_chain(t);
            }
            for key in ["start", "segments"].into_iter().filter(|key| t.has(key)) {
                t.problem(key, format!("`{key}` and `table` both draw the profile"), "keep one of them");
            }
            table.flatten()
        });
        let wheel_radius = model.table("wheel", "the grinding wheel", |t| {
            t.quantity("radius", LENGTH, "its radius, for which the programme is made").within(0.0, 100.0).required()
        });
        let cut = model.optional_table("cut", "what is ground", |t| {
            let stock =
                t.quantity("stock", MICRO, "thickness of the layer that a turn takes off").positive().optional();
            let about =
                "normal force per removal rate, which grinding-deflection needs; for the whole width of the cam";
            (stock, t.quantity("force_per_rate", FORCE_PER_RATE, about).estimated(CUTTING_FORCE).positive().optional())
        });
        let (stock, force_per_rate) = cut.unwrap_or_default();
        let points = model.optional_table("measurement", "where the cam is predicted", |t| {
            t.count("points", "points in each block").between(1, 1000).optional()
        });
        let (speed, programmed) = model.table("program", "how the cam is programmed", |t| {
            let speed = Speed::read(t);
            let division = Division::read(t, speed.map(|s| s.pace));
            let (Some(drawn), Some(division), Some(run)) = (&drawn, division, speed) else { return (speed, None) };
            let own: Vec<Option<usize>> = drawn.segments.iter().map(|s| s.blocks).collect();
            let is_possible = division.check(t, &drawn.profile, &own, wheel_radius);
            let program = || Program::new(&drawn.profile, wheel_radius, &division, &own, &run);
            (speed, is_possible.then(|| (division, program())))
        });
        let before = model.optional_table("before", "the pass before, if its programme was another", |t| {
            Before::read(t, drawn.as_ref(), wheel_radius, speed, stock.is_some())
        });
        let allowed = model
            .optional_table("tolerance", "what the cam is held against", |t| Allowed::read(t, &ALLOWED))
            .unwrap_or_default();
        let (division, program) = programmed?;
        let Drawn { profile, segments } = drawn?;
        // So many that each block shows its error, and no more than a picture holds.
        let usual = (7200 / program.blocks()).clamp(2, 10);
        let points = points.flatten().filter(|points| *points > 0).unwrap_or(usual);
        Some(Self {
            profile,
            segments,
            wheel_radius,
            stock,
            force_per_rate,
            division,
            program,
            before: before.flatten(),
            allowed,
            points,
        })
    }

    /// Places of the profile at which the cam is predicted: within each block evenly, m.
    pub fn places(&self) -> Vec<f64> {
        (0..self.program.blocks()).flat_map(|block| self.program.middles(block, self.points)).collect()
    }

    /// The contour through these places, closed.
    pub fn drawn(&self) -> Vec<Spot> {
        let places = self.places();
        let spot = |s: &f64| {
            let place = self.profile.at(*s);
            Spot { at: place.point.into(), outward: place.normal.into(), deviation: 0.0 }
        };
        places.iter().chain(places.first()).map(spot).collect()
    }
}

/// Speed of the grinding point of a wheel of `radius` along the profile at s when its programme runs at
/// its own speed, m/s.
pub fn feed(profile: &Profile, program: &Program, radius: f64, s: f64) -> f64 {
    let block = program.block_at(s);
    let turned = (program.axes.turns[block + 1] - program.axes.turns[block]).abs();
    let mean = turned / program.time(block) / wheel_rate(profile, radius, s);
    let [begin, here] = [program.places[block], s].map(|s| profile.at(s).outside(radius));
    mean * program.courses[block].speed((turn(&begin, &here).abs() / turned).min(1.0))
}
