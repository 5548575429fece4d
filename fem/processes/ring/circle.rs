//! The least-squares circle, taken out set-up by set-up as a roundness instrument does: mean and first
//! harmonic, which are where the centre of the ring happens to stand and how large it is.

use std::f64::consts::TAU;

use crate::process::DatumDirection;

/// Rows that leave less than this part of a direction beside the others do not tell it from them.
const DEPENDENT: f64 = 1e-9;

/// So many angles around from 0, rad.
pub fn evenly(count: usize) -> Vec<f64> {
    (0..count).map(|i| TAU * i as f64 / count as f64).collect()
}

/// 1, cos θ and sin θ over the rows of a set-up, made orthonormal; fewer where they have fewer than three
/// angles. `angles` are those of all rows, rad. To take them out is to measure from the unweighted
/// least-squares circle.
pub fn directions(rows: &[usize], angles: &[f64]) -> Vec<DatumDirection> {
    let shapes: [fn(f64) -> f64; 3] = [|_| 1.0, f64::cos, f64::sin];
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for shape in shapes {
        let mut v: Vec<f64> = rows.iter().map(|row| shape(angles[*row])).collect();
        // Twice is enough to be orthogonal to round-off.
        for _ in 0..2 {
            for b in &basis {
                let along: f64 = b.iter().zip(&v).map(|(b, v)| b * v).sum();
                v.iter_mut().zip(b).for_each(|(v, b)| *v -= along * b);
            }
        }
        let left = v.iter().map(|v| v * v).sum::<f64>().sqrt();
        if left > DEPENDENT * (rows.len() as f64).sqrt() {
            basis.push(v.into_iter().map(|v| v / left).collect());
        }
    }
    basis.into_iter().map(|components| DatumDirection { rows: rows.to_vec(), components }).collect()
}

/// Deviations at some angles (rad) of one set-up, from their least-squares circle.
pub fn form(angles: &[f64], deviations: &[f64]) -> Vec<f64> {
    let mut form = deviations.to_vec();
    let rows: Vec<usize> = (0..angles.len()).collect();
    directions(&rows, angles).iter().for_each(|direction| direction.take_out(&mut form));
    form
}
