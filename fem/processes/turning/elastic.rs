//! Elastic equilibrium of a cut: shaft, supports, carriage, nose and force, with the surface met and the one left.
//!
//! Nose and work are moved apart by a gap y: the shaft bends under the force between supports that yield, and that
//! stand where effects have moved them; tool and slide yield. All else that moves the nose ([`Nose`]) meets that gap in
//! one place, and the depth of cut is what lies between blank and nose: t_d = t_set − (R − D/2), R the radius at which
//! the nose stands.

use super::cut::Conditions;
use super::machine::{Machine, Moment, Nose};
use super::setup::Setup;
use crate::joint::{Joint, Rubbing};
use crate::process::Failure;
use crate::solve::{
    Condensed, Equilibrium, JointsError, MOST_SEATS, Moved, ShaftError, System, solve_joints, solve_seated,
};

/// What the joints of headstock and tailstock bear, N, in every pass; nothing where nothing rubs.
pub type Borne = [[f64; 2]];

/// A cut at one place and moment: force, depth, diameter, nose and supports.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutting {
    /// Force and depth.
    pub conditions: Conditions,
    /// Diameter that is meant, m.
    pub diameter: f64,
    /// Where the nose stands.
    pub nose: Nose,
    /// What a correction of the last pass adds to the diameter there, m.
    pub commanded: f64,
    /// How far headstock and tailstock stand from their places, m.
    pub displacements: [f64; 2],
    /// What the joints of headstock and tailstock bore before the tool came there, N; where friction holds them they stay.
    pub borne: [f64; 2],
}

impl Cutting {
    /// The cut at a moment under these conditions.
    pub fn new(machine: &Machine, moment: &Moment, conditions: Conditions) -> Self {
        let (nose, displacements) = (machine.nose_at(moment), machine.displacements_at(moment));
        let commanded = machine.commanded_at(moment);
        Self { conditions, diameter: moment.diameter, nose, commanded, displacements, borne: [0.0; 2] }
    }

    /// The last pass on a part at x (m), by the schedule and the settings of the model, where the work is as it is meant and
    /// nothing has been through anything.
    pub fn on_part(machine: &Machine, part: usize, x: f64) -> Self {
        Self::new(machine, &machine.moment_on(part, x), machine.setup.conditions(x, 0.0))
    }

    /// The same behind a place up to which the joints have been through this, of every pass; as a history of the pass has it.
    #[must_use]
    pub fn behind(mut self, borne: &Borne) -> Self {
        self.borne = borne.last().copied().unwrap_or_default();
        self
    }

    /// The same where the last pass is programmed to another radius, larger by a change (m).
    #[must_use]
    pub fn programmed(mut self, change: f64) -> Self {
        self.commanded += 2.0 * change;
        self.nose.across += 2.0 * change;
        self
    }

    /// The same where the work is larger by an error of the diameter (m).
    #[must_use]
    pub fn meeting(mut self, error: f64) -> Self {
        self.conditions.set_depth += 0.5 * error;
        self
    }
}

/// The equilibrium at one tool position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deflection {
    /// Radial force that really acts, N.
    pub force: f64,
    /// Forces and yielding of headstock and tailstock.
    pub supports: Equilibrium,
    /// How far these stand from their places, m.
    pub displaced: [f64; 2],
    /// What their joints bear; the rest of the forces is friction, N.
    pub borne: [f64; 2],
    /// Displacements and path variables of the joints of the structure that are no springs.
    pub seats: [[f64; MOST_SEATS]; 2],
    /// The shaft's own bending under the tool, m.
    pub shaft: f64,
    /// What supports and tool stand on, m.
    pub structure: f64,
    /// Tool, slide and holder, m.
    pub carriage: f64,
    /// The whole gap y between tool and work, m.
    pub total: f64,
    /// dy/dP, m/N.
    pub rate: f64,
    /// Diameter error that is left, m.
    pub error: f64,
}

impl Deflection {
    /// What joints, and what moves supports, have moved.
    pub fn moved(&self) -> Moved {
        let y = self.supports.displacements;
        Moved { ends: [y[0] + self.displaced[0], y[1] + self.displaced[1]], seats: self.seats[0] }
    }
}

/// Joints in equilibrium: those of the ends, and the seats of the structure.
struct Settled {
    supports: Equilibrium,
    /// Displacements and path variables.
    seats: [[f64; MOST_SEATS]; 2],
    /// What the seats add to the gap, m, and to its rate, m/N.
    gap: [f64; 2],
}

/// The elastic part of a machine: what a deflection depends on.
pub struct Elastic<'a> {
    shaft: &'a Condensed,
    joints: [&'a Joint; 2],
    friction: [f64; 2],
    carriage: &'a Joint,
    feedback: Option<f64>,
    setup: &'a Setup,
}

impl<'a> Elastic<'a> {
    /// A machine on a shaft condensed to the positions of interest.
    pub fn new(machine: &'a Machine, shaft: &'a Condensed) -> Self {
        let joints = [&machine.headstock, &machine.tailstock];
        let feedback = machine.feedback.filter(|exponent| *exponent != 0.0);
        let (friction, carriage) = (machine.friction, &machine.carriage);
        Self { shaft, joints, friction, carriage, feedback, setup: &machine.setup }
    }

    /// The diameter error (m) that the first pass meets at x, at an angle (rad) around the part or on the mean: none where
    /// no pass copies it.
    pub fn met(&self, x: f64, angle: Option<f64>) -> f64 {
        if self.feedback.is_none() {
            return 0.0;
        }
        let blank = &self.setup.blank;
        // Half of a diameter is what the tool meets at one angle.
        let around = angle.map_or(0.0, |angle| 2.0 * blank.around(angle));
        blank.error(x, self.setup.length()) + around
    }

    /// The diameter error (m) that the passes before the last leave at x with the tool there, at position
    /// number `i`, at an angle (rad) around the part or on the mean: where the force is fed back each copies what it
    /// meets. `last` is the last pass, and whatever moves nose and supports in it moves them in all; `borne` is what the
    /// joints bore in every pass before the tool came there.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    fn before(&self, i: usize, x: f64, angle: Option<f64>, last: &Cutting, borne: &Borne) -> Result<f64, Failure> {
        if self.feedback.is_none() {
            return Ok(0.0);
        }
        (0..self.setup.passes.len())
            .try_fold(self.met(x, angle), |error, number| Ok(self.pass(number, (i, x), error, last, borne)?.error))
    }

    /// The last pass on what the passes before it leave of the blank, see [`Self::before`].
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn last(
        &self,
        (i, x): (usize, f64),
        angle: Option<f64>,
        last: &Cutting,
        borne: &Borne,
    ) -> Result<Deflection, Failure> {
        self.finish(i, self.before(i, x, angle, last, borne)?, last, borne)
    }

    /// The last pass where the work is too large by an error (m).
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn finish(&self, i: usize, error: f64, last: &Cutting, borne: &Borne) -> Result<Deflection, Failure> {
        self.deflect(i, &last.behind(borne).meeting(error))
    }

    /// The pass `number`, the last behind those before it, with the tool at a position of a number at x (m), where the work
    /// is too large by an error (m).
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn pass(
        &self,
        number: usize,
        (i, x): (usize, f64),
        error: f64,
        last: &Cutting,
        borne: &Borne,
    ) -> Result<Deflection, Failure> {
        match number < self.setup.passes.len() {
            true => self.deflect(i, &self.earlier(number, x, error, last, borne)),
            false => self.finish(i, error, last, borne),
        }
    }

    /// The pass `number` before the last at x, where the work is too large by an error (m).
    fn earlier(&self, number: usize, x: f64, error: f64, last: &Cutting, borne: &Borne) -> Cutting {
        let passes = &self.setup.passes;
        let later = passes[number + 1..].iter().map(|pass| pass.depth).sum::<f64>() + self.setup.cut.depth;
        let conditions = passes[number].conditions(x, error);
        let nose = Nose { across: last.nose.across - last.commanded, ..last.nose };
        let borne = borne.get(number).copied().unwrap_or_default();
        Cutting { conditions, diameter: last.diameter + 2.0 * later, nose, commanded: 0.0, borne, ..*last }
    }

    /// The equilibrium with the tool at position number `i`.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn deflect(&self, i: usize, at: &Cutting) -> Result<Deflection, Failure> {
        match self.feedback {
            Some(exponent) => self.fed_back(i, at, exponent),
            None => self.under(i, at.conditions.force, at, None),
        }
    }

    /// The same under a given force (N) where every support stands in its place and nothing rubs.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn yielding(&self, i: usize, force: f64) -> Result<Equilibrium, Failure> {
        Ok(self.settled(i, force, None, None)?.supports)
    }

    /// The joints where they bore so much before, N.
    fn rubbing(&self, borne: [f64; 2]) -> [Rubbing<'a>; 2] {
        [0, 1].map(|k| Rubbing::new(self.joints[k], self.friction[k], borne[k]))
    }

    /// The joints under a given force, with supports that stand off, rests out of line and friction as a cut has them, or,
    /// where that is `None`, with all of them in their places and without it.
    fn settled(
        &self,
        i: usize,
        force: f64,
        at: Option<&Cutting>,
        near: Option<&Deflection>,
    ) -> Result<Settled, Failure> {
        let displaced = at.map(|at| at.displacements);
        let joints = at.map_or_else(|| self.joints.map(Rubbing::free), |at| self.rubbing(at.borne));
        let Some((constraint, bent)) = self.shaft.whole().filter(|_| !self.shaft.seats().is_empty()) else {
            let (influence, s) = (self.shaft.influence[i], &self.shaft.constraint);
            // A support that is moved leaves what it would take to move it back.
            let left = displaced.map_or([0.0; 2], |moved| {
                [0, 1].map(|k| self.shaft.bent_forces[k] - s[k][0] * moved[0] - s[k][1] * moved[1])
            });
            let supports = solve_joints(&joints, influence, s, (force, left), near.map(|d| &d.supports))?;
            return Ok(Settled { supports, seats: [[0.0; MOST_SEATS]; 2], gap: [0.0; 2] });
        };
        let influence = self.shaft.whole_influence(i);
        let left: Vec<f64> = (0..bent.len())
            .map(|k| {
                displaced.map_or(0.0, |moved| bent[k] - constraint[(k, 0)] * moved[0] - constraint[(k, 1)] * moved[1])
            })
            .collect();
        let system = System { influence: &influence, constraint, bent_forces: &left };
        let path =
            near.map(|d| d.supports.path.iter().chain(&d.seats[1]).take(bent.len()).copied().collect::<Vec<_>>());
        let told = |error| match &self.setup.base {
            Some(base) => base.drawn.failure(error),
            None => error.into(),
        };
        let all = solve_seated(&joints, self.shaft.seats(), &system, force, path.as_deref()).map_err(told)?;
        let ends = |of: &[f64]| [of[0], of[1]];
        let seats = |of: &[f64]| std::array::from_fn(|k| of.get(2 + k).copied().unwrap_or(0.0));
        let gap = |of: &[f64]| influence[2..].iter().zip(&of[2..]).map(|(g, own)| g * own).sum::<f64>();
        Ok(Settled {
            supports: Equilibrium {
                forces: ends(&all.forces),
                displacements: ends(&all.displacements),
                displacement_rates: ends(&all.rates),
                path: ends(&all.path),
                iterations: all.iterations,
            },
            seats: [seats(&all.displacements), seats(&all.path)],
            gap: [gap(&all.displacements), gap(&all.rates)],
        })
    }

    /// The equilibrium under a given force, from that under a similar one if there is one.
    fn under(&self, i: usize, force: f64, at: &Cutting, near: Option<&Deflection>) -> Result<Deflection, Failure> {
        let (influence, displaced) = (self.shaft.influence[i], at.displacements);
        let Settled { supports, seats, gap } = self.settled(i, force, Some(at), near)?;
        let [compliance, founded] = [self.shaft.compliance[i], self.shaft.foundation_compliance[i]];
        let [shaft, structure] = [compliance * force, founded * force + gap[0]];
        let (carriage, carriage_rate) = self.carriage.yield_under(force);
        let [y, rates] = [supports.displacements, supports.displacement_rates];
        let moved = self.shaft.moved(i, [y[0] + displaced[0], y[1] + displaced[1]]);
        let total = shaft + structure + moved + carriage;
        let joints = influence[0] * rates[0] + influence[1] * rates[1] + gap[1];
        let rate = compliance + founded + joints + carriage_rate;
        let error = at.nose.error(at.diameter, total).0;
        let rubbing = self.rubbing(at.borne);
        let borne = [0, 1].map(|k| rubbing[k].bears(supports.forces[k]));
        Ok(Deflection { force, supports, displaced, borne, seats, shaft, structure, carriage, total, rate, error })
    }

    /// Equilibrium with force feedback: a gap between nose and work takes depth off the cut, and the force with it, P =
    /// P₀·(t_d/t₀)^e, t_d = t_set − e(P)/2 ≥ 0, with e(P) the diameter error that the nose would leave under P. Where
    /// nothing is left of the depth the tool does not touch, and leaves what it meets.
    ///
    /// t_d + e(P(t_d))/2 rises with t_d, so the root is bracketed; Newton's step is taken where it stays inside the
    /// bracket.
    fn fed_back(&self, i: usize, at: &Cutting, exponent: f64) -> Result<Deflection, Failure> {
        let conditions = &at.conditions;
        let force = |depth: f64| conditions.nominal * (depth / conditions.nominal_depth).powf(exponent);
        let free = self.under(i, 0.0, at, None)?;
        let (mut low, mut high) = (0.0, conditions.set_depth - 0.5 * free.error);
        if high <= 0.0 {
            return Ok(Deflection { error: 2.0 * conditions.set_depth, ..free });
        }
        if conditions.nominal == 0.0 {
            return Ok(free);
        }
        let mut deflection = self.under(i, force(high), at, None)?;
        let mut depth = high / (1.0 + 0.5 * (deflection.error - free.error) / high);
        for _ in 0..MAX_ITERATIONS {
            deflection = self.under(i, force(depth), at, Some(&deflection))?;
            let excess = depth + 0.5 * deflection.error - conditions.set_depth;
            if excess > 0.0 {
                high = depth
            } else {
                low = depth
            }
            let by_gap = 0.5 * at.nose.error(at.diameter, deflection.total).1;
            let slope = 1.0 + by_gap * deflection.rate * exponent * deflection.force / depth;
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
                return self.under(i, force(if excess == 0.0 { depth } else { next }), at, Some(&deflection));
            }
            depth = next;
        }
        Err(JointsError::Diverged {
            load: conditions.nominal,
            iterations: MAX_ITERATIONS,
            residual: force(high) - force(low),
        }
        .into())
    }
}

/// The shaft as the machine holds it, condensed to tool positions in m.
///
/// # Errors
/// An effect cannot be computed, the shaft is loose, or a position is off it.
pub fn condense(machine: &Machine, positions: &[f64]) -> Result<Condensed, Failure> {
    if let Some(failure) = &machine.failure {
        return Err(failure.clone());
    }
    let shaft = machine.shaft();
    let condensed = match machine.setup.foundation(positions) {
        Some(foundation) => shaft.condense_on(positions, foundation),
        None => shaft.condense(positions),
    };
    condensed.map_err(Failure::from)
}

impl From<ShaftError> for Failure {
    fn from(error: ShaftError) -> Self {
        let help = match error {
            ShaftError::Loose { .. } => "give the shaft a stiffer support, or check its dimensions and stiffnesses",
            ShaftError::OffTheShaft { .. } => "keep every position between the ends of the shaft",
        };
        Self { message: error.to_string(), help: help.into() }
    }
}

/// A step of Newton's method that is this short, relative to the depth, has left an error of about its
/// square.
const NEWTON_STEP: f64 = 1e-8;
/// A bracket that cannot be halved any more.
const ROUND_OFF: f64 = 4e-16;
/// Halving by ratio needs some 60 from 1e-2 to round-off, and a dozen to find the power of ten.
const MAX_ITERATIONS: usize = 300;
