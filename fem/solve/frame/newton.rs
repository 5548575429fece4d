//! Frames with nonlinear joints: Newton's method on displacements u and joint forces Q together.
//!
//! Equations, for joints with laws y(Q) at displacements w (e picks the joint's unknown):
//! ```text
//!   f − F(u) − Σ e Q = 0        balance at every unknown (F: elements and springs, linear)
//!   w − y(Q)         = 0        every joint on its law
//! ```
//! With the law linearised at Q, y(Q + dQ) ≈ y(Q) + dQ/κ, κ = 1/y′(Q), a step condenses to the frame's
//! unknowns,
//! ```text
//!   (K + Σ κ e eᵀ) du = f − F(u) − Σ e Q − Σ e κ (w − y(Q)),        Q + dQ = Q + κ (dw + w − y(Q)),
//! ```
//! symmetric and positive definite. The forces Q + dQ balance, but are off the law; each joint goes back onto
//! its law along its load line, the linear response of the rest of the shaft. That makes the step exact for
//! joints whose force is statically determinate and for a single joint, and passes Q = 0, where a contact y =
//! c Qⁿ has κ = 0, without a singular matrix. The first step takes secants at half the load for tangents.
//!
//! Steps are full at first; where they do not converge the solve starts again, finally with a line search on
//! the distance of the joints from their laws.

use super::builder::Frame;
use super::error::SolveError;
use super::joint_state::JointState;
use super::solution::{Convergence, Solution};
use super::support::{Resistance, Support};
use super::system::{FORCE_TOLERANCE, INCREMENT_TOLERANCE, Motion, System, Tangent, ratio};

/// Control of the Newton steps.
#[derive(Clone, Copy)]
struct Attempt {
    /// Whether a line search shortens the steps.
    searched: bool,
    /// Stiffnesses below this part of a node's own are taken for rounding of the factorisation.
    rounding: f64,
    /// Steps before giving up.
    most: usize,
}

/// Attempts in turn: nearly every frame converges in fewer than ten steps of the first; very light loads on
/// very soft joints need the second, cycles between pressing and pulling the third.
const ATTEMPTS: [Attempt; 3] = [
    Attempt { searched: false, rounding: 1e-14, most: 25 },
    Attempt { searched: false, rounding: 1e-11, most: 25 },
    Attempt { searched: true, rounding: 1e-14, most: 100 },
];

/// A joint's own force tolerance, relative to the load: the joint is on its law if its displacement is that
/// of a force so near. Matters only at Q = 0, where the displacement of y = cQⁿ feels the rounding of Q.
const JOINT_FORCE_TOLERANCE: f64 = 1e-12;

/// Displacements below this part of the first step's count as this part: with all loads on a rigid support
/// the solution is no motion at all, which nothing can be measured against.
const SMALLEST_SIZE: f64 = 1e-6;

struct Newton<'s, 'f> {
    system: &'s System<'f>,
    loads: &'s [f64],
    attempt: Attempt,
    motion: Motion,
    joints: Vec<JointState<'f>>,
    /// Steps done.
    iterations: usize,
    /// Size of the displacements after the first step (m).
    first_size: f64,
}

/// Solves one load case.
pub(super) fn solve(frame: &Frame, loads: &[(usize, f64)]) -> Result<Solution, SolveError> {
    let system = System::new(frame)?;
    let loads = frame.load_vector(loads)?;
    let mut outcome = Err(SolveError::NotConverged(Convergence::START));
    for attempt in ATTEMPTS {
        outcome = Newton::new(&system, &loads, attempt).run();
        if !matches!(outcome, Err(SolveError::NotConverged(_) | SolveError::NotPositiveDefinite { .. })) {
            break;
        }
    }
    outcome
}

impl<'s, 'f> Newton<'s, 'f> {
    /// The unloaded shaft.
    fn new(system: &'s System<'f>, loads: &'s [f64], attempt: Attempt) -> Self {
        let load_size = system.force_size(loads);
        let joint = |support: &'f Support| match &support.resistance {
            Resistance::Joint(law) => {
                let freedom = support.freedom();
                Some(JointState::new(freedom, law, system.own_stiffness(freedom), load_size))
            }
            _ => None,
        };
        let joints = system.frame().supports().iter().filter_map(joint).collect();
        let motion = system.at_rest();
        Self { system, loads, attempt, motion, joints, iterations: 0, first_size: 0.0 }
    }

    fn run(mut self) -> Result<Solution, SolveError> {
        let mut convergence = Convergence::START;
        while self.iterations < self.attempt.most {
            convergence = self.advance()?;
            if self.converged(&convergence) {
                let forces: Vec<f64> = self.joints.iter().map(|joint| joint.force).collect();
                return Ok(self.system.solution(&self.motion, self.loads, &forces, convergence));
            }
        }
        Err(SolveError::NotConverged(convergence))
    }

    /// One Newton step.
    fn advance(&mut self) -> Result<Convergence, SolveError> {
        let stiffnesses = self.stiffnesses();
        let freedoms = self.joints.iter().map(|joint| joint.freedom);
        let tangent = self.system.tangent(freedoms.zip(stiffnesses.iter().copied()).collect())?;
        let gaps: Vec<f64> = self.joints.iter().map(|joint| joint.gap(&self.motion)).collect();
        let mut right_side = self.unbalanced();
        for ((joint, stiffness), gap) in self.joints.iter().zip(&stiffnesses).zip(&gaps) {
            right_side[joint.freedom] -= stiffness * gap;
        }
        let (change, _) = self.system.solve(&tangent, &right_side)?;
        let terms = self.joints.iter().zip(&stiffnesses).zip(&gaps);
        let forces: Vec<f64> =
            terms.map(|((joint, stiffness), gap)| joint.force + stiffness * (change[joint.freedom].0 + gap)).collect();
        // the first step brings the loads on: before it there is no balance to measure a distance from
        let searched = self.attempt.searched && self.iterations > 0;
        let step = if searched { self.step_length(&change, &forces) } else { 1.0 };
        self.system.advance(&mut self.motion, &change, step);
        self.set_forces(&tangent, &stiffnesses, &forces, step)?;
        if self.iterations == 0 {
            self.first_size = self.system.size(&self.motion);
        }
        self.iterations += 1;
        Ok(self.convergence(step * self.system.size(&change)))
    }

    /// κ of every joint (N/m).
    fn stiffnesses(&self) -> Vec<f64> {
        let rounding = self.attempt.rounding;
        let start = self.iterations == 0;
        let stiffness = |joint: &JointState| if start { joint.start(rounding) } else { joint.tangent(rounding) };
        self.joints.iter().map(stiffness).collect()
    }

    /// Moves the balancing forces by `step` toward `forces`, then each joint onto its law along its load
    /// line.
    fn set_forces(
        &mut self,
        tangent: &Tangent,
        stiffnesses: &[f64],
        forces: &[f64],
        step: f64,
    ) -> Result<(), SolveError> {
        for ((joint, &stiffness), force) in self.joints.iter_mut().zip(stiffnesses).zip(forces) {
            let mut unit_force = vec![0.0; self.loads.len()];
            unit_force[joint.freedom] = 1.0;
            let compliance = self.system.solve(tangent, &unit_force)?.0[joint.freedom].0;
            joint.set_rest(compliance, stiffness, self.attempt.rounding);
            joint.balance += step * (force - joint.balance);
            joint.force = joint.meeting_force(self.motion[joint.freedom].0, joint.balance);
        }
        Ok(())
    }

    /// The first of the steps 1, 1/2, 1/4 … that brings the joints nearer to their laws, or the best of
    /// twelve.
    fn step_length(&self, change: &Motion, forces: &[f64]) -> f64 {
        let distance = |step: f64| -> f64 {
            let pairs = self.joints.iter().zip(forces);
            let distances = pairs.map(|(joint, force)| {
                let w = self.motion[joint.freedom].0 + step * change[joint.freedom].0;
                joint.distance(w, joint.balance + step * (force - joint.balance))
            });
            distances.sum()
        };
        let start = distance(0.0);
        if start <= (FORCE_TOLERANCE * self.system.force_size(self.loads)).powi(2) {
            return 1.0;
        }
        let mut best = (f64::INFINITY, 1.0);
        for halvings in 0..12 {
            let step = 0.5_f64.powi(halvings);
            let there = distance(step);
            if there < best.0 {
                best = (there, step);
            }
            if there <= (1.0 - 0.2 * step) * start {
                break;
            }
        }
        best.1
    }

    /// Forces f − F(u) − Σ e Q that elements, springs and joints leave unbalanced (N, N m).
    fn unbalanced(&self) -> Vec<f64> {
        let mut forces = self.system.unbalanced(&self.motion, self.loads);
        for joint in &self.joints {
            forces[joint.freedom] -= joint.force;
        }
        forces
    }

    /// Displacement that increments and misfits are measured against (m).
    fn size(&self) -> f64 {
        self.system.size(&self.motion).max(SMALLEST_SIZE * self.first_size)
    }

    /// Displacements of a joint at forces its own tolerance less and more than the present one (m).
    fn band(&self, joint: &JointState) -> [f64; 2] {
        let slack = JOINT_FORCE_TOLERANCE * self.system.force_size(self.loads);
        [-slack, slack].map(|slack| joint.law.displacement(joint.force + slack))
    }

    /// State of the iteration after displacements changed by `change` (m).
    fn convergence(&self, change: f64) -> Convergence {
        let mut misfit = 0.0_f64;
        for joint in &self.joints {
            let [low, high] = self.band(joint);
            let w = self.motion[joint.freedom].0;
            misfit = misfit.max(low - w).max(w - high);
        }
        Convergence {
            iterations: self.iterations,
            force_residual: ratio(self.system.force_size(&self.unbalanced()), self.system.force_size(self.loads)),
            increment: ratio(change, self.size()),
            joint_misfit: ratio(misfit, self.size()),
        }
    }

    /// Forces balance, every joint is on its law, and the last change of the displacements is negligible:
    /// below the tolerance or what the force tolerance of a joint explains.
    fn converged(&self, convergence: &Convergence) -> bool {
        let width = |joint| {
            let [low, high] = self.band(joint);
            high - low
        };
        let explained = self.joints.iter().map(width).fold(0.0, f64::max);
        convergence.force_residual <= FORCE_TOLERANCE
            && convergence.joint_misfit <= INCREMENT_TOLERANCE
            && convergence.increment <= INCREMENT_TOLERANCE + ratio(explained, self.size())
    }
}

impl Frame {
    /// Solves one load case: `loads` are (node, force in N), several on a node add.
    ///
    /// # Errors
    /// Those of [`Frame::factor`] save `Nonlinear`, a wrong load, or [`SolveError::NotConverged`].
    pub fn solve(&self, loads: &[(usize, f64)]) -> Result<Solution, SolveError> {
        if self.is_linear() { self.factor()?.solve(loads) } else { solve(self, loads) }
    }
}
