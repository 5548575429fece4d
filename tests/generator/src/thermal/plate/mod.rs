//! Heated plates: rectangles whose edges are heated, cooled, held and covered, as one body with all its losses.

pub mod course;
pub mod direction;
pub mod scenes;
pub mod series;
pub mod strip;
pub mod writing;

use std::f64::consts::TAU;

use course::Piece;
use series::{HOLDS, Place, Reading, Side, rises};
use strip::Strip;

use super::catalogue::LAWS;
use super::job::{self, Row, Seen};
use crate::job::{NoiseKind, Shown};
use crate::law::{self, Cause, Law, value};
use crate::random::{Random, figures};

/// What holds on an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Condition {
    /// kW/m², on from, to (min), and whether it keeps the air off.
    Flux(f64, f64, f64, bool),
    /// A strip of flux: kW/m², its middle at the start (mm), mm/min, width (mm).
    Strip(f64, f64, f64, f64),
    /// W/m²/K, and what is beyond it (degC), the room where there is none.
    Film(f64, Option<f64>),
    /// degC.
    Held(f64),
}

/// A plate with its measuring design.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// Length, height and width, mm.
    pub size: [f64; 3],
    /// On the edges; several may act on one.
    pub edges: Vec<(Side, Condition)>,
    /// (x mm, W, on from, to min).
    pub source: Option<(f64, f64, f64, f64)>,
    /// Of the surroundings without drift, degC.
    pub ambient: f64,
    /// Of the plate at the start where it is not that, degC.
    pub start: Option<f64>,
    /// min.
    pub end: f64,
    /// (x, y), mm.
    pub sensors: Vec<(f64, f64)>,
    /// Measured rows, by time.
    pub rows: Vec<Row>,
    /// Longest step (s) and element (mm) of the model.
    pub fine: (f64, f64),
    /// Where the noise is to be learnt from.
    pub noise: NoiseKind,
    /// What the model shows.
    pub shown: Vec<Shown>,
}

const SIDES: [Side; 4] = [Side::Left, Side::Right, Side::Bottom, Side::Top];

impl crate::job::Job for Job {
    crate::job::of_fields!("thermal");

    fn scales(&self) -> Vec<f64> {
        job::by_row(self.rows.iter().map(|row| row.seen), 0.05, 1.0)
    }

    fn si(&self) -> Vec<f64> {
        job::by_row(self.rows.iter().map(|row| row.seen), 1.0, 1e-6)
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.1, 6.0)
    }

    fn admits(&self, effect: &str, causes: &[Cause]) -> bool {
        let beside = |effect: &str| causes.iter().any(|cause| cause.effect == effect);
        let holds = |side| self.on(side).any(|condition| matches!(condition, Condition::Held(_)));
        match effect {
            // Of rods: a heater sits at a point, and a joint cuts through the section.
            "heater-capacity" | "contact-resistance" => false,
            // What is held at a temperature is so whatever the base takes.
            "base-conductance" => !holds(Side::Left),
            "ambient-drift" => {
                let open = |(_, condition): &(Side, Condition)| matches!(condition, Condition::Film(_, None));
                beside("convection") || beside("base-conductance") && !holds(Side::Left) || self.edges.iter().any(open)
            }
            _ => true,
        }
    }

    fn length(&self) -> f64 {
        self.size[0]
    }

    /// Heat in a section bends the temperatures there sharply, and the program's elements only at their ends: no
    /// sensor stands within an element of it.
    fn draw(&self, effect: &'static str, random: &mut Random) -> Cause {
        let mut drawn = law::draw(LAWS, effect, self.length(), random);
        for (_, at) in drawn.parameters.iter_mut().filter(|(parameter, _)| *parameter == "at") {
            let close = |at: f64| self.sensors.iter().any(|(x, _)| (x - at).abs() < self.fine.1);
            while close(*at) {
                *at = figures(*at + self.fine.1, 5);
            }
        }
        drawn
    }

    fn draws(&self, _effect: &str) -> usize {
        5
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        let plate = self.plate(causes);
        let mut times: Vec<f64> = self.rows.iter().map(|row| 60.0 * row.time).collect();
        times.dedup();
        let points = self.sensors.iter().map(|(x, y)| Reading::Point(1e-3 * x, 1e-3 * y));
        let read: Vec<Reading> = points.chain([Reading::Mean]).collect();
        let (now, lag) = (rises(&plate, &read, &times, 0.0), value(causes, "sensor-lag", "time_constant"));
        let late = lag.map(|lag| rises(&plate, &read, &times, lag));
        let row = |row: &Row| {
            let i = times.iter().position(|time| (time - 60.0 * row.time).abs() < 1e-6).unwrap_or(0);
            match row.seen {
                Seen::Temperature(sensor) => self.cold() + late.as_ref().unwrap_or(&now)[i][sensor],
                // Stress that nothing outside balances has no mean: the ends part by what the mean rise makes.
                Seen::Elongation => 11.5e-6 * 1e3 * self.size[0] * now[i][self.sensors.len()],
            }
        };
        self.rows.iter().map(row).collect()
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        let (periods, phase) = (random.uniform(5.0, 11.0), random.uniform(0.0, TAU));
        let ripple = |row: &Row| (TAU * periods * row.time / self.end + phase).sin();
        ("ripple in time", self.rows.iter().zip(self.scales()).map(|(row, scale)| scale * ripple(row)).collect())
    }

    fn tables(&self) -> String {
        writing::tables(self)
    }

    fn data(&self, observed: &[f64], sigma: f64) -> String {
        writing::data(self, observed, sigma)
    }
}

impl Job {
    /// Of the plate at the start, degC.
    fn cold(&self) -> f64 {
        self.start.unwrap_or(self.ambient)
    }

    fn on(&self, side: Side) -> impl Iterator<Item = Condition> {
        self.edges.iter().filter(move |(on, _)| *on == side).map(|(_, condition)| *condition)
    }

    fn plate(&self, causes: &[Cause]) -> series::Plate {
        let size = |effect, parameter| value(causes, effect, parameter).unwrap_or(0.0);
        let [length, height, width] = self.size.map(|size| 1e-3 * size);
        let (air, room) = (size("convection", "coefficient"), self.room(causes));
        let faces = 2.0 * air / width;
        let (mut films, mut heat) = ([0.0; 4], vec![(Place::Faces, room.times(faces))]);
        for (film, side) in films.iter_mut().zip(SIDES) {
            // The air is at every edge that has no film of its own, and what holds the body at its base besides.
            let mut bare = true;
            let mut loses = |coefficient: f64, to: Piece| {
                *film += coefficient;
                (Place::Edge(side), to.times(coefficient))
            };
            for condition in self.on(side) {
                bare &= !matches!(condition, Condition::Flux(_, _, _, true) | Condition::Film(..) | Condition::Held(_));
                heat.push(match condition {
                    Condition::Flux(flux, from, to, _) => {
                        (Place::Edge(side), Piece::constant(1e3 * flux, 60.0 * from, 60.0 * to))
                    }
                    Condition::Strip(flux, middle, speed, width) => {
                        let strip = Strip { middle: 1e-3 * middle, speed: 1e-3 / 60.0 * speed, width: 1e-3 * width };
                        (Place::Strip(side, strip), always(1e3 * flux))
                    }
                    Condition::Film(coefficient, beyond) => {
                        loses(coefficient, beyond.map_or(room, |beyond| always(beyond - self.cold())))
                    }
                    Condition::Held(at) => loses(HOLDS, always(at - self.cold())),
                });
            }
            let base = size("base-conductance", "conductance") / (height * width);
            let more = if side == Side::Left { base } else { 0.0 } + if bare { air } else { 0.0 };
            heat.push(loses(more, room));
        }
        let mut section =
            |at: f64, power: Piece| heat.push((Place::Section(1e-3 * at), power.times(1.0 / (height * width))));
        if let Some((at, power, from, to)) = self.source {
            section(at, Piece::constant(power, 60.0 * from, 60.0 * to));
        }
        if let Some(at) = value(causes, "extra-source", "at") {
            section(at, always(size("extra-source", "power")));
        }
        heat.retain(|(_, course)| !course.is_nothing());
        series::Plate { size: [length, height], conductivity: 50.0, capacity: 7850.0 * 470.0, films, faces, heat }
    }

    /// What the room is warmer than the plate at the start, K.
    fn room(&self, causes: &[Cause]) -> Piece {
        let size = |parameter| value(causes, "ambient-drift", parameter);
        let apart = self.ambient - self.cold();
        let (Some(amplitude), Some(period), Some(phase)) = (size("amplitude"), size("period"), size("phase")) else {
            return always(apart);
        };
        // A sin(ωt + φ) − A sin φ.
        let (sine, cosine) = phase.to_radians().sin_cos();
        Piece {
            constant: apart - amplitude * sine,
            cosine: amplitude * sine,
            sine: amplitude * cosine,
            frequency: TAU / (3600.0 * period),
            ..always(0.0)
        }
    }
}

fn always(constant: f64) -> Piece {
    Piece::constant(constant, 0.0, f64::INFINITY)
}
