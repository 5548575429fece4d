//! The equilibrium of the end joints together with seats in the structure under them, as many as there are.
//!
//! With all of their forces F and displacements e in one vector
//!
//! ```text
//!     F + S·e(F) − g·P = q
//! ```
//!
//! is the problem of the two end joints ([`solve_joints`](super::solve_joints)) in more unknowns, and is solved along the
//! same paths.

use nalgebra::{DMatrix, DVector};

use super::equilibrium::JointsError;
use super::foundation::MOST_SEATS;
use crate::joint::{Joint, JointState, Seat};

/// Residual at which a state counts as in equilibrium, relative to the forces in play.
const TOLERANCE: f64 = 1e-12;
const MAX_ITERATIONS: usize = 200;
/// No joint of a machine opens this far: what is so wide apart is held by nothing else, m or rad.
const WIDE: f64 = 0.01;
/// Halvings of a step.
const HALVINGS: usize = 40;

/// What the joints see: headstock and tailstock first, then the seats.
pub struct System<'s> {
    /// Forces per unit force of the tool, every joint rigid.
    pub influence: &'s [f64],
    /// Forces per unit displacement of each, N/m.
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

struct State {
    path: Vec<f64>,
    joints: Vec<JointState>,
    residual: DVector<f64>,
    /// Size of the forces that are in balance, N.
    scale: f64,
}

/// Solves for end joints and seats under the tool's force (N), from a path of the solution under a similar one if there is
/// one.
///
/// # Errors
/// Newton's method did not converge, a seat opens that alone bears a part, or there are more seats than [`MOST_SEATS`].
pub fn solve_seated(
    joints: &[Joint; 2],
    seats: &[Seat],
    system: &System,
    load: f64,
    near: Option<&[f64]>,
) -> Result<Seated, JointsError> {
    let along = |k: usize, s: f64| if k < 2 { joints[k].along(s) } else { seats[k - 2].along(s) };
    let count = 2 + seats.len();
    let target = DVector::from_fn(count, |k, _| system.influence[k] * load + system.bent_forces[k]);
    let at = |path: Vec<f64>| {
        let joints: Vec<JointState> = path.iter().enumerate().map(|(k, s)| along(k, *s)).collect();
        let displaced = DVector::from_fn(count, |k, _| joints[k].displacement);
        let resisted = system.constraint * &displaced;
        let residual = DVector::from_fn(count, |k, _| joints[k].force + resisted[k] - target[k]);
        let size = |k: usize| {
            let parts = (0..count).map(|j| (system.constraint[(k, j)] * displaced[j]).abs()).sum::<f64>();
            joints[k].force.abs() + parts + target[k].abs()
        };
        let scale = (0..count).map(size).fold(0.0, f64::max);
        State { path, joints, residual, scale }
    };
    let jacobian = |state: &State| {
        let mut jacobian = DMatrix::from_fn(count, count, |k, j| {
            let own = if k == j { state.joints[k].force_rate } else { 0.0 };
            own + system.constraint[(k, j)] * state.joints[j].displacement_rate
        });
        for k in 0..count {
            // Nothing can load this joint, as where there is no tailstock: it stays unloaded.
            if jacobian.row(k).iter().all(|own| *own == 0.0) {
                jacobian[(k, k)] = 1.0;
            }
        }
        jacobian
    };
    let open = |state: &State| state.joints.iter().skip(2).position(|own| own.displacement < -WIDE);
    let failure = |state: &State, iterations| match open(state) {
        Some(seat) => JointsError::Open { seat, load },
        None => JointsError::Diverged { load, iterations, residual: state.residual.amax() },
    };
    let start = || {
        let path_at = |k: usize| {
            if k < 2 { joints[k].path_at(target[k]) } else { seats[k - 2].path_at(target[k]) }
        };
        (0..count).map(path_at).collect()
    };
    let mut state = at(near.map_or_else(start, <[f64]>::to_vec));
    if seats.len() > MOST_SEATS {
        return Err(failure(&state, 0));
    }
    for iterations in 0..MAX_ITERATIONS {
        let is_settled = |times: f64, state: &State| state.residual.amax() <= times * TOLERANCE * state.scale;
        let lu = jacobian(&state).lu();
        let done = |state: State| {
            let rates =
                lu.solve(&DVector::from_column_slice(system.influence)).unwrap_or_else(|| DVector::zeros(count));
            Seated {
                forces: state.joints.iter().map(|own| own.force).collect(),
                displacements: state.joints.iter().map(|own| own.displacement).collect(),
                rates: state.joints.iter().zip(rates.iter()).map(|(own, rate)| own.displacement_rate * rate).collect(),
                path: state.path,
                iterations,
            }
        };
        if is_settled(1.0, &state) && open(&state).is_none() {
            return Ok(done(state));
        }
        let Some(step) = lu.solve(&state.residual) else { return Err(failure(&state, iterations)) };
        let mut length = 1.0;
        let mut next = None;
        for _ in 0..HALVINGS {
            let path = state.path.iter().zip(step.iter()).map(|(own, step)| own - length * step).collect();
            let tried = at(path);
            if tried.residual.amax() < (1.0 - 1e-4 * length) * state.residual.amax() {
                next = Some(tried);
                break;
            }
            length *= 0.5;
        }
        match next {
            Some(next) => state = next,
            // No shorter step lowers the residual any more: at round-off this is the answer.
            None if is_settled(1e3, &state) && open(&state).is_none() => return Ok(done(state)),
            None => return Err(failure(&state, iterations)),
        }
    }
    Err(failure(&state, MAX_ITERATIONS))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint::Contact;
    use crate::solve::solve_joints;

    /// Without seats it is the problem of the end joints, and is solved as that is.
    #[test]
    fn end_joints_alone_are_as_ever() {
        let contact = Contact { coefficient: 2e-7, exponent: 0.5 };
        let joints = [
            Joint { spring_compliance: 1.0 / 60e6, contacts: vec![contact] },
            Joint { spring_compliance: 1.0 / 40e6, contacts: Vec::new() },
        ];
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

    /// A clearance that a force has to cross: none of it below, all of it beyond, and what is in between where another
    /// spring limits it.
    #[test]
    fn a_clearance_is_crossed() {
        let joints = [Joint::default(), Joint::default()];
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
