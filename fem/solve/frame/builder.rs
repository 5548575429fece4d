//! A straight shaft of beam elements with its supports.

use super::error::{FrameError, SolveError};
use super::support::{Direction, Resistance, Support, loose_motion};
use crate::element::BeamPiece;
use crate::joint::Joint;

/// A straight shaft: one beam element a piece, node i at the end of piece i − 1, loads and supports at the
/// nodes.
///
/// w (m) is positive the way the tool force pushes, θ = dw/dx (rad); all quantities SI.
///
/// ```
/// use fem::{element::BeamPiece, joint::{Contact, Joint}, solve::frame::Frame};
/// let piece = BeamPiece { length: 0.3, flexural_rigidity: 26.4e3, shear_rigidity: f64::INFINITY };
/// let shaft = Frame::new(&[piece, piece])?
///     .translational_spring(0, 60e6)?
///     .joint(2, Joint {
///         spring_compliance: 1.0 / 40e6,
///         contacts: vec![Contact { coefficient: 0.2e-6, exponent: 0.5 }],
///     })?;
/// let solution = shaft.solve(&[(1, 500.0)])?;
/// assert!((solution.reactions[1].value - 250.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Frame {
    pieces: Vec<BeamPiece>,
    positions: Vec<f64>,
    supports: Vec<Support>,
}

impl Frame {
    /// A shaft of `pieces` in line from x = 0, without supports.
    pub fn new(pieces: &[BeamPiece]) -> Result<Self, FrameError> {
        if pieces.is_empty() {
            return Err(FrameError::NoPieces);
        }
        for (index, piece) in pieces.iter().enumerate() {
            check_piece(index, piece)?;
        }
        let mut positions = vec![0.0];
        positions.extend(pieces.iter().scan(0.0, |x, piece| {
            *x += piece.length;
            Some(*x)
        }));
        Ok(Self { pieces: pieces.to_vec(), positions, supports: Vec::new() })
    }

    /// A spring of `stiffness` (N/m) against w. Infinite: as [`Frame::fix_translation`]; 0: holds nothing.
    pub fn translational_spring(self, node: usize, stiffness: f64) -> Result<Self, FrameError> {
        self.spring(node, Direction::Translation, stiffness)
    }

    /// A spring of `stiffness` (N m/rad) against θ. Infinite: as [`Frame::fix_rotation`]; 0: holds nothing.
    pub fn rotational_spring(self, node: usize, stiffness: f64) -> Result<Self, FrameError> {
        self.spring(node, Direction::Rotation, stiffness)
    }

    /// Holds w at 0: the unknown is eliminated, its reaction follows from the balance of the node.
    pub fn fix_translation(self, node: usize) -> Result<Self, FrameError> {
        self.support(node, Direction::Translation, Resistance::Fixed)
    }

    /// Holds θ at 0: the unknown is eliminated, its reaction follows from the balance of the node.
    pub fn fix_rotation(self, node: usize) -> Result<Self, FrameError> {
        self.support(node, Direction::Rotation, Resistance::Fixed)
    }

    /// A nonlinear joint against w.
    pub fn joint(self, node: usize, joint: Joint) -> Result<Self, FrameError> {
        self.support(node, Direction::Translation, Resistance::Joint(joint))
    }

    /// Positions x of the nodes (m), from 0.
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// The rigid motion that the supports leave, if any; such a frame is refused by the solvers.
    pub fn loose_motion(&self) -> Option<super::LooseMotion> {
        loose_motion(&self.supports, &self.positions)
    }

    pub(super) fn pieces(&self) -> &[BeamPiece] {
        &self.pieces
    }

    pub(super) fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// Whether no support is a joint.
    pub(super) fn is_linear(&self) -> bool {
        !self.supports.iter().any(|support| matches!(support.resistance, Resistance::Joint(_)))
    }

    /// Length of the shaft (m).
    pub(super) fn length(&self) -> f64 {
        self.positions[self.pieces.len()]
    }

    /// `loads` as one force vector over all degrees of freedom (N; moments 0).
    pub(super) fn load_vector(&self, loads: &[(usize, f64)]) -> Result<Vec<f64>, SolveError> {
        let mut vector = vec![0.0; 2 * self.positions.len()];
        for &(node, force) in loads {
            if node >= self.positions.len() {
                return Err(SolveError::UnknownNode { node, last: self.pieces.len() });
            }
            if !force.is_finite() {
                return Err(SolveError::Load { node, force });
            }
            vector[2 * node] += force;
        }
        Ok(vector)
    }

    fn spring(self, node: usize, direction: Direction, stiffness: f64) -> Result<Self, FrameError> {
        if stiffness.is_nan() || stiffness < 0.0 {
            return Err(FrameError::Spring { node, value: stiffness });
        }
        let resistance = if stiffness.is_infinite() { Resistance::Fixed } else { Resistance::Spring(stiffness) };
        self.support(node, direction, resistance)
    }

    fn support(mut self, node: usize, direction: Direction, resistance: Resistance) -> Result<Self, FrameError> {
        if node >= self.positions.len() {
            return Err(FrameError::UnknownNode { node, last: self.pieces.len() });
        }
        let fixed = |resistance: &Resistance| matches!(resistance, Resistance::Fixed);
        let added = Support { node, direction, resistance };
        let mut beside = self.supports.iter().filter(|other| other.freedom() == added.freedom());
        if beside.any(|other| fixed(&other.resistance) || fixed(&added.resistance)) {
            return Err(FrameError::DoubleSupport { node });
        }
        self.supports.push(added);
        Ok(self)
    }
}

/// Refuses lengths and rigidities that are not positive; only the shear rigidity may be infinite.
fn check_piece(index: usize, piece: &BeamPiece) -> Result<(), FrameError> {
    let quantities = [
        ("length (m)", piece.length, piece.length.is_finite()),
        ("flexural rigidity (N m^2)", piece.flexural_rigidity, piece.flexural_rigidity.is_finite()),
        ("shear rigidity (N)", piece.shear_rigidity, true),
    ];
    for (quantity, value, allowed) in quantities {
        if value.is_nan() || value <= 0.0 || !allowed {
            return Err(FrameError::Piece { piece: index, quantity, value });
        }
    }
    Ok(())
}
