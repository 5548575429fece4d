//! Temperature along a rod over time: sources at points, loss to the surroundings from the surface and
//! through the base, lengths that lose to surroundings of their own, joints that resist.
//!
//! ```text
//!   ρcA θ_t = (kA θ_x)_x − h p (θ − a(t)) + Σ Q δ(x − x_Q)
//!   kA θ_x = G (θ − a(t)) at x = 0,    kA θ_x = g [θ] at a joint
//! ```
//! θ is the rise over the temperature that all had at the start, a that of the surroundings. Linear elements
//! with a node at every source, joint and change of section; the capacity is the mean of the lumped and the
//! consistent one, which follows slow waves to fourth order (Goudreau and Taylor 1973), so that only what
//! sources switch is second order. Every step solves a tridiagonal system.
//!
//! A source may warm a heater first, which has a heat capacity of its own and passes heat on through its
//! contact: C_H θ_H' = P − G_H (θ_H − θ), Q = G_H (θ_H − θ).

mod contour;
mod lanes;
mod laws;
mod read;
mod response;
mod run;
mod system;
#[cfg(test)]
mod tests;
mod track;
mod transfer;
mod tridiagonal;

pub use read::{Known, Sensor};
pub use run::Stepping;
pub use system::RodSystem;
pub use track::{Probe, Track, lagged};

use std::fmt;

pub use super::conduction::{Energy, History, Power, Pulse, Scheme, Swing};
pub use super::heat::RodPiece;

/// A section across which heat flows as g times the difference of the temperatures on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Distance from the base, m.
    pub at: f64,
    /// Conductance g, W/K; above zero.
    pub conductance: f64,
}

/// A source of heat.
#[derive(Clone, Debug)]
pub struct PointSource {
    /// Distance from the base, m.
    pub at: f64,
    /// Power over time, W.
    pub power: Power,
    /// The heater that it warms first; `None` where the heat comes into the rod at once.
    pub heater: Option<Heater>,
}

/// A heater between a source and the rod, at one temperature, which loses heat to the rod alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heater {
    /// Heat capacity, J/K; above zero.
    pub heat_capacity: f64,
    /// Conductance from the heater to the rod, W/K; above zero.
    pub contact: f64,
}

impl Heater {
    /// The same heater with a contact that lets it be late by a microsecond at least: all of its heat comes through
    /// whatever the contact, nobody sees so short a time, and faster ones would drown the rates of the rod in
    /// round-off.
    fn no_faster_than_seen(self) -> Self {
        /// Shortest C/G, s.
        const SHORTEST: f64 = 1e-6;
        Self { contact: self.contact.min(self.heat_capacity / SHORTEST), ..self }
    }
}

/// A length of a surface that loses heat to surroundings of its own, beside what the pieces lose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Film {
    /// Where it begins and ends, m from the base.
    pub ends: [f64; 2],
    /// Loss per length and difference of temperature, W/(m K); zero or above.
    pub loss: f64,
    /// Number of its surroundings; 0 are those of the pieces.
    pub around: usize,
}

/// A rod from its base at 0 to its free end, which is insulated.
#[derive(Clone, Debug, Default)]
pub struct Rod {
    /// Pieces from the base on.
    pub pieces: Vec<RodPiece>,
    /// Conductance G from the base to its surroundings, W/K; zero or above.
    pub base: f64,
    /// Number of the surroundings of the base; 0 are those of the pieces.
    pub base_around: usize,
    /// Lengths with surroundings of their own, in any order.
    pub films: Vec<Film>,
    /// Joints in any order.
    pub joints: Vec<Joint>,
    /// Sources in any order.
    pub sources: Vec<PointSource>,
}

/// Why a rod cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RodError {
    /// This piece (from 0) is missing or has a value out of range.
    Piece(usize),
    /// A quantity (with its unit) is out of range.
    Value(&'static str, f64),
}

impl fmt::Display for RodError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Piece(index) => write!(f, "piece {index} of the rod is missing or has a value out of range"),
            Self::Value(quantity, value) => write!(f, "{quantity} is {value}"),
        }
    }
}

impl std::error::Error for RodError {}

impl Rod {
    /// Length, m.
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|p| p.length).sum()
    }

    fn check(&self) -> Result<(), RodError> {
        let above = |value: f64| value > 0.0 && value.is_finite();
        let fits = |p: &RodPiece| above(p.length) && above(p.heat_capacity) && above(p.conductance) && p.loss >= 0.0;
        if let Some(piece) = self.pieces.iter().position(|p| !fits(p) || !p.loss.is_finite()) {
            return Err(RodError::Piece(piece));
        }
        if self.pieces.is_empty() {
            return Err(RodError::Piece(0));
        }
        let mut values = vec![("the conductance of the base (W/K)", self.base, self.base >= 0.0)];
        values.extend(
            self.joints.iter().map(|j| ("the conductance of a joint (W/K)", j.conductance, j.conductance > 0.0)),
        );
        let inside = |at: f64| (0.0..=self.length() * (1.0 + 1e-12)).contains(&at);
        values.extend(self.joints.iter().map(|j| ("the place of a joint (m)", j.at, inside(j.at))));
        values.extend(self.sources.iter().map(|s| ("the place of a source (m)", s.at, inside(s.at))));
        values.extend(self.films.iter().flat_map(|f| f.ends).map(|at| ("an end of a film (m)", at, inside(at))));
        values.extend(self.films.iter().map(|f| ("the loss of a film (W/m/K)", f.loss, f.loss >= 0.0)));
        let infinite = self.sources.iter().filter_map(|s| s.power.infinite());
        values.extend(infinite.map(|power| ("the power of a source (W)", power, false)));
        for heater in self.sources.iter().filter_map(|s| s.heater) {
            values.push(("the heat capacity of a heater (J/K)", heater.heat_capacity, heater.heat_capacity > 0.0));
            values.push(("the conductance of a heater (W/K)", heater.contact, heater.contact > 0.0));
        }
        match values.into_iter().find(|(_, value, fits)| !fits || !value.is_finite()) {
            Some((quantity, value, _)) => Err(RodError::Value(quantity, value)),
            None => Ok(()),
        }
    }
}
