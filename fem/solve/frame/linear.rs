//! Linear frames: factor once, then any number of load cases.

use super::builder::Frame;
use super::error::SolveError;
use super::solution::Solution;
use super::system::{System, Tangent};

/// A frame without joints, its stiffness in factored form.
pub struct FactoredFrame<'f> {
    system: System<'f>,
    tangent: Tangent,
}

impl<'f> FactoredFrame<'f> {
    pub(super) fn new(frame: &'f Frame) -> Result<Self, SolveError> {
        if !frame.is_linear() {
            return Err(SolveError::Nonlinear);
        }
        let system = System::new(frame)?;
        let tangent = system.tangent(Vec::new())?;
        Ok(Self { system, tangent })
    }

    /// Solves K u = f for `loads` (node, force in N), several on a node adding, and refines u until the
    /// unbalanced force is below 1e-10 of the load and the last change of u below 1e-12 of u.
    ///
    /// # Errors
    /// A wrong load, or [`SolveError::NotConverged`] where the factor is too inexact to refine.
    pub fn solve(&self, loads: &[(usize, f64)]) -> Result<Solution, SolveError> {
        let loads = self.system.frame().load_vector(loads)?;
        let (motion, convergence) = self.system.solve(&self.tangent, &loads)?;
        Ok(self.system.solution(&motion, &loads, &[], convergence))
    }
}

impl Frame {
    /// Factors the stiffness once for many load cases.
    ///
    /// # Errors
    /// [`SolveError::Loose`], [`SolveError::Nonlinear`], [`SolveError::NotPositiveDefinite`],
    /// [`SolveError::OutOfMemory`].
    pub fn factor(&self) -> Result<FactoredFrame<'_>, SolveError> {
        FactoredFrame::new(self)
    }
}
