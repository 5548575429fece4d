//! Losses of a surface that are not in proportion to its temperature, or whose film changes with time.
//!
//! They act on the nodes of the sides, each for its share of the surface, ∫ Nₐ t dl: of sides of second order that is Simpson's rule. A
//! stage finds the rates under them by Newton's steps with a factor that is kept as long as it serves.

use super::conditions::{Loss, side_shares};
use super::{Condition, History, ThermalError};
use crate::element::plane::Thickness;
use crate::mesh::Mesh;

/// Stefan–Boltzmann constant, W/(m² K⁴) (CODATA 2018).
pub const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// A surface with its loss.
pub(super) struct Surface {
    /// Each node with its share, m².
    shares: Vec<(usize, f64)>,
    loss: Loss,
    ambient: History,
}

impl Surface {
    /// Those of the conditions.
    pub fn of(mesh: &Mesh, thickness: Thickness, conditions: &[Condition]) -> Result<Vec<Self>, ThermalError> {
        let mut all = Vec::new();
        for condition in conditions {
            let Condition::Surface { sides, loss, ambient } = condition else { continue };
            if let Loss::Radiation { emissivity, zero } = loss {
                ThermalError::check((0.0..=1.0).contains(emissivity), "emissivity", "from 0 to 1", *emissivity)?;
                ThermalError::check(*zero > 0.0, "absolute temperature (K)", "above zero", *zero)?;
            }
            let shares = side_shares(mesh, mesh.sides(sides)?, thickness, 1.0);
            all.push(Self { shares, loss: loss.clone(), ambient: ambient.clone() });
        }
        Ok(all)
    }

    /// Whether it can hold the temperature of a node.
    pub fn holds(&self) -> impl Iterator<Item = usize> + '_ {
        self.shares.iter().map(|(node, _)| *node)
    }

    /// Gives each node with the heat that it loses (W) at its temperature, and what a kelvin adds to that (W/K), at `time` of a step.
    pub fn lose(
        &self,
        (time, step): (f64, [f64; 2]),
        temperature: impl Fn(usize) -> f64,
        mut give: impl FnMut(usize, f64, f64),
    ) {
        let ambient = self.ambient.within(time, step);
        match &self.loss {
            Loss::Film(history) => {
                let film = history.within(time, step);
                for &(node, share) in &self.shares {
                    give(node, share * film * (temperature(node) - ambient), share * film);
                }
            }
            Loss::Radiation { emissivity, zero } => {
                let factor = emissivity * STEFAN_BOLTZMANN;
                let around = (zero + ambient).powi(4);
                for &(node, share) in &self.shares {
                    let own = zero + temperature(node);
                    let (flux, slope) = (factor * (own.powi(4) - around), 4.0 * factor * own.powi(3));
                    give(node, share * flux, share * slope);
                }
            }
        }
    }
}
