//! What bends: a beam, or a plane body.

use nalgebra::DMatrix;

use super::{Bending, Body, Spot};

/// A part as far as it yields to vertical forces that balance.
#[derive(Clone, Debug, PartialEq)]
pub enum Flexible {
    /// A beam, whose faces move alike.
    Beam(Bending),
    /// A plane body.
    Body(Body),
}

impl Flexible {
    /// w at a spot under forces (N, downwards), but for a rigid motion, m.
    pub(super) fn deflection(&self, spot: &Spot, forces: &[(Spot, f64)]) -> f64 {
        match self {
            Self::Beam(bending) => forces.iter().map(|(s, f)| f * bending.influence(spot.at, s.at)).sum(),
            Self::Body(body) => body.deflection(spot, forces),
        }
    }

    /// G between spots, m/N, symmetric. (spots, spots)
    pub(super) fn influence(&self, spots: &[Spot]) -> DMatrix<f64> {
        match self {
            Self::Beam(bending) => {
                DMatrix::from_fn(spots.len(), spots.len(), |i, j| bending.influence(spots[i].at, spots[j].at))
            }
            Self::Body(body) => body.influence(spots),
        }
    }
}
