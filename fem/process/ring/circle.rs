//! The least-squares circle, taken out set-up by set-up as a roundness instrument does: mean and first harmonic, which are where the centre of
//! the ring happens to stand and how large it is.

use std::collections::HashMap;

use super::observe::{ANGLE_OF_ROW, JAW_FORCE, RUN, SPEED, STATE};
use crate::process::{Blind, Rows};

/// Less than this part of a direction is left when the others are taken out: the rows do not tell it from them.
const DEPENDENT: f64 = 1e-9;

/// The rows of each set-up: equal run, state, jaw force and spindle speed.
pub fn set_ups(rows: &Rows) -> Vec<Vec<usize>> {
    let mut numbers: HashMap<[u64; 4], usize> = HashMap::new();
    let mut set_ups: Vec<Vec<usize>> = Vec::new();
    for row in 0..rows.len() {
        let key = [RUN, STATE, JAW_FORCE, SPEED].map(|column| rows.columns[column][row].to_bits());
        let number = *numbers.entry(key).or_insert(set_ups.len());
        if number == set_ups.len() {
            set_ups.push(Vec::new());
        }
        set_ups[number].push(row);
    }
    set_ups
}

/// 1, cos θ and sin θ over the rows of each set-up, made orthonormal; fewer where a set-up has fewer than three angles. To take them out is to
/// measure from the unweighted least-squares circle.
pub fn directions(rows: &Rows) -> Vec<Blind> {
    let of_set_up = |own: Vec<usize>| {
        let angle = |row: &usize| rows.columns[ANGLE_OF_ROW][*row];
        let shapes: [fn(f64) -> f64; 3] = [|_| 1.0, f64::cos, f64::sin];
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for shape in shapes {
            let mut v: Vec<f64> = own.iter().map(|row| shape(angle(row))).collect();
            let size = (own.len() as f64).sqrt();
            // Twice is enough to be orthogonal to round-off.
            for _ in 0..2 {
                for b in &basis {
                    let along: f64 = b.iter().zip(&v).map(|(b, v)| b * v).sum();
                    v.iter_mut().zip(b).for_each(|(v, b)| *v -= along * b);
                }
            }
            let left = norm(&v);
            if left > DEPENDENT * size {
                basis.push(v.into_iter().map(|v| v / left).collect());
            }
        }
        basis.into_iter().map(|components| Blind { rows: own.clone(), components }).collect::<Vec<_>>()
    };
    set_ups(rows).into_iter().flat_map(of_set_up).collect()
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}
