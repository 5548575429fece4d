//! A ring under its jaws, as far as a picture shows it.

use super::super::jaws::Jaw;
use crate::element::plane::STRAINS;
use crate::process::{Grid, Skin};

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
