//! Small least squares with sign constraints: the fall of χ² when a few columns are added, some of them with
//! amplitudes that may not be negative.

use nalgebra::{DMatrix, DVector};

/// Part of the product of two squares below which their determinant is round-off.
const DEPENDENT: f64 = 1e-14;

/// Fall of χ² and the amplitudes that give it.
#[derive(Clone, Debug, PartialEq)]
pub struct Gain {
    /// Fall of χ².
    pub delta_chi2: f64,
    /// Amplitude of each column.
    pub amplitudes: Vec<f64>,
}

/// Finds the amplitudes a that minimise ‖r − C·a‖², from `gram` = CᵀC and `along` = Cᵀr; an amplitude that
/// is not `signed` is not negative. All subsets of columns are tried, for there are few.
pub fn gain(gram: &DMatrix<f64>, along: &DVector<f64>, signed: &[bool]) -> Gain {
    let n = along.len();
    let mut best = Gain { delta_chi2: 0.0, amplitudes: vec![0.0; n] };
    if n == 1 {
        let a = along[0] / gram[(0, 0)].max(f64::MIN_POSITIVE);
        if a > 0.0 || signed[0] {
            best = Gain { delta_chi2: a * along[0], amplitudes: vec![a] };
        }
        return best;
    }
    if n == 2 {
        return of_two(gram, along, signed);
    }
    for used in 1u32..1 << n {
        let members: Vec<usize> = (0..n).filter(|i| used & (1 << i) != 0).collect();
        let part = DMatrix::from_fn(members.len(), members.len(), |r, c| gram[(members[r], members[c])]);
        let right = DVector::from_fn(members.len(), |r, _| along[members[r]]);
        let Some(a) = part.cholesky().map(|l| l.solve(&right)) else { continue };
        if members.iter().zip(a.iter()).any(|(i, a)| !signed[*i] && *a < 0.0) {
            continue;
        }
        let delta_chi2 = a.dot(&right);
        if delta_chi2 > best.delta_chi2 {
            best.delta_chi2 = delta_chi2;
            best.amplitudes = vec![0.0; n];
            members.iter().zip(a.iter()).for_each(|(i, a)| best.amplitudes[*i] = *a);
        }
    }
    best
}

/// The same for two columns, without a matrix: pairs of effects are many.
fn of_two(gram: &DMatrix<f64>, along: &DVector<f64>, signed: &[bool]) -> Gain {
    let (p, q, r) = (gram[(0, 0)], gram[(1, 1)], gram[(0, 1)]);
    let (u, v) = (along[0], along[1]);
    let determinant = p * q - r * r;
    let both = [(q * u - r * v) / determinant, (p * v - r * u) / determinant];
    let allowed = |a: [f64; 2]| a.iter().zip(signed).all(|(a, signed)| *signed || *a >= 0.0);
    let mut best = Gain { delta_chi2: 0.0, amplitudes: vec![0.0; 2] };
    let one = |a: f64| if a.is_finite() { a } else { 0.0 };
    let trials = [[one(u / p), 0.0], [0.0, one(v / q)], if determinant > DEPENDENT * p * q { both } else { [0.0; 2] }];
    for amplitudes in trials.into_iter().filter(|a| allowed(*a)) {
        let delta_chi2 = amplitudes[0] * u + amplitudes[1] * v;
        if delta_chi2 > best.delta_chi2 {
            best = Gain { delta_chi2, amplitudes: amplitudes.to_vec() };
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_amplitude_that_must_not_be_negative_is_left_out() {
        let gram = DMatrix::from_row_slice(2, 2, &[4.0, 1.0, 1.0, 9.0]);
        let along = DVector::from_vec(vec![8.0, -9.0]);
        // Free: a = (4·9 − 1)⁻¹·(72 + 9, −36 − 8); the fall is a·along.
        let free = gain(&gram, &along, &[true, true]);
        assert!((free.delta_chi2 - (81.0 * 8.0 + 44.0 * 9.0) / 35.0).abs() < 1e-12);
        let bounded = gain(&gram, &along, &[false, false]);
        assert_eq!(bounded, Gain { delta_chi2: 16.0, amplitudes: vec![2.0, 0.0] });
    }
}
