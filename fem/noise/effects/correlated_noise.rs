//! Neighbouring rows share noise.

use super::super::evidence::Evidence;
use super::super::term::{Acts, MeasurementEffect, Size, Term};

/// Errors correlated between neighbouring rows.
pub static CORRELATED_NOISE: MeasurementEffect = MeasurementEffect {
    name: "correlated-noise",
    about: "what a row is off by is shared with its neighbours in the file: the noise has a memory",
    law: "correlation of two rows = exp(-d/length), d apart in the order of the file",
    source: "Box, Jenkins & Reinsel, Time Series Analysis, 1994, ch. 3 (AR(1): coefficient exp(-1/length))",
    separates: "measure the rows in another order, or more slowly",
    size: Size::Number("length", "rows over which the correlation falls to 1/e"),
    example: "2",
    acts: Acts::Neighbours,
    ..MeasurementEffect::USUAL
};

/// Once, where the covariance of the rows is not known.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let is_known = evidence.has(|acts| matches!(acts, Acts::Neighbours | Acts::Given));
    if is_known { Vec::new() } else { vec![evidence.and(Term::new(&CORRELATED_NOISE))] }
}

#[cfg(test)]
mod tests {
    use crate::noise::tests::{measured, whitened_square};
    use crate::noise::{Term, effects};

    #[test]
    fn three_rows_have_the_covariance_of_a_first_order_process() {
        // Coefficient 1/2: V = [[1, 1/2, 1/4], [1/2, 1, 1/2], [1/4, 1/2, 1]], det V = 9/16, and the last
        // entry of its inverse is 4/3.
        let term = Term { size: 1.0 / 2.0f64.ln(), ..Term::new(&effects::CORRELATED_NOISE) };
        let (square, log_determinant) = whitened_square(&measured(&[1.0, 2.0, 3.0]), &[term], &[0.0, 0.0, 1.0]);
        assert!((square - 4.0 / 3.0).abs() < 1e-12);
        assert!((log_determinant - (9.0f64 / 16.0).ln()).abs() < 1e-12);
    }
}
