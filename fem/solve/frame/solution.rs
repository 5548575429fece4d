//! The result of a solve.

use std::fmt;

use super::support::SupportKind;

/// Figures of the iteration's convergence. All are relative and without unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Convergence {
    /// Newton steps, or for a linear frame the solve and its refinements.
    pub iterations: usize,
    /// Largest unbalanced force at a free degree of freedom over the largest load ‖f − Ku − ΣQ‖/‖f‖
    /// (unbalanced moments are divided by the length of the shaft).
    pub force_residual: f64,
    /// Last change of the displacements over their size (rotations times the length of the shaft). Of a
    /// converged frame with joints it may exceed 1e-12 by what a force change of 1e-12 of the load explains,
    /// see below.
    pub increment: f64,
    /// Largest distance |w − y(Q)| of a joint from its law over the size of the displacements, less what a
    /// force change of 1e-12 of the load explains (at Q = 0 a joint y = cQⁿ is infinitely soft). 0 without
    /// joints.
    pub joint_misfit: f64,
}

impl Convergence {
    /// The state before the first step: nothing is known.
    pub(super) const START: Self =
        Self { iterations: 0, force_residual: f64::INFINITY, increment: f64::INFINITY, joint_misfit: f64::INFINITY };
}

impl fmt::Display for Convergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} iterations, unbalanced force {:.1e} of the load, last displacement change {:.1e}, joint misfit {:.1e}",
            self.iterations, self.force_residual, self.increment, self.joint_misfit
        )
    }
}

/// The reaction of one support.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// The node it stands at.
    pub node: usize,
    /// Kind of the support.
    pub support: SupportKind,
    /// The force (N) or moment (N m) **of the shaft on the support**, positive the way of positive w or θ: a
    /// tool force pushing the shaft against a support gives a positive reaction there, and all translational
    /// reactions add up to the loads. The support pushes back on the shaft with the opposite sign.
    pub value: f64,
}

impl Reaction {
    /// Whether this is a joint that would have to pull the shaft back: contact cannot.
    pub fn pulls(&self) -> bool {
        self.support == SupportKind::Joint && self.value < 0.0
    }
}

/// A solved load case.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Displacement w of every node (m), positive the way the tool force pushes.
    pub displacement: Vec<f64>,
    /// Turn θ of the cross-section at every node (rad), positive where w grows with x.
    pub rotation: Vec<f64>,
    /// Reactions of the supports, in the order in which those were added to the frame.
    pub reactions: Vec<Reaction>,
    /// Convergence of the iteration.
    pub convergence: Convergence,
}
