//! The part on a given set of supports, each of which holds both ways.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::{Flexible, LaidError, Load, Settled, Spot, Sunk, Support, Supports, friction};
use crate::joint::JointState;

/// Residual at which forces and displacements count as in equilibrium, relative to the terms of each
/// equation.
const TOLERANCE: f64 = 1e-13;
const MAX_ITERATIONS: usize = 80;
/// Change of friction as a part of the loads at which it has come to rest.
const SETTLED: f64 = 1e-12;

/// A part on supports that hold both ways.
pub(super) struct Carried {
    /// Force of every support, N; those that do not carry are included.
    pub forces: Vec<f64>,
    /// Friction of every support on the part, N.
    pub friction: Vec<f64>,
    /// The part at rest.
    pub part: Settled,
}

/// Solves for the forces of the supports that carry.
pub(super) fn carry(
    part: &Arc<Flexible>,
    on: Supports,
    carrying: &[bool],
    loads: &[Load],
) -> Result<Carried, LaidError> {
    let supports = on.all;
    let own: Vec<usize> = (0..supports.len()).filter(|i| carrying[*i]).collect();
    let mut problem = Problem::new(part, on, &own, loads);
    let (mut found, mut rigid) = problem.solve()?;
    let mut held = vec![0.0; own.len()];
    if own.iter().any(|i| supports[*i].friction > 0.0) {
        let lost = LaidError::NoEquilibrium { load: problem.total };
        let spots: Vec<Spot> = own.iter().map(|i| supports[*i].spot.along()).collect();
        let influence = part.influence(&spots);
        // Friction bends the part, and what that changes of the forces changes friction: a small part each time.
        for round in 0.. {
            let next = problem.friction(part, &spots, &influence, &found).ok_or(lost)?;
            let change = held.iter().zip(&next).map(|(t, next): (&f64, &f64)| (t - next).abs()).fold(0.0, f64::max);
            held = next;
            if change <= SETTLED * problem.total {
                break;
            }
            if round == MAX_ITERATIONS {
                return Err(lost);
            }
            problem.bend(part, &spots, &held);
            (found, rigid) = problem.solve()?;
        }
    }
    let [mut forces, mut friction] = [vec![0.0; supports.len()], vec![0.0; supports.len()]];
    for (k, i) in own.iter().enumerate() {
        (forces[*i], friction[*i]) = (found[k], held[k]);
    }
    let acting = acting(supports, loads, &forces, &friction);
    Ok(Carried { forces, friction, part: Settled { part: part.clone(), forces: acting, rigid, reactions: Vec::new() } })
}

/// All that acts on the part: loads, reactions and friction.
pub(super) fn acting(supports: &[Support], loads: &[Load], forces: &[f64], friction: &[f64]) -> Vec<(Spot, f64)> {
    let pressed = loads.iter().map(|l| (l.spot, l.force));
    let carried = supports.iter().zip(forces).map(|(s, q)| (s.spot, -q));
    let held = supports.iter().zip(friction).filter(|(_, t)| **t != 0.0).map(|(s, t)| (s.spot.along(), *t));
    pressed.chain(carried).chain(held).collect()
}

struct Problem<'a> {
    /// All supports.
    on: Supports<'a>,
    /// Numbers of those that carry.
    own: &'a [usize],
    supports: Vec<&'a Support>,
    loads: &'a [Load],
    /// G(x_i, x_j) between supports, m/N.
    influence: DMatrix<f64>,
    /// Deflection of the supports' places by the loads and by friction, m.
    bent: Vec<f64>,
    /// Middle and half of the supports' span, m, about which turns are counted.
    middle: f64,
    half: f64,
    /// Sum of the loads ΣF, N.
    total: f64,
}

/// A trial: where each joint stands on its path, and the rigid motion (at the middle, and at its half span
/// beyond), m.
struct Trial {
    path: Vec<f64>,
    rigid: [f64; 2],
    states: Vec<JointState>,
    sunk: Option<Sunk>,
    residual: DVector<f64>,
    /// Largest residual over the terms of its equation.
    size: f64,
}

impl<'a> Problem<'a> {
    fn new(part: &Flexible, on: Supports<'a>, own: &'a [usize], loads: &'a [Load]) -> Self {
        let supports: Vec<&Support> = own.iter().map(|i| &on.all[*i]).collect();
        let at = |i: usize| supports[i].spot.at;
        let (from, to) = (0..supports.len())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), i| (low.min(at(i)), high.max(at(i))));
        let pressed: Vec<(Spot, f64)> = loads.iter().map(|l| (l.spot, l.force)).collect();
        Self {
            influence: part.influence(&supports.iter().map(|s| s.spot).collect::<Vec<Spot>>()),
            bent: supports.iter().map(|s| part.deflection(&s.spot, &pressed)).collect(),
            middle: 0.5 * (from + to),
            half: 0.5 * (to - from),
            total: loads.iter().map(|l| l.force).sum(),
            on,
            own,
            supports,
            loads,
        }
    }

    /// The ground under these forces of the supports (N); `None` where it stands firm.
    fn sunk(&self, forces: &[f64]) -> Result<Option<Sunk>, LaidError> {
        let Some(ground) = self.on.ground else { return Ok(None) };
        let mut all = vec![0.0; self.on.all.len()];
        self.own.iter().zip(forces).for_each(|(i, force)| all[*i] = *force);
        let Sunk { by, rates } = ground.sunk(&all).map_err(LaidError::Ground)?;
        Ok(Some(Sunk {
            by: self.own.iter().map(|i| by[*i]).collect(),
            rates: DMatrix::from_fn(self.own.len(), self.own.len(), |i, j| rates[(self.own[i], self.own[j])]),
        }))
    }

    /// Friction (N) that belongs to these forces of the supports, whose `spots` along the part have this influence.
    fn friction(&self, part: &Flexible, spots: &[Spot], influence: &DMatrix<f64>, forces: &[f64]) -> Option<Vec<f64>> {
        let pressed = self.loads.iter().map(|l| (l.spot, l.force));
        let acting: Vec<(Spot, f64)> =
            pressed.chain(self.supports.iter().zip(forces).map(|(s, q)| (s.spot, -q))).collect();
        let free: Vec<f64> = spots.iter().map(|spot| part.deflection(spot, &acting)).collect();
        let limits: Vec<f64> = self.supports.iter().zip(forces).map(|(s, q)| s.friction * q.max(0.0)).collect();
        friction::held(influence, &free, &limits)
    }

    /// Lets loads and friction bend the part.
    fn bend(&mut self, part: &Flexible, spots: &[Spot], friction: &[f64]) {
        let pressed = self.loads.iter().map(|l| (l.spot, l.force));
        let all: Vec<(Spot, f64)> = pressed.chain(spots.iter().copied().zip(friction.iter().copied())).collect();
        self.bent = self.supports.iter().map(|s| part.deflection(&s.spot, &all)).collect();
    }

    /// Forces of the supports, and the rigid motion.
    fn solve(&self) -> Result<(Vec<f64>, (f64, f64)), LaidError> {
        if self.supports.len() == 2 { self.by_statics() } else { self.by_newton() }
    }

    /// Lever of a place about the middle, in half spans.
    fn lever(&self, x: f64) -> f64 {
        (x - self.middle) / self.half
    }

    /// Two supports: the levers decide.
    fn by_statics(&self) -> Result<(Vec<f64>, (f64, f64)), LaidError> {
        let [a, b] = [self.supports[0].spot.at, self.supports[1].spot.at];
        let share =
            |from: f64, to: f64| self.loads.iter().map(|l| l.force * (l.spot.at - from)).sum::<f64>() / (to - from);
        let forces = vec![share(b, a), share(a, b)];
        let sunk = self.sunk(&forces)?;
        let y = |i: usize| {
            let support = self.supports[i];
            let sunk = sunk.as_ref().map_or(0.0, |sunk| sunk.by[i]);
            support.lowered + sunk + support.joint.displacement(forces[i]) - self.bent_at(i, &forces)
        };
        let slope = (y(1) - y(0)) / (b - a);
        let rigid = (y(0) - slope * a, slope);
        Ok((forces, rigid))
    }

    /// Deflection of a support's place by loads and reactions, m.
    fn bent_at(&self, i: usize, forces: &[f64]) -> f64 {
        self.bent[i] - forces.iter().enumerate().map(|(j, q)| self.influence[(i, j)] * q).sum::<f64>()
    }

    /// Newton's method along the joints' paths, each step as long as it lowers the residual.
    fn by_newton(&self) -> Result<(Vec<f64>, (f64, f64)), LaidError> {
        let failure = LaidError::NoEquilibrium { load: self.total };
        let mut trial = self.start()?;
        for _ in 0..MAX_ITERATIONS {
            if trial.size <= TOLERANCE {
                break;
            }
            let step = self.jacobian(&trial).lu().solve(&trial.residual).ok_or(failure)?;
            let Some(next) = self.search(&trial, &step) else { break };
            trial = next;
        }
        // Round-off of many supports may stop the fall a little before.
        if trial.size > 100.0 * TOLERANCE {
            return Err(failure);
        }
        let slope = trial.rigid[1] / self.half;
        let forces = trial.states.iter().map(|s| s.force).collect();
        Ok((forces, (trial.rigid[0] - slope * self.middle, slope)))
    }

    /// Every joint as a spring by its secant under an even share of the loads, the ground as it yields there.
    fn start(&self) -> Result<Trial, LaidError> {
        let count = self.supports.len();
        let share = self.total / count as f64;
        let sunk = self.sunk(&vec![share; count])?;
        let mut matrix = DMatrix::zeros(count + 2, count + 2);
        let mut right = DVector::zeros(count + 2);
        for i in 0..count {
            for j in 0..count {
                matrix[(i, j)] = self.influence[(i, j)];
            }
            matrix[(i, i)] += self.supports[i].joint.displacement(share) / share;
            right[i] = self.bent[i] - self.supports[i].lowered;
        }
        if let Some(Sunk { by, rates }) = sunk {
            let mut reactions = matrix.view_mut((0, 0), (count, count));
            reactions += &rates;
            (0..count).for_each(|i| right[i] -= by[i] - share * rates.row(i).sum());
        }
        self.border(&mut matrix, |_| 1.0);
        right[count] = self.total;
        right[count + 1] = self.moment();
        let found = matrix.lu().solve(&right).ok_or(LaidError::NoEquilibrium { load: self.total })?;
        let path = (0..count).map(|i| self.supports[i].joint.path_at(found[i])).collect();
        self.trial(path, [found[count], found[count + 1]])
    }

    /// Moment of the loads about the middle over the half span, N.
    fn moment(&self) -> f64 {
        self.loads.iter().map(|l| l.force * self.lever(l.spot.at)).sum()
    }

    /// The columns of the rigid motion and the rows of the balance; `rate` is dQ/ds of each support.
    fn border(&self, matrix: &mut DMatrix<f64>, rate: impl Fn(usize) -> f64) {
        let count = self.supports.len();
        for i in 0..count {
            let lever = self.lever(self.supports[i].spot.at);
            matrix[(i, count)] = -1.0;
            matrix[(i, count + 1)] = -lever;
            matrix[(count, i)] = rate(i);
            matrix[(count + 1, i)] = lever * rate(i);
        }
    }

    fn trial(&self, path: Vec<f64>, rigid: [f64; 2]) -> Result<Trial, LaidError> {
        let count = self.supports.len();
        let states: Vec<JointState> = self.supports.iter().zip(&path).map(|(s, p)| s.joint.along(*p)).collect();
        let forces: Vec<f64> = states.iter().map(|s| s.force).collect();
        let sunk = self.sunk(&forces)?;
        let mut residual = DVector::zeros(count + 2);
        let mut size = 0.0f64;
        for i in 0..count {
            let turn = rigid[1] * self.lever(self.supports[i].spot.at);
            let held = states.iter().enumerate().map(|(j, s)| self.influence[(i, j)] * s.force);
            let (sum, sizes) = held.fold((0.0, 0.0), |(sum, sizes), term| (sum + term, sizes + f64::abs(term)));
            let lowered = self.supports[i].lowered + sunk.as_ref().map_or(0.0, |sunk| sunk.by[i]);
            let displacement = states[i].displacement;
            residual[i] = lowered + displacement - rigid[0] - turn - self.bent[i] + sum;
            let terms = lowered.abs() + displacement.abs() + rigid[0].abs() + turn.abs() + self.bent[i].abs() + sizes;
            size = size.max(residual[i].abs() / terms.max(f64::MIN_POSITIVE));
        }
        let lever = |i: usize| self.lever(self.supports[i].spot.at);
        residual[count] = states.iter().map(|s| s.force).sum::<f64>() - self.total;
        residual[count + 1] = (0..count).map(|i| states[i].force * lever(i)).sum::<f64>() - self.moment();
        let terms = self.total + states.iter().map(|s| s.force.abs()).sum::<f64>();
        size = size.max(residual[count].abs() / terms).max(residual[count + 1].abs() / terms);
        Ok(Trial { path, rigid, states, sunk, residual, size })
    }

    fn jacobian(&self, trial: &Trial) -> DMatrix<f64> {
        let count = self.supports.len();
        let mut matrix = DMatrix::zeros(count + 2, count + 2);
        for i in 0..count {
            for j in 0..count {
                let sinking = trial.sunk.as_ref().map_or(0.0, |sunk| sunk.rates[(i, j)]);
                matrix[(i, j)] = (self.influence[(i, j)] + sinking) * trial.states[j].force_rate;
            }
            matrix[(i, i)] += trial.states[i].displacement_rate;
        }
        self.border(&mut matrix, |i| trial.states[i].force_rate);
        matrix
    }

    /// The first of ever shorter steps that lowers the residual.
    fn search(&self, from: &Trial, step: &DVector<f64>) -> Option<Trial> {
        let count = self.supports.len();
        let mut length = 1.0;
        for _ in 0..40 {
            let path = (0..count).map(|i| from.path[i] - length * step[i]).collect();
            let rigid = [0, 1].map(|k| from.rigid[k] - length * step[count + k]);
            // A trial may go so far that the ground opens.
            let next = self.trial(path, rigid).ok().filter(|next| next.size < (1.0 - 1e-4 * length) * from.size);
            if next.is_some() {
                return next;
            }
            length *= 0.5;
        }
        None
    }
}
