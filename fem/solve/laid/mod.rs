//! A part that is laid on supports and held by nothing else: how it yields, and which supports it leaves.
//!
//! Supports only press. Where one carries a force Q > 0 the part sinks there by the support's y(Q), from where the
//! support stands; where it carries nothing the part may lift off. All forces on the part balance, and then
//!
//! ```text
//!     w(x) = a + b·x + Σ F·G(x, s)        over loads F and reactions −Q, at s
//! ```
//!
//! is exactly how it yields, be it a beam ([`Bending`]) or a plane body ([`Body`]). The reactions follow from the force method: w =
//! y(Q) at every support that carries, which is one small system however long the part is and of however many pieces or elements.

mod bending;
mod body;
mod carried;
mod faces;
mod flexible;
mod friction;
mod settle;
mod spot;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
mod tests;

pub use bending::Bending;
pub use body::{Body, Unit};
pub use faces::{FaceError, Faces, Level, LevelSide};
pub use flexible::Flexible;
pub use settle::settle;
pub use spot::{Face, Spot, Way};

use std::sync::Arc;

use nalgebra::DMatrix;

use super::JointsError;
use crate::joint::Joint;
use crate::solve::elastic::ElasticError;

/// A support under the part.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// Where it carries.
    pub spot: Spot,
    /// How far it stands below its place, m; below zero where it stands high.
    pub lowered: f64,
    /// The law by which it yields.
    pub joint: Joint,
    /// Coefficient of friction on it; 0 where the part slides freely, as a beam does.
    pub friction: f64,
}

/// What supports stand on.
pub trait Ground {
    /// How far every support sinks with it under these forces on all of them, N.
    ///
    /// # Errors
    /// It is in no equilibrium.
    fn sunk(&self, forces: &[f64]) -> Result<Sunk, JointsError>;
}

/// Ground that has given way.
#[derive(Clone, Debug, PartialEq)]
pub struct Sunk {
    /// How far every support sinks, m.
    pub by: Vec<f64>,
    /// How much more per newton more on each of them, m/N; symmetric. (supports, supports)
    pub rates: DMatrix<f64>,
}

/// The supports under the part, two or more at different places, and what they stand on.
#[derive(Clone, Copy)]
pub struct Supports<'a> {
    /// All of them.
    pub all: &'a [Support],
    /// The ground; `None` where it stands firm.
    pub ground: Option<&'a dyn Ground>,
}

impl<'a> Supports<'a> {
    /// On firm ground.
    pub fn firm(all: &'a [Support]) -> Self {
        Self { all, ground: None }
    }

    /// How far every support stands below its place with these forces on all of them (N), m.
    fn stand(&self, forces: &[f64]) -> Result<Vec<f64>, LaidError> {
        let mut stand: Vec<f64> = self.all.iter().map(|support| support.lowered).collect();
        if let Some(ground) = self.ground {
            let sunk = ground.sunk(forces).map_err(LaidError::Ground)?;
            stand.iter_mut().zip(sunk.by).for_each(|(stand, sunk)| *stand += sunk);
        }
        Ok(stand)
    }
}

/// A force that presses the part down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Where it presses.
    pub spot: Spot,
    /// Force, N; zero or more.
    pub force: f64,
}

/// The reaction of a support.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// Force Q, N; zero where the part has lifted off.
    pub force: f64,
    /// Displacement of the part there from where the support stands, m: what it sinks by, or, below zero, how far the
    /// part has lifted off.
    pub displacement: f64,
    /// Friction on the part along it, N.
    pub friction: f64,
}

/// The part found no place to lie.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LaidError {
    /// The loads press outside the supports.
    #[error("the part tips: what presses on it acts at x = {:.3} mm as a whole, and the supports reach from {:.3} to {:.3} mm", 1e3 * at, 1e3 * from, 1e3 * to)]
    Tips {
        /// Place of the resultant, m.
        at: f64,
        /// Place of the first support, m.
        from: f64,
        /// Place of the last support, m.
        to: f64,
    },
    /// It stands on one support and may lean on either of its neighbours.
    #[error("the part rocks: all that presses on it acts above the support at {:.3} mm, and none beside that carries", 1e3 * at)]
    Rocks {
        /// Place of the support, m.
        at: f64,
    },
    /// Newton's method or the choice of supports did not come to an end.
    #[error("no equilibrium of the part on its supports under {load} N")]
    NoEquilibrium {
        /// Sum of the loads, N.
        load: f64,
    },
    /// The joints of what it stands on found none.
    #[error(transparent)]
    Ground(JointsError),
}

/// A part at rest on its supports.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    part: Arc<Flexible>,
    /// Loads, reactions with a minus sign, and friction on the part, N.
    forces: Vec<(Spot, f64)>,
    /// Rigid part of the displacement, a + b·x.
    rigid: (f64, f64),
    /// Reactions in the order of the supports.
    pub reactions: Vec<Reaction>,
}

impl Settled {
    /// Forces of all supports, N.
    pub fn carried(&self) -> Vec<f64> {
        self.reactions.iter().map(|reaction| reaction.force).collect()
    }

    /// w of the top at x, m, downwards.
    pub fn deflection(&self, x: f64) -> f64 {
        self.deflection_at(&Spot::point(Face::Top, x))
    }

    /// w at a spot, m, downwards.
    pub(crate) fn deflection_at(&self, spot: &Spot) -> f64 {
        self.rigid.0 + self.rigid.1 * spot.at + self.part.deflection(spot, &self.forces)
    }

    /// How a beam is bent; none of a plane body.
    pub fn bent(&self) -> Option<Bent<'_>> {
        match &*self.part {
            Flexible::Beam(bending) => Some(Bent { settled: self, bending }),
            Flexible::Body(_) => None,
        }
    }

    /// The plane body; none of a beam.
    pub fn body(&self) -> Option<&Body> {
        match &*self.part {
            Flexible::Beam(_) => None,
            Flexible::Body(body) => Some(body),
        }
    }

    /// Displacement (x, y) of the nodes of its body, y upwards, m.
    ///
    /// # Errors
    /// The equations cannot be solved.
    pub fn displaced(&self, body: &Body) -> Result<Vec<[f64; 2]>, ElasticError> {
        body.displaced(&self.forces, self.rigid)
    }
}

/// How a beam is bent.
#[derive(Clone, Copy, Debug)]
pub struct Bent<'a> {
    settled: &'a Settled,
    bending: &'a Bending,
}

impl Bent<'_> {
    /// How far the section at x turns, rad: dw/dx but for what shear adds.
    pub fn slope(&self, x: f64) -> f64 {
        let turned = self.settled.forces.iter().map(|(s, f)| f * self.bending.turned(x, s.at));
        self.settled.rigid.1 + turned.sum::<f64>()
    }

    /// EI·w'' at x, N m: above zero where the beam hollows upwards, as over a support.
    pub fn moment(&self, x: f64) -> f64 {
        self.settled.forces.iter().map(|(s, f)| 0.5 * f * (x - s.at).abs()).sum()
    }
}
