//! A plane-stress ring under a radial load that goes around as cos mθ: collocation in the radius.
//!
//! u_r = U(r) cos mθ, u_t = V(r) sin mθ; S, H, T are the amplitudes of σ_rr, σ_θθ (cos) and τ (sin), with E
//! = b = Ro = 1:
//!
//! ```text
//!   S = (U' + ν (U + mV)/r)/(1−ν²)     H = ((U + mV)/r + ν U')/(1−ν²)     T = (V' − V/r − mU/r)/2(1+ν)
//!   S' + (S − H + mT)/r = 0            T' + (2T − mH)/r = 0
//!   S(1) = −1, T(1) = 0, S(Ri) = T(Ri) = 0
//! ```

use std::f64::consts::PI;

use crate::dense::solve;

/// Collocation points across a thin wall for long waves; more for thick walls and short waves. Too many
/// lose digits.
const POINTS: usize = 9;
/// The bore no longer feels a harmonic below this part of the largest.
const SHIELDED: f64 = 1e-8;

/// u_r at the bore per unit of load (N/rad inwards on the outside) for m = 0, 1, 2 …, with m = 1, which
/// loads in equilibrium do not have, left at zero; every multiple of `step` only, the others zero.
pub fn compliances(ratio: f64, poisson: f64, step: usize) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    let mut largest = 0.0f64;
    for m in 0usize.. {
        if m == 1 || !m.is_multiple_of(step) {
            found.push(0.0);
            continue;
        }
        let compliance = bore(ratio, poisson, m);
        found.push(compliance);
        largest = largest.max(compliance.abs());
        if m > 1 && compliance.abs() < SHIELDED * largest {
            break;
        }
    }
    found
}

/// The waves that so many jaws may make: all, where three stand out of place; every second multiple, where every other one of an
/// even number presses harder.
pub fn step(jaws: usize) -> usize {
    if jaws == 3 { 1 } else { jaws / 2 }
}

/// u_r at the bore under one wave of load.
pub fn bore(ratio: f64, poisson: f64, m: usize) -> f64 {
    let (r, d) = chebyshev(ratio, (POINTS + ((m as f64 + 15.0) * (1.0 - ratio)).ceil() as usize).min(30));
    let n = r.len();
    let wave = m as f64;
    // Rows of operators on (U, V), each 2n long.
    let (plane, shear) = (1.0 / (1.0 - poisson * poisson), 0.5 / (1.0 + poisson));
    let operator = |of: &dyn Fn(usize, usize) -> [f64; 2]| -> Vec<Vec<f64>> {
        (0..n).map(|i| (0..n).map(|j| of(i, j)[0]).chain((0..n).map(|j| of(i, j)[1])).collect()).collect()
    };
    let same = |i: usize, j: usize| f64::from(i == j);
    let radial =
        operator(&|i, j| [plane * (d[i][j] + poisson * same(i, j) / r[i]), plane * poisson * wave * same(i, j) / r[i]]);
    let hoop = operator(&|i, j| [plane * (same(i, j) / r[i] + poisson * d[i][j]), plane * wave * same(i, j) / r[i]]);
    let tangential = operator(&|i, j| [-shear * wave * same(i, j) / r[i], shear * (d[i][j] - same(i, j) / r[i])]);
    let derivative = |of: &[Vec<f64>], i: usize, j: usize| (0..n).map(|k| d[i][k] * of[k][j]).sum::<f64>();
    let mut matrix = vec![vec![0.0; 2 * n]; 2 * n];
    let mut right = vec![0.0; 2 * n];
    for i in 0..n {
        let at_end = i == 0 || i == n - 1;
        for j in 0..2 * n {
            (matrix[i][j], matrix[n + i][j]) = if at_end {
                (radial[i][j], tangential[i][j])
            } else {
                (
                    derivative(&radial, i, j) + (radial[i][j] - hoop[i][j] + wave * tangential[i][j]) / r[i],
                    derivative(&tangential, i, j) + (2.0 * tangential[i][j] - wave * hoop[i][j]) / r[i],
                )
            };
        }
        if m == 0 {
            // No load turns the ring: V is nothing but a rotation.
            matrix[n + i] = (0..2 * n).map(|j| f64::from(j == n + i)).collect();
        }
    }
    right[0] = -1.0;
    solve(matrix, right)[n - 1]
}

/// Chebyshev points from 1 down to `low`, and the matrix that differentiates.
fn chebyshev(low: f64, n: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    let x: Vec<f64> = (0..n).map(|i| (PI * i as f64 / (n - 1) as f64).cos()).collect();
    let weight = |i: usize| if i == 0 || i == n - 1 { 2.0 } else { 1.0 } * if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    let slope = 2.0 / (1.0 - low);
    let mut d = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in (0..n).filter(|&j| j != i) {
            d[i][j] = slope * weight(i) / (weight(j) * (x[i] - x[j]));
        }
        // A constant has no slope.
        d[i][i] = -d[i].iter().sum::<f64>();
    }
    (x.iter().map(|x| low + (1.0 - low) * 0.5 * (1.0 + x)).collect(), d)
}
