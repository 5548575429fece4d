//! Small least squares with bounds: how much χ² falls when a few columns may be used, some of them only forward.

use nalgebra::{DMatrix, DVector};

/// The fall of χ² and the amplitudes that give it.
#[derive(Clone, Debug, PartialEq)]
pub struct Gain {
    /// Fall of χ².
    pub fall: f64,
    /// Per column.
    pub amplitudes: Vec<f64>,
}

/// The best amplitudes a for ‖r − C·a‖², from `gram` = CᵀC and `along` = Cᵀr; an amplitude that is not `signed` is not negative. All ways to
/// leave out columns are tried, for there are few.
pub fn gain(gram: &DMatrix<f64>, along: &DVector<f64>, signed: &[bool]) -> Gain {
    let n = along.len();
    let mut best = Gain { fall: 0.0, amplitudes: vec![0.0; n] };
    if n == 1 {
        let a = along[0] / gram[(0, 0)].max(f64::MIN_POSITIVE);
        if a > 0.0 || signed[0] {
            best = Gain { fall: a * along[0], amplitudes: vec![a] };
        }
        return best;
    }
    for used in 1u32..1 << n {
        let members: Vec<usize> = (0..n).filter(|i| used & (1 << i) != 0).collect();
        let part = DMatrix::from_fn(members.len(), members.len(), |r, c| gram[(members[r], members[c])]);
        let right = DVector::from_fn(members.len(), |r, _| along[members[r]]);
        let Some(a) = part.cholesky().map(|l| l.solve(&right)) else { continue };
        if members.iter().zip(a.iter()).any(|(i, a)| !signed[*i] && *a < 0.0) {
            continue;
        }
        let fall = a.dot(&right);
        if fall > best.fall {
            best.fall = fall;
            best.amplitudes = vec![0.0; n];
            members.iter().zip(a.iter()).for_each(|(i, a)| best.amplitudes[*i] = *a);
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
        assert!((free.fall - (81.0 * 8.0 + 44.0 * 9.0) / 35.0).abs() < 1e-12);
        let bounded = gain(&gram, &along, &[false, false]);
        assert_eq!(bounded, Gain { fall: 16.0, amplitudes: vec![2.0, 0.0] });
    }
}
