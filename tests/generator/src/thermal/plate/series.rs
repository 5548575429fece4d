//! A heated rectangle by products of the waves of its two directions.
//!
//! ρc T_t = k(T_xx + T_yy) − b T + q, −k ∂T/∂n = h T on every edge, all of it linear: what the room and the coolants
//! are warmer than the body at the start comes in as heat b T_a and h T_a. Every wave decays at its own rate
//! λ = (k(μ² + ν²) + b)/ρc and answers to its heat in closed form. A series of these alone converges slowly where
//! heat comes in. Of 1/λ there is therefore summed only what 1/(λ + σ) leaves, and that sum itself is the steady
//! answer of a plate with a stronger loss: closed across, and a single series along.

use super::course::{Answer, Piece};
use super::direction::{Direction, Spread};
use super::strip::Strip;

/// Waves of either direction in the double series, and in the single ones.
const WAVES: usize = 32;
const ALONG: usize = 400;
/// σ, 1/s.
const SHIFT: f64 = 1e-3;
/// A film that holds an edge at the temperature beyond, W/(m² K).
pub const HOLDS: f64 = 1e10;

/// An edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// x = 0.
    Left,
    /// x = length.
    Right,
    /// y = 0.
    Bottom,
    /// y = height.
    Top,
}

/// Where heat comes in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// All along an edge, W/m².
    Edge(Side),
    /// Under a strip on an edge, W/m²; always.
    Strip(Side, Strip),
    /// In the section at x (m), W/m².
    Section(f64),
    /// Everywhere, W/m³.
    Faces,
}

/// What is heated and how. SI units; temperatures are rises over that at the start.
#[derive(Debug, Clone)]
pub struct Plate {
    /// Along x and y, m.
    pub size: [f64; 2],
    /// k, W/(m K).
    pub conductivity: f64,
    /// ρ c, J/(m³ K).
    pub capacity: f64,
    /// h of left, right, bottom and top, W/(m² K).
    pub films: [f64; 4],
    /// b, of both broad faces together, W/(m³ K).
    pub faces: f64,
    /// All heat: where, and how much over time.
    pub heat: Vec<(Place, Piece)>,
}

/// What of a plate is read.
#[derive(Debug, Clone, Copy)]
pub enum Reading {
    /// x, y, m.
    Point(f64, f64),
    /// Of the whole plate.
    Mean,
}

/// Rises of what is read at times (s), all through a lag of so many s.
pub fn rises(plate: &Plate, readings: &[Reading], times: &[f64], lag: f64) -> Vec<Vec<f64>> {
    let [left, right, bottom, top] = plate.films;
    let [x, y] = [(plate.size[0], [left, right]), (plate.size[1], [bottom, top])]
        .map(|(length, films)| Direction::of(length, plate.conductivity, films, ALONG));
    let mut found = vec![vec![0.0; readings.len()]; times.len()];
    for (place, course) in &plate.heat {
        Flow::of(plate, [&x, &y], *place, readings).add(*place, *course, times, lag, &mut found);
    }
    found
}

/// Heat that is a product of something along a direction and something across it.
struct Flow<'a> {
    plate: &'a Plate,
    along: &'a Direction,
    across: &'a Direction,
    /// Where it comes in across.
    enters: Spread,
    /// What is read along and across, and the area over which.
    read: Vec<[Spread; 2]>,
    areas: Vec<f64>,
}

impl<'a> Flow<'a> {
    fn of(plate: &'a Plate, [x, y]: [&'a Direction; 2], place: Place, readings: &[Reading]) -> Self {
        let (lies, enters) = match place {
            Place::Edge(Side::Left) | Place::Strip(Side::Left, _) => (false, Spread::At(0.0)),
            Place::Edge(Side::Right) | Place::Strip(Side::Right, _) => (false, Spread::At(x.length)),
            Place::Edge(Side::Bottom) | Place::Strip(Side::Bottom, _) => (true, Spread::At(0.0)),
            Place::Edge(Side::Top) | Place::Strip(Side::Top, _) => (true, Spread::At(y.length)),
            Place::Section(at) => (false, Spread::At(at)),
            Place::Faces => (false, Spread::Even),
        };
        let (along, across) = if lies { (x, y) } else { (y, x) };
        let (mut read, mut areas) = (Vec::new(), Vec::new());
        for reading in readings {
            let (spreads, area) = match *reading {
                Reading::Point(x, y) if lies => ([x, y].map(Spread::At), 1.0),
                Reading::Point(x, y) => ([y, x].map(Spread::At), 1.0),
                Reading::Mean => ([Spread::Even; 2], x.length * y.length),
            };
            read.push(spreads);
            areas.push(area);
        }
        Self { plate, along, across, enters, read, areas }
    }

    /// Adds to what is found at every time.
    fn add(&self, place: Place, course: Piece, times: &[f64], lag: f64, found: &mut [Vec<f64>]) {
        // Of every wave across: its number, and what it takes up and shows of one.
        let across = self.across.waves[..WAVES].iter().map(|wave| {
            let takes = wave.meets(self.enters, self.across.length) / wave.square;
            let shows = self.read.iter().map(|[_, across]| takes * wave.meets(*across, self.across.length));
            (wave.number, shows.collect())
        });
        let across: Vec<(f64, Vec<f64>)> = across.collect();
        for (number, wave) in self.along.waves.iter().enumerate() {
            let fed = match place {
                Place::Strip(_, strip) => strip.meets(wave, self.along.length),
                _ => vec![course.times(wave.meets(Spread::Even, self.along.length))],
            };
            let flux = if matches!(place, Place::Strip(..)) { course.constant } else { 1.0 };
            let shows = self
                .read
                .iter()
                .zip(&self.areas)
                .map(|([along, _], area)| flux * wave.meets(*along, self.along.length) / (wave.square * area));
            let shows: Vec<f64> = shows.collect();
            let double = if number < WAVES { across.as_slice() } else { &[] };
            let Plate { conductivity, capacity, faces, .. } = *self.plate;
            let loss = conductivity * wave.number * wave.number + faces;
            let gamma = ((loss + capacity * SHIFT) / conductivity).sqrt();
            let steady = self.read.iter().map(|[_, across]| self.across.answer(self.enters, *across, gamma));
            let steady: Vec<f64> = steady.collect();
            for (found, time) in found.iter_mut().zip(times) {
                let answer = Answer::of(&fed, *time, lag);
                let follows = answer.follows();
                let mut sums: Vec<f64> = steady.iter().map(|steady| follows * steady).collect();
                for (number, shows) in double {
                    let rate = (loss + conductivity * number * number) / capacity;
                    let left = (answer.at(rate) - follows / (rate + SHIFT)) / capacity;
                    sums.iter_mut().zip(shows).for_each(|(sum, shows)| *sum += left * shows);
                }
                for ((found, sum), shows) in found.iter_mut().zip(sums).zip(&shows) {
                    *found += shows * sum;
                }
            }
        }
    }
}
