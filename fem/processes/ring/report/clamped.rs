//! A ring under its jaws, as far as a picture shows it.

use super::super::jaws::Jaw;
use super::super::machine::Machine;
use crate::element::plane::STRAINS;
use crate::process::{Failure, Grid, Skin};

/// The cells of a ring, its two states, its surface, and the nodes of the surface that is cut.
pub type Solved = (Grid, [Clamped; 2], Skin, Vec<u32>);

/// The ring under jaws.
pub struct Clamped {
    /// Their shares are their forces, N.
    pub jaws: Vec<Jaw>,
    /// Displacements, m. (nodes, 3)
    pub displacements: Vec<[f64; 3]>,
    /// (σxx, σyy, σxy) at the nodes, Pa; zero where they are not known.
    pub stresses: Vec<[f64; STRAINS]>,
}

/// The ring at standstill and while the chuck turns, by what `clamped` makes of its jaws.
///
/// # Errors
/// The jaws cannot hold the ring, or it cannot be computed.
pub fn states(
    machine: &Machine,
    clamped: impl Fn(Vec<Jaw>) -> Result<Clamped, Failure>,
) -> Result<[Clamped; 2], Failure> {
    let setup = &machine.setup;
    let standing = clamped(machine.pressing(|part| part * setup.jaw_force)?)?;
    let turning = clamped(machine.pressing(|part| machine.force_at(part * setup.jaw_force, setup.speed()))?)?;
    Ok([standing, turning])
}
