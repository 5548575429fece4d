//! Supports of a frame, and whether they hold it.

use crate::joint::Joint;
use std::fmt;

/// Kinds of supports, for people and for [`super::Reaction`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SupportKind {
    /// A linear spring against w; its reaction is a force (N).
    TranslationalSpring,
    /// A linear spring against θ; its reaction is a moment (N m).
    RotationalSpring,
    /// w held at 0; its reaction is a force (N).
    FixedTranslation,
    /// θ held at 0; its reaction is a moment (N m).
    FixedRotation,
    /// A nonlinear joint against w; its reaction is a force (N).
    Joint,
}

/// The resistance of a support.
#[derive(Clone, Debug)]
pub(super) enum Resistance {
    /// Force = stiffness (N/m or N m/rad) × displacement.
    Spring(f64),
    /// The degree of freedom is held at 0.
    Fixed,
    /// Displacement = law(force).
    Joint(Joint),
}

/// The displacement of a node that a support resists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    Translation,
    Rotation,
}

/// One support of the frame.
#[derive(Clone, Debug)]
pub(super) struct Support {
    pub node: usize,
    pub direction: Direction,
    pub resistance: Resistance,
}

impl Support {
    /// Index of the resisted degree of freedom: w of node i at 2i, θ at 2i + 1.
    pub fn freedom(&self) -> usize {
        match self.direction {
            Direction::Translation => 2 * self.node,
            Direction::Rotation => 2 * self.node + 1,
        }
    }

    pub fn kind(&self) -> SupportKind {
        match (&self.resistance, self.direction) {
            (Resistance::Spring(_), Direction::Translation) => SupportKind::TranslationalSpring,
            (Resistance::Spring(_), Direction::Rotation) => SupportKind::RotationalSpring,
            (Resistance::Fixed, Direction::Translation) => SupportKind::FixedTranslation,
            (Resistance::Fixed, Direction::Rotation) => SupportKind::FixedRotation,
            (Resistance::Joint(_), _) => SupportKind::Joint,
        }
    }

    /// A spring of stiffness 0 is there but holds nothing.
    fn holds(&self) -> bool {
        !matches!(self.resistance, Resistance::Spring(stiffness) if stiffness == 0.0)
    }
}

/// A rigid motion that no support resists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LooseMotion {
    /// No support at all.
    TranslationAndRotation,
    /// Nothing resists w.
    Translation,
    /// w is held at one place only and θ nowhere.
    Rotation {
        /// The place about which the shaft turns, x (m) from its first node.
        about: f64,
    },
}

impl fmt::Display for LooseMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LooseMotion::TranslationAndRotation => write!(f, "free to translate and to rotate: it has no support"),
            LooseMotion::Translation => write!(f, "free to translate"),
            // twelve digits hide the rounding of summed lengths
            LooseMotion::Rotation { about } => {
                write!(f, "free to rotate about x = {} m", (about * 1e12).round() / 1e12)
            }
        }
    }
}

/// The motion that `supports` leave to a straight shaft with nodes at `positions` (m), if any.
pub(super) fn loose_motion(supports: &[Support], positions: &[f64]) -> Option<LooseMotion> {
    let in_direction = |direction| supports.iter().filter(move |s| s.direction == direction && s.holds());
    let turning_held = in_direction(Direction::Rotation).next().is_some();
    let mut places = in_direction(Direction::Translation).map(|support| support.node);
    match places.next() {
        None if turning_held => Some(LooseMotion::Translation),
        None => Some(LooseMotion::TranslationAndRotation),
        Some(first) if turning_held || places.any(|place| place != first) => None,
        Some(first) => Some(LooseMotion::Rotation { about: positions[first] }),
    }
}
