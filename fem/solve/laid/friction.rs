//! Friction of the supports on a part that is pressed on them.
//!
//! The underside of a part that bends slides over its supports, and they hold it back by T, |T| ≤ µQ (Coulomb 1785). All forces are
//! taken to rise together from nothing: a support on which the part sticks has then never let it slide, and one on which it slips
//! pushes back all the way with µQ against the way it went,
//!
//! ```text
//!     u = u₀ + u_free + H·T,   u = 0 where |T| < µQ,   T = −µQ·sign u elsewhere,   ΣT = 0
//! ```
//!
//! u₀ being how far the part goes as a whole, which nothing holds but friction. With u₀ given, T is what a convex problem with bounds
//! has (H is symmetric and positive), and ΣT falls with u₀ along straight pieces: Newton's steps between bounds find where it is zero.

use nalgebra::{DMatrix, DVector};

/// Round-off: of ΣT as a part of the limits, of a force beyond its limit, and of a motion as a part of the largest.
const NOTHING: f64 = 1e-12;
/// Halvings that leave of a bracket what round-off leaves.
const MAX_ITERATIONS: usize = 200;

/// Forces on the part along it (N) that keep to their `limits` (N), with H (m/N) between the supports and how far each of their
/// places goes without friction (m). None where there are no numbers.
pub(super) fn held(influence: &DMatrix<f64>, free: &[f64], limits: &[f64]) -> Option<Vec<f64>> {
    let count = limits.len();
    let most: f64 = limits.iter().sum();
    if most == 0.0 {
        return Some(vec![0.0; count]);
    }
    let reach = |i: usize| free[i].abs() + (0..count).map(|j| influence[(i, j)].abs() * limits[j]).sum::<f64>();
    let far = (0..count).map(reach).fold(0.0, f64::max);
    let problem = Problem { influence, free, limits, far };
    // The force with which each slips; none of those that stick.
    let mut slips: Vec<Option<f64>> = limits.iter().map(|limit| (*limit <= 0.0).then_some(0.0)).collect();
    let (mut low, mut high, mut whole) = (-far, far, 0.0);
    for _ in 0..MAX_ITERATIONS {
        let forces = problem.resting(whole, &mut slips)?;
        let sum: f64 = forces.iter().sum();
        if sum.abs() <= NOTHING * most {
            return Some(forces);
        }
        if sum > 0.0 {
            low = whole
        } else {
            high = whole
        }
        let next = whole + sum / problem.pull(&slips)?;
        whole = if next > low && next < high { next } else { 0.5 * (low + high) };
    }
    None
}

struct Problem<'a> {
    influence: &'a DMatrix<f64>,
    free: &'a [f64],
    limits: &'a [f64],
    /// What no place goes beyond, m.
    far: f64,
}

impl Problem<'_> {
    /// The forces with the part as a whole at a place (m), beginning with some choice of those that slip.
    ///
    /// The worst changes first, which is quick; the first one later on, which cannot go in circles (Murty 1974).
    fn resting(&self, whole: f64, slips: &mut [Option<f64>]) -> Option<Vec<f64>> {
        let count = slips.len();
        for round in 0..50 * (count + 1) {
            let forces = self.forces(whole, slips)?;
            let goes =
                |i: usize| whole + self.free[i] + (0..count).map(|j| self.influence[(i, j)] * forces[j]).sum::<f64>();
            let beyond = |i: usize| match slips[i] {
                None => forces[i].abs() / self.limits[i] - 1.0,
                Some(force) if force != 0.0 => goes(i) * force.signum() / self.far,
                Some(_) => 0.0,
            };
            let mut wrong = (0..count).map(|i| (i, beyond(i))).filter(|(_, by)| *by > NOTHING);
            let changed = match round < 4 * count {
                true => wrong.max_by(|a, b| a.1.total_cmp(&b.1)),
                false => wrong.next(),
            };
            let Some((i, _)) = changed else { return Some(forces) };
            slips[i] = match slips[i] {
                None => Some(self.limits[i].copysign(forces[i])),
                Some(_) => None,
            };
        }
        None
    }

    /// Those that stick, and H between them.
    fn sticking(&self, slips: &[Option<f64>]) -> (Vec<usize>, DMatrix<f64>) {
        let own: Vec<usize> = (0..slips.len()).filter(|i| slips[*i].is_none()).collect();
        let matrix = DMatrix::from_fn(own.len(), own.len(), |a, b| self.influence[(own[a], own[b])]);
        (own, matrix)
    }

    /// The forces of those that stick beside the given ones of those that slip.
    fn forces(&self, whole: f64, slips: &[Option<f64>]) -> Option<Vec<f64>> {
        let mut forces: Vec<f64> = slips.iter().map(|slip| slip.unwrap_or(0.0)).collect();
        let (own, matrix) = self.sticking(slips);
        let pushed = |i: &usize| (0..slips.len()).map(|j| self.influence[(*i, j)] * forces[j]).sum::<f64>();
        let right = DVector::from_iterator(own.len(), own.iter().map(|i| -(whole + self.free[*i] + pushed(i))));
        let found = matrix.cholesky()?.solve(&right);
        own.iter().zip(found.iter()).for_each(|(i, force)| forces[*i] = *force);
        Some(forces)
    }

    /// −dΣT/du₀, N/m: zero where all slip.
    fn pull(&self, slips: &[Option<f64>]) -> Option<f64> {
        let (own, matrix) = self.sticking(slips);
        Some(matrix.cholesky()?.solve(&DVector::from_element(own.len(), 1.0)).sum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs of 1 N/m between four places, the first of them held by one too.
    fn chain() -> DMatrix<f64> {
        DMatrix::from_fn(4, 4, |i, j| 1.0 + i.min(j) as f64)
    }

    fn near(found: &[f64], expected: &[f64]) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-11), "{found:?} {expected:?}");
    }

    #[test]
    fn what_sticks_goes_nowhere_and_what_slips_pushes_back() {
        // Places that spread by −3, 0, 2 and 2 m without friction; with all held the springs push with 3 and 2 N.
        let free = [-3.0, 0.0, 2.0, 2.0];
        near(&held(&chain(), &free, &[9.0; 4]).unwrap(), &[3.0, -1.0, -2.0, 0.0]);
        near(&held(&chain(), &free, &[0.0; 4]).unwrap(), &[0.0; 4]);
    }

    #[test]
    fn whatever_the_limits_all_keep_to_the_law() {
        let mut seed = 1u32;
        let mut draw = move || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 24)
        };
        for case in 0..500 {
            let free: Vec<f64> = (0..4).map(|_| 6.0 * draw() - 3.0).collect();
            let limits: Vec<f64> = (0..4).map(|_| 10f64.powf(4.0 * draw() - 3.0)).collect();
            let forces = held(&chain(), &free, &limits).unwrap();
            assert!(forces.iter().sum::<f64>().abs() < 1e-10 * limits.iter().sum::<f64>(), "case {case}");
            let motion = chain() * DVector::from_vec(forces.clone()) + DVector::from_vec(free);
            // What sticks tells how far the part goes as a whole; that all slip leaves it open.
            let Some(stuck) = (0..4).find(|i| forces[*i].abs() < limits[*i] * (1.0 - 1e-9)) else { continue };
            for i in 0..4 {
                let goes = motion[i] - motion[stuck];
                let holds = match forces[i].abs() < limits[i] * (1.0 - 1e-9) {
                    true => goes.abs() < 1e-9,
                    false => forces[i].abs() <= limits[i] * (1.0 + 1e-9) && goes * forces[i] <= 1e-9,
                };
                assert!(holds, "case {case}: {forces:?} {limits:?} {goes}");
            }
        }
    }
}
