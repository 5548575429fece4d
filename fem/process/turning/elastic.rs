//! The deflection under the tool: shaft, supports, carriage and force in one equilibrium.

use super::cut::Conditions;
use super::machine::Machine;
use super::setup::Setup;
use crate::joint::Joint;
use crate::solve::{Condensed, Equilibrium, JointsError, solve_joints};

/// The equilibrium at one tool position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deflection {
    /// Radial force that really acts, N.
    pub force: f64,
    /// Forces and displacements of headstock and tailstock.
    pub supports: Equilibrium,
    /// The shaft's own bending under the tool, m.
    pub shaft: f64,
    /// Tool, slide and holder, m.
    pub carriage: f64,
    /// The whole gap y between tool and work, m.
    pub total: f64,
    /// dy/dP, m/N.
    pub rate: f64,
    /// The diameter error that the tool meets, m, where the cut follows it; infinite where it does not.
    pub met: f64,
}

impl Deflection {
    /// The diameter error that is left, m, with what else moves the tool on the diameter (m): twice the gap and that,
    /// but no more than there was, which the tool does not reach.
    pub fn error(&self, shift: f64) -> f64 {
        (2.0 * self.total + shift).min(self.met)
    }
}

/// The elastic part of a machine: what a deflection depends on.
pub struct Elastic<'a> {
    shaft: &'a Condensed,
    joints: [Joint; 2],
    carriage: &'a Joint,
    feedback: Option<f64>,
    setup: &'a Setup,
}

impl<'a> Elastic<'a> {
    /// A machine on a shaft condensed to the positions of interest.
    pub fn new(machine: &'a Machine, shaft: &'a Condensed) -> Self {
        let joints = [machine.headstock.clone(), machine.tailstock.clone()];
        Self { shaft, joints, carriage: &machine.carriage, feedback: machine.feedback, setup: &machine.setup }
    }

    /// The diameter error (m) that the passes before the last leave at x with the tool there, at position
    /// number `i`, at an angle (rad) around the part or on the mean: where the force is fed back each copies what it
    /// meets.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn before(&self, i: usize, x: f64, angle: Option<f64>) -> Result<f64, JointsError> {
        if self.feedback.is_none_or(|exponent| exponent == 0.0) {
            return Ok(0.0);
        }
        let blank = &self.setup.blank;
        // Half of a diameter is what the tool meets at one angle.
        let around = angle.map_or(0.0, |angle| 2.0 * blank.around(angle));
        let blank = blank.error(x, self.setup.length()) + around;
        self.setup.passes.iter().try_fold(blank, |error, pass| Ok(self.pass(i, pass.conditions(x, error))?.1))
    }

    /// Force (N) of a pass, and the diameter error (m) that it leaves: twice the gap, or all that it does
    /// not reach.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn pass(&self, i: usize, at: Conditions) -> Result<(f64, f64), JointsError> {
        let deflection = self.deflect(i, at)?;
        Ok((deflection.force, deflection.error(0.0)))
    }

    /// The equilibrium with the tool at position number `i`.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn deflect(&self, i: usize, at: Conditions) -> Result<Deflection, JointsError> {
        match self.feedback {
            Some(exponent) if exponent != 0.0 => {
                Ok(Deflection { met: 2.0 * at.set_depth, ..self.fed_back(i, at, exponent)? })
            }
            _ => self.under(i, at.force, None),
        }
    }

    /// The equilibrium under a given force, from that under a similar one if there is one.
    fn under(&self, i: usize, force: f64, near: Option<&Deflection>) -> Result<Deflection, JointsError> {
        let influence = self.shaft.influence[i];
        let near = near.map(|d| &d.supports);
        let supports = solve_joints(&self.joints, influence, &self.shaft.constraint, force, near)?;
        let shaft = self.shaft.compliance[i] * force;
        let (carriage, carriage_rate) = self.carriage.yield_under(force);
        let [d, rates] = [supports.displacements, supports.displacement_rates];
        let total = shaft + influence[0] * d[0] + influence[1] * d[1] + carriage;
        let rate = self.shaft.compliance[i] + influence[0] * rates[0] + influence[1] * rates[1] + carriage_rate;
        Ok(Deflection { force, supports, shaft, carriage, total, rate, met: f64::INFINITY })
    }

    /// The deflection takes depth off the cut, and the force with it: P = P₀·(t_d/t₀)^e, t_d = t_set − y(P)
    /// ≥ 0.
    ///
    /// t_d + y(P(t_d)) rises with t_d from 0 to beyond t_set, so the root is bracketed; Newton's step is
    /// taken where it stays inside the bracket.
    fn fed_back(&self, i: usize, at: Conditions, exponent: f64) -> Result<Deflection, JointsError> {
        if at.set_depth <= 0.0 || at.nominal == 0.0 {
            return self.under(i, 0.0, None);
        }
        let force = |depth: f64| at.nominal * (depth / at.nominal_depth).powf(exponent);
        let (mut low, mut high) = (0.0, at.set_depth);
        let mut deflection = self.under(i, force(at.set_depth), None)?;
        let mut depth = at.set_depth / (1.0 + deflection.total / at.set_depth);
        for _ in 0..MAX_ITERATIONS {
            deflection = self.under(i, force(depth), Some(&deflection))?;
            let excess = depth + deflection.total - at.set_depth;
            if excess > 0.0 {
                high = depth
            } else {
                low = depth
            }
            let slope = 1.0 + deflection.rate * exponent * deflection.force / depth;
            let newton = depth - excess / slope;
            let inside = newton > low && newton < high;
            // The depth may be a tiny part of what is set, so it is halved by ratio and every step is
            // measured against it.
            let halved = if low > 0.0 { (low * high).sqrt() } else { 1e-2 * high };
            let next = if inside { newton } else { halved };
            if (inside && (next - depth).abs() <= NEWTON_STEP * depth)
                || excess == 0.0
                || high - low <= ROUND_OFF * high
            {
                return self.under(i, force(if excess == 0.0 { depth } else { next }), Some(&deflection));
            }
            depth = next;
        }
        Err(JointsError { load: at.nominal, iterations: MAX_ITERATIONS, residual: force(high) - force(low) })
    }
}

/// A step of Newton's method that is this short, relative to the depth, has left an error of about its
/// square.
const NEWTON_STEP: f64 = 1e-8;
/// A bracket that cannot be halved any more.
const ROUND_OFF: f64 = 4e-16;
/// Halving by ratio needs some 60 from 1e-2 to round-off, and a dozen to find the power of ten.
const MAX_ITERATIONS: usize = 300;
