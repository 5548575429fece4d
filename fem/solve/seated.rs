//! The equilibrium of the end joints together with seats in the structure under them, as many as there are.
//!
//! With all of their forces F and displacements e in one vector
//!
//! ```text
//!     F + S·e(F) − g·P = q
//! ```
//!
//! is the problem of the two end joints ([`solve_joints`](super::solve_joints)) in more unknowns, and is solved along the
//! same paths. S is positive semidefinite and every joint's force rises along its path, so that the equilibrium is the least
//! of a convex energy. Where Newton's steps stall at a joint that opens or comes to its flank, every joint is brought into
//! balance by itself in turn, which always lowers that energy, and Newton's method begins anew from there.

use nalgebra::{DMatrix, DVector};

use super::equilibrium::JointsError;
use crate::joint::{JointState, Rubbing, Seat};

/// Most joints of a structure that are no springs.
pub const MOST_SEATS: usize = 8;
/// Residual at which a state counts as in equilibrium, relative to the forces in play.
const TOLERANCE: f64 = 1e-12;
/// The same where no step lowers it any more.
const ROUND_OFF: f64 = 1e-9;
/// Newton steps of a round.
const STEPS: usize = 60;
/// Whole steps that are dared where no shorter one helps.
const DARED: usize = 20;
/// Rounds after which what is left is round-off.
const IDLE: usize = 5;
/// Rounds, and how often in each every joint is brought into balance by itself before.
const ROUNDS: usize = 200;
const SWEEPS: usize = 10;
/// No joint of a machine opens this far: what is so wide apart is held by nothing else, m or rad.
const WIDE: f64 = 0.01;
/// Contacts that stand so far apart after all rounds have come loose, m or rad.
const APART: f64 = 1e-4;
/// Halvings of a step.
const HALVINGS: usize = 40;
/// Part of a spring's stiffness below which nothing beside the seat resists: what rounding leaves of none.
const NOTHING: f64 = 1e-9;

/// What the joints see: headstock and tailstock first, then the seats.
pub struct System<'s> {
    /// Forces per unit force of the tool, every joint rigid.
    pub influence: &'s [f64],
    /// Forces per unit displacement of each, N/m; as [`resisted`] leaves it.
    pub constraint: &'s DMatrix<f64>,
    /// Forces that are there without the tool, N.
    pub bent_forces: &'s [f64],
}

/// Joints in equilibrium; headstock and tailstock first, then the seats.
#[derive(Clone, Debug, PartialEq)]
pub struct Seated {
    /// Forces, N.
    pub forces: Vec<f64>,
    /// Displacements, m.
    pub displacements: Vec<f64>,
    /// Their change with the tool's force, m/N.
    pub rates: Vec<f64>,
    /// Path variables: a start for the solution under a similar force.
    pub path: Vec<f64>,
    /// Newton iterations.
    pub iterations: usize,
}

/// The constraint of headstock, tailstock and seats on these springs (N/m), in which what rounding leaves where statics alone
/// gives the force of a seat is nothing.
pub fn resisted(mut constraint: DMatrix<f64>, springs: &[f64]) -> DMatrix<f64> {
    for (seat, spring) in springs.iter().enumerate() {
        if constraint[(2 + seat, 2 + seat)].abs() <= NOTHING * spring {
            constraint.row_mut(2 + seat).fill(0.0);
            constraint.column_mut(2 + seat).fill(0.0);
        }
    }
    constraint
}

#[derive(Clone)]
struct State {
    path: Vec<f64>,
    joints: Vec<JointState>,
    residual: DVector<f64>,
    /// Size of the forces that are in balance, N.
    scale: f64,
}

/// The joints and what they see.
struct Problem<'p> {
    joints: &'p [Rubbing<'p>; 2],
    seats: &'p [Seat],
    constraint: &'p DMatrix<f64>,
    /// Forces with every joint rigid, N.
    target: DVector<f64>,
    /// Size of the forces that act from outside or hold a seat together, N: what rounding leaves is measured by it too.
    acting: f64,
}

impl Problem<'_> {
    fn count(&self) -> usize {
        2 + self.seats.len()
    }

    fn along(&self, k: usize, s: f64) -> JointState {
        if k < 2 { self.joints[k].along(s) } else { self.seats[k - 2].along(s) }
    }

    /// Every joint under its force with all of them rigid; a force that rounding leaves is none.
    fn start(&self) -> Vec<f64> {
        let force = |k: usize| {
            let own = self.target[k];
            if own.abs() <= ROUND_OFF * self.acting { 0.0 } else { own }
        };
        let path_at = |k: usize| match k < 2 {
            true => self.joints[k].path_at(force(k)),
            false => self.seats[k - 2].path_at(force(k)),
        };
        (0..self.count()).map(path_at).collect()
    }

    fn at(&self, path: Vec<f64>) -> State {
        let count = self.count();
        let joints: Vec<JointState> = path.iter().enumerate().map(|(k, s)| self.along(k, *s)).collect();
        let displaced = DVector::from_fn(count, |k, _| joints[k].displacement);
        let resisted = self.constraint * &displaced;
        let residual = DVector::from_fn(count, |k, _| joints[k].force + resisted[k] - self.target[k]);
        let size = |k: usize| {
            let parts = (0..count).map(|j| (self.constraint[(k, j)] * displaced[j]).abs()).sum::<f64>();
            joints[k].force.abs() + parts + self.target[k].abs()
        };
        let scale = (0..count).map(size).fold(self.acting, f64::max);
        State { path, joints, residual, scale }
    }

    fn jacobian(&self, state: &State) -> DMatrix<f64> {
        let count = self.count();
        let mut jacobian = DMatrix::from_fn(count, count, |k, j| {
            let own = if k == j { state.joints[k].force_rate } else { 0.0 };
            own + self.constraint[(k, j)] * state.joints[j].displacement_rate
        });
        for k in 0..count {
            // Nothing can load this joint, as where there is no tailstock: it stays unloaded.
            if jacobian.row(k).iter().all(|own| *own == 0.0) {
                jacobian[(k, k)] = 1.0;
            }
        }
        jacobian
    }

    /// Newton's step; `None` where there is none.
    fn newton(&self, from: &State) -> Option<DVector<f64>> {
        self.jacobian(from).lu().solve(&from.residual)
    }

    /// The state after a part of a step.
    fn stepped(&self, from: &State, step: &DVector<f64>, length: f64) -> State {
        self.at(from.path.iter().zip(step.iter()).map(|(own, step)| own - length * step).collect())
    }

    /// The first of ever shorter steps that lowers the residual.
    fn search(&self, from: &State, step: &DVector<f64>) -> Option<State> {
        let mut length = 1.0;
        for _ in 0..HALVINGS {
            let tried = self.stepped(from, step, length);
            if tried.residual.amax() < (1.0 - 1e-4 * length) * from.residual.amax() {
                return Some(tried);
            }
            length *= 0.5;
        }
        None
    }

    /// The best of some whole steps, whether they lower the residual or not: beyond a kink they often do, where no shorter
    /// one does before it.
    fn dared(&self, from: State) -> State {
        let (mut best, mut here) = (from.clone(), from);
        for _ in 0..DARED {
            let Some(step) = self.newton(&here).filter(|step| step.iter().all(|own| own.is_finite())) else { break };
            here = self.stepped(&here, &step, 1.0);
            if here.residual.amax() < best.residual.amax() {
                best = here.clone();
            }
        }
        best
    }

    /// Brings every joint into balance by itself, one after the other, the others as they stand.
    fn relaxed(&self, from: &State) -> State {
        let mut path = from.path.clone();
        let mut displaced: Vec<f64> = from.joints.iter().map(|own| own.displacement).collect();
        for _ in 0..SWEEPS {
            for k in 0..self.count() {
                let own = self.constraint[(k, k)];
                let others: f64 =
                    (0..self.count()).filter(|j| *j != k).map(|j| self.constraint[(k, j)] * displaced[j]).sum();
                let left = |s: f64| {
                    let joint = self.along(k, s);
                    joint.force + own * joint.displacement + others - self.target[k]
                };
                path[k] = root(left, path[k]);
                displaced[k] = self.along(k, path[k]).displacement;
            }
        }
        self.at(path)
    }

    /// The contact that is open farthest, if any is by more than `beyond` (m).
    fn open(&self, state: &State, beyond: f64) -> Option<usize> {
        // A clearance is never below its first flank.
        let open = |(seat, own): (usize, &JointState)| {
            (own.force_rate == 0.0 && own.displacement < -beyond).then_some((seat, own.displacement))
        };
        let all = state.joints.iter().skip(2).enumerate().filter_map(open);
        all.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(seat, _)| seat)
    }

    /// A seat whose force statics gives, and that cannot bear it.
    fn bears_not(&self) -> Option<usize> {
        let cannot = |(seat, law): (usize, &Seat)| {
            let k = 2 + seat;
            let pulls = law.holds() + self.target[k] < -ROUND_OFF * self.acting;
            pulls && self.constraint.row(k).iter().all(|own| *own == 0.0)
        };
        self.seats.iter().enumerate().position(cannot)
    }
}

/// Where a function that never falls is zero, from a place near it; where it is so nowhere near, as far as it was looked for.
fn root(of: impl Fn(f64) -> f64, near: f64) -> f64 {
    let here = of(near);
    if here == 0.0 {
        return near;
    }
    let towards = if here > 0.0 { -1.0 } else { 1.0 };
    let (mut inner, mut reach) = (near, 1e-6f64.max(1e-6 * near.abs()));
    let mut outer = near + towards * reach;
    for _ in 0..100 {
        if of(outer) * towards >= 0.0 {
            break;
        }
        inner = outer;
        reach *= 2.0;
        outer = near + towards * reach;
    }
    for _ in 0..100 {
        let middle = 0.5 * (inner + outer);
        if middle == inner || middle == outer {
            break;
        }
        if of(middle) * towards >= 0.0 { outer = middle } else { inner = middle }
    }
    outer
}

/// Solves for end joints and seats under the tool's force (N), from a path of the solution under a similar one if there is
/// one.
///
/// # Errors
/// Newton's method did not converge, a seat opens that alone bears a part, or there are more seats than [`MOST_SEATS`].
pub fn solve_seated(
    joints: &[Rubbing; 2],
    seats: &[Seat],
    system: &System,
    load: f64,
    near: Option<&[f64]>,
) -> Result<Seated, JointsError> {
    let count = 2 + seats.len();
    let bent = system.bent_forces.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
    let held = seats.iter().map(Seat::holds).filter(|own| own.is_finite()).fold(0.0, f64::max);
    let target = DVector::from_fn(count, |k, _| system.influence[k] * load + system.bent_forces[k]);
    let constraint = system.constraint;
    let problem = Problem { joints, seats, constraint, target, acting: load.abs() + bent + held };
    let failure = |state: &State, iterations| match problem.open(state, APART) {
        // Seats that open together leave a part of the machine loose, which goes on and on.
        Some(seat) => JointsError::Open { seat, load },
        None => JointsError::Diverged { load, iterations, residual: state.residual.amax() },
    };
    let mut state = problem.at(near.map_or_else(|| problem.start(), <[f64]>::to_vec));
    if seats.len() > MOST_SEATS {
        return Err(failure(&state, 0));
    }
    if let Some(seat) = problem.bears_not() {
        return Err(JointsError::Open { seat, load });
    }
    let is_settled =
        |part: f64, state: &State| state.residual.amax() <= part * state.scale && problem.open(state, WIDE).is_none();
    let done = |state: State, iterations| {
        let influence = DVector::from_column_slice(system.influence);
        let rates = problem.jacobian(&state).lu().solve(&influence).unwrap_or_else(|| DVector::zeros(count));
        Seated {
            forces: state.joints.iter().map(|own| own.force).collect(),
            displacements: state.joints.iter().map(|own| own.displacement).collect(),
            rates: state.joints.iter().zip(rates.iter()).map(|(own, rate)| own.displacement_rate * rate).collect(),
            path: state.path,
            iterations,
        }
    };
    let (mut iterations, mut idle) = (0, 0);
    for _ in 0..ROUNDS {
        let before = state.residual.amax();
        for _ in 0..STEPS {
            if is_settled(TOLERANCE, &state) {
                return Ok(done(state, iterations));
            }
            let Some(next) = problem.newton(&state).and_then(|step| problem.search(&state, &step)) else { break };
            state = next;
            iterations += 1;
        }
        state = problem.dared(state);
        if is_settled(TOLERANCE, &state) {
            return Ok(done(state, iterations));
        }
        // Nothing lowers the residual any more: at round-off this is the answer.
        idle = if state.residual.amax() < 0.99 * before { 0 } else { idle + 1 };
        if idle >= IDLE && is_settled(ROUND_OFF, &state) {
            return Ok(done(state, iterations));
        }
        state = problem.relaxed(&state);
    }
    Err(failure(&state, iterations))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::{Contact, Joint};
    use crate::solve::solve_joints;

    /// Without seats it is the problem of the end joints, and is solved as that is.
    #[test]
    fn end_joints_alone_are_as_ever() {
        let contact = Contact { coefficient: 2e-7, exponent: 0.5 };
        let joints = [
            Joint { spring_compliance: 1.0 / 60e6, contacts: vec![contact] },
            Joint { spring_compliance: 1.0 / 40e6, contacts: Vec::new() },
        ];
        let joints = joints.each_ref().map(Rubbing::free);
        let constraint = [[3e7, -1e7], [-1e7, 2e7]];
        let matrix = DMatrix::from_fn(2, 2, |i, j| constraint[i][j]);
        for (load, bent) in [(450.0, [0.0, 0.0]), (100.0, [30.0, -20.0]), (2000.0, [-50.0, 10.0])] {
            let system = System { influence: &[0.6, 0.5], constraint: &matrix, bent_forces: &bent };
            let found = solve_seated(&joints, &[], &system, load, None).unwrap();
            let expected = solve_joints(&joints, [0.6, 0.5], &constraint, (load, bent), None).unwrap();
            for k in 0..2 {
                assert!((found.forces[k] - expected.forces[k]).abs() < 1e-9 * load);
                assert!((found.displacements[k] - expected.displacements[k]).abs() < 1e-9 * load / 1e7);
                assert!((found.rates[k] / expected.displacement_rates[k] - 1.0).abs() < 1e-8);
            }
        }
    }

    /// A contact whose force statics gives, at rest, loaded, about to open and beyond, whatever rounding leaves of its preload.
    #[test]
    fn a_contact_that_statics_loads_yields_by_its_law_until_it_opens() {
        let rigid = Joint::default();
        let joints = [Rubbing::free(&rigid); 2];
        let left = DMatrix::from_fn(3, 3, |i, j| if i == 2 && j == 2 { 3e-8 } else { 0.0 });
        let constraint = resisted(left, &[6e8]);
        for (n, preload) in [(0.4, 1500.0), (0.6, 2000.0), (0.7, 3000.0), (0.5, 50_000.0), (0.55, 0.0)] {
            let contact = Contact { coefficient: 3e-7, exponent: n };
            let seats = [Seat::Contact(contact, preload)];
            let system = System { influence: &[0.0, 0.0, 1.0], constraint: &constraint, bent_forces: &[0.0; 3] };
            for load in [0.0, 1e-14, 250.0, -0.9 * preload] {
                let found = solve_seated(&joints, &seats, &system, load, None).unwrap();
                let expected = contact.displacement(load + preload) - contact.displacement(preload);
                assert!(
                    (found.displacements[2] - expected).abs() < 1e-9 * 1e-6f64.max(expected.abs()),
                    "{n} {preload} {load}: {found:?}"
                );
            }
            let opens = solve_seated(&joints, &seats, &system, -preload - 1.0, None);
            assert_eq!(opens, Err(JointsError::Open { seat: 0, load: -preload - 1.0 }));
        }
    }

    /// A clearance that a force has to cross: none of it below, all of it beyond, and what is in between where another
    /// spring limits it.
    #[test]
    fn a_clearance_is_crossed() {
        let rigid = Joint::default();
        let joints = [Rubbing::free(&rigid); 2];
        let seats = [Seat::Clearance(5e-6)];
        // The seat's spring k beside another k' that bears what it does not: S = k k'/(k + k').
        let matrix = DMatrix::from_fn(3, 3, |i, j| if i == 2 && j == 2 { 1e7 } else { 0.0 });
        for (load, expected) in [(-80.0, 0.0), (20.0, 2e-6), (40.0, 4e-6), (200.0, 5e-6)] {
            let system = System { influence: &[0.0, 0.0, 1.0], constraint: &matrix, bent_forces: &[0.0; 3] };
            let found = solve_seated(&joints, &seats, &system, load, None).unwrap();
            assert!((found.displacements[2] - expected).abs() < 1e-15, "{load}: {found:?}");
            assert!((found.forces[2] - (load - 1e7 * expected)).abs() < 1e-9);
        }
    }
}
