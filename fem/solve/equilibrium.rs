//! The equilibrium of a condensed shaft on its two end joints.
//!
//! With g the influence and S the constraint of the condensed shaft, the joints' forces Q and displacements d
//! = y(Q) obey
//!
//! ```text
//!     Q + S·y(Q) − g·P = q        and the tool sees    C·P + g·d
//! ```
//!
//! with q the forces that supports out of line leave on the joints.
//!
//! Where statics decides, S = 0 and Q = g·P at once. Otherwise Newton's method runs along each joint's path
//! (see [`Rubbing::along`]), on which the contact law has no infinite slope, with a line search on the
//! residual.

use crate::joint::{JointState, Rubbing};

/// Residual at which a state counts as in equilibrium, relative to the forces in play.
const TOLERANCE: f64 = 1e-12;
const MAX_ITERATIONS: usize = 60;

/// Forces and displacements of headstock and tailstock under one tool force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// Q on headstock and tailstock, N; negative where the joint would have to pull.
    pub forces: [f64; 2],
    /// Displacement y of each joint, m.
    pub displacements: [f64; 2],
    /// dy/dP of each, m/N.
    pub displacement_rates: [f64; 2],
    /// Path variable of each joint: a start for the solution under a similar force.
    pub path: [f64; 2],
    /// Newton iterations.
    pub iterations: usize,
}

/// The joints found no equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum JointsError {
    /// Newton's method did not converge.
    #[error("no equilibrium of the joints under {load} N after {iterations} Newton steps: {residual} N are left over")]
    Diverged {
        /// Tool force, N.
        load: f64,
        /// Steps done.
        iterations: usize,
        /// Forces out of balance, N.
        residual: f64,
    },
    /// A seat opens, and nothing else bears what it let go.
    #[error("the seat number {seat} (from 0) opens under {load} N")]
    Open {
        /// The seat.
        seat: usize,
        /// Tool force, N.
        load: f64,
    },
}

/// Solves for the joints under the tool force `load` (N), given influence g, constraint S and the forces q (N) that are
/// there without the tool, from the solution under a similar force if there is one.
///
/// # Errors
/// Newton's method did not converge.
pub fn solve_joints(
    joints: &[Rubbing; 2],
    influence: [f64; 2],
    constraint: &[[f64; 2]; 2],
    (load, bent_forces): (f64, [f64; 2]),
    near: Option<&Equilibrium>,
) -> Result<Equilibrium, JointsError> {
    let target = [influence[0] * load + bent_forces[0], influence[1] * load + bent_forces[1]];
    if *constraint == [[0.0; 2]; 2] {
        return Ok(determinate(joints, influence, target));
    }
    let path = near.map_or_else(
        || {
            let guess = secant_forces(joints, target, constraint);
            [joints[0].path_at(guess[0]), joints[1].path_at(guess[1])]
        },
        |near| near.path,
    );
    let mut state = States::at(joints, path, target, constraint);
    for iterations in 0..MAX_ITERATIONS {
        if state.residual_norm() <= TOLERANCE * state.scale {
            return Ok(state.finish(influence, constraint, iterations));
        }
        let Some(step) = solve2(state.jacobian(constraint), state.residual) else { break };
        match state.search(joints, target, constraint, step) {
            Some(next) => state = next,
            // No shorter step lowers the residual any more: at round-off this is the answer.
            None if state.residual_norm() <= 1e3 * TOLERANCE * state.scale => {
                return Ok(state.finish(influence, constraint, iterations));
            }
            None => return Err(state.failure(load, iterations)),
        }
    }
    Err(state.failure(load, MAX_ITERATIONS))
}

/// Statics alone gives the forces.
fn determinate(joints: &[Rubbing; 2], influence: [f64; 2], forces: [f64; 2]) -> Equilibrium {
    let [(y0, rate0), (y1, rate1)] = [joints[0].yield_under(forces[0]), joints[1].yield_under(forces[1])];
    // A joint without force does not move, however steep its law begins.
    let rate = |g: f64, rate: f64| if g == 0.0 { 0.0 } else { g * rate };
    Equilibrium {
        forces,
        displacements: [y0, y1],
        displacement_rates: [rate(influence[0], rate0), rate(influence[1], rate1)],
        path: [0.0; 2],
        iterations: 0,
    }
}

/// Forces with each joint replaced by its secant at the forces that statics alone would give.
fn secant_forces(joints: &[Rubbing; 2], target: [f64; 2], s: &[[f64; 2]; 2]) -> [f64; 2] {
    let y = [0, 1].map(|i: usize| joints[i].secant(target[i]));
    let matrix = [[1.0 + s[0][0] * y[0], s[0][1] * y[1]], [s[1][0] * y[0], 1.0 + s[1][1] * y[1]]];
    solve2(matrix, target).unwrap_or(target)
}

struct States {
    path: [f64; 2],
    joints: [JointState; 2],
    residual: [f64; 2],
    /// Size of the forces that are in balance, N.
    scale: f64,
}

impl States {
    fn at(joints: &[Rubbing; 2], path: [f64; 2], target: [f64; 2], s: &[[f64; 2]; 2]) -> Self {
        let states = [joints[0].along(path[0]), joints[1].along(path[1])];
        let [y0, y1] = [states[0].displacement, states[1].displacement];
        let balance = |i: usize| states[i].force + s[i][0] * y0 + s[i][1] * y1 - target[i];
        let size = |i: usize| states[i].force.abs() + (s[i][0] * y0).abs() + (s[i][1] * y1).abs() + target[i].abs();
        Self { path, joints: states, residual: [balance(0), balance(1)], scale: size(0).max(size(1)) }
    }

    fn residual_norm(&self) -> f64 {
        self.residual[0].abs().max(self.residual[1].abs())
    }

    fn jacobian(&self, s: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
        let rates = |j: &JointState| (j.force_rate, j.displacement_rate);
        let [(q0, y0), (q1, y1)] = [rates(&self.joints[0]), rates(&self.joints[1])];
        let mut jacobian = [[q0 + s[0][0] * y0, s[0][1] * y1], [s[1][0] * y0, q1 + s[1][1] * y1]];
        for (i, row) in jacobian.iter_mut().enumerate() {
            // Nothing can load this joint, as where there is no tailstock: it stays unloaded.
            if *row == [0.0; 2] {
                row[i] = 1.0;
            }
        }
        jacobian
    }

    /// The first of ever shorter steps that lowers the residual.
    fn search(&self, joints: &[Rubbing; 2], target: [f64; 2], s: &[[f64; 2]; 2], step: [f64; 2]) -> Option<Self> {
        let mut length = 1.0;
        for _ in 0..40 {
            let path = [self.path[0] - length * step[0], self.path[1] - length * step[1]];
            let next = Self::at(joints, path, target, s);
            if next.residual_norm() < (1.0 - 1e-4 * length) * self.residual_norm() {
                return Some(next);
            }
            length *= 0.5;
        }
        None
    }

    fn finish(&self, influence: [f64; 2], s: &[[f64; 2]; 2], iterations: usize) -> Equilibrium {
        let [a, b] = &self.joints;
        let path_rates = solve2(self.jacobian(s), influence).unwrap_or([0.0; 2]);
        Equilibrium {
            forces: [a.force, b.force],
            displacements: [a.displacement, b.displacement],
            displacement_rates: [a.displacement_rate * path_rates[0], b.displacement_rate * path_rates[1]],
            path: self.path,
            iterations,
        }
    }

    fn failure(&self, load: f64, iterations: usize) -> JointsError {
        JointsError::Diverged { load, iterations, residual: self.residual_norm() }
    }
}

fn solve2(m: [[f64; 2]; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    let det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let x = [(b[0] * m[1][1] - b[1] * m[0][1]) / det, (m[0][0] * b[1] - m[1][0] * b[0]) / det];
    (x[0].is_finite() && x[1].is_finite()).then_some(x)
}
