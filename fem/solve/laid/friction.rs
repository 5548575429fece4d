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
//! u₀ being how far the part goes as a whole, which nothing holds but friction.

use nalgebra::{DMatrix, DVector};

/// Ways that are this small a part of the largest count as none.
const NOTHING: f64 = 1e-10;

/// Forces on the part along it (N) that keep to their `limits` (N), with H (m/N) between the supports and how far each of their
/// places goes without friction (m). None where no choice of those that slip was found.
pub(super) fn held(influence: &DMatrix<f64>, free: &[f64], limits: &[f64]) -> Option<Vec<f64>> {
    let count = limits.len();
    // The force with which each slips; none of those that stick.
    let mut slips: Vec<Option<f64>> = limits.iter().map(|limit| (*limit <= 0.0).then_some(0.0)).collect();
    for _ in 0..20 * (count + 1) {
        let (forces, whole) = balanced(influence, free, &slips)?;
        let goes = |i: usize| whole + free[i] + (0..count).map(|j| influence[(i, j)] * forces[j]).sum::<f64>();
        let scale = free.iter().fold(f64::MIN_POSITIVE, |most, u| most.max((u + whole).abs()));
        let beyond = |i: usize| match slips[i] {
            None => forces[i].abs() / limits[i] - 1.0,
            Some(force) if limits[i] > 0.0 => goes(i) * force.signum() / scale,
            Some(_) => 0.0,
        };
        let worst = (0..count).map(|i| (i, beyond(i))).filter(|(_, by)| *by > NOTHING);
        let Some((i, _)) = worst.max_by(|a, b| a.1.total_cmp(&b.1)) else { return Some(forces) };
        slips[i] = match slips[i] {
            None => Some(limits[i].copysign(forces[i])),
            Some(_) => None,
        };
    }
    None
}

/// The forces of those that stick beside the given ones of those that slip, and u₀.
fn balanced(influence: &DMatrix<f64>, free: &[f64], slips: &[Option<f64>]) -> Option<(Vec<f64>, f64)> {
    let sticking: Vec<usize> = (0..slips.len()).filter(|i| slips[*i].is_none()).collect();
    let count = sticking.len();
    let mut forces: Vec<f64> = slips.iter().map(|slip| slip.unwrap_or(0.0)).collect();
    if count == 0 {
        return forces.iter().all(|force| *force == 0.0).then_some((forces, 0.0));
    }
    // H in terms of its own size, so that the row of the balance weighs as much.
    let scale = influence.amax();
    let mut matrix = DMatrix::zeros(count + 1, count + 1);
    let mut right = DVector::zeros(count + 1);
    for (a, i) in sticking.iter().enumerate() {
        for (b, j) in sticking.iter().enumerate() {
            matrix[(a, b)] = influence[(*i, *j)] / scale;
        }
        matrix[(a, count)] = 1.0;
        matrix[(count, a)] = 1.0;
        let pushed: f64 = (0..slips.len()).map(|j| influence[(*i, j)] * forces[j]).sum();
        right[a] = -(free[*i] + pushed) / scale;
    }
    right[count] = -forces.iter().sum::<f64>();
    let found = matrix.lu().solve(&right)?;
    sticking.iter().enumerate().for_each(|(a, i)| forces[*i] = found[a]);
    Some((forces, scale * found[count]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs of 1 m/N between three places.
    fn chain() -> DMatrix<f64> {
        DMatrix::from_fn(3, 3, |i, j| i.min(j) as f64)
    }

    #[test]
    fn what_sticks_goes_nowhere_and_what_slips_pushes_back() {
        // Places that spread by −3, 0 and 2 m without friction.
        let free = [-3.0, 0.0, 2.0];
        let stuck = held(&chain(), &free, &[9.0; 3]).unwrap();
        // The springs are held at their lengths: they push with 3 and 2 N.
        for (force, expected) in stuck.iter().zip([3.0, -1.0, -2.0]) {
            assert!((force - expected).abs() < 1e-12, "{stuck:?}");
        }
        let slipping = held(&chain(), &free, &[1.0, 9.0, 0.5]).unwrap();
        for (force, expected) in slipping.iter().zip([1.0, -0.5, -0.5]) {
            assert!((force - expected).abs() < 1e-12, "{slipping:?}");
        }
        assert_eq!(held(&chain(), &free, &[0.0; 3]), Some(vec![0.0; 3]));
    }
}
